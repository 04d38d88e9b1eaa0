//! The map of classes over two parameters, from the bodies of a scan.

use std::collections::BTreeMap;

use bifdiag_body::Preset;
use bifdiag_diagram::class::ClassName;
use bifdiag_documents::words::counted;
use bifdiag_numbers::decimal::significant;
use bifdiag_plot::{Map, MapAxis, MapBodies, MapEntry};
use bifdiag_schema::BodyParameter;
use bifdiag_survey::scan::known_classes;
use bifdiag_survey::subdivision::{Subdivision, divide};

use super::existence::{Existence, exists};
use super::shown::{Bodies, Seen, Shown, Shows, shared};

/// More classes than these share an entry: they could not be told apart.
const ENTRIES: usize = 30;

/// What is shown, on which part of the area of the map or by which part of the bodies, and where.
pub struct Counted<'a> {
    pub shows: &'a Shows,
    pub part: f64,
    pub at: Option<[f64; 2]>,
}

/// The map of some bodies, the most frequent class first.
#[must_use]
pub fn map(bodies: &[Seen], axes: [BodyParameter; 2], show: Shown) -> Map {
    let existence = Existence::over(bodies, axes);
    let has_impossible = bodies.iter().any(exists);
    let possible: Vec<&Seen> = bodies.iter().filter(|body| !has_impossible || exists(body)).collect();
    let grid = Grid::of(bodies);
    let subdivision = grid.as_ref().and_then(|grid| grid.divided(bodies, axes, show)).map(|mut subdivision| {
        for (_, corners) in &mut subdivision.pieces {
            *corners = existence.possible(corners);
        }
        subdivision.pieces.retain(|(_, corners)| corners.len() > 2);
        subdivision.seen.retain(|(_, at)| existence.holds(*at));
        subdivision
    });
    let order = counted_by(&possible, subdivision.as_ref(), show);
    let last = if show == Shown::Class && order.len() > ENTRIES { ENTRIES } else { usize::MAX };
    let number: BTreeMap<&Shows, usize> =
        order.iter().enumerate().map(|(k, counted)| (counted.shows, k.min(last))).collect();
    let entry = |shown: &Option<Shows>| shown.as_ref().and_then(|shown| number.get(shown).copied());
    let is_whole = possible.len() == bodies.len();
    let (bodies_drawn, ranges) = match (&grid, &subdivision) {
        (Some(grid), Some(subdivision)) => (areas(subdivision, entry, show), grid.ends(0.0)),
        (Some(grid), None) if is_whole => {
            let entries = grid.cells.iter().map(|&body| entry(&bodies[body].shows)).collect();
            (MapBodies::Grid { columns: grid.axes[0].len(), entries }, grid.ends(0.5))
        }
        _ => {
            let points = possible.iter().map(|body| (body.at, entry(&body.shows))).collect();
            (MapBodies::Points(points), [0, 1].map(|axis| margins(&values(bodies, axis))))
        }
    };
    let what = match show {
        Shown::Class => counted(order.len(), "class", "classes"),
        Shown::Regions => "number of regions".to_owned(),
        Shown::CriticalPoints => "relative equilibria at one l, at most, circles counted once".to_owned(),
    };
    let shown = match show {
        Shown::Class => "Classes of bifurcation diagrams",
        Shown::Regions => "Regions of bifurcation diagrams",
        Shown::CriticalPoints => "Relative equilibria",
    };
    let [x, y] = axes.map(|parameter| parameter.name().to_owned());
    let how_many = match bodies.len() - possible.len() {
        0 => counted(bodies.len(), "body", "bodies"),
        others => format!("{} that can exist ({others} cannot)", counted(possible.len(), "body", "bodies")),
    };
    let of = if subdivision.is_some() { "area" } else { "bodies" };
    Map {
        title: format!("{shown} over {x} and {y}"),
        subtitle: format!("{how_many}, {what}, with shares of the {of}{}", fixed(bodies, axes)),
        x: MapAxis { name: x, range: ranges[0] },
        y: MapAxis { name: y, range: ranges[1] },
        entries: entries(&order, last),
        ordered: show != Shown::Class,
        unknown: "undecided or failed".to_owned(),
        bodies: bodies_drawn,
        impossible: existence.impossible(ranges),
        lines: Vec::new(),
        notes: Vec::new(),
        key: if show == Shown::Class { key(&order, of, axes) } else { Vec::new() },
    }
}

/// What the bodies show, and what lies between them; classes by their parts, the largest first.
pub fn counted_by<'a>(
    bodies: &[&'a Seen],
    subdivision: Option<&'a Subdivision<Option<Shows>>>,
    show: Shown,
) -> Vec<Counted<'a>> {
    let mut parts: BTreeMap<&Shows, (f64, Option<[f64; 2]>)> = BTreeMap::new();
    for body in bodies {
        if let Some(shown) = &body.shows {
            let part = parts.entry(shown).or_default();
            let own = if subdivision.is_some() { 0.0 } else { 1.0 / bodies.len() as f64 };
            *part = (part.0 + own, part.1.or(Some(body.at)));
        }
    }
    if let Some(subdivision) = subdivision {
        let all: f64 = subdivision.pieces.iter().map(|(_, corners)| area(corners)).sum();
        for (shown, corners) in &subdivision.pieces {
            if let Some(shown) = shown {
                parts.entry(shown).or_default().0 += area(corners) / all;
            }
        }
        for (shown, at) in &subdivision.seen {
            if let Some(part) = shown.as_ref().and_then(|shown| parts.get_mut(shown)) {
                part.1 = part.1.or(Some(*at));
            }
        }
    }
    let counted = |(shows, (part, at))| Counted { shows, part, at };
    let mut order: Vec<Counted<'_>> = parts.into_iter().map(counted).collect();
    if show == Shown::Class {
        order.sort_by(|p, q| q.part.total_cmp(&p.part).then_with(|| p.shows.cmp(q.shows)));
    }
    order
}

/// The area of a polygon.
fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>().abs()
}

/// The parameters that are the same for all bodies, in words; empty if there are none.
fn fixed(bodies: &[Seen], axes: [BodyParameter; 2]) -> String {
    let shown = BodyParameter::ALL.into_iter().filter(|parameter| !axes.contains(parameter)).filter_map(|parameter| {
        shared(bodies, parameter).map(|value| {
            let sign = if is_rounded(value) { "≈" } else { "=" };
            format!("{} {sign} {}", parameter.name(), significant(value, 6))
        })
    });
    let shown: Vec<String> = shown.collect();
    if shown.is_empty() { String::new() } else { format!("; {}", shown.join(", ")) }
}

/// True where six digits are not all of a number.
pub fn is_rounded(value: f64) -> bool {
    significant(value, 6).parse() != Ok(value)
}

/// A part of the area or of the bodies; what lies on lines or at points alone has no area.
pub fn share(part: f64) -> String {
    match 100.0 * part {
        percent if percent < 0.05 => "below 0.1%".to_owned(),
        percent => format!("{percent:.1}%"),
    }
}

/// The legend: what is shown, by how many of the bodies, with how many regions; from `last` on in one entry. Classes have
/// numbers, and named bodies name theirs.
pub fn entries(order: &[Counted<'_>], last: usize) -> Vec<MapEntry> {
    let known = known(order);
    let entry = |(number, found): (usize, &Counted<'_>)| match found.shows {
        Shows::Class(class, regions) => MapEntry {
            name: counted(*regions, "region", "regions"),
            note: match known.get(class) {
                Some(preset) => format!("{}; {}", share(found.part), preset.name()),
                None => share(found.part),
            },
            mark: (number + 1).to_string(),
            key: class.to_string(),
            color: Some(number),
        },
        Shows::Count(count) => MapEntry {
            name: count.to_string(),
            note: share(found.part),
            mark: count.to_string(),
            key: String::new(),
            color: Some(number),
        },
    };
    let mut entries: Vec<MapEntry> = order.iter().enumerate().take(last).map(entry).collect();
    if let Some(others) = order.get(last..) {
        entries.push(MapEntry {
            name: counted(others.len(), "smaller class", "smaller classes"),
            note: share(others.iter().map(|other| other.part).sum()),
            ..MapEntry::default()
        });
    }
    entries
}

/// The named body of each class that has one, where there are classes.
fn known(order: &[Counted<'_>]) -> BTreeMap<ClassName, &'static Preset> {
    let has_classes = order.iter().any(|counted| matches!(counted.shows, Shows::Class(..)));
    if has_classes { known_classes() } else { BTreeMap::new() }
}

/// All classes by their numbers in the map, under a heading; shares are of the area or of the bodies.
fn key(order: &[Counted<'_>], of: &str, axes: [BodyParameter; 2]) -> Vec<Vec<String>> {
    let known = known(order);
    let [x, y] = axes.map(BodyParameter::name);
    let share_of = format!("share of the {of}");
    let heading = ["number", "class", "regions", &share_of, x, y, "named body"].map(str::to_owned).to_vec();
    let row = |(number, counted): (usize, &Counted<'_>)| {
        let (preset, regions) = match counted.shows {
            Shows::Class(class, regions) => (known.get(class).map_or("", |preset| preset.name()), *regions),
            Shows::Count(regions) => ("", *regions),
        };
        let [x, y] = counted.at.map_or_else(Default::default, |at| at.map(|value| significant(value, 6)));
        vec![
            (number + 1).to_string(),
            counted.shows.to_string(),
            regions.to_string(),
            share(counted.part),
            x,
            y,
            preset.to_owned(),
        ]
    };
    [heading].into_iter().chain(order.iter().enumerate().map(row)).collect()
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
pub fn areas(
    subdivision: &Subdivision<Option<Shows>>,
    entry: impl Fn(&Option<Shows>) -> Option<usize>,
    show: Shown,
) -> MapBodies {
    let pieces = subdivision.pieces.iter().map(|(shown, corners)| (entry(shown), corners.clone())).collect();
    let seen = subdivision.seen.iter().filter_map(|(shown, at)| Some((entry(shown)?, *at))).collect();
    let legend = match show {
        Shown::Class => "borders between classes, as scan border finds them",
        Shown::Regions => "borders at which the number changes",
        // It may change without the class, whose borders are found.
        Shown::CriticalPoints => "borders at which the number changes, to within a cell of the grid",
    };
    MapBodies::Areas { pieces, seen, borders: subdivision.borders.clone(), legend: legend.to_owned() }
}
