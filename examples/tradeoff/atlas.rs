//! Whole bodies: time of an atlas, and whether it holds the regions that are proved.

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::topology::Component;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::curves::Branch;
use bifdiag_exact::{Accuracy, CertifiedAtlas};
use bifdiag_numbers::table::Id;
use rayon::prelude::*;

use super::clock::{spread, timed};
use super::companion;
use super::points::Asked;
use super::verdict::{ALL, Verdict, counts};
use support::flood_fill;

/// Bodies of each stratum, and those on which the flood fill is tried.
const BODIES: usize = 60;
const FLOODED: usize = 4;

/// Points of the (h, l) plane in each direction, and rows of the flood fill at each.
const GRIDS: [(usize, usize); 3] = [(12, 32), (24, 48), (40, 64)];

/// The classes of all regions, sorted.
type Classes = Vec<Vec<Component>>;

#[derive(Default)]
struct Tally {
    verdicts: Vec<Verdict>,
    times: Vec<f64>,
}

impl Tally {
    /// `found`: the answer, if there is one; `whole`: nothing in it is undecided.
    fn add<T: PartialEq>(&mut self, time: f64, found: Option<&T>, whole: bool, truth: Option<&T>) {
        self.times.push(time);
        self.verdicts.push(match (found, truth) {
            (None, _) => Verdict::Failed,
            (Some(_), _) if !whole => Verdict::Undecided,
            (Some(_), None) => Verdict::Unknown,
            (Some(found), Some(truth)) if found == truth => Verdict::Right,
            (Some(_), Some(_)) => Verdict::Wrong,
        });
    }

    fn print(mut self, stratum: &str, method: &str) {
        let (count, counts, times) = (self.times.len(), counts(&self.verdicts, &ALL), spread(&mut self.times, 1));
        println!("{stratum},{method},{count},{counts},{times}");
    }
}

pub fn run(all: &[Asked]) {
    println!("stratum,method,bodies,right,wrong,undecided,failed,untold,cpu_us_median,cpu_us_99,cpu_us_largest");
    for stratum in ["generic", "near axis", "near symmetric", "rod"] {
        let bodies = all.iter().filter(|asked| asked.stratum == stratum).map(|asked| &asked.body);
        let bodies: Vec<&Body> = bodies.take(BODIES).collect();
        let (certified, truths) = proofs(&bodies);
        let mut bare = Tally::default();
        for (body, truth) in bodies.iter().zip(&truths) {
            let (atlas, time) = timed(|| bifdiag_diagram::fast::atlas(body));
            let whole = atlas.as_ref().is_ok_and(is_whole);
            bare.add(time, atlas.ok().map(|atlas| classes(&atlas)).as_ref(), whole, truth.as_ref());
        }
        bare.print(stratum, "regions alone");
        for (name, accuracy) in [("fast", Accuracy::Fast), ("exact", Accuracy::Exact)] {
            with_documents(&bodies, &truths, accuracy).print(stratum, name);
        }
        certified.print(stratum, "proof");
        for (points, rows) in GRIDS {
            let name = format!("flood fill {points}x{points} points of {rows}x{}", 2 * rows);
            flood_fills(&bodies, &truths, points, rows).print(stratum, &name);
        }
        for (name, real) in [("companion matrix: cusps alone", 1e-8), ("companion matrix 1e-4: cusps alone", 1e-4)] {
            let mut tally = Tally::default();
            for body in &bodies {
                let (found, time) = timed(|| companion::cusps(body, real));
                let truth = bifdiag_diagram::fast::atlas(body).ok().filter(is_whole);
                tally.add(time, found.as_ref(), true, truth.map(|atlas| cusps(&atlas)).as_ref());
            }
            tally.print(stratum, name);
        }
    }
}

/// Proved atlases, and what they say: the truth for all others.
fn proofs(bodies: &[&Body]) -> (Tally, Vec<Option<Classes>>) {
    let proofs: Vec<(Option<Classes>, f64)> = bodies
        .par_iter()
        .map(|body| {
            let (atlas, time) = timed(|| CertifiedAtlas::new(body));
            (atlas.ok().and_then(|atlas| proved(&atlas)), time)
        })
        .collect();
    let mut tally = Tally::default();
    for (classes, time) in &proofs {
        tally.add(*time, Some(classes), classes.is_some(), Some(classes));
    }
    (tally, proofs.into_iter().map(|(classes, _)| classes).collect())
}

fn with_documents(bodies: &[&Body], truths: &[Option<Classes>], accuracy: Accuracy) -> Tally {
    let options = DocumentOptions { accuracy, ..DocumentOptions::default() };
    let mut tally = Tally::default();
    for (body, truth) in bodies.iter().zip(truths) {
        let (found, time) = timed(|| {
            let atlas = bifdiag_exact::atlas(body, accuracy).ok()?;
            let document = bifdiag_documents::atlas::document(&atlas, &options);
            Some((atlas, document.summary.undecided.is_empty()))
        });
        let whole = found.as_ref().is_some_and(|(_, whole)| *whole);
        let classes = found.map(|(atlas, _)| classes(&atlas));
        tally.add(time, classes.as_ref(), whole, truth.as_ref());
    }
    tally
}

fn flood_fills(bodies: &[&Body], truths: &[Option<Classes>], points: usize, rows: usize) -> Tally {
    let found: Vec<(Classes, f64)> =
        bodies.par_iter().take(FLOODED).map(|body| timed(|| flooded(body, points, rows))).collect();
    let mut tally = Tally::default();
    for ((found, time), truth) in found.into_iter().zip(truths) {
        // A grid cannot distinguish two regions of one class.
        let kinds = truth.clone().map(|mut all| {
            all.dedup();
            all
        });
        tally.add(time, Some(&found), true, kinds.as_ref());
    }
    tally
}

/// Nothing is left undecided: neither the plane nor the topology of a region.
fn is_whole(atlas: &Atlas) -> bool {
    atlas.arrangement().undecided.is_empty() && atlas.regions().ids().all(|region| atlas.components(region).is_ok())
}

fn key(components: &[Component]) -> String {
    format!("{components:?}")
}

fn sorted(mut classes: Classes) -> Classes {
    classes.sort_by_key(|components| key(components));
    classes
}

fn proved(atlas: &CertifiedAtlas) -> Option<Classes> {
    let classes: Option<Classes> =
        atlas.region_ids().map(|region| atlas.components(region).map(<[Component]>::to_vec)).collect();
    classes.map(sorted)
}

fn classes(atlas: &Atlas) -> Classes {
    let all = atlas.regions().ids().filter_map(|region| atlas.components(region).ok().map(<[Component]>::to_vec));
    sorted(all.collect())
}

/// The classes that a grid over the part of the plane with all events shows, each once.
fn flooded(body: &Body, points: usize, rows: usize) -> Classes {
    let (a, r) = (body.moments_f64(), body.center_f64());
    let norm = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let [least, most] = [a.iter().copied().fold(f64::INFINITY, f64::min), a.iter().copied().fold(0.0, f64::max)];
    // Events of bodies of order one lie below a few times the natural momentum.
    let l_max = 4.0 * (norm * most).sqrt();
    let mut found = Classes::new();
    for row in 1..=points {
        let l = l_max * row as f64 / points as f64;
        let [low, high] = [0.5 * l * l / most - norm, 0.5 * l * l / least + norm];
        for column in 0..points {
            let h = low + (high - low) * (column as f64 + 0.5) / points as f64;
            let components = flood_fill::components(body, h, l, rows);
            if !components.is_empty() && !found.contains(&components) {
                found.push(components);
            }
        }
    }
    sorted(found)
}

/// Cusps of the generic family in each interval of μ.
fn cusps(atlas: &Atlas) -> [usize; 4] {
    let set = &atlas.arrangement().set;
    let mut counts = [0; 4];
    for cusp in &set.cusps {
        if let Branch::Generic(interval) = set.curves[cusp.curves[0]].branch {
            counts[interval.index()] += 1;
        }
    }
    counts
}
