//! The difference of the heights of two curves over the same x.

use crate::equilibria::places::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;

impl Spaces {
    /// h_a − h_b over x: the difference of the heights, and for two equilibria also x times [`Spaces::range_gap`].
    /// `None` when it cannot be enclosed, or when two enclosures contradict each other.
    pub fn gap(&self, x: &Fixed, a: &Point, b: &Point) -> Option<Fixed> {
        let moment = self.moment_difference(a, b)?;
        let plain = &-&(x * &moment).over(&(&a.j * &b.j))? - &(&a.rho - &b.rho);
        match identity(a, b, &moment) {
            Some(exact) => plain.meet(&(x * &exact)),
            None => Some(plain),
        }
    }

    /// (h_a − h_b)/x over ranges of equilibria.
    pub fn range_gap(&self, a: &Point, b: &Point) -> Option<Fixed> {
        identity(a, b, &self.moment_difference(a, b)?)
    }

    /// J_a − J_b, also as Σ (γ_a − γ_b)(γ_a + γ_b)(a − a_base); `None` when these contradict each other.
    fn moment_difference(&self, a: &Point, b: &Point) -> Option<Fixed> {
        let factors: Vec<Fixed> = a.gamma.iter().zip(&b.gamma).map(|(p, q)| &(p - q) * &(p + q)).collect();
        (0..self.list.len()).try_fold(&a.j - &b.j, |best, base| {
            let terms = factors.iter().enumerate().map(|(k, factor)| factor * self.difference(k, base));
            best.meet(&terms.fold(Fixed::whole(0), |sum, term| &sum + &term))
        })
    }

    /// J_a − J_b and (h_a − h_b)/x of two equilibria over the same x, each anywhere in its range (Lemma 7.8): with
    /// g = μ − a_k of one sign for both, u from γ_k² and j from J,
    /// (J_a − J_b)(1 − 4(a_k − a_m)u/j) = Σ (a_i − a_m)(γ_i² − γ′_i²) − 2(a_k − a_m)u(μ_a − μ_b)/g over the i but k and m.
    pub fn over_one_x(&self, a: &Point, b: &Point) -> Option<[Fixed; 2]> {
        let (p, q) = (a.tau.as_ref()?, b.tau.as_ref()?);
        let mut moment = self.moment_difference(a, b)?;
        let squares: Vec<Fixed> = a.gamma.iter().zip(&b.gamma).map(|(p, q)| &p.square() - &q.square()).collect();
        let j = a.j.hull(&b.j);
        for &k in &self.active {
            let u = a.gamma[k].square().hull(&b.gamma[k].square());
            let Some(shift) = (&(&p[0] - &q[0]) * &(&u * &Fixed::whole(2))).over(&p[k].hull(&q[k])) else {
                continue;
            };
            for m in (0..self.list.len()).filter(|&m| m != k) {
                let lever = self.difference(k, m);
                let others = (0..self.list.len()).filter(|&i| i != k && i != m);
                let rest = others.fold(Fixed::whole(0), |sum, i| &sum + &(self.difference(i, m) * &squares[i]));
                let factor = &Fixed::whole(1) - &(&(lever * &u) * &Fixed::whole(4)).over(&j)?;
                if let Some(found) = (&rest - &(lever * &shift)).over(&factor) {
                    moment = moment.meet(&found)?;
                }
            }
        }
        let gap = identity(a, b, &moment)?;
        Some([moment, gap])
    }
}

/// Corollary 3.10, for two equilibria over the same x:
/// (h_a − h_b)/x = [(μ_b − μ_a)|γ_a − γ_b|² − (J_a − J_b)³/(J_a J_b)]/(J_a² + J_b²).
fn identity(a: &Point, b: &Point, moment: &Fixed) -> Option<Fixed> {
    let (p, q) = (a.tau.as_ref()?, b.tau.as_ref()?);
    let mu = &q[0] - &p[0];
    let distance = a.gamma.iter().zip(&b.gamma).fold(Fixed::whole(0), |sum, (p, q)| &sum + &(p - q).square());
    let cube = (moment * &moment.square()).over(&(&a.j * &b.j))?;
    (&(&mu * &distance) - &cube).over(&(&a.j.square() + &b.j.square()))
}

#[cfg(test)]
mod tests {
    use dashu_ratio::RBig;

    use super::*;
    use crate::equilibria::places::Side;
    use crate::equilibria::spaces::Body;

    fn spaces() -> Spaces {
        let body = Body {
            moments: [RBig::from(2), RBig::from_parts(11.into(), 10u8.into()), RBig::ONE],
            center: [RBig::ONE, RBig::ONE, RBig::from(2)],
        };
        Spaces::new(&body, [RBig::ONE, RBig::ONE], 256).unwrap()
    }

    #[test]
    fn a_contradiction_between_enclosures_is_no_gap() {
        let spaces = spaces();
        let point = |y: i32| spaces.point(2, Side::Plus, &Fixed::whole(y)).unwrap();
        let (a, mut b) = (point(1), point(2));
        assert!(spaces.range_gap(&a, &b).is_some());
        // A moment of inertia that is not that of its γ.
        b.j = &b.j + &Fixed::whole(1);
        assert!(spaces.moment_difference(&a, &b).is_none());
        assert!(spaces.range_gap(&a, &b).is_none() && spaces.gap(&Fixed::whole(1), &a, &b).is_none());
    }
}
