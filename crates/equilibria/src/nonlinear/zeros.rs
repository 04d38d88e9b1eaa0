//! All zeros of Arnold's determinant on a stretch of a family.
//!
//! N = (D₄/s) χ² (β² − 4χ)(4β² − 25χ) p⁹, on an axis (D₄/s) χ (β² − 4χ), is a polynomial in the parameter of a family, of a degree that is known (Theorem
//! 13.13 of docs/algorithms.md). Enclosed values at one place more than that determine it, and Descartes' rule isolates its
//! zeros: none is missed, however close to an end of the stretch.

use dashu_ratio::RBig;

use super::normal_form::NormalForm;
use super::reduced_hamiltonian::farthest;
use super::taylor::taylor;
use crate::stability::exact::{ExactBody, Family, FamilyChart};
use crate::stability::{Constants, Reduced};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::form::EnclosedForm;
use bifdiag_numbers::wide::{Interval128, Interval384, Interval1024};

/// The zeros of D₄ between two places of a family inside of which it is elliptic, by rising t, as they are judged from ranges of
/// t that hold one each; `None` where enclosures do not isolate all of them, or one is at an end. A range that is not
/// judged (`None`) is narrowed as far as possible; `judged` is informed when it is the last one.
pub(super) fn zeros<T>(
    body: &ExactBody,
    chart: &FamilyChart,
    range: [&RBig; 2],
    judged: impl Fn(&[RBig; 2], bool) -> Option<T>,
) -> Option<Vec<T>> {
    let all = |zeros: Vec<[RBig; 2]>, is_last: bool| zeros.iter().map(|zero| judged(zero, is_last)).collect();
    if let Some(found) = enclosed::<Interval128>(body, chart, range).and_then(|zeros| all(zeros, false)) {
        return Some(found);
    }
    let bits = bits_that_part(body, chart, range);
    let medium = if bits <= 384 { enclosed::<Interval384>(body, chart, range) } else { None };
    medium.and_then(|zeros| all(zeros, false)).or_else(|| all(enclosed::<Interval1024>(body, chart, range)?, true))
}

/// About as many bits as part N from 0 at the ends: interpolation costs two for each degree at most, and beside special bodies N
/// is smaller there by many orders than inside.
fn bits_that_part(body: &ExactBody, chart: &FamilyChart, [lo, hi]: [&RBig; 2]) -> usize {
    let c: Constants<Interval128> = body.constants(());
    let known = chart.zeros_of_degeneracy(body);
    let near = RBig::ONE / RBig::from(1u64 << 40);
    let half = RBig::ONE / RBig::from(2);
    let value = |u: &RBig| rest(body, chart, &c, &known, &(lo + (hi - lo) * u));
    let Some(inside) = value(&half) else { return 0 };
    let ends = [near.clone(), RBig::ONE - near];
    let apart = ends.iter().filter_map(|u| {
        let [from, to] = (value(u)? / inside.clone()).bounds();
        let (_, exponent) = libm::frexp(from.abs().max(to.abs()));
        usize::try_from(-exponent).ok()
    });
    2 * (chart.degree_of_determinant(body) - known.len()) + apart.max().unwrap_or(0)
}

fn enclosed<E>(body: &ExactBody, chart: &FamilyChart, [lo, hi]: [&RBig; 2]) -> Option<Vec<[RBig; 2]>>
where
    E: Enclosure<Precision = ()>,
{
    let c: Constants<E> = body.constants(());
    let known = chart.zeros_of_degeneracy(body);
    let degree = chart.degree_of_determinant(body) - known.len();
    let width = hi - lo;
    let places: Vec<RBig> =
        spread_places(degree + 1).into_iter().map(|u| RBig::try_from(u).unwrap_or(RBig::ZERO)).collect();
    let values = places.iter().map(|u| rest(body, chart, &c, &known, &(lo + &width * u)));
    let values: Vec<E> = values.collect::<Option<_>>()?;
    let places: Vec<E> = places.iter().map(|u| E::rational(u, ())).collect();
    let roots = EnclosedForm::through(&places, &values).simple_roots()?;
    let range = |root: E| root.exact_bounds().map(|ends| ends.map(|u| lo + &width * u));
    roots.into_iter().map(range).collect()
}

/// Chebyshev nodes in (0, 1), rounded, ordered so that each initial segment is spread over all of them: by their
/// numbers with the binary digits reversed. Through values at these places `EnclosedForm::through` loses less than two
/// bits for each degree.
fn spread_places(count: usize) -> Vec<f64> {
    let bits = count.next_power_of_two().trailing_zeros();
    let reversed = |k: usize| (0..bits).fold(0, |number, bit| number << 1 | (k >> bit & 1));
    let node = |k: usize| {
        let sine = libm::sin(std::f64::consts::FRAC_PI_4 * (2 * k + 1) as f64 / count as f64);
        sine * sine
    };
    (0..1 << bits).map(reversed).filter(|number| *number < count).map(node).collect()
}

/// N divided by its zeros that are not zeros of the determinant.
fn rest<E>(body: &ExactBody, chart: &FamilyChart, c: &Constants<E>, known: &[RBig], t: &RBig) -> Option<E>
where
    E: Enclosure<Precision = ()>,
{
    let distance = known.iter().fold(RBig::ONE, |product, zero| product * (t - zero));
    Some(numerator(body, chart, c, t)? / E::rational(&distance, ()))
}

/// N at t, where there are two distinct imaginary pairs.
fn numerator<E>(body: &ExactBody, chart: &FamilyChart, c: &Constants<E>, t: &RBig) -> Option<E>
where
    E: Enclosure<Precision = ()>,
{
    let state = chart.state_over(body, c, [t, t]);
    let reduced = Reduced::new(c, &state);
    let [beta, chi] = reduced.coefficients();
    let determinant = NormalForm::arnold(&taylor(c, &state, farthest(&state)), beta, chi, ())?;
    let axis = determinant * chi.clone() * reduced.discriminant().clone();
    if body.active.len() == 1 && matches!(chart.family, Family::Generic(_)) {
        return Some(axis);
    }
    let small = |value| E::small(value, ());
    let resonance = small(4) * beta.square() - small(25) * chi.clone();
    let cube = |x: &E| x.square() * x.clone();
    let weight = cube(&cube(&chart.total(t, ())));
    Some(axis * chi.clone() * resonance * weight)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_numbers::enclosure::Arithmetic;

    fn rational(p: i32, q: u32) -> RBig {
        RBig::from_parts(p.into(), q.into())
    }

    /// A polynomial of degree 45 with simple roots all over (0, 1), from values of 128 bits.
    #[test]
    fn a_high_degree_takes_few_bits_at_spread_places() {
        let planted: Vec<RBig> = (1..=45).map(|k| rational(2 * k + 1, 97)).collect();
        let value =
            |u: &RBig| Interval128::rational(&planted.iter().fold(RBig::ONE, |product, x| product * (u - x)), ());
        let places: Vec<RBig> = spread_places(46).into_iter().map(|u| RBig::try_from(u).unwrap()).collect();
        let values: Vec<Interval128> = places.iter().map(value).collect();
        let places: Vec<Interval128> = places.iter().map(|u| Interval128::rational(u, ())).collect();
        let found = EnclosedForm::through(&places, &values).simple_roots().unwrap();
        assert_eq!(found.len(), planted.len());
        for (range, root) in found.iter().zip(&planted) {
            let [lo, hi] = range.exact_bounds().unwrap();
            assert!(lo <= *root && *root <= hi && hi - lo < rational(1, 1_000_000_007), "{range:?}");
        }
    }
}
