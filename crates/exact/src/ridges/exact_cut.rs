//! The cut of Staude's curve, exactly.

use std::cmp::Ordering::Less;
use std::rc::Rc;

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure, horner};
use bifdiag_numbers::polynomial::{Polynomial, rational};
use bifdiag_numbers::wide::Interval128;
use dashu_ratio::RBig;

use super::latitude::{RealRoot, RootLatitude, StaudeCurve, value};
use super::strand::{Cut, samples};
use crate::model::Model;

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

/// `None`: two roots cannot be separated, or one is a moment.
pub(super) fn cut(model: &Model, x: &RBig, h: &RBig) -> Option<Cut<RootLatitude>> {
    let [_, p, q, rho] = model.family();
    let excess = rational::sub(&rational::scale(&p, x), &rational::scale(&q, h));
    let pull = rational::mul(&rho, &q);
    let square = rational::mul(&p, &rational::mul(&excess, &excess));
    let polynomial = Polynomial::from_rationals(&rational::sub(&square, &rational::mul(&pull, &pull)));
    let moments: Vec<RBig> = model.active.iter().map(|&k| model.a(k).clone()).collect();
    let fold = fold(model)?;
    let mut marks = RealRoot::about(&polynomial, &moments)?;
    let mut valley_roots = 0;
    for root in &marks {
        valley_roots += usize::from(root.compare(&fold)? == Less);
    }
    let along = moments.into_iter().zip(&model.active).map(|(a, &k)| [a, model.groups[k].q.clone()]);
    let along = Rc::new(StaudeCurve { moments: along.collect() });
    let latitude =
        |root: &RealRoot| RootLatitude::OnCurve { along: Rc::clone(&along), root: root.clone(), sign: Sign::Positive };
    let roots = marks.iter().map(latitude).collect();
    marks.insert(valley_roots, fold.clone());
    let level = Level::new([&p[..], &excess, &pull]);
    let below: Vec<[bool; 2]> = samples(&marks).iter().map(|mu| level.is_below(mu)).collect();
    let inside = [0, 1].map(|sign| below.iter().map(|below| below[sign]).collect());
    Some(Cut { roots, valley_roots, fold: latitude(&fold), inside })
}

/// Where ridge and valley of the curve meet.
fn fold(model: &Model) -> Option<RealRoot> {
    match model.inflection_polynomial() {
        Some(polynomial) => RealRoot::all(&polynomial)?.into_iter().next(),
        None => Some(RealRoot::rational(&passive_moment(model)?)),
    }
}

/// The moment of the axis that is perpendicular to r and to the other two active axes.
pub(super) fn passive_moment(model: &Model) -> Option<RBig> {
    let number = (0..model.groups.len()).find(|&k| !model.active.contains(&k) || model.groups[k].size > 1)?;
    Some(model.a(number).clone())
}
