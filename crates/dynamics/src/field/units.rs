//! Units in which the numbers of a top are of moderate size.

/// A dimension as powers of the units of inertia and of time. (γ has none, so that r is an energy.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// Power of the unit of inertia.
    pub inertia: i32,
    /// Power of the unit of time.
    pub time: i32,
}

impl Dimension {
    /// Of A.
    pub const INERTIA: Self = Self { inertia: 1, time: 0 };
    /// Of times.
    pub const TIME: Self = Self { inertia: 0, time: 1 };
    /// Of ω and of Lyapunov exponents.
    pub const FREQUENCY: Self = Self { inertia: 0, time: -1 };
    /// Of l.
    pub const MOMENTUM: Self = Self { inertia: 1, time: -1 };
    /// Of h and of r.
    pub const ENERGY: Self = Self { inertia: 1, time: -2 };

    /// Unit of the derivative with respect to time.
    #[must_use]
    pub const fn rate(self) -> Self {
        Self { inertia: self.inertia, time: self.time - 1 }
    }
}

/// A unit of inertia and one of time, both powers of two, so that no number is rounded when it changes its units.
///
/// The arithmetic of an orbit would leave the range of `f64` long before the numbers of the body do: twenty
/// derivatives with respect to time are twenty factors of the frequency. All orbits are therefore computed in the
/// units of their top, in which A_max is within 2^±50 and A_max/|r| within 2^±25. Scaling A or r by 2^100 changes the
/// units and nothing else; a body whose numbers are moderate as given keeps them, since both units are powers of a
/// coarse step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TopUnits {
    /// Exponents of two.
    inertia: i32,
    time: i32,
}

/// Exponents of the units of inertia and of time are multiples of these.
const INERTIA_STEP: i32 = 100;
const TIME_STEP: i32 = 25;

impl TopUnits {
    /// Those in which numbers are given.
    pub const ONE: Self = Self { inertia: 0, time: 0 };

    /// Of a top.
    pub(super) fn of(moments: [f64; 3], center: [f64; 3]) -> Self {
        let exponent = |v: [f64; 3]| {
            let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            (largest > 0.0 && largest.is_finite()).then(|| libm::ilogb(largest))
        };
        let Some(inertia) = exponent(moments) else {
            return Self::ONE;
        };
        // The time of a pendulum, √(A/r); without weight there is none.
        let time_squared = exponent(center).map_or(0, |energy| inertia - energy);
        Self {
            inertia: nearest_multiple(inertia, INERTIA_STEP),
            time: nearest_multiple(time_squared, 2 * TIME_STEP) / 2,
        }
    }

    /// A unit of time in which a frequency is of moderate size; without weight a slow one too, since no pendulum sets the time.
    pub(super) fn of_frequency(frequency: f64, is_weightless: bool) -> Self {
        let is_usable = frequency > 0.0 && frequency.is_finite();
        let exponent = if is_usable { libm::ilogb(frequency) } else { 0 };
        let exponent = if is_weightless { exponent } else { exponent.max(0) };
        Self { inertia: 0, time: -nearest_multiple(exponent, 2 * TIME_STEP) }
    }

    /// These units, with another one of time that is given in them.
    pub(super) fn with_time_in(self, other: Self) -> Self {
        Self { inertia: self.inertia, time: self.time + other.time }
    }

    /// True for the units in which numbers are given.
    #[must_use]
    #[inline]
    pub fn are_one(self) -> bool {
        self == Self::ONE
    }

    /// A given number in these units.
    #[must_use]
    #[inline]
    pub fn reduce(self, x: f64, dimension: Dimension) -> f64 {
        if self.are_one() { x } else { libm::scalbn(x, -self.exponent(dimension)) }
    }

    /// A number in these units as it would be given.
    #[must_use]
    #[inline]
    pub fn restore(self, x: f64, dimension: Dimension) -> f64 {
        if self.are_one() { x } else { libm::scalbn(x, self.exponent(dimension)) }
    }

    fn exponent(self, dimension: Dimension) -> i32 {
        dimension.inertia * self.inertia + dimension.time * self.time
    }
}

/// The multiple of `step` nearest to k, the upper one of two.
fn nearest_multiple(k: i32, step: i32) -> i32 {
    (k + step / 2).div_euclid(step) * step
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_move_with_the_body() {
        let power = |e: i32| libm::scalbn(1.0, e);
        for a in (-300..300).step_by(7) {
            for r in (-300..300).step_by(11) {
                let of = |da: i32, dr: i32| {
                    TopUnits::of(
                        [0.3, 1.7, 0.2].map(|x| x * power(a + da)),
                        [0.0, 1.9 * power(r + dr), power(r + dr - 60)],
                    )
                };
                let TopUnits { inertia, time } = of(0, 0);
                assert_eq!(of(100, 0), TopUnits { inertia: inertia + 100, time: time + 50 });
                assert_eq!(of(0, 100), TopUnits { inertia, time: time - 50 });
                assert!((a - inertia).abs() <= 50 && (a - r - 2 * time).abs() <= 25);
            }
        }
    }

    #[test]
    fn moderate_bodies_keep_their_numbers() {
        for a in [1e-3, 0.2, 1.0, 1e4] {
            for r in [1e-3, 0.5, 30.0] {
                assert!(TopUnits::of([a, 0.7 * a, 0.9 * a], [0.0, r, 0.3 * r]).are_one(), "{a} {r}");
            }
        }
        assert!(TopUnits::of([2.0, 1.0, 1.0], [0.0; 3]).are_one());
    }

    #[test]
    fn numbers_come_back_as_they_were() {
        let units = TopUnits::of([1e60, 2e60, 1.5e60], [1e-30, 0.0, 3e-31]);
        assert!(!units.are_one());
        for dimension in [Dimension::INERTIA, Dimension::TIME, Dimension::ENERGY.rate().rate()] {
            for x in [0.0, 1.1e7, -3.3e-12, f64::INFINITY] {
                assert_eq!(units.restore(units.reduce(x, dimension), dimension), x);
            }
        }
    }
}
