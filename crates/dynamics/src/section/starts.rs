//! Starting points on the section, spread evenly and reproducibly.

use std::f64::consts::TAU;

use super::error::SectionError;
use super::torus::{PpTorus, TorusPoint};
use crate::field::{add, cross, norm, scale};

/// How starting points are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StartOptions {
    /// How many.
    pub count: usize,
    /// Shifts the sequence.
    pub seed: u64,
    /// Give up after so many places for each point wanted.
    pub tries_per_start: u64,
}

impl Default for StartOptions {
    fn default() -> Self {
        Self { count: 64, seed: 0, tries_per_start: 20_000 }
    }
}

/// Points of the accessible region U ≤ h, uniform in area, both sheets in turn.
///
/// A Kronecker sequence with the plastic number's powers, which fills (cosϑ', ψ') with low discrepancy; the
/// points at which U_l > h are passed over.
///
/// # Errors
/// [`SectionError::Inaccessible`] when the places run out before `count` points were found.
pub fn spread_starts(torus: &PpTorus, h: f64, l: f64, options: &StartOptions) -> Result<Vec<TorusPoint>, SectionError> {
    spread_starts_over(torus, h, l, options, 1, &|_| Some(0))
}

/// Likewise, with an equal share for each of `components` parts of the accessible region, however small.
///
/// `component_of` tells in which part γ lies (below `components`); points for which it says None are passed over.
/// The parts take turns in the result as far as the sequence allows; the first parts get the odd ones.
///
/// # Errors
/// [`SectionError::Inaccessible`] when the places run out before every part has its share.
pub fn spread_starts_over(
    torus: &PpTorus,
    h: f64,
    l: f64,
    options: &StartOptions,
    components: usize,
    component_of: &dyn Fn([f64; 3]) -> Option<usize>,
) -> Result<Vec<TorusPoint>, SectionError> {
    for (name, value) in [("h", h), ("l", l)] {
        if !value.is_finite() {
            return Err(SectionError::Parameter { name, value, expected: "a finite number is needed" });
        }
    }
    let share = |part: usize| options.count / components + usize::from(part < options.count % components);
    let mut taken = vec![0_usize; components];
    let limit = options.tries_per_start.saturating_mul(options.count.max(1) as u64);
    let mut position = shift(options.seed);
    let mut starts = Vec::with_capacity(options.count);
    let mut lowest = f64::INFINITY;
    let mut tried = 0;
    while components > 0 && starts.len() < options.count {
        if tried == limit {
            return Err(SectionError::Inaccessible { h, lowest, tried });
        }
        tried += 1;
        advance(&mut position);
        let cos = 1.0 - 2.0 * position[0];
        let theta = libm::atan2((1.0 - cos * cos).sqrt(), cos);
        let psi = TAU * position[1];
        let gamma = torus.gamma(theta, psi);
        let potential = torus.top().effective_potential(gamma, l);
        lowest = lowest.min(potential);
        if potential > h {
            continue;
        }
        if let Some(part) = component_of(gamma).filter(|&part| part < components && taken[part] < share(part)) {
            let sheet = if taken[part].is_multiple_of(2) { 1 } else { -1 };
            taken[part] += 1;
            starts.push(TorusPoint { theta, psi, sheet });
        }
    }
    Ok(starts)
}

/// Likewise for one small part of the accessible region round γ = `center`, for which `wanted` is true: from caps that
/// shrink until a part of their points serves.
///
/// # Errors
/// [`SectionError::Inaccessible`] when no cap that is wider than rounding has enough points.
pub fn spread_starts_round(
    torus: &PpTorus,
    h: f64,
    l: f64,
    options: &StartOptions,
    center: [f64; 3],
    wanted: &dyn Fn([f64; 3]) -> bool,
) -> Result<Vec<TorusPoint>, SectionError> {
    /// So many places of a cap for each point wanted.
    const TRIES: u64 = 64;
    let smallest = (0..3).min_by(|&i, &j| center[i].abs().total_cmp(&center[j].abs())).unwrap_or(0);
    let first = cross(center, std::array::from_fn(|i| if i == smallest { 1.0 } else { 0.0 }));
    let first = scale(1.0 / norm(first), first);
    let second = cross(center, first);
    let (mut lowest, mut tried) = (f64::INFINITY, 0);
    let mut radius = 1.0;
    while radius > f64::EPSILON {
        let mut position = shift(options.seed);
        let mut starts = Vec::with_capacity(options.count);
        for _ in 0..TRIES * options.count as u64 {
            if starts.len() == options.count {
                return Ok(starts);
            }
            tried += 1;
            advance(&mut position);
            let distance = radius * position[0].sqrt();
            let (sin, cos) = libm::sincos(TAU * position[1]);
            let gamma = add(center, add(scale(distance * cos, first), scale(distance * sin, second)));
            let gamma = scale(1.0 / norm(gamma), gamma);
            let potential = torus.top().effective_potential(gamma, l);
            lowest = lowest.min(potential);
            let (theta, psi) = torus.angles(gamma);
            // The angles round; what counts is the point that they denote.
            if potential <= h && torus.top().effective_potential(torus.gamma(theta, psi), l) <= h && wanted(gamma) {
                starts.push(TorusPoint { theta, psi, sheet: if starts.len().is_multiple_of(2) { 1 } else { -1 } });
            }
        }
        radius *= 0.5;
    }
    Err(SectionError::Inaccessible { h, lowest, tried })
}

/// The next place of the Kronecker sequence.
fn advance(position: &mut [f64; 2]) {
    // 1/p and 1/p² with p³ = p + 1.
    const STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];
    for (x, step) in position.iter_mut().zip(STEP) {
        *x += step;
        *x -= x.floor();
    }
}

/// Two numbers in [0, 1) from a seed (SplitMix64).
fn shift(seed: u64) -> [f64; 2] {
    let mut state = seed;
    [(); 2].map(|()| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 53) as f64
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::HeavyTop;

    fn torus() -> PpTorus {
        PpTorus::new(&HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])).unwrap()
    }

    #[test]
    fn starts_are_accessible_reproducible_and_on_both_sheets() {
        let options = StartOptions { count: 100, seed: 7, ..StartOptions::default() };
        let starts = spread_starts(&torus(), 4.45, 3.25, &options).unwrap();
        assert_eq!(starts, spread_starts(&torus(), 4.45, 3.25, &options).unwrap());
        assert_ne!(starts, spread_starts(&torus(), 4.45, 3.25, &StartOptions { seed: 8, ..options }).unwrap());
        assert!(starts.iter().all(|p| torus().state(*p, 4.45, 3.25).is_ok()));
        assert_eq!(starts.iter().map(|p| i32::from(p.sheet)).sum::<i32>(), 0);
    }

    #[test]
    fn small_components_get_their_share() {
        // U = S² at h = 6.5; as parts, a cap round −e₁ and the rest.
        let torus = torus();
        let part = |gamma: [f64; 3]| Some(usize::from(gamma[0] < -0.5));
        let options = StartOptions { count: 21, ..StartOptions::default() };
        let starts = spread_starts_over(&torus, 6.5, 3.25, &options, 2, &part).unwrap();
        let small = starts.iter().filter(|p| part(torus.gamma(p.theta, p.psi)) == Some(1)).count();
        assert_eq!((starts.len(), small), (21, 10));
    }

    #[test]
    fn below_the_minimum_the_lowest_energy_seen_is_named() {
        // Example 15.3 of docs/mathematics.md: the minimum at l = 3.25 is 1.639699408.
        let error = spread_starts(&torus(), 1.6, 3.25, &StartOptions { count: 1, ..StartOptions::default() });
        let Err(SectionError::Inaccessible { lowest, .. }) = error else { panic!("{error:?}") };
        assert!((lowest - 1.639_699_408).abs() < 1e-3 && lowest >= 1.639_699_407);
    }
}
