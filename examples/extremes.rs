//! Bodies and points on the way into each extreme: what `exact` answers, and how long it takes.
//!
//! `cargo run --release --example extremes [family] [exponents]` prints one line for each family and distance ε = 10⁻ᵏ:
//! the atlas of f64 (`all` decided, `open`, `none`), the exact one, the proved one, a point, whether `verify` confirms the
//! certificate, and the milliseconds of each. `data/extremes.txt` is the recorded result.

use std::time::Instant;

use bifdiag_body::{Body, Number};
use bifdiag_documents::{DocumentOptions, certified_atlas};
use bifdiag_exact::{Accuracy, CertifiedAtlas, classify_exactly};
use bifdiag_schema::AtlasDocument;
use dashu_ratio::RBig;

type Parts = [RBig; 6];

/// A name, and the moments and centre of mass at a distance ε.
type Family = (&'static str, fn(&RBig) -> Parts);

/// A family of bodies that is special for ε = 0.
const FAMILIES: [Family; 12] = [
    ("near-axis", |e| [n("2"), n("1.1"), n("1"), n("1"), e.clone(), n("2") * e]),
    ("near-axis-mid", |e| [n("1.3"), n("1"), n("0.7"), n("2") * e, n("1"), e.clone()]),
    ("near-plane", |e| [n("2"), n("1.1"), n("1"), n("0.94868"), e.clone(), n("0.61623")]),
    ("near-plane-long", |e| [n("1"), n("1.3"), n("1.9"), n("0.8"), n("0.6"), e.clone()]),
    ("near-symmetric", |e| [n("1"), n("1") + e, n("1.3"), n("0.3"), n("0.5"), n("0.7")]),
    ("near-lagrange", |e| [n("1"), n("1") + e, n("0.7"), e.clone(), n("0"), n("1")]),
    ("near-isotropic", |e| [n("1"), n("1") + e, n("1") + n("3") * e, n("0.3"), n("0.5"), n("0.7")]),
    ("rod", |e| [e.clone(), n("1"), n("1") + e / n("2"), n("1"), n("0.3"), n("0.2")]),
    ("katok-3/4", |e| [n("1"), n("1.4"), n("0.75") - e, n("1"), n("0"), n("0")]),
    ("katok-1", |e| [n("1"), n("1") - e, n("1.4"), n("1"), n("0"), n("0")]),
    ("katok-triple", |e| [n("1"), RBig::from(5) / RBig::from(9), n("0.5") + e, n("1"), n("0"), n("0")]),
    ("near-euler", |e| [n("2"), n("1.1"), n("1"), n("0.3") * e, n("0.5") * e, n("0.7") * e]),
];

fn n(text: &str) -> RBig {
    text.parse::<Number>().expect("a number").value().clone()
}

fn body([a, b, c, x, y, z]: Parts) -> Body {
    Body::new([a, b, c].map(Number::from_rational), [x, y, z].map(Number::from_rational)).expect("a body")
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}

fn document(proved: &CertifiedAtlas) -> Option<AtlasDocument> {
    let options = DocumentOptions { drawing: bifdiag_documents::Drawn::Nothing, ..DocumentOptions::default() };
    certified_atlas(proved, &proved.to_atlas().ok()?, &options).ok()
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let wanted = arguments.next().unwrap_or_default();
    let exponents: Vec<isize> = arguments
        .next()
        .map_or_else(|| (1..=18).collect(), |list| list.split(',').map(|k| k.parse().expect("a number")).collect());
    for (name, parts) in FAMILIES.iter().filter(|(name, _)| name.contains(wanted.as_str())) {
        for &exponent in &exponents {
            let body = body(parts(&(RBig::ONE / RBig::from(10).pow(exponent))));
            let fast = match bifdiag_diagram::fast::atlas(&body) {
                Ok(atlas) => {
                    let open = atlas.regions().iter().filter(|region| region.components.is_err()).count();
                    let undecided = atlas.arrangement().undecided.len();
                    if open + undecided == 0 { "all".to_owned() } else { format!("open {undecided}+{open}") }
                }
                Err(_) => "none".to_owned(),
            };
            let (answer, time) = timed(|| bifdiag_exact::atlas(&body, Accuracy::Exact));
            let (proved, proof_time) = timed(|| CertifiedAtlas::new(&body));
            let verified = proved.as_ref().ok().and_then(document).map_or_else(
                || "no certificate".to_owned(),
                |document| {
                    let (found, time) = timed(|| bifdiag_verify::verify(&document));
                    found.map_or_else(|refused| format!("REFUSED {refused}"), |_| format!("verified {time:.0} ms"))
                },
            );
            let proved = match &proved {
                Ok(atlas) => {
                    let open = atlas.region_ids().filter(|&region| atlas.components(region).is_none()).count();
                    format!("{} regions, {open} open, {} bits", atlas.region_count(), atlas.bits())
                }
                Err(error) => error.to_string(),
            };
            let point = timed(|| {
                classify_exactly(
                    &body,
                    &Number::from_f64(0.9).expect("finite"),
                    &Number::from_f64(0.8).expect("finite"),
                )
            });
            let answer = answer
                .map_or_else(|error| format!("ERROR {error}"), |atlas| format!("{} regions", atlas.regions().len()));
            println!(
                "{name} 1e-{exponent} | f64 {fast} | exact {answer} {time:.0} ms | proof {proved} {proof_time:.0} ms | point {} {:.1} ms | {verified}",
                point.0.is_ok(),
                point.1
            );
        }
    }
}
