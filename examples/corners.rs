//! Where two ways of being special meet: bodies in the corners, what is not proved there, and what f64 finds otherwise.
//!
//! `cargo run --release --example corners [bodies] [moments] [centre]` takes that number of bodies of each kind of moments with
//! each kind of centre of mass; one line for each pair, and one on stderr for each body that is refused or differs.

use std::time::Instant;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::topology::Component;
use bifdiag_exact::CertifiedAtlas;
use dashu_ratio::RBig;

use support::random::SplitMix64;

/// How the moments are special.
const MOMENTS: [&str; 8] =
    ["generic", "equal", "near-equal", "three-near-equal", "rod", "rod-equal", "rod-near-equal", "plate"];
/// How the centre of mass is.
const CENTRES: [&str; 7] = ["generic", "axis", "near-axis", "plane", "near-plane", "plane-near-axis", "two-scales"];

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(40);
    let [moments, centre] = [arguments.next(), arguments.next()];
    let wanted =
        |name: &str, wanted: &Option<String>| wanted.as_ref().is_none_or(|wanted| wanted == name || wanted == "all");
    for (m, kind) in MOMENTS.iter().enumerate().filter(|(_, name)| wanted(name, &moments)) {
        for (c, place) in CENTRES.iter().enumerate().filter(|(_, name)| wanted(name, &centre)) {
            let mut rng = SplitMix64::new(17_000_000 + u64::try_from(100 * m + c).unwrap_or(0));
            let mut tally = Tally::default();
            for _ in 0..count {
                tally.examine(corner(&mut rng, kind, place));
            }
            println!("{kind:>16} {place:>15}: {count} bodies, {tally}");
        }
    }
}

/// A number of five digits, between these two times 10⁻⁵.
fn digits(rng: &mut SplitMix64, least: u32, most: u32) -> RBig {
    let room = rng.index((most - least) as usize);
    RBig::from(least as usize + room) / RBig::from(100_000)
}

/// Moments and centre of mass.
type Parts = [[RBig; 3]; 2];

fn corner(rng: &mut SplitMix64, moments: &str, centre: &str) -> Parts {
    let [zero, one] = [RBig::ZERO, RBig::ONE];
    // 10⁻³ to 10⁻¹⁸ of a number.
    let tiny = |rng: &mut SplitMix64, n: RBig| n / RBig::from(10).pow(isize::try_from(3 + rng.index(16)).unwrap_or(3));
    let [p, q, s] = [0; 3].map(|_| digits(rng, 30_000, 200_000));
    let [u, v] = [0; 2].map(|_| digits(rng, 10_000, 100_000));
    let (u, v) = (tiny(rng, u), tiny(rng, v));
    let a = match moments {
        "equal" => [p.clone(), p, q],
        "near-equal" => [p.clone(), p * (&one + u), q],
        "three-near-equal" => [p.clone(), &p * (&one + u), p * (one - v)],
        "rod" => [u, p, q],
        "rod-equal" => [u, p.clone(), p],
        "rod-near-equal" => [u, p.clone(), p * (one + v)],
        "plate" => [&p + &q, p, q],
        _ => [p, q, s],
    };
    let [x, y, z] = [0; 3].map(|_| digits(rng, 10_000, 100_000));
    let mut r = match centre {
        "axis" => [x, zero.clone(), zero],
        "near-axis" => {
            let scale = tiny(rng, RBig::ONE);
            [x, y * &scale, z * scale]
        }
        "plane" => [x, y, zero],
        "near-plane" => [x, y, tiny(rng, z)],
        "plane-near-axis" => [x, tiny(rng, y), zero],
        "two-scales" => [x, tiny(rng, y), tiny(rng, z)],
        _ => [x, y, z],
    };
    r.rotate_left(rng.index(3));
    if rng.index(2) == 1 {
        r.swap(0, 1);
    }
    [a, r]
}

#[derive(Default)]
struct Tally {
    refused: usize,
    open: usize,
    different: usize,
    /// Milliseconds.
    times: Vec<f64>,
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let slowest = self.times.iter().copied().fold(0.0, f64::max);
        let over = self.times.iter().filter(|time| **time > 100.0).count();
        let Self { refused, open, different, .. } = self;
        write!(
            f,
            "{refused} refused, {open} with open regions, {different} different, slowest {slowest:.0} ms, {over} over 100"
        )
    }
}

impl Tally {
    fn examine(&mut self, [a, r]: Parts) {
        let list = |numbers: &[RBig; 3]| numbers.each_ref().map(RBig::to_string).join(",");
        let text = format!("--A={} --r={}", list(&a), list(&r));
        let body = Body::new(a.map(Number::from_rational), r.map(Number::from_rational)).expect("a body");
        let start = Instant::now();
        let proved = CertifiedAtlas::new(&body);
        let time = start.elapsed().as_secs_f64() * 1e3;
        self.times.push(time);
        if time > 100.0 {
            eprintln!("slow {time:.0} ms: {text}");
        }
        let proved = match proved {
            Ok(proved) => proved,
            Err(error) => {
                self.refused += 1;
                eprintln!("refused: {text}: {error}");
                return;
            }
        };
        let mut classes: Vec<String> =
            proved.region_ids().filter_map(|region| proved.components(region)).map(class).collect();
        if classes.len() < proved.region_count() {
            self.open += 1;
            eprintln!("open: {text}");
            return;
        }
        let Some(quick) =
            bifdiag_diagram::fast::atlas(&body).ok().filter(|atlas| atlas.arrangement().undecided.is_empty())
        else {
            return;
        };
        let found: Result<Vec<String>, _> =
            quick.regions().ids().map(|region| quick.components(region).map(class)).collect();
        let Ok(mut found) = found else { return };
        classes.sort();
        found.sort();
        if classes != found {
            self.different += 1;
            eprintln!("different: {text}: {} and {} regions", classes.len(), found.len());
        }
    }
}

fn class(components: &[Component]) -> String {
    format!("{components:?}")
}
