//! The spins between the changes of a rotation's type, and the verdict on its stability there.

use bifdiag_schema::{NonlinearVerdict, Reason, SpinType};
use dashu_ratio::RBig;

use super::rotation::AxisRotation;
use crate::curves::{BranchName, Pole};
use crate::nonlinear::{Friction, VerdictChange};

/// Spins between two changes of type.
#[derive(Clone, Debug)]
pub struct SpinStretch {
    /// The change below; `None`: rest.
    pub from: Option<f64>,
    /// The change above; `None`: any larger spin.
    pub to: Option<f64>,
    /// The type.
    pub kind: SpinType,
    /// The verdict, but at the isolated spins, with its reason.
    pub verdict: (NonlinearVerdict, Reason),
    /// It follows from eigenvalues, energy and integrals and is proved.
    pub proved: bool,
    /// The isolated rotations inside to which Arnold's theorem does not apply, by rising spin; `None` where not all of them
    /// were found.
    pub isolated: Option<Vec<VerdictChange>>,
    /// What friction leaves of it.
    pub friction: Friction,
}

impl AxisRotation {
    /// The spins between the changes of type, each with the verdict on rotation there: where the normal form decides, Arnold's
    /// theorem but at the isolated spins among the
    /// [`exceptions`](crate::critical::RelativeEquilibria::exceptions) of the body, or where these are not known the verdict at
    /// one spin inside. Left out where no double lies inside.
    #[must_use]
    pub fn stretches(&self, exceptions: Option<&[(BranchName, VerdictChange)]>) -> Vec<SpinStretch> {
        let changes = self.changes();
        let ends = |k: usize| [k.checked_sub(1).map(|k| &changes[k]), changes.get(k)];
        let stretch = |k: usize| {
            let [from, to] = ends(k);
            let expected = from.map(|change| change.to).or(to.map(|change| change.from));
            self.stretch(ends(k).map(|change| change.map(|change| change.omega)), expected, exceptions)
        };
        (0..=changes.len()).filter_map(stretch).collect()
    }

    fn stretch(
        &self,
        [from, to]: [Option<f64>; 2],
        expected: Option<SpinType>,
        exceptions: Option<&[(BranchName, VerdictChange)]>,
    ) -> Option<SpinStretch> {
        /// Spins inside, relative to the ends, or to the one that there is.
        const INSIDE: [f64; 5] = [0.5, 0.41, 0.63, 0.29, 0.77];
        let place = |part: f64| match (from, to) {
            (Some(from), Some(to)) => from + part * (to - from),
            (None, Some(to)) => part * to,
            (Some(from), None) => from / part,
            (None, None) => part,
        };
        let (kind, judged) = INSIDE.into_iter().find_map(|part| {
            let omega = RBig::try_from(place(part)).ok()?;
            let kind = self.type_at_spin(&omega).filter(|kind| expected.is_none_or(|known| known == *kind))?;
            Some((kind, self.stability_at_spin(&omega)?))
        })?;
        let by_normal_form = judged.nonlinear.near.is_some();
        let verdict = match exceptions {
            Some(_) if by_normal_form => (NonlinearVerdict::Stable, Reason::Arnold),
            _ => (judged.nonlinear.verdict, judged.nonlinear.why),
        };
        let pole = if self.weight > RBig::ZERO { Pole::Plus } else { Pole::Minus };
        let is_inside = |(branch, change): &&(BranchName, VerdictChange)| {
            by_normal_form
                && *branch == BranchName::Axis(pole)
                && from.is_none_or(|from| from < change.omega)
                && to.is_none_or(|to| change.omega < to)
        };
        let isolated = exceptions.map(|list| {
            let mut inside: Vec<VerdictChange> = list.iter().filter(is_inside).map(|(_, change)| *change).collect();
            inside.sort_by(|p, q| p.omega.total_cmp(&q.omega));
            inside
        });
        // `verify` does not check what follows from the normal form.
        let proved = judged.nonlinear.proved && !by_normal_form;
        let kind = self.own(kind);
        Some(SpinStretch { from, to, kind, verdict, proved, isolated, friction: judged.friction })
    }
}
