//! Every critical value of U and the energies of the poles over one x = l²/2, with the exact sign of h against each.

use std::cmp::Ordering;
use std::sync::Arc;

use bifdiag_equilibria::curves::Pole;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::polynomial::{Polynomial, Root, rational};
use bifdiag_numbers::wide::Wide;
use dashu_ratio::RBig;

use super::curves::{IsolationError, Place, order, roots_in_interval};
use super::family::{Half, State};
use super::model::{Constants, Model};
use super::statistics::{Precision, Question, count};

/// Bits in which h is compared with a height; beyond the second one equality is looked for by gcd.
const STAGES: [usize; 6] = [64, 160, 400, 1000, 2500, 6000];

/// What has a height.
#[derive(Clone, Debug)]
pub(super) enum CriticalSource {
    /// The generic family over an interval of μ with this number.
    Generic { number: usize, place: Place },
    /// The family over a group without r.
    Over { group: usize, place: Place },
    /// γ = ±r̂.
    Line(Pole),
    /// r = 0: rotation about an axis of this group.
    Euler { group: usize },
}

/// A height over x.
#[derive(Clone, Debug)]
pub(super) struct CriticalValue {
    pub source: CriticalSource,
    pub height: Wide,
    /// The sign of h − height; zero is proved.
    pub sign: Sign,
    /// Bounds of |h − height|.
    pub distance: [f64; 2],
}

/// Why the heights are not known.
#[derive(Clone, Debug)]
pub(super) enum CriticalValueError {
    /// Roots of the polynomial of critical points (Proposition 4.8) that are not isolated.
    Roots,
    /// The largest precision does not decide the sign of h against this height, and it is not 0.
    Sign(Box<CriticalSource>),
}

impl From<IsolationError> for CriticalValueError {
    fn from(_: IsolationError) -> Self {
        Self::Roots
    }
}

/// The body at one x, with constants in growing precision made when first needed.
pub(super) struct CriticalValues<'a> {
    pub model: &'a Model,
    pub x: RBig,
    constants: Vec<Constants<Wide>>,
}

impl<'a> CriticalValues<'a> {
    pub fn new(model: &'a Model, x: RBig) -> Self {
        Self { model, x, constants: Vec::new() }
    }

    /// All heights with the signs of h against them.
    pub fn against(&mut self, h: &RBig) -> Result<Vec<CriticalValue>, CriticalValueError> {
        let sources = self.sources()?;
        sources.into_iter().map(|source| self.level(source, h)).collect()
    }

    /// The level nearest to h. Those that their bounds do not separate are compared with more bits; what the largest
    /// precision finds equal is, like two curves that cross over x, equally near, and the first is taken.
    pub fn nearest(&mut self, levels: &[CriticalValue], h: &RBig) -> Option<CriticalValue> {
        let farthest = levels.iter().map(|level| level.distance[1]).fold(f64::INFINITY, f64::min);
        let mut rivals: Vec<CriticalValue> =
            levels.iter().filter(|level| level.distance[0] <= farthest).cloned().collect();
        for stage in self.useful_stages() {
            if rivals.len() < 2 || farthest == 0.0 {
                break;
            }
            let distances: Option<Vec<[RBig; 2]>> = rivals
                .iter()
                .map(|level| {
                    let (_, height) = self.enclosure(level.source.clone(), stage);
                    let [lo, hi] = height.exact_bounds()?.map(|height| level.sign.orient(h - height));
                    Some(if lo <= hi { [lo, hi] } else { [hi, lo] })
                })
                .collect();
            let Some(distances) = distances else { continue };
            let Some(farthest) = distances.iter().map(|[_, hi]| hi).min() else { break };
            let mut may_be_nearest = distances.iter().map(|[lo, _]| lo <= farthest);
            rivals.retain(|_| may_be_nearest.next() == Some(true));
        }
        rivals.into_iter().next()
    }

    /// The precisions worth trying: what more bits would show of a rounded body is its rounding.
    fn useful_stages(&self) -> std::ops::Range<usize> {
        0..STAGES.iter().take_while(|bits| **bits <= Self::most_bits(self.model)).count()
    }

    /// The highest of them.
    pub fn most_bits(model: &Model) -> usize {
        if model.rounded { STAGES[2] } else { STAGES[STAGES.len() - 1] }
    }

    /// All heights, enclosed with at least the bits of a stage.
    pub fn enclosed(&mut self, stage: usize) -> Result<Vec<(CriticalSource, Wide)>, CriticalValueError> {
        let sources = self.sources()?;
        Ok(sources.into_iter().map(|source| self.enclosure(source, stage)).collect())
    }

    /// The number of precisions.
    pub fn stages() -> usize {
        STAGES.len()
    }

    fn sources(&self) -> Result<Vec<CriticalSource>, CriticalValueError> {
        let model = self.model;
        let mut found = Vec::new();
        if model.active.is_empty() {
            found.extend((0..model.groups.len()).map(|group| CriticalSource::Euler { group }));
            return Ok(found);
        }
        if model.active.len() > 1 {
            let polynomial = self.level_polynomial();
            for number in 0..=model.active.len() {
                let roots = roots_in_interval(model, &polynomial, number, STAGES[0])?;
                found.extend(roots.into_iter().map(|(place, _)| CriticalSource::Generic { number, place }));
            }
        }
        for &group in &model.passive {
            found.extend(self.over(group)?);
        }
        found.extend([Pole::Plus, Pole::Minus].map(CriticalSource::Line));
        Ok(found)
    }

    /// q⁴ − 4x²p³D² (Proposition 4.8).
    fn level_polynomial(&self) -> Polynomial {
        let [d, p, q, _] = self.model.known_family();
        let q2 = rational::mul(&q, &q);
        let cube = rational::mul(&rational::mul(&p, &p), &rational::mul(&p, &rational::mul(&d, &d)));
        let weight = &self.x * &self.x * RBig::from(4);
        let difference = rational::sub(&rational::mul(&q2, &q2), &rational::scale(&cube, &weight));
        Polynomial::from_rationals(&difference)
    }

    /// A place of the generic family has exactly this x.
    pub fn stands_over(&self, place: &Place) -> bool {
        self.is_root_at(place, &self.level_polynomial())
    }

    /// (a v − R̂)⁴ = 4x² v³ for v = s² ≥ P̂ (Proposition 4.8), in y = v − P̂.
    fn over(&self, group: usize) -> Result<Vec<CriticalSource>, CriticalValueError> {
        let (r_sum, p_sum) = self.model.known_sums(group);
        let moment = [-r_sum, self.model.a(group).clone()];
        let square = rational::mul(&moment, &moment);
        let cube = [RBig::ZERO, RBig::ZERO, RBig::ZERO, &self.x * &self.x * RBig::from(4)];
        let difference = Polynomial::from_rationals(&rational::sub(&rational::mul(&square, &square), &cube));
        let local = difference.composed(&p_sum, &RBig::ONE);
        let half = Half::Over { group };
        let mut places = Vec::new();
        if local.sign_at(&RBig::ZERO) == Sign::Zero {
            places.push(Place::exact(half, RBig::ZERO));
        }
        for mut root in local.positive_roots().ok_or(CriticalValueError::Roots)? {
            root.refine(STAGES[0]);
            places.push(of_root(half, root, &RBig::ONE));
        }
        Ok(places.into_iter().map(|place| CriticalSource::Over { group, place }).collect())
    }

    fn constants(&mut self, stage: usize) -> &Constants<Wide> {
        while self.constants.len() <= stage {
            let bits = STAGES[self.constants.len()];
            self.constants.push(Constants::new(self.model, bits));
        }
        &self.constants[stage]
    }

    fn level(&mut self, mut source: CriticalSource, h: &RBig) -> Result<CriticalValue, CriticalValueError> {
        /// A distance is known to this relative accuracy.
        const ACCURACY: f64 = 1e-12;
        let equal = |source: CriticalSource| {
            count(Question::Sign, Precision::Algebra);
            Ok(CriticalValue { source, height: Wide::rational(h, STAGES[0]), sign: Sign::Zero, distance: [0.0; 2] })
        };
        let straight = self.straight_sign(&source, h);
        if straight == Some(Sign::Zero) {
            return equal(source);
        }
        let mut decided = None;
        for stage in self.useful_stages() {
            let bits = STAGES[stage];
            if stage == 2 && decided.is_none() && straight.is_none() && self.is_equal(&source, h) {
                return equal(source);
            }
            let (refined, height) = self.enclosure(source, stage);
            source = refined;
            let difference = Wide::rational(h, bits) - height.clone();
            let Some(sign) = difference.strict_sign() else { continue };
            let [lo, hi] = difference.bounds().map(f64::abs);
            let distance = [lo.min(hi), lo.max(hi)];
            if decided.is_none() {
                count(Question::Sign, Precision::Bits(bits));
            }
            decided = Some(CriticalValue { source: source.clone(), height, sign, distance });
            if distance[1] - distance[0] <= ACCURACY * distance[1] {
                break;
            }
        }
        decided.ok_or_else(|| CriticalValueError::Sign(Box::new(source)))
    }

    /// The sign of h against a straight line, which rational arithmetic decides.
    fn straight_sign(&self, source: &CriticalSource, h: &RBig) -> Option<Sign> {
        match source {
            CriticalSource::Euler { group } => Some((h * self.model.a(*group)).cmp(&self.x).into()),
            CriticalSource::Line(pole) => {
                let [r2, weighted] = &self.model.line;
                let above = h - &self.x * r2 / weighted;
                // Against −r for P+ and r for P−, by squares.
                let square = &above * &above;
                Some(match (pole, above < RBig::ZERO) {
                    (Pole::Plus, false) => Sign::Positive,
                    (Pole::Plus, true) => r2.cmp(&square).into(),
                    (Pole::Minus, true) => Sign::Negative,
                    (Pole::Minus, false) => square.cmp(r2).into(),
                })
            }
            CriticalSource::Generic { .. } | CriticalSource::Over { .. } => None,
        }
    }

    fn enclosure(&mut self, source: CriticalSource, stage: usize) -> (CriticalSource, Wide) {
        let bits = STAGES[stage];
        let (model, x) = (self.model, Wide::rational(&self.x, bits));
        let c = self.constants(stage);
        match source {
            CriticalSource::Euler { group } => (source, x / c.a[group].clone()),
            CriticalSource::Line(pole) => {
                let kinetic = x / c.j_r.clone().unwrap_or_else(|| c.small(1));
                (source, if pole == Pole::Plus { kinetic - c.r.clone() } else { kinetic + c.r.clone() })
            }
            CriticalSource::Generic { number, place } => {
                let place = refined(&place, bits);
                let height = height_at(model, c, &place, x);
                (CriticalSource::Generic { number, place }, height)
            }
            CriticalSource::Over { group, place } => {
                let place = refined(&place, bits);
                let height = height_at(model, c, &place, x);
                (CriticalSource::Over { group, place }, height)
            }
        }
    }

    /// The height is h: decided by gcd of the polynomial of critical points with that of their height (Lemma 4.11).
    fn is_equal(&self, source: &CriticalSource, h: &RBig) -> bool {
        let (place, condition) = match source {
            CriticalSource::Generic { place, .. } => (place, self.generic_condition(h)),
            CriticalSource::Over { group, place } => (place, self.condition_over(*group, h)),
            CriticalSource::Line(_) | CriticalSource::Euler { .. } => return false,
        };
        self.is_root_at(place, &condition)
    }

    /// A place is a root of a polynomial in μ, or in v over a group without r: decided by gcd.
    fn is_root_at(&self, place: &Place, condition: &Polynomial) -> bool {
        let [origin, direction] = match place.half {
            Half::Generic { base, sign } => [self.model.a(base).clone(), RBig::from(i8::from(sign))],
            Half::Over { group } => [self.model.known_sums(group).1, RBig::ONE],
        };
        match &place.root {
            None => condition.sign_at(&(&origin + &direction * &place.lo)) == Sign::Zero,
            Some(root) => {
                let scale = if root.hi.is_zero() { RBig::ONE } else { &place.hi / &root.hi };
                root.is_root_of(&condition.composed(&origin, &(direction * scale)))
            }
        }
    }

    /// hQ² − xP(Q − 2R), times D⁴.
    fn generic_condition(&self, h: &RBig) -> Polynomial {
        let [d, p, q, r] = self.model.known_family();
        let energy = rational::sub(&q, &rational::scale(&rational::mul(&r, &d), &RBig::from(2)));
        let right = rational::scale(&rational::mul(&p, &energy), &self.x);
        Polynomial::from_rationals(&rational::sub(&rational::scale(&rational::mul(&q, &q), h), &right))
    }

    /// h(a v − R̂)² − x v (a v − 3R̂).
    fn condition_over(&self, group: usize, h: &RBig) -> Polynomial {
        let (r_sum, _) = self.model.known_sums(group);
        let a = self.model.a(group).clone();
        let moment = [-r_sum.clone(), a.clone()];
        let left = rational::scale(&rational::mul(&moment, &moment), h);
        let right = rational::scale(&[RBig::ZERO, RBig::from(-3) * r_sum, a], &self.x);
        Polynomial::from_rationals(&rational::sub(&left, &right))
    }
}

fn of_root(half: Half, root: Root, scale: &RBig) -> Place {
    Place { half, lo: &root.lo * scale, hi: &root.hi * scale, root: Some(Arc::new(root)) }
}

/// The same place with an isolating range of this many bits.
pub(super) fn refined(place: &Place, bits: usize) -> Place {
    let Some(root) = &place.root else { return place.clone() };
    let scale = if root.hi.is_zero() { RBig::ONE } else { &place.hi / &root.hi };
    let mut finer = root.as_ref().clone();
    finer.refine(bits);
    of_root(place.half, finer, &scale)
}

/// The order of two places of one family by rising μ, or v; `None` when the largest precision does not separate them.
pub(super) fn ordered(model: &Model, p: &Place, q: &Place) -> Option<Ordering> {
    STAGES.into_iter().find_map(|bits| order(model, &refined(p, bits), &refined(q, bits)))
}

/// x/J − ⟨γ, r⟩ over the range of a place.
fn height_at(model: &Model, c: &Constants<Wide>, place: &Place, x: Wide) -> Wide {
    let y = Wide::rational(&place.lo, c.precision).hull(&Wide::rational(&place.hi, c.precision));
    let state = State::at(model, c, place.half, &y);
    x / state.j - state.rho
}
