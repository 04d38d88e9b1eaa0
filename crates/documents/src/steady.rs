//! All steady axes over the spin as a document.

use bifdiag_equilibria::critical::{AxisCount, FamilyPoint, SteadyFamily, SteadyStretch, axis_counts};
use bifdiag_equilibria::curves::BranchName;
use bifdiag_equilibria::nonlinear::VerdictChange;
use bifdiag_equilibria::permanent::PermanentAxis;
use bifdiag_exact::{AllSpins, EndUp};
use bifdiag_schema::{
    AxisCountDocument, PermanentAxisDocument, SteadyFamilyDocument, SteadyPlaceDocument, SteadySpinsDocument,
    SteadyStretchDocument,
};

use crate::body::{given, head};
use crate::critical::stable;
use crate::spin_change::{NO_REGIONS, changes, spin};
use crate::stability::isolated_spin;
use crate::subject::Subject;

/// The families of steady axes of a body, and what changes about those that are permanent.
#[must_use]
pub fn steady_spins(subject: &Subject, found: &AllSpins) -> SteadySpinsDocument {
    let second = subject.second();
    let permanent = |(axis, ends): &(PermanentAxis, [EndUp; 2])| PermanentAxisDocument {
        axis: subject.to_given(axis.direction),
        slow: ends.each_ref().map(EndUp::slowest),
        changes: changes(ends, second),
    };
    let count = |count: AxisCount| AxisCountDocument {
        from: count.from.map(|omega| spin(omega * second)),
        axes: count.axes,
        circles: count.circles,
    };
    SteadySpinsDocument {
        head: head(subject.command("critical-spin").json()),
        body: given(&subject.body),
        permanent: found.permanent.iter().map(permanent).collect(),
        families: steady_families(subject, found.families.iter(), found.exceptions.as_deref()),
        counts: axis_counts(&found.families).into_iter().map(count).collect(),
        note: (!found.permanent.is_empty() && !found.has_regions).then(|| NO_REGIONS.to_owned()),
        part: subject.part.clone(),
    }
}

/// Families of steady axes.
pub(crate) fn steady_families<'a>(
    subject: &Subject,
    families: impl Iterator<Item = &'a SteadyFamily>,
    exceptions: Option<&[(BranchName, VerdictChange)]>,
) -> Vec<SteadyFamilyDocument> {
    families.map(|found| family(subject, found, exceptions)).collect()
}

/// γ points down.
fn up(subject: &Subject, gamma: [f64; 3]) -> [f64; 3] {
    subject.to_given(gamma.map(|x| 0.0 - x))
}

fn family(
    subject: &Subject,
    found: &SteadyFamily,
    exceptions: Option<&[(BranchName, VerdictChange)]>,
) -> SteadyFamilyDocument {
    let isolated = exceptions.map(|list| found.isolated(&subject.body, list));
    let stretches = found.stretches.iter().enumerate().map(|(number, one)| {
        let isolated = isolated.as_ref().map(|lists| &lists[number][..]);
        stretch(subject, one, isolated)
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

fn stretch(subject: &Subject, found: &SteadyStretch, isolated: Option<&[&VerdictChange]>) -> SteadyStretchDocument {
    let place = |place: &FamilyPoint| SteadyPlaceDocument {
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
        stable: stable(found.verdict_with(isolated.is_some()), found.kind),
        isolated: isolated.map(|list| list.iter().map(|one| isolated_spin(one, subject.second())).collect()),
    }
}
