//! Units of mass, length and time, as exact factors.
//!
//! A table of our own: libraries of units carry floats or another type of big rationals, and hundreds of units.

use std::fmt;
use std::str::FromStr;

use dashu_ratio::RBig;
use thiserror::Error;

/// kg in the unit of mass, exactly (1 lb = 0.45359237 kg; a slug is 1 lbf s²/ft).
const MASSES: [(&str, i64, i64); 7] = [
    ("kg", 1, 1),
    ("g", 1, 1000),
    ("mg", 1, 1_000_000),
    ("t", 1000, 1),
    ("lb", 45_359_237, 100_000_000),
    ("oz", 45_359_237, 1_600_000_000),
    ("slug", 8_896_443_230_521, 609_600_000_000),
];

/// m in the unit of length, exactly (1 in = 25.4 mm).
const LENGTHS: [(&str, i64, i64); 7] = [
    ("m", 1, 1),
    ("cm", 1, 100),
    ("mm", 1, 1000),
    ("um", 1, 1_000_000),
    ("km", 1000, 1),
    ("in", 127, 5000),
    ("ft", 381, 1250),
];

/// s in the unit of time.
const TIMES: [(&str, i64, i64); 3] = [("s", 1, 1), ("ms", 1, 1000), ("min", 60, 1)];

/// A system of units: of mass, length and time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Units {
    names: [&'static str; 3],
    factors: [RBig; 3],
}

/// A text names no system of units.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitsError {
    /// Not three names.
    #[error("{count} units given; write those of mass, length and time, such as kg,mm,s")]
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
}
