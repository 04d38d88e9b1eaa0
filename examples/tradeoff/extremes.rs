//! Into each extreme: what fast and exact answer.

use rayon::prelude::*;

use super::families::{EXTREMES, answers};

pub fn run() {
    println!("extreme,epsilon,fast,exact");
    let all: Vec<(usize, isize)> =
        (0..EXTREMES.len()).flat_map(|k| EXTREMES[k].exponents.clone().map(move |exponent| (k, exponent))).collect();
    let lines: Vec<String> = all
        .par_iter()
        .map(|&(k, exponent)| {
            let found = answers(&EXTREMES[k].ask(exponent));
            let [fast, exact] = found.map(|answer| format!("{answer:?}").to_lowercase());
            format!("{},1e-{exponent},{fast},{exact}", EXTREMES[k].name)
        })
        .collect();
    println!("{}", lines.join("\n"));
}
