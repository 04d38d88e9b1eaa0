//! A parameter of a branch on the range from 0 to 1, so that roots are looked for on a bounded range everywhere.

use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::equilibria::pieces::{Branch, End, Piece, Pieces};
use crate::equilibria::spaces::Spaces;
use crate::numbers::descartes::moved;
use crate::numbers::sturm::integers;

/// How w from 0 to 1 stands for the parameter t.
#[derive(Clone, Debug)]
pub(crate) enum Chart {
    /// t = a + w/(1−w).
    Above(RBig),
    /// t = a − w/(1−w).
    Below(RBig),
    /// t = a + (b − a) w.
    Between(RBig, RBig),
}

impl Chart {
    /// Of μ on the generic family and on the lines of ±r̂ where r lies on an axis, and of z = 1/s² over a space without r.
    pub fn of(spaces: &Spaces, branch: Branch) -> Option<Self> {
        let ends = match branch {
            Branch::Generic(number) => spaces.interval(number).map(Option::<&RBig>::cloned),
            Branch::Line(plus) => {
                let a = spaces.list[*spaces.active.first()?].a.clone();
                if plus { [Some(a), None] } else { [None, Some(a)] }
            }
            Branch::Over(base) => [Some(RBig::ZERO), Some(RBig::ONE / spaces.sums(base).1)],
            Branch::Rotation(_) => return None,
        };
        match ends {
            [Some(a), Some(b)] => Some(Self::Between(a, b)),
            [Some(a), None] => Some(Self::Above(a)),
            [None, Some(b)] => Some(Self::Below(b)),
            [None, None] => None,
        }
    }

    /// w falls where t rises.
    fn falls(&self) -> bool {
        matches!(self, Self::Below(_))
    }

    /// x rises with w along a curve.
    pub fn rises(&self, piece: &Piece) -> bool {
        // x falls with μ away from the moment on a line; y = 1/z − P̂ falls with z.
        match piece.branch {
            Branch::Line(_) | Branch::Rotation(_) => false,
            Branch::Over(_) => !piece.rising,
            Branch::Generic(_) => piece.rising != self.falls(),
        }
    }

    pub fn parameter(&self, w: &RBig) -> RBig {
        let beyond = || w / (RBig::ONE - w);
        match self {
            Self::Above(a) => a + beyond(),
            Self::Below(a) => a - beyond(),
            Self::Between(a, b) => a + (b - a) * w,
        }
    }

    fn inverse(&self, t: &RBig) -> RBig {
        let finite = |d: RBig| &d / (RBig::ONE + &d);
        match self {
            Self::Above(a) => finite(t - a),
            Self::Below(a) => finite(a - t),
            Self::Between(a, b) => (t - a) / (b - a),
        }
    }

    /// A polynomial in t as one in w, up to a positive factor.
    pub fn moved(&self, polynomial: &[IBig]) -> Vec<IBig> {
        let one = RBig::ONE;
        let (above, below) = match self {
            Self::Above(a) => ([a.clone(), &one - a], [one.clone(), -one]),
            Self::Below(a) => ([a.clone(), -(a + &one)], [one.clone(), -one]),
            Self::Between(a, b) => ([a.clone(), b - a], [one, RBig::ZERO]),
        };
        // One positive factor for both makes them whole.
        let whole = integers(&[&above[..], &below[..]].concat());
        let mut parts = whole.into_iter().chain(std::iter::repeat(IBig::ZERO));
        let mut pair = || [(); 2].map(|()| parts.next().unwrap_or(IBig::ZERO));
        let (above, below) = (pair(), pair());
        moved(polynomial, &above, &below)
    }

    /// The ranges of w that hold the ends of a curve, by rising w.
    pub fn ends(&self, spaces: &Spaces, pieces: &Pieces, piece: &Piece) -> [[RBig; 2]; 2] {
        let mut ends = match piece.branch {
            Branch::Line(_) => piece.ends.map(|end| match end {
                End::Pitchfork(fork) => {
                    let mu = &spaces.list[pieces.forks[fork].base].a;
                    Some([mu.clone(), mu.clone()])
                }
                _ => None,
            }),
            // y rises where z = 1/(P̂ + y) falls.
            Branch::Over(base) => {
                let p_sum = spaces.sums(base).1;
                let z = |y: &RBig| RBig::ONE / (&p_sum + y);
                piece.range.each_ref().map(|range| range.as_ref().map(|[low, high]| [z(high), z(low)]))
            }
            _ => piece.range.clone(),
        }
        .map(|range| range.map(|range| sorted(range.map(|t| self.inverse(&t)))));
        // On the lines by rising x: the first end that is missing lies where x = 0.
        let reversed = match piece.branch {
            Branch::Line(_) | Branch::Over(_) => true,
            _ => self.falls(),
        };
        if reversed {
            ends.reverse();
        }
        let [first, last] = ends;
        let at = |x: RBig| [x.clone(), x];
        [first.unwrap_or_else(|| at(RBig::ZERO)), last.unwrap_or_else(|| at(RBig::ONE))]
    }
}

fn sorted([p, q]: [RBig; 2]) -> [RBig; 2] {
    if p <= q { [p, q] } else { [q, p] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::sturm::sign_at;

    #[test]
    fn charts_move_polynomials_and_back() {
        let n = |n: i32, d: u32| RBig::from_parts(n.into(), d.into());
        let p: Vec<IBig> = [-7, 3, 0, 5].map(IBig::from).to_vec();
        for chart in [Chart::Above(n(-5, 3)), Chart::Below(n(2, 7)), Chart::Between(n(-1, 2), n(9, 4))] {
            let moved = chart.moved(&p);
            for k in 1..20 {
                let w = n(k, 20);
                let t = chart.parameter(&w);
                assert_eq!(chart.inverse(&t), w);
                assert_eq!(sign_at(&moved, &w), sign_at(&p, &t), "{chart:?} {k}");
            }
        }
    }
}
