//! Local optimisation.

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;

use super::chart::Chart;
use super::score::{Domain, Score, look};
use super::target::Target;
use crate::digits::{DIGITS, rounded};

/// First steps of the simplex in logarithms.
const STEP: f64 = 0.08;

struct Problem<'a> {
    chart: Chart,
    target: &'a Target,
    domain: Domain,
}

impl CostFunction for Problem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, coordinates: &Vec<f64>) -> Result<f64, argmin::core::Error> {
        let seen = look(self.chart.values(coordinates), self.target, &self.domain);
        Ok(-seen.map_or(Score::Nothing, |seen| seen.score).value())
    }
}

/// Makes what a body shows more visible, or brings the body nearer to showing it: the simplex method over the ratios of
/// its moments and of the components of r that are not 0. Gives A and r, rounded to six digits, or to fewer where that
/// costs little.
#[must_use]
pub fn improve(start: [[f64; 3]; 2], target: &Target, domain: &Domain, steps: u64) -> [[f64; 3]; 2] {
    let chart = Chart::around(start);
    let dimensions = chart.dimensions();
    let origin = vec![0.0; dimensions];
    if dimensions == 0 {
        return chart.values(&origin);
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
    let problem = Problem { chart: chart.clone(), target, domain: *domain };
    let done = NelderMead::new(simplex)
        .with_sd_tolerance(1e-7)
        .and_then(|solver| Executor::new(problem, solver).configure(|state| state.max_iters(steps)).run());
    let best = done.ok().and_then(|done| done.state().get_best_param().cloned());
    tidied(chart.values(best.as_ref().unwrap_or(&origin)), target, domain)
}

/// The body with as few digits as leave most of what it shows.
fn tidied(values: [[f64; 3]; 2], target: &Target, domain: &Domain) -> [[f64; 3]; 2] {
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
