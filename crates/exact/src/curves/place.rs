//! Places on the generic family and over the groups without r: isolated roots, in order.

use std::sync::Arc;

use dashu_ratio::RBig;

use crate::family::Half;
use crate::model::Model;
use bifdiag_numbers::Sign;
use bifdiag_numbers::polynomial::{Polynomial, Root};

/// Bits to which the roots of a proof are refined.
pub(crate) const ROOT_BITS: usize = 420;

/// A place on a half of a family.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub half: Half,
    /// y between lo and hi; equal when y is this rational.
    pub lo: RBig,
    pub hi: RBig,
    /// The root, if it is one.
    pub root: Option<Arc<Root>>,
}

/// Roots lie closer together than isolation goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct IsolationError;

/// A chart of the generic family: y in (0, limit], or (0, ∞).
pub(super) struct Chart {
    pub half: Half,
    pub limit: Option<RBig>,
}

/// The interval of μ with this number: charts by rising μ.
pub(super) fn charts(model: &Model, number: usize) -> Vec<Chart> {
    let left = number.checked_sub(1).map(|n| model.active[n]);
    let right = model.active.get(number).copied();
    match (left, right) {
        (Some(left), Some(right)) => {
            let middle = model.difference(right, left) / RBig::from(2);
            vec![
                Chart { half: Half::Generic { base: left, sign: Sign::Positive }, limit: Some(middle.clone()) },
                Chart { half: Half::Generic { base: right, sign: Sign::Negative }, limit: Some(middle) },
            ]
        }
        (None, Some(base)) => vec![Chart { half: Half::Generic { base, sign: Sign::Negative }, limit: None }],
        (Some(base), None) => vec![Chart { half: Half::Generic { base, sign: Sign::Positive }, limit: None }],
        (None, None) => Vec::new(),
    }
}

/// Roots of a polynomial in μ on one interval of the generic family, by rising μ. A root in the very middle between two
/// moments is given once, on the left half.
pub(crate) fn roots_in_interval(
    model: &Model,
    polynomial: &Polynomial,
    number: usize,
    bits: usize,
) -> Result<Vec<(Place, bool)>, IsolationError> {
    let mut found = Vec::new();
    for chart in charts(model, number) {
        let Half::Generic { base, sign } = chart.half else { continue };
        let scale = chart.limit.clone().unwrap_or(RBig::ONE);
        let oriented = sign.orient(scale.clone());
        let local = polynomial.composed(model.a(base), &oriented);
        let mut roots =
            if chart.limit.is_some() { local.roots_in_unit() } else { local.positive_roots() }.ok_or(IsolationError)?;
        if chart.limit.is_some() && sign == Sign::Positive && local.sign_at(&RBig::ONE) == Sign::Zero {
            roots.push(Root::exact(&local, RBig::ONE));
        }
        let mut places: Vec<(Place, bool)> = roots
            .into_iter()
            .map(|mut root| {
                root.refine(bits);
                let odd = root.odd;
                let (lo, hi) = (&root.lo * &scale, &root.hi * &scale);
                (Place { half: chart.half, lo, hi, root: Some(Arc::new(root)) }, odd)
            })
            .collect();
        if sign == Sign::Negative {
            places.reverse();
        }
        found.extend(places);
    }
    Ok(found)
}

/// Order on an interval of the generic family: by rising μ; `None` when the enclosures overlap.
pub(crate) fn order(model: &Model, p: &Place, q: &Place) -> Option<std::cmp::Ordering> {
    use std::cmp::Ordering::{Greater, Less};
    let (Half::Generic { .. }, Half::Generic { .. }) = (p.half, q.half) else {
        return match (&p.lo, &p.hi, &q.lo, &q.hi) {
            (_, a, b, _) if a < b => Some(Less),
            (a, _, _, b) if a > b => Some(Greater),
            _ => None,
        };
    };
    let ([a, b], [c, d]) = (p.mu(model), q.mu(model));
    if b < c {
        Some(Less)
    } else if d < a {
        Some(Greater)
    } else {
        None
    }
}

impl Place {
    pub fn exact(half: Half, y: RBig) -> Self {
        Self { half, lo: y.clone(), hi: y, root: None }
    }

    /// The range of μ.
    pub fn mu(&self, model: &Model) -> [RBig; 2] {
        match self.half {
            Half::Generic { base, sign: Sign::Positive } => [model.a(base) + &self.lo, model.a(base) + &self.hi],
            Half::Generic { base, .. } => [model.a(base) - &self.hi, model.a(base) - &self.lo],
            Half::Over { group } => [model.a(group).clone(), model.a(group).clone()],
        }
    }
}

/// μ = a_k of a group without r, if it lies in the interval.
pub(crate) fn passive_place(model: &Model, number: usize, group: usize) -> Option<Place> {
    let mu = model.a(group);
    charts(model, number).into_iter().find_map(|chart| {
        let Half::Generic { base, sign } = chart.half else { return None };
        let delta = mu - model.a(base);
        let y = sign.orient(delta);
        let inside = y > RBig::ZERO && chart.limit.is_none_or(|limit| y <= limit);
        inside.then(|| Place::exact(chart.half, y))
    })
}
