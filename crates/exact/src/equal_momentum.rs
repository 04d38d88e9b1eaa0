//! Differences of two relative equilibria over one x: of energies, moments of inertia and multipliers, without the
//! cancellation of the numbers themselves.

use super::evaluator::{Evaluator, Point};
use super::family::State;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// J − J' of two points or ranges, the narrowest over all moments to measure from.
    pub fn moment_difference(&self, p: &State<E>, q: &State<E>) -> E {
        let n = self.model.groups.len();
        let squares: Vec<E> = (0..n)
            .map(|k| (p.gamma[k].clone() - q.gamma[k].clone()) * (p.gamma[k].clone() + q.gamma[k].clone()))
            .collect();
        let about = |base: usize| {
            (0..n)
                .filter(|&k| k != base)
                .fold(self.c.small(0), |sum, k| sum + squares[k].clone() * self.c.diff[k][base].clone())
        };
        let plain = p.j.clone() - q.j.clone();
        (0..n).fold(plain, |best, base| self.c.common(&best, &about(base)))
    }

    /// h_a − h_b over one x.
    pub fn gap(&self, a: &Point<E>, b: &Point<E>) -> E {
        let x = self.c.common(&a.x, &b.x);
        let difference = self.moment_difference(&b.at, &a.at);
        let kinetic = x.clone() * difference / (a.at.j.clone() * b.at.j.clone());
        let plain = kinetic - (a.at.rho.clone() - b.at.rho.clone()) + a.correction.clone() - b.correction.clone();
        if a.critical && b.critical { self.c.common(&plain, &self.exact_gap(&x, &a.over, &b.over)) } else { plain }
    }

    /// h_a − h_b of two critical points over one x, without the cancellation of heights (Corollary 3.10 of
    /// docs/mathematics.md):
    /// h_a − h_b = x [(μ_b − μ_a)|γ_a − γ_b|² − (J_a − J_b)³/(J_a J_b)]/(J_a² + J_b²).
    ///
    /// From U(γ') − U(γ) = (s/2)[⟨γ'−γ, (μ−A)(γ'−γ)⟩ + (J'−J)²/J'], which holds for a critical γ and every γ' on the
    /// sphere, taken in both directions.
    fn exact_gap(&self, x: &E, a: &State<E>, b: &State<E>) -> E {
        self.gap_with(x, a, b, &self.moment_difference(a, b))
    }

    /// The same with a given enclosure of J_a − J_b.
    fn gap_with(&self, x: &E, a: &State<E>, b: &State<E>, moment: &E) -> E {
        let n = self.model.groups.len();
        let distance = (0..n).fold(self.c.small(0), |sum, k| sum + (a.gamma[k].clone() - b.gamma[k].clone()).square());
        let cube = moment.clone() * moment.square() / (a.j.clone() * b.j.clone());
        let mu = self.multiplier_difference(b, a);
        x.clone() * (mu * distance - cube) / (a.j.square() + b.j.square())
    }

    /// μ_a − μ_b, the narrowest over all moments to measure from.
    pub fn multiplier_difference(&self, a: &State<E>, b: &State<E>) -> E {
        let about = |base: usize| a.tau[base].clone() - b.tau[base].clone();
        (1..self.model.groups.len()).fold(about(0), |best, base| self.c.common(&best, &about(base)))
    }

    /// The sign of h_a − h_b all over two ranges of states that hold the points over the same x, by the same identity.
    pub fn range_sign(&self, a: &State<E>, b: &State<E>) -> Option<Sign> {
        self.range_sign_with(a, b, &self.moment_difference(a, b))
    }

    /// The same with a given enclosure of J_a − J_b over these ranges.
    pub fn range_sign_with(&self, a: &State<E>, b: &State<E>, moment: &E) -> Option<Sign> {
        self.gap_with(&self.c.small(1), a, b, moment).strict_sign()
    }

    /// J_a − J_b of two critical points over the same x, each anywhere in its range, the narrowest over all a_k and a_j of
    /// Lemma 7.8 of docs/algorithms.md: as small as μ and the moments between them are close, however wide the ranges are.
    pub fn moments_at_equal_momentum(&self, a: &State<E>, b: &State<E>) -> E {
        let c = &self.c;
        let n = self.model.groups.len();
        let squares: Vec<E> = (0..n).map(|i| a.gamma[i].square() - b.gamma[i].square()).collect();
        let (mu, j) = (self.multiplier_difference(a, b), a.j.hull(&b.j));
        let mut best = self.moment_difference(a, b);
        for &k in &self.model.active {
            let tau = a.tau[k].hull(&b.tau[k]);
            if tau.strict_sign().is_none() {
                continue;
            }
            let u = a.gamma[k].square().hull(&b.gamma[k].square());
            let drift = u.clone() * mu.clone() * c.small(2) / tau;
            for base in (0..n).filter(|&base| base != k) {
                let lever = c.diff[k][base].clone();
                let others = (0..n).filter(|&i| i != k && i != base);
                let rest = others.fold(c.small(0), |sum, i| sum + squares[i].clone() * c.diff[i][base].clone());
                let factor = c.small(1) - lever.clone() * u.clone() * c.small(4) / j.clone();
                best = c.common(&best, &((rest - lever * drift.clone()) / factor));
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::Curves;
    use crate::model::Model;
    use bifdiag_body::Body;
    use bifdiag_equilibria::curves::CurveId;
    use bifdiag_numbers::enclosure::Arithmetic;
    use bifdiag_numbers::interval::Interval;
    use bifdiag_numbers::wide::Interval128;

    /// Over a range of x the enclosure holds the difference at an x inside, and where moments are close it is mostly much
    /// narrower than the range of either J.
    #[test]
    fn the_difference_of_moments_over_a_range_holds_that_at_each_x() {
        let (mut compared, mut narrow) = (0, 0);
        for (a, r) in [
            (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
            (["1", "1.0000001", "1.9"], ["3e-8", "5e-8", "1"]),
            (["1", "1.0000001", "0.4"], ["1e-7", "0", "1"]),
        ] {
            let body = Body::parse(&a, &r).unwrap();
            let model = Model::new(&body, &body.frame());
            let curves = Curves::of(&model).unwrap();
            let coarse = Evaluator::<Interval>::new(&model, &curves, &[], ());
            let fine = Evaluator::<Interval128>::new(&model, &curves, &[], ());
            for x in [0.9, 1.7, 3.0, 20.0] {
                let over = |curve: CurveId| {
                    let [p, q] = [x, 1.05 * x].map(|x| coarse.point(curve, &Interval::double(x, ())));
                    let ((half, y), (other, z)) = (p?.place?, q?.place?);
                    (half == other).then(|| coarse.state(half, &y.hull(&z)))
                };
                let inside = |curve: CurveId| fine.point(curve, &Interval128::double(1.02 * x, ()));
                let known: Vec<_> = curves.list.ids().filter_map(|c| Some((over(c)?, inside(c)?.over))).collect();
                for (n, (p, at_p)) in known.iter().enumerate() {
                    for (q, at_q) in &known[..n] {
                        let [lo, hi] = coarse.moments_at_equal_momentum(p, q).bounds();
                        let [below, above] = (at_p.j.clone() - at_q.j.clone()).bounds();
                        assert!(lo <= above && below <= hi, "{a:?} {r:?} {x}: [{below}, {above}] outside [{lo}, {hi}]");
                        let [first, last] = p.j.bounds();
                        narrow += usize::from(hi - lo < 1e-3 * (last - first));
                        compared += 1;
                    }
                }
            }
        }
        assert!(compared > 20 && narrow >= 5, "{compared} {narrow}");
    }
}
