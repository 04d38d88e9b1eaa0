//! The topology from the pieces of ridges and valleys on Staude's curve γ = ± adj(μ − A) r/√p, and for two active moments on
//! the great circle of the pair.

use std::cell::OnceCell;
use std::cmp::Ordering::Less;

use bifdiag_numbers::wide::Interval128;
use dashu_ratio::RBig;

use super::latitude::{Latitude, RootLatitude, value};
use super::strand::{Cut, Piece, Pieces, Quadratic};
use super::whole::Whole;
use super::{enclosed, exact_cut};
use crate::model::Model;
use bifdiag_diagram::topology::Component;

/// `whole` are the forms of this body, made when they are first needed.
pub(super) fn components(model: &Model, whole: &OnceCell<Option<Whole>>, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
    if model.active.len() < 3 {
        return with_pair(model, &exact_cut::cut(model, x, h)?, x, h);
    }
    let found = enclosed::ranges(model, x, h).and_then(|ranges| folded(&enclosed::cut(&ranges)?));
    let whole = || whole.get_or_init(|| Whole::new(model)).as_ref();
    let found = found.or_else(|| folded(&enclosed::cut(&whole()?.ranges::<Interval128>(x, h))?));
    found.or_else(|| folded(&exact_cut::cut(model, x, h)?))
}

/// The piece that holds a latitude.
fn holder<L: Latitude>(pieces: &[Piece<L>], latitude: &L) -> Option<usize> {
    for (number, piece) in pieces.iter().enumerate() {
        if piece.holds(latitude)? {
            return Some(number);
        }
    }
    None
}

/// The poles of a piece of the ridge of a sign.
fn poles<L: Latitude>(sign: usize, piece: &Piece<L>) -> [bool; 2] {
    let mut poles = [false; 2];
    poles[sign] = piece.reaches(1);
    poles
}

/// Three active moments: each sign of the curve is closed and has one ridge and one valley.
pub(super) fn folded<L: Latitude>(cut: &Cut<L>) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes: Vec<Vec<usize>> = ridges
        .iter()
        .enumerate()
        .map(|(sign, pieces)| {
            let add = |piece: &Piece<L>| found.add(piece.characteristic([true, false]), poles(sign, piece));
            pieces.iter().map(add).collect()
        })
        .collect();
    for sign in [0, 1] {
        for valley in cut.valleys(sign) {
            // Nearest to the fold, and in terms of this sign's ω.
            let latitude = valley.ends[1].clone().unwrap_or_else(|| cut.fold.clone());
            let own = nodes[sign][holder(&ridges[sign], &latitude)?];
            let node = found.add(-valley.characteristic([true, true]), [false; 2]);
            found.join(node, own);
            // Latitudes between the folds of both signs meet both ridges.
            let shared = valley.reaches(1) || latitude.compare(&cut.fold.clone().negated())? == Less;
            if shared {
                found.join(node, nodes[1 - sign][holder(&ridges[1 - sign], &latitude.negated())?]);
            }
        }
    }
    found.components()
}

/// Two active moments: the curve is two half circles through the poles, and the great circle of the pair crosses them at
/// the fold.
fn with_pair(model: &Model, cut: &Cut<RootLatitude>, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
    let a = exact_cut::passive_moment(model)?;
    let [_, p, q, rho] = model.family();
    let [p, q, rho] = [p, q, rho].map(|c| value(&c, &a));
    let (square, moment) = (&rho * &rho / &p, &q / &p);
    let side = rho.cmp(&RBig::ZERO);
    if side == std::cmp::Ordering::Equal {
        let inside = h * &moment >= *x;
        return on_equator(cut, inside);
    }
    let kappa = (moment - &a) / &square;
    let pair = Quadratic { alpha: a, kappa, reach: square }.pieces(x, h)?;
    if side == Less { pair_of_valleys(cut, &pair) } else { pair_of_ridges(cut, &pair) }
}

/// Nodes of the ridges of both half circles.
fn ridge_nodes(found: &mut Pieces, ridges: &[Vec<Piece<RootLatitude>>; 2], open: bool) -> Vec<Vec<usize>> {
    let of_sign = |(sign, pieces): (usize, &Vec<Piece<RootLatitude>>)| {
        pieces.iter().map(|piece| found.add(piece.characteristic([open, false]), poles(sign, piece))).collect()
    };
    ridges.iter().enumerate().map(of_sign).collect()
}

/// Nodes of the ridges, each with the valleys of the other half circle whose latitudes it meets; on the equator both folds
/// are one.
fn across(
    found: &mut Pieces,
    cut: &Cut<RootLatitude>,
    ridges: &[Vec<Piece<RootLatitude>>; 2],
    on_equator: bool,
) -> Option<Vec<Vec<usize>>> {
    let nodes = ridge_nodes(found, ridges, true);
    for sign in [0, 1] {
        for valley in cut.valleys(sign) {
            let latitude = valley.ends[1].clone().unwrap_or_else(|| cut.fold.clone()).negated();
            let node = found.add(-valley.characteristic([true, on_equator]), [false; 2]);
            let at_fold = on_equator && valley.reaches(1);
            found.join(node, nodes[1 - sign][holder_or_first(&ridges[1 - sign], &latitude, at_fold)?]);
        }
    }
    Some(nodes)
}

/// The folds lie on the equator, which belongs to neither ridge nor valley: J is constant on it.
fn on_equator(cut: &Cut<RootLatitude>, inside: bool) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes = across(&mut found, cut, &ridges, true)?;
    if inside {
        let first = |sign: usize| ridges[sign].iter().position(|piece| piece.reaches(0));
        found.join(nodes[0][first(0)?], nodes[1][first(1)?]);
    }
    found.components()
}

/// The piece that holds a latitude, or the one at the fold.
fn holder_or_first(pieces: &[Piece<RootLatitude>], latitude: &RootLatitude, at_fold: bool) -> Option<usize> {
    if at_fold { pieces.iter().position(|piece| piece.reaches(0)) } else { holder(pieces, latitude) }
}

/// Between the folds there are the ridges of both half circles, with the pair as valleys.
fn pair_of_valleys(cut: &Cut<RootLatitude>, pair: &[Piece<RootLatitude>]) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes = across(&mut found, cut, &ridges, false)?;
    for piece in pair {
        let latitude = piece.ends[0].clone().unwrap_or_else(|| cut.fold.clone());
        let node = found.add(-2 * piece.characteristic([true, true]), [false; 2]);
        let first = holder_or_first(&ridges[0], &latitude, piece.reaches(0))?;
        found.join(node, nodes[0][first]);
        found.join(node, nodes[1][holder(&ridges[1], &latitude.negated())?]);
    }
    found.components()
}

/// Between the folds the pair are the ridges, and both half circles valleys.
fn pair_of_ridges(cut: &Cut<RootLatitude>, pair: &[Piece<RootLatitude>]) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes = ridge_nodes(&mut found, &ridges, false);
    let copies: Vec<[usize; 2]> =
        pair.iter().map(|piece| [0, 1].map(|_| found.add(piece.characteristic([true, true]), [false; 2]))).collect();
    for (sign, end) in [(0, 1), (1, 0)] {
        // At its fold a half circle's ridge splits into the pair.
        let fold = ridges[sign].iter().position(|piece| piece.reaches(0));
        let beside = pair.iter().position(|piece| piece.reaches(end));
        if let (Some(fold), Some(beside)) = (fold, beside) {
            for copy in copies[beside] {
                found.join(nodes[sign][fold], copy);
            }
        }
    }
    for (sign, end) in [(0, 1), (1, 0)] {
        for valley in cut.valleys(sign) {
            let node = found.add(-valley.characteristic([true, true]), [false; 2]);
            let own = valley.ends[1].clone().unwrap_or_else(|| cut.fold.clone());
            let shared = valley.reaches(1) || cut.fold.clone().negated().compare(&own)? == Less;
            if shared {
                let place = if valley.reaches(1) {
                    pair.iter().position(|piece| piece.reaches(end))?
                } else {
                    holder(pair, &if sign == 0 { own } else { own.negated() })?
                };
                for copy in copies[place] {
                    found.join(node, copy);
                }
            } else {
                found.join(node, nodes[1 - sign][holder(&ridges[1 - sign], &own.negated())?]);
            }
        }
    }
    found.components()
}
