//! The twist of the normal form against orbits: frequencies of integrated tori of small amplitude, measured by weighted
//! averages, extrapolated to amplitude 0. Nothing here knows the reduced Hamiltonian.

mod whole;

use bifdiag_body::{Axis, Body, Frame};
use bifdiag_equilibria::nonlinear::{Question, Setting};
use bifdiag_equilibria::stability::{Constants, LinearType, Reduced, State};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::vector::{cross, dot};
use nalgebra::{Complex, SMatrix, SVector};

type Vector = SVector<Complex<f64>, 6>;
type Matrix = SMatrix<Complex<f64>, 6, 6>;

/// A relative equilibrium in the frame, and its linearised flow.
struct Top<'a> {
    frame: &'a Frame,
    gamma: [f64; 3],
    omega: f64,
    flow: Matrix,
}

impl Top<'_> {
    fn velocity(&self, y: [f64; 6]) -> [f64; 6] {
        let [gamma, l] = [[y[0], y[1], y[2]], [y[3], y[4], y[5]]];
        let omega: [f64; 3] = std::array::from_fn(|k| l[k] / self.frame.a[k]);
        let (turn, drag, weight) = (cross(gamma, omega), cross(l, omega), cross(gamma, self.frame.r));
        std::array::from_fn(|k| if k < 3 { turn[k] } else { drag[k - 3] - weight[k - 3] })
    }

    fn step(&self, y: [f64; 6], time: f64) -> [f64; 6] {
        let moved = |slope: [f64; 6], time: f64| std::array::from_fn(|k| y[k] + time * slope[k]);
        let first = self.velocity(y);
        let second = self.velocity(moved(first, 0.5 * time));
        let third = self.velocity(moved(second, 0.5 * time));
        let fourth = self.velocity(moved(third, time));
        std::array::from_fn(|k| y[k] + time / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]))
    }

    fn rest(&self) -> [f64; 6] {
        std::array::from_fn(
            |k| if k < 3 { self.gamma[k] } else { self.omega * self.frame.a[k - 3] * self.gamma[k - 3] },
        )
    }

    /// A vector that a matrix takes to iω times itself, by inverse iteration.
    fn eigenvector(matrix: &Matrix, frequency: f64) -> Vector {
        let shift = Complex::new(1e-10, frequency * (1.0 + 1e-11));
        let solver = (matrix - Matrix::identity() * shift).lu();
        let start = [0.3, -0.7, 0.5, 0.9, 0.2, -0.4];
        let mut v = Vector::from_fn(|k, _| Complex::new(start[k], start[5 - k]));
        for _ in 0..5 {
            v = solver.solve(&v).expect("a shifted matrix");
            v /= Complex::new(v.norm(), 0.0);
        }
        v
    }

    /// Twice the energy of a disturbance, to second order, with multipliers for both Casimirs.
    fn energy(&self, x: &Vector) -> f64 {
        let part = |at: usize| -> [f64; 3] { std::array::from_fn(|k| x[at + k].re) };
        let (gamma, l) = (part(0), part(3));
        let turning: [f64; 3] = std::array::from_fn(|k| self.frame.a[k] * self.gamma[k] * self.omega);
        let beta = -(dot(self.gamma, self.frame.r) + self.omega * dot(self.gamma, turning));
        let kinetic: f64 = (0..3).map(|k| l[k] * l[k] / self.frame.a[k]).sum();
        kinetic - 2.0 * self.omega * dot(gamma, l) - beta * dot(gamma, gamma)
    }

    /// The mean frequencies of both modes on the orbit of a disturbance at fixed l.
    fn frequencies(&self, disturbance: &Vector, modes: &[Vector; 2], near: [f64; 2]) -> [f64; 2] {
        const STEPS: u32 = 60_000;
        let time = 0.02 / near[0].max(1.0);
        let rest = self.rest();
        let moment: f64 = dot(self.gamma, [rest[3], rest[4], rest[5]]);
        let mut y: [f64; 6] = std::array::from_fn(|k| rest[k] + disturbance[k].re);
        let length = dot([y[0], y[1], y[2]], [y[0], y[1], y[2]]).sqrt();
        (0..3).for_each(|k| y[k] /= length);
        let excess = moment - dot([y[0], y[1], y[2]], [y[3], y[4], y[5]]);
        (0..3).for_each(|k| y[k + 3] += excess * y[k]);
        let phase = |y: &[f64; 6]| {
            modes.each_ref().map(|mode| {
                let z = (0..6).fold(Complex::new(0.0, 0.0), |sum, k| sum + mode[k] * (y[k] - rest[k]));
                libm::atan2(z.im, z.re)
            })
        };
        let (mut sums, mut total) = ([0.0; 2], 0.0);
        let mut last = phase(&y);
        for n in 1..STEPS {
            y = self.step(y, time);
            let now = phase(&y);
            let share = f64::from(n) / f64::from(STEPS);
            // A smooth bump: averages of quasi-periodic functions converge faster than any power.
            let weight = libm::exp(-1.0 / (share * (1.0 - share)));
            for k in 0..2 {
                let turn = now[k] - last[k];
                let whole = ((turn - near[k] * time) / std::f64::consts::TAU).round();
                sums[k] += weight * (turn - whole * std::f64::consts::TAU) / time;
            }
            total += weight;
            last = now;
        }
        sums.map(|sum| sum / total)
    }
}

#[test]
fn the_twist_is_that_of_integrated_tori() {
    let mut compared = 0;
    for (a, r) in [(["2", "1.1", "1"], ["0.9", "0.2", "0.6"]), (["3", "2", "1.5"], ["0.3", "1", "-0.7"])] {
        let body = Body::parse(&a, &r).expect("a body");
        let frame = body.frame();
        let c = Constants::rounded(&frame);
        for (base, delta) in [(0, -0.1), (0, 0.05), (0, 0.1), (0, -0.3)] {
            let state = State::generic(&c, Axis::ALL[base], &Interval::point(delta));
            let reduced = Reduced::new(&c, &state);
            let kind = LinearType::Elliptic;
            if reduced.linear_type() != Some(kind) || reduced.index(state.hessian_trace(&c).sign()) != Some(2) {
                continue;
            }
            let setting = Setting { index: 2, minimum: None, integral: false };
            let form =
                Question { c: &c, state: &state, reduced: &reduced, kind, setting }.normal_form().expect("a form");
            let known = form.twist.map(|k| k.middle().lo);
            let omega = state.s.middle().lo.sqrt();
            let gamma = Axis::ALL.map(|k| state.w[k].middle().lo.sqrt().copysign(state.tau[k].middle().lo));
            let matrix = whole::matrix(&frame, gamma, omega);
            let flow = Matrix::from_fn(|i, j| Complex::new(matrix[i][j], 0.0));
            let top = Top { frame: &frame, gamma, omega, flow };
            let near = form.omega.map(|x| x.middle().lo * omega);
            let spectrum = whole::spectrum(&matrix);
            assert!(near.iter().all(|x| spectrum.iter().any(|y| (y.im - x).abs() < 1e-6 * x)), "{near:?} {spectrum:?}");
            let modes = near.map(|x| Top::eigenvector(&top.flow, x));
            let duals = near.map(|x| Top::eigenvector(&top.flow.transpose(), x));
            // Amplitudes whose actions are a² and a²/4, and the other way round.
            let units: [f64; 2] = std::array::from_fn(|k| {
                let real = modes[k].map(|x| Complex::new(x.re, 0.0));
                (0.5 * top.energy(&real).abs() / near[k]).sqrt()
            });
            let mut found = Vec::new();
            for size in [0.024, 0.012, 0.006] {
                let orbit = |first: f64, second: f64| {
                    let amounts = [first / units[0], second / units[1]];
                    let mut mean = [0.0; 2];
                    for signs in [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]] {
                        let x = modes[0].map(|x| x * (signs[0] * amounts[0]))
                            + modes[1].map(|x| x * (signs[1] * amounts[1]));
                        let frequencies = top.frequencies(&x, &duals, near);
                        (0..2).for_each(|k| mean[k] += frequencies[k] / 4.0);
                    }
                    mean
                };
                let still = orbit(1e-3 * size, 1e-3 * size);
                let (one, other) = (orbit(size, 0.5 * size), orbit(0.5 * size, size));
                let unit = size * size;
                // dθ₁/dt = ω₁ + 2K₁₁I₁ + K₁₂I₂ and −dθ₂/dt = ω₂ − K₁₂I₁ − 2K₂₂I₂.
                let shift = |of: [f64; 2]| [(of[0] - still[0]) / unit, (still[1] - of[1]) / unit];
                let (p, q) = (shift(one), shift(other));
                let solve = |p: f64, q: f64| [(4.0 * p - q) * 4.0 / 15.0, (4.0 * q - p) * 4.0 / 15.0];
                let (first, second) = (solve(p[0], q[0]), solve(p[1], q[1]));
                found.push([first[0] / 2.0, first[1], second[0], second[1] / 2.0]);
            }
            let scale = known.iter().fold(0.0_f64, |size, k| size.max(k.abs()));
            // The error is a series in the square of the amplitude.
            let at_zero: [f64; 4] = std::array::from_fn(|k| {
                let once = |n: usize| found[n + 1][k] + (found[n + 1][k] - found[n][k]) / 3.0;
                once(1) + (once(1) - once(0)) / 15.0
            });
            for (value, known) in at_zero.into_iter().zip([known[0], known[1], known[1], known[2]]) {
                assert!((value - known).abs() < 3e-6 * scale, "{a:?} {delta}: {known:?} {at_zero:?} {found:?}");
            }
            compared += 1;
        }
    }
    assert!(compared >= 3, "{compared}");
}
