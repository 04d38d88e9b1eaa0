//! From a point close to the section onto it.

use super::condition::SectionCondition;
use crate::field::{HeavyTop, State, add, scale};

/// Moves a state that is close to the section, where S = `residual`, onto it along the flow: the time that this
/// takes and the state there.
///
/// The polynomial's root is as good as the step's tolerance; Newton's method in time with the flow's own series
/// brings |S| down to rounding. Near a tangency it stops where it no longer improves.
#[inline(never)]
pub(super) fn polished(top: &HeavyTop, condition: SectionCondition, state: &State, mut residual: f64) -> (f64, State) {
    let (mut offset, mut best) = (0.0, *state);
    for _ in 0..4 {
        let t = -residual / condition.rate(top, &best);
        if t.is_nan() {
            break;
        }
        let mut next = State::default();
        for x in top.taylor_coefficients(&best, 4).iter().rev() {
            next.gamma = add(scale(t, next.gamma), x.gamma);
            next.l = add(scale(t, next.l), x.l);
        }
        let value = condition.value(top, &next);
        if value.is_nan() || value.abs() >= residual.abs() {
            break;
        }
        (offset, best, residual) = (offset + t, next, value);
    }
    (offset, best)
}
