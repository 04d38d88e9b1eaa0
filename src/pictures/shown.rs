//! What bodies show on a map, and where it changes between them.

use std::fmt;

use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use bifdiag_schema::BodyParameter;
use bifdiag_survey::border::{self, BodySegment, Border, BorderOptions};
use bifdiag_survey::scan::ScanRow;
use bifdiag_survey::subdivision::{LabelledPlane, PlanePoint};
use rayon::prelude::*;

/// What a map shows by its colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Shown {
    /// The class of the diagram
    Class,
    /// The number of regions
    Regions,
    /// The largest number of relative equilibria at one l
    CriticalPoints,
}

/// What a body shows by its colour.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shows {
    /// The class of its diagram, and how many regions that has.
    Class(ClassName, u32),
    /// A number of something.
    Count(u32),
}

impl fmt::Display for Shows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Class(name, _) => write!(f, "{name}"),
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
}

impl Seen {
    /// What a row shows.
    #[must_use]
    pub fn new(row: &ScanRow, axes: [BodyParameter; 2], show: Shown) -> Self {
        let at = axes.map(|parameter| row.values.as_flattened()[parameter.place()]);
        let counts = row.diagram.as_ref();
        let shows = row.class.as_ref().zip(counts).map(|(class, counts)| match show {
            Shown::Class => Shows::Class(class.clone(), counts.regions),
            Shown::Regions => Shows::Count(counts.regions),
            Shown::CriticalPoints => Shows::Count(counts.critical_points),
        });
        Self { at, values: row.values, shows }
    }
}

/// The value of a parameter that all bodies have; `None` where they differ.
pub fn shared(bodies: &[Seen], parameter: BodyParameter) -> Option<f64> {
    let value = |body: &Seen| body.values.as_flattened()[parameter.place()];
    let first = value(bodies.first()?);
    bodies.iter().all(|body| value(body) == first).then_some(first)
}

/// The bodies over two parameters, the other four as given.
pub struct Bodies {
    values: [[f64; 3]; 2],
    axes: [BodyParameter; 2],
    show: Shown,
    /// To what in each parameter borders are sought by bisection.
    tolerance: [f64; 2],
}

/// Borders are sought by bisection to this part of the grid's step; the zero of what vanishes at a border then gives it to
/// the last digits.
const BISECTED: f64 = 1.0 / 128.0;

impl Bodies {
    /// Those among which these are, a grid with these steps; none where another parameter varies too.
    pub fn of(bodies: &[Seen], axes: [BodyParameter; 2], steps: [f64; 2], show: Shown) -> Option<Self> {
        let mut others = BodyParameter::ALL.into_iter().filter(|parameter| !axes.contains(parameter));
        others.all(|parameter| shared(bodies, parameter).is_some()).then_some(Self {
            values: bodies.first()?.values,
            axes,
            show,
            tolerance: steps.map(|step| BISECTED * step),
        })
    }

    fn values(&self, place: PlanePoint) -> [[f64; 3]; 2] {
        let mut values = self.values;
        for (parameter, value) in self.axes.into_iter().zip(place) {
            values.as_flattened_mut()[parameter.place()] = value;
        }
        values
    }

    fn shown(&self, values: [[f64; 3]; 2]) -> Option<Shows> {
        Seen::new(&ScanRow::of(0, values, Accuracy::Exact), self.axes, self.show).shows
    }

    /// What is shown on the two sides of a border.
    fn beside(&self, segment: &BodySegment, border: &Border) -> [Option<Shows>; 2] {
        let side = |k: usize| match self.show {
            Shown::Class => {
                let class = &border.classes[k];
                Some(Shows::Class(class.name().clone(), u32::try_from(class.regions()).unwrap_or(u32::MAX)))
            }
            Shown::Regions | Shown::CriticalPoints => {
                let value = |place| segment.coordinate(place, border.enclosure[k]).to_f64().value();
                self.shown([[0, 1, 2].map(value), [3, 4, 5].map(value)])
            }
        };
        [side(0), side(1)]
    }

    fn changes_on(&self, [from, to]: [PlanePoint; 2]) -> Vec<(f64, [Option<Shows>; 2])> {
        let body = |place| {
            let [moments, center] = self.values(place);
            Body::from_f64(moments, center)
        };
        let (Ok(lower), Ok(upper)) = (body(from), body(to)) else { return vec![(0.5, [None, None])] };
        let segment = BodySegment::new(lower, upper);
        let tolerance = self.tolerance[usize::from(from[0] == to[0])];
        let options = BorderOptions { tolerance, ..BorderOptions::default() };
        let borders = border::all(&segment, &options);
        if borders.is_empty() {
            // An end that nothing is known of.
            let ends = [from, to].map(|place| self.shown(self.values(place)));
            return vec![(0.5, ends)];
        }
        let change = |border: &Border| (border.t, self.beside(&segment, border));
        borders.iter().map(change).filter(|(_, [before, after])| before != after).collect()
    }
}

impl LabelledPlane for Bodies {
    type Label = Option<Shows>;

    fn labels(&self, places: &[PlanePoint]) -> Vec<Self::Label> {
        places.par_iter().map(|place| self.shown(self.values(*place))).collect()
    }

    fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Vec<(f64, [Self::Label; 2])>> {
        ways.par_iter().map(|way| self.changes_on(*way)).collect()
    }
}
