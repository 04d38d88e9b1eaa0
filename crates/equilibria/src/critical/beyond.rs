//! The verdict on an exact point, with enclosures as narrow as it needs.

use crate::curves::Branch;
use crate::nonlinear::{Nonlinear, Question, Setting};
use crate::stability::Reduced;
use crate::stability::exact::{ExactPoint, StabilityProfile};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::wide::{Interval128, Interval384, Wide};

/// Bits of the root in intervals of 128, of 384 and of more bits; the others are for what cancels.
const BITS: [usize; 2] = [112, 352];
const WIDE_BITS: [usize; 2] = [1500, 6000];
const SPARE_BITS: usize = 64;

/// A point of a branch.
struct Task<'a> {
    profile: &'a StabilityProfile,
    branch: Branch,
    exact: &'a ExactPoint,
    setting: Setting,
    /// Which of the resonances 1:2 and 1:3 hold.
    resonances: [Option<bool>; 2],
}

impl Task<'_> {
    /// The answer of one precision; `None` if it needs a better one, and there is one.
    fn ask<E: Enclosure>(&self, precision: (E::Precision, usize), is_last: bool) -> Option<Nonlinear> {
        let (c, state) = self.profile.refined::<E>(self.branch, self.exact, precision)?;
        let reduced = Reduced::new(&c, &state);
        let (kind, setting) = (self.exact.kind, self.setting);
        let question = Question { c: &c, state: &state, reduced: &reduced, kind, setting };
        question.verdict(self.resonances).or_else(|| is_last.then(|| question.undecided(self.resonances)))
    }
}

/// The verdict; `None` for a branch without a family.
pub(super) fn verdict(
    profile: &StabilityProfile,
    branch: Branch,
    exact: &ExactPoint,
    setting: Setting,
) -> Option<Nonlinear> {
    if let Some(known) = setting.verdict(exact.kind) {
        return Some(Nonlinear::of(known));
    }
    let task = Task { profile, branch, exact, setting, resonances: profile.resonances(branch, exact)?.map(Some) };
    let wide = |bits, is_last| task.ask::<Wide>((bits + SPARE_BITS, bits), is_last);
    task.ask::<Interval128>(((), BITS[0]), false)
        .or_else(|| task.ask::<Interval384>(((), BITS[1]), false))
        .or_else(|| wide(WIDE_BITS[0], false))
        .or_else(|| wide(WIDE_BITS[1], true))
}
