//! `bifdiag campbell`: frequencies over the spin of a permanent axis.

use numbers::Sign;
use plot::{Campbell, draw_campbell};
use top::permanent::{AxisRotation, SpinType};

use super::arguments::CampbellArguments;
use super::direction::second;
use super::error::StateInput;
use super::rotation::Axis;
use crate::cli::export::{Column, Columns, DataFormat, ExportError, FileSet, PictureFormat, RESOLUTION, Values};
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, Timings, print, significant};

/// Spins in the table.
const STEPS: u32 = 400;

pub fn run(arguments: &CampbellArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let axis = match Axis::of(&subject, arguments.axis.0) {
        Axis::Permanent { axis, .. } => axis,
        Axis::Other { nearest } => {
            let axis = nearest.axis.map(|x| significant(x, 6)).join(", ");
            return Err(StateInput::NotPermanent { axis, angle: significant(nearest.angle_deg, 3) }.into());
        }
        Axis::AtOneSpin { .. } | Axis::Principal | Axis::Unknown => return Err(StateInput::NotAtEverySpin.into()),
    };
    // γ points down.
    let Some(rotation) = AxisRotation::about(&subject.body, axis, Sign::Negative) else {
        return Err(StateInput::NotAtEverySpin.into());
    };
    let second = second(subject.part.as_ref());
    let largest = arguments.to.rad_per_s().abs();
    let rows = rows(&rotation, largest, second);
    let mut files = FileSet::new(&arguments.out);
    files.export("campbell", &columns(&rows), &DataFormat::Csv)?;
    let changes = documents::spin_changes(&rotation, "+axis", None, second);
    if !arguments.no_plot {
        let scene = Campbell {
            rows: rows.iter().map(|row| (row.rpm, row.frequencies, row.stable)).collect(),
            changes: changes
                .iter()
                .map(|change| change.spin.rpm)
                .filter(|rpm| *rpm <= part::Spin::rpm(largest))
                .collect(),
        };
        let picture = draw_campbell(&scene, plot::Theme::Light).map_err(ExportError::from)?;
        files.pictures("campbell", &picture, &[PictureFormat::Svg], RESOLUTION, timings)?;
    }
    let mut report = Report::default();
    for change in &changes {
        report.line(format!("{} rpm: {} to {}", significant(change.spin.rpm, 8), change.from, change.to));
    }
    report.written(&files.write()?);
    Ok(print(report.text())?)
}

/// Frequencies at one spin.
struct Row {
    rpm: f64,
    frequencies: [f64; 2],
    growth: f64,
    stable: bool,
}

fn rows(rotation: &AxisRotation, largest: f64, second: f64) -> Vec<Row> {
    let row = |k: u32| {
        let spin = largest * f64::from(k) / f64::from(STEPS);
        let (frequencies, growth) = rotation.squared_eigenvalues(spin / second).frequencies_and_growth();
        let [p, q] = frequencies.map(|frequency| part::Spin::hertz(frequency * second));
        let stable = rotation.type_at_spin(spin / second).is_some_and(SpinType::is_stable);
        Row {
            rpm: part::Spin::rpm(spin),
            frequencies: [p.min(q), p.max(q)],
            growth: if stable { 0.0 } else { growth * second },
            stable,
        }
    };
    (1..=STEPS).map(row).collect()
}

fn columns(rows: &[Row]) -> Columns {
    let floats = |value: fn(&Row) -> f64| Values::floats(rows.iter().map(value));
    let columns = [
        ("spin_rpm", floats(|row| row.rpm)),
        ("frequency1_hz", floats(|row| row.frequencies[0])),
        ("frequency2_hz", floats(|row| row.frequencies[1])),
        ("growth_per_s", floats(|row| row.growth)),
        ("stable", Values::Int8(rows.iter().map(|row| i8::from(row.stable)).collect())),
    ];
    let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
    Columns { columns, meta: String::new() }
}
