//! A campaign against `classify`: random and adversarial points over all strata, against the latitude sweep and against
//! exact rational arithmetic for the pole lines. Seeded: the same command prints the same numbers (but for the time).
//!
//! ```text
//! cargo run --release --example campaign -- 100000 7
//! ```
//! Arguments: number of points, seed. Half of the points are random; the others lie at relative distance 1e-3 … 1e-15
//! from a random curve. The truth there is the sweep at the middle of the gap between curves into which the point falls,
//! when the point is farther from every curve than rounding (1e-13); nearer points must be undecided or agree between the cold
//! and the prepared body. For random points of either kind the side of both pole lines is decided in exact arithmetic.

use std::collections::BTreeMap;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::fast::classify;
use bifdiag_diagram::topology::{Answer, Classification};
use bifdiag_diagram::topology::{Poles, latitude};
use dashu_ratio::RBig;
use support::bodies::{STRATA, Stratum, random_body, random_point};
use support::random::SplitMix64;

#[derive(Default)]
struct Tally {
    points: u64,
    /// Answers of the cold and of the prepared body.
    undecided: [u64; 2],
    /// Undecided although the nearest curve is farther than 1e-13.
    undecided_far: u64,
    compared: u64,
    /// The sweep could not decide.
    unswept: u64,
    wrong: u64,
    failed: u64,
}

/// Below this relative distance the side of a curve is not known here.
const KNOWN: f64 = 1e-13;

fn main() {
    let mut arguments = std::env::args().skip(1).filter_map(|text| text.parse::<u64>().ok());
    let (points, seed) = (arguments.next().unwrap_or(20_000), arguments.next().unwrap_or(7));
    let start = std::time::Instant::now();
    let mut rng = SplitMix64::new(seed);
    let mut tally: BTreeMap<Stratum, Tally> = BTreeMap::new();
    let mut shown = 0;
    for n in 0..points / 4 {
        let stratum = STRATA[usize::try_from(n).unwrap_or(0) % STRATA.len()];
        let body = random_body(&mut rng, stratum);
        let counts = tally.entry(stratum).or_default();
        let Ok(atlas) = bifdiag_diagram::fast::atlas(&body) else {
            counts.points += 4;
            counts.failed += 4;
            println!("no atlas: A={:?} r={:?}", body.moments_f64(), body.center_f64());
            continue;
        };
        for k in 0..4 {
            counts.points += 1;
            let (h, l) = random_point(&mut rng, &body);
            let h = if k % 2 == 0 { h } else { beside_a_curve(&mut rng, &atlas, l) };
            if let Err(what) = examine(&body, &atlas, h, l, counts) {
                shown += 1;
                if shown <= 50 {
                    println!(
                        "{what}: {stratum:?} A={:?} r={:?} h={h:e} l={l:e}",
                        body.moments_f64(),
                        body.center_f64()
                    );
                }
            }
        }
    }
    println!("{points} points, seed {seed}, {:.0} s", start.elapsed().as_secs_f64());
    println!(
        "{:10} {:>8} {:>9} {:>15} {:>9} {:>8} {:>13} {:>6} {:>7}",
        "stratum", "points", "undecided", "(prepared body)", "> 1e-13", "compared", "sweep refused", "wrong", "failed"
    );
    for (stratum, t) in &tally {
        println!(
            "{:10} {:>8} {:>9} {:>15} {:>9} {:>8} {:>13} {:>6} {:>7}",
            format!("{stratum:?}"),
            t.points,
            t.undecided[0],
            t.undecided[1],
            t.undecided_far,
            t.compared,
            t.unswept,
            t.wrong,
            t.failed
        );
    }
}

/// Heights of all curves over l, ascending, with their energy scale.
fn heights(atlas: &Atlas, l: f64) -> Vec<(f64, f64)> {
    let set = &atlas.arrangement().set;
    let scaled = l / set.frame.momentum_unit;
    let x = 0.5 * scaled * scaled;
    let mut found: Vec<(f64, f64)> = set
        .curves
        .ids()
        .filter(|&c| set.curves[c].x()[0] <= x && x <= set.curves[c].x()[1])
        .map(|c| {
            let point = set.curves[c].point(&set.frame, x);
            let unit = set.frame.energy_unit;
            (point.h() * unit, (point.x / point.j + set.frame.r_norm) * unit)
        })
        .collect();
    found.sort_by(|p, q| p.0.total_cmp(&q.0));
    found
}

fn beside_a_curve(rng: &mut SplitMix64, atlas: &Atlas, l: f64) -> f64 {
    let all = heights(atlas, l);
    let (h, scale) = all[rng.index(all.len())];
    h + rng.sign() * scale * rng.power_of_ten(-15.5, -3.0)
}

fn examine(body: &Body, atlas: &Atlas, h: f64, l: f64, counts: &mut Tally) -> Result<(), String> {
    let (Ok(number_h), Ok(number_l)) = (Number::from_f64(h), Number::from_f64(l)) else { return Ok(()) };
    let (cold, prepared) = match (
        classify(body, &number_h, &number_l),
        bifdiag_diagram::fast::classify_in(atlas, &number_h, &number_l).map(|(found, _)| found),
    ) {
        (Ok(cold), Ok(prepared)) => (cold, prepared),
        (Err(error), _) | (_, Err(error)) => {
            counts.failed += 1;
            return Err(error.to_string());
        }
    };
    let all = heights(atlas, l);
    let distance = all.iter().map(|(c, scale)| (h - c).abs() / scale).fold(f64::INFINITY, f64::min);
    let mut far = false;
    for (k, found) in [&cold, &prepared].into_iter().enumerate() {
        if found.components().is_none() {
            counts.undecided[k] += 1;
            far |= distance > KNOWN;
        }
    }
    counts.undecided_far += u64::from(far);
    let mut wrong = |what: String| {
        counts.wrong += 1;
        Err(what)
    };
    let (first, second) = (cold.components(), prepared.components());
    if first.is_some() && second.is_some() && first != second {
        return wrong(format!("cold {first:?}, prepared {second:?}"));
    }
    if let Some(sides) = poles_inside(body, &number_h, &number_l) {
        for found in [&cold, &prepared] {
            if matches!(found.answer, Answer::Regular(_)) && poles_of(found) != sides {
                return wrong(format!("poles {:?} for {sides:?}", poles_of(found)));
            }
        }
    }
    if distance <= KNOWN {
        return Ok(());
    }
    let frame = body.frame();
    let (middle, l) = (middle(&all, h) / frame.energy_unit, l / frame.momentum_unit);
    let Ok(swept) = latitude::components(&frame, middle, l) else {
        counts.unswept += 1;
        return Ok(());
    };
    counts.compared += 1;
    for found in [&cold, &prepared] {
        let right = match found.components() {
            Some(components) => components == swept,
            None => found.candidates().contains(&swept),
        };
        if !right {
            counts.wrong += 1;
            return Err(format!("{:?} {:?}, sweep {swept:?}", found.components(), found.candidates()));
        }
    }
    Ok(())
}

/// The middle of the gap between curves into which h falls.
fn middle(heights: &[(f64, f64)], h: f64) -> f64 {
    let position = heights.partition_point(|(c, _)| *c < h);
    match (position.checked_sub(1).map(|k| heights[k]), heights.get(position)) {
        (Some((below, _)), Some((above, _))) => 0.5 * (below + above),
        (Some((below, scale)), None) => below + scale,
        (None, Some((above, scale))) => above - scale,
        (None, None) => h,
    }
}

/// Which poles lie in U_hl, exactly: h ∓ … ≥ l²/(2 J_r) ∓ r. `None` for r = 0 or on a pole line.
fn poles_inside(body: &Body, h: &Number, l: &Number) -> Option<[bool; 2]> {
    let a = body.moments().each_ref().map(Number::value);
    let r = body.center().each_ref().map(Number::value);
    let squared = r.map(|c| c * c);
    let norm = &squared[0] + &squared[1] + &squared[2];
    if norm.is_zero() {
        return None;
    }
    let weighted = &squared[0] * a[0] + &squared[1] * a[1] + &squared[2] * a[2];
    let offset = h.value() - l.value() * l.value() / RBig::from(2) * &norm / weighted;
    let square = &offset * &offset;
    if square == norm {
        return None;
    }
    // offset > −r and offset > r.
    let positive = offset > RBig::ZERO;
    Some([positive || square < norm, positive && square > norm])
}

fn poles_of(found: &Classification) -> [bool; 2] {
    let has = |inside: fn(Poles) -> bool| found.components().into_iter().flatten().any(|c| c.poles.is_some_and(inside));
    [has(|poles| poles.plus), has(|poles| poles.minus)]
}
