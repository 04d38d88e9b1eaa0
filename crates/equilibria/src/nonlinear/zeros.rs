//! All zeros of Arnold's determinant on a stretch of a family.
//!
//! N = (D₄/s) χ² (β² − 4χ)(4β² − 25χ) p⁹, on an axis (D₄/s) χ (β² − 4χ), is a polynomial in the parameter of a family, of a degree that is known (Theorem
//! 13.13 of docs/algorithms.md). Enclosed values at one place more than that determine it, and Descartes' rule isolates its
//! zeros: none is missed, however close to an end of the stretch.

use dashu_ratio::RBig;

use super::judge::{MAXIMUM, Question};
use crate::stability::exact::{ExactBody, Family, FamilyChart};
use crate::stability::{Constants, LinearType, Reduced};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::form::EnclosedForm;
use bifdiag_numbers::wide::{Interval384, Interval1024};

/// The zeros of D₄ between two places of a family inside of which it is elliptic, by rising t, in ranges of t; `None` where
/// enclosures do not isolate all of them, or one is at an end.
pub(super) fn zeros(body: &ExactBody, chart: &FamilyChart, range: [&RBig; 2]) -> Option<Vec<[RBig; 2]>> {
    // Interpolation costs three bits for each degree at most; beside special bodies N has many sizes.
    enclosed::<Interval384>(body, chart, range).or_else(|| enclosed::<Interval1024>(body, chart, range))
}

fn enclosed<E>(body: &ExactBody, chart: &FamilyChart, [lo, hi]: [&RBig; 2]) -> Option<Vec<[RBig; 2]>>
where
    E: Enclosure<Precision = ()>,
{
    let c: Constants<E> = body.constants(());
    let known = chart.zeros_of_degeneracy(body);
    let degree = chart.degree_of_determinant(body) - known.len();
    let width = hi - lo;
    let places: Vec<RBig> = (0..=degree).map(|k| place(k, degree)).collect();
    let values = places.iter().map(|u| {
        let t = lo + &width * u;
        let distance = known.iter().fold(RBig::ONE, |product, zero| product * (&t - zero));
        Some(numerator(body, chart, &c, &t)? / E::rational(&distance, ()))
    });
    let values: Vec<E> = values.collect::<Option<_>>()?;
    let places: Vec<E> = places.iter().map(|u| E::rational(u, ())).collect();
    let roots = EnclosedForm::through(&places, values).simple_roots()?;
    let range = |root: E| root.exact_bounds().map(|ends| ends.map(|u| lo + &width * u));
    roots.into_iter().map(range).collect()
}

/// Node k of Chebyshev's, rounded, in (0, 1).
fn place(k: usize, degree: usize) -> RBig {
    let angle = std::f64::consts::FRAC_PI_4 * (2 * k + 1) as f64 / (degree + 1) as f64;
    let sine = libm::sin(angle);
    RBig::try_from(sine * sine).unwrap_or(RBig::ZERO)
}

/// N at t, where there are two distinct imaginary pairs.
fn numerator<E>(body: &ExactBody, chart: &FamilyChart, c: &Constants<E>, t: &RBig) -> Option<E>
where
    E: Enclosure<Precision = ()>,
{
    let state = chart.state_over(body, c, [t, t]);
    let reduced = Reduced::new(c, &state);
    let question = Question { c, state: &state, reduced: &reduced, kind: LinearType::Elliptic, setting: MAXIMUM };
    let determinant = question.normal_form()?.arnold;
    let [beta, chi] = reduced.coefficients();
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
