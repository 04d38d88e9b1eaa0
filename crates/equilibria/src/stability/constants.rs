//! The numbers of a body that the linearisation needs, in any arithmetic.

use dashu_ratio::RBig;

use bifdiag_body::Frame;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::interval::Interval;

/// A body in the frame's axes and units.
#[derive(Clone, Debug)]
pub struct Constants<E: Arithmetic> {
    /// Principal moments, ascending.
    pub a: [E; 3],
    /// Their inverses.
    pub inverse: [E; 3],
    /// `diff[i][j]` = a_i − a_j.
    pub diff: [[E; 3]; 3],
    /// r_k².
    pub rho: [E; 3],
    /// r_k ≠ 0.
    pub active: [bool; 3],
    /// tr A.
    pub trace: E,
    /// det A.
    pub determinant: E,
    /// The precision of all of them.
    pub precision: E::Precision,
}

impl<E: Arithmetic> Constants<E> {
    fn of(a: [E; 3], diff: [[E; 3]; 3], rho: [E; 3], active: [bool; 3], precision: E::Precision) -> Self {
        let [a1, a2, a3] = a.clone();
        Self {
            inverse: a.clone().map(|a| E::small(1, precision) / a),
            trace: a1.clone() + a2.clone() + a3.clone(),
            determinant: a1 * a2 * a3,
            a,
            diff,
            rho,
            active,
            precision,
        }
    }

    /// From exact moments and squares r_k².
    #[must_use]
    pub fn exact(a: &[RBig; 3], rho: &[RBig; 3], precision: E::Precision) -> Self {
        let number = |x: &RBig| E::rational(x, precision);
        let diff = std::array::from_fn(|i| std::array::from_fn(|j| number(&(&a[i] - &a[j]))));
        Self::of(
            a.each_ref().map(number),
            diff,
            rho.each_ref().map(number),
            rho.each_ref().map(|x| !x.is_zero()),
            precision,
        )
    }

    /// A small whole number.
    pub(super) fn small(&self, value: i32) -> E {
        E::small(value, self.precision)
    }
}

impl Constants<Interval> {
    /// From a frame, whose numbers are rounded.
    #[must_use]
    pub fn rounded(frame: &Frame) -> Self {
        // Square roots in a frame are rounded twice.
        const ROOT: f64 = 3.0;
        let squared = |x: f64| {
            let r = if x == 0.0 { Interval::ZERO } else { Interval::point(x).widened(ROOT) };
            r * r
        };
        let diff = frame.diff.map(|row| row.map(Interval::rounded));
        Self::of(frame.a.map(Interval::rounded), diff, frame.r.map(squared), frame.r.map(|x| x != 0.0), ())
    }
}
