//! The isolated relative equilibria at which a hypothesis of Arnold's theorem fails between others to which it applies.

use super::{Equilibrium, RelativeEquilibria};
use crate::curves::{BranchName, CurveName};
use crate::nonlinear::{VerdictChange, Verdicts};
use bifdiag_body::Number;

impl RelativeEquilibria<'_> {
    /// Each of them, with what fails there, by rising l; `None` where not all were found. Elsewhere Arnold's theorem decides
    /// wherever eigenvalues, energy and integrals do not.
    #[must_use]
    pub fn exceptions(&self) -> Option<Vec<(Equilibrium, VerdictChange)>> {
        let verdicts = Verdicts::new(self.body, &self.set);
        if !verdicts.is_complete() {
            return None;
        }
        let inside = verdicts.changes().iter().filter(|change| !change.changes);
        inside.map(|change| Some((self.at_change(change)?, *change))).collect()
    }

    fn at_change(&self, change: &VerdictChange) -> Option<Equilibrium> {
        let branch = BranchName::of(&self.set.frame, self.set.curves[change.curve].branch);
        let on = |found: &Equilibrium| matches!(found.curve, Some(CurveName::Piece { branch: of, .. }) if of == branch);
        let distance = |found: &Equilibrium| (found.h - change.h).abs();
        let list = self.at(&Number::from_f64(change.l).ok()?).ok()?.list;
        list.into_iter().filter(on).min_by(|p, q| distance(p).total_cmp(&distance(q)))
    }
}
