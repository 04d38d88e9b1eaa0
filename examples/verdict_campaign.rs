//! A campaign against the verdicts of sections: are orbits that were called regular or chaotic what they turn out to be?
//!
//! ```text
//! cargo run --release --example verdict_campaign -- 90 7
//! ```
//! Arguments: number of points (h, l), seed; 16 orbits each. Every orbit is followed for 20,000 crossings, and what it turns out
//! to be is read off the tangent vector alone: *chaotic* if ln|δ| has gained more than 60 in all and 25 in the second half of the
//! time, *quiet* otherwise. For the verdicts after 500, 1000, 2000, 6000 and 20,000 crossings the table counts how many are regular,
//! chaotic and open. A verdict does not change when an orbit is followed further, so that those after N crossings are those that
//! were decided until then (the package's tests compare them with runs of N crossings).

use std::collections::BTreeMap;

use bifdiag::Body;
use bifdiag::dynamics::field::{HeavyTop, State};
use bifdiag::dynamics::section::chaos::{ChaosMeasure, ChaosOptions, OrbitVerdict, chaos_measures};
use bifdiag::dynamics::section::{Monitor, PpTorus, SectionError, StartOptions, SweepOptions, spread_starts, sweep};
use support::random::SplitMix64;

const CROSSINGS: [u32; 5] = [500, 1000, 2000, 6000, 20_000];
const ORBITS: usize = 16;
/// Integrable tops, in turn with others: those beside them, whose chaos is thin, and any.
const FAMILIES: [(&str, Family); 9] = [
    ("Kovalevskaya", Family::Exact([2.0, 2.0, 1.0], [1.0, 0.0, 0.0])),
    ("beside Kovalevskaya", Family::Beside([2.0, 2.0, 1.0], [1.0, 0.0, 0.0])),
    ("Lagrange", Family::Exact([1.0, 1.0, 0.6], [0.0, 0.0, 1.0])),
    ("beside Lagrange", Family::Beside([1.0, 1.0, 0.6], [0.0, 0.0, 1.0])),
    ("Goryachev-Chaplygin, l = 0", Family::AtRest([4.0, 4.0, 1.0], [1.0, 0.0, 0.0])),
    ("beside Goryachev-Chaplygin", Family::Beside([4.0, 4.0, 1.0], [1.0, 0.0, 0.0])),
    ("beside Euler", Family::Beside([2.0, 1.5, 1.0], [0.0; 3])),
    ("the paper's", Family::Exact([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])),
    ("any", Family::Any),
];

#[derive(Clone, Copy)]
enum Family {
    Exact([f64; 3], [f64; 3]),
    AtRest([f64; 3], [f64; 3]),
    Beside([f64; 3], [f64; 3]),
    Any,
}

#[derive(Default)]
struct Tally {
    orbits: usize,
    /// For each number of crossings: regular, chaotic.
    decided: [[usize; 2]; CROSSINGS.len()],
    turned_out_chaotic: usize,
    wrong: usize,
}

fn main() -> Result<(), SectionError> {
    let mut arguments = std::env::args().skip(1).filter_map(|text| text.parse::<u64>().ok());
    let (points, seed) = (arguments.next().unwrap_or(45), arguments.next().unwrap_or(7));
    let mut rng = SplitMix64::new(seed);
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for (name, family) in FAMILIES.into_iter().cycle().take(usize::try_from(points).unwrap_or(0)) {
        let tally = tallies.entry(name).or_default();
        let (body, torus, h, starts) = loop {
            if let Some(found) = place(&mut rng, family) {
                break found;
            }
        };
        for measure in followed(&torus, &starts)? {
            count(tally, &measure, || format!("{name} A={:?} r={:?} h={h}", body.moments_f64(), body.center_f64()));
        }
    }
    print(&tallies);
    Ok(())
}

/// A body and starts at a point (h, l) of it; None where the point is not accessible.
fn place(rng: &mut SplitMix64, family: Family) -> Option<(Body, PpTorus, f64, Vec<State>)> {
    let mut span = |low: f64, high: f64| low + (high - low) * rng.unit();
    let (h, l) = (span(-0.5, 5.0), span(0.0, 3.0));
    let mut beside = |moments: [f64; 3], center: [f64; 3]| {
        let size = match span(0.0, 4.0) {
            x if x < 1.0 => 0.3,
            x if x < 2.0 => 0.1,
            x if x < 3.0 => 0.03,
            _ => 0.01,
        };
        (moments.map(|x| x * (1.0 + 0.3 * size * span(-1.0, 1.0))), center.map(|x| x + size * span(-1.0, 1.0)))
    };
    let ((moments, center), l) = match family {
        Family::Exact(moments, center) => ((moments, center), l),
        Family::AtRest(moments, center) => ((moments, center), 0.0),
        Family::Beside(moments, center) => (beside(moments, center), l),
        Family::Any => {
            let [x, y, z] = [(); 3].map(|()| span(0.05, 1.0));
            (([y + z, z + x, x + y], [(); 3].map(|()| span(-1.0, 1.0))), l)
        }
    };
    let body = Body::from_f64(moments, center).ok()?;
    let torus = PpTorus::new(&HeavyTop::new(&body)).ok()?;
    let points = spread_starts(&torus, h, l, &StartOptions { count: ORBITS, ..StartOptions::default() }).ok()?;
    let starts = points.iter().map(|&point| torus.state(point, h, l)).collect::<Result<_, _>>().ok()?;
    Some((body, torus, h, starts))
}

fn followed(torus: &PpTorus, starts: &[State]) -> Result<Vec<ChaosMeasure>, SectionError> {
    let options = SweepOptions { crossings: CROSSINGS[CROSSINGS.len() - 1] as usize, ..SweepOptions::default() };
    let orbits = sweep(torus, starts, &options, &Monitor::default())?;
    chaos_measures(torus, &orbits, &ChaosOptions::default(), &Monitor::default())
}

fn count(tally: &mut Tally, measure: &ChaosMeasure, place: impl Fn() -> String) {
    let Some(lyapunov) = measure.lyapunov else { return };
    let [whole, half] = [lyapunov.exponent * lyapunov.time, lyapunov.exponent_half * 0.5 * lyapunov.time];
    let turned_out_chaotic = whole > 60.0 && whole - half > 25.0;
    let judgement = &measure.judgement;
    tally.orbits += 1;
    tally.turned_out_chaotic += usize::from(turned_out_chaotic);
    let Some((_, crossing)) = judgement.decided else { return };
    let chaotic = judgement.verdict == OrbitVerdict::Chaotic;
    for (row, _) in tally.decided.iter_mut().zip(CROSSINGS).filter(|(_, crossings)| crossing <= *crossings) {
        row[usize::from(chaotic)] += 1;
    }
    if chaotic != turned_out_chaotic {
        tally.wrong += 1;
        println!("WRONG: {} orbit {}: {judgement:?}, ln|δ| {half} and {whole}", place(), measure.orbit);
    }
}

fn print(tallies: &BTreeMap<&str, Tally>) {
    println!("regular/chaotic/open after {CROSSINGS:?} crossings; how many turned out to be chaotic; wrong verdicts");
    for (name, tally) in tallies {
        let cells: Vec<String> = tally
            .decided
            .iter()
            .map(|[regular, chaotic]| format!("{regular}/{chaotic}/{}", tally.orbits - regular - chaotic))
            .collect();
        println!(
            "{name:<28} {:>5} orbits  {}  chaotic {}  wrong {}",
            tally.orbits,
            cells.join("  "),
            tally.turned_out_chaotic,
            tally.wrong
        );
    }
    let all = |part: fn(&Tally) -> usize| tallies.values().map(part).sum::<usize>();
    println!("{} orbits, {} wrong verdicts", all(|tally| tally.orbits), all(|tally| tally.wrong));
}
