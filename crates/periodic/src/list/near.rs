//! The curve of the diagram near which the section is too sharply bent to be covered.

use bifdiag_diagram::topology::Margin;
use bifdiag_dynamics::field::{State, dot};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_equilibria::critical::RelativeEquilibria;
use bifdiag_equilibria::curves::{CurveName, Pole};

use crate::chart::{RADIUS, Surface};
use crate::flow::Phase as Point;

/// A critical curve or pole line near (h, l). At its own energy P is singular at a few states, and close to that energy
/// it is sharply bent near them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearCurve {
    /// The curve.
    pub curve: CurveName,
    /// Its distance in h, |h − h_c|.
    pub margin: f64,
    /// Every place that could not be covered lies this close to one of these states, in (γ, l/L).
    pub within: f64,
}

/// Farther from the states at which P is singular than this, its bends have another reason: the side of the largest
/// square.
const NEAR: f64 = 2.0 * RADIUS;
/// The largest margin, as a part of |h| + |r|: P bends near such a state on the scale of its square root, and farther
/// away than this the largest square fits.
const MARGIN: f64 = RADIUS * RADIUS;

impl NearCurve {
    /// The nearest curve, if it is so near that it explains why none of these places could be covered.
    #[must_use]
    pub fn of(setting: &SectionSetting, surface: &Surface, places: &[Point]) -> Option<Self> {
        let Margin { h: margin, nearest, error_bound } = *setting.margin();
        let scale = setting.h().abs() + setting.torus().top().center_norm();
        let curve = nearest.filter(|_| error_bound < margin && margin < MARGIN * scale)?;
        let states = singular_states(setting, curve)?;
        let singular: Vec<Point> = states.iter().map(|state| surface.point(state)).collect();
        let distance = |place: &Point| singular.iter().map(|at| (place - at).norm()).fold(f64::INFINITY, f64::min);
        let within = places.iter().map(distance).fold(0.0, f64::max);
        (!places.is_empty() && within < NEAR).then_some(Self { curve, margin, within })
    }
}

/// The states of energy h_c at which P is singular: the relative equilibria on a critical curve; on a pole line the
/// rotation with the pole along the vertical, which spends all of h_c.
fn singular_states(setting: &SectionSetting, curve: CurveName) -> Option<Vec<State>> {
    let (top, l) = (setting.torus().top(), setting.l());
    let turning = |gamma: [f64; 3]| {
        let momentum = top.inertia(gamma);
        State { gamma, l: momentum.map(|x| x * (l / dot(gamma, momentum))) }
    };
    if let CurveName::Pole(pole) = curve {
        let gamma = top.r_hat()?;
        return Some(vec![turning(if pole == Pole::Plus { gamma } else { gamma.map(|x| -x) })]);
    }
    let known = RelativeEquilibria::new(setting.body()).ok()?.without_normal_forms();
    let equilibria = known.at(setting.point()[1]).ok()?.list;
    let own = equilibria.into_iter().filter(|found| found.curve == Some(curve));
    Some(own.map(|found| turning(found.gamma)).collect())
}

#[cfg(test)]
mod tests {
    use bifdiag_body::Body;

    use super::*;

    /// The states lie on the curve: their energy differs from h by the margin, for poles and for equilibria.
    #[test]
    fn singular_states_have_the_energy_of_the_curve() {
        let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
        for (h, name) in [("1.9694", "P+"), ("4.2319", "P-"), ("1.64", "G2.1"), ("4.645", "S2.1")] {
            let setting = SectionSetting::new(&body, &h.parse().unwrap(), &"3.25".parse().unwrap()).unwrap();
            let Margin { h: margin, nearest, .. } = *setting.margin();
            let curve = nearest.unwrap();
            assert_eq!(curve.to_string(), name);
            let states = singular_states(&setting, curve).unwrap();
            assert_eq!(states.len(), if name == "S2.1" { 2 } else { 1 });
            for state in states {
                let distance = (setting.torus().top().energy(&state) - setting.h()).abs();
                assert!((distance - margin).abs() < 1e-12, "{name} {distance} {margin}");
                assert!((dot(state.gamma, state.l) - 3.25).abs() < 1e-12);
            }
        }
    }
}
