//! Numbers with a unit and a tolerance, as engineers write them: `2.7 g/cm3`, `180 g ± 0.5`, `9.81 m/s^2`, `40±1%`.

use std::fmt;
use std::str::FromStr;

use bifdiag_numbers::{Number, ParseNumberError};
use dashu_ratio::RBig;
use thiserror::Error;

use super::measured::Measured;
use super::units::{LENGTHS, MASSES, TIMES, Units};

/// Powers of mass, length and time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension([i8; 3]);

impl Dimension {
    /// Of a mass.
    pub const MASS: Self = Self([1, 0, 0]);
    /// Of a length.
    pub const LENGTH: Self = Self([0, 1, 0]);
    /// Of a moment of inertia.
    pub const MOMENT: Self = Self([1, 2, 0]);
    /// Of a density.
    pub const DENSITY: Self = Self([1, -3, 0]);
    /// Of an acceleration.
    pub const ACCELERATION: Self = Self([0, 1, -2]);

    /// A unit of it, for messages.
    fn example(self) -> &'static str {
        match self {
            Self::MASS => "kg",
            Self::LENGTH => "mm",
            Self::MOMENT => "g mm2",
            Self::DENSITY => "g/cm3",
            _ => "m/s2",
        }
    }
}

/// A product of powers of units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    text: String,
    /// In kg, m, s.
    factor: RBig,
    dimension: Dimension,
}

/// A number, how far the true one may be from it, and its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    number: Measured,
    unit: Option<Unit>,
}

/// Why a text is no quantity.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// No number.
    #[error(transparent)]
    Number(#[from] ParseNumberError),
    /// An unknown unit.
    #[error("`{text}` is no unit; units are made of {known}, such as g/cm3 or m/s2")]
    Unit {
        /// What was written.
        text: String,
        /// The names that are known.
        known: String,
    },
    /// A unit of something else.
    #[error("`{unit}` is the unit of something else; write one such as {right}")]
    Dimension {
        /// What was written.
        unit: String,
        /// A right one.
        right: &'static str,
    },
    /// A negative tolerance.
    #[error("what stands behind ± must not be negative; write 2±0.02, 2+-0.02 or 2±1%")]
    Negative,
    /// A list in which some numbers have a unit.
    #[error(
        "some of these numbers have a unit and some have none; write one behind the last number, or one behind each"
    )]
    Mixed,
}

impl Quantity {
    /// In the units of a part; a number without unit is in them already.
    ///
    /// # Errors
    /// [`QuantityError::Dimension`].
    pub fn measured(&self, dimension: Dimension, units: &Units) -> Result<Measured, QuantityError> {
        let Some(unit) = &self.unit else { return Ok(self.number.clone()) };
        if unit.dimension != dimension {
            return Err(QuantityError::Dimension { unit: unit.text.clone(), right: dimension.example() });
        }
        let own = [units.mass(), units.length(), units.time()];
        let factor = product(own.into_iter().zip(dimension.0).map(|(factor, power)| power_of(factor, power)));
        let scale = &unit.factor / factor;
        Ok(Measured { value: &self.number.value * &scale, within: &self.number.within * &scale })
    }

    /// A list in the units of a part: a unit behind the last number alone is that of all of them.
    ///
    /// # Errors
    /// [`QuantityError::Dimension`], [`QuantityError::Mixed`].
    pub fn all_measured<const N: usize>(
        list: &[Self; N],
        dimension: Dimension,
        units: &Units,
    ) -> Result<[Measured; N], QuantityError> {
        let with_unit = list.iter().filter(|quantity| quantity.unit.is_some()).count();
        let last = list.last().and_then(|quantity| quantity.unit.clone());
        let common = if with_unit == 1 { last } else { None };
        if with_unit > 0
            && common.is_none()
            && list.iter().any(|quantity| quantity.unit.is_none() && !quantity.is_zero())
        {
            return Err(QuantityError::Mixed);
        }
        let mut measured = Vec::with_capacity(N);
        for quantity in list {
            let unit = quantity.unit.clone().or_else(|| common.clone());
            measured.push(Self { number: quantity.number.clone(), unit }.measured(dimension, units)?);
        }
        measured.try_into().map_err(|_| QuantityError::Mixed)
    }

    /// The number as it was written, without its unit.
    #[must_use]
    pub fn number(&self) -> &Measured {
        &self.number
    }

    /// A unit was written.
    #[must_use]
    pub fn has_unit(&self) -> bool {
        self.unit.is_some()
    }

    fn is_zero(&self) -> bool {
        self.number.value.is_zero() && self.number.within.is_zero()
    }
}

impl FromStr for Quantity {
    type Err = QuantityError;

    /// 1.2, 1.2±0.01, 1.2+-0.01, 1.2±1%, each with a unit behind the number or at the end.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let split = ["±", "+/-", "+-"].iter().find_map(|sign| text.split_once(sign));
        let (value, within) = split.map_or((text, None), |(value, within)| (value, Some(within.trim())));
        let (value, unit) = number_and_unit(value.trim())?;
        let Some(within) = within else { return Ok(Self { number: Measured { value, within: RBig::ZERO }, unit }) };
        if within.starts_with('-') {
            return Err(QuantityError::Negative);
        }
        let (within, own) = if let Some((percent, rest)) = within.split_once('%') {
            let size = if value < RBig::ZERO { -value.clone() } else { value.clone() };
            let percent: Number = percent.trim().parse()?;
            let unit = if rest.trim().is_empty() { None } else { Some(rest.trim().parse::<Unit>()?) };
            (percent.value() * size / RBig::from(100), unit)
        } else {
            let (mut within, own) = number_and_unit(within)?;
            if let (Some(unit), Some(own)) = (&unit, &own) {
                if unit.dimension != own.dimension {
                    let right = unit.dimension.example();
                    return Err(QuantityError::Dimension { unit: own.text.clone(), right });
                }
                within *= &own.factor / &unit.factor;
            }
            (within, own)
        };
        Ok(Self { number: Measured { value, within }, unit: unit.or(own) })
    }
}

/// The longest number at the start, and the unit behind it.
fn number_and_unit(text: &str) -> Result<(RBig, Option<Unit>), QuantityError> {
    // A number out of range, or over zero, is one all the same.
    let is_no_number =
        |error: &ParseNumberError| matches!(error, ParseNumberError::Malformed { .. } | ParseNumberError::Empty);
    let whole = match text.parse::<Number>() {
        Ok(number) => return Ok((number.value().clone(), None)),
        Err(error) if is_no_number(&error) => error,
        Err(error) => return Err(error.into()),
    };
    let starts = text.char_indices().filter(|(_, letter)| letter.is_alphabetic()).map(|(at, _)| at);
    let mut found = starts.filter_map(|at| match text[..at].trim_end().parse::<Number>() {
        Err(error) if is_no_number(&error) => None,
        found => Some((found, text[at..].trim())),
    });
    let Some((number, unit)) = found.next_back() else { return Err(whole.into()) };
    Ok((number?.value().clone(), Some(unit.parse()?)))
}

impl FromStr for Unit {
    type Err = QuantityError;

    /// `kg/m3`, `g cm^-3`, `m/s²`: factors with powers, `/` before those of the denominator.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let unknown = || {
            let names = [&MASSES[..], &LENGTHS[..], &TIMES[..]].map(|table| table.iter().map(|(name, ..)| *name));
            let known = names.into_iter().flatten().collect::<Vec<_>>().join(", ");
            QuantityError::Unit { text: text.to_owned(), known }
        };
        let (mut factor, mut dimension) = (RBig::ONE, [0_i8; 3]);
        for (place, part) in text.split('/').enumerate() {
            let side = if place == 0 { 1 } else { -1 };
            let mut factors = part.split([' ', '*', '·']).filter(|word| !word.is_empty()).peekable();
            if factors.peek().is_none() {
                return Err(unknown());
            }
            for word in factors {
                for (name, power) in names_and_powers(word).ok_or_else(unknown)? {
                    let (kind, own) = known(name).ok_or_else(unknown)?;
                    let power = side * power;
                    dimension[kind] = dimension[kind].checked_add(power).ok_or_else(unknown)?;
                    factor *= power_of(&own, power);
                }
            }
        }
        Ok(Self { text: text.to_owned(), factor, dimension: Dimension(dimension) })
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// `cm3`, `cm^3`, `cm³`, `cm`, `s^-2`.
fn name_and_power(word: &str) -> Option<(&str, i8)> {
    let end = word.find(|letter: char| !letter.is_alphabetic() || "²³".contains(letter)).unwrap_or(word.len());
    let (name, power) = word.split_at(end);
    let power = match power.strip_prefix('^').unwrap_or(power) {
        "" if power.is_empty() => 1,
        "²" => 2,
        "³" => 3,
        digits => digits.parse().ok().filter(|power: &i8| (1..=6).contains(&power.abs()))?,
    };
    Some((name, power))
}

/// The same of two names in one word, such as `kgm2`.
fn names_and_powers(word: &str) -> Option<Vec<(&str, i8)>> {
    let (name, power) = name_and_power(word)?;
    if known(name).is_some() {
        return Some(vec![(name, power)]);
    }
    let splits = name.char_indices().skip(1).map(|(at, _)| name.split_at(at));
    let (first, second) = splits.into_iter().find(|(p, q)| known(p).is_some() && known(q).is_some())?;
    Some(vec![(first, 1), (second, power)])
}

/// For a name: 0 for mass, 1 for length, 2 for time, and its value in kg, m, s.
fn known(name: &str) -> Option<(usize, RBig)> {
    [&MASSES[..], &LENGTHS[..], &TIMES[..]].into_iter().enumerate().find_map(|(kind, table)| {
        let &(_, p, q) = table.iter().find(|(known, ..)| *known == name)?;
        Some((kind, RBig::from(p) / RBig::from(q)))
    })
}

fn power_of(x: &RBig, power: i8) -> RBig {
    let whole = product((0..power.unsigned_abs()).map(|_| x.clone()));
    if power < 0 { RBig::ONE / whole } else { whole }
}

fn product(factors: impl Iterator<Item = RBig>) -> RBig {
    factors.fold(RBig::ONE, |product, factor| product * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn in_units(text: &str, dimension: Dimension, units: &str) -> Result<[String; 2], QuantityError> {
        let measured = text.parse::<Quantity>()?.measured(dimension, &units.parse().unwrap())?;
        Ok([measured.value, measured.within].map(|x| x.to_string()))
    }

    #[test]
    fn units_are_exact_factors() {
        let density = |text, units| in_units(text, Dimension::DENSITY, units).unwrap()[0].clone();
        for text in ["2.7g/cm3", "2.7 g/cm^3", "2700kg/m3", "2700 kg/m³", "27/10 g cm^-3", "2.7e3 kg / m3", "2.7t/m3"]
        {
            assert_eq!(density(text, "kg,m,s"), "2700", "{text}");
            assert_eq!(density(text, "g,mm,s"), "27/10000", "{text}");
        }
        assert_eq!(in_units("50kg", Dimension::MASS, "g,mm,s").unwrap()[0], "50000");
        assert_eq!(in_units("9.81m/s2", Dimension::ACCELERATION, "kg,m,s").unwrap()[0], "981/100");
        assert_eq!(in_units("1 in", Dimension::LENGTH, "kg,mm,s").unwrap()[0], "127/5");
        assert_eq!(in_units("3kgm2", Dimension::MOMENT, "kg,mm,s").unwrap()[0], "3000000");
        assert_eq!(in_units("3 kgmm^2", Dimension::MOMENT, "g,mm,s").unwrap()[0], "3000");
        assert_eq!(in_units("3 kg m2", Dimension::MOMENT, "kg,mm,s").unwrap()[0], "3000000");
        // Without a unit the number is in those of the part.
        assert_eq!(in_units("1/3", Dimension::MASS, "g,mm,s").unwrap()[0], "1/3");
    }

    #[test]
    fn tolerances_stand_before_or_behind_the_unit() {
        let mass = |text: &str| in_units(text, Dimension::MASS, "g,mm,s").unwrap();
        let half = ["180".to_owned(), "1/2".to_owned()];
        for text in ["180±0.5", "180+-0.5", "180 +/- 0.5 g", "180g±0.5", "180g ± 500mg", "0.18 kg ± 0.5g", "180±0.5g"]
        {
            assert_eq!(mass(text), half, "{text}");
        }
        assert_eq!(mass("200kg±1%"), ["200000", "2000"]);
        assert_eq!(mass("200±1% kg"), ["200000", "2000"]);
        assert_eq!(in_units("-40±10%", Dimension::LENGTH, "kg,m,s").unwrap(), ["-40", "4"]);
    }

    #[test]
    fn a_unit_behind_the_last_number_is_that_of_all() {
        let list = |text: &str| {
            let parts: Vec<Quantity> = text.split(',').map(|part| part.parse().unwrap()).collect();
            let list: [Quantity; 3] = parts.try_into().unwrap();
            Quantity::all_measured(&list, Dimension::LENGTH, &"kg,mm,s".parse().unwrap())
                .map(|list| list.map(|x| x.value.to_string()))
        };
        assert_eq!(list("1,2,3").unwrap(), ["1", "2", "3"]);
        assert_eq!(list("1,2,3cm").unwrap(), ["10", "20", "30"]);
        assert_eq!(list("1cm,2mm,3m").unwrap(), ["10", "2", "3000"]);
        assert_eq!(list("0,1cm,0").unwrap(), ["0", "10", "0"]);
        assert_eq!(list("1cm,2,3m"), Err(QuantityError::Mixed));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let error = |text: &str, dimension| in_units(text, dimension, "kg,m,s").unwrap_err().to_string();
        assert!(error("5 stone", Dimension::MASS).contains("`stone` is no unit"));
        assert!(error("5 kg/", Dimension::MASS).contains("`kg/` is no unit"));
        assert!(
            error("5 kg", Dimension::DENSITY).contains("`kg` is the unit of something else; write one such as g/cm3")
        );
        assert!(error("2±-0.1", Dimension::MASS).contains("must not be negative"));
        assert!(error("2±", Dimension::MASS).contains("the number is missing"));
        assert!(error("1e400", Dimension::MASS).contains("`1e400` is out of range"));
        assert!(error("1e-200kg", Dimension::MASS).contains("`1e-200` is out of range"));
        assert!(error("1/0 kg", Dimension::MASS).contains("`1/0` has denominator zero"));
        for text in ["x", "1.2.3", "", "kg"] {
            assert!(matches!(text.parse::<Quantity>(), Err(QuantityError::Number(_))), "{text}");
        }
    }
}
