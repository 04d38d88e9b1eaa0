//! Motions known in closed form, found unasked among the orbits at their point: what is looked for is not a guess of them.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_periodic::list::{ListOptions, OrbitList, list};
use bifdiag_periodic::orbit::PeriodicOrbit;

fn found(body: &Body, [h, l]: [f64; 2], crossings: u32) -> OrbitList {
    let [h, l] = [h, l].map(|x| format!("{x:?}").parse().unwrap());
    let setting = SectionSetting::new(body, &h, &l).unwrap();
    list(&setting, &ListOptions { crossings, ..ListOptions::default() }, &Monitor::default()).unwrap()
}

/// The one orbit that starts at γ, up to what its point may be off, and turns with ω; else none.
fn starting_at<'a>(list: &'a OrbitList, top: &HeavyTop, gamma: [f64; 3], omega: [f64; 3]) -> Option<&'a PeriodicOrbit> {
    let off = |orbit: &PeriodicOrbit| {
        let turning = top.inverse_inertia(orbit.start.l);
        (0..3).map(|i| (orbit.start.gamma[i] - gamma[i]).abs() + (turning[i] - omega[i]).abs()).fold(0.0, f64::max)
    };
    list.orbits.iter().map(|listed| &listed.orbit).find(|orbit| off(orbit) < 1e-8)
}

/// The arithmetic–geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..20 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Grioli (1947): where r stands at right angles to a plane in which A is a multiple of 1, that is r₂ = 0 and
/// r₁²/(A₁ − A₂) = r₃²/(A₂ − A₃), the body can spin about the line of r and precess about an oblique axis p at right angles to it,
/// both at the rate n with n² = |r|/|A r̂|: ω = n(r̂ + p).
///
/// With u at right angles to r̂ in the plane of the first and third axes, c = ⟨r̂, A r̂⟩ and b = ⟨u, A r̂⟩: p = u cos nt − e₂ sin nt,
/// γ = (−(c cos nt − b sin² nt) u + sin nt (c + b cos nt) e₂ + b cos nt r̂)/|A r̂|. This solves γ̇ = γ×ω and
/// d(Aω)/dt = Aω×ω + r×γ, as one sees by inserting it. ⟨γ,r⟩ is largest at t = 0.
#[test]
fn the_regular_precession_of_grioli_is_found() {
    let (moments, spin) = ([2.5_f64, 2.05, 1.25], [0.6, 0.0, 0.8]);
    let body = Body::parse(&["2.5", "2.05", "1.25"], &["0.6", "0", "0.8"]).unwrap();
    let c = moments[0] * 0.36 + moments[2] * 0.64;
    let b = (moments[0] - moments[2]) * 0.48;
    let across = [0.8, 0.0, -0.6];
    let size = (b * b + c * c).sqrt();
    let n = (1.0 / size).sqrt();
    let gamma: [f64; 3] = std::array::from_fn(|i| (b * spin[i] - c * across[i]) / size);
    let omega: [f64; 3] = std::array::from_fn(|i| n * (spin[i] + across[i]));
    let momentum: [f64; 3] = std::array::from_fn(|i| moments[i] * omega[i]);
    let (h, l) = (0.5 * dot(omega, momentum) - dot(gamma, spin), dot(gamma, momentum));
    assert!((h - 0.5 * n * n * (moments[1] + c)).abs() < 1e-14);
    let list = found(&body, [h, l], 2);
    let orbit = starting_at(&list, &HeavyTop::new(&body), gamma, omega).expect("Grioli's precession");
    assert!((orbit.period * n / std::f64::consts::TAU - 1.0).abs() < 1e-10, "{orbit:?}");
    assert!(orbit.symmetric && orbit.crossings == 2 && orbit.residual < 1e-12, "{orbit:?}");
    // A slightly different weight has none there: the condition matters.
    let other = Body::parse(&["2.5", "2.05", "1.25"], &["0.61", "0", "0.79"]).unwrap();
    let list = found(&other, [h, l], 2);
    assert!(starting_at(&list, &HeavyTop::new(&other), gamma, omega).is_none());
}

/// Steklov (1899): r = (ρ, 0, 0), and γ₂ = k₂ω₁ω₂, γ₃ = k₃ω₁ω₃ with ρk₂ = (A₂−A₁)(A₃−A₁)/(2A₃−A₁) and
/// ρk₃ = (A₂−A₁)(A₃−A₁)/(2A₂−A₁). Then A₂ω̇₂ and A₃ω̇₃ are those of a free body of other moments, ω₂² and ω₃² are linear in
/// x = ω₁², and ẋ² is a cubic in x: an elliptic function.
///
/// Here A₂ > A₁ > 2A₃, and at ω₁ = 0 the centre of mass is on top: γ = (−1, 0, 0), so that l = 0 and
/// h = (A₂ω₂² + A₃ω₃²)/2 + ρ with k₂(A₂−A₃)ω₂² = A₁ and ω₃²/ω₂² = (2A₂−A₁)/(A₁−2A₃).
#[test]
fn the_solution_of_steklov_is_found() {
    let [a, b, c] = [2.0_f64, 2.5, 0.9];
    let body = Body::parse(&["2", "2.5", "0.9"], &["1", "0", "0"]).unwrap();
    let k2 = (b - a) * (c - a) / (2.0 * c - a);
    let second = a / (k2 * (b - c));
    let third = second * (2.0 * b - a) / (a - 2.0 * c);
    let h = 0.5 * (b * second + c * third) + 1.0;
    // ω₂² = second − slope ω₁², ω₃² = third + rise ω₁², A₁ω̇₁ = (A₂−A₃)ω₂ω₃.
    let slope = (a - c) * a / ((2.0 * b - a) * (b - c));
    let rise = (b - a) * a / ((a - 2.0 * c) * (b - c));
    let largest = second / slope;
    let mean = agm(third.sqrt(), (third + rise * largest).sqrt());
    let period = std::f64::consts::TAU * a / ((b - c) * slope.sqrt() * mean);
    let list = found(&body, [h, 0.0], 4);
    // It is lowest where ω₂ = 0.
    let k3 = (b - a) * (c - a) / (2.0 * b - a);
    let omega = [largest.sqrt(), 0.0, (third + rise * largest).sqrt()];
    let gamma = [-1.0 + 0.5 * (k2 - k3) * a / (b - c) * largest, 0.0, k3 * omega[0] * omega[2]];
    assert!((dot(gamma, gamma) - 1.0).abs() < 1e-14);
    let top = HeavyTop::new(&body);
    let [x, _, z] = omega;
    let signs = [[x, 0.0, z], [-x, 0.0, -z]];
    let both = signs.map(|omega| starting_at(&list, &top, gamma, omega)).into_iter().flatten();
    let turned = signs.map(|[x, y, z]| starting_at(&list, &top, [gamma[0], 0.0, -gamma[2]], [x, y, -z]));
    let orbits: Vec<&PeriodicOrbit> = both.chain(turned.into_iter().flatten()).collect();
    // It goes through two of these points, and its mirror image through the two others.
    assert_eq!(orbits.len(), 2, "{:?}", list.orbits);
    for orbit in orbits {
        assert!((orbit.period / period - 1.0).abs() < 1e-10 && orbit.crossings == 4, "{orbit:?} {period}");
    }
}

/// Delone (1892): Kovalevskaya's top, A = (2, 2, 1), r = (1, 0, 0), where her integral |(ω₁+iω₂)² + γ₁+iγ₂|² is 0. Then
/// γ₁ = ω₂² − ω₁² and γ₂ = −2ω₁ω₂, so that h = 2ω₁² + ω₃²/2 and l = ω₃γ₃ − 2ω₁(ω₁² + ω₂²). With sin α = l/√(2h) and an angle u,
/// 2ω₁ = √(2h) sin u, ω₃ = √(2h) cos u, ω₁² + ω₂² = cos(u+α), γ₃ = sin(u+α), and ω̇₃ = γ₂ says u̇ = ω₂: u swings between two roots of
/// ω₂² = cos(u+α) − (h/2) sin²u, in the time 2∫du/ω₂.
#[test]
fn the_motions_of_delone_are_found() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let top = HeavyTop::new(&body);
    for (h, l) in [(1.5_f64, 0.5_f64), (2.5, 0.8)] {
        let alpha = libm::asin(l / (2.0 * h).sqrt());
        let square = |u: f64| libm::cos(u + alpha) - 0.5 * h * libm::sin(u) * libm::sin(u);
        let state = |u: f64, sign: f64| {
            let [x, z] = [0.5 * libm::sin(u), libm::cos(u)].map(|part| (2.0 * h).sqrt() * part);
            let y = sign * square(u).max(0.0).sqrt();
            let gamma = [y * y - x * x, -2.0 * x * y, libm::sin(u + alpha)];
            State { gamma, l: [2.0 * x, 2.0 * y, z] }
        };
        // It solves the equations of motion: u̇ = ω₂, by differences.
        for u in [-0.4, 0.1, 0.3] {
            let (here, step) = (state(u, 1.0), 1e-5);
            let rate = top.vector_field(&here);
            let [before, behind] = [-step, step].map(|d| state(u + d, 1.0));
            for i in 0..3 {
                let speed = 0.5 * here.l[1];
                assert!(((behind.gamma[i] - before.gamma[i]) / (2.0 * step) * speed - rate.gamma[i]).abs() < 1e-8);
                assert!(((behind.l[i] - before.l[i]) / (2.0 * step) * speed - rate.l[i]).abs() < 1e-8);
            }
            assert!((top.energy(&here) - h).abs() < 1e-14 && (dot(here.gamma, here.l) - l).abs() < 1e-14);
        }
        let root = |mut inside: f64, mut outside: f64| {
            for _ in 0..100 {
                let middle = 0.5 * (inside + outside);
                if square(middle) > 0.0 { inside = middle } else { outside = middle }
            }
            inside
        };
        let ends = [root(0.0, -1.6), root(0.0, 1.6)];
        // u = m + a sin t: the square root at the ends goes, and the rule of midpoints is exact but for rounding.
        let (middle, half, count) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]), 400);
        let at = |k: i32| {
            let t = std::f64::consts::PI * ((f64::from(k) + 0.5) / f64::from(count) - 0.5);
            half * libm::cos(t) / square(middle + half * libm::sin(t)).sqrt()
        };
        let period = 2.0 * std::f64::consts::PI / f64::from(count) * (0..count).map(at).sum::<f64>();
        let list = found(&body, [h, l], 4);
        // Her integral vanishes on the whole orbit, and on no other one.
        let integral = |orbit: &PeriodicOrbit| {
            let ([g1, g2, _], [x, y, _]) = (orbit.start.gamma, top.inverse_inertia(orbit.start.l));
            (x * x - y * y + g1).abs() + (2.0 * x * y + g2).abs()
        };
        let own: Vec<&PeriodicOrbit> =
            list.orbits.iter().map(|listed| &listed.orbit).filter(|orbit| integral(orbit) < 1e-8).collect();
        assert!(!own.is_empty(), "{:?}", list.orbits);
        for orbit in own {
            assert!((orbit.period / period - 1.0).abs() < 1e-10, "{orbit:?} {period}");
        }
    }
}

/// Goryachev (1900): A = (4, 4, 1), r = (1, 0, 0), l = 0, where Chaplygin's integral F = ω₃(ω₁² + ω₂²) + ω₁γ₃ is 0. In Chaplygin's
/// variables, u − v = ω₃ and 4uv = ω₁² + ω₂² but for factors, the polynomial of the quadratures is then s²(8(1+h) − s²)(s² + 8(1−h)),
/// and time is the sum of two elliptic integrals of the first kind: every motion has the period 8K(k), k² = (1+h)/2.
#[test]
fn the_motions_of_goryachev_are_found_as_a_continuum() {
    let body = Body::parse(&["4", "4", "1"], &["1", "0", "0"]).unwrap();
    let top = HeavyTop::new(&body);
    let setting = SectionSetting::new(&body, &"0.7".parse().unwrap(), &"0".parse().unwrap()).unwrap();
    // Other continua are near: without a limit it takes long to say that not all is decided.
    let options = ListOptions { crossings: 4, cells: 100_000 };
    let list = list(&setting, &options, &Monitor::default()).unwrap();
    let period = 2.0 * std::f64::consts::TAU / agm(1.0, (0.5 * (1.0 - 0.7_f64)).sqrt());
    let own = list.continua.iter().filter(|orbit| {
        let ([_, _, g3], [x, y, z]) = (orbit.start.gamma, top.inverse_inertia(orbit.start.l));
        (z * (x * x + y * y) + x * g3).abs() < 1e-7
    });
    let periods: Vec<f64> = own.map(|orbit| orbit.period).collect();
    assert!(!periods.is_empty(), "{:?}", list.continua);
    assert!(periods.iter().all(|found| (found / period - 1.0).abs() < 1e-9), "{periods:?} {period}");
}

/// A body whose r lies in the plane of two principal axes swings and turns over about the third like a pendulum:
/// A₂φ̈ = −|r| sin φ. Swings cross P four times in a period and turns twice.
#[test]
fn pendulum_motions_are_found_among_all_others() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let top = HeavyTop::new(&body);
    let (weight, inertia) = (top.center_norm(), 1.1_f64);
    let lowest = top.center().map(|x| x / weight);
    let start = |h: f64| [0.0, (2.0 * (h + weight) / inertia).sqrt(), 0.0];
    let pace = (inertia / weight).sqrt() * std::f64::consts::TAU;
    let swing = |h: f64| pace / agm(1.0, (0.5 * (1.0 - h / weight)).sqrt());
    let turn = |h: f64| {
        let ends = [h + weight, h - weight].map(f64::sqrt);
        (0.5 * inertia).sqrt() * std::f64::consts::TAU / agm(ends[0], ends[1])
    };
    for (h, crossings, period) in [(-0.4, 4, swing(-0.4)), (2.0, 2, turn(2.0))] {
        let list = found(&body, [h, 0.0], crossings);
        let orbit = [1.0, -1.0].into_iter().find_map(|sign| {
            let omega = start(h).map(|x| sign * x);
            starting_at(&list, &top, lowest, omega)
        });
        let orbit = orbit.expect("a pendulum");
        assert!((orbit.period / period - 1.0).abs() < 1e-10 && orbit.crossings == crossings, "{orbit:?} {period}");
    }
}

/// Lagrange: n = A₃ω₃ is constant and u = γ₃ nods between two roots of
/// f(u) = (2(h + ρu) − n²/A₃)(1 − u²)/A₁ − ((l − nu)/A₁)², in the time 2∫du/√f. Every orbit of a continuum nods a whole number of
/// times in its period, once for each pair of crossings of P.
#[test]
fn continua_of_the_lagrange_top_have_its_nutation_periods() {
    let body = Body::parse(&["2", "2", "1"], &["0", "0", "1"]).unwrap();
    let (h, l) = (3.5, 2.0);
    let list = found(&body, [h, l], 4);
    assert!(list.continua.len() >= 4, "{:?}", list.continua);
    for orbit in &list.continua {
        let n = orbit.start.l[2];
        // −f = u³ + au² − bu − c, of which the highest point is a root; by it the two others.
        let energy = h - 0.5 * n * n;
        let (a, b, c) = (energy + 0.25 * n * n, 1.0 + 0.5 * l * n, energy - 0.25 * l * l);
        let highest = orbit.start.gamma[2];
        assert!((((highest + a) * highest - b) * highest - c).abs() < 1e-11, "{orbit:?}");
        let sum = -(highest + a);
        let apart = (sum * sum + 4.0 * (b + sum * highest)).sqrt();
        let (lowest, third) = (0.5 * (sum + apart), 0.5 * (sum - apart));
        assert!(third <= -1.0 && (-1.0..highest).contains(&lowest));
        let mean = agm((highest - third).sqrt(), (lowest - third).sqrt());
        let nutation = std::f64::consts::TAU / mean;
        let times = f64::from(orbit.crossings / 2);
        assert!((orbit.period / (times * nutation) - 1.0).abs() < 1e-10, "{orbit:?} {nutation}");
    }
}
