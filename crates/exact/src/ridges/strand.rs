//! Ridges and valleys of J over the latitudes, and their pieces inside U_hl.
//!
//! Pieces of ridges, put together.
//!
//! Staude's curve γ = ± adj(μ − A) r/√p, cut by the level U = h.
//!
//! Strands on which J is a quadratic function of w: J = α + κw².

use std::cmp::Ordering::Less;

use super::latitude::{Latitude, RealRoot, RootLatitude, value};
use bifdiag_diagram::topology::{Component, Poles, sort_components};
use bifdiag_numbers::polynomial::{Polynomial, rational};
use bifdiag_numbers::table::Partition;
use dashu_ratio::RBig;

/// A piece of a strand in U_hl by rising w; `None`: it reaches that end of its strand.
#[derive(Clone, Debug)]
pub(super) struct Piece<L> {
    pub ends: [Option<L>; 2],
}

impl<L: Latitude> Piece<L> {
    /// A latitude within the strand lies on this piece; `None` when it cannot be separated from an end.
    pub fn holds(&self, latitude: &L) -> Option<bool> {
        let [low, high] = &self.ends;
        let above = low.as_ref().map_or(Some(true), |low| Some(low.compare(latitude)? == Less))?;
        let below = high.as_ref().map_or(Some(true), |high| Some(latitude.compare(high)? == Less))?;
        Some(above && below)
    }

    pub fn reaches(&self, end: usize) -> bool {
        self.ends[end].is_none()
    }

    /// Euler's characteristic with compact support, where `open` says which ends do not belong to the strand.
    pub fn characteristic(&self, open: [bool; 2]) -> i32 {
        1 - (0..2).map(|end| i32::from(open[end] && self.reaches(end))).sum::<i32>()
    }
}

/// The maximal runs of gaps that are inside, as pairs of the roots at their ends.
pub(super) fn runs(inside: &[bool]) -> Vec<[Option<usize>; 2]> {
    let mut found: Vec<[Option<usize>; 2]> = Vec::new();
    for (gap, _) in inside.iter().enumerate().filter(|(_, inside)| **inside) {
        let (before, after) = (gap.checked_sub(1), (gap + 1 < inside.len()).then_some(gap));
        match found.last_mut() {
            Some(last) if gap > 0 && last[1] == before => last[1] = after,
            _ => found.push([before, after]),
        }
    }
    found
}

/// A rational in each gap between ascending isolated roots.
pub(super) fn samples(roots: &[RealRoot]) -> Vec<RBig> {
    let ranges: Vec<[RBig; 2]> = roots.iter().map(RealRoot::range).collect();
    let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else { return vec![RBig::ZERO] };
    let mut found = vec![&first[0] - RBig::ONE];
    found.extend(ranges.windows(2).map(|pair| (&pair[0][1] + &pair[1][0]) / RBig::from(2)));
    found.push(&last[1] + RBig::ONE);
    found
}

/// Components of U_hl while they are put together: pieces of ridges, joined.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    /// For each: Euler's characteristic and the poles in it.
    nodes: Vec<(i32, [bool; 2])>,
    links: Vec<[usize; 2]>,
}

impl Pieces {
    pub fn add(&mut self, characteristic: i32, poles: [bool; 2]) -> usize {
        self.nodes.push((characteristic, poles));
        self.nodes.len() - 1
    }

    pub fn join(&mut self, p: usize, q: usize) {
        self.links.push([p, q]);
    }

    /// The components, in canonical order; `None` if one is no part of a sphere.
    pub fn components(&self) -> Option<Vec<Component>> {
        let mut classes = Partition::new(self.nodes.len());
        for &[p, q] in &self.links {
            classes.unite(p, q);
        }
        let mut sums = vec![(0, [false; 2]); self.nodes.len()];
        let mut roots = Vec::new();
        for (node, (characteristic, poles)) in self.nodes.iter().enumerate() {
            let root = classes.find(node);
            if !roots.contains(&root) {
                roots.push(root);
            }
            sums[root].0 += characteristic;
            sums[root].1 = [sums[root].1[0] || poles[0], sums[root].1[1] || poles[1]];
        }
        let components = roots.into_iter().map(|root| {
            let (characteristic, [plus, minus]) = sums[root];
            let boundary_circles = u32::try_from(2 - characteristic).ok()?;
            Some(Component { boundary_circles, poles: Some(Poles { plus, minus }) })
        });
        let mut components: Vec<Component> = components.collect::<Option<_>>()?;
        sort_components(&mut components);
        Some(components)
    }
}

/// The curve's ridges and valleys, with what is inside U_hl. Its two signs are images of each other under γ → −γ.
#[derive(Debug)]
pub(super) struct Cut<L> {
    /// ω of the positive sign where U = h on either sign of the curve, by rising μ, without the fold.
    pub roots: Vec<L>,
    /// So many roots lie below the fold.
    pub valley_roots: usize,
    /// ω of the positive sign where ridge and valley meet.
    pub fold: L,
    /// For each sign, whether the gaps between roots and fold lie in U_hl.
    pub inside: [Vec<bool>; 2],
}

impl<L: Latitude> Cut<L> {
    /// Pieces of the ridge, μ above the fold, in terms of ω, which rises with μ: the lower end is the fold, the upper the
    /// pole.
    pub fn ridges(&self, sign: usize) -> Vec<Piece<L>> {
        Self::pieces(&self.roots[self.valley_roots..], &self.inside[sign][self.valley_roots + 1..])
    }

    /// Pieces of the valley, by rising μ: the upper end is the fold.
    pub fn valleys(&self, sign: usize) -> Vec<Piece<L>> {
        Self::pieces(&self.roots[..self.valley_roots], &self.inside[sign][..=self.valley_roots])
    }

    fn pieces(roots: &[L], gaps: &[bool]) -> Vec<Piece<L>> {
        let end = |root: Option<usize>| root.map(|root| roots[root].clone());
        runs(gaps).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect()
    }
}

/// J = α + κw² for w² < `reach`.
#[derive(Debug)]
pub(super) struct Quadratic {
    pub alpha: RBig,
    pub kappa: RBig,
    pub reach: RBig,
}

impl Quadratic {
    /// The pieces in U_hl, where (h + w) J ≥ x; `None` when a root cannot be separated from an end.
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
            let inner = samples(&roots).into_iter().map(|w| self.converted_in(w, &roots));
            inner.map(|w| value(&excess, &w) > RBig::ZERO).collect()
        };
        let end = |root: Option<usize>| root.map(|root| RootLatitude::Straight(roots[root].clone()));
        Some(runs(&inside).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect())
    }

    /// A sample beyond the outermost root, moved towards it until it lies on the strand.
    fn converted_in(&self, mut w: RBig, roots: &[RealRoot]) -> RBig {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_maximal() {
        assert_eq!(runs(&[true, true, false, true]), [[None, Some(1)], [Some(2), None]]);
        assert_eq!(runs(&[false, true, false]), [[Some(0), Some(1)]]);
        assert_eq!(runs(&[true]), [[None, None]]);
        assert_eq!(runs(&[false]), [[None::<usize>; 2]; 0]);
    }
}
