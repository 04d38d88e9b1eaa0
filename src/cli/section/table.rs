//! The points of a section as columns.

use bifdiag_dynamics::section::chaos::ChaosMeasure;
use bifdiag_dynamics::section::{OrbitSection, SectionPoint};
use bifdiag_schema::{ChaosDocument, SectionDocument};

use crate::cli::export::{Column, Columns, Values};

/// One row for each point; `meta` is the document on one line.
pub fn of(
    document: &SectionDocument,
    orbits: &[OrbitSection],
    chaos: &[ChaosMeasure],
) -> Result<Columns, serde_json::Error> {
    let points: Vec<&SectionPoint> = orbits.iter().flat_map(|orbit| &orbit.points).collect();
    Columns::new(columns(&points).into_iter().chain(measures(document, orbits, chaos)), document)
}

/// What each crossing is.
pub fn columns(points: &[&SectionPoint]) -> [(&'static str, Values); 9] {
    let floats = |value: fn(&SectionPoint) -> f64| Values::floats(points.iter().map(|p| value(p)));
    let vectors = |value: fn(&SectionPoint) -> [f64; 3]| Values::vectors(points.iter().map(|p| value(p)));
    // The options allow no more than fit.
    let counts =
        |value: fn(&SectionPoint) -> u32| Values::Int32(points.iter().map(|p| value(p).cast_signed()).collect());
    [
        ("orbit", counts(|p| p.orbit)),
        ("index", counts(|p| p.index)),
        ("time", floats(|p| p.time)),
        ("gamma", vectors(|p| p.gamma)),
        ("l", vectors(|p| p.l)),
        ("sheet", Values::Int8(points.iter().map(|p| p.sheet).collect())),
        ("s_dot", floats(|p| p.s_dot)),
        ("theta", floats(|p| p.theta)),
        ("psi", floats(|p| p.psi)),
    ]
}

/// The points of some columns and of what their times leave out.
pub fn points(columns: &[Column], time_low: &Values) -> Vec<SectionPoint> {
    let [orbit, index, time, gamma, l, sheet, s_dot, theta, psi] = columns else { return Vec::new() };
    let counts = |column: &Column, row: usize| match &column.values {
        Values::Int8(values) => i32::from(values[row]),
        Values::Int32(values) => values[row],
        _ => 0,
    };
    let floats = |values: &Values, row: usize| match values {
        Values::Float { parts, values } => std::array::from_fn(|k| values[row * parts.len() + k.min(parts.len() - 1)]),
        _ => [f64::NAN; 3],
    };
    let point = |row: usize| SectionPoint {
        orbit: counts(orbit, row).cast_unsigned(),
        index: counts(index, row).cast_unsigned(),
        time: floats(&time.values, row)[0],
        time_low: floats(time_low, row)[0],
        gamma: floats(&gamma.values, row),
        l: floats(&l.values, row),
        sheet: i8::try_from(counts(sheet, row)).unwrap_or_default(),
        s_dot: floats(&s_dot.values, row)[0],
        theta: floats(&theta.values, row)[0],
        psi: floats(&psi.values, row)[0],
    };
    (0..time_low.len()).map(point).collect()
}

/// The measures of a point's orbit, if requested, and λ(t); NaN where undefined.
fn measures(
    document: &SectionDocument,
    orbits: &[OrbitSection],
    chaos: &[ChaosMeasure],
) -> Vec<(&'static str, Values)> {
    if chaos.is_empty() {
        return Vec::new();
    }
    let spread = |value: fn(&ChaosDocument) -> Option<f64>| {
        let rows = document.orbits.iter().zip(orbits).flat_map(|(summary, orbit)| {
            let value = summary.chaos.as_ref().and_then(value).unwrap_or(f64::NAN);
            std::iter::repeat_n(value, orbit.points.len())
        });
        Values::floats(rows)
    };
    let running = Values::floats(chaos.iter().flat_map(|measure| measure.running.iter().copied()));
    vec![("lyapunov", spread(lyapunov)), ("rotation", spread(rotation)), ("exponent", running)]
}

/// λ(T).
pub fn lyapunov(chaos: &ChaosDocument) -> Option<f64> {
    chaos.lyapunov.map(|lyapunov| lyapunov.exponent)
}

/// The rotation number.
pub fn rotation(chaos: &ChaosDocument) -> Option<f64> {
    chaos.rotation.map(|rotation| rotation.number)
}
