//! `bifdiag campbell`: frequencies over the spin of a steady rotation.

use std::path::PathBuf;

use bifdiag_body::part::Spin;
use bifdiag_diagram::region_changes::rotation_changes;
use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::{CriticalError, Multiplicity, RelativeEquilibria};
use bifdiag_equilibria::nonlinear::NonlinearVerdict;
use bifdiag_equilibria::permanent::{
    AxisKind, AxisRotation, PermanentAxis, angle_between, fastest_along, permanent_axis,
};
use bifdiag_numbers::Sign;
use bifdiag_plot::{Campbell, CampbellRow, Steadiness, draw_campbell};
use clap::Args;

use super::axis::{AxisArgument, angle_text, axis, followed_text, listed, one_of, principal_near};
use super::given::that_can_be_given;
use crate::cli::export::{Column, Columns, DataFormat, FileSet, PictureArguments, PictureFormat, Values};
use crate::cli::failure::{Failure, failed};
use crate::cli::input::BodyArguments;
use crate::cli::terminal::{Report, Timings, all_apart, print, told_apart};

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
    /// Axis of rotation, pointing up: x, y, z or a direction; an axis within 0.5° of it that is permanent at every spin is
    /// used instead. Where there is none, the steady rotation is followed whose axis is nearest to it at fast spins; refused
    /// if that axis is itself permanent
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: AxisArgument,
    /// Largest spin, with its unit: rpm, Hz, rad/s, deg/s
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
const REPORTED: f64 = 1e-9;

/// What is said where there is no answer.
const NOT_FOUND: &str = "the steady rotations could not be found";

/// Spins in the table.
const STEPS: u32 = 400;

/// Digits of a spin.
const DIGITS: usize = 8;

pub fn run(arguments: &CampbellArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    if arguments.to.rad_per_s() <= 0.0 {
        let right = "the largest spin must be greater than 0, such as \"6000 rpm\"";
        return Err(Failure::input(format!("--to {}: {right}", arguments.to)));
    }
    let kind = AxisKind::followed(
        &subject.body,
        subject.to_principal(arguments.axis.direction),
        &arguments.axis.given.values(),
    );
    let followed = match kind {
        AxisKind::Permanent { axis, .. } => permanent(&subject, axis, &kind, &arguments.to)?,
        _ => moving(&subject, &arguments.axis, &arguments.to)?,
    };
    let Followed { rows, beside, crossings, start, changes, notes } = followed;
    if rows.iter().any(|row| row.frequencies.into_iter().chain([row.growth]).any(f64::is_infinite)) {
        let right = "at such a spin the frequencies overflow; give a smaller one";
        return Err(Failure::input(format!("--to {}: {right}", arguments.to)));
    }
    let mut files = FileSet::new(&arguments.out);
    files.add("campbell.csv", DataFormat::Csv.bytes(&columns(&rows))?);
    let top = arguments.to.in_rpm();
    let (changes, beyond): (Vec<_>, Vec<_>) =
        changes.into_iter().partition(|(rpm, ..)| *rpm <= top * (1.0 + 4.0 * f64::EPSILON));
    if !arguments.no_plot {
        let mut drawn = [rows, beside].concat();
        drawn.sort_by(|row, other| row.rpm.total_cmp(&other.rpm));
        let scene =
            Campbell { rows: modes(&drawn, &crossings), changes: changes.iter().map(|(rpm, ..)| *rpm).collect() };
        let picture = draw_campbell(&scene, bifdiag_plot::Theme::Light)?;
        files.pictures("campbell", &picture, &PictureArguments::plain(PictureFormat::Svg), timings)?;
    }
    let mut report = Report::default();
    for line in &notes {
        report.line(line);
    }
    let spins =
        start.into_iter().chain(changes.iter().map(|(rpm, ..)| *rpm)).chain(beyond.first().map(|(rpm, ..)| *rpm));
    let spins = all_apart(&spins.collect::<Vec<_>>(), DIGITS);
    let spins = &spins[usize::from(start.is_some())..];
    for ((_, from, to), rpm) in changes.iter().zip(spins) {
        report.line(format!("{rpm} rpm: {from} to {to}"));
    }
    let next = beyond.first().map_or(f64::INFINITY, |(rpm, ..)| *rpm);
    let [top, next] = told_apart([top, next], DIGITS);
    if changes.is_empty() {
        report.line(format!("no change of linear type up to {top} rpm"));
    }
    if !beyond.is_empty() {
        report.line(format!("the next change of type is at {next} rpm, beyond --to"));
    }
    report.written(&files.write()?);
    print(report.text())
}

/// A steady rotation over the spin.
struct Followed {
    rows: Vec<Row>,
    /// Just below and above each change, where lines of the picture end, and in ranges that are narrow.
    beside: Vec<Row>,
    /// In rpm, where the frequencies of two modes cross.
    crossings: Vec<f64>,
    /// In rpm, where the rotation begins, if it is not permanent.
    start: Option<f64>,
    /// In rpm, with the types below and above.
    changes: Vec<(f64, String, String)>,
    /// What is followed, where it is not the axis as given.
    notes: Vec<String>,
}

/// Rotation about a permanent axis.
fn permanent(subject: &Subject, axis: PermanentAxis, kind: &AxisKind, largest: &Spin) -> Result<Followed, Failure> {
    // γ points down.
    let rotation = AxisRotation::about(&subject.body, axis, Sign::Negative);
    let rotation = rotation.ok_or_else(|| Failure::work(NOT_FOUND))?;
    let second = subject.second();
    let changes = rotation_changes(&rotation, None).into_iter().map(|change| {
        let [from, to] = change.types.map(|kind| kind.word().to_owned());
        (Spin::rpm(change.omega * second), from, to)
    });
    let changes: Vec<_> = changes.collect();
    let nearest = bifdiag_documents::nearest_axis(subject, kind).filter(|nearest| nearest.angle_deg > REPORTED);
    let at = |spin: &Spin| row(&rotation, spin, subject);
    let rows: Vec<Row> = (1..=STEPS).map(|k| at(&largest.part(k, STEPS))).collect();
    let pair = |spin: &Spin| {
        let omega = spin.exact_rad_per_s() * subject.unit_of_time();
        rotation.frequencies_and_growth(&(&omega * &omega)).0
    };
    let at_changes = changes.iter().map(|(rpm, ..)| *rpm);
    Ok(Followed {
        crossings: crossings(&rows, largest, pair),
        rows,
        beside: beside(largest, std::iter::once(0.0).chain(at_changes)).iter().map(at).collect(),
        start: None,
        changes,
        notes: nearest.iter().map(followed_text).collect(),
    })
}

/// The steady rotation that moves with the spin and is nearest to the given axis at fast spins.
fn moving(subject: &Subject, given: &AxisArgument, largest: &Spin) -> Result<Followed, Failure> {
    let prepared = RelativeEquilibria::new(&subject.body).map_err(failed(NOT_FOUND))?;
    let families = prepared.families().ok_or_else(|| Failure::work(NOT_FOUND))?;
    let near = fastest_along(&subject.body, &families, subject.to_principal(given.direction));
    let family = match &near[..] {
        [family] if !family.is_permanent => family,
        [] => {
            return Err(Failure::input(format!(
                "--axis: {}; give an axis that is near to one of them, such as one of {}",
                bifdiag_documents::NONE_NEAREST,
                bifdiag_documents::fast_axes(subject, &families)
            )));
        }
        near if near.iter().all(|family| family.is_permanent) => return Err(not_permanent(subject, given)),
        _ => {
            return Err(Failure::input(format!(
                "--axis: at fast spins the steady axes {} are equally near to it; give an axis that is nearer to one \
                of them",
                bifdiag_documents::fast_axes(subject, &near)
            )));
        }
    };
    let second = subject.second();
    let at = |spin: &Spin| {
        let omega = spin.exact_rad_per_s() * subject.unit_of_time();
        let found = prepared.at_spin(&omega).map_err(|error| no_axes_up_to(subject, largest, error))?;
        Ok::<_, Failure>(found.list.into_iter().find(|point| family.holds(&subject.body, point)))
    };
    let row = |spin: &Spin| {
        let Some(point) = at(spin)? else { return Ok(None) };
        let [[growth, p], [other, q]] = point.eigenvalues.pairs;
        Ok::<_, Failure>(Some(Row {
            rpm: spin.in_rpm(),
            frequencies: frequencies([p, q], second),
            growth: if point.stability.is_unstable() { growth.max(other) * second } else { 0.0 },
            known: known(point.nonlinear.verdict, point.friction.survives),
        }))
    };
    let rows = (1..=STEPS).filter_map(|k| row(&largest.part(k, STEPS)).transpose()).collect::<Result<Vec<_>, _>>()?;
    let rpm = |omega: f64| Spin::rpm(omega * second);
    let start = rpm(family.slowest());
    let pairs = family.stretches.windows(2).filter(|pair| pair[0].kind != pair[1].kind);
    let changes = pairs.filter_map(|pair| {
        Some((rpm(pair[1].from?.omega), pair[0].kind.word().to_owned(), pair[1].kind.word().to_owned()))
    });
    let changes: Vec<(f64, String, String)> = changes.collect();
    let first = changes.first().map_or(f64::INFINITY, |(rpm, ..)| *rpm);
    let circle = if family.axes == Multiplicity::Circle { ", one of a circle of them" } else { "" };
    let note = format!(
        "following the steady rotation that begins at {} rpm and tends to {} at fast spins ({}{circle})",
        told_apart([start, first], DIGITS)[0],
        bifdiag_documents::fast_axes(subject, std::slice::from_ref(family)),
        family.branch
    );
    if rows.is_empty() {
        let [top, start] = told_apart([largest.in_rpm(), start], DIGITS);
        return Err(Failure::input(format!(
            "--to: up to {top} rpm the table has no spin of the rotation that is nearest to this axis at fast spins, which \
            begins at {start} rpm; give a larger spin"
        )));
    }
    let pair = |spin: &Spin| {
        at(spin).ok().flatten().map_or([f64::NAN; 2], |point| point.eigenvalues.pairs.map(|pair| pair[1]))
    };
    let crossings = crossings(&rows, largest, pair);
    let ends = std::iter::once(start).chain(changes.iter().map(|(rpm, ..)| *rpm));
    let beside = beside(largest, ends).iter().filter_map(|spin| row(spin).transpose()).collect::<Result<_, _>>()?;
    Ok(Followed { rows, beside, crossings, start: Some(start), changes, notes: vec![note] })
}

/// The parts of a largest spin beyond f64 have no axes.
fn no_axes_up_to(subject: &Subject, largest: &Spin, error: CriticalError) -> Failure {
    let CriticalError::Spin { smallest, largest: most, .. } = error else { return failed(NOT_FOUND)(error) };
    let [from, to] = [smallest * f64::from(FINE), most].map(|omega| that_can_be_given(subject, omega));
    Failure::input(format!(
        "--to {largest}: parts of it are out of range for this body in f64; give a spin from {from} to {to} rad/s"
    ))
}

/// Why an axis has no frequencies over the spin where the steady axes that are nearest to it are permanent.
fn not_permanent(subject: &Subject, given: &AxisArgument) -> Failure {
    let direction = given.direction;
    let Some(nearest) = permanent_axis(&subject.body, subject.to_principal(direction)) else {
        return Failure::work(NOT_FOUND);
    };
    let axis = subject.to_given(nearest.direction);
    let angle = angle_between(axis, direction).to_degrees();
    let mut near = if subject.body.is_euler() { principal_near(subject, direction, angle) } else { Vec::new() };
    if near.is_empty() {
        near.push(axis);
    }
    let axes: Vec<String> = near
        .iter()
        .map(|axis| {
            let circle = one_of(subject, *axis).map_or("", |_| ", one of a circle of such axes");
            format!("{}{circle}", listed(*axis))
        })
        .collect();
    let are = if axes.len() > 1 { "permanent axes are" } else { "permanent axis is" };
    Failure::input(format!(
        "--axis: rotation about it is steady at {}, and the steady axis that is nearest to it at fast spins is permanent itself; \
        the nearest {are} {}, {}° away",
        steady_at(subject, given),
        axes.join(" and "),
        angle_text(angle)
    ))
}

/// At how many spins rotation about an axis is steady that is not permanent.
fn steady_at(subject: &Subject, given: &AxisArgument) -> &'static str {
    match AxisKind::of(&subject.body, subject.to_principal(given.direction), &given.given.values()) {
        AxisKind::AtOneSpin(axis) => match axis.squared_spin {
            Some(s) if s < 0.0 => "one spin only, with its other end up",
            Some(0.0) => "no spin",
            _ => "one spin only",
        },
        AxisKind::Principal | AxisKind::Other(_) => "no spin",
        // Which of both was not found.
        AxisKind::Permanent { .. } | AxisKind::Unknown => "one spin at most",
    }
}

/// Frequencies at one spin.
#[derive(Clone, Copy)]
struct Row {
    rpm: f64,
    /// The slower one first; NaN for pairs of eigenvalues that are real or zero.
    frequencies: [f64; 2],
    growth: f64,
    known: Steadiness,
}

fn row(rotation: &AxisRotation, spin: &Spin, subject: &Subject) -> Row {
    let second = subject.second();
    let omega = spin.exact_rad_per_s() * subject.unit_of_time();
    let (frequencies, growth) = rotation.frequencies_and_growth(&(&omega * &omega));
    let judged = rotation.stability_at_spin(&omega);
    let known = judged.map_or(Steadiness::Open, |judged| known(judged.nonlinear.verdict, judged.friction.survives));
    let grows = judged.is_none_or(|judged| judged.kind.is_unstable());
    Row {
        rpm: spin.in_rpm(),
        frequencies: self::frequencies(frequencies, second),
        growth: if grows { growth * second } else { 0.0 },
        known,
    }
}

/// Into how many parts the largest spin is cut where one of the table's is too coarse: so fine that a gap which vanishes is less
/// than `CROSSED`.
const FINE: u32 = 1 << 24;

/// Of the ranges that begin at some spins in rpm, which rise, and end at the next or at the largest: the spins just within both
/// ends, and some between the ends of a range that is narrow.
fn beside(largest: &Spin, starts: impl Iterator<Item = f64>) -> Vec<Spin> {
    // Ranges of fewer rows of the table get so many of their own.
    const BETWEEN: u32 = 24;
    let near = f64::from(BETWEEN) / f64::from(STEPS) * f64::from(FINE);
    let starts = starts.map(|rpm| rpm / largest.in_rpm() * f64::from(FINE)).filter(|part| *part < f64::from(FINE));
    let parts: Vec<f64> = starts.chain([f64::from(FINE)]).collect();
    let ends = parts.iter().flat_map(|part| [part.ceil() - 1.0, part.floor() + 1.0]);
    let narrow = parts.windows(2).filter(|ends| ends[1] - ends[0] < near);
    let inside = narrow.flat_map(|ends| {
        (1..BETWEEN).map(|k| (ends[0] + (ends[1] - ends[0]) * f64::from(k) / f64::from(BETWEEN)).round())
    });
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to FINE")]
    let spin = |part: f64| (1.0..=f64::from(FINE)).contains(&part).then(|| largest.part(part as u32, FINE));
    ends.chain(inside).filter_map(spin).collect()
}

/// Frequencies that come so near to each other, in parts of their sum, cross: they do not turn away from each other.
const CROSSED: f64 = 1e-6;

/// The spins in rpm at which the frequencies of a rotation without growth are equal: least gaps between three spins of the table
/// that vanish. `pair` are the frequencies at a spin, in any unit.
fn crossings(rows: &[Row], largest: &Spin, pair: impl Fn(&Spin) -> [f64; 2]) -> Vec<f64> {
    // In parts of their sum.
    let gap = |[p, q]: [f64; 2]| (p - q).abs() / (p + q);
    let top = largest.in_rpm();
    let mut found = Vec::new();
    for three in rows.windows(3).filter(|three| three.iter().all(|row| row.growth == 0.0)) {
        let [before, here, after] = [0, 1, 2].map(|k| gap(three[k].frequencies));
        if !(here <= before && here < after) {
            continue;
        }
        let count = |row: &Row| (row.rpm / top * f64::from(FINE)).round();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to FINE")]
        let [mut low, mut high] = [count(&three[0]) as u32, count(&three[2]) as u32];
        let at = |k: u32| gap(pair(&largest.part(k, FINE)));
        while high - low > 2 {
            let third = (high - low) / 3;
            let [left, right] = [low + third, high - third];
            if at(left) < at(right) { high = right } else { low = left }
        }
        let middle = low + (high - low) / 2;
        if at(middle) < CROSSED {
            found.push(f64::from(middle) / f64::from(FINE) * top);
        }
    }
    found
}

/// The rows with the frequencies of each mode in one place: they change places where they cross.
fn modes(rows: &[Row], crossings: &[f64]) -> Vec<CampbellRow> {
    let row = |row: &Row| {
        let Row { rpm, mut frequencies, growth, known } = *row;
        if crossings.iter().filter(|crossing| **crossing < rpm).count() % 2 == 1 {
            frequencies.swap(0, 1);
        }
        CampbellRow { spin: rpm, frequencies, growth, known }
    };
    rows.iter().map(row).collect()
}

fn known(verdict: NonlinearVerdict, survives_friction: Option<bool>) -> Steadiness {
    match verdict {
        NonlinearVerdict::Stable if survives_friction == Some(true) => Steadiness::Lasting,
        NonlinearVerdict::Stable => Steadiness::Frictionless,
        NonlinearVerdict::Open => Steadiness::Open,
        NonlinearVerdict::Unstable => Steadiness::Unstable,
    }
}

/// In Hz, the slower one first; NaN where nothing oscillates.
fn frequencies(per_unit: [f64; 2], second: f64) -> [f64; 2] {
    let [p, q] = per_unit.map(|frequency| Spin::hertz(frequency * second));
    [p.min(q), p.max(q)].map(|frequency| if frequency == 0.0 { f64::NAN } else { frequency })
}

fn columns(rows: &[Row]) -> Columns {
    let flags = |is: fn(&Row) -> bool| Values::Int8(rows.iter().map(|row| i8::from(is(row))).collect());
    let floats = |value: fn(&Row) -> f64| Values::floats(rows.iter().map(value));
    let columns = [
        ("spin_rpm", floats(|row| row.rpm)),
        ("frequency1_hz", floats(|row| row.frequencies[0])),
        ("frequency2_hz", floats(|row| row.frequencies[1])),
        ("growth_per_s", floats(|row| row.growth)),
        ("stable", flags(|row| matches!(row.known, Steadiness::Lasting | Steadiness::Frictionless))),
        ("survives_friction", flags(|row| row.known == Steadiness::Lasting)),
    ];
    let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
    Columns { columns, meta: String::new() }
}
