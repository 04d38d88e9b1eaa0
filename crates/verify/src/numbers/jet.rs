//! A function along a line with its first two derivatives, enclosed.

use std::ops::{Add, Mul, Sub};

use super::interval::Interval;

/// f, f′ and f″/2 over a range of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet(pub [Interval; 3]);

impl Jet {
    pub fn constant(x: Interval) -> Self {
        Self([x, Interval::point(0.0), Interval::point(0.0)])
    }

    /// start + t·direction.
    pub fn line(start: Interval, direction: Interval, t: Interval) -> Self {
        Self([start + t * direction, direction, Interval::point(0.0)])
    }

    pub fn times(self, factor: Interval) -> Self {
        Self(self.0.map(|c| c * factor))
    }

    pub fn square(self) -> Self {
        let [f, g, h] = self.0;
        Self([f.square(), Interval::point(2.0) * f * g, Interval::point(2.0) * f * h + g.square()])
    }

    /// 1/f: f′ and f″/2 become −f′/f² and (f′²/f − f″/2)/f².
    pub fn recip(self) -> Self {
        let [f, g, h] = self.0;
        let inverse = f.recip();
        let square = inverse.square();
        Self([inverse, -(g * square), (g.square() * inverse - h) * square])
    }

    /// √f: f′ and f″/2 become f′/(2√f) and (f″/2 − (f′/(2√f))²)/(2√f).
    pub fn sqrt(self) -> Self {
        let [f, g, h] = self.0;
        let root = f.sqrt();
        let half = Interval::point(0.5) * root.recip();
        let slope = g * half;
        Self([root, slope, (h - slope.square()) * half])
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [p, q, r]) = (self.0, other.0);
        Self([a + p, b + q, c + r])
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [p, q, r]) = (self.0, other.0);
        Self([a - p, b - q, c - r])
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [p, q, r]) = (self.0, other.0);
        Self([a * p, a * q + b * p, a * r + b * q + c * p])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// f(t) = 1 + 2t + 3t² at t = 0, so that 1/f = 1 − 2t + t² + …, √f = 1 + t + t² + …, f² = 1 + 4t + 10t² + ….
    #[test]
    fn derivatives_are_those_of_power_series() {
        let f = Jet([1.0, 2.0, 3.0].map(Interval::point));
        for (found, expected) in [
            (f.recip(), [1.0, -2.0, 1.0]),
            (f.sqrt(), [1.0, 1.0, 1.0]),
            (f.square(), [1.0, 4.0, 10.0]),
            (f * f, [1.0, 4.0, 10.0]),
            (f - f.square(), [0.0, -2.0, -7.0]),
            (Jet::line(Interval::point(1.0), Interval::point(2.0), Interval::point(3.0)), [7.0, 2.0, 0.0]),
        ] {
            for (set, number) in found.0.into_iter().zip(expected) {
                let off = set - Interval::point(number);
                assert!(off.sign().is_none() && off.middle().abs() < 1e-14, "{found:?} is not {expected:?}");
            }
        }
    }
}
