//! A state as a document.

use bifdiag_body::part::Spin;
use bifdiag_diagram::atlas::Spot;
use bifdiag_equilibria::critical::Multiplicity;
use bifdiag_exact::{State, Steady};
use bifdiag_schema::{AxisEnd, CommandLine, SpinDocument, StateDocument, SteadyDocument, Verdict};

use crate::body::{given, head};
use crate::classification::margin;
use crate::spin_change::change;
use crate::stability::{friction, nonlinear};
use crate::subject::Subject;

/// A state as it was given, in the frame of the question and in seconds.
#[derive(Clone, Debug)]
pub struct StateQuestion {
    /// The options that mean it.
    pub command: CommandLine,
    /// The angular velocity.
    pub omega: [f64; 3],
    /// The direction upward.
    pub vertical: [f64; 3],
    /// The magnitude of the angular velocity.
    pub spin: SpinDocument,
}

/// Where a state lies in the (h, l) plane, and whether it is a steady rotation.
#[must_use]
pub fn state(subject: &Subject, question: StateQuestion, found: &State) -> StateDocument {
    StateDocument {
        head: head(question.command.json()),
        body: given(&subject.body),
        omega: question.omega,
        vertical: question.vertical,
        spin: question.spin,
        h: found.h,
        l: found.l,
        steady: found.steady.as_ref().map(|steady| document(subject, steady)),
        region: found.region.map(|region| region.to_string()),
        margin: found.margin.as_ref().map(margin),
        nearest: found.nearest.as_ref().map(|steady| document(subject, steady)),
        note: found.unknown.map(|unknown| unknown.to_string()),
        part: subject.part.clone(),
    }
}

fn document(subject: &Subject, found: &Steady) -> SteadyDocument {
    let (second, judged) = (subject.second(), &found.judged);
    let nonlinear = nonlinear(&judged.nonlinear);
    let [h, l] = found.place;
    let [below, at, above] =
        found.changes.each_ref().map(|one| one.as_ref().map(|one| change(AxisEnd::Plus, one, second)));
    let id = |spot: &Spot| if let Spot::Region(region) = spot { Some(region.to_string()) } else { None };
    SteadyDocument {
        axis: subject.to_given(found.axis),
        angle_deg: found.angle.to_degrees(),
        h,
        l,
        stability: judged.kind.term(),
        one_of: Some(found.multiplicity).filter(|found| !matches!(found, Multiplicity::Points(_))),
        stable: Verdict::of(&nonlinear, judged.kind.term()),
        nonlinear,
        friction: friction(&judged.friction, &judged.eigenvalues.pairs),
        frequencies_hz: found.frequencies.map(|frequency| Spin::hertz(frequency * second)),
        growth_time_s: found.growth.map(|growth| 1.0 / (growth * second)).filter(|time| time.is_finite()),
        at,
        below,
        above,
        regions: found.beside.as_ref().map(|beside| beside.each_ref().map(id)).unwrap_or_default(),
        note: found.beside.is_none().then(|| "the regions beside it are not known".to_owned()),
    }
}
