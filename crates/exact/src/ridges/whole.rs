//! The forms of Staude's curve in whole numbers, multiplied out once for a body: at a point (h, x) the level is a sum of four
//! of them, so that its coefficients have all their digits, however much cancels in it.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::form::EnclosedForm;
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::polynomial::rational::over_one_denominator;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::enclosed::{RANGES, Range};
use crate::model::Model;

/// For the body with moments A' = `unit` A and squares q' = `weight` q, all of them integers: p = p'/(`weight`
/// `unit`⁴),
/// q = q'/(`weight` `unit`⁵), ρ = ρ'/(`weight` `unit`²).
pub(super) struct Whole {
    ranges: [WholeRange; 6],
    /// Twice the common denominator of the moments.
    unit: RBig,
    weight: RBig,
}

/// The forms of a range as polynomials in u/(1 − u).
struct WholeRange {
    rises: bool,
    p: Polynomial,
    q: Polynomial,
    rho: Polynomial,
    fold: Polynomial,
    /// p³, p²q, pq² and ρ²q².
    products: [Polynomial; 4],
}

impl Whole {
    /// `None` if there are not three active moments.
    pub fn new(model: &Model) -> Option<Self> {
        let active: [usize; 3] = model.active[..].try_into().ok()?;
        let two = RBig::from(2);
        let (moments, common) = over_one_denominator(&active.map(|k| model.a(k).clone()));
        let (weights, weight) = over_one_denominator(&active.map(|k| model.groups[k].q.clone()));
        let unit = RBig::from(common) * two;
        let doubled: Vec<IBig> = moments.iter().map(|a| a * 2).collect();
        let ranges = RANGES.map(|(base, other, sign)| {
            // τ_k at u = 0 and at u = 1, where on the way to infinity it is multiplied by 1 − u.
            let tau = [0, 1, 2].map(|k| {
                let at_zero = (&moments[base] - &moments[k]) * 2;
                let at_one = match other {
                    Some(other) => &at_zero + &moments[other] - &moments[base],
                    None => sign.orient(unit.numerator().clone()),
                };
                Polynomial::new(vec![at_zero, at_one])
            });
            WholeRange::new(&tau, &doubled, &weights, sign)
        });
        Some(Self { ranges, unit, weight: RBig::from(weight) })
    }

    /// The ranges at a point, in one arithmetic.
    pub fn ranges<E: Enclosure<Precision = ()>>(&self, x: &RBig, h: &RBig) -> [Range<E>; 6] {
        let x = x * &self.unit;
        let linear = over_one_denominator(&[x.clone(), -h]).0;
        let square = [&x * &x, &x * h * RBig::from(-2), h * h].map(|c| c * &self.weight);
        let [a, b, c] = square;
        let square = over_one_denominator(&[a, b, c, -RBig::ONE]).0;
        self.ranges.each_ref().map(|range| {
            let sum = |terms: &[&Polynomial], factors: &[IBig]| {
                terms.iter().zip(factors).fold(Polynomial::new(Vec::new()), |sum, (p, c)| sum.plus(&p.scaled(c)))
            };
            let excess = sum(&[&range.p, &range.q], &linear);
            let level = sum(&range.products.each_ref(), &square);
            Range {
                rises: range.rises,
                p: EnclosedForm::of(&range.p, 4),
                rho: EnclosedForm::of(&range.rho, 2),
                excess: EnclosedForm::of(&excess, 4),
                level: EnclosedForm::of(&level, 12),
                fold: EnclosedForm::of(&range.fold, 3),
            }
        })
    }
}

impl WholeRange {
    fn new(tau: &[Polynomial; 3], moments: &[IBig], weights: &[IBig], sign: Sign) -> Self {
        let triples = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
        let sum = |[a, b, c]: [Polynomial; 3]| a.plus(&b).plus(&c);
        let rest = triples.map(|(_, i, j)| tau[i].times(&tau[j]));
        let weighted = [0, 1, 2].map(|k| rest[k].squared().scaled(&weights[k]));
        let p = sum(weighted.clone());
        let q = sum([0, 1, 2].map(|k| weighted[k].scaled(&moments[k])));
        let rho = sum([0, 1, 2].map(|k| rest[k].scaled(&weights[k])));
        let fold = sum(triples.map(|(k, i, j)| {
            let difference = &moments[i] - &moments[j];
            let weight = &weights[i] * &weights[j] * &difference * &difference;
            tau[k].squared().times(&tau[k]).scaled(&weight)
        }));
        let (square, pull) = (p.squared(), rho.times(&q));
        let products = [square.times(&p), square.times(&q), p.times(&q.squared()), pull.squared()];
        Self { rises: sign == Sign::Positive, p, q, rho, fold, products }
    }
}
