//! The difference of the moments of inertia of two relative equilibria over one x, from ranges that hold both (Lemma 7.8
//! of docs/mathematics.md): as small as μ and the moments between them are close, however wide the ranges are.

use super::family::State;
use super::point::Evaluator;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// J_a − J_b of two critical points over the same x, each anywhere in its range, the narrowest over all a_k and a_j of
    /// the lemma.
    pub fn moments_over_one_x(&self, a: &State<E>, b: &State<E>) -> E {
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
                        let [lo, hi] = coarse.moments_over_one_x(p, q).bounds();
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
