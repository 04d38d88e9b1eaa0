//! r in one eigenspace of A: on each latitude J has its extrema in two planes through r.

use dashu_ratio::RBig;

use super::latitude::RootLatitude;
use super::strand::{Piece, Pieces, Quadratic};
use crate::model::Model;
use bifdiag_diagram::topology::Component;

pub(super) fn components(model: &Model, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
    let [low, high] = across(model)?;
    let a = model.a(model.active[0]);
    let strand = |moment: &RBig| {
        let kappa = (a - moment) / &model.r2;
        Quadratic { alpha: moment.clone(), kappa, reach: model.r2.clone() }.pieces(x, h)
    };
    let ridges = strand(&high)?;
    if low == high { round(&ridges) } else { two_planes(&ridges, &strand(&low)?) }
}

/// The moments of the two axes perpendicular to r.
fn across(model: &Model) -> Option<[RBig; 2]> {
    let mut moments = Vec::new();
    for (number, group) in model.groups.iter().enumerate() {
        let carried = usize::from(number == model.active[0]);
        moments.extend(std::iter::repeat_n(group.a.clone(), group.size - carried));
    }
    moments.try_into().ok()
}

/// The poles at the ends of a piece by rising w: −r̂ at the lower one.
fn poles(piece: &Piece<RootLatitude>) -> [bool; 2] {
    [piece.reaches(1), piece.reaches(0)]
}

/// J is constant on each latitude: pieces are discs, annuli or the sphere.
fn round(pieces: &[Piece<RootLatitude>]) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    for piece in pieces {
        let [plus, minus] = poles(piece);
        found.add(i32::from(plus) + i32::from(minus), [plus, minus]);
    }
    found.components()
}

/// Two ridges and two valleys on each latitude, images of each other, which meet at the poles.
fn two_planes(ridges: &[Piece<RootLatitude>], valleys: &[Piece<RootLatitude>]) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let open = [true, true];
    let nodes: Vec<[usize; 2]> = ridges
        .iter()
        .map(|ridge| {
            let count = ridge.characteristic(open);
            let copies = [0, 1].map(|_| found.add(count, [false; 2]));
            for (end, pole) in [(1, [true, false]), (0, [false, true])] {
                if ridge.reaches(end) {
                    let pole = found.add(1, pole);
                    for copy in copies {
                        found.join(copy, pole);
                    }
                }
            }
            copies
        })
        .collect();
    for valley in valleys {
        let ridge = holder(ridges, valley)?;
        let copies = nodes[ridge];
        found.join(copies[0], copies[1]);
        let both = found.add(-2 * valley.characteristic(open), [false; 2]);
        found.join(both, copies[0]);
    }
    found.components()
}

/// The ridge piece over the latitudes of a valley piece.
pub(super) fn holder(ridges: &[Piece<RootLatitude>], valley: &Piece<RootLatitude>) -> Option<usize> {
    let inner = valley.ends.iter().flatten().next();
    for (number, ridge) in ridges.iter().enumerate() {
        let holds = match inner {
            Some(latitude) => ridge.holds(latitude)?,
            None => ridge.reaches(0) && ridge.reaches(1),
        };
        if holds {
            return Some(number);
        }
    }
    None
}
