//! Steady rotations: about a permanent axis at every spin, about others at the spin that is asked about.

use bifdiag_body::part::Spin;
use bifdiag_diagram::atlas::Spot;
use bifdiag_documents::{Subject, words};
use bifdiag_equilibria::permanent::{
    AxisRotation, PermanentAxis, SteadyRotation, angle_between, nearest_steady, permanent_axis,
};
use bifdiag_exact::Solver;
use bifdiag_numbers::vector::norm;
use bifdiag_numbers::{Number, Sign};
use bifdiag_schema::{Multiplicity, SpinChangeDocument, SteadyDocument, Verdict};
use dashu_ratio::RBig;

use super::axis::{Axis, MEANT};
use crate::cli::terminal::{Report, significant};

/// Distances in h at which the regions beside a curve are looked up, relative to the size of the energies.
const STEPS: [f64; 4] = [1e-9, 1e-12, 1e-15, 1e-18];

/// How many of them are above the rounding of a point that is not exactly on the curve.
const ROUNDED: usize = 2;

/// A permanent axis nearer than this, in radians, to a steady rotation that was found in doubles is its axis.
const SAME: f64 = 1e-12;

/// Which steady rotation is asked for.
pub struct Question<'a> {
    pub subject: &'a Subject,
    /// The axis that points up, in the frame of the question.
    pub vertical: [f64; 3],
    /// The same in principal axes, exact, of any length.
    pub up: [RBig; 3],
    /// The spin in the body's unit of time, exact.
    pub omega: RBig,
}

/// The steady rotation whose axis is nearest to that of the question.
pub fn at_spin(question: &Question<'_>, prepared: &Solver) -> Option<SteadyDocument> {
    let body = &question.subject.body;
    if let Axis::Permanent { axis, .. } = Axis::of(question.subject, question.vertical) {
        return about_axis(question, axis, 0.0, prepared);
    }
    let found = nearest_steady(body, &question.omega, &question.up)?;
    let up = found.gamma.map(|x| 0.0 - x);
    match permanent_axis(body, up).filter(|axis| angle_between(axis.direction, up) <= SAME) {
        Some(axis) => about_axis(question, axis, found.angle, prepared),
        None => Some(steady(question, &found, prepared)),
    }
}

/// Points at which regions are looked up.
struct Place<'a> {
    h: &'a Number,
    l: &'a Number,
    /// The size of the energies.
    size: f64,
    is_exact: bool,
}

/// The regions just below and just above a point of a curve: that curve is still the nearest one there, so that no other
/// lies between.
fn beside(prepared: &Solver, place: &Place<'_>) -> Option<[Spot; 2]> {
    let Place { h, l, size, is_exact } = place;
    let curve = prepared.classify(h, l).ok()?.margin.nearest;
    let near = |step: RBig| {
        let h = Number::from_rational(h.value() + step);
        let found = prepared.classify(&h, l).ok().filter(|found| found.margin.nearest == curve)?;
        Some(prepared.spot(&h, l, &found.answer)).filter(|spot| matches!(spot, Spot::Region(_) | Spot::Forbidden))
    };
    // At rest without weight there is no other energy to compare with.
    let size = if *size > 0.0 { *size } else { 1.0 };
    let steps = if *is_exact { &STEPS[..] } else { &STEPS[..ROUNDED] };
    let region = |side: f64| steps.iter().filter_map(|step| RBig::try_from(side * step * size).ok()).find_map(near);
    Some([region(-1.0)?, region(1.0)?])
}

/// Rotation about an axis that is permanent at every spin, at an angle to that of the question: exact, along its curve.
fn about_axis(question: &Question<'_>, axis: PermanentAxis, angle: f64, prepared: &Solver) -> Option<SteadyDocument> {
    let Question { subject, omega, .. } = question;
    let second = subject.second();
    // γ points down.
    let rotation = AxisRotation::about(&subject.body, axis, Sign::Negative)?;
    let [below, at, above] = bifdiag_documents::changes_beside(&rotation, "+axis", prepared.atlas(), second, omega);
    let Some(judged) = rotation.stability_at_spin(omega) else {
        let up = axis.direction.map(|x| RBig::try_from(x).unwrap_or_default());
        let found = SteadyRotation { angle, ..nearest_steady(&subject.body, omega, &up)? };
        return Some(SteadyDocument { below, at, above, ..steady(question, &found, prepared) });
    };
    let nonlinear = bifdiag_documents::nonlinear(&judged.nonlinear);
    let friction = bifdiag_documents::friction(&judged.friction, &judged.eigenvalues.pairs);
    let (frequencies, growth) = rotation.frequencies_and_growth(omega);
    let (h, l) = rotation.point(omega);
    let size = norm(subject.body.center_f64()) + 0.5 * l.to_f64() * omega.to_f64().value();
    let document = SteadyDocument {
        axis: subject.to_given(axis.direction),
        angle_deg: reported_angle(angle),
        h: h.to_f64(),
        l: l.to_f64(),
        stability: judged.kind.word().to_owned(),
        one_of: one_of(rotation.multiplicity()),
        stable: Verdict::of(&nonlinear, judged.kind.term()),
        nonlinear,
        friction,
        frequencies_hz: by_size(frequencies.map(|frequency| Spin::hertz(frequency * second))),
        growth_time_s: judged.kind.is_unstable().then(|| 1.0 / (growth * second)),
        at,
        below,
        above,
        regions: [None, None],
        note: None,
    };
    Some(with_regions(document, beside(prepared, &Place { h: &h, l: &l, size, is_exact: true })))
}

/// Rotation about another axis, which is permanent at this spin.
fn steady(question: &Question<'_>, found: &SteadyRotation, prepared: &Solver) -> SteadyDocument {
    let Question { subject, omega, .. } = question;
    let second = subject.second();
    let point = &found.equilibrium;
    let growth = point.eigenvalues.pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max);
    let [h, l] = &found.place;
    let nonlinear = bifdiag_documents::nonlinear(&point.nonlinear);
    let document = SteadyDocument {
        axis: subject.to_given(found.gamma.map(|x| 0.0 - x)),
        angle_deg: reported_angle(found.angle),
        h: h.to_f64(),
        l: l.to_f64(),
        stability: point.stability.word().to_owned(),
        one_of: one_of(point.multiplicity),
        stable: Verdict::of(&nonlinear, point.stability.term()),
        nonlinear,
        friction: bifdiag_documents::friction(&point.friction, &point.eigenvalues.pairs),
        frequencies_hz: by_size(point.eigenvalues.pairs.map(|pair| Spin::hertz(pair[1] * second))),
        growth_time_s: (growth > 0.0).then(|| 1.0 / (growth * second)),
        at: None,
        below: None,
        above: None,
        regions: [None, None],
        note: None,
    };
    let size = norm(subject.body.center_f64()) + 0.5 * l.to_f64() * omega.to_f64().value();
    with_regions(document, beside(prepared, &Place { h, l, size, is_exact: found.is_exact }))
}

/// In degrees; 0 where the two axes are meant to be one.
fn reported_angle(angle: f64) -> f64 {
    if angle <= MEANT { 0.0 } else { angle.to_degrees() }
}

fn by_size([p, q]: [f64; 2]) -> [f64; 2] {
    [p.min(q), p.max(q)]
}

/// The set of steady rotations of which this is one.
fn one_of(found: Multiplicity) -> Option<Multiplicity> {
    Some(found).filter(|found| !matches!(found, Multiplicity::Points(_)))
}

fn with_regions(document: SteadyDocument, regions: Option<[Spot; 2]>) -> SteadyDocument {
    let note = regions.is_none().then(|| "the regions beside it are not known".to_owned());
    let id = |spot: &Spot| if let Spot::Region(region) = spot { Some(region.to_string()) } else { None };
    SteadyDocument { regions: regions.map(|regions| regions.each_ref().map(id)).unwrap_or_default(), note, ..document }
}

/// Its stability in words.
pub fn report_steady(report: &mut Report, steady: &SteadyDocument) {
    report.line(format!("steady rotation, {}: {}", words::verdict(&steady.nonlinear), steady.stability));
    report.line(format!("with friction that conserves l: {}", words::with_friction(&steady.friction)));
    match steady.one_of {
        Some(Multiplicity::Circle) => {
            report.line("it is one of a circle of steady rotations, which are judged as a whole");
        }
        Some(Multiplicity::Sphere) if steady.l == 0.0 => {
            report.line("at rest every orientation is an equilibrium; they are judged as a whole");
        }
        Some(Multiplicity::Sphere) => report.line("rotation about every axis is steady"),
        Some(Multiplicity::Points(_)) | None => {}
    }
    if let Some(frequencies) = frequencies(steady) {
        report.line(format!("{frequencies}, seen from the turning body"));
    }
    if let Some(time) = steady.growth_time_s {
        report.line(format!("a deviation grows by the factor e in {} s", significant(time, 4)));
    }
    if let Some(note) = &steady.note {
        report.line(note);
        return;
    }
    let [below, above] = steady.regions.each_ref().map(|region| region.as_deref().unwrap_or("none"));
    report.line(format!("regions beside it: {below} below, {above} above in h"));
}

/// The frequencies in words; none where no pair of eigenvalues has an imaginary part.
fn frequencies(steady: &SteadyDocument) -> Option<String> {
    let hertz = |frequency: f64| format!("{} Hz", significant(frequency, 6));
    let [slow, fast] = steady.frequencies_hz;
    match (slow > 0.0, fast > 0.0) {
        (_, false) => None,
        (false, true) => Some(format!("frequency of small oscillations: {}", hertz(fast))),
        (true, true) if slow < fast => {
            Some(format!("frequencies of small oscillations: {}, {}", hertz(slow), hertz(fast)))
        }
        (true, true) if steady.stable != Verdict::Unstable => {
            Some(format!("frequency of small oscillations: {}, twice", hertz(fast)))
        }
        (true, true) => Some(format!("frequency of oscillations that grow: {}", hertz(fast))),
    }
}

/// The change at this spin and those at the next smaller and larger ones, which are known for a permanent axis; without an
/// atlas those of stability.
pub fn changes(report: &mut Report, steady: &SteadyDocument, atlas: bool) {
    let of_regions = |change: &SpinChangeDocument| change.kind == "region";
    let change = |name: &str, change: &Option<SpinChangeDocument>| match change {
        Some(change) => {
            let what = if of_regions(change) {
                "regions change".to_owned()
            } else {
                format!("{} to {}", change.from, change.to)
            };
            format!(
                "next change at {name} spin: {} rpm = {} rad/s, {what}",
                significant(change.spin.rpm, 8),
                significant(change.spin.rad_per_s, 8)
            )
        }
        None if atlas => format!("no change at any {name} spin"),
        None => format!("no change of stability at any {name} spin; the regions are not known"),
    };
    match &steady.at {
        Some(at) if of_regions(at) => report.line("the regions change at this spin, or within rounding of it"),
        Some(at) => report.line(format!("this spin is a threshold: {} below, {} above", at.from, at.to)),
        None => {}
    }
    report.line(change("smaller", &steady.below));
    report.line(change("larger", &steady.above));
}
