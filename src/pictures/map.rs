//! The map of classes over two parameters, from the bodies of a scan.

use std::collections::BTreeMap;

use bifdiag_documents::words::counted;
use bifdiag_numbers::decimal::significant;
use bifdiag_plot::{Map, MapAxis, MapBodies, MapEntry};
use bifdiag_schema::BodyParameter;
use bifdiag_survey::scan::known_classes;
use bifdiag_survey::subdivision::{Subdivision, divide};

use super::shown::{Bodies, Seen, Shown, Shows, shared};

/// The map of some bodies, the most frequent class first.
#[must_use]
pub fn map(bodies: &[Seen], axes: [BodyParameter; 2], show: Shown) -> Map {
    let grid = Grid::of(bodies);
    let subdivision = grid.as_ref().and_then(|grid| grid.divided(bodies, axes, show));
    // What lies only between the bodies is listed too.
    let between =
        subdivision.iter().flat_map(|subdivision| &subdivision.pieces).filter_map(|(shown, _)| shown.as_ref());
    let mut counts: BTreeMap<&Shows, (usize, u32)> = between.map(|shown| (shown, (0, 0))).collect();
    for body in bodies {
        if let Some(shown) = &body.shows {
            let count = counts.entry(shown).or_default();
            *count = (count.0 + 1, body.regions);
        }
    }
    let mut order: Vec<(&Shows, usize, u32)> =
        counts.iter().map(|(name, (n, regions))| (*name, *n, *regions)).collect();
    if show == Shown::Class {
        order.sort_by(|p, q| q.1.cmp(&p.1).then_with(|| p.0.cmp(q.0)));
    }
    let number: BTreeMap<&Shows, usize> = order.iter().enumerate().map(|(k, (name, _, _))| (*name, k)).collect();
    let entry = |shown: &Option<Shows>| shown.as_ref().and_then(|shown| number.get(shown).copied());
    let (bodies_drawn, ranges) = match (&grid, &subdivision) {
        (Some(grid), Some(subdivision)) => (areas(subdivision, entry, show), grid.ends(0.0)),
        (Some(grid), None) => {
            let entries = grid.cells.iter().map(|&body| entry(&bodies[body].shows)).collect();
            (MapBodies::Grid { columns: grid.axes[0].len(), entries }, grid.ends(0.5))
        }
        (None, _) => {
            let points = bodies.iter().map(|body| (body.at, entry(&body.shows))).collect();
            (MapBodies::Points(points), [0, 1].map(|axis| margins(&values(bodies, axis))))
        }
    };
    let what = match show {
        Shown::Class => counted(order.len(), "class", "classes"),
        Shown::Regions => "number of regions".to_owned(),
        Shown::CriticalPoints => "relative equilibria at one l, at most".to_owned(),
    };
    let shown = match show {
        Shown::Class => "Classes of bifurcation diagrams",
        Shown::Regions => "Regions of bifurcation diagrams",
        Shown::CriticalPoints => "Relative equilibria",
    };
    let [x, y] = axes.map(|parameter| parameter.name().to_owned());
    Map {
        title: format!("{shown} over {x} and {y}"),
        subtitle: format!("{}, {what}{}", counted(bodies.len(), "body", "bodies"), fixed(bodies, axes)),
        x: MapAxis { name: x, range: ranges[0] },
        y: MapAxis { name: y, range: ranges[1] },
        entries: entries(&order, bodies.len()),
        ordered: show != Shown::Class,
        unknown: "undecided or failed".to_owned(),
        bodies: bodies_drawn,
        lines: Vec::new(),
        notes: Vec::new(),
    }
}

/// The parameters that are the same for all bodies, in words; empty where there are none.
fn fixed(bodies: &[Seen], axes: [BodyParameter; 2]) -> String {
    let shown = BodyParameter::ALL.into_iter().filter(|parameter| !axes.contains(parameter)).filter_map(|parameter| {
        shared(bodies, parameter).map(|value| format!("{} = {}", parameter.name(), significant(value, 6)))
    });
    let shown: Vec<String> = shown.collect();
    if shown.is_empty() { String::new() } else { format!("; {}", shown.join(", ")) }
}

/// The legend: what is shown, by how many of the bodies, with how many regions.
fn entries(order: &[(&Shows, usize, u32)], bodies: usize) -> Vec<MapEntry> {
    let share = |n: usize| match 100.0 * n as f64 / bodies as f64 {
        percent if percent < 0.05 => "below 0.1%".to_owned(),
        percent => format!("{percent:.1}%"),
    };
    // The regions of a class that none of the bodies has were not counted.
    let regions_of = |regions: u32| {
        if regions == 0 { String::new() } else { format!("{}, ", counted(regions, "region", "regions")) }
    };
    let has_classes = order.iter().any(|(shown, _, _)| matches!(shown, Shows::Class(_)));
    let known = if has_classes { known_classes() } else { BTreeMap::new() };
    let entry = |(number, (shown, bodies, regions)): (usize, &(&Shows, usize, u32))| match shown {
        Shows::Class(class) => MapEntry {
            name: class.to_string(),
            note: match known.get(class) {
                Some(preset) => format!("{}{}; {}", regions_of(*regions), share(*bodies), preset.name()),
                None => format!("{}{}", regions_of(*regions), share(*bodies)),
            },
            mark: (number + 1).to_string(),
            color: number,
        },
        Shows::Count(count) => {
            MapEntry { name: count.to_string(), note: share(*bodies), mark: count.to_string(), color: number }
        }
    };
    order.iter().enumerate().map(entry).collect()
}

/// The values of a parameter, each once, by size.
fn values(bodies: &[Seen], axis: usize) -> Vec<f64> {
    let mut values: Vec<f64> = bodies.iter().map(|body| body.at[axis]).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// A range that holds all values, with a margin.
fn margins(values: &[f64]) -> [f64; 2] {
    let (first, last) = (values[0], values[values.len() - 1]);
    let margin = 0.02 * (last - first);
    [first - margin, last + margin]
}

/// Bodies that are a grid with even steps.
struct Grid {
    axes: [Vec<f64>; 2],
    /// The number of the body at each point, row by row from below.
    cells: Vec<usize>,
}

/// Columns beyond which cells are too small for their borders to be seen in them.
const COLUMNS_MAX: usize = 300;

impl Grid {
    fn of(bodies: &[Seen]) -> Option<Self> {
        let axes = [values(bodies, 0), values(bodies, 1)];
        let even = |values: &Vec<f64>| {
            values.len() > 1 && values.windows(2).all(|pair| ((pair[1] - pair[0]) / step(values) - 1.0).abs() < 1e-6)
        };
        if !axes.iter().all(even) || axes[0].len() * axes[1].len() != bodies.len() {
            return None;
        }
        let mut cells: Vec<Option<usize>> = vec![None; bodies.len()];
        for (number, body) in bodies.iter().enumerate() {
            let place = |axis: usize| axes[axis].partition_point(|value| *value < body.at[axis]);
            cells[place(1) * axes[0].len() + place(0)] = Some(number);
        }
        // A body twice leaves a hole elsewhere: no grid.
        Some(Self { cells: cells.into_iter().collect::<Option<_>>()?, axes })
    }

    /// The ranges, extended by `more` steps on each side.
    fn ends(&self, more: f64) -> [[f64; 2]; 2] {
        self.axes.each_ref().map(|values| {
            let margin = more * step(values);
            [values[0] - margin, values[values.len() - 1] + margin]
        })
    }

    /// The plane of the bodies along its exact borders; none where other parameters vary too.
    fn divided(&self, bodies: &[Seen], axes: [BodyParameter; 2], show: Shown) -> Option<Subdivision<Option<Shows>>> {
        let steps = self.axes.each_ref().map(|values| step(values));
        let plane = Bodies::of(bodies, axes, steps, show)?;
        let shown: Vec<Option<Shows>> = self.cells.iter().map(|&body| bodies[body].shows.clone()).collect();
        let is_coarse = self.axes.iter().all(|values| values.len() <= COLUMNS_MAX);
        is_coarse.then(|| divide(&plane, self.axes.each_ref().map(Vec::as_slice), &shown))
    }
}

fn step(values: &[f64]) -> f64 {
    (values[values.len() - 1] - values[0]) / (values.len().max(2) - 1) as f64
}

/// The pieces of a subdivision.
fn areas(
    subdivision: &Subdivision<Option<Shows>>,
    entry: impl Fn(&Option<Shows>) -> Option<usize>,
    show: Shown,
) -> MapBodies {
    let pieces = subdivision.pieces.iter().map(|(shown, corners)| (entry(shown), corners.clone())).collect();
    let seen = subdivision.seen.iter().filter_map(|(shown, at)| Some((entry(shown)?, *at))).collect();
    let legend = match show {
        Shown::Class => "borders between classes, as scan border finds them",
        Shown::Regions | Shown::CriticalPoints => "borders at which the number changes",
    };
    MapBodies::Areas { pieces, seen, borders: subdivision.borders.clone(), told: legend.to_owned() }
}
