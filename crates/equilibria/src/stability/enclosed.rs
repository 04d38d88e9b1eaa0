//! A relative equilibrium that f64 found, enclosed: the parameter by Newton's method in intervals, then the rest.

use super::constants::Constants;
use super::state::State;
use crate::curves::Mu;
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// Where a relative equilibrium lies on its family, as f64 found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// On the generic family.
    Generic(Mu),
    /// Over a passive moment, with this s = Ω².
    Over {
        /// The axis of the frame.
        axis: Axis,
        /// Ω².
        s: f64,
        /// R̂ (Theorem 3.3 of docs/mathematics.md).
        r_sum: f64,
    },
    /// Rotation about a principal axis of the frame.
    About {
        /// The axis.
        axis: Axis,
        /// ⟨γ, r⟩: r, −r or, without weight, 0.
        weight: f64,
    },
}

/// Twice the distance to the root that the residual suggests is searched.
const SAFETY: f64 = 2.0;

impl Place {
    /// All that the equilibrium at x = l²/2 can be; `None` where f64 cannot tell it from a neighbour.
    #[must_use]
    pub fn enclosed(self, c: &Constants<Interval>, x: Interval) -> Option<State<Interval>> {
        match self {
            Self::Generic(mu) => {
                let at = State::generic(c, mu.base, &Interval::point(mu.delta));
                let change = logarithm(x, at.x(c))?;
                let reach = SAFETY * change.magnitude() / at.falling(c).magnitude();
                let range = around(mu.delta, reach)?;
                let over = State::generic(c, mu.base, &range);
                let step = change / over.falling(c);
                (step.magnitude() <= reach).then_some(over)
            }
            Self::Over { axis, s, r_sum } => {
                let r_sum = Interval::rounded(r_sum);
                let z = 1.0 / (s * s);
                // −d ln x/dz = (a + 3zR̂)/(2zJ)
                let falling = |at: &State<Interval>, z: Interval| (c.a[axis] + z * r_sum * 3.0) / (z * 2.0 * at.j);
                let point = Interval::point(z);
                let at = State::over(c, axis, &point);
                let change = logarithm(x, at.x(c))?;
                let reach = SAFETY * change.magnitude() / falling(&at, point).magnitude();
                let range = around(z, reach)?;
                let over = State::over(c, axis, &range);
                let step = change / falling(&over, range);
                (step.magnitude() <= reach && over.w[axis].sign() == Some(Sign::Positive)).then_some(over)
            }
            Self::About { axis, weight } => {
                let s = x * 2.0 / c.a[axis].square();
                let shift = if weight == 0.0 { Interval::ZERO } else { Interval::point(weight).widened(3.0) / s };
                Some(State::about(c, axis, &s, &shift))
            }
        }
    }
}

/// The doubles from y − reach to y + reach, if all of them have the sign of y.
fn around(y: f64, reach: f64) -> Option<Interval> {
    let range = Interval::between((y - reach).next_down(), (y + reach).next_up());
    range.is_positive().map(|_| range)
}

/// ln(x/y) of neighbours: with e = (x − y)/y it is e up to e².
fn logarithm(x: Interval, y: Interval) -> Option<Interval> {
    let e = (x - y) / y;
    let size = e.magnitude();
    (size < 1e-3).then(|| e + Interval::between(-size * size, size * size).widened(4.0))
}
