//! Enclosures of the curvature d²h/dx² of an arc.

use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{Arc, Shape, SymmetricFamily};
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::interval::Interval;

/// Units of roundoff by which computed inputs are widened.
const SLACK: f64 = 32.0;

/// d²h/dx² over a finite range of x inside the arc; `None` where no finite enclosure was found.
///
/// Along the generic family d²h/dx² = −2V/(J x (T J + 4V)); over μ = a_i it is −4R̂/(s³ J³ (a_i + 3R̂/s²)); on a
/// straight line 0 (Lemma 7.3 of docs/mathematics.md).
pub(super) fn curvature(frame: &Frame, arc: &Arc, x: [f64; 2]) -> Option<Interval> {
    let enclosure = match &arc.shape {
        Shape::Straight { .. } => Interval::ZERO,
        Shape::Generic(_) => {
            let (from, to) = (arc.mu(frame, x[0])?, arc.mu(frame, x[1])?);
            // Ends measured from different moments lie on both sides of the middle between these: there the change of
            // base costs one rounding of the larger distance.
            let first = if from.base == to.base { from.delta } else { from.delta + frame.diff[from.base][to.base] };
            generic(frame, to.base, Interval::between(first, to.delta).widened(SLACK))
        }
        Shape::Symmetric { family, .. } => {
            let s = |x: f64| {
                let point = arc.point(frame, x);
                // s J²/2 = x.
                2.0 * x / (point.j * point.j)
            };
            symmetric(frame, family, Interval::between(s(x[0]), s(x[1])).widened(SLACK))
        }
    };
    (enclosure.lo.is_finite() && enclosure.hi.is_finite()).then_some(enclosure)
}

fn generic(frame: &Frame, base: Axis, delta: Interval) -> Interval {
    let active = frame.active();
    let value = Interval::rounded;
    let tau: Vec<Interval> = active.iter().map(|&k| delta + value(frame.diff[base][k])).collect();
    let inverse: Vec<Interval> = tau.iter().map(|t| Interval::ONE / *t).collect();
    let g2: Vec<Interval> =
        active.iter().zip(&inverse).map(|(&k, inverse)| (value(frame.r[k]) * *inverse).square()).collect();
    let zero = Interval::ZERO;
    let p = g2.iter().fold(zero, |sum, g| sum + *g);
    let w: Vec<Interval> = g2.iter().map(|g| *g / p).collect();
    let j = active.iter().zip(&w).fold(zero, |sum, (&k, w)| sum + value(frame.a[k]) * *w);
    let t = w.iter().zip(&inverse).fold(zero, |sum, (w, inverse)| sum + *w * *inverse);
    let mut v = zero;
    for m in 0..active.len() {
        for n in m + 1..active.len() {
            let d = value(frame.diff[active[m]][active[n]]).square();
            v = v + w[m] * w[n] * d * inverse[m] * inverse[n];
        }
    }
    let x = p.sqrt() * j.square() * 0.5;
    -(v * 2.0) / (j * x * (t * j + v * 4.0))
}

fn symmetric(frame: &Frame, family: &SymmetricFamily, s: Interval) -> Interval {
    let r_sum = Interval::point(family.r_sum).widened(8.0);
    let a = Interval::rounded(frame.a[family.axis]);
    let shift = r_sum / s.square();
    let j = a - shift;
    -(r_sum * 4.0) / (s * s.square() * j * j.square() * (a + shift * 3.0))
}
