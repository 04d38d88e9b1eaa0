//! Mass properties about the centre of mass, about the fixed point and under gravity, and whether they can exist.

use std::fmt;

use bifdiag_numbers::decimal::short;
use bifdiag_numbers::symmetric::{PrincipalAxes, Real, Symmetric, dot};
use dashu_int::IBig;
use dashu_ratio::RBig;
use thiserror::Error;

use super::units::Units;
use crate::principal::PrincipalForm;
use crate::rigid_body::{Tensor, TensorError};

/// Mass, centre of mass and tensor of inertia, exactly, in units of their own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MassProperties {
    /// The mass, positive.
    pub mass: RBig,
    /// The centre of mass from the origin.
    pub com: [RBig; 3],
    /// The tensor about the centre of mass.
    pub about_com: Symmetric,
}

/// Why numbers are not the mass properties of a part.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum MassError {
    /// The mass is zero or negative.
    #[error("the mass {value} is not positive")]
    NotPositive {
        /// As a decimal.
        value: String,
    },
}

/// A part under gravity whose fixed point is the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its mass properties, in `units`.
    pub properties: MassProperties,
    /// The acceleration of gravity in m/s².
    pub gravity: RBig,
    /// Units of everything.
    pub units: Units,
}

impl MassProperties {
    /// From a tensor about the centre of mass.
    ///
    /// # Errors
    /// [`MassError::NotPositive`].
    pub fn about_com(mass: RBig, com: [RBig; 3], tensor: Symmetric) -> Result<Self, MassError> {
        if mass <= RBig::ZERO {
            return Err(MassError::NotPositive { value: bifdiag_numbers::decimal::short(&mass) });
        }
        Ok(Self { mass, com, about_com: tensor })
    }

    /// From a tensor about the origin.
    ///
    /// # Errors
    /// [`MassError::NotPositive`].
    pub fn about_origin(mass: RBig, com: [RBig; 3], tensor: &Symmetric) -> Result<Self, MassError> {
        let shift = parallel_axis(&com);
        let about_com = tensor.plus(&-mass.clone(), &shift);
        Self::about_com(mass, com, about_com)
    }

    /// The tensor about the origin: I_com + m (|c|² E − c cᵀ), the parallel-axis theorem.
    #[must_use]
    pub fn tensor_about_origin(&self) -> Symmetric {
        self.about_com.plus(&self.mass, &parallel_axis(&self.com))
    }

    /// The same part, its origin moved to a point.
    #[must_use]
    pub fn seen_from(mut self, origin: &[RBig; 3]) -> Self {
        for (c, o) in self.com.iter_mut().zip(origin) {
            *c -= o;
        }
        self
    }

    /// The same part in other units.
    #[must_use]
    pub fn in_units(&self, from: &Units, to: &Units) -> Self {
        let (mass, length) = (from.mass() / to.mass(), from.length() / to.length());
        let moment = &mass * &length * &length;
        Self {
            mass: &self.mass * &mass,
            com: self.com.each_ref().map(|c| c * &length),
            about_com: self.about_com.map(|_, _, x| x * &moment),
        }
    }

    /// Whether it can exist.
    #[must_use]
    pub fn existence(&self) -> Existence {
        Existence::of(&self.about_com)
    }
}

impl Part {
    /// r = m g c, in the units of the part.
    #[must_use]
    pub fn weighted_center(&self) -> [RBig; 3] {
        let weight = &self.properties.mass * self.units.acceleration(&self.gravity);
        self.properties.com.each_ref().map(|c| c * &weight)
    }

    /// The body about the fixed point, in principal axes.
    ///
    /// # Errors
    /// [`TensorError`] for a tensor that is not positive definite.
    pub fn principal(&self) -> Result<PrincipalForm, TensorError> {
        Tensor::new(self.properties.tensor_about_origin(), self.weighted_center())?.principal()
    }
}

/// |c|² E − c cᵀ.
fn parallel_axis(c: &[RBig; 3]) -> Symmetric {
    Symmetric::outer(c).subtracted_from(&dot(c, c))
}

/// What the three products of a list Ixx, Iyy, Izz, Ixy, Ixz, Iyz are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Products {
    /// Entries of the tensor: Ixy = −∫ x y dm.
    Tensor,
    /// The integrals: Ixy = +∫ x y dm.
    Integral,
}

/// The tensor of a list Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
#[must_use]
pub fn tensor_of(list: [RBig; 6], products: Products) -> Symmetric {
    match products {
        Products::Tensor => Symmetric::new(list),
        Products::Integral => {
            let [xx, yy, zz, xy, xz, yz] = list;
            Symmetric::new([xx, yy, zz, -xy, -xz, -yz])
        }
    }
}

/// Whether a part can exist, judged about its centre of mass; decided exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Existence {
    /// Each principal moment is less than the sum of the other two.
    Solid,
    /// The largest is the sum of the others: a flat body, a rod or a point.
    Flat,
    /// It cannot exist.
    Impossible(Inequality),
}

/// The triangle inequality of the principal moments about the centre of mass that fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Inequality {
    /// The principal moments, ascending, to far more digits than [`missing`](Self::missing) needs.
    pub moments: [RBig; 3],
    /// What is missing on the smaller side: I3 − I1 − I2.
    pub missing: RBig,
}

impl Existence {
    /// Judges the tensor about the centre of mass: the second moments ∫ x xᵀ dm = (tr I / 2) E − I must be positive
    /// semidefinite.
    #[must_use]
    pub fn of(about_com: &Symmetric) -> Self {
        let second = about_com.subtracted_from(&(about_com.trace() / RBig::from(2)));
        if second.is_positive_semidefinite() {
            return if second.determinant().is_zero() { Self::Flat } else { Self::Solid };
        }
        Self::Impossible(Inequality::of(about_com))
    }

    /// Whether it can exist.
    #[must_use]
    pub fn is_possible(&self) -> bool {
        !matches!(self, Self::Impossible(_))
    }
}

impl Inequality {
    /// That of a tensor about the centre of mass which fails.
    fn of(about_com: &Symmetric) -> Self {
        let mut failed = Self { moments: [RBig::ZERO, RBig::ZERO, RBig::ZERO], missing: RBig::ZERO };
        // However small the difference, these digits show it.
        for digits in [30_u8, 60, 120, 240] {
            let axes = PrincipalAxes::new(about_com, &[RBig::ZERO, RBig::ZERO, RBig::ZERO], digits.into());
            let mut values = axes.values;
            values.sort_by(|x, y| x.lo.cmp(&y.lo));
            let [a, b, c] = values.map(|value: Real| value.lo);
            let missing = &c - &a - &b;
            let is_sure = missing > (&a + &b).max(c.clone()) * ten_to(10 - i64::from(digits));
            failed = Self { moments: [a, b, c], missing };
            if is_sure {
                break;
            }
        }
        failed
    }

    /// The moments as they are printed: the inequality of the printed numbers fails by what is missing, to a hundredth of it.
    fn printed(&self) -> [RBig; 3] {
        let with = |digits: i64| self.moments.each_ref().map(|x| rounded(x, digits));
        let fails_so = |[a, b, c]: &[RBig; 3]| {
            let error = c - a - b - &self.missing;
            error.clone().max(-error) * RBig::from(100) <= self.missing
        };
        (DIGITS..=DIGITS_MAX).map(with).find(fails_so).unwrap_or_else(|| self.moments.clone())
    }
}

impl fmt::Display for Inequality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.printed().map(|x| short(&x));
        if self.moments[0] < RBig::ZERO {
            return write!(f, "the least principal moment is negative: {a}");
        }
        let missing = short(&rounded(&self.missing, DIGITS));
        write!(
            f,
            "the two smaller principal moments add up to less than the largest: {a} + {b} < {c}, {missing} is missing"
        )
    }
}

/// Digits of a moment, where they suffice.
const DIGITS: i64 = 7;
/// The most digits of one.
const DIGITS_MAX: i64 = 240;

/// Rounded to this many digits.
fn rounded(x: &RBig, digits: i64) -> RBig {
    // From the nearest double, or one next to it.
    let exponent = format!("{:e}", x.to_f64().value()).split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    let scale = ten_to(digits - 1 - exponent.unwrap_or(0));
    RBig::from((x * &scale).round()) / scale
}

/// 10^power.
fn ten_to(power: i64) -> RBig {
    let ten = RBig::from(IBig::from(10).pow(usize::try_from(power.unsigned_abs()).unwrap_or(0)));
    if power < 0 { RBig::ONE / ten } else { ten }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_numbers::Number;

    fn value(text: &str) -> RBig {
        text.parse::<Number>().unwrap().value().clone()
    }

    /// A rod of 1 kg and 1 m, 20 m from the pivot, as its CAD writes it about the pivot: still a rod, exactly.
    #[test]
    fn a_far_rod_stays_a_rod() {
        let com = ["20", "0", "0"].map(value);
        let about_com = Symmetric::diagonal([RBig::ZERO, value("1/12"), value("1/12")]);
        let rod = MassProperties::about_com(RBig::ONE, com.clone(), about_com.clone()).unwrap();
        let about_pivot = rod.tensor_about_origin();
        assert_eq!(about_pivot.rows()[1][1], value("4801/12"));
        assert_eq!(MassProperties::about_origin(RBig::ONE, com, &about_pivot).unwrap(), rod);
        assert_eq!(rod.existence(), Existence::Flat);
    }

    #[test]
    fn moving_the_origin_there_and_back_changes_nothing() {
        let com = ["1/3", "-2", "0.7"].map(value);
        let part = MassProperties::about_com(
            value("2.5"),
            com,
            Symmetric::new(["3", "4", "5", "0.1", "-0.2", "0.3"].map(value)),
        )
        .unwrap();
        let away = ["7", "-1/7", "1e-9"].map(value);
        let back = away.clone().map(|x| -x);
        assert_eq!(part.clone().seen_from(&away).seen_from(&back), part);
    }

    #[test]
    fn units_change_nothing_but_the_numbers() {
        let com = ["1", "2", "3"].map(value);
        let part =
            MassProperties::about_com(value("2.5"), com, Symmetric::diagonal(["3", "4", "5"].map(value))).unwrap();
        let (si, other): (Units, Units) = (Units::default(), "lb,in,s".parse().unwrap());
        assert_eq!(part.in_units(&si, &other).in_units(&other, &si), part);
        let small = part.in_units(&si, &"g,mm,s".parse().unwrap());
        assert_eq!(small.about_com.rows()[0][0], value("3e9"));
        assert_eq!(small.tensor_about_origin().rows()[1][2], value("-2.5e9") * RBig::from(6));
    }

    #[test]
    fn weight_is_in_the_units_of_the_part() {
        let com = [RBig::ZERO, RBig::ZERO, RBig::from(10)];
        let properties =
            MassProperties::about_com(RBig::from(2), com, Symmetric::diagonal([RBig::ONE, RBig::ONE, RBig::ONE]))
                .unwrap();
        // 2 g, 10 mm: 2·9806.65·10 g mm²/s².
        let part = Part { properties, gravity: value("9.80665"), units: "g,mm,s".parse().unwrap() };
        assert_eq!(part.weighted_center()[2], value("196133"));
    }

    fn of(entries: [&str; 6]) -> Existence {
        let rational = |text: &str| text.parse::<Number>().unwrap().value().clone();
        Existence::of(&Symmetric::new(entries.map(rational)))
    }

    #[test]
    fn flat_parts_exist_and_are_decided_exactly() {
        assert_eq!(of(["0.3", "0.1", "0.25", "0", "0", "0"]), Existence::Solid);
        assert_eq!(of(["0.3", "0.1", "0.2", "0", "0", "0"]), Existence::Flat);
        // A plate with the moments 0.1, 0.2, 0.3 turned by 3-4-5.
        assert_eq!(of(["0.164", "0.136", "0.3", "0.048", "0", "0"]), Existence::Flat);
        // A rod, a point.
        assert_eq!(of(["1", "1", "0", "0", "0", "0"]), Existence::Flat);
        assert_eq!(of(["0", "0", "0", "0", "0", "0"]), Existence::Flat);
    }

    #[test]
    fn what_cannot_be_says_by_how_much() {
        let Existence::Impossible(inequality) = of(["0.3", "0.1", "0.19", "0", "0", "0"]) else { panic!() };
        assert_eq!(inequality.moments, ["0.1", "0.19", "0.3"].map(value));
        assert_eq!(
            inequality.to_string(),
            "the two smaller principal moments add up to less than the largest: 0.1 + 0.19 < 0.3, 0.01 is missing"
        );
        let message = |entries: [&str; 6]| {
            let Existence::Impossible(inequality) = of(entries) else { panic!("{entries:?}") };
            inequality.to_string().split_once(": ").unwrap().1.to_owned()
        };
        // As printed, the inequality holds, however little is missing.
        assert_eq!(message(["1", "1", "2.0000001", "0", "0", "0"]), "1 + 1 < 2.0000001, 0.0000001 is missing");
        assert_eq!(message(["100", "200", "300.00001", "0", "0", "0"]), "100 + 200 < 300.00001, 0.00001 is missing");
        assert_eq!(
            message(["1234567.89", "1", "1234568.9", "0", "0", "0"]),
            "1 + 1234567.89 < 1234568.9, 0.01 is missing"
        );
        let little = format!("2.{}1", "0".repeat(39));
        assert_eq!(
            message(["1", "1", &little, "0", "0", "0"]),
            format!("1 + 1 < {little}, 0.{}1 is missing", "0".repeat(39))
        );
        // Irrational moments are printed so far that the difference is seen.
        let turned = message(["1", "1.0000001", "2.0000003", "0.0001", "0", "0"]);
        let [a, b, c] = [0, 2, 4].map(|k| turned.split([' ', ',']).nth(k).unwrap()).map(value);
        assert!(&a + &b < c && c - a - b > value("1.9e-7"), "{turned}");
        // A negative moment fails, too.
        assert!(!of(["1", "1", "-0.1", "0", "0", "0"]).is_possible());
    }
}
