//! What holds exactly of a tensor and r, and is kept where its principal form is rounded.
//!
//! The diagram changes its type, or its curves meet in another way, where components of r have certain ratios, where a moment is
//! the mean of the others, and where one of the [`Relation`]s holds; parts with equal entries in their tensors meet these. A body
//! with rounded numbers would lie a hair beside such a border.

use dashu_ratio::RBig;

use super::integrable::is_hess;
use super::rigid_body::Tensor;
use bifdiag_numbers::Number;
use bifdiag_numbers::symmetric::{PrincipalAxes, Real};

/// Makes the ratio of two components of r exact where it is rational, although they are not.
pub(super) fn keep_ratios(found: &PrincipalAxes, center: &mut [RBig; 3]) {
    for k in 1..3 {
        let ratio_to = |i: usize| {
            let (Some(square), Some(other)) = (&found.squares[k], &found.squares[i]) else { return None };
            // The one root of a square that is wanted is exact: no digits.
            let ratio = (!other.is_zero()).then(|| Real::root_of(&(square / other), 0))?;
            ratio.is_exact().then(|| ratio.lo * &center[i])
        };
        if !found.components[k].is_exact()
            && let Some(size) = (0..k).find_map(ratio_to)
        {
            center[k] = if (size < RBig::ZERO) == (center[k] < RBig::ZERO) { size } else { -size };
        }
    }
}

/// Makes the sum of two irrational moments beside a rational one exact, which is rational, so that this one stays their mean
/// where it is.
pub(super) fn keep_trace(tensor: &Tensor, found: &PrincipalAxes, moments: &mut [RBig; 3]) {
    if let Some(k) = (0..3).find(|&k| found.values[k].is_exact()) {
        let [i, j] = others(k);
        moments[j] = tensor.matrix().trace() - &moments[k] - &moments[i];
    }
}

/// A relation between the moments and r in which one moment, A_k, is rational. The other two axes are i and j.
pub(super) struct Relation {
    kind: Kind,
    /// Number of the axis k.
    k: usize,
}

enum Kind {
    /// J_r = rᵀAr/|r|² = A_k: the pole lines and the curve of axis k run side by side.
    PoleLines,
    /// Hess and Appelrot's, where r_k = 0.
    Hess,
    /// The pair over axis k has its cusp at its pitchfork, where r_k = 0: A_k Q = 3P with the sums P, Q and R of
    /// r_i²/(A_i − A_k)ⁿ for n = 1, 2 and 3.
    CuspAtPitchfork,
    /// The curve from which this pair leaves has a cusp at the pitchfork: 4Q² + A_k Q R = 3P R.
    PitchforkAtCusp,
}

impl Relation {
    /// The relation that holds of this tensor, if its body has one and two further components of r.
    pub(super) fn of(tensor: &Tensor, found: &PrincipalAxes) -> Option<Self> {
        let is_zero = |k: usize| found.components[k] == Real::exact(RBig::ZERO);
        let has_weights = |k: usize| others(k).into_iter().all(|i| !is_zero(i));
        let along = tensor.weighted_moment();
        let squared = tensor.center_squared();
        let is_mean = |k: usize| found.values[k].is_exact() && along == &found.values[k].lo * &squared;
        if let Some(k) = (0..3).find(|&k| is_mean(k) && has_weights(k)) {
            return Some(Self { kind: Kind::PoleLines, k });
        }
        let k = (0..3).find(|&k| found.values[k].is_exact() && is_zero(k) && has_weights(k))?;
        if is_hess(tensor.matrix(), tensor.center()) {
            return Some(Self { kind: Kind::Hess, k });
        }
        let a = &found.values[k].lo;
        let [p, q, r] = tensor.sums_at_fork(a)?;
        if a * &q == RBig::from(3) * &p {
            return Some(Self { kind: Kind::CuspAtPitchfork, k });
        }
        let meets = RBig::from(4) * &q * &q + a * &q * &r == RBig::from(3) * p * r;
        meets.then_some(Self { kind: Kind::PitchforkAtCusp, k })
    }

    /// Makes it hold of rounded numbers by a change as small as their rounding: of one of the two other moments or both, also
    /// where they are rational, and, so that these do not become long, of the ratio t = r_i/r_j.
    pub(super) fn impose(&self, found: &PrincipalAxes, moments: &mut [RBig; 3], center: &mut [RBig; 3]) {
        let (k, [i, j]) = (self.k, others(self.k));
        let ratio = &center[i] / &center[j];
        let is_rational = matches!([&found.squares[i], &found.squares[j]],
            [Some(square), Some(other)] if *square == &ratio * &ratio * other);
        let t = if is_rational { ratio } else { rounded(&Real::exact(ratio), Tensor::DIGITS + 1) };
        let turned = &t * &center[j];
        // A ratio to the third component stays as it is.
        if let [Some(square), Some(other)] = [&found.squares[i], &found.squares[k]]
            && square * &center[k] * &center[k] == other * &center[i] * &center[i]
        {
            center[k] = &center[k] * &turned / &center[i];
        }
        center[i] = turned;
        let [w, a_k] = [&t * &t, moments[k].clone()];
        match self.kind {
            // w (A_i − A_k) + A_j − A_k = 0.
            Kind::PoleLines => moments[j] = &a_k - (&moments[i] - &a_k) * w,
            // 1/A_i − 1/A_k + w (1/A_j − 1/A_k) = 0.
            Kind::Hess => {
                let [at_i, at_k] = [&moments[i], &a_k].map(|a| RBig::ONE / a);
                moments[j] = RBig::ONE / (&at_k - (at_i - &at_k) / w);
            }
            Kind::CuspAtPitchfork | Kind::PitchforkAtCusp => {
                let m = (&moments[i] - &a_k) / (&moments[j] - &a_k);
                let m = rounded(&Real::exact(m), Tensor::DIGITS + 1);
                // Up to the factor r_j² these are Pd, Qd² and Rd³, with d = A_i − A_k: the relations are linear in 1/d then.
                let [p, q, r] = [&w + &m, &w + m.sqr(), &w + m.cubic()];
                let along = if let Kind::CuspAtPitchfork = self.kind {
                    &a_k * q / (RBig::from(3) * p)
                } else {
                    &a_k * &q * &r / (RBig::from(3) * p * r - RBig::from(4) * q.sqr())
                };
                moments[j] = &a_k + &along / m;
                moments[i] = a_k + along;
            }
        }
    }
}

/// A decimal of so many significant digits.
pub(super) fn rounded(x: &Real, digits: usize) -> RBig {
    // A decimal always is a rational.
    x.decimal(digits).parse::<Number>().map_or_else(|_| x.lo.clone(), |number| number.value().clone())
}

/// The other two axes.
fn others(k: usize) -> [usize; 2] {
    [[1, 2], [0, 2], [0, 1]][k]
}

#[cfg(test)]
mod tests {
    use bifdiag_numbers::symmetric::Symmetric;
    use proptest::prelude::*;

    use super::*;
    use crate::{Body, IntegrableCase, PrincipalForm};

    fn tensor(matrix: [&str; 6], center: [&str; 3]) -> Tensor {
        let rational = |text: &str| text.parse::<Number>().unwrap().value().clone();
        Tensor::new(Symmetric::new(matrix.map(rational)), center.map(rational)).unwrap()
    }

    /// The principal form of a tensor whose form is rounded.
    fn rounded_form(matrix: [&str; 6], center: [&str; 3]) -> PrincipalForm {
        let form = tensor(matrix, center).principal().unwrap();
        assert!(!form.exact);
        form
    }

    fn values(numbers: &[Number; 3]) -> [RBig; 3] {
        numbers.each_ref().map(|x| x.value().clone())
    }

    /// J_r of the rounded numbers.
    fn mean(body: &Body) -> RBig {
        let [a, r] = [body.moments(), body.center()].map(values);
        let along = (0..3).fold(RBig::ZERO, |sum, k| sum + &a[k] * &r[k] * &r[k]);
        along / r.iter().fold(RBig::ZERO, |sum, r| sum + r * r)
    }

    #[test]
    fn a_mean_moment_that_is_a_moment_stays_one() {
        for (matrix, center) in [
            (["3", "3", "5", "0", "1", "0"], ["1", "0", "0"]),
            (["1", "1", "1", "0", "0.01", "0"], ["0", "0", "1"]),
            (["1", "1", "1", "0.1", "0.2", "0"], ["0", "0", "1"]),
            (["4/3", "4/3", "2", "0", "1/3", "0"], ["1/7", "0", "0"]),
            // A = (1, 2, 4) and r₁² = 2 r₃²: all moments are rational, and the ratio of the components is not.
            (["5/2", "5/2", "2", "1/2", "1", "1"], ["2", "2", "-1"]),
        ] {
            let form = rounded_form(matrix, center);
            let moments = values(form.body.moments());
            assert!(moments.contains(&mean(&form.body)), "{matrix:?}");
            assert_eq!(mean(&form.body), form.body.weighted_moment() / form.body.center_squared());
        }
    }

    #[test]
    fn a_moment_that_is_the_mean_of_the_others_stays_it() {
        let form = rounded_form(["5", "5", "5", "1", "0", "1"], ["1", "-1", "1"]);
        let [first, second, third] = values(form.body.moments());
        assert_eq!((first + third, second), (RBig::from(10), RBig::from(5)));
    }

    #[test]
    fn components_with_a_rational_ratio_keep_it() {
        let form = tensor(["1", "1", "1", "0", "0.01", "0"], ["0", "0", "1"]).principal().unwrap();
        let [x, y, z] = values(form.body.center());
        assert_eq!((&x + &z, y), (RBig::ZERO, RBig::ZERO));
        assert_ne!(x.sqr() * RBig::from(2), RBig::ONE);
        // A = (5 − √0.13, 5, 5 + √0.13) and r = (−1, 0, 1)/√2, up to signs.
        let form = tensor(["5", "5", "5", "0.3", "0.2", "0"], ["1", "0", "0"]).principal().unwrap();
        let [x, y, z] = values(form.body.center());
        assert_eq!((x.sqr(), y), (z.sqr(), RBig::ZERO));
        // 1 + v vᵀ with v = (1, 1, 0): along v and across it the components of (2, 1, 0) are 3 and 1, by √2.
        let form = tensor(["2", "2", "1", "1", "0", "0"], ["2", "1", "0"]).principal().unwrap();
        let [first, _, last] = values(form.body.center());
        assert_eq!(last / first, RBig::from(3));
    }

    /// A brick that is held beside its centre.
    #[test]
    fn hess_and_appelrots_case_stays_one() {
        let form = rounded_form(["2", "17", "17", "0", "-3", "0"], ["4", "0", "1"]);
        for body in [form.body.clone(), Body::new(form.body.moments().clone(), form.body.center().clone()).unwrap()] {
            assert_eq!(IntegrableCase::of(&body), [IntegrableCase::HessAppelrot]);
        }
    }

    /// A_k of the axis across r, and P, Q and R there.
    fn sums(body: &Body) -> (RBig, [RBig; 3]) {
        let [a, r] = [body.moments(), body.center()].map(values);
        let k = (0..3).find(|&k| r[k].is_zero()).unwrap();
        let sum = |n: isize| others(k).into_iter().fold(RBig::ZERO, |sum, i| sum + r[i].sqr() / (&a[i] - &a[k]).pow(n));
        (a[k].clone(), [1, 2, 3].map(sum))
    }

    #[test]
    fn a_cusp_at_a_pitchfork_stays_there() {
        for (matrix, center) in [
            (["2", "4", "3", "1", "0", "0"], ["0", "1", "0"]),
            (["4", "3", "3", "1/2", "0", "0"], ["4", "2", "0"]),
            (["4", "2", "3", "1", "0", "0"], ["4", "4", "0"]),
            (["8", "5", "6", "1", "0", "0"], ["8", "4", "0"]),
            // A = (3, 11/3, 5) and r₃² = 3 r₂²: all moments are rational, and the ratio of the components is not.
            (["37/9", "37/9", "31/9", "-8/9", "-2/9", "-2/9"], ["2", "-1", "-1"]),
        ] {
            let form = rounded_form(matrix, center);
            let (a, [p, q, _]) = sums(&form.body);
            assert_eq!(a * q, RBig::from(3) * p, "{matrix:?}");
        }
    }

    #[test]
    fn a_pitchfork_at_a_cusp_stays_there() {
        for (matrix, center) in
            [(["5", "4", "4", "1", "0", "0"], ["1", "0", "0"]), (["4", "5", "4", "1", "0", "0"], ["2", "1", "0"])]
        {
            let form = rounded_form(matrix, center);
            let (a, [p, q, r]) = sums(&form.body);
            assert_eq!(RBig::from(4) * q.sqr() + a * q * &r, RBig::from(3) * p * r, "{matrix:?}");
        }
    }

    proptest! {
        /// r along an axis of the part with a moment that an axis across it has, too.
        #[test]
        fn parts_with_equal_entries_keep_the_relation(a in 1_i32..40, b in 1_i32..40, x in 1_i32..40, weight in 1_i32..9) {
            let [a, b, x] = [a, b, x].map(RBig::from);
            let matrix = Symmetric::new([a.clone(), a.clone(), b, RBig::ZERO, x, RBig::ZERO]);
            let Ok(tensor) = Tensor::new(matrix, [weight, 0, 0].map(RBig::from)) else { return Ok(()) };
            let form = tensor.principal().unwrap();
            let [moments, center] = [form.body.moments(), form.body.center()].map(values);
            if !center[1].is_zero() || center[0].is_zero() || center[2].is_zero() {
                return Ok(());
            }
            prop_assert_eq!(mean(&form.body), a);
            prop_assert!(form.exact || moments[0] < moments[1] && moments[1] < moments[2]);
        }
    }
}
