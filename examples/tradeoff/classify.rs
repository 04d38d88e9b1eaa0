//! Single points: time and share of right, wrong and undecided answers.

use proof::Accuracy;
use rayon::prelude::*;
use top::atlas::Atlas;
use top::classify::Classification;
use top::topology::Component;

use super::clock::{quantiles, timed};
use super::companion;
use super::points::Point;
use support::flood_fill;

#[derive(Clone, Copy, PartialEq)]
enum Verdict {
    Right,
    Wrong,
    Undecided,
    /// No answer at all.
    Failed,
    /// The truth is not known.
    Untold,
}

/// Rows of the flood fill's grid; twice as many columns.
const ROWS: [usize; 3] = [32, 96, 256];

type Method = (&'static str, fn(&Point) -> (Verdict, f64));

const METHODS: [Method; 8] = [
    ("fast", fast),
    ("fast on a prepared body", prepared),
    ("exact", exact),
    ("flood fill 32x64", |p| flood(p, ROWS[0])),
    ("flood fill 96x192", |p| flood(p, ROWS[1])),
    ("flood fill 256x512", |p| flood(p, ROWS[2])),
    ("companion matrix", |p| companion_matrix(p, 1e-8)),
    ("companion matrix 1e-4", |p| companion_matrix(p, 1e-4)),
];

pub fn run(points: &[Point]) {
    let mut groups: Vec<(&str, Option<f64>)> = points.iter().map(|p| (p.stratum.as_str(), p.distance)).collect();
    groups.dedup();
    println!("stratum,distance,method,points,right,wrong,undecided,failed,untold,cpu_us_median,cpu_us_99");
    for (stratum, distance) in groups {
        let group: Vec<&Point> = points.iter().filter(|p| p.stratum == stratum && p.distance == distance).collect();
        for (name, answer) in METHODS {
            let answers: Vec<(Verdict, f64)> = group.par_iter().map(|point| answer(point)).collect();
            let count = |verdict| answers.iter().filter(|answer| answer.0 == verdict).count();
            let [median, high] = quantiles(&mut answers.iter().map(|answer| answer.1).collect::<Vec<_>>());
            println!(
                "{stratum},{},{name},{},{},{},{},{},{},{median:.3},{high:.3}",
                distance.map_or_else(String::new, |d| format!("{d:e}")),
                group.len(),
                count(Verdict::Right),
                count(Verdict::Wrong),
                count(Verdict::Undecided),
                count(Verdict::Failed),
                count(Verdict::Untold),
            );
        }
    }
}

fn against(point: &Point, found: &[Component]) -> Verdict {
    match &point.truth {
        Some(truth) if truth == found => Verdict::Right,
        Some(_) => Verdict::Wrong,
        None => Verdict::Untold,
    }
}

fn answer_against(point: &Point, found: &Classification) -> Verdict {
    let Some(truth) = &point.truth else {
        return if found.components().is_none() { Verdict::Undecided } else { Verdict::Untold };
    };
    match found.components() {
        Some(components) if components == truth => Verdict::Right,
        None if found.candidates().contains(truth) => Verdict::Undecided,
        _ => Verdict::Wrong,
    }
}

fn fast(point: &Point) -> (Verdict, f64) {
    let (found, time) = timed(|| top::classify::classify(&point.body, &point.h, &point.l));
    (found.map_or(Verdict::Failed, |found| answer_against(point, &found)), time)
}

fn prepared(point: &Point) -> (Verdict, f64) {
    let Ok(atlas) = Atlas::new(&point.body) else { return (Verdict::Failed, 0.0) };
    let (found, time) = timed(|| atlas.classify(&point.h, &point.l));
    (found.map_or(Verdict::Failed, |found| answer_against(point, &found)), time)
}

fn exact(point: &Point) -> (Verdict, f64) {
    let (found, time) = timed(|| proof::classify(&point.body, &point.h, &point.l, Accuracy::Exact));
    (found.map_or(Verdict::Failed, |found| answer_against(point, &found)), time)
}

fn flood(point: &Point, rows: usize) -> (Verdict, f64) {
    let (found, time) = timed(|| flood_fill::components(&point.body, point.h.to_f64(), point.l.to_f64(), rows));
    (against(point, &found), time)
}

/// `real`: the imaginary part up to which a root counts as real, relative to its size. Right if it counts the relative equilibria below h right, which does not yet tell the components.
fn companion_matrix(point: &Point, real: f64) -> (Verdict, f64) {
    let (found, time) = timed(|| companion::equilibria_below(&point.body, point.h.to_f64(), point.l.to_f64(), real));
    let verdict = match found {
        None => Verdict::Failed,
        Some(count) if count == point.equilibria_below => Verdict::Right,
        Some(_) => Verdict::Wrong,
    };
    (verdict, time)
}
