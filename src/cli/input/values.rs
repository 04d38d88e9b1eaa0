//! Values of options, read exactly and refused with what would be right.

use std::num::{NonZeroU32, NonZeroUsize};

use bifdiag_body::part::{Measured, Units, UnitsError};
use bifdiag_body::{Body, BodyError, Number, ParseNumberError, Preset};
use bifdiag_documents::GridAxis;
use bifdiag_dynamics::integrator::check_tolerance;
use bifdiag_numbers::vector::dot;
use bifdiag_schema::WindowDocument;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use dashu_ratio::RBig;
use thiserror::Error;

/// The most threads that can be asked for.
const MAX_THREADS: usize = 1024;

/// Three numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple(pub [Number; 3]);

impl Triple {
    /// The exact values.
    pub fn values(&self) -> [RBig; 3] {
        self.0.each_ref().map(|x| x.value().clone())
    }

    /// The nearest doubles.
    pub fn rounded(&self) -> Vector {
        Vector(self.0.each_ref().map(Number::to_f64))
    }
}

/// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz, in either convention of the products.
#[derive(Clone, Debug, PartialEq)]
pub struct Entries(pub [Measured; 6]);

impl Entries {
    /// The nominal values.
    pub fn values(&self) -> [RBig; 6] {
        self.0.each_ref().map(|x| x.value.clone())
    }
}

/// A point whose coordinates may be known to within so much.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredPoint(pub [Measured; 3]);

/// Three numbers of which only the nearest doubles are needed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector(pub [f64; 3]);

impl Vector {
    /// Brought to length 1; one of this length, within rounding, stays as it is.
    pub fn direction(self) -> Result<Self, ValueError> {
        if (dot(self.0, self.0) - 1.0).abs() <= 2.0 * f64::EPSILON {
            return Ok(self);
        }
        bifdiag_numbers::vector::direction(self.0).map(Self).ok_or(ValueError::NoDirection)
    }
}

/// Why a value is refused.
#[derive(Debug, PartialEq, Error)]
pub enum ValueError {
    #[error("{0}; write three positive numbers with commas between them, such as 2,1.1,1")]
    Moments(BodyError),
    #[error("{0}; write three numbers with commas between them, such as 0.94868,0,0.61623")]
    Center(BodyError),
    #[error("{count} numbers given; write three coordinates, such as 0,0.02,0.15")]
    CenterOfMassCount { count: usize },
    #[error("{count} numbers given; write six: Ixx,Iyy,Izz,Ixy,Ixz,Iyz")]
    TensorCount { count: usize },
    #[error("{name}: {source}")]
    Entry { name: &'static str, source: Box<ValueError> },
    #[error("{0}")]
    Number(#[from] ParseNumberError),
    #[error("{0}")]
    Units(#[from] UnitsError),
    #[error("a mass must be greater than zero; give it in the unit of --units, such as kg")]
    Mass,
    #[error("what stands behind ± must not be negative; write 2±0.02, 2+-0.02 or 2±1%")]
    Within,
    #[error("the acceleration of gravity must not be negative; give its magnitude in m/s², such as 9.80665")]
    Gravity,
    #[error("a grid is written hmin:hmax:n,lmin:lmax:m, such as -1:6:200,0:4:200")]
    GridShape,
    #[error("{points} points; a grid has at most {most}")]
    GridSize { points: usize, most: usize },
    #[error(
        "a tolerance is a share from 0 to 50%, such as 1% or 0.01, or shares by name: axis=0.5%,across=1%,weight=2%"
    )]
    Tolerance,
    #[error("a window is written hmin:hmax,lmin:lmax, such as 0:6,0:4")]
    WindowShape,
    #[error("{name}: {source}; a window is written hmin:hmax,lmin:lmax, such as 0:6,0:4")]
    WindowEntry { name: &'static str, source: ParseNumberError },
    #[error("{low} = {from} is not below {high} = {to}; write the lower end first")]
    WindowEmpty { low: &'static str, high: &'static str, from: String, to: String },
    #[error("lmin = {0} is negative; everything depends on l² only, give a window with lmin ≥ 0")]
    WindowNegative(String),
    #[error("the number of threads is a whole number from 1 to {MAX_THREADS}")]
    Threads,
    #[error("bifdiag bodies lists the names")]
    NoPreset,
    #[error("the number of {0} is a whole number from 1 to {1}")]
    Count(&'static str, u32),
    #[error("a seed is a whole number from 0 to {max}", max = u64::MAX)]
    Seed,
    #[error("{count} numbers given; write three with commas between them, such as 0.6,0,0.8")]
    VectorCount { count: usize },
    #[error("the zero vector has no direction; write one that is not 0, such as 0.6,0,0.8")]
    NoDirection,
    #[error("a sheet is + (or 1) or - (or -1), by the sign of Delta")]
    Sheet,
    #[error("the truncation error of a step is from 1e-18 to 1e-2, such as 1e-12")]
    StepTolerance,
    #[error("a time must be greater than zero, such as 1e4")]
    Duration,
}

fn parts(text: &str) -> Vec<&str> {
    text.split(',').collect()
}

pub fn number(text: &str) -> Result<Number, ValueError> {
    Ok(text.parse()?)
}

pub fn moments(text: &str) -> Result<Triple, ValueError> {
    let body = Body::parse(&parts(text), &["0"; 3]).map_err(ValueError::Moments)?;
    Ok(Triple(body.moments().clone()))
}

pub fn center(text: &str) -> Result<Triple, ValueError> {
    let body = Body::parse(&["1"; 3], &parts(text)).map_err(ValueError::Center)?;
    Ok(Triple(body.center().clone()))
}

pub fn center_of_mass(text: &str) -> Result<Triple, ValueError> {
    let numbers = entries(text, &["x", "y", "z"], |count| ValueError::CenterOfMassCount { count })?;
    Ok(Triple(numbers))
}

pub fn measured_point(text: &str) -> Result<MeasuredPoint, ValueError> {
    let numbers = entries(text, &["x", "y", "z"], |count| ValueError::CenterOfMassCount { count })?;
    Ok(MeasuredPoint(numbers))
}

pub fn tensor(text: &str) -> Result<Entries, ValueError> {
    const NAMES: [&str; 6] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
    Ok(Entries(entries(text, &NAMES, |count| ValueError::TensorCount { count })?))
}

/// 1.2, or 1.2±0.01, 1.2+-0.01, 1.2±1%.
fn measured(text: &str) -> Result<Measured, ValueError> {
    let split = ["±", "+/-", "+-"].iter().find_map(|sign| text.split_once(sign));
    let (value, within) = split.map_or((text, None), |(value, within)| (value, Some(within.trim())));
    let value = number(value.trim())?.value().clone();
    let Some(within) = within else { return Ok(Measured { value, within: RBig::ZERO }) };
    let within = match within.strip_suffix('%') {
        Some(percent) => {
            let size = if value < RBig::ZERO { -value.clone() } else { value.clone() };
            number(percent)?.value() * size / RBig::from(100)
        }
        None => number(within)?.value().clone(),
    };
    if within < RBig::ZERO { Err(ValueError::Within) } else { Ok(Measured { value, within }) }
}

impl FromEntry for Measured {
    fn from_entry(text: &str) -> Result<Self, ValueError> {
        measured(text)
    }
}

impl FromEntry for Number {
    fn from_entry(text: &str) -> Result<Self, ValueError> {
        number(text)
    }
}

/// What an entry of a list is read as.
trait FromEntry: Sized {
    fn from_entry(text: &str) -> Result<Self, ValueError>;
}

fn entries<T: FromEntry, const N: usize>(
    text: &str,
    names: &[&'static str; N],
    wrong_count: impl Fn(usize) -> ValueError,
) -> Result<[T; N], ValueError> {
    let parts = parts(text);
    if parts.len() != N {
        return Err(wrong_count(parts.len()));
    }
    let mut numbers = Vec::with_capacity(N);
    for (&name, part) in names.iter().zip(parts) {
        let wrong = |source| ValueError::Entry { name, source: Box::new(source) };
        numbers.push(T::from_entry(part).map_err(wrong)?);
    }
    numbers.try_into().map_err(|numbers: Vec<T>| wrong_count(numbers.len()))
}

pub fn units(text: &str) -> Result<Units, ValueError> {
    Ok(text.parse()?)
}

pub fn mass(text: &str) -> Result<Number, ValueError> {
    let mass = number(text)?;
    if mass.to_f64() > 0.0 { Ok(mass) } else { Err(ValueError::Mass) }
}

pub fn measured_mass(text: &str) -> Result<Measured, ValueError> {
    let mass = measured(text)?;
    if mass.value > mass.within { Ok(mass) } else { Err(ValueError::Mass) }
}

pub fn gravity(text: &str) -> Result<Number, ValueError> {
    let gravity = number(text)?;
    if gravity.to_f64() >= 0.0 { Ok(gravity) } else { Err(ValueError::Gravity) }
}

pub fn window(text: &str) -> Result<WindowDocument, ValueError> {
    let (h, l) = text.split_once(',').ok_or(ValueError::WindowShape)?;
    let (h, _) = interval(h, "hmin", "hmax")?;
    let (l, l_low) = interval(l, "lmin", "lmax")?;
    if l[0] < 0.0 {
        return Err(ValueError::WindowNegative(l_low.text().to_owned()));
    }
    Ok(WindowDocument { h, l })
}

fn interval(text: &str, low: &'static str, high: &'static str) -> Result<([f64; 2], Number), ValueError> {
    let (from, to) = text.split_once(':').ok_or(ValueError::WindowShape)?;
    let entry = |name, text: &str| text.parse::<Number>().map_err(|source| ValueError::WindowEntry { name, source });
    let (from, to) = (entry(low, from)?, entry(high, to)?);
    let ends = [from.to_f64(), to.to_f64()];
    if ends[0] < ends[1] {
        Ok((ends, from))
    } else {
        Err(ValueError::WindowEmpty { low, high, from: from.text().to_owned(), to: to.text().to_owned() })
    }
}

/// The energies and the momenta of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    pub h: GridAxis,
    pub l: GridAxis,
}

pub fn grid(text: &str) -> Result<Grid, ValueError> {
    /// The most points of a grid.
    const MOST: usize = 100_000_000;
    let (h, l) = text.split_once(',').ok_or(ValueError::GridShape)?;
    let (h, l) = (axis(h)?, axis(l)?);
    if h.count.saturating_mul(l.count) > MOST {
        return Err(ValueError::GridSize { points: h.count.saturating_mul(l.count), most: MOST });
    }
    Ok(Grid { h, l })
}

fn axis(text: &str) -> Result<GridAxis, ValueError> {
    let parts: Vec<&str> = text.split(':').collect();
    let [from, to, count] = parts[..] else { return Err(ValueError::GridShape) };
    let count = count.parse().ok().filter(|count| *count > 0).ok_or(ValueError::GridShape)?;
    Ok(GridAxis { from: from.parse()?, to: to.parse()?, count })
}

pub fn threads(text: &str) -> Result<NonZeroUsize, ValueError> {
    let count = text.parse::<NonZeroUsize>().map_err(|_not_a_count| ValueError::Threads)?;
    if count.get() <= MAX_THREADS { Ok(count) } else { Err(ValueError::Threads) }
}

/// A number of which only the nearest double is needed.
pub fn float(text: &str) -> Result<f64, ValueError> {
    Ok(number(text)?.to_f64())
}

/// The truncation error of a step of the integrator.
pub fn step_tolerance(text: &str) -> Result<f64, ValueError> {
    let tolerance = float(text)?;
    check_tolerance(tolerance).map_err(|_| ValueError::StepTolerance)?;
    Ok(tolerance)
}

pub fn duration(text: &str) -> Result<f64, ValueError> {
    let time = float(text)?;
    if time > 0.0 { Ok(time) } else { Err(ValueError::Duration) }
}

pub fn triple(text: &str) -> Result<Triple, ValueError> {
    let numbers = entries(text, &["x", "y", "z"], |count| ValueError::VectorCount { count })?;
    Ok(Triple(numbers))
}

pub fn vector(text: &str) -> Result<Vector, ValueError> {
    Ok(triple(text)?.rounded())
}

/// A vector brought to length 1; one of this length, within rounding, stays as it is.
pub fn direction(text: &str) -> Result<Vector, ValueError> {
    vector(text)?.direction()
}

pub fn orbits(text: &str) -> Result<NonZeroU32, ValueError> {
    /// The memory of many more would be the limit.
    const MOST: u32 = 1_000_000;
    let wrong = ValueError::Count("orbits", MOST);
    text.parse::<NonZeroU32>().ok().filter(|count| count.get() <= MOST).ok_or(wrong)
}

pub fn crossings(text: &str) -> Result<NonZeroUsize, ValueError> {
    /// Crossings are numbered by 32-bit integers in the data.
    const MOST: u32 = i32::MAX.unsigned_abs();
    let wrong = ValueError::Count("crossings", MOST);
    let count = text.parse::<NonZeroU32>().ok().filter(|count| count.get() <= MOST).ok_or(wrong)?;
    NonZeroUsize::try_from(count).map_err(|_too_large| ValueError::Count("crossings", MOST))
}

pub fn seed(text: &str) -> Result<u64, ValueError> {
    text.parse().map_err(|_not_a_seed| ValueError::Seed)
}

/// An angle: a number of radians, or a multiple of pi such as pi/2, -pi, 3pi/4.
pub fn angle(text: &str) -> Result<f64, ValueError> {
    use std::f64::consts::PI;
    let Some((factor, divisor)) = text.split_once("pi") else { return float(text) };
    let factor = match factor.trim().trim_end_matches('*') {
        "" | "+" => 1.0,
        "-" => -1.0,
        factor => float(factor)?,
    };
    match divisor.trim() {
        "" => Ok(factor * PI),
        divisor => Ok(factor * PI / float(divisor.strip_prefix('/').unwrap_or("?"))?),
    }
}

/// A sheet of the PP-torus: 1, + or T+; -1, - or T-.
pub fn sheet(text: &str) -> Result<i8, ValueError> {
    match text {
        "1" | "+1" | "+" | "T+" => Ok(1),
        "-1" | "-" | "T-" => Ok(-1),
        _ => Err(ValueError::Sheet),
    }
}

/// A value by its word; with each word goes what it means.
pub type Named<T> = (&'static str, &'static str, T);

/// One of these values, by its word.
pub fn named<T: Clone + Send + Sync>(words: &'static [Named<T>]) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(words.iter().map(|(word, meaning, _)| PossibleValue::new(*word).help(*meaning))).map(
        |given| {
            let known = words.iter().find(|(word, ..)| *word == given);
            known.map_or_else(|| unreachable!("the words are those that are possible"), |(.., value)| value.clone())
        },
    )
}

/// A named body.
pub fn preset() -> impl TypedValueParser<Value = &'static Preset> {
    let names = Preset::all().iter().map(|preset| PossibleValue::new(preset.name()).help(preset.note()));
    PossibleValuesParser::new(names).try_map(|name| Preset::find(&name).ok_or(ValueError::NoPreset))
}
