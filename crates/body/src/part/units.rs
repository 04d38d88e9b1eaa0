//! Units of mass, length and time as exact factors, and rates of rotation (rpm, Hz, rad/s, deg/s) without a factor 2π lost.
//!
//! A table of our own: libraries of units carry floats or another type of big rationals, and hundreds of units.

use std::f64::consts::{PI, TAU};
use std::fmt;
use std::str::FromStr;

use bifdiag_numbers::decimal::counted;
use bifdiag_numbers::{Number, ParseNumberError};
use dashu_int::IBig;
use dashu_ratio::RBig;
use thiserror::Error;

/// kg in the unit of mass, exactly (1 lb = 0.45359237 kg; a slug is 1 lbf s²/ft).
pub(super) const MASSES: [(&str, i64, i64); 7] = [
    ("kg", 1, 1),
    ("g", 1, 1000),
    ("mg", 1, 1_000_000),
    ("t", 1000, 1),
    ("lb", 45_359_237, 100_000_000),
    ("oz", 45_359_237, 1_600_000_000),
    ("slug", 8_896_443_230_521, 609_600_000_000),
];

/// m in the unit of length, exactly (1 in = 25.4 mm).
pub(super) const LENGTHS: [(&str, i64, i64); 7] = [
    ("m", 1, 1),
    ("cm", 1, 100),
    ("mm", 1, 1000),
    ("um", 1, 1_000_000),
    ("km", 1000, 1),
    ("in", 127, 5000),
    ("ft", 381, 1250),
];

/// s in the unit of time.
pub(super) const TIMES: [(&str, i64, i64); 3] = [("s", 1, 1), ("ms", 1, 1000), ("min", 60, 1)];

/// A system of units: of mass, length and time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Units {
    names: [&'static str; 3],
    factors: [RBig; 3],
}

/// Why a text does not name a system of units.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitsError {
    /// Not three names.
    #[error(
        "{} given; write those of mass, length and time, such as kg,mm,s", counted(*count, "unit", "units")
    )]
    Count {
        /// How many.
        count: usize,
    },
    /// An unknown name.
    #[error("`{name}` is no unit of {dimension}; the known ones are {known}")]
    Unknown {
        /// What was written.
        name: String,
        /// mass, length or time.
        dimension: &'static str,
        /// Those that are known.
        known: String,
    },
}

impl Default for Units {
    /// kg, m, s.
    fn default() -> Self {
        Self { names: ["kg", "m", "s"], factors: [RBig::ONE, RBig::ONE, RBig::ONE] }
    }
}

impl Units {
    /// kg in one unit of mass.
    #[must_use]
    pub fn mass(&self) -> &RBig {
        &self.factors[0]
    }

    /// m in one unit of length.
    #[must_use]
    pub fn length(&self) -> &RBig {
        &self.factors[1]
    }

    /// s in one unit of time.
    #[must_use]
    pub fn time(&self) -> &RBig {
        &self.factors[2]
    }

    /// The names of the units of mass, length and time.
    #[must_use]
    pub fn names(&self) -> [&'static str; 3] {
        self.names
    }

    /// Of a moment of inertia, such as `kg mm^2`.
    #[must_use]
    pub fn moment(&self) -> String {
        format!("{} {}^2", self.names[0], self.names[1])
    }

    /// Of an energy, and of r = m g c.
    #[must_use]
    pub fn energy(&self) -> String {
        format!("{}/{}^2", self.moment(), self.names[2])
    }

    /// Of an angular momentum.
    #[must_use]
    pub fn momentum(&self) -> String {
        format!("{}/{}", self.moment(), self.names[2])
    }

    /// An acceleration in m/s² in these units.
    #[must_use]
    pub fn acceleration(&self, si: &RBig) -> RBig {
        si * self.time() * self.time() / self.length()
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.names.join(","))
    }
}

impl FromStr for Units {
    type Err = UnitsError;

    fn from_str(text: &str) -> Result<Self, UnitsError> {
        let names: Vec<&str> = text.split(',').map(str::trim).collect();
        let [mass, length, time] = names[..] else { return Err(UnitsError::Count { count: names.len() }) };
        let mass = find(mass, "mass", &MASSES)?;
        let length = find(length, "length", &LENGTHS)?;
        let time = find(time, "time", &TIMES)?;
        Ok(Self { names: [mass.0, length.0, time.0], factors: [mass.1, length.1, time.1] })
    }
}

fn find(
    name: &str,
    dimension: &'static str,
    table: &[(&'static str, i64, i64)],
) -> Result<(&'static str, RBig), UnitsError> {
    let unknown = || UnitsError::Unknown {
        name: name.to_owned(),
        dimension,
        known: table.iter().map(|(name, ..)| *name).collect::<Vec<_>>().join(", "),
    };
    let &(name, p, q) = table.iter().find(|(known, ..)| *known == name).ok_or_else(unknown)?;
    Ok((name, RBig::from(p) / RBig::from(q)))
}

/// Units of a rate of rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpinUnit {
    /// Turns in a minute.
    Rpm,
    /// Turns in a second.
    Hertz,
    /// Radians in a second.
    RadPerSecond,
    /// Degrees in a second.
    DegPerSecond,
}

/// A rate of rotation as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spin {
    value: Number,
    unit: SpinUnit,
}

/// Why a text is not a rate of rotation.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SpinError {
    /// No unit, or an unknown one.
    #[error("`{text}` has none of the units rpm, Hz, rad/s and deg/s; write for instance \"3000 rpm\"")]
    Unit {
        /// What was written.
        text: String,
    },
    /// No number.
    #[error(transparent)]
    Number(#[from] ParseNumberError),
}

impl SpinUnit {
    const ALL: [Self; 4] = [Self::Rpm, Self::RadPerSecond, Self::DegPerSecond, Self::Hertz];

    /// What stands before a unit at the end of a text, and the unit; `None` where none stands there, or one with a prefix, as in
    /// 3 kHz and 2 mrad/s.
    #[must_use]
    pub fn at_end(text: &str) -> Option<(&str, Self)> {
        let lower = text.to_ascii_lowercase();
        let unit = Self::ALL.into_iter().find(|unit| lower.ends_with(&unit.name().to_ascii_lowercase()))?;
        let before = &text[..text.len() - unit.name().len()];
        (!before.ends_with(char::is_alphabetic)).then(|| (before.trim_end(), unit))
    }

    fn name(self) -> &'static str {
        match self {
            Self::Rpm => "rpm",
            Self::Hertz => "Hz",
            Self::RadPerSecond => "rad/s",
            Self::DegPerSecond => "deg/s",
        }
    }

    /// π rad/s in one unit; `None` for rad/s itself.
    fn half_turns(self) -> Option<RBig> {
        match self {
            Self::Rpm => Some(RBig::from_parts(1.into(), 30u8.into())),
            Self::Hertz => Some(RBig::from(2)),
            Self::RadPerSecond => None,
            Self::DegPerSecond => Some(RBig::from_parts(1.into(), 180u8.into())),
        }
    }
}

impl Spin {
    /// A number of a unit.
    #[must_use]
    pub fn new(value: Number, unit: SpinUnit) -> Self {
        Self { value, unit }
    }

    /// The number that was given, in its unit.
    #[must_use]
    pub fn number(&self) -> &Number {
        &self.value
    }

    /// Its unit.
    #[must_use]
    pub fn unit(&self) -> SpinUnit {
        self.unit
    }

    /// In rad/s, rounded once.
    #[must_use]
    pub fn rad_per_s(&self) -> f64 {
        self.exact_rad_per_s().to_f64().value()
    }

    /// In rpm, rounded once: a rate that was given in rpm is the number that was given.
    #[must_use]
    pub fn in_rpm(&self) -> f64 {
        self.exact_rpm().to_f64().value()
    }

    /// In rpm: exact unless it was given in rad/s, then with 60 digits of π.
    #[must_use]
    pub fn exact_rpm(&self) -> RBig {
        match self.unit.half_turns() {
            Some(half_turns) => self.value.value() * half_turns * RBig::from(30),
            None => self.value.value() * RBig::from(30) / half_turn(),
        }
    }

    /// In rad/s: exact if it was given in rad/s, else with 60 digits of π, so that it differs from the simple numbers
    /// near it.
    #[must_use]
    pub fn exact_rad_per_s(&self) -> RBig {
        match self.unit.half_turns() {
            Some(half_turns) => self.value.value() * half_turns * half_turn(),
            None => self.value.value().clone(),
        }
    }

    /// The part of this rate that part/parts is; `parts` is not 0.
    #[must_use]
    pub fn part(&self, part: u32, parts: u32) -> Self {
        let value = self.value.value() * RBig::from_parts(part.into(), parts.into());
        Self { value: Number::from_rational(value), unit: self.unit }
    }

    /// The same rate without its sign.
    #[must_use]
    pub fn absolute(&self) -> Self {
        if self.value.value() < &RBig::ZERO {
            Self { value: Number::from_rational(-self.value.value()), unit: self.unit }
        } else {
            self.clone()
        }
    }

    /// This rate + (the other − this)·part/parts, in the unit of this one; `parts` is not 0.
    #[must_use]
    pub fn between(&self, other: &Self, part: u32, parts: u32) -> Self {
        Self { value: Number::between(&self.value, &other.value, part, parts), unit: self.unit }
    }

    /// rpm of a rate in rad/s.
    #[must_use]
    pub fn rpm(rad_per_s: f64) -> f64 {
        rad_per_s * (30.0 / PI)
    }

    /// Hz of a rate in rad/s.
    #[must_use]
    pub fn hertz(rad_per_s: f64) -> f64 {
        rad_per_s / TAU
    }
}

/// π, rounded down.
fn half_turn() -> RBig {
    const DIGITS: [u64; 4] = [314_159_265_358_979, 323_846_264_338_327, 950_288_419_716_939, 937_510_582_097_494];
    let block = IBig::from(1_000_000_000_000_000_u64);
    let whole = DIGITS.into_iter().fold(IBig::ZERO, |whole, digits| whole * &block + IBig::from(digits));
    RBig::from(whole) / RBig::from(IBig::from(10).pow(59))
}

impl fmt::Display for Spin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.value, self.unit.name())
    }
}

impl FromStr for Spin {
    type Err = SpinError;

    fn from_str(text: &str) -> Result<Self, SpinError> {
        let trimmed = text.trim();
        let (value, unit) = SpinUnit::at_end(trimmed).ok_or_else(|| SpinError::Unit { text: trimmed.to_owned() })?;
        Ok(Self { value: value.parse()?, unit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_and_wrong_ones_are_named() {
        let units: Units = "g, mm,s".parse().unwrap();
        assert_eq!(units.to_string(), "g,mm,s");
        assert_eq!((units.moment(), units.energy()), ("g mm^2".into(), "g mm^2/s^2".into()));
        assert_eq!(units.acceleration(&RBig::from(9)), RBig::from(9000));
        assert_eq!("kg,m".parse::<Units>().unwrap_err(), UnitsError::Count { count: 2 });
        let error = "mm,kg,s".parse::<Units>().unwrap_err().to_string();
        assert!(error.contains("`mm` is no unit of mass") && error.contains("kg, g"), "{error}");
    }

    #[test]
    fn imperial_units_are_exact() {
        let units: Units = "slug,ft,s".parse().unwrap();
        // 1 slug ft/s² is 1 lbf = 4.4482216152605 N.
        let newton = RBig::from_parts(44_482_216_152_605_i64.into(), 10_000_000_000_000_u64.into());
        assert_eq!(units.mass() * units.length(), newton);
    }

    #[test]
    fn sixty_rpm_are_one_hertz() {
        for text in ["60 rpm", "1 Hz", "1hz", "360 deg/s", "60/1 RPM"] {
            assert_eq!(text.parse::<Spin>().unwrap().rad_per_s(), TAU, "{text}");
        }
        assert_eq!("2 rad/s".parse::<Spin>().unwrap().rad_per_s(), 2.0);
        assert!((Spin::rpm(TAU) - 60.0).abs() < 1e-13);
        assert_eq!(Spin::hertz(TAU), 1.0);
    }

    #[test]
    fn only_rates_in_radians_are_simple_numbers() {
        let exact = |text: &str| text.parse::<Spin>().unwrap().exact_rad_per_s();
        assert_eq!(exact("1/3 rad/s"), RBig::from_parts(1.into(), 3u8.into()));
        // The nearest double of these is 1 rad/s.
        for text in ["9.549296585513720146133025802 rpm", "57.29577951308232087679815481 deg/s"] {
            let spin = text.parse::<Spin>().unwrap();
            assert!((spin.rad_per_s() - 1.0).abs() < 1e-15 && spin.exact_rad_per_s() != RBig::ONE, "{text}");
            assert!((spin.exact_rad_per_s() - RBig::ONE).to_f64().value().abs() < 1e-27, "{text}");
        }
    }

    #[test]
    fn a_rate_without_unit_is_refused() {
        assert!(matches!("3000".parse::<Spin>(), Err(SpinError::Unit { .. })));
        assert!(matches!("fast rpm".parse::<Spin>(), Err(SpinError::Number(_))));
        assert!(matches!("3 kHz".parse::<Spin>(), Err(SpinError::Unit { .. })));
        assert_eq!("-3e3  rpm".parse::<Spin>().unwrap().to_string(), "-3e3 rpm");
    }
}
