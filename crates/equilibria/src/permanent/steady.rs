//! The steady rotation at one spin that is nearest to a direction, of all relative equilibria with the angular velocity Ωγ.

use bifdiag_numbers::symmetric::{Real, dot as inner};
use bifdiag_numbers::vector::{norm, normalised};
use dashu_ratio::RBig;

use super::axis::MEANT;
use super::cone::angle_between;
use crate::critical::{Equilibrium, ExactSpin, Multiplicity, RelativeEquilibria};
use bifdiag_body::{Body, Number};

/// A steady rotation, and what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyRotation {
    /// The direction of gravity in principal axes.
    pub gamma: [f64; 3],
    /// The angle between −γ and the direction of the question, in radians.
    pub angle: f64,
    /// h and l at this spin.
    pub place: [Number; 2],
    /// h is exact, and l exact or known to 60 digits: the direction of the question is that of a steady rotation, to the last
    /// digit.
    pub is_exact: bool,
    /// The relative equilibrium, with its stability.
    pub equilibrium: Equilibrium,
    /// The axes −γ of the other steady rotations at this spin that are as near.
    pub as_near: Vec<[f64; 3]>,
}

/// The steady rotation at the spin Ω ≥ 0 whose upward direction −γ is nearest to `up` in principal axes; `exact` is the same
/// direction in the axes in which the body was given, both of any length. `None` where numbers leave the range of `f64`, or
/// where the list of all may not be complete.
#[must_use]
pub fn nearest_steady(
    body: &Body,
    spin: &ExactSpin,
    up: [f64; 3],
    exact: Option<&[RBig; 3]>,
) -> Option<SteadyRotation> {
    /// Angles that differ by less are the same.
    const TIE: f64 = 1e-11;
    let down = normalised(up.map(|x| -x));
    let all = all_at(body, spin, down)?;
    let (angle, gamma, equilibrium) = all.iter().min_by(|(p, ..), (q, ..)| p.total_cmp(q))?;
    let others = all.iter().filter(|(other, ..)| other - angle < TIE).map(|(_, other, _)| other);
    let as_near =
        others.filter(|other| angle_between(**other, *gamma) > TIE).map(|other| other.map(|x| 0.0 - x)).collect();
    let is_meant = *angle <= MEANT && exact.is_some_and(|up| spin.is_steady(body, up));
    let (gamma, angle) = if is_meant { (down, 0.0) } else { (*gamma, *angle) };
    let exact = exact.and_then(|up| exact_place(body, spin, up));
    let is_exact = exact.is_some();
    let rounded = || Some([Number::from_f64(equilibrium.h).ok()?, Number::from_f64(equilibrium.l).ok()?]);
    let place = exact.or_else(rounded)?;
    Some(SteadyRotation { gamma, angle, place, is_exact, equilibrium: equilibrium.clone(), as_near })
}

/// Every steady rotation at a spin: the angle to `down` of the γ nearest to it, this γ, and its equilibrium. `None` where the
/// list may not be complete.
fn all_at(body: &Body, spin: &ExactSpin, down: [f64; 3]) -> Option<Vec<(f64, [f64; 3], Equilibrium)>> {
    let all = RelativeEquilibria::new(body).ok()?.at_exact_spin(spin).ok().filter(|all| all.complete)?;
    let beside = |equilibrium: Equilibrium| {
        let gamma = nearest_of(body, &equilibrium, down);
        (angle_between(gamma, down), gamma, equilibrium)
    };
    Some(all.list.into_iter().map(beside).collect())
}

/// The γ nearest to `down` among those that an entry represents: on a circle the part across the axis of symmetry is
/// turned.
fn nearest_of(body: &Body, found: &Equilibrium, down: [f64; 3]) -> [f64; 3] {
    match found.multiplicity {
        Multiplicity::Points(_) => found.gamma,
        Multiplicity::Sphere => down,
        Multiplicity::Circle => {
            let (moments, r) = (body.moments(), body.center_f64());
            let is_turned =
                [0, 1, 2].map(|k| r[k] == 0.0 && (0..3).any(|i| i != k && r[i] == 0.0 && moments[i] == moments[k]));
            let across = |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| if is_turned[k] { v[k] } else { 0.0 }) };
            let [size, length] = [norm(across(found.gamma)), norm(across(down))];
            if length == 0.0 {
                return found.gamma;
            }
            std::array::from_fn(|k| if is_turned[k] { size * down[k] / length } else { found.gamma[k] })
        }
    }
}

/// h and l of rotation with n = `up` pointing up, if it is steady at exactly this spin and |n| and Ω² are rational; l to 60
/// digits where Ω is not.
fn exact_place(body: &Body, spin: &ExactSpin, up: &[RBig; 3]) -> Option<[Number; 2]> {
    if !spin.is_steady(body, up) || &spin.squared * &spin.squared != spin.fourth {
        return None;
    }
    let center = body.center_as_given();
    let moment = inner(up, &body.angular_momentum_as_given(up)) / inner(up, up);
    let height = inner(up, &center) / length(up)?;
    let h = &spin.squared * &moment / RBig::from(2) + height;
    Some([h, &spin.omega * moment].map(Number::from_rational))
}

/// |n|, where it is rational and not 0.
fn length(n: &[RBig; 3]) -> Option<RBig> {
    let length = Real::root_of(&inner(n, n), 1);
    (length.is_exact() && !length.lo.is_zero()).then_some(length.lo)
}

#[cfg(test)]
mod tests {
    use bifdiag_numbers::vector::dot;

    use super::*;

    fn nearest(body: &Body, omega: f64, up: [f64; 3]) -> SteadyRotation {
        let rational = |x: f64| RBig::try_from(x).unwrap();
        nearest_steady(body, &ExactSpin::rational(rational(omega)), up, Some(&up.map(rational))).unwrap()
    }

    /// s Aγ + r is along γ, and every relative equilibrium at the l of a steady rotation is one at its own spin.
    #[test]
    fn steady_rotations_are_all_relative_equilibria_of_their_spin() {
        let bodies = [
            (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
            (["2", "1", "1.5"], ["0.3", "0.4", "0.5"]),
            (["1", "1", "0.6"], ["0", "0", "1"]),
            (["2", "1", "1.5"], ["0", "0.7", "0"]),
            // A component of the centre of mass of which ν keeps few digits next to sA₃.
            (["569051/1000000", "1728059/1000000", "1/5"], ["1/1000", "1/10000", "1e-17"]),
        ];
        let mut compared = 0;
        for (a, r) in bodies {
            let body = Body::parse(&a, &r).unwrap();
            let (moments, center) = (body.moments_f64(), body.center_f64());
            let prepared = RelativeEquilibria::new(&body).unwrap();
            for l in ["0.3", "1.1", "2.2", "3.7"] {
                for point in prepared.at(&l.parse().unwrap()).unwrap().list {
                    let up = point.gamma.map(|x| -x);
                    let found = nearest(&body, point.omega, up);
                    assert!(found.angle < 1e-7, "{a:?} {r:?} {point:?} {found:?}");
                    assert_eq!(found.equilibrium.stability, point.stability, "{found:?}");
                    compared += 1;
                    let spin = ExactSpin::rational(RBig::try_from(point.omega).unwrap());
                    for Equilibrium { gamma, .. } in prepared.at_exact_spin(&spin).unwrap().list {
                        let force: [f64; 3] =
                            std::array::from_fn(|k| point.omega * point.omega * moments[k] * gamma[k] + center[k]);
                        let along = dot(force, gamma);
                        let size = dot(force, force).sqrt();
                        assert!((0..3).all(|k| (force[k] - along * gamma[k]).abs() < 1e-7 * size), "{a:?} {gamma:?}");
                    }
                }
            }
        }
        assert!(compared > 50, "{compared}");
    }

    #[test]
    fn at_rest_the_body_hangs_or_stands() {
        let body = Body::parse(&["2", "1.1", "1"], &["3", "0", "4"]).unwrap();
        let found = nearest(&body, 0.0, [0.1, 0.0, -1.0]);
        assert!((found.gamma[0] - 0.6).abs() < 1e-15 && (found.gamma[2] - 0.8).abs() < 1e-15);
        assert_eq!(found.place[1].to_f64(), 0.0);
    }

    /// A pair leaves the plane at Ω = 1, l = 41/25, with −γ = −(3, 4, 0)/5: what is typed lies exactly there.
    #[test]
    fn a_rational_axis_is_judged_at_its_own_momentum() {
        let body = Body::parse(&["1", "2", "3"], &["1.2", "0.8", "0"]).unwrap();
        let up = [-3, -4, 0].map(RBig::from);
        let spin = ExactSpin::of_steady(&body, &up).unwrap();
        assert_eq!(spin, ExactSpin::rational(RBig::ONE));
        let found = nearest_steady(&body, &spin, [-3.0, -4.0, 0.0], Some(&up)).unwrap();
        let [h, l] = ["-0.54", "1.64"].map(|text| text.parse::<Number>().unwrap().value().clone());
        assert_eq!([found.place[0].value(), found.place[1].value()], [&h, &l]);
        assert!(found.is_exact && found.angle == 0.0);
        assert_eq!(found.equilibrium.stability.word(), "zero");
        // Ω⁴ = 2 (2/5)², and no spin beside the plane of the centre of mass.
        let fourth = |up: [i32; 3]| ExactSpin::of_steady(&body, &up.map(RBig::from)).map(|spin| spin.fourth);
        assert_eq!(fourth([-1, -1, 0]), Some(RBig::from_parts(8.into(), 25u8.into())));
        assert_eq!([fourth([-1, -1, 1]), fourth([1, 1, 0])], [None, None]);
    }
}
