//! The cubic inequality whose solution is U_hl, in spherical coordinates about r̂, with enclosures.

use super::angle::{Trig, within};
use bifdiag_body::Frame;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// G(γ) = 2J(γ)(h + ⟨γ,r⟩) − l², whose sign for l ≠ 0 says whether γ is in U_hl = {G ≥ 0}.
///
/// With γ = cos ϑ r̂ + sin ϑ (cos ψ e1 + sin ψ e2), where e2 lies in the plane of r̂ and the frame axis k
/// on which r has its smallest component,
/// J − a_k = constant + axial cos 2ϑ + sin 2ϑ (p1 cos ψ + p2 sin ψ) + sin²ϑ (α cos 2ψ + β sin 2ψ).
/// All coefficients are closed formulas in the exact differences of moments: p and β vanish exactly for the bodies
/// for which they should, and nothing is lost when moments are nearly equal.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// 2 a_k h − l².
    base: Interval,
    twice_h: Interval,
    r: Interval,
    /// a_k.
    moment: Interval,
    /// [a_1 − a_k, a_3 − a_k], the range of J − a_k.
    range: Interval,
    constant: Interval,
    axial: Interval,
    p: [Interval; 2],
    alpha: Interval,
    beta: Interval,
    /// e1 and e2 in the frame, rounded.
    pub tangent: [[f64; 3]; 2],
    /// r̂ in the frame, rounded; the third axis when r = 0.
    pub pole: [f64; 3],
}

/// G and its derivatives over a box of (ϑ, ψ) or at a point, each enclosed when it is asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patch<'a> {
    level: &'a Level,
    theta: &'a Trig,
    psi: &'a Trig,
    /// p1 cos ψ + p2 sin ψ.
    outward: Interval,
    /// α cos 2ψ + β sin 2ψ.
    quadrupole: Interval,
    /// J − a_k.
    excess: Interval,
}

impl Level {
    /// For finite h and l.
    pub fn new(frame: &Frame, h: f64, l: f64) -> Self {
        let r_hat = if frame.is_euler() {
            [Interval::ZERO, Interval::ZERO, Interval::ONE]
        } else {
            frame.r.map(|x| Interval::rounded(x) / Interval::rounded(frame.r_norm))
        };
        let k = if frame.is_euler() || (frame.r[0] <= frame.r[1] && frame.r[0] <= frame.r[2]) {
            0
        } else if frame.r[1] <= frame.r[2] {
            1
        } else {
            2
        };
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let above = |x: usize| Interval::rounded(frame.diff[x][k]);
        let [x, y, z] = [r_hat[i], r_hat[j], r_hat[k]];
        let (x2, y2) = (x.square(), y.square());
        let n2 = x2 + y2;
        let n = n2.sqrt();
        let axis = if frame.is_euler() { above(i) * x2 + above(j) * y2 } else { -Interval::rounded(frame.offset[k]) };
        let across = (y2 * above(i) + x2 * above(j)) / n2;
        let along = z.square() * (x2 * above(i) + y2 * above(j)) / n2;
        let mean = (across + along) * 0.5;
        let (h, l, moment) = (Interval::rounded(h), Interval::rounded(l), Interval::rounded(frame.a[k]));
        let middle = |u: Interval| 0.5 * (u.lo + u.hi);
        let (mx, my, mz, mn) = (middle(x), middle(y), middle(z), middle(n));
        let mut tangent = [[0.0; 3]; 2];
        tangent[0][i] = -my / mn;
        tangent[0][j] = mx / mn;
        tangent[1][i] = -mx * mz / mn;
        tangent[1][j] = -my * mz / mn;
        tangent[1][k] = mn;
        Self {
            base: (moment * h).twice() - l.square(),
            twice_h: h.twice(),
            r: Interval::rounded(frame.r_norm),
            moment,
            range: above(0).hull(&above(2)),
            constant: (axis + mean) * 0.5,
            axial: (axis - mean) * 0.5,
            p: [x * y * Interval::rounded(frame.diff[j][i]) / n, -(z * (x2 * above(i) + y2 * above(j))) / n],
            alpha: (across - along) * 0.5,
            beta: x * y * z * Interval::rounded(frame.diff[i][j]) / n2,
            tangent,
            pole: r_hat.map(middle),
        }
    }

    /// G over a box.
    pub fn over<'a>(&'a self, theta: &'a Trig, psi: &'a Trig) -> Patch<'a> {
        let outward = self.p[0] * psi.cos + self.p[1] * psi.sin;
        let quadrupole = self.alpha * psi.cos_double + self.beta * psi.sin_double;
        let excess = self.constant
            + self.axial * theta.cos_double
            + theta.sin_double * outward
            + theta.sin.square() * quadrupole;
        Patch { level: self, theta, psi, outward, quadrupole, excess: within(excess, self.range) }
    }

    /// The values of G over a box.
    pub fn value(&self, theta: &Trig, psi: &Trig) -> Interval {
        self.over(theta, psi).value()
    }

    /// h + ⟨γ,r⟩ over a range of latitudes.
    pub fn height(&self, theta: &Trig) -> Interval {
        self.twice_h * 0.5 + self.r * theta.cos
    }
}

impl Patch<'_> {
    /// G.
    pub fn value(&self) -> Interval {
        let Self { level, theta, excess, .. } = *self;
        let twice_height = level.twice_h + (level.r * theta.cos).twice();
        level.base + excess * twice_height + (level.moment * level.r * theta.cos).twice()
    }

    /// h + ⟨γ,r⟩.
    pub fn height(&self) -> Interval {
        self.level.height(self.theta)
    }

    /// H = ∂J/∂ψ / (2 sin ϑ), which is regular at the poles.
    pub fn turning(&self) -> Interval {
        let Self { level, theta, psi, .. } = *self;
        let sideways = level.p[1] * psi.cos - level.p[0] * psi.sin;
        let quadrupole_slope = level.beta * psi.cos_double - level.alpha * psi.sin_double;
        theta.cos * sideways + theta.sin * quadrupole_slope
    }

    /// ∂G/∂ϑ.
    pub fn meridional(&self) -> Interval {
        let Self { level, theta, outward, quadrupole, excess, .. } = *self;
        let j = level.moment + excess;
        let j_slope = theta.sin_double * (quadrupole - level.axial.twice()) + (theta.cos_double * outward).twice();
        (j_slope * self.height() - j * level.r * theta.sin).twice()
    }

    /// ∂G/∂ψ = 2 (h + ⟨γ,r⟩) ∂J/∂ψ = 4 sin ϑ (h + ⟨γ,r⟩) H.
    pub fn parallel(&self, turning: Interval) -> Interval {
        (self.theta.sin * self.height() * turning).twice().twice()
    }
}

/// How far G may be from its value at a point of a box, by the mean value theorem: `slope` is its derivative in one direction,
/// `reach` the largest distance from that point in this direction.
pub(super) fn variation(slope: Interval, reach: f64) -> f64 {
    (slope.magnitude() * reach).next_up()
}

#[cfg(test)]
mod tests {
    use super::super::angle::Longitude;
    use super::*;
    use bifdiag_body::Body;

    const BODIES: [([&str; 3], [&str; 3]); 6] = [
        (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
        (["0.3", "1.7", "0.9"], ["-0.4", "2.1", "0.7"]),
        (["1.7", "0.9", "0.3"], ["0.1", "-0.05", "3"]),
        (["2", "2", "1"], ["1", "0.3", "-0.2"]),
        (["1", "1.0000000003", "1.273"], ["0", "0", "-2"]),
        (["1", "1.5", "2"], ["0", "0", "0"]),
    ];

    fn middle(x: Interval) -> f64 {
        0.5 * (x.lo + x.hi)
    }

    #[test]
    fn the_polynomial_in_spherical_coordinates_is_g() {
        let (h, l) = (1.25, 1.5);
        for (a, r) in BODIES {
            let frame = Body::parse(&a, &r).unwrap().frame();
            let level = Level::new(&frame, h, l);
            for (t, quadrant, u) in [(0.0, 0, 0.0), (0.3, 0, 0.7), (1.2, 1, 0.2), (0.8, 2, 0.9), (3.0, 3, 0.4)] {
                let (theta, psi) = (Trig::at(t), Longitude::new(quadrant, u).trig());
                let (c, s) = (middle(theta.cos), middle(theta.sin));
                let (x, y) = (middle(psi.cos), middle(psi.sin));
                let gamma: [f64; 3] = std::array::from_fn(|i| {
                    c * level.pole[i] + s * (x * level.tangent[0][i] + y * level.tangent[1][i])
                });
                let j: f64 = (0..3).map(|i| frame.a[i] * gamma[i] * gamma[i]).sum();
                let height = h + (0..3).map(|i| frame.r[i] * gamma[i]).sum::<f64>();
                let expected = 2.0 * j * height - l * l;
                let value = level.value(&theta, &psi);
                assert!((middle(value) - expected).abs() < 1e-13 && value.hi - value.lo < 1e-13, "{a:?} {r:?}");
            }
        }
    }

    #[test]
    fn slopes_are_the_derivatives() {
        let step = 1e-5;
        for (a, r) in BODIES {
            let level = Level::new(&Body::parse(&a, &r).unwrap().frame(), 1.25, 1.5);
            for (t, u) in [(0.3, 0.7), (0.9, 0.2), (2.0, 0.5)] {
                let value = |t: f64, u: f64| middle(level.value(&Trig::at(t), &Longitude::new(1, u).trig()));
                let (theta, psi) = (Trig::at(t), Longitude::new(1, u).trig());
                let here = level.over(&theta, &psi);
                // dx/dt = 2/(1 + t²) for x = 2 arctan t.
                let along_meridian = (value(t + step, u) - value(t - step, u)) / (2.0 * step) * (1.0 + t * t) / 2.0;
                let along_parallel = (value(t, u + step) - value(t, u - step)) / (2.0 * step) * (1.0 + u * u) / 2.0;
                let parallel = middle(here.parallel(here.turning()));
                assert!((middle(here.meridional()) - along_meridian).abs() < 1e-7, "{a:?} {r:?}");
                assert!((parallel - along_parallel).abs() < 1e-7, "{a:?} {r:?}");
            }
        }
    }
}
