//! Steady rotations: about a principal axis at every spin, about others at the spin that is asked about.

use documents::{Subject, words};
use numbers::Sign;
use part::Spin;
use schema::{SpinChangeDocument, SteadyDocument, Verdict};
use top::atlas::{Atlas, Place};
use top::body::BodyAxis;
use top::permanent::nearest_steady;

use super::direction::{from_principal, second, to_principal};
use super::rotation::{Axis, MEANT, rotation};
use crate::cli::terminal::{Report, significant};

/// The steady rotation at a spin in rad/s with its axis nearest to `up`, in the frame of the question.
pub fn at_spin(subject: &Subject, up: [f64; 3], spin: f64, atlas: Option<&Atlas>) -> Option<SteadyDocument> {
    match Axis::of(subject, up) {
        Axis::Permanent { axis, sign, .. } => about_axis(subject, axis, sign, spin, atlas),
        Axis::Other { .. } => elsewhere(subject, up, spin, atlas),
    }
}

/// The region of a point that lies clearly inside one.
pub fn region_at(atlas: &Atlas, h: f64, l: f64) -> Option<String> {
    match atlas.locate(h, l).ok()?.place {
        Place::Region(region) => Some(region.to_string()),
        Place::Forbidden | Place::Undecided(_) => None,
    }
}

/// The regions just below and just above.
fn beside(atlas: Option<&Atlas>, h: f64, l: f64, omega: f64) -> [Option<String>; 2] {
    let step = 1e-9 * (h.abs() + 0.5 * (l * omega).abs());
    [h - step, h + step].map(|h| atlas.and_then(|atlas| region_at(atlas, h, l)))
}

/// Rotation about a principal axis through the centre of mass, answered along its curve.
fn about_axis(
    subject: &Subject,
    axis: BodyAxis,
    sign: Sign,
    spin: f64,
    atlas: Option<&Atlas>,
) -> Option<SteadyDocument> {
    let second = second(subject.part.as_ref());
    let rotation = rotation(subject, axis, sign)?;
    let omega = spin / second;
    let found = rotation.type_at_spin(omega)?;
    let (frequencies, growth) = rotation.squared_eigenvalues(omega).frequencies_and_growth();
    let changes =
        documents::spin_changes(&rotation, if sign == Sign::Positive { "+axis" } else { "-axis" }, atlas, second);
    let (h, l) = (rotation.h(omega), rotation.l(omega));
    let up = BodyAxis::ALL.map(|k| if k == axis { f64::from(sign) } else { 0.0 });
    Some(SteadyDocument {
        axis: from_principal(subject.part.as_ref(), up),
        angle_deg: 0.0,
        h,
        l,
        stability: found.name().to_owned(),
        stable: found.is_stable(),
        verdict: documents::verdict(rotation.verdict(found)),
        frequencies_hz: frequencies.map(|frequency| Spin::hertz(frequency * second)),
        growth_time_s: (!found.is_stable()).then(|| 1.0 / (growth * second)),
        below: changes.iter().rev().find(|change| change.spin.rad_per_s < spin).cloned(),
        above: changes.iter().find(|change| change.spin.rad_per_s > spin).cloned(),
        regions: beside(atlas, h, l, omega),
    })
}

/// Rotation about an axis of Staude's cone, which is permanent at this spin.
fn elsewhere(subject: &Subject, up: [f64; 3], spin: f64, atlas: Option<&Atlas>) -> Option<SteadyDocument> {
    let part = subject.part.as_ref();
    let second = second(part);
    let omega = spin / second;
    let found = nearest_steady(&subject.body, omega, to_principal(part, up))?;
    let point = &found.equilibrium;
    let growth = point.eigenvalues.pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max);
    Some(SteadyDocument {
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
        regions: beside(atlas, point.h, found.l, omega),
    })
}

/// Its stability in words.
pub fn told(report: &mut Report, steady: &SteadyDocument) {
    let how = match steady.verdict {
        Verdict::Unstable => "unstable".to_owned(),
        Verdict::Spectrum => "spectrally stable, of which nothing more is known".to_owned(),
        Verdict::Open => "its stability is not decided by the linear terms".to_owned(),
        Verdict::Energy | Verdict::Integral => format!("stable {}", words::verdict(steady.verdict)),
    };
    report.line(format!("steady rotation, {how}: {}", steady.stability));
    let frequencies = steady.frequencies_hz.map(|frequency| significant(frequency, 6)).join(" Hz, ");
    report.line(format!("frequencies of small oscillations, seen from the turning body: {frequencies} Hz"));
    if let Some(time) = steady.growth_time_s {
        report.line(format!("a deviation grows by e in {} s", significant(time, 4)));
    }
    let [below, above] = steady.regions.each_ref().map(|region| region.as_deref().unwrap_or("none"));
    report.line(format!("regions beside it: {below} below, {above} above in h"));
}

/// The changes at the next smaller and larger spins, which are known for a principal axis.
pub fn changes(report: &mut Report, steady: &SteadyDocument) {
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
        None => format!("no change at any {name} spin"),
    };
    report.line(change("smaller", &steady.below));
    report.line(change("larger", &steady.above));
}
