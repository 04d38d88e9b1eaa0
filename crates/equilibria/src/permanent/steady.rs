//! Steady rotations at one spin: every relative equilibrium with angular velocity Ωγ.
//!
//! (sA − ν)γ = −r with s = Ω² and |γ| = 1 (Proposition 3.1 of docs/mathematics.md): γ_k = r_k/(ν − sA_k), where ν is a
//! root of Σ r_k²/(ν − sA_k)² = 1, or ν = sA_k for an axis with r_k = 0, along which γ has what is missing of its length.

use bifdiag_numbers::symmetric::{Real, dot as inner};
use bifdiag_numbers::vector::{dot, norm, normalised};
use dashu_ratio::RBig;

use super::cone::angle_between;
use crate::critical::{Equilibrium, Multiplicity, RelativeEquilibria};
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
    /// h and l are exact: the direction of the question is that of a steady rotation, to the last digit.
    pub is_exact: bool,
    /// The relative equilibrium, with its stability.
    pub equilibrium: Equilibrium,
}

/// The steady rotation at the spin Ω ≥ 0 whose upward direction −γ is nearest to `up`, of any length, in principal axes;
/// `None` where numbers leave the range of `f64`. Given are Ω and Ω², which may be rational where Ω is not.
#[must_use]
pub fn nearest_steady(body: &Body, [omega, squared]: [&RBig; 2], up: &[RBig; 3]) -> Option<SteadyRotation> {
    if omega * omega == *squared {
        return nearest_at(body, omega, up);
    }
    // With 1/Ω as the unit of time the body is (A, r/Ω²) and turns with spin 1: rational.
    let center = body.center().each_ref().map(|r| Number::from_rational(r.value() / squared));
    let found = nearest_at(&Body::new(body.moments().clone(), center).ok()?, &RBig::ONE, up)?;
    let [h, l] = found.place.each_ref().map(Number::value);
    let place = [h * squared, l * omega].map(Number::from_rational);
    Some(SteadyRotation { place, equilibrium: found.equilibrium.clone().sped_up(omega.to_f64().value()), ..found })
}

/// The same for a rational spin.
fn nearest_at(body: &Body, omega: &RBig, up: &[RBig; 3]) -> Option<SteadyRotation> {
    let (a, r, spin) = (body.moments_f64(), body.center_f64(), omega.to_f64().value());
    let down = normalised(up.each_ref().map(|x| -x.to_f64().value()));
    let exact = exact_place(body, omega, up);
    let is_exact = exact.is_some();
    let (gamma, angle, l) = if let Some([_, l]) = &exact {
        (down, 0.0, Number::from_rational(l.clone()))
    } else {
        let candidates =
            directions(body, &(omega * omega), down).into_iter().map(|gamma| (gamma, angle_between(gamma, down)));
        let (gamma, angle) = candidates.min_by(|(_, p), (_, q)| p.total_cmp(q))?;
        let moment = (0..3).map(|k| a[k] * gamma[k] * gamma[k]).sum::<f64>();
        (gamma, angle, Number::from_f64(spin * moment).ok()?)
    };
    let all = RelativeEquilibria::new(body).ok()?.at(&l).ok()?;
    let turning = 0.5 * spin * l.to_f64();
    let h = turning - dot(gamma, r);
    let size = turning.abs() + norm(r);
    let distance = |found: &Equilibrium| {
        // One point of a circle or sphere represents all.
        let apart = match found.multiplicity {
            Multiplicity::Points(_) => (0..3).map(|k| (found.gamma[k] - gamma[k]).abs()).fold(0.0, f64::max),
            Multiplicity::Circle | Multiplicity::Sphere => 0.0,
        };
        (found.h - h).abs() / size.max(f64::MIN_POSITIVE) + apart
    };
    let equilibrium = all.list.into_iter().min_by(|p, q| distance(p).total_cmp(&distance(q)))?;
    let h = match exact {
        Some([h, _]) => Number::from_rational(h),
        None => Number::from_f64(equilibrium.h).ok()?,
    };
    (distance(&equilibrium) < 1e-6).then_some(SteadyRotation { gamma, angle, place: [h, l], is_exact, equilibrium })
}

/// The other steady axes at a spin that are as near to a direction as one of them, at this angle in radians.
#[must_use]
pub fn equally_near_steady(
    body: &Body,
    omega: &RBig,
    up: [f64; 3],
    (nearest, angle): ([f64; 3], f64),
) -> Vec<[f64; 3]> {
    /// Angles that differ by less are the same.
    const TIE: f64 = 1e-11;
    let found = RelativeEquilibria::new(body).ok().and_then(|all| Some(all.at_spin(omega).ok()?.list));
    let axes = found.unwrap_or_default().into_iter().map(|point| point.gamma.map(|x| 0.0 - x));
    let is_other =
        |axis: &[f64; 3]| (angle_between(*axis, up) - angle).abs() < TIE && angle_between(*axis, nearest) > TIE;
    axes.filter(is_other).collect()
}

/// Ω² at which rotation with `up` pointing up is steady, where the axis is rational: then [`nearest_steady`] is exact at it.
/// `None` too for an axis that is principal.
#[must_use]
pub(super) fn exact_squared_spin(body: &Body, up: &[RBig; 3]) -> Option<RBig> {
    let Balance { left, right } = Balance::of(body, up)?;
    let squared = inner(&left, &left);
    if squared.is_zero() {
        return None;
    }
    let s = inner(&left, &right) / squared;
    (s >= RBig::ZERO && (0..3).all(|k| &s * &left[k] == right[k])).then_some(s)
}

/// h and l of rotation with n = `up` pointing up, if it is steady at exactly this spin and |n| is rational.
fn exact_place(body: &Body, omega: &RBig, up: &[RBig; 3]) -> Option<[RBig; 2]> {
    let Balance { left, right } = Balance::of(body, up)?;
    let s = omega * omega;
    if (0..3).any(|k| &s * &left[k] != right[k]) {
        return None;
    }
    let (length, turned) = (length(up)?, turned(body, up));
    let l = omega * inner(up, &turned) / inner(up, up);
    Some([omega * &l / RBig::from(2) + inner(up, &center(body)) / length, l])
}

/// Rotation with n pointing up: with γ = −n/|n|, sAγ + r is along γ where s(n × An) = |n|(n × r).
struct Balance {
    /// n × An.
    left: [RBig; 3],
    /// |n|(n × r).
    right: [RBig; 3],
}

impl Balance {
    /// `None` where |n| is 0 or not rational.
    fn of(body: &Body, up: &[RBig; 3]) -> Option<Self> {
        let length = length(up)?;
        let right = exact_cross(up, &center(body)).map(|x| x * &length);
        Some(Self { left: exact_cross(up, &turned(body, up)), right })
    }
}

/// |n|, where it is rational and not 0.
fn length(n: &[RBig; 3]) -> Option<RBig> {
    let length = Real::root_of(&inner(n, n), 1);
    (length.is_exact() && !length.lo.is_zero()).then_some(length.lo)
}

fn turned(body: &Body, n: &[RBig; 3]) -> [RBig; 3] {
    std::array::from_fn(|k| body.moments()[k].value() * &n[k])
}

fn center(body: &Body) -> [RBig; 3] {
    body.center().each_ref().map(|x| x.value().clone())
}

fn exact_cross(v: &[RBig; 3], w: &[RBig; 3]) -> [RBig; 3] {
    [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &v[i] * &w[j] - &v[j] * &w[i]
    })
}

/// All γ with (sA − ν)γ = −r for some ν; of a circle or sphere of them the one nearest to `down`.
fn directions(body: &Body, s: &RBig, down: [f64; 3]) -> Vec<[f64; 3]> {
    let r = body.center_f64();
    // s(A_i − A_k), each rounded from the exact one.
    let exact = |i: usize, k: usize| s * (body.moments()[i].value() - body.moments()[k].value());
    let apart = [0, 1, 2].map(|i| [0, 1, 2].map(|k| exact(i, k).to_f64().value()));
    let mut found: Vec<[f64; 3]> = multipliers(&apart, r)
        .into_iter()
        .map(|from_pole| normalised(std::array::from_fn(|k| if r[k] == 0.0 { 0.0 } else { r[k] / from_pole[k] })))
        .collect();
    for axis in (0..3).filter(|&k| r[k] == 0.0) {
        // Axes with the same pole share what is missing; one of them is active: no finite ν.
        let shares: Vec<usize> = (0..3).filter(|&k| apart[axis][k] == 0.0).collect();
        if shares.iter().any(|&k| r[k] != 0.0) {
            continue;
        }
        let fixed: [f64; 3] = std::array::from_fn(|k| if shares.contains(&k) { 0.0 } else { r[k] / apart[axis][k] });
        // Exact: where it is 0 the direction is that of an axis on which the centre of mass lies.
        let taken = (0..3).filter(|k| !shares.contains(k)).map(|k| body.center()[k].value() / exact(axis, k));
        let missing = (RBig::ONE - taken.fold(RBig::ZERO, |sum, x| sum + &x * &x)).to_f64().value();
        if missing < 0.0 {
            continue;
        }
        let along: [f64; 3] = std::array::from_fn(|k| if shares.contains(&k) { down[k] } else { 0.0 });
        let along = if dot(along, along) > 0.0 {
            normalised(along)
        } else {
            std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 })
        };
        for sign in [1.0, -1.0] {
            found.push(std::array::from_fn(|k| fixed[k] + sign * missing.sqrt() * along[k]));
        }
    }
    found
}

/// The roots ν of Σ r_k²/(ν − sA_k)² = 1, each as its three distances ν − sA_k: one beyond the poles on each side, and two,
/// one or none between neighbours, where the function is convex. A root is found as its distance from a pole beside it, of
/// which no digit is lost when r_k is small.
fn multipliers(apart: &[[f64; 3]; 3], r: [f64; 3]) -> Vec<[f64; 3]> {
    let mut poles: Vec<usize> = Vec::new();
    for k in (0..3).filter(|&k| r[k] != 0.0) {
        if poles.iter().all(|&pole| apart[pole][k] != 0.0) {
            poles.push(k);
        }
    }
    poles.sort_by(|&i, &k| apart[i][k].total_cmp(&0.0));
    let (Some(&least), Some(&most)) = (poles.first(), poles.last()) else { return Vec::new() };
    let from_poles = |pole: usize, distance: f64| [0, 1, 2].map(|k| distance + apart[pole][k]);
    let sum = |pole: usize, distance: f64, term: fn(f64, f64) -> f64| {
        let from_poles = from_poles(pole, distance);
        (0..3).filter(|&k| r[k] != 0.0).map(|k| term(r[k], from_poles[k])).sum::<f64>()
    };
    let value = |pole: usize| move |distance: f64| sum(pole, distance, |r, d| (r / d) * (r / d)) - 1.0;
    let slope = |pole: usize| move |distance: f64| -sum(pole, distance, |r, d| (r / d) * (r / d) / d);
    let root = |pole: usize, minus: f64| from_poles(pole, bisected(0.0, minus, &value(pole)));
    // Beyond the poles the root lies at |r| from the last one at most.
    let far = 2.0 * norm(r);
    let mut found = vec![root(least, -far), root(most, far)];
    for pair in poles.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        let width = apart[high][low];
        let from_low = bisected(width, 0.0, &slope(low));
        let from_high = bisected(0.0, -width, &slope(high));
        if value(low)(from_low) <= 0.0 {
            found.extend([root(low, from_low), root(high, from_high)]);
        }
    }
    found
}

/// Where a function that is positive beside `plus` and negative beside `minus` changes its sign.
fn bisected(mut plus: f64, mut minus: f64, value: &impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = 0.5 * (plus + minus);
        if middle == plus || middle == minus {
            return minus;
        }
        if value(middle) > 0.0 { plus = middle } else { minus = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(body: &Body, omega: f64, up: [f64; 3]) -> SteadyRotation {
        let rational = |x: f64| RBig::try_from(x).unwrap();
        let omega = rational(omega);
        nearest_steady(body, [&omega, &(&omega * &omega)], &up.map(rational)).unwrap()
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
                    let squared = RBig::try_from(point.omega * point.omega).unwrap();
                    for gamma in directions(&body, &squared, point.gamma) {
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
        assert_eq!(exact_squared_spin(&body, &up), Some(RBig::ONE));
        let found = nearest_steady(&body, [&RBig::ONE; 2], &up).unwrap();
        let [h, l] = ["-0.54", "1.64"].map(|text| text.parse::<Number>().unwrap().value().clone());
        assert_eq!([found.place[0].value(), found.place[1].value()], [&h, &l]);
        assert!(found.is_exact && found.angle == 0.0);
        assert_eq!(found.equilibrium.stability.word(), "zero");
        assert_eq!(exact_squared_spin(&body, &[-1, -1, 0].map(RBig::from)), None);
    }
}
