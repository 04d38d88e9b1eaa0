//! All steady axes over the spin as a document.

use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, Place, SteadyFamily, SteadyStretch};
use bifdiag_equilibria::nonlinear::VerdictChange;
use bifdiag_schema::{
    AxisCountDocument, NonlinearVerdict, PermanentAxisDocument, Reason, SteadyFamilyDocument, SteadyPlaceDocument,
    SteadySpinsDocument, SteadyStretchDocument,
};

use crate::body::{given, head};
use crate::critical::stable;
use crate::spin::spin;
use crate::stability::isolated_spins;
use crate::subject::Subject;

/// The families of steady axes of a body, and what was found of those that are permanent.
#[must_use]
pub fn steady_spins(
    subject: &Subject,
    families: &[SteadyFamily],
    permanent: Vec<PermanentAxisDocument>,
    note: Option<String>,
    exceptions: Option<&[(Equilibrium, VerdictChange)]>,
) -> SteadySpinsDocument {
    SteadySpinsDocument {
        head: head(subject.command("critical-spin").json()),
        body: given(&subject.body),
        permanent,
        families: families.iter().map(|found| family(subject, found, exceptions)).collect(),
        counts: counts(families, subject.second()),
        note,
        part: subject.part.clone(),
    }
}

/// Families of steady axes.
#[must_use]
pub fn steady_families(
    subject: &Subject,
    families: &[&SteadyFamily],
    exceptions: Option<&[(Equilibrium, VerdictChange)]>,
) -> Vec<SteadyFamilyDocument> {
    families.iter().map(|found| family(subject, found, exceptions)).collect()
}

/// γ points down.
fn up(subject: &Subject, gamma: [f64; 3]) -> [f64; 3] {
    subject.to_given(gamma.map(|x| 0.0 - x))
}

fn family(
    subject: &Subject,
    found: &SteadyFamily,
    exceptions: Option<&[(Equilibrium, VerdictChange)]>,
) -> SteadyFamilyDocument {
    let own: Option<Vec<(Equilibrium, VerdictChange)>> =
        exceptions.map(|list| list.iter().filter(|(point, _)| found.holds(&subject.body, point)).cloned().collect());
    let ends: Vec<f64> = found.stretches.iter().map(|stretch| stretch.from.map_or(0.0, |place| place.omega)).collect();
    let stretches = found.stretches.iter().enumerate().map(|(number, one)| {
        let until = ends.get(number + 1).copied().unwrap_or(f64::INFINITY);
        stretch(subject, one, [ends[number], until], own.as_deref())
    });
    SteadyFamilyDocument {
        branch: found.branch.to_string(),
        branch_name: found.branch_name.to_string(),
        start: found.start,
        axes: found.axes,
        permanent: found.is_permanent,
        slow_axis: found.slow.map(|gamma| up(subject, gamma)),
        fast_axis: up(subject, found.fast),
        stretches: stretches.collect(),
    }
}

fn stretch(
    subject: &Subject,
    found: &SteadyStretch,
    [from, to]: [f64; 2],
    exceptions: Option<&[(Equilibrium, VerdictChange)]>,
) -> SteadyStretchDocument {
    let by_normal_form = found.verdict.is_none();
    let verdict = if by_normal_form && exceptions.is_some() {
        Some((NonlinearVerdict::Stable, Reason::Arnold))
    } else {
        found.verdict
    };
    let inside = |point: &Equilibrium| by_normal_form && from < point.omega.abs() && point.omega.abs() < to;
    let place = |place: &Place| SteadyPlaceDocument {
        spin: spin(place.omega * subject.second()),
        error_bound: place.error_bound * subject.second(),
        axis: up(subject, place.gamma),
        l: place.l,
        h: place.h,
    };
    SteadyStretchDocument {
        from: found.from.as_ref().map(place),
        change: found.change,
        stability: found.kind.term(),
        stable: stable(verdict, found.kind),
        isolated: exceptions.map(|list| isolated_spins(list, subject.second(), inside)),
    }
}

/// How many steady axes there are by rising spin; starts closer than their error bounds are one.
fn counts(families: &[SteadyFamily], second: f64) -> Vec<AxisCountDocument> {
    let mut starts: Vec<(Option<Place>, Multiplicity)> =
        families.iter().map(|family| (family.stretches.first().and_then(|first| first.from), family.axes)).collect();
    let omega = |place: &Option<Place>| place.map_or(0.0, |place| place.omega);
    starts.sort_by(|(p, _), (q, _)| omega(p).total_cmp(&omega(q)));
    let mut counts: Vec<AxisCountDocument> = Vec::new();
    let mut reached = f64::NEG_INFINITY;
    for (from, axes) in starts {
        let error = from.map_or(0.0, |place| place.error_bound);
        if omega(&from) - error > reached {
            let before = counts.last().map_or([0, 0], |last| [last.axes, last.circles]);
            let from = from.map(|place| spin(place.omega * second));
            counts.push(AxisCountDocument { from, axes: before[0], circles: before[1] });
        }
        reached = omega(&from) + error;
        let Some(last) = counts.last_mut() else { continue };
        match axes {
            Multiplicity::Points(count) => last.axes += count,
            Multiplicity::Circle | Multiplicity::Sphere => last.circles += 1,
        }
    }
    counts
}
