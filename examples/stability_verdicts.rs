//! A campaign for verdicts on stability: is anything left open but at isolated points that are known, and what does it cost?
//!
//! ```text
//! cargo run --release --example stability_verdicts -- 1000 39
//! ```
//! Arguments: number of random generic bodies, seed. As many in all come from the special strata; then there are the presets, and
//! bodies on the way to the ends of the range. Of each body are asked the verdicts along all curves, the isolated points at which a
//! hypothesis of Arnold's theorem fails, and all relative equilibria at one l between each two of the l at which anything changes,
//! before the first and beyond the last. What is not decided there is printed with its body. Times are CPU times of the thread, each
//! of one cold call. `data/oracles/stability_verdicts.txt` is the recorded result.

use std::collections::BTreeMap;
use std::time::Duration;

use bifdiag::Body;
use bifdiag::Number;
use bifdiag::body::Preset;
use bifdiag::equilibria::critical::RelativeEquilibria;
use bifdiag::equilibria::curves::CriticalSet;
use bifdiag::equilibria::nonlinear::{NonlinearVerdict, Reason, Verdicts};
use rustix::time::{ClockId, clock_gettime};
use support::bodies::{STRATA, Stratum, random_body};
use support::random::SplitMix64;

type Parts = ([f64; 3], [f64; 3]);

/// What a number of a row is made into.
type Maker = fn(f64) -> Parts;

/// Bodies that are special for ε = 0.
const ENDS: [(&str, Maker); 6] = [
    ("axis", |e| ([2.0, 1.1, 1.0], [1.0, e, 2.0 * e])),
    ("plane", |e| ([2.0, 1.1, 1.0], [0.94868, e, 0.61623])),
    ("symmetric", |e| ([1.0, 1.0 + e, 1.3], [0.3, 0.5, 0.7])),
    ("Lagrange", |e| ([1.0, 1.0 + e, 0.7], [e, 0.0, 1.0])),
    ("rod", |e| ([e, 1.0, 1.0 + 0.5 * e], [1.0, 0.3, 0.2])),
    ("Euler", |e| ([2.0, 1.1, 1.0], [0.3 * e, 0.5 * e, 0.7 * e])),
];

/// What came of the bodies so far.
#[derive(Default)]
struct Tally {
    bodies: usize,
    curves: usize,
    equilibria: usize,
    open: usize,
    verdicts: BTreeMap<String, usize>,
    exceptions: BTreeMap<String, usize>,
    /// The largest error of an exception, over its l or |h|.
    error: f64,
    /// Milliseconds: all relative equilibria at one l, for each of them; the verdicts along all curves and the exceptions, for each
    /// curve that needs a normal form, and for a body.
    at_point: Vec<f64>,
    of_body: Vec<f64>,
    of_curve: Vec<f64>,
    /// The body whose curves took longest, and how long.
    slowest: Option<(f64, String)>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().ok_or("number of bodies?")?.parse()?;
    let seed = arguments.next().ok_or("seed?")?.parse()?;
    let mut rng = SplitMix64::new(seed);
    report("random", (0..count).map(|_| random_body(&mut rng, Stratum::Generic)))?;
    let special = STRATA.into_iter().filter(|stratum| *stratum != Stratum::Generic);
    report("special", special.cycle().take(count).map(|stratum| random_body(&mut rng, stratum)))?;
    report("presets", Preset::all().iter().map(Preset::body))?;
    for (name, parts) in ENDS {
        let bodies = (1..=15).filter_map(|k| {
            let (moments, center) = parts(format!("1e-{k}").parse().ok()?);
            Body::from_f64(moments, center).ok()
        });
        report(&format!("to {name}"), bodies)?;
    }
    Ok(())
}

fn report(name: &str, bodies: impl Iterator<Item = Body>) -> Result<(), Box<dyn std::error::Error>> {
    let mut tally = Tally::default();
    for body in bodies {
        tally.add(&body)?;
    }
    println!(
        "{name}: {} bodies, {} curves, {} equilibria, {} open",
        tally.bodies, tally.curves, tally.equilibria, tally.open
    );
    println!("  verdicts: {:?}", tally.verdicts);
    println!("  exceptions: {:?}, largest relative error {:.1e}", tally.exceptions, tally.error);
    for (what, times) in [
        ("an equilibrium at one l", &mut tally.at_point),
        ("a curve with normal forms, proved", &mut tally.of_curve),
        ("a body, proved", &mut tally.of_body),
    ] {
        times.sort_by(f64::total_cmp);
        let at = |share: usize| times.get((times.len() * share / 100).min(times.len() - 1)).copied().unwrap_or(0.0);
        println!("  {what}: median {:.3} ms, 95 % {:.3} ms, worst {:.3} ms", at(50), at(95), at(100));
    }
    if let Some((time, body)) = &tally.slowest {
        println!("  slowest curves: {time:.3} ms each, {body}");
    }
    Ok(())
}

fn in_words(body: &Body) -> String {
    let list = |numbers: &[Number; 3]| numbers.each_ref().map(ToString::to_string).join(",");
    format!("--A {} --r {}", list(body.moments()), list(body.center()))
}

fn now() -> Duration {
    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).unwrap_or_default()
}

/// A result, and the CPU time that it took in milliseconds.
fn timed<R>(job: impl FnOnce() -> R) -> (R, f64) {
    let start = now();
    let result = job();
    (result, 1e3 * now().saturating_sub(start).as_secs_f64())
}

impl Tally {
    fn add(&mut self, body: &Body) -> Result<(), Box<dyn std::error::Error>> {
        let set = CriticalSet::new(body.frame())?;
        let (verdicts, time) = timed(|| Verdicts::new(body, &set));
        let critical = set.curves.iter().filter(|curve| curve.is_critical()).count();
        self.bodies += 1;
        self.curves += critical;
        self.of_body.push(time);
        let mut missed = |what: &str| {
            self.open += 1;
            println!("OPEN {what}: {}", in_words(body));
        };
        if !verdicts.is_complete() {
            missed("exceptions");
        }
        let mut of_normal_forms = 0;
        let mut places: Vec<f64> = verdicts.types().changes().iter().map(|change| change.l).collect();
        for id in set.curves.ids().filter(|id| set.curves[*id].is_critical()) {
            match verdicts.spans(id) {
                None => missed("curve without verdicts"),
                Some(spans) => {
                    of_normal_forms += usize::from(spans.iter().any(|span| span.why == Reason::Arnold));
                    if spans.iter().any(|span| span.verdict == NonlinearVerdict::Open) {
                        missed("stretch of a curve");
                    }
                    places.extend(spans.iter().flat_map(|span| [Some(span.l_from), span.l_to]).flatten());
                }
            }
        }
        for change in verdicts.changes() {
            let (kind, verdict, why) = (change.kind.word(), change.verdict.word(), change.why.word());
            let proved = if change.proved { "" } else { ", not proved" };
            *self.exceptions.entry(format!("{kind} {verdict} ({why}){proved}")).or_default() += 1;
            self.error = self.error.max(change.error_bound / change.l.max(change.h.abs()));
            places.push(change.l);
        }
        if of_normal_forms > 0 {
            let of_curve = time / of_normal_forms as f64;
            self.of_curve.push(of_curve);
            if self.slowest.as_ref().is_none_or(|(slowest, _)| of_curve > *slowest) {
                self.slowest = Some((of_curve, in_words(body)));
            }
        }
        places.retain(|l| *l > 0.0);
        places.sort_by(f64::total_cmp);
        places.dedup_by(|p, q| *p - *q < 1e-9 * *p);
        let unit = body.frame().momentum_unit;
        let ends = [places.first().map_or(unit, |l| 0.5 * l), places.last().map_or(2.0 * unit, |l| 2.0 * l)];
        let between = places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let all: Vec<f64> = between.chain(ends).collect();
        for l in all {
            let l = Number::from_f64(l)?;
            let (found, time) = timed(|| RelativeEquilibria::new(body).and_then(|prepared| prepared.at(&l)));
            let found = found?;
            self.at_point.push(time / found.list.len() as f64);
            self.equilibria += found.list.len();
            for point in found.list {
                let judged = point.nonlinear;
                *self.verdicts.entry(format!("{} ({})", judged.verdict.word(), judged.why.word())).or_default() += 1;
                if judged.verdict == NonlinearVerdict::Open || !judged.proved {
                    self.open += 1;
                    println!("OPEN at l = {l}: {} {judged:?}", in_words(body));
                }
            }
        }
        Ok(())
    }
}
