//! Roots of smooth functions along the branch.

use super::branch::{Branch, Point, Tangent};
use super::report::Effort;

/// Share of the golden section.
pub(super) const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// An end of a bracket: a step, and the function there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bracket {
    pub step: f64,
    pub value: f64,
}

impl Branch<'_> {
    /// The point between two steps along `tangent` where `value` vanishes, and its step.
    ///
    /// `last` is the point at the second end. Secant steps with the Illinois weights, so that both ends of the bracket move; ends when it is as narrow as
    /// rounding. `None` if the corrector fails inside the bracket.
    pub fn locate(
        &self,
        base: &Point,
        tangent: &Tangent,
        ends: [Bracket; 2],
        last: Point,
        value: impl Fn(&Point) -> f64,
        effort: &mut Effort,
    ) -> Option<Point> {
        let [mut low, mut high] = ends;
        let width = (high.step - low.step).abs();
        let mut best = last;
        let mut best_value = high.value;
        let mut last_side = 0;
        for iteration in 0..100 {
            let mut step = low.step + (high.step - low.step) * (low.value / (low.value - high.value));
            // Every fourth step halves the bracket: the worst case is that of bisection.
            if iteration % 4 == 3 || step.is_nan() {
                step = 0.5 * (low.step + high.step);
            }
            if step == low.step || step == high.step || (high.step - low.step).abs() <= 1e-15 * width {
                break;
            }
            let point = self.advance(base, tangent, step, effort)?;
            let here = value(&point);
            if here.abs() <= best_value.abs() {
                best = point;
                best_value = here;
            }
            if here == 0.0 {
                break;
            }
            if (here > 0.0) == (high.value > 0.0) {
                high = Bracket { step, value: here };
                if last_side == 1 {
                    low.value *= 0.5;
                }
                last_side = 1;
            } else {
                low = Bracket { step, value: here };
                if last_side == -1 {
                    high.value *= 0.5;
                }
                last_side = -1;
            }
        }
        Some(best)
    }
}
