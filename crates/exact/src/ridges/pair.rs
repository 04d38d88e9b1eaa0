//! Strands on which J is a quadratic function of w: J = α + κw².

use bifdiag_numbers::polynomial::{Polynomial, rational};
use dashu_ratio::RBig;

use super::latitude::{RealRoot, RootLatitude, value};
use super::strand::{Piece, runs, samples};

/// J = α + κw² for w² < `reach`.
#[derive(Debug)]
pub(super) struct Quadratic {
    pub alpha: RBig,
    pub kappa: RBig,
    pub reach: RBig,
}

impl Quadratic {
    /// The pieces in U_hl, where (h + w) J ≥ x; `None` when a root cannot be told from an end.
    pub fn pieces(&self, x: &RBig, h: &RBig) -> Option<Vec<Piece<RootLatitude>>> {
        let line = [h.clone(), RBig::ONE];
        let moment = [self.alpha.clone(), RBig::ZERO, self.kappa.clone()];
        let excess = rational::sub(&rational::mul(&line, &moment), std::slice::from_ref(x));
        let polynomial = Polynomial::from_rationals(&excess);
        let mut roots = Vec::new();
        for mut root in RealRoot::all(&polynomial)? {
            if self.reaches(&mut root)? {
                roots.push(root);
            }
        }
        let inside: Vec<bool> = if roots.is_empty() {
            vec![h * &self.alpha >= *x]
        } else {
            let inner = samples(&roots).into_iter().map(|w| self.drawn_in(w, &roots));
            inner.map(|w| value(&excess, &w) > RBig::ZERO).collect()
        };
        let end = |root: Option<usize>| root.map(|root| RootLatitude::Straight(roots[root].clone()));
        Some(runs(&inside).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect())
    }

    /// A sample beyond the outermost root, moved towards it until it lies on the strand.
    fn drawn_in(&self, mut w: RBig, roots: &[RealRoot]) -> RBig {
        let ends = roots.iter().flat_map(RealRoot::range);
        let nearest = ends.min_by_key(|end| {
            let away = end - &w;
            if away < RBig::ZERO { -away } else { away }
        });
        let nearest = nearest.unwrap_or(RBig::ZERO);
        while &w * &w >= self.reach {
            w = (&w + &nearest) / RBig::from(2);
        }
        w
    }

    /// The root lies on the strand.
    fn reaches(&self, root: &mut RealRoot) -> Option<bool> {
        let [lo, hi] = root.range_beside(&self.reach)?;
        Some(&lo * &lo < self.reach && &hi * &hi < self.reach)
    }
}
