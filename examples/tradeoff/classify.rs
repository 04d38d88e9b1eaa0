//! Single points: time and share of right, wrong and undecided answers.

use std::collections::BTreeMap;

use bifdiag_diagram::topology::Classification;
use bifdiag_diagram::topology::Component;
use bifdiag_exact::{Accuracy, Solver};
use rayon::prelude::*;

use super::clock::{spread, timed};
use super::points::{Asked, Point};
use super::verdict::{ALL, Verdict, counts};
use super::{Failure, companion};
use support::flood_fill;

/// A body and what is made of it once.
struct Bodies<'a> {
    asked: &'a Asked,
    fast: Solver,
    exact: Solver,
}

/// Rows of the flood fill's grid; twice as many columns.
const ROWS: [usize; 3] = [32, 96, 256];

/// So many bodies of each stratum are asked what one would do otherwise, too.
const PEERS: usize = 100;

type Method = (&'static str, fn(&Bodies, &Point) -> (Verdict, f64));

const METHODS: [Method; 3] = [
    ("fast", |_, point| classified(point, Accuracy::Fast)),
    ("fast on a prepared body", |bodies, point| prepared(point, &bodies.fast)),
    ("exact", |_, point| classified(point, Accuracy::Exact)),
];

const OTHERS: [Method; 6] = [
    ("exact on a prepared body", |bodies, point| prepared(point, &bodies.exact)),
    ("flood fill 32x64", |_, point| flood(point, ROWS[0])),
    ("flood fill 96x192", |_, point| flood(point, ROWS[1])),
    ("flood fill 256x512", |_, point| flood(point, ROWS[2])),
    ("companion matrix", |_, point| companion_matrix(point, 1e-8)),
    ("companion matrix 1e-4", |_, point| companion_matrix(point, 1e-4)),
];

/// The answers of each method at each place of a body's list, and their times.
type Answers = BTreeMap<(usize, usize), Vec<(Verdict, f64)>>;

pub fn run(all: &[Asked], only: Option<&str>) -> Result<(), Failure> {
    println!(
        "stratum,distance,method,points,right,wrong,undecided,failed,untold,cpu_us_median,cpu_us_99,cpu_us_largest"
    );
    let mut strata: Vec<&str> = Vec::new();
    for asked in all {
        if !strata.contains(&asked.stratum.as_str()) && only.is_none_or(|only| only == asked.stratum) {
            strata.push(&asked.stratum);
        }
    }
    for stratum in strata {
        let group: Vec<&Asked> = all.iter().filter(|asked| asked.stratum == stratum).collect();
        eprintln!("{stratum}: {} bodies", group.len());
        let answers: Result<Vec<_>, String> =
            group.par_iter().enumerate().map(|(number, asked)| answers(asked, number < PEERS)).collect();
        let mut merged = Answers::new();
        for (key, mut one) in answers?.into_iter().flatten() {
            merged.entry(key).or_default().append(&mut one);
        }
        for ((place, method), answers) in merged {
            let distance = group[0].distances().nth(place).unwrap_or_default();
            print(stratum, distance, METHODS.iter().chain(&OTHERS).nth(method).map_or("", |m| m.0), &answers);
        }
    }
    Ok(())
}

fn answers(asked: &Asked, peers: bool) -> Result<Answers, String> {
    let prepared = |accuracy| {
        let body = Solver::new(asked.body.clone(), accuracy);
        // Its atlas is made here and not with the first point.
        let _answer = body.classify(&asked.l, &asked.l);
        body
    };
    let bodies = Bodies { asked, fast: prepared(Accuracy::Fast), exact: prepared(Accuracy::Exact) };
    let mut found = Answers::new();
    let others: &[Method] = if peers { &OTHERS } else { &[] };
    for (place, point) in bodies.asked.points().map_err(|error| error.to_string())?.iter().enumerate() {
        for (method, (name, answer)) in METHODS.iter().chain(others).enumerate() {
            let answer = answer(&bodies, point);
            if answer.0 == Verdict::Wrong && method <= METHODS.len() {
                let Point { body, distance, h, l, .. } = point;
                let numbers = (body.moments(), body.center());
                eprintln!("wrong: {name} {distance} {numbers:?} h={h:?} l={l:?}");
            }
            found.entry((place, method)).or_default().push(answer);
        }
    }
    Ok(found)
}

fn print(stratum: &str, distance: &str, name: &str, answers: &[(Verdict, f64)]) {
    let (verdicts, mut times): (Vec<Verdict>, Vec<f64>) = answers.iter().copied().unzip();
    let (counts, times) = (counts(&verdicts, &ALL), spread(&mut times, 3));
    println!("{stratum},{distance},{name},{},{counts},{times}", answers.len());
}

fn against(point: &Point, found: &[Component]) -> Verdict {
    match &point.truth {
        _ if !point.admits(found) => Verdict::Wrong,
        Some(truth) if truth == found => Verdict::Right,
        Some(_) => Verdict::Wrong,
        None => Verdict::Unknown,
    }
}

/// A point beside a curve is never on one.
fn answer_against(point: &Point, found: &Classification, accuracy: Accuracy) -> Verdict {
    match (found.components(), &point.truth) {
        (Some(components), _) => against(point, components),
        (None, _) if accuracy == Accuracy::Exact => Verdict::Wrong,
        (None, Some(truth)) if !found.candidates().contains(truth) => Verdict::Wrong,
        (None, _) => Verdict::Undecided,
    }
}

fn classified(point: &Point, accuracy: Accuracy) -> (Verdict, f64) {
    let (found, time) = timed(|| bifdiag_exact::classify(point.body, &point.h, point.l, accuracy));
    (found.map_or(Verdict::Failed, |found| answer_against(point, &found, accuracy)), time)
}

fn prepared(point: &Point, body: &Solver) -> (Verdict, f64) {
    let (found, time) = timed(|| body.classify(&point.h, point.l));
    (found.map_or(Verdict::Failed, |found| answer_against(point, &found, body.accuracy())), time)
}

fn flood(point: &Point, rows: usize) -> (Verdict, f64) {
    let (found, time) = timed(|| flood_fill::components(point.body, point.h.to_f64(), point.l.to_f64(), rows));
    (against(point, &found), time)
}

/// `real`: the imaginary part up to which a root counts as real, relative to its size. Right if it counts the relative
/// equilibria below h right, which does not yet give the components.
fn companion_matrix(point: &Point, real: f64) -> (Verdict, f64) {
    let (found, time) = timed(|| companion::equilibria_below(point.body, point.h.to_f64(), point.l.to_f64(), real));
    let verdict = match found {
        None => Verdict::Failed,
        Some(count) if count == point.equilibria_below => Verdict::Right,
        Some(_) => Verdict::Wrong,
    };
    (verdict, time)
}
