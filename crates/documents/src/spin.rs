//! Rotation about an axis over the spin as a document.

use bifdiag_body::Number;
use bifdiag_equilibria::critical::{SteadyFamily, SteadyStretch};
use bifdiag_equilibria::permanent::{AxisKind, NearestAxis, OneSpin, SpinStretch};
use bifdiag_exact::{AxisSpins, EndUp};
use bifdiag_numbers::decimal::{enumerated, significant};
use bifdiag_schema::{
    AxisEnd, CommandLine, CriticalSpinDocument, FrictionDocument, NearestAxisDocument, NonlinearDocument,
    NonlinearVerdict, Reason, SpinStretchDocument, SpinType, SteadySpinDocument, Verdict,
};
use bifdiag_survey::tolerance::{Tolerances, Tolerated};

use crate::body::{given, head, texts};
use crate::spin_change::{NO_REGIONS, changes, spin};
use crate::stability::{friction, isolated_spin, nonlinear};
use crate::steady::steady_families;
use crate::subject::Subject;
use crate::tolerance::{measured_command, shares_text, tolerance};

/// An angle of this size, in degrees, is the rounding of the axes that it is between.
const ROUNDED: f64 = 1e-12;

/// The axis that is permanent or nearest to one that is, beside the given one.
#[must_use]
pub fn nearest_axis(subject: &Subject, kind: &AxisKind) -> Option<NearestAxisDocument> {
    let near = |axis: [f64; 3], angle: f64, squared_spin: Option<f64>| NearestAxisDocument {
        axis: subject.to_given(axis),
        angle_deg: angle.to_degrees(),
        spin: squared_spin.map(|s| spin(s.abs().sqrt() * subject.second())),
        up: squared_spin.filter(|s| *s != 0.0).map(AxisEnd::of_squared_spin),
    };
    match *kind {
        AxisKind::Permanent { axis, angle } => Some(near(axis.direction, angle, None)),
        AxisKind::AtOneSpin(NearestAxis { axis, angle, squared_spin })
        | AxisKind::Other(NearestAxis { axis, angle, squared_spin }) => Some(near(axis, angle, squared_spin)),
        AxisKind::Principal | AxisKind::Unknown => None,
    }
}

/// What is said of an axis that no steady axis approaches.
pub const NONE_NEAREST: &str =
    "at fast spins all steady axes are perpendicular to the given one, so that none is nearest to it";

/// An axis as it was given, and how well the numbers of the body are known.
#[derive(Clone, Debug)]
pub struct AxisQuestion<'a> {
    /// Of length 1, in the frame of the question.
    pub axis: [f64; 3],
    /// As it was written.
    pub given: &'a [Number; 3],
    /// How well the numbers are known.
    pub tolerances: Tolerances<'a>,
}

impl AxisQuestion<'_> {
    fn command(&self, subject: &Subject) -> CommandLine {
        let axis = texts(self.given).join(",");
        match self.tolerances {
            Tolerances::Measured(part, measured) => {
                measured_command("critical-spin", part, measured).option("axis", axis)
            }
            Tolerances::Shares(shares) => {
                subject.command("critical-spin").option("axis", axis).option("tolerance", shares_text(shares))
            }
            Tolerances::Exact => subject.command("critical-spin").option("axis", axis),
        }
    }
}

/// The spins at which rotation about an axis changes, and what tolerances do to them.
#[must_use]
pub fn critical_spin(
    subject: &Subject,
    question: &AxisQuestion<'_>,
    found: &AxisSpins,
    tolerated: Option<&Tolerated>,
) -> CriticalSpinDocument {
    let second = subject.second();
    let exceptions = found.exceptions.as_deref();
    let slow = match (&found.ends, found.nearest()) {
        (Some(ends), _) => Some(ends.each_ref().map(EndUp::slowest)),
        (None, Some(families)) => families_at_start(families),
        (None, None) => None,
    };
    let stretches = found.ends.iter().flatten().flat_map(|end| {
        end.rotation.stretches(exceptions).into_iter().map(|stretch| spin_stretch(end.end, &stretch, second))
    });
    CriticalSpinDocument {
        head: head(question.command(subject).json()),
        body: given(&subject.body),
        axis: question.axis,
        permanent: matches!(found.kind, AxisKind::Permanent { .. }),
        nearest: nearest_axis(subject, &found.kind).filter(|nearest| nearest.angle_deg > ROUNDED),
        steady: match found.itself {
            AxisKind::AtOneSpin(_) => Some(found.one_spin.iter().map(|one| one_spin(one, second)).collect()),
            AxisKind::Permanent { .. } | AxisKind::Unknown => None,
            AxisKind::Principal | AxisKind::Other(_) => Some(Vec::new()),
        },
        families: steady_families(subject, found.families(), exceptions),
        slow,
        changes: found.ends.as_ref().map(|ends| changes(ends, second)).unwrap_or_default(),
        stretches: stretches.collect(),
        tolerance: tolerated.map(|tolerated| tolerance(question.tolerances, tolerated, second)),
        note: note(subject, question.tolerances, found),
        part: subject.part.clone(),
    }
}

/// The types of two families where they begin.
fn families_at_start(families: [&SteadyFamily; 2]) -> Option<[SpinType; 2]> {
    let [plus, minus] = families.map(|family| family.stretches.first().map(spin_type));
    Some([plus?, minus?])
}

/// The type of a stretch, with whether U_l has a minimum there.
fn spin_type(stretch: &SteadyStretch) -> SpinType {
    let is_minimum = stretch.verdict == Some((NonlinearVerdict::Stable, Reason::Energy));
    match stretch.kind.term().into() {
        SpinType::Elliptic if is_minimum => SpinType::Minimum,
        SpinType::DoubleElliptic if is_minimum => SpinType::DoubleMinimum,
        kind => kind,
    }
}

/// What is not known.
fn note(subject: &Subject, tolerances: Tolerances<'_>, found: &AxisSpins) -> Option<String> {
    if found.ends.is_some() {
        return (!found.has_regions).then(|| NO_REGIONS.to_owned());
    }
    if let (Tolerances::Shares(shares), Some(_)) = (tolerances, found.nearest_isolated())
        && Tolerances::share_of_all(shares).is_none()
    {
        let right = "give one share for all, such as 1%";
        return Some(format!("tolerances by name are for an axis that is permanent at every spin; {right}"));
    }
    let Some([plus, _]) = &found.beside else {
        return Some("the steady rotations that are nearest to it at fast spins could not be found".to_owned());
    };
    if plus.is_empty() {
        let bounds = match tolerances {
            Tolerances::Exact => "",
            Tolerances::Shares(_) | Tolerances::Measured(..) => "; for bounds give another axis",
        };
        return Some(format!("{NONE_NEAREST}{bounds}"));
    }
    if !matches!(tolerances, Tolerances::Exact) && found.nearest().is_some() && found.nearest_isolated().is_none() {
        let axes = fast_axes(subject, plus);
        return Some(format!(
            "no bounds: the steady axis {axes} that is nearest to it at fast spins is one of a circle or sphere of them, and \
            bounds are those of a single one"
        ));
    }
    (plus.len() > 1).then(|| {
        let listed = match tolerances {
            Tolerances::Exact => "all are listed",
            Tolerances::Shares(_) | Tolerances::Measured(..) => {
                "all are listed; for bounds give an axis that is nearer to one of them"
            }
        };
        let axes = fast_axes(subject, plus);
        format!("at fast spins the steady axes {axes} are equally near to the given one: {listed}")
    })
}

/// The axes of families at fast spins, in the frame of the question, as a list.
#[must_use]
pub fn fast_axes(subject: &Subject, families: &[SteadyFamily]) -> String {
    let axis = |family: &SteadyFamily| {
        let axis = subject.to_given(family.fast.map(|x| 0.0 - x));
        format!("({})", axis.map(|x| significant(x, 6)).join(", "))
    };
    let axes: Vec<String> = families.iter().map(axis).collect();
    enumerated(&axes)
}

fn one_spin(found: &OneSpin, second: f64) -> SteadySpinDocument {
    let point = found.equilibrium.as_ref();
    let nonlinear = point.map(|point| nonlinear(&point.nonlinear));
    SteadySpinDocument {
        up: found.end,
        spin: spin(found.omega * second),
        l: found.l,
        h: found.h,
        stability: point.map(|point| point.stability.term()),
        stable: point.zip(nonlinear).map(|(point, nonlinear)| Verdict::of(&nonlinear, point.stability.term())),
        nonlinear,
        friction: point.map(|point| friction(&point.friction, &point.eigenvalues.pairs)),
    }
}

fn spin_stretch(up: AxisEnd, found: &SpinStretch, second: f64) -> SpinStretchDocument {
    let (verdict, why) = found.verdict;
    let end = |omega: Option<f64>| omega.map(|omega| spin(omega * second));
    let isolated = |list: &Vec<_>| list.iter().map(|one| isolated_spin(one, second)).collect();
    SpinStretchDocument {
        up,
        from: end(found.from),
        to: end(found.to),
        stability: found.kind,
        nonlinear: NonlinearDocument::along(verdict, why, found.proved),
        isolated: found.isolated.as_ref().map(isolated),
        friction: FrictionDocument { rates: Vec::new(), ..friction(&found.friction, &[[0.0; 2]; 2]) },
    }
}
