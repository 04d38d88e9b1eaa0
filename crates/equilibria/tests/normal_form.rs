//! Birkhoff's normal form against results that are known.

use bifdiag_body::{Axis, Body};
use bifdiag_equilibria::nonlinear::{NormalForm, arnold_numerator, reduced_hamiltonian, series::Series, sixth, taylor};
use bifdiag_equilibria::stability::{Constants, LinearType, Reduced, State};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// m/|q − place| as a series in q = (q₁, q₂).
fn attraction<const D: usize>(mass: Interval, from: [Interval; 2]) -> Series<Interval, D> {
    let one = Interval::point(1.0);
    let squares = [0, 1].map(|k| {
        let coordinate = Series::variable(k, from[k], one);
        coordinate.times(&coordinate)
    });
    let square = squares[0].clone().plus(squares[1].clone());
    let start = from[0].square() + from[1].square();
    // x^(−1/2) at the start.
    let mut value = one / start.sqrt();
    let taylor = (0_u8..).map(|power| {
        let here = value;
        let n = Interval::point(f64::from(power));
        value = value * (Interval::point(-0.5) - n) / (n + one) / start;
        here
    });
    square.composed(taylor).scaled(&mass)
}

/// The Hamiltonian of the restricted three-body problem about a triangular point, for the mass μ of the smaller body.
fn at_the_triangular_point<const D: usize>(mu: Interval) -> Series<Interval, D> {
    let point = |x| Interval::point(x);
    let (one, half, minus) = (point(1.0), point(0.5), point(-1.0));
    let height = point(3.0).sqrt() * half;
    let [x, y, px, py] =
        [(0, half - mu), (1, height), (2, -height), (3, half - mu)].map(|(k, at)| Series::variable(k, at, one));
    let kinetic = px.times(&px).plus(py.times(&py)).scaled(&half);
    let turning = y.times(&px).plus(x.times(&py).scaled(&minus));
    let far = attraction(one - mu, [half, height]).scaled(&minus);
    let near = attraction(mu, [-half, height]).scaled(&minus);
    kinetic.plus(turning).plus(far).plus(near)
}

/// Triangular points of the restricted three-body problem: Deprit and Deprit-Bartholomé (Astron. J. 72, 1967). With
/// H₄ = ½(A I₁² + 2B I₁I₂ + C I₂²) and σ = ω₁ω₂
/// A = ω₂²(81 − 696ω₁² + 124ω₁⁴)/(72(1 − 2ω₁²)²(1 − 5ω₁²)), B = −σ(43 + 64σ²)/(6(4σ² − 1)(25σ² − 4)), C is A with ω₁ and ω₂
/// exchanged, and the determinant is Aω₂² + 2Bσ + Cω₁² = (36 − 541σ² + 644σ⁴)/(8(1 − 4σ²)(4 − 25σ²)).
#[test]
fn the_triangular_points_have_deprits_determinant() {
    for mu in [0.001, 0.005, 0.01, 0.012, 0.015, 0.02, 0.03, 0.038] {
        let point = |x| Interval::point(x);
        let (mu, one) = (point(mu), point(1.0));
        let hamiltonian = at_the_triangular_point(mu);
        let square = point(27.0) * mu * (one - mu) / point(4.0);
        let form = NormalForm::new(&hamiltonian, &one, &square, ()).unwrap();
        let n = point;
        let numerator = n(36.0) - n(541.0) * square + n(644.0) * square.square();
        let determinant = numerator / (n(16.0) * (one - n(4.0) * square) * (n(4.0) - n(25.0) * square));
        let [first, second] = form.omega.map(|omega| omega.square());
        let own = |this: Interval, other: Interval| {
            let numerator = other * (n(81.0) - n(696.0) * this + n(124.0) * this.square());
            numerator / (n(144.0) * (one - n(2.0) * this).square() * (one - n(5.0) * this))
        };
        let mixed = -(square.sqrt() * (n(43.0) + n(64.0) * square))
            / (n(6.0) * (n(4.0) * square - one) * (n(25.0) * square - n(4.0)));
        let known = [own(first, second), mixed, own(second, first), determinant];
        for (found, known) in form.twist.into_iter().chain([form.arnold]).zip(known) {
            let [lo, hi] = found.bounds();
            assert!(found.meet(&known).is_some(), "{found:?} {known:?}");
            assert!(hi - lo < 1e-6 * known.magnitude(), "{lo} {hi}");
        }
        assert_eq!(form.signs, [Sign::Positive, Sign::Negative]);
        // Without eigenvectors, from the coefficients alone.
        let numerator = arnold_numerator(&hamiltonian, &one, &square, ()).expect("no resonance");
        let other = numerator / (square * (one - n(4.0) * square));
        assert!(other.meet(&determinant).is_some(), "{other:?}");
        // In double precision: F and H₂ cancel as c → 0, and digits are lost beside 1:2 (c = 4/25).
        let is_narrow = width(other) < 1e-3 * determinant.magnitude();
        assert!(is_narrow || square.lo < 0.1, "{other:?}");
    }
}

/// Where the frequencies of the triangular points agree (Routh's mass), they are stable (A. G. Sokolskii, Pisma Astron. Zh. 4,
/// 1978): the numerator is positive there, where the determinant is infinite.
#[test]
fn the_triangular_points_are_stable_at_rouths_mass() {
    let point = |x| Interval::point(x);
    let (one, half) = (point(1.0), point(0.5));
    let mu = half * (one - (point(23.0) / point(27.0)).sqrt());
    let hamiltonian = at_the_triangular_point(mu);
    let numerator = arnold_numerator(&hamiltonian, &one, &point(0.25), ()).expect("no resonance of order three");
    // c(36 − 541c + 644c²)/(16(4 − 25c)) at c = ¼.
    assert!((numerator.middle().lo - 59.0 / 144.0).abs() < 1e-6, "{numerator:?}");
}

/// Where the determinant of the triangular points is 0, at the mass 0.010914, K. R. Meyer and D. S. Schmidt (J. Differ. Equ. 62,
/// 1986) went on to degree six.
#[test]
fn the_triangular_points_have_a_sixth_degree_where_deprits_determinant_is_zero() {
    let n = Interval::point;
    let (one, half) = (n(1.0), n(0.5));
    // 36 − 541c + 644c² = 0, c = 27μ(1 − μ)/4.
    let square = (n(541.0) - (n(541.0).square() - n(4.0 * 644.0 * 36.0)).sqrt()) / n(2.0 * 644.0);
    let mu = half * (one - (one - n(16.0) * square / n(27.0)).sqrt());
    let found = sixth(&at_the_triangular_point(mu), &one, &square, ()).expect("no resonance");
    assert!((found.middle().lo + 66.6).abs() < 0.1 && width(found) < 1e-3, "{mu:?} {found:?}");
}

/// Two pendulums, E(I) = I − I²/16 − I³/256 − …, in canonical coordinates that mix them.
#[test]
fn the_sixth_degree_does_not_depend_on_coordinates() {
    let n = Interval::point;
    let variable = |k: usize| Series::<Interval, 6>::variable(k, n(0.0), n(1.0));
    let [q1, q2, p1, p2] = [0, 1, 2, 3].map(variable);
    // p + ∇S for S = q₁²q₂/3 + q₁q₂² − q₂³/2.
    let [q11, q12, q22] = [q1.times(&q1), q1.times(&q2), q2.times(&q2)];
    let p1 = p1.plus(q12.clone().scaled(&(n(2.0) / n(3.0)))).plus(q22.clone());
    let p2 =
        p2.plus(q11.clone().scaled(&(n(1.0) / n(3.0)))).plus(q12.scaled(&n(2.0))).plus(q22.clone().scaled(&n(-1.5)));
    // cos q − 1 as a function of q².
    let cosine = [0.0, -0.5, 1.0 / 24.0].map(n).into_iter().chain([n(-1.0) / n(720.0)]);
    let pendulum = |p: &Series<Interval, 6>, square: &Series<Interval, 6>| {
        p.times(p).scaled(&n(0.5)).plus(square.composed(cosine.clone()).scaled(&n(-1.0)))
    };
    let ratio = 0.443;
    let hamiltonian = pendulum(&p1, &q11).plus(pendulum(&p2, &q22).scaled(&n(-ratio)));
    let square = n(ratio).square();
    let found = sixth(&hamiltonian, &(n(1.0) + square), &square, ()).expect("no resonance");
    let known = (ratio - ratio * ratio * ratio) / 256.0;
    assert!((found.middle().lo - known).abs() < 1e-9 && width(found) < 1e-6, "{found:?} {known}");
}

/// A = 2, 1.1, 1, r = 0.9, 0.2, 0.6, τ₂ ≈ −0.22, where Arnold's determinant is 0. From the amplitudes of the modes
/// `bifdiag_verify` finds the same (`stability::amplitudes`).
#[test]
fn the_sixth_degree_of_a_body() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.9", "0.2", "0.6"]).expect("a body");
    let c = Constants::rounded(&body.frame());
    let at = |delta: f64| {
        let state = State::generic(&c, Axis::ALL[1], &Interval::point(delta));
        let reduced = Reduced::new(&c, &state);
        let [b, d] = reduced.coefficients().map(Clone::clone);
        let form = NormalForm::new(&reduced_hamiltonian(&c, &state, Axis::ALL[0]), &b, &d, ()).expect("a form");
        let found = sixth(&reduced_hamiltonian(&c, &state, Axis::ALL[0]), &b, &d, ()).expect("no resonance");
        [form.arnold, found].map(|value| value.middle().lo)
    };
    let [mut lo, mut hi] = [-0.2227, -0.2177];
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if at(middle)[0] < 0.0 { lo = middle } else { hi = middle }
    }
    let [_, found] = at(lo);
    assert!((found - 14.088_934_015_872).abs() < 1e-9, "{found}");
}

/// The determinant from eigenvectors and from the coefficients alone.
#[test]
fn the_determinant_is_a_rational_function_of_the_coefficients() {
    for (c, state, reduced) in elliptic_points() {
        let [b, d] = reduced.coefficients();
        let series: Series<_> = reduced_hamiltonian(&c, &state, Axis::ALL[0]);
        let form = NormalForm::new(&series, b, d, ()).expect("a form");
        let numerator = arnold_numerator(&series, b, d, ()).expect("no resonance");
        let other = numerator / (*d * *reduced.discriminant());
        assert!(other.meet(&form.arnold).is_some(), "{other:?} {form:?}");
    }
}

/// The determinant alone, from the Taylor series in closed form and by contractions, is that of the normal form, and as narrow.
#[test]
fn the_determinant_alone_is_that_of_the_normal_form() {
    for (c, state, reduced) in elliptic_points() {
        let [b, d] = reduced.coefficients();
        for axis in Axis::ALL {
            let form = NormalForm::new(&reduced_hamiltonian(&c, &state, axis), b, d, ()).expect("a form");
            let alone = NormalForm::arnold(&taylor(&c, &state, axis), b, d, ()).expect("a form");
            assert!(alone.meet(&form.arnold).is_some(), "{alone:?} {form:?}");
            assert!(width(alone) < 10.0 * width(form.arnold), "{alone:?} {form:?}");
        }
    }
}

/// The series in closed form is the one of the products of its factors, without the constant and the linear terms.
#[test]
fn the_closed_form_of_the_series_is_that_of_its_factors() {
    for (c, state, _) in elliptic_points() {
        for axis in Axis::ALL {
            let [one, other] = [taylor(&c, &state, axis), reduced_hamiltonian(&c, &state, axis)];
            let digits = |k: u16| [k / 125 % 5, k / 25 % 5, k / 5 % 5, k % 5].map(|power| u8::try_from(power).unwrap());
            for powers in (0..625).map(digits).filter(|powers| (2..=4).contains(&powers.iter().sum::<u8>())) {
                let [one, other] = [&one, &other].map(|series| series.coefficient(powers).copied());
                let [one, other] = [one, other].map(|value| value.unwrap_or(Interval::ZERO));
                assert!(one.meet(&other).is_some(), "{powers:?} {one:?} {other:?}");
            }
        }
    }
}

/// Points of the generic family at which the linearised flow has two imaginary pairs.
fn elliptic_points() -> Vec<(Constants<Interval>, State<Interval>, Reduced<Interval>)> {
    let mut found = Vec::new();
    for (a, r) in [(["2", "1.1", "1"], ["0.9", "0.2", "0.6"]), (["3", "2", "1.5"], ["0.3", "1", "-0.7"])] {
        let body = Body::parse(&a, &r).expect("a body");
        let c = Constants::rounded(&body.frame());
        for base in Axis::ALL {
            for delta in [-4.0, -2.0, -1.0, -0.4, -0.1, -0.02, 0.02, 0.1, 0.4, 1.0, 2.0] {
                let state = State::generic(&c, base, &Interval::point(delta));
                let reduced = Reduced::new(&c, &state);
                if reduced.linear_type() == Some(LinearType::Elliptic) {
                    found.push((c.clone(), state, reduced));
                }
            }
        }
    }
    assert!(found.len() >= 20, "{}", found.len());
    found
}

/// The point is an equilibrium, and its quadratic part has the eigenvalues of Theorem 13.1.
#[test]
fn the_series_begins_with_the_linearised_flow() {
    for (c, state, reduced) in elliptic_points() {
        let series: Series<_> = reduced_hamiltonian(&c, &state, Axis::ALL[0]);
        for unit in 0..4 {
            let mut power = [0; 4];
            power[unit] = 1;
            let Some(slope) = series.coefficient(power) else { continue };
            assert!(slope.sign().is_none_or(|sign| sign == Sign::Zero), "{slope:?}");
        }
        let at = |a: usize, b: usize| {
            let mut powers = [0; 4];
            powers[a] += 1;
            powers[b] += 1;
            let value = series.coefficient(powers).copied().unwrap_or(Interval::ZERO);
            if a == b { value.twice() } else { value }
        };
        // −½ tr M² with M = (H_pq, H_pp; −H_qq, −H_qp).
        let mut b = Interval::ZERO;
        for i in 0..2 {
            for k in 0..2 {
                b = b + at(i, k) * at(2 + i, 2 + k) - at(2 + i, k) * at(2 + k, i);
            }
        }
        assert!(b.meet(reduced.coefficients()[0]).is_some(), "{b:?} {reduced:?}");
    }
}

/// The normal form does not depend on the coordinates: angles about any axis give the same.
#[test]
fn the_axis_of_the_angles_does_not_matter() {
    for (c, state, reduced) in elliptic_points() {
        let [b, d] = reduced.coefficients();
        let forms =
            Axis::ALL.map(|axis| NormalForm::new(&reduced_hamiltonian(&c, &state, axis), b, d, ()).expect("a form"));
        for other in &forms[1..] {
            assert_eq!(forms[0].signs, other.signs);
            let pairs = forms[0].twist.iter().zip(&other.twist).chain([(&forms[0].arnold, &other.arnold)]);
            for (one, other) in pairs {
                assert!(one.meet(other).is_some(), "{one:?} {other:?}");
            }
        }
        let arnold = forms.iter().map(|form| form.arnold).min_by(|p, q| width(*p).total_cmp(&width(*q)));
        let arnold = arnold.expect("three of them");
        assert!(width(arnold) < 1e-6 * arnold.magnitude(), "{arnold:?}");
    }
}

fn width(x: Interval) -> f64 {
    let [lo, hi] = x.bounds();
    hi - lo
}
