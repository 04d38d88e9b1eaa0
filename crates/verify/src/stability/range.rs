//! Where the parameter of a branch runs, and where each of its curves begins and ends: μ on the generic family and, where r
//! lies on an axis, on the lines of ±r̂; z = 1/s² over a space without r.

use dashu_base::{Abs, BitTest};
use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::pieces::{Branch, End, Piece, Pieces};
use crate::equilibria::spaces::Spaces;
use crate::numbers::isolation::Root;
use crate::numbers::polynomial::Polynomial;

pub(super) const CHANGES: Refused = Refused::Field { field: "stability_changes" };

/// Halvings of a root's range at most.
const NARROWEST: usize = 2000;

pub(super) fn uncertain() -> Refused {
    Refused::uncertain("the places where Arnold's theorem fails cannot be enclosed")
}

/// The range of the parameter; what has no end is cut beyond every zero of the condition and every end of a curve.
pub(crate) fn of(spaces: &Spaces, pieces: &Pieces, branch: Branch, condition: &Polynomial) -> Option<[RBig; 2]> {
    let ends = match branch {
        Branch::Generic(number) => spaces.interval(number).map(Option::<&RBig>::cloned),
        Branch::Line(plus) => {
            let a = Some(spaces.list[*spaces.active.first()?].a.clone());
            if plus { [a, None] } else { [None, a] }
        }
        Branch::Over(base) => [Some(RBig::ZERO), Some(RBig::ONE / spaces.sums(base).1)],
        Branch::Rotation(_) => return None,
    };
    let stations = pieces.list.iter().filter(|piece| piece.branch == branch).flat_map(|piece| &piece.range);
    let known = spaces.list.iter().map(|space| &space.a).chain(stations.flatten().flatten());
    let beyond = known.fold(condition.bound(), |most, t| most.max(t.clone().abs())) * RBig::from(2);
    let [lo, hi] = ends;
    Some([lo.unwrap_or_else(|| -&beyond), hi.unwrap_or(beyond)])
}

/// x rises with the parameter along a curve.
pub(crate) fn rises(piece: &Piece) -> bool {
    match piece.branch {
        Branch::Line(plus) => !plus,
        // y = 1/z − P̂.
        Branch::Over(_) => !piece.rising,
        Branch::Generic(_) | Branch::Rotation(_) => piece.rising,
    }
}

/// The ranges that hold the ends of a curve, by rising parameter; `whole` is that of its branch.
pub(crate) fn ends(spaces: &Spaces, pieces: &Pieces, piece: &Piece, whole: &[RBig; 2]) -> [[RBig; 2]; 2] {
    let mut ends = match piece.branch {
        Branch::Line(_) => piece.ends.map(|end| match end {
            End::Pitchfork(fork) => Some([(); 2].map(|()| spaces.list[pieces.forks[fork]].a.clone())),
            _ => None,
        }),
        Branch::Over(base) => {
            let p_sum = spaces.sums(base).1;
            let z = |y: &RBig| RBig::ONE / (&p_sum + y);
            piece.range.each_ref().map(|range| range.as_ref().map(|[low, high]| [z(high), z(low)]))
        }
        _ => piece.range.clone(),
    };
    // Those of a line are by rising x.
    if matches!(piece.branch, Branch::Line(true) | Branch::Over(_)) {
        ends.reverse();
    }
    let ([first, last], [lo, hi]) = (ends, whole);
    let at = |t: &RBig| [t.clone(), t.clone()];
    [first.unwrap_or_else(|| at(lo)), last.unwrap_or_else(|| at(hi))]
}

/// Narrows the range of a root until it is 2⁻ᵇ of its distance from the ends of the branch, by which equilibria are
/// distinguished.
pub(super) fn narrow(root: &mut Root, [first, last]: [&RBig; 2], bits: usize) {
    let finer = RBig::from(IBig::ONE << bits);
    for _ in 0..NARROWEST {
        let width = (&root.hi - &root.lo) * &finer;
        let room = (&root.lo - first).min(last - &root.hi);
        if width <= room {
            break;
        }
        // An end of the range may be one of the branch.
        let halvings = if room.is_zero() { 1 } else { (width / room).floor().bit_len() };
        root.narrow(halvings);
    }
}

/// Narrows a root until it lies aside of the range that holds an end of a curve; false where it is that end.
pub(super) fn apart(root: &mut Root, [low, high]: &[RBig; 2]) -> Result<bool, Refused> {
    if low == high && root.settle_at(low) {
        return Ok(false);
    }
    for _ in 0..NARROWEST {
        if root.hi < *low || *high < root.lo {
            return Ok(true);
        }
        root.halve();
    }
    Err(CHANGES)
}
