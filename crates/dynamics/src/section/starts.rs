//! Starting points on the section, spread evenly and reproducibly.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use super::error::{SectionError, check_finite, check_stop};
use super::torus::{PpTorus, TorusPoint};
use crate::field::{Dimension, HeavyTop, TopUnits, add, cross, norm, scale};
use bifdiag_numbers::sequence::Square;

/// How starting points are chosen.
#[derive(Clone, Copy, Debug)]
pub struct StartOptions<'a> {
    /// How many.
    pub count: usize,
    /// Shifts the sequence.
    pub seed: u64,
    /// Places that are tried for each point wanted.
    pub tries_per_start: u64,
    /// Cancellation: once it is set, the search ends with [`SectionError::Interrupted`].
    pub stop: Option<&'a AtomicBool>,
}

impl Default for StartOptions<'_> {
    fn default() -> Self {
        Self { count: 64, seed: 0, tries_per_start: 20_000, stop: None }
    }
}

/// U_l of one top, in the top's own units, and what was seen of it.
struct StartPotential {
    top: HeavyTop,
    units: TopUnits,
    h: f64,
    l: f64,
    lowest: f64,
    tried: u64,
}

impl StartPotential {
    fn new(torus: &PpTorus, h: f64, l: f64) -> Self {
        let units = torus.top().units();
        let (h, l) = (units.reduce(h, Dimension::ENERGY), units.reduce(l, Dimension::MOMENTUM));
        Self { top: torus.top().reduced(), units, h, l, lowest: f64::INFINITY, tried: 0 }
    }

    /// True where U_l(γ) ≤ h.
    fn allows(&self, gamma: [f64; 3]) -> bool {
        self.top.effective_potential(gamma, self.l) <= self.h
    }

    /// The same for a place that is tried.
    fn try_place(&mut self, gamma: [f64; 3]) -> bool {
        let potential = self.top.effective_potential(gamma, self.l);
        self.lowest = self.lowest.min(potential);
        self.tried += 1;
        potential <= self.h
    }

    fn inaccessible(&self) -> SectionError {
        let [h, lowest] = [self.h, self.lowest].map(|x| self.units.restore(x, Dimension::ENERGY));
        SectionError::Inaccessible { h, lowest, tried: self.tried }
    }
}

/// Points of the accessible region U ≤ h, uniform in area, alternating between the sheets.
///
/// A Kronecker sequence with the plastic number's powers, which fills (cosϑ', ψ') with low discrepancy; points with U_l
/// > h are skipped.
///
/// # Errors
/// [`SectionError::Inaccessible`] when the places run out before `count` points were found;
/// [`SectionError::Interrupted`].
pub fn spread_starts(
    torus: &PpTorus,
    h: f64,
    l: f64,
    options: &StartOptions<'_>,
) -> Result<Vec<TorusPoint>, SectionError> {
    spread_starts_over(torus, h, l, options, 1, &|_| Some(0))
}

/// Likewise, with an equal share for each of `components` parts of the accessible region, however small.
///
/// `component_of` gives the part in which γ lies (below `components`); points for which it gives None are skipped. The
/// parts alternate in the result where the sequence allows; the first parts get the remainder.
///
/// # Errors
/// [`SectionError::Inaccessible`] when the places run out before every part has its share;
/// [`SectionError::Interrupted`].
pub fn spread_starts_over(
    torus: &PpTorus,
    h: f64,
    l: f64,
    options: &StartOptions<'_>,
    components: usize,
    component_of: &dyn Fn([f64; 3]) -> Option<usize>,
) -> Result<Vec<TorusPoint>, SectionError> {
    check_finite(h, l)?;
    let share = |part: usize| options.count / components + usize::from(part < options.count % components);
    let mut taken = vec![0_usize; components];
    let limit = options.tries_per_start.saturating_mul(options.count.max(1) as u64);
    let mut places = Square::new(options.seed);
    let mut potential = StartPotential::new(torus, h, l);
    let mut starts = Vec::with_capacity(options.count.min(1 << 16));
    while components > 0 && starts.len() < options.count {
        if potential.tried == limit {
            return Err(potential.inaccessible());
        }
        check_stop(options.stop)?;
        let [x, y] = places.advance();
        let cos = 1.0 - 2.0 * x;
        let theta = libm::atan2((1.0 - cos * cos).sqrt(), cos);
        let psi = TAU * y;
        let gamma = torus.gamma(theta, psi);
        if !potential.try_place(gamma) {
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
/// [`SectionError::Inaccessible`] when no cap that is wider than rounding has enough points;
/// [`SectionError::Interrupted`].
pub fn spread_starts_round(
    torus: &PpTorus,
    h: f64,
    l: f64,
    options: &StartOptions<'_>,
    center: [f64; 3],
    wanted: &dyn Fn([f64; 3]) -> bool,
) -> Result<Vec<TorusPoint>, SectionError> {
    /// Places of a cap for each point wanted.
    const TRIES: u64 = 64;
    let smallest = (0..3).min_by(|&i, &j| center[i].abs().total_cmp(&center[j].abs())).unwrap_or(0);
    let first = cross(center, std::array::from_fn(|i| if i == smallest { 1.0 } else { 0.0 }));
    let first = scale(1.0 / norm(first), first);
    let second = cross(center, first);
    let mut potential = StartPotential::new(torus, h, l);
    let mut radius = 1.0;
    while radius > f64::EPSILON {
        let mut places = Square::new(options.seed);
        let mut starts = Vec::with_capacity(options.count.min(1 << 16));
        for _ in 0..TRIES * options.count as u64 {
            if starts.len() == options.count {
                return Ok(starts);
            }
            check_stop(options.stop)?;
            let [x, y] = places.advance();
            let distance = radius * x.sqrt();
            let (sin, cos) = libm::sincos(TAU * y);
            let gamma = add(center, add(scale(distance * cos, first), scale(distance * sin, second)));
            let gamma = scale(1.0 / norm(gamma), gamma);
            let accessible = potential.try_place(gamma);
            let (theta, psi) = torus.angles(gamma);
            // The angles round; what counts is the point that they denote.
            if accessible && potential.allows(torus.gamma(theta, psi)) && wanted(gamma) {
                starts.push(TorusPoint { theta, psi, sheet: if starts.len().is_multiple_of(2) { 1 } else { -1 } });
            }
        }
        radius *= 0.5;
    }
    Err(potential.inaccessible())
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
        // Example 15.3 of docs/algorithms.md: the minimum at l = 3.25 is 1.639699408.
        let error = spread_starts(&torus(), 1.6, 3.25, &StartOptions { count: 1, ..StartOptions::default() });
        let Err(SectionError::Inaccessible { lowest, .. }) = error else { panic!("{error:?}") };
        assert!((lowest - 1.639_699_408).abs() < 1e-3 && lowest >= 1.639_699_407);
    }
}
