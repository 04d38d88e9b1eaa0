//! The Hamiltonian of the flow reduced by l near a relative equilibrium, as a series in canonical coordinates.
//!
//! With γ = (sin ϑ sin φ, sin ϑ cos φ, cos ϑ) about an axis of the frame, p_φ = L₃ and the angle about the vertical cyclic, whose
//! momentum is l,
//!
//! H = ½(L₁²/A₁ + L₂²/A₂ + p_φ²/A₃) − ⟨γ, r⟩, L₁ = m sin φ + p_ϑ cos φ, L₂ = m cos φ − p_ϑ sin φ,
//! m = (l − p_φ cos ϑ)/sin ϑ.
//!
//! The axis is the one from which γ is farthest, so that sin²ϑ ≥ 2/3. Time is in units of 1/Ω, which makes Ω = 1,
//! L = Aγ, l = J and r_k/s = τ_kγ_k. Signs of γ and the order of the axes are free: a reflection leaves H unchanged, or
//! reverses time, and neither changes the normal form.

use bifdiag_body::Axis;
use bifdiag_numbers::enclosure::Enclosure;

use super::series::Series;
use crate::stability::{Constants, State};

/// The variables of the series, in order.
const ANGLES: [usize; 2] = [0, 1];
const MOMENTA: [usize; 2] = [2, 3];

/// The axis of the frame from which γ is farthest.
pub(super) fn farthest<E: Enclosure>(state: &State<E>) -> Axis {
    let size = |k: Axis| state.w[k].bounds()[1];
    Axis::ALL.into_iter().min_by(|&i, &k| size(i).total_cmp(&size(k))).unwrap_or(Axis::ALL[2])
}

/// H/s about the equilibrium in (ϑ, φ, p_ϑ, p_φ), up to degree D, with the angles about an axis with γ ≠ ±e_axis.
#[must_use]
pub fn reduced_hamiltonian<E: Enclosure, const D: usize>(
    c: &Constants<E>,
    state: &State<E>,
    axis: Axis,
) -> Series<E, D> {
    let precision = c.precision;
    let small = |value| E::small(value, precision);
    let axes = [axis.next(), axis.next().next(), axis];
    let [first, second, third] = axes;
    let gamma = axes.map(|k| state.gamma[k].clone());
    let rho = (state.w[first].clone() + state.w[second].clone()).sqrt();
    let one = small(1);

    let [theta, phi] = ANGLES;
    let circle = |variable: usize, sine: &E, cosine: &E| {
        let taylor = |values: [E; 4]| {
            let factorial = |power: i32| small((1..=power).product());
            values.into_iter().cycle().zip(0..).take(D + 1).map(move |(value, power)| value / factorial(power))
        };
        let (s, c) = (sine.clone(), cosine.clone());
        [
            Series::univariate(variable, taylor([s.clone(), c.clone(), -s.clone(), -c.clone()])),
            Series::univariate(variable, taylor([c.clone(), -s.clone(), -c, s])),
        ]
    };
    let [sin_theta, cos_theta] = circle(theta, &rho, &gamma[2]);
    let [sin_phi, cos_phi] = circle(phi, &(gamma[0].clone() / rho.clone()), &(gamma[1].clone() / rho.clone()));

    // p_ϑ = L₁ cos φ − L₂ sin φ.
    let along = c.diff[first][second].clone() * gamma[0].clone() * gamma[1].clone() / rho.clone();
    let p_theta = Series::variable(MOMENTA[0], along, one.clone());
    let p_phi = Series::variable(MOMENTA[1], c.a[third].clone() * gamma[2].clone(), one.clone());

    // 1/x at x = ϱ: the powers of −1/ϱ.
    let inverse = one.clone() / rho;
    let mut power = inverse.clone();
    let reciprocal: Vec<E> = (0..=D)
        .map(|_| {
            let value = power.clone();
            power = -(power.clone() * inverse.clone());
            value
        })
        .collect();
    let minus = small(-1);
    let horizontal = Series::constant(state.j.clone())
        .plus(p_phi.times(&cos_theta).scaled(&minus))
        .times(&sin_theta.composed(reciprocal));
    let l1 = horizontal.times(&sin_phi).plus(p_theta.times(&cos_phi));
    let l2 = horizontal.times(&cos_phi).plus(p_theta.times(&sin_phi).scaled(&minus));

    let half = one / small(2);
    let kinetic = [(l1, first), (l2, second), (p_phi, third)]
        .map(|(momentum, k)| momentum.times(&momentum).scaled(&(half.clone() * c.inverse[k].clone())));
    let weight = |place: usize| -(state.tau[axes[place]].clone() * gamma[place].clone());
    let potential = [
        sin_theta.times(&sin_phi).scaled(&weight(0)),
        sin_theta.times(&cos_phi).scaled(&weight(1)),
        cos_theta.scaled(&weight(2)),
    ];
    kinetic.into_iter().chain(potential).fold(Series::of([]), Series::plus)
}
