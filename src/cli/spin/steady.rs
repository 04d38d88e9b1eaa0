//! Steady rotations: about a permanent axis at every spin, about others at the spin that is asked about.

use dashu_ratio::RBig;
use documents::Subject;
use numbers::vector::norm;
use numbers::{Number, Sign};
use part::Spin;
use proof::Prepared;
use schema::{SpinChangeDocument, SteadyDocument, Verdict};
use top::atlas::Spot;
use top::permanent::{AxisRotation, PermanentAxis, nearest_steady};

use super::direction::{from_principal, second, to_principal};
use super::rotation::{Axis, MEANT};
use crate::cli::terminal::{Report, significant};

/// Distances in h at which the regions beside a curve are looked up, relative to the size of the energies.
const STEPS: [f64; 4] = [1e-9, 1e-12, 1e-15, 1e-18];

/// The steady rotation at a spin in rad/s with its axis nearest to `up`, in the frame of the question.
pub fn at_spin(subject: &Subject, up: [f64; 3], spin: f64, prepared: &Prepared) -> Option<SteadyDocument> {
    match Axis::of(subject, up) {
        Axis::Permanent { axis, .. } => about_axis(subject, axis, spin, prepared),
        _ => elsewhere(subject, up, spin, prepared),
    }
}

/// The regions just below and just above a point of a curve: that curve is still the nearest one there, so that no other
/// lies between.
fn beside(prepared: &Prepared, h: &Number, l: &Number, size: f64) -> Option<[Spot; 2]> {
    let curve = prepared.classify(h, l).ok()?.margin.nearest;
    let near = |step: RBig| {
        let h = Number::from_rational(h.value() + step);
        let found = prepared.classify(&h, l).ok().filter(|found| found.margin.nearest == curve)?;
        Some(prepared.spot(&h, l, &found.answer)).filter(|spot| matches!(spot, Spot::Region(_) | Spot::Forbidden))
    };
    let region = |side: f64| STEPS.iter().filter_map(|step| RBig::try_from(side * step * size).ok()).find_map(near);
    Some([region(-1.0)?, region(1.0)?])
}

/// Rotation about an axis that is permanent at every spin, answered along its curve.
fn about_axis(subject: &Subject, axis: PermanentAxis, spin: f64, prepared: &Prepared) -> Option<SteadyDocument> {
    let second = second(subject.part.as_ref());
    // γ points down.
    let rotation = AxisRotation::about(&subject.body, axis, Sign::Negative)?;
    let omega = spin / second;
    let changes = documents::spin_changes(&rotation, "+axis", prepared.atlas(), second);
    let mut steady = elsewhere(subject, from_principal(subject.part.as_ref(), axis.direction), spin, prepared);
    if omega != 0.0 {
        let change = rotation.changes().into_iter().find(|change| (change.omega - omega).abs() <= change.error_bound);
        let (stability, verdict) = if let Some(change) = change {
            change.between()
        } else {
            (rotation.type_at_spin(omega)?.name(), rotation.verdict_at_spin(omega)?)
        };
        let verdict = documents::verdict(verdict);
        let (frequencies, growth) = rotation.squared_eigenvalues(omega).frequencies_and_growth();
        let unstable = verdict == Verdict::Unstable;
        let (h, l) = rotation.point(omega)?;
        let size = norm(subject.body.center_f64()) + 0.5 * rotation.l(omega).abs() * omega;
        let document = SteadyDocument {
            axis: from_principal(subject.part.as_ref(), axis.direction),
            angle_deg: 0.0,
            h: rotation.h(omega),
            l: rotation.l(omega),
            stability: stability.to_owned(),
            stable: !unstable,
            verdict,
            frequencies_hz: frequencies.map(|frequency| Spin::hertz(frequency * second)),
            growth_time_s: unstable.then(|| 1.0 / (growth * second)),
            below: None,
            above: None,
            regions: [None, None],
            note: None,
        };
        steady = Some(with_regions(document, beside(prepared, &h, &l, size)));
    }
    let steady = steady?;
    Some(SteadyDocument {
        below: changes.iter().rev().find(|change| change.spin.rad_per_s < spin).cloned(),
        above: changes.into_iter().find(|change| change.spin.rad_per_s > spin),
        ..steady
    })
}

/// Rotation about another axis, which is permanent at this spin.
fn elsewhere(subject: &Subject, up: [f64; 3], spin: f64, prepared: &Prepared) -> Option<SteadyDocument> {
    let part = subject.part.as_ref();
    let second = second(part);
    let omega = spin / second;
    let found = nearest_steady(&subject.body, omega, to_principal(part, up))?;
    let point = &found.equilibrium;
    let growth = point.eigenvalues.pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max);
    let document = SteadyDocument {
        axis: from_principal(part, found.gamma.map(|x| 0.0 - x)),
        angle_deg: if found.angle <= MEANT { 0.0 } else { found.angle.to_degrees() },
        h: point.h,
        l: found.l,
        stability: point.stability.word().to_owned(),
        stable: !point.stability.is_unstable(),
        verdict: documents::verdict(point.verdict),
        frequencies_hz: point.eigenvalues.pairs.map(|pair| Spin::hertz(pair[1] * second)),
        growth_time_s: (growth > 0.0).then(|| 1.0 / (growth * second)),
        below: None,
        above: None,
        regions: [None, None],
        note: None,
    };
    let (h, l) = (Number::from_f64(point.h).ok()?, Number::from_f64(found.l).ok()?);
    let size = norm(subject.body.center_f64()) + 0.5 * (found.l * omega).abs();
    Some(with_regions(document, beside(prepared, &h, &l, size)))
}

fn with_regions(document: SteadyDocument, regions: Option<[Spot; 2]>) -> SteadyDocument {
    let note = regions.is_none().then(|| "the regions beside it are not known".to_owned());
    let id = |spot: &Spot| if let Spot::Region(region) = spot { Some(region.to_string()) } else { None };
    SteadyDocument { regions: regions.map(|regions| regions.each_ref().map(id)).unwrap_or_default(), note, ..document }
}

/// What is known of stability, in words.
pub fn stability_text(verdict: Verdict) -> String {
    match verdict {
        Verdict::Unstable => "unstable".to_owned(),
        Verdict::Spectrum => "spectrally stable, of which nothing more is known".to_owned(),
        Verdict::Open => "its stability is not decided by the linear terms".to_owned(),
        Verdict::Energy | Verdict::Integral => format!("stable {}", verdict.word()),
    }
}

/// Its stability in words.
pub fn told(report: &mut Report, steady: &SteadyDocument) {
    let how = stability_text(steady.verdict);
    report.line(format!("steady rotation, {how}: {}", steady.stability));
    let frequencies = steady.frequencies_hz.map(|frequency| significant(frequency, 6)).join(" Hz, ");
    report.line(format!("frequencies of small oscillations, seen from the turning body: {frequencies} Hz"));
    if let Some(time) = steady.growth_time_s {
        report.line(format!("a deviation grows by e in {} s", significant(time, 4)));
    }
    if let Some(note) = &steady.note {
        report.line(note);
        return;
    }
    let [below, above] = steady.regions.each_ref().map(|region| region.as_deref().unwrap_or("none"));
    report.line(format!("regions beside it: {below} below, {above} above in h"));
}

/// The changes at the next smaller and larger spins, which are known for a permanent axis; without an atlas those of stability.
pub fn changes(report: &mut Report, steady: &SteadyDocument, atlas: bool) {
    let change = |name: &str, change: &Option<SpinChangeDocument>| match change {
        Some(change) => {
            let what = if change.from == change.to {
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
    report.line(change("smaller", &steady.below));
    report.line(change("larger", &steady.above));
}
