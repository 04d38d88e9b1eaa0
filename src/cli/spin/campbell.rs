//! `bifdiag campbell`: frequencies over the spin of a permanent axis.

use std::path::PathBuf;

use bifdiag_body::part::Spin;
use bifdiag_documents::Subject;
use bifdiag_equilibria::nonlinear::Verdict;
use bifdiag_equilibria::permanent::{AxisRotation, angle_between, permanent_axis};
use bifdiag_numbers::Sign;
use bifdiag_plot::{Campbell, Known, draw_campbell};
use clap::Args;
use dashu_ratio::RBig;

use super::axis::{Axis, AxisArgument, axis, followed_text};
use crate::cli::export::{Column, Columns, DataFormat, FileSet, PictureFormat, Values};
use crate::cli::failure::Failure;
use crate::cli::input::BodyArguments;
use crate::cli::terminal::{Report, Timings, print, significant};

pub const CAMPBELL_EXAMPLES: &str = "\
Examples:
  bifdiag campbell --inertia-com 8e-5,9e-5,1.2e-4,0,0,0 --com 0,0,0.04 \\
      --mass 0.2 --axis z --to \"4000 rpm\"
  bifdiag campbell --A 2,1.1,1 --r 0,0,1 --axis=-z --to \"5 rad/s\" --out campbell";

/// `bifdiag campbell`.
#[derive(Debug, Args)]
pub struct CampbellArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The axis of rotation, pointing up: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: AxisArgument,
    /// The largest spin, with its unit: rpm, Hz, rad/s, deg/s
    #[arg(long, value_name = "\"6000 rpm\"", allow_hyphen_values = true, help_heading = "Rotation")]
    pub to: Spin,
    /// Write campbell.svg and campbell.csv to DIR
    #[arg(long, value_name = "DIR", default_value = "bifdiag-out", help_heading = "Output")]
    pub out: PathBuf,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
}

/// An axis farther than this, in degrees, from the one that is followed is reported.
const TOLD: f64 = 1e-9;

/// Spins in the table.
const STEPS: u32 = 400;

pub fn run(arguments: &CampbellArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let largest = arguments.to.rad_per_s();
    if largest <= 0.0 {
        let right = "the largest spin must be greater than 0, such as \"6000 rpm\"";
        return Err(Failure::input(format!("--to {}: {right}", arguments.to)));
    }
    let Axis::Permanent { axis, nearest } = Axis::followed(&subject, arguments.axis.direction) else {
        return Err(not_permanent(&subject, arguments.axis.direction));
    };
    // γ points down.
    let Some(rotation) = AxisRotation::about(&subject.body, axis, Sign::Negative) else {
        return Err(no_permanent_axis());
    };
    let second = subject.second();
    let rows = rows(&rotation, largest, second);
    if rows.iter().any(|row| row.frequencies.into_iter().chain([row.growth]).any(f64::is_infinite)) {
        let right = "at such a spin the frequencies leave the range of numbers; give a smaller one";
        return Err(Failure::input(format!("--to {}: {right}", arguments.to)));
    }
    let mut files = FileSet::new(&arguments.out);
    files.add("campbell.csv", DataFormat::Csv.bytes(&columns(&rows))?);
    let (changes, beyond): (Vec<_>, Vec<_>) = bifdiag_documents::spin_changes(&rotation, "+axis", None, second)
        .into_iter()
        .partition(|change| change.spin.rad_per_s <= largest);
    if !arguments.no_plot {
        let scene = Campbell {
            rows: rows.iter().map(|row| (row.rpm, row.frequencies, row.known)).collect(),
            changes: changes.iter().map(|change| change.spin.rpm).collect(),
        };
        let picture = draw_campbell(&scene, bifdiag_plot::Theme::Light)?;
        files.pictures("campbell", &picture, &[PictureFormat::Svg], timings)?;
    }
    let mut report = Report::default();
    if nearest.angle_deg > TOLD {
        report.line(followed_text(&nearest));
    }
    for change in &changes {
        report.line(format!("{} rpm: {} to {}", significant(change.spin.rpm, 8), change.from, change.to));
    }
    if changes.is_empty() {
        report.line(format!("no change of type up to {} rpm", significant(Spin::rpm(largest), 8)));
    }
    if let Some(next) = beyond.first() {
        report.line(format!("the next change of type is at {} rpm, beyond --to", significant(next.spin.rpm, 8)));
    }
    report.written(&files.write()?);
    print(report.text())
}

/// Why an axis has no frequencies over the spin.
fn not_permanent(subject: &Subject, given: [f64; 3]) -> Failure {
    match permanent_axis(&subject.body, subject.to_principal(given)) {
        Some(nearest) => {
            let axis = subject.to_given(nearest.direction);
            let angle = significant(angle_between(axis, given).to_degrees(), 3);
            let axis = axis.map(|x| significant(x, 6)).join(", ");
            Failure::input(format!(
                "--axis: rotation about it is not permanent at every spin, so that it has no frequencies over the spin; the \
                 nearest axis that has them is {axis}, {angle}° away"
            ))
        }
        None => no_permanent_axis(),
    }
}

fn no_permanent_axis() -> Failure {
    Failure::input(
        "--axis: rotation about it is not permanent at every spin, nor is that about any other axis of this body: there are no \
         frequencies over the spin; `bifdiag critical-spin` gives the spin at which rotation about an axis is steady, if there \
         is one",
    )
}

/// Frequencies at one spin.
struct Row {
    rpm: f64,
    /// The slower one first; NaN for pairs of eigenvalues that are real or zero.
    frequencies: [f64; 2],
    growth: f64,
    known: Known,
}

fn rows(rotation: &AxisRotation, largest: f64, second: f64) -> Vec<Row> {
    let row = |k: u32| {
        let spin = largest * f64::from(k) / f64::from(STEPS);
        let omega = RBig::try_from(spin / second).unwrap_or_default();
        let (frequencies, growth) = rotation.frequencies_and_growth(&omega);
        let [p, q] = frequencies.map(|frequency| Spin::hertz(frequency * second));
        let judged = rotation.stability_at_spin(&omega);
        let known = judged.map_or(Known::Open, |judged| match judged.nonlinear.verdict {
            Verdict::Stable if judged.friction.survives == Some(true) => Known::Lasting,
            Verdict::Stable => Known::Frictionless,
            Verdict::Open => Known::Open,
            Verdict::Unstable => Known::Unstable,
        });
        let grows = judged.is_none_or(|judged| judged.kind.is_unstable());
        Row {
            rpm: Spin::rpm(spin),
            frequencies: [p.min(q), p.max(q)].map(|frequency| if frequency == 0.0 { f64::NAN } else { frequency }),
            growth: if grows { growth * second } else { 0.0 },
            known,
        }
    };
    (1..=STEPS).map(row).collect()
}

fn columns(rows: &[Row]) -> Columns {
    let flags = |is: fn(&Row) -> bool| Values::Int8(rows.iter().map(|row| i8::from(is(row))).collect());
    let floats = |value: fn(&Row) -> f64| Values::floats(rows.iter().map(value));
    let columns = [
        ("spin_rpm", floats(|row| row.rpm)),
        ("frequency1_hz", floats(|row| row.frequencies[0])),
        ("frequency2_hz", floats(|row| row.frequencies[1])),
        ("growth_per_s", floats(|row| row.growth)),
        ("stable", flags(|row| matches!(row.known, Known::Lasting | Known::Frictionless))),
        ("survives_friction", flags(|row| row.known == Known::Lasting)),
    ];
    let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
    Columns { columns, meta: String::new() }
}
