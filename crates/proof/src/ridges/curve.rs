//! r in no eigenspace of A: ridges and valleys on Staude's curve γ = ± adj(μ − A) r/√p, and for two active moments on
//! the great circle of the pair.

use std::cmp::Ordering::Less;

use dashu_ratio::RBig;
use numbers::Sign;
use numbers::enclosure::{Arithmetic, Enclosure, horner};
use numbers::polynomial::{Polynomial, rational};
use numbers::wide::Interval128;

use super::latitude::{Course, Latitude, RealRoot, value};
use super::pair::Quadratic;
use super::pieces::Pieces;
use super::strand::{Piece, runs, samples};
use crate::model::Model;
use top::topology::Component;

/// The curve γ = ± adj(μ − A) r/√p cut by the level U = h.
struct Cut {
    course: Course,
    /// Where U = h on either sign of the curve, ascending, without the fold.
    roots: Vec<RealRoot>,
    /// So many roots lie below the fold.
    valley_roots: usize,
    /// Where ridge and valley meet.
    fold: RealRoot,
    /// For each sign, whether the gaps between roots and fold lie in U_hl.
    inside: [Vec<bool>; 2],
}

/// U − h on either sign of the curve: (A√p ∓ ρq)/(q√p) with A = xp − hq.
struct Level<'a> {
    /// p, A and ρq.
    exact: [&'a [RBig]; 3],
    narrow: [Vec<Interval128>; 3],
}

impl<'a> Level<'a> {
    fn new(exact: [&'a [RBig]; 3]) -> Self {
        let narrow = exact.map(|c| c.iter().map(|c| Interval128::rational(c, ())).collect());
        Self { exact, narrow }
    }

    /// U < h at μ, on both signs of the curve.
    fn is_below(&self, mu: &RBig) -> [bool; 2] {
        let at = Interval128::rational(mu, ());
        let [p, excess, pull] = self.narrow.each_ref().map(|c| horner(c, &at, ()));
        let kinetic = excess * p.sqrt();
        Sign::BOTH.map(|sign| {
            let difference = kinetic.clone() - sign.orient(pull.clone());
            difference.strict_sign().map_or_else(|| self.is_below_exactly(mu, sign), |sign| sign == Sign::Negative)
        })
    }

    fn is_below_exactly(&self, mu: &RBig, sign: Sign) -> bool {
        let [p, a, b] = self.exact.map(|c| value(c, mu));
        let b = sign.orient(b);
        let signed = |c: &RBig, square: RBig| if *c < RBig::ZERO { -square } else { square };
        signed(&a, &a * &a * p) < signed(&b, &b * &b)
    }
}

impl Cut {
    fn new(model: &Model, x: &RBig, h: &RBig) -> Option<Self> {
        let [_, p, q, rho] = model.family();
        let excess = rational::sub(&rational::scale(&p, x), &rational::scale(&q, h));
        let pull = rational::mul(&rho, &q);
        let square = rational::mul(&p, &rational::mul(&excess, &excess));
        let polynomial = Polynomial::from_rationals(&rational::sub(&square, &rational::mul(&pull, &pull)));
        let moments: Vec<RBig> = model.active.iter().map(|&k| model.a(k).clone()).collect();
        let course =
            Course { moments: model.active.iter().map(|&k| [model.a(k).clone(), model.groups[k].q.clone()]).collect() };
        let fold = fold(model)?;
        let mut roots = Vec::new();
        let mut valley_roots = 0;
        for root in RealRoot::about(&polynomial, &moments)? {
            valley_roots += usize::from(root.compare(&fold)? == Less);
            roots.push(root);
        }
        let mut marks = roots.clone();
        marks.insert(valley_roots, fold.clone());
        let samples = samples(&marks);
        let level = Level::new([&p[..], &excess, &pull]);
        let below: Vec<[bool; 2]> = samples.iter().map(|mu| level.is_below(mu)).collect();
        let inside = [0, 1].map(|sign| below.iter().map(|below| below[sign]).collect());
        Some(Self { course, roots, valley_roots, fold, inside })
    }

    fn latitude(&self, root: &RealRoot, sign: Sign) -> Latitude<'_> {
        Latitude::OnCurve { course: &self.course, root: root.clone(), sign }
    }

    /// ω at the fold of one sign.
    fn fold_latitude(&self, sign: Sign) -> Latitude<'_> {
        self.latitude(&self.fold, sign)
    }

    /// Pieces of the ridge, μ above the fold, in terms of ω, which rises with μ: the lower end is the fold, the upper the
    /// pole.
    fn ridges(&self, sign: usize) -> Vec<Piece<'_>> {
        let end =
            |root: Option<usize>| root.map(|root| self.latitude(&self.roots[self.valley_roots + root], Sign::Positive));
        let gaps = &self.inside[sign][self.valley_roots + 1..];
        runs(gaps).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect()
    }

    /// Pieces of the valley, by rising μ: the upper end is the fold.
    fn valleys(&self, sign: usize) -> Vec<Piece<'_>> {
        let end = |root: Option<usize>| root.map(|root| self.latitude(&self.roots[root], Sign::Positive));
        let gaps = &self.inside[sign][..=self.valley_roots];
        runs(gaps).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect()
    }
}

/// Where ridge and valley of the curve meet.
fn fold(model: &Model) -> Option<RealRoot> {
    match model.inflection_polynomial() {
        Some(polynomial) => RealRoot::all(&polynomial)?.into_iter().next(),
        None => Some(RealRoot::rational(&passive_moment(model)?)),
    }
}

/// The moment of the axis that is perpendicular to r and to the other two active axes.
fn passive_moment(model: &Model) -> Option<RBig> {
    let number = (0..model.groups.len()).find(|&k| !model.active.contains(&k) || model.groups[k].size > 1)?;
    Some(model.a(number).clone())
}

pub(super) fn components(model: &Model, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
    let cut = Cut::new(model, x, h)?;
    if model.active.len() == 3 { folded(&cut) } else { with_pair(model, &cut, x, h) }
}

/// The piece that holds a latitude.
fn holder(pieces: &[Piece<'_>], latitude: &Latitude<'_>) -> Option<usize> {
    for (number, piece) in pieces.iter().enumerate() {
        if piece.holds(latitude)? {
            return Some(number);
        }
    }
    None
}

/// The poles of a piece of the ridge of a sign.
fn poles(sign: usize, piece: &Piece<'_>) -> [bool; 2] {
    let mut poles = [false; 2];
    poles[sign] = piece.reaches(1);
    poles
}

/// Three active moments: each sign of the curve is closed and has one ridge and one valley.
fn folded(cut: &Cut) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes: Vec<Vec<usize>> = ridges
        .iter()
        .enumerate()
        .map(|(sign, pieces)| {
            let add = |piece: &Piece<'_>| found.add(piece.characteristic([true, false]), poles(sign, piece));
            pieces.iter().map(add).collect()
        })
        .collect();
    for sign in [0, 1] {
        for valley in cut.valleys(sign) {
            // Nearest to the fold, and in terms of this sign's ω.
            let latitude = valley.ends[1].clone().unwrap_or_else(|| cut.fold_latitude(Sign::Positive));
            let own = nodes[sign][holder(&ridges[sign], &latitude)?];
            let node = found.add(-valley.characteristic([true, true]), [false; 2]);
            found.join(node, own);
            // Latitudes between the folds of both signs meet both ridges.
            let shared = valley.reaches(1) || latitude.compare(&cut.fold_latitude(Sign::Negative))? == Less;
            if shared {
                found.join(node, nodes[1 - sign][holder(&ridges[1 - sign], &latitude.negated())?]);
            }
        }
    }
    found.components()
}

/// Two active moments: the curve is two half circles through the poles, and the great circle of the pair crosses them at
/// the fold.
fn with_pair(model: &Model, cut: &Cut, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
    let a = passive_moment(model)?;
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
fn ridge_nodes(found: &mut Pieces, ridges: &[Vec<Piece<'_>>; 2], open: bool) -> Vec<Vec<usize>> {
    let of_sign = |(sign, pieces): (usize, &Vec<Piece<'_>>)| {
        pieces.iter().map(|piece| found.add(piece.characteristic([open, false]), poles(sign, piece))).collect()
    };
    ridges.iter().enumerate().map(of_sign).collect()
}

/// The folds lie on the equator, which belongs to neither ridge nor valley: J is constant on it.
fn on_equator(cut: &Cut, inside: bool) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes = ridge_nodes(&mut found, &ridges, true);
    for sign in [0, 1] {
        for valley in cut.valleys(sign) {
            let latitude = valley.ends[1].clone().unwrap_or_else(|| cut.fold_latitude(Sign::Positive)).negated();
            let node = found.add(-valley.characteristic([true, true]), [false; 2]);
            found.join(node, nodes[1 - sign][holder_or_first(&ridges[1 - sign], &latitude, valley.reaches(1))?]);
        }
    }
    if inside {
        let first = |sign: usize| ridges[sign].iter().position(|piece| piece.reaches(0));
        found.join(nodes[0][first(0)?], nodes[1][first(1)?]);
    }
    found.components()
}

/// The piece that holds a latitude, or the one at the fold.
fn holder_or_first(pieces: &[Piece<'_>], latitude: &Latitude<'_>, at_fold: bool) -> Option<usize> {
    if at_fold { pieces.iter().position(|piece| piece.reaches(0)) } else { holder(pieces, latitude) }
}

/// Between the folds there are the ridges of both half circles, with the pair as valleys.
fn pair_of_valleys(cut: &Cut, pair: &[Piece<'static>]) -> Option<Vec<Component>> {
    let mut found = Pieces::default();
    let ridges = [0, 1].map(|sign| cut.ridges(sign));
    let nodes = ridge_nodes(&mut found, &ridges, true);
    for sign in [0, 1] {
        for valley in cut.valleys(sign) {
            // These latitudes meet the other half circle's ridge.
            let latitude = valley.ends[1].clone().unwrap_or_else(|| cut.fold_latitude(Sign::Positive)).negated();
            let node = found.add(-valley.characteristic([true, false]), [false; 2]);
            found.join(node, nodes[1 - sign][holder(&ridges[1 - sign], &latitude)?]);
        }
    }
    for piece in pair {
        let latitude = piece.ends[0].clone().unwrap_or_else(|| cut.fold_latitude(Sign::Positive));
        let node = found.add(-2 * piece.characteristic([true, true]), [false; 2]);
        let first = holder_or_first(&ridges[0], &latitude, piece.reaches(0))?;
        found.join(node, nodes[0][first]);
        found.join(node, nodes[1][holder(&ridges[1], &latitude.negated())?]);
    }
    found.components()
}

/// Between the folds the pair are the ridges, and both half circles valleys.
fn pair_of_ridges(cut: &Cut, pair: &[Piece<'static>]) -> Option<Vec<Component>> {
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
            let own = valley.ends[1].clone().unwrap_or_else(|| cut.fold_latitude(Sign::Positive));
            let shared = valley.reaches(1) || cut.fold_latitude(Sign::Negative).compare(&own)? == Less;
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
