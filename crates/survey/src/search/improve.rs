//! Local optimisation in logarithms of ratios, so that near-axis and near-symmetric bodies are ordinary.

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;

use super::score::{Score, SearchDomain, look};
use super::target::Target;
use super::witness::rounded;

/// Significant digits of the numbers of a body.
const DIGITS: usize = 6;

/// First steps of the simplex in logarithms.
const STEP: f64 = 0.08;

struct Problem<'a> {
    coordinates: LogCoordinates,
    target: &'a Target,
    domain: SearchDomain,
}

impl CostFunction for Problem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, coordinates: &Vec<f64>) -> Result<f64, argmin::core::Error> {
        let seen = look(self.coordinates.values(coordinates), self.target, &self.domain);
        Ok(-seen.map_or(Score::Nothing, |seen| seen.score).value())
    }
}

/// Makes what a body shows more visible, or brings the body nearer to showing it: the simplex method over the ratios of
/// its moments and of the components of r that are not 0. Gives A and r, rounded to six digits, or to fewer where that
/// costs little.
#[must_use]
pub fn improve(start: [[f64; 3]; 2], target: &Target, domain: &SearchDomain, steps: u64) -> [[f64; 3]; 2] {
    let coordinates = LogCoordinates::around(start);
    let dimensions = coordinates.dimensions();
    let origin = vec![0.0; dimensions];
    if dimensions == 0 {
        return coordinates.values(&origin);
    }
    let simplex = (0..=dimensions)
        .map(|corner| {
            let mut at = origin.clone();
            if let Some(coordinate) = corner.checked_sub(1).and_then(|axis| at.get_mut(axis)) {
                *coordinate = STEP;
            }
            at
        })
        .collect();
    let problem = Problem { coordinates: coordinates.clone(), target, domain: *domain };
    let done = NelderMead::new(simplex)
        .with_sd_tolerance(1e-7)
        .and_then(|solver| Executor::new(problem, solver).configure(|state| state.max_iters(steps)).run());
    let best = done.ok().and_then(|done| done.state().get_best_param().cloned());
    tidied(coordinates.values(best.as_ref().unwrap_or(&origin)), target, domain)
}

/// The body with as few digits as leave most of what it shows.
fn tidied(values: [[f64; 3]; 2], target: &Target, domain: &SearchDomain) -> [[f64; 3]; 2] {
    const KEPT: f64 = 0.8;
    const SMALL: f64 = 0.01;
    let visibility = |values| match look(values, target, domain)?.score {
        Score::Shown(visibility) => Some(visibility),
        Score::Near(_) | Score::Nothing => None,
    };
    let Some(best) = visibility(values) else { return values };
    // r in units of its largest component.
    let [a, r] = values;
    let largest = r.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    let mut values = [a, r.map(|c| c / largest)];
    let shows = |values| visibility(values).is_some_and(|seen| seen >= KEPT * best);
    // What is small may as well be 0.
    let plain = [a, values[1].map(|c| if c < SMALL { 0.0 } else { c })];
    if shows(plain) {
        values = plain;
    }
    (1..DIGITS)
        .map(|digits| values.map(|triple| triple.map(|x| rounded(x, digits))))
        .find(|rough| shows(*rough))
        .unwrap_or(values)
}

/// Coordinates around a body; components of r that are 0 stay 0, and units stay the same.
#[derive(Clone, Debug)]
struct LogCoordinates {
    base: [[f64; 3]; 2],
    /// Places of (A1, A2, A3, r1, r2, r3) that vary.
    free: Vec<usize>,
}

impl LogCoordinates {
    /// All ratios vary but those of the largest moment and of the largest component of r.
    fn around(base: [[f64; 3]; 2]) -> Self {
        let largest =
            |values: &[f64; 3]| (0..3).max_by(|&i, &j| values[i].abs().total_cmp(&values[j].abs())).unwrap_or_default();
        let fixed = [largest(&base[0]), 3 + largest(&base[1])];
        let free = (0..6).filter(|place| !fixed.contains(place) && base[place / 3][place % 3] != 0.0).collect();
        Self { base, free }
    }

    /// Number of coordinates.
    fn dimensions(&self) -> usize {
        self.free.len()
    }

    /// A and r at these coordinates, rounded to a few digits: so that what is found can be written down.
    fn values(&self, coordinates: &[f64]) -> [[f64; 3]; 2] {
        let mut values = self.base;
        for (place, coordinate) in self.free.iter().zip(coordinates) {
            values[place / 3][place % 3] *= libm::exp(*coordinate);
        }
        values.map(|triple| triple.map(|x| rounded(x, DIGITS)))
    }
}
