//! The Taylor series of the reduced Hamiltonian from closed forms of its factors, for where it is needed at many places.
//!
//! In the coordinates of [`reduced_hamiltonian`](super::reduced_hamiltonian()), with p = p_ϑ, q = p_φ,
//!
//! H = ½((σ + C)m² − 2S mp + (σ − C)p² + q²/A₃) − ⟨γ, r⟩, m = l/sin ϑ − q cot ϑ,
//!
//! where 2σ = 1/A₁ + 1/A₂ and C, S are cos 2φ, sin 2φ times ½(1/A₂ − 1/A₁).

use bifdiag_body::Axis;
use bifdiag_numbers::enclosure::Enclosure;

use super::series::{DEGREE, Exponents, Series, of_degree};
use crate::stability::{Constants, State};

type Taylor<E> = [E; DEGREE + 1];

/// H/s up to degree four, without its constant and its linear terms.
#[must_use]
pub fn taylor<E: Enclosure>(c: &Constants<E>, state: &State<E>, axis: Axis) -> Series<E> {
    let small = |value| E::small(value, c.precision);
    let axes = [axis.next(), axis.next().next(), axis];
    let [first, second, third] = axes;
    let gamma = axes.map(|k| state.gamma[k].clone());
    let inverse = axes.map(|k| c.inverse[k].clone());
    let share = [2, 3, 4].map(|n| small(1) / small(n));
    let half = share[0].clone();
    let rho = (state.w[first].clone() + state.w[second].clone()).sqrt();
    let over_rho = small(1) / rho.clone();
    let [sine, cosine] = [0, 1].map(|k| gamma[k].clone() * over_rho.clone());
    // Of p_ϑ and p_φ at the equilibrium.
    let turning = c.diff[first][second].clone() * gamma[0].clone() * cosine.clone();
    let vertical = c.a[third].clone() * gamma[2].clone();

    // 1/sin ϑ and cot ϑ: y′ = −yz, z′ = −1 − z².
    let mut csc: Taylor<E> = std::array::from_fn(|_| over_rho.clone());
    let mut cot: Taylor<E> = std::array::from_fn(|_| gamma[2].clone() * over_rho.clone());
    for n in 0..DEGREE {
        let [y, z] = [&csc, &cot].map(|y| product_at(y, &cot, n));
        let z = if n == 0 { z + small(1) } else { z };
        [csc[n + 1], cot[n + 1]] = [y, z].map(|slope| if n == 0 { -slope } else { -(slope * share[n - 1].clone()) });
    }
    let m: Taylor<E> = std::array::from_fn(|n| state.j.clone() * csc[n].clone() - vertical.clone() * cot[n].clone());
    let squares: Taylor<E> = std::array::from_fn(|n| half.clone() * product_at(&m, &m, n));
    let mixed: Taylor<E> = std::array::from_fn(|n| product_at(&m, &cot, n));
    let inner: Taylor<E> = std::array::from_fn(|n| half.clone() * product_at(&cot, &cot, n));
    let [turned, dragged] = [&m, &cot].map(|y| y.each_ref().map(|y| turning.clone() * y.clone()));

    let scale = half.clone() * c.diff[first][second].clone() * inverse[0].clone() * inverse[1].clone();
    let [skew, even] = circle(
        &(small(2) * sine.clone() * cosine.clone() * scale.clone()),
        &((cosine.square() - sine.square()) * scale),
        &small(2),
        &share,
    );
    let sigma = half.clone() * (inverse[0].clone() + inverse[1].clone());
    let about = |sign: i32| -> Taylor<E> {
        let mut sum = even.each_ref().map(|x| if sign > 0 { x.clone() } else { -x.clone() });
        sum[0] = sum[0].clone() + sigma.clone();
        sum
    };
    let [alpha, epsilon] = [1, -1].map(about);

    let weight = |k: usize| state.tau[axes[k]].clone() * gamma[k].clone();
    let [w1, w2, w3] = [0, 1, 2].map(weight);
    let [down, _] = circle(
        &(w1.clone() * sine.clone() + w2.clone() * cosine.clone()),
        &(w1 * cosine - w2 * sine),
        &small(1),
        &share,
    );
    let [sin_theta, cos_theta] = circle(&rho, &gamma[2], &small(1), &share);
    let steady = half.clone() * turning.square();

    let mut terms: Vec<(Exponents, E)> = Vec::new();
    for [x, y, ..] in (0..=DEGREE).flat_map(of_degree).filter(|powers| powers[2..] == [0, 0]) {
        let [i, j] = [x, y].map(usize::from);
        let at = |p: &Taylor<E>, q: &Taylor<E>| p[j].clone() * q[i].clone();
        if i + j >= 2 {
            let mut value = at(&alpha, &squares) - at(&skew, &turned) - at(&down, &sin_theta);
            if i == 0 {
                value = value + steady.clone() * epsilon[j].clone();
            }
            if j == 0 {
                value = value - w3.clone() * cos_theta[i].clone();
            }
            terms.push(([x, y, 0, 0], value));
        }
        if (1..=3).contains(&(i + j)) {
            terms.push(([x, y, 0, 1], at(&skew, &dragged) - at(&alpha, &mixed)));
            let value = -at(&skew, &m);
            let value = if i == 0 { value + turning.clone() * epsilon[j].clone() } else { value };
            terms.push(([x, y, 1, 0], value));
        }
        if i + j <= 2 {
            let value = at(&alpha, &inner);
            let value = if i + j == 0 { value + half.clone() * inverse[2].clone() } else { value };
            terms.push(([x, y, 0, 2], value));
            terms.push(([x, y, 1, 1], at(&skew, &cot)));
            if i == 0 {
                terms.push(([x, y, 2, 0], half.clone() * epsilon[j].clone()));
            }
        }
    }
    Series::of(terms)
}

/// Coefficient n of a product.
fn product_at<E: Enclosure>(y: &Taylor<E>, z: &Taylor<E>, n: usize) -> E {
    let first = y[0].clone() * z[n].clone();
    (1..=n).fold(first, |sum, k| sum + y[k].clone() * z[n - k].clone())
}

/// f and f′/k of f″ = −k²f with these values at 0; `share`: 1/2, 1/3, 1/4.
fn circle<E: Enclosure>(sine: &E, cosine: &E, k: &E, share: &[E; 3]) -> [Taylor<E>; 2] {
    let from = |sine: &E, cosine: &E| {
        let mut values = [sine.clone(), k.clone() * cosine.clone(), sine.clone(), sine.clone(), sine.clone()];
        let square = k.square();
        values[2] = -(square.clone() * sine.clone() * share[0].clone());
        values[3] = -(square.clone() * values[1].clone() * share[0].clone() * share[1].clone());
        values[4] = -(square * values[2].clone() * share[1].clone() * share[2].clone());
        values
    };
    [from(sine, cosine), from(cosine, &-sine.clone())]
}
