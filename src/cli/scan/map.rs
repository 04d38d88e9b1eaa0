//! `bifdiag scan map`: the class of each body over two parameters.

use std::collections::BTreeMap;
use std::fmt;

use plot::{Map, MapAxis, MapBodies, MapEntry, draw_map};
use survey::Parameter;
use survey::scan::{Row, known_classes};
use top::class::ClassName;

use super::arguments::{MapArguments, Shown};
use super::error::ScanInput;
use super::output;
use crate::cli::export::{ExportError, FileSet, RESOLUTION};
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, Timings, print, significant};

pub fn run(arguments: &MapArguments, timings: &Timings) -> Result<(), Failure> {
    if arguments.x == arguments.y {
        let reason = format!("both axes show it; choose two of {}", names());
        return Err(ScanInput::Axis { option: "--y", name: arguments.y.to_string(), reason }.into());
    }
    let file = &arguments.file;
    let format = output::format_of_input(file)?;
    let table = |source| ScanInput::Table { path: file.clone(), source };
    let mut bodies = Vec::new();
    for row in format.rows(file).map_err(table)? {
        let row = row.map_err(table)?;
        let not_a_row = |source| ScanInput::Row { path: file.clone(), body: row.index, source };
        let axes = [arguments.x, arguments.y];
        bodies.push(Seen::new(&documents::scan::read_row(&row).map_err(not_a_row)?, axes, arguments.show));
    }
    let axes = [("--x", arguments.x), ("--y", arguments.y)];
    if bodies.is_empty() {
        return Err(ScanInput::Empty { path: file.clone() }.into());
    }
    for (place, (option, parameter)) in axes.into_iter().enumerate() {
        if bodies.iter().all(|body| body.at[place] == bodies[0].at[place]) {
            let reason = format!("it is the same for all {} bodies of {}", bodies.len(), file.display());
            return Err(ScanInput::Axis { option, name: parameter.to_string(), reason }.into());
        }
    }
    let map = map(&bodies, [arguments.x, arguments.y], arguments.show);
    let picture = timings.stage("map", || draw_map(&map, arguments.picture.theme())).map_err(ExportError::from)?;
    let mut files = FileSet::new(&arguments.out);
    files.remove_pictures("map");
    files.pictures("map", &picture, &arguments.picture.format, RESOLUTION, timings)?;
    Ok(print(Report::written(&files.write()?).text())?)
}

fn names() -> String {
    Parameter::ALL.map(Parameter::name).join(", ")
}

/// What a body shows by its colour.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shows {
    /// The class of its diagram.
    Class(ClassName),
    /// A number of something.
    Count(u32),
}

impl fmt::Display for Shows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Class(name) => write!(f, "{name}"),
            Self::Count(count) => write!(f, "{count}"),
        }
    }
}

/// What the map needs of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The two parameters.
    pub at: [f64; 2],
    /// A1, A2, A3, r1, r2, r3.
    pub values: [[f64; 3]; 2],
    /// What the body shows.
    pub shows: Option<Shows>,
    /// Number of regions.
    pub regions: u32,
}

impl Seen {
    /// What a row shows.
    pub fn new(row: &Row, axes: [Parameter; 2], show: Shown) -> Self {
        let at = axes.map(|parameter| row.values.as_flattened()[parameter.place()]);
        let counts = row.diagram.as_ref();
        let shows = row.class.as_ref().zip(counts).map(|(class, counts)| match show {
            Shown::Class => Shows::Class(class.clone()),
            Shown::Regions => Shows::Count(counts.regions),
            Shown::CriticalPoints => Shows::Count(counts.critical_points),
        });
        Self { at, values: row.values, shows, regions: counts.map_or(0, |counts| counts.regions) }
    }
}

/// The map of some bodies, the most frequent class first.
pub fn map(bodies: &[Seen], axes: [Parameter; 2], show: Shown) -> Map {
    let mut counts: BTreeMap<&Shows, (usize, u32)> = BTreeMap::new();
    for body in bodies {
        if let Some(shown) = &body.shows {
            counts.entry(shown).or_insert((0, body.regions)).0 += 1;
        }
    }
    let mut order: Vec<(&Shows, usize, u32)> =
        counts.iter().map(|(name, (n, regions))| (*name, *n, *regions)).collect();
    if show == Shown::Class {
        order.sort_by(|p, q| q.1.cmp(&p.1).then_with(|| p.0.cmp(q.0)));
    }
    let number: BTreeMap<&Shows, usize> = order.iter().enumerate().map(|(k, (name, _, _))| (*name, k)).collect();
    let entry = |body: &Seen| body.shows.as_ref().and_then(|shown| number.get(shown).copied());
    let (bodies_drawn, ranges) = placed(bodies, entry);
    let what = match show {
        Shown::Class => format!("{} classes", order.len()),
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
        subtitle: format!("{} bodies, {what}{}", bodies.len(), fixed(bodies, axes)),
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
fn fixed(bodies: &[Seen], axes: [Parameter; 2]) -> String {
    let value = |body: &Seen, parameter: Parameter| body.values.as_flattened()[parameter.place()];
    let told = Parameter::ALL.into_iter().filter(|parameter| !axes.contains(parameter)).filter_map(|parameter| {
        let first = value(bodies.first()?, parameter);
        let same = bodies.iter().all(|body| value(body, parameter) == first);
        same.then(|| format!("{} = {}", parameter.name(), significant(first, 6)))
    });
    let told: Vec<String> = told.collect();
    if told.is_empty() { String::new() } else { format!("; {}", told.join(", ")) }
}

/// The legend: what is shown, by how many of the bodies, with how many regions.
fn entries(order: &[(&Shows, usize, u32)], bodies: usize) -> Vec<MapEntry> {
    let share = |n: usize| match 100.0 * n as f64 / bodies as f64 {
        percent if percent < 0.05 => "below 0.1%".to_owned(),
        percent => format!("{percent:.1}%"),
    };
    let has_classes = order.iter().any(|(shown, _, _)| matches!(shown, Shows::Class(_)));
    let known = if has_classes { known_classes() } else { BTreeMap::new() };
    let entry = |(number, (shown, bodies, regions)): (usize, &(&Shows, usize, u32))| match shown {
        Shows::Class(class) => MapEntry {
            name: class.to_string(),
            note: match known.get(class) {
                Some(preset) => format!("{regions} regions, {}; {}", share(*bodies), preset.name()),
                None => format!("{regions} regions, {}", share(*bodies)),
            },
            mark: (number + 1).to_string(),
        },
        Shows::Count(count) => MapEntry { name: count.to_string(), note: share(*bodies), mark: count.to_string() },
    };
    order.iter().enumerate().map(entry).collect()
}

/// Bodies as a grid if they are one with even steps, and the ranges that hold them all.
fn placed(bodies: &[Seen], entry: impl Fn(&Seen) -> Option<usize>) -> (MapBodies, [[f64; 2]; 2]) {
    let values = |place: usize| {
        let mut values: Vec<f64> = bodies.iter().map(|body| body.at[place]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let axes = [values(0), values(1)];
    let step = |values: &[f64]| (values[values.len() - 1] - values[0]) / (values.len().max(2) - 1) as f64;
    let even = |values: &[f64]| {
        values.len() > 1 && values.windows(2).all(|pair| ((pair[1] - pair[0]) / step(values) - 1.0).abs() < 1e-6)
    };
    let ends = |values: &[f64], more: f64| [values[0] - more, values[values.len() - 1] + more];
    if axes.iter().all(|values| even(values)) && axes[0].len() * axes[1].len() == bodies.len() {
        let columns = axes[0].len();
        let mut cells: Vec<Option<Option<usize>>> = vec![None; bodies.len()];
        for body in bodies {
            let place = |axis: usize| axes[axis].partition_point(|value| *value < body.at[axis]);
            cells[place(1) * columns + place(0)] = Some(entry(body));
        }
        // A body twice leaves a hole elsewhere: no grid.
        if cells.iter().all(Option::is_some) {
            let entries = cells.into_iter().map(Option::flatten).collect();
            let ranges = [0, 1].map(|axis| ends(&axes[axis], 0.5 * step(&axes[axis])));
            return (MapBodies::Grid { columns, entries }, ranges);
        }
    }
    let points = bodies.iter().map(|body| (body.at, entry(body))).collect();
    let margin = |values: &[f64]| 0.02 * (values[values.len() - 1] - values[0]);
    (MapBodies::Points(points), [0, 1].map(|axis| ends(&axes[axis], margin(&axes[axis]))))
}
