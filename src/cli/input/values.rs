//! Values of options, read exactly and refused with what would be right.

use std::ffi::OsStr;
use std::num::{NonZeroU32, NonZeroUsize};

use bifdiag_body::part::{Measured, Quantity, Units};
use bifdiag_body::{Body, Number, Preset};
use bifdiag_documents::GridAxis;
use bifdiag_dynamics::integrator::check_tolerance;
use bifdiag_enclosure::orbit::MOST_DIGITS;
use bifdiag_numbers::decimal::{self, counted};
use bifdiag_numbers::vector::dot;
use bifdiag_schema::{Accuracy, WindowDocument};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error};
use dashu_ratio::RBig;

use crate::cli::failure::Failure;

/// The most threads that can be asked for.
const MAX_THREADS: usize = 1024;

/// An id as the program writes it; pictures write L− with the minus sign.
pub fn id(given: &str) -> String {
    given.to_ascii_uppercase().replace('−', "-")
}

/// Three numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple(pub [Number; 3]);

impl Triple {
    /// The exact values.
    pub fn values(&self) -> [RBig; 3] {
        self.0.each_ref().map(|x| x.value().clone())
    }

    /// The nearest doubles.
    pub fn rounded(&self) -> [f64; 3] {
        self.0.each_ref().map(Number::to_f64)
    }
}

/// A vector used for its direction: as written, and normalized.
#[derive(Clone, Debug, PartialEq)]
pub struct Vertical {
    pub given: Triple,
    pub unit: [f64; 3],
}

/// The nominal values of measured numbers.
pub fn nominal<const N: usize>(numbers: &[Measured; N]) -> [RBig; N] {
    numbers.each_ref().map(|x| x.value.clone())
}

/// A normalized vector; one of length 1 within rounding is left unchanged.
pub fn to_direction(v: [f64; 3]) -> Result<[f64; 3], Failure> {
    if (dot(v, v) - 1.0).abs() <= 2.0 * f64::EPSILON {
        return Ok(v);
    }
    let none = "the zero vector has no direction; write one that is not 0, such as 0.6,0,0.8";
    bifdiag_numbers::vector::direction(v).ok_or_else(|| Failure::input(none))
}

fn parts(text: &str) -> Vec<&str> {
    if text.is_empty() { Vec::new() } else { text.split(',').collect() }
}

pub fn number(text: &str) -> Result<Number, Failure> {
    text.parse().map_err(Failure::input)
}

pub fn moments(text: &str) -> Result<Triple, Failure> {
    let body = Body::parse(&parts(text), &["0"; 3]).map_err(|error| {
        Failure::input(format!("{error}; write three positive numbers with commas between them, such as 2,1.1,1"))
    })?;
    Ok(Triple(body.moments().clone()))
}

pub fn center(text: &str) -> Result<Triple, Failure> {
    let body = Body::parse(&["1"; 3], &parts(text)).map_err(|error| {
        Failure::input(format!("{error}; write three numbers with commas between them, such as 0.94868,0,0.61623"))
    })?;
    Ok(Triple(body.center().clone()))
}

pub fn place(text: &str) -> Result<[Quantity; 3], Failure> {
    entries(text, &["x", "y", "z"], "write three coordinates, such as 0,0.02,0.15", quantity)
}

/// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz, in either convention of the products.
pub fn tensor(text: &str) -> Result<[Quantity; 6], Failure> {
    const NAMES: [&str; 6] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
    entries(text, &NAMES, "write six: Ixx,Iyy,Izz,Ixy,Ixz,Iyz", quantity)
}

/// 1.2, or 1.2±0.01, 1.2+-0.01, 1.2±1%, and a unit.
fn quantity(text: &str) -> Result<Quantity, Failure> {
    text.parse().map_err(Failure::input)
}

/// N values with commas between them.
fn entries<T, const N: usize>(
    text: &str,
    names: &[&'static str; N],
    right: &str,
    read: impl Fn(&str) -> Result<T, Failure>,
) -> Result<[T; N], Failure> {
    let parts = parts(text);
    let mut numbers = Vec::with_capacity(N);
    if parts.len() != N
        && let Some(error) = parts.iter().find_map(|part| read(part).err())
    {
        return Err(Failure::input(format!("{error}; {right}")));
    }
    if parts.len() == N {
        for (name, part) in names.iter().zip(&parts) {
            numbers.push(read(part).map_err(|error| Failure::input(format!("{name}: {error}")))?);
        }
    }
    numbers
        .try_into()
        .map_err(|_| Failure::input(format!("{} given; {right}", counted(parts.len(), "number", "numbers"))))
}

pub fn units(text: &str) -> Result<Units, Failure> {
    text.parse().map_err(Failure::input)
}

pub fn mass(text: &str) -> Result<Quantity, Failure> {
    let right = "a mass must be greater than zero; give it in the unit of --units, such as kg";
    bounded(text, |value| value > &RBig::ZERO, right)
}

pub fn density(text: &str) -> Result<Quantity, Failure> {
    bounded(text, |value| value > &RBig::ZERO, "a density must be greater than zero, such as 2.7g/cm3")
}

pub fn gravity(text: &str) -> Result<Quantity, Failure> {
    let right = "the acceleration of gravity must not be negative; give its magnitude in m/s², such as 9.80665";
    bounded(text, |value| value >= &RBig::ZERO, right)
}

/// A quantity that can be, as far down as it reaches.
fn bounded(text: &str, can_be: impl Fn(&RBig) -> bool, right: &str) -> Result<Quantity, Failure> {
    let quantity = quantity(text)?;
    let Measured { value, within } = quantity.number();
    match (can_be(value), can_be(&(value - within))) {
        (true, true) => Ok(quantity),
        (false, _) => Err(Failure::input(right)),
        (true, false) => {
            let least = decimal::short(&(value - within));
            Err(Failure::input(format!("its ± reaches down to {least}: {right}, or a smaller number after ±")))
        }
    }
}

/// A name without the blanks beside it.
#[expect(clippy::unnecessary_wraps, reason = "what clap calls")]
pub fn trimmed(text: &str) -> Result<String, Failure> {
    Ok(text.trim().to_owned())
}

/// How a window is written.
const WINDOW: &str = "a window is written hmin:hmax,lmin:lmax, such as 0:6,0:4";

pub fn window(text: &str) -> Result<WindowDocument, Failure> {
    let (h, l) = text.split_once(',').ok_or_else(|| Failure::input(WINDOW))?;
    let (h, _) = interval(h, ["hmin", "hmax"], WINDOW)?;
    Ok(WindowDocument { h, l: momenta_of(l, WINDOW)? })
}

/// Momenta from one to another.
pub fn momenta(text: &str) -> Result<[f64; 2], Failure> {
    momenta_of(text, "write lmin:lmax, such as 0:4")
}

fn momenta_of(text: &str, right: &str) -> Result<[f64; 2], Failure> {
    let (ends, from) = interval(text, ["lmin", "lmax"], right)?;
    if ends[0] < 0.0 {
        let from = from.text();
        return Err(Failure::input(format!("lmin = {from} is negative; everything depends on l² only, give lmin ≥ 0")));
    }
    Ok(ends)
}

fn interval(text: &str, [low, high]: [&str; 2], right: &str) -> Result<([f64; 2], Number), Failure> {
    let (from, to) = text.split_once(':').ok_or_else(|| Failure::input(right))?;
    let entry =
        |name, text: &str| text.parse::<Number>().map_err(|error| Failure::input(format!("{name}: {error}; {right}")));
    let (from, to) = (entry(low, from)?, entry(high, to)?);
    let ends = [from.to_f64(), to.to_f64()];
    if ends[0] < ends[1] {
        return Ok((ends, from));
    }
    let why = if from.value() < to.value() {
        format!("is the same double as {high} = {}; write ends that are further apart", to.text())
    } else {
        format!("is not below {high} = {}; write the lower end first", to.text())
    };
    Err(Failure::input(format!("{low} = {} {why}", from.text())))
}

/// The energies and the momenta of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    pub h: GridAxis,
    pub l: GridAxis,
}

/// How a grid is written.
const GRID: &str = "a grid is written hmin:hmax:n,lmin:lmax:m, such as -1:6:200,0:4:200";

pub fn grid(text: &str) -> Result<Grid, Failure> {
    /// The most points of a grid.
    const MOST: usize = 100_000_000;
    let (h, l) = text.split_once(',').ok_or_else(|| Failure::input(GRID))?;
    let (h, l) = (axis(h)?, axis(l)?);
    match h.count.saturating_mul(l.count) {
        points if points > MOST => Err(Failure::input(format!("{points} points; a grid has at most {MOST}"))),
        _ => Ok(Grid { h, l }),
    }
}

fn axis(text: &str) -> Result<GridAxis, Failure> {
    let parts: Vec<&str> = text.split(':').collect();
    let [from, to, count] = parts[..] else { return Err(Failure::input(GRID)) };
    let count = count.trim().parse().ok().filter(|count| *count > 0).ok_or_else(|| Failure::input(GRID))?;
    Ok(GridAxis { from: number(from)?, to: number(to)?, count })
}

pub fn threads(text: &str) -> Result<NonZeroUsize, Failure> {
    let count = text.parse::<NonZeroUsize>().ok().filter(|count| count.get() <= MAX_THREADS);
    count.ok_or_else(|| Failure::input(format!("the number of threads is a whole number from 1 to {MAX_THREADS}")))
}

/// A number needed only as the nearest double.
pub fn float(text: &str) -> Result<f64, Failure> {
    Ok(number(text)?.to_f64())
}

/// The truncation error of a step of the integrator.
pub fn step_tolerance(text: &str) -> Result<f64, Failure> {
    let tolerance = float(text)?;
    match check_tolerance(tolerance) {
        Ok(()) => Ok(tolerance),
        Err(_) => Err(Failure::input("the truncation error of a step is from 1e-18 to 1e-2, such as 1e-12")),
    }
}

pub fn duration(text: &str) -> Result<f64, Failure> {
    let time = float(text)?;
    if time > 0.0 { Ok(time) } else { Err(Failure::input("a time must be greater than zero, such as 1e4")) }
}

pub fn triple(text: &str) -> Result<Triple, Failure> {
    let numbers = entries(text, &["x", "y", "z"], "write three with commas between them, such as 0.6,0,0.8", number)?;
    Ok(Triple(numbers))
}

pub fn vector(text: &str) -> Result<[f64; 3], Failure> {
    Ok(triple(text)?.rounded())
}

/// A normalized vector; one of length 1 within rounding is left unchanged.
pub fn direction(text: &str) -> Result<[f64; 3], Failure> {
    to_direction(vector(text)?)
}

/// A vector that is not 0.
pub fn vertical(text: &str) -> Result<Vertical, Failure> {
    let given = triple(text)?;
    Ok(Vertical { unit: to_direction(given.rounded())?, given })
}

/// Digits of a proof.
pub fn proof_digits(text: &str) -> Result<u32, Failure> {
    let digits = text.parse::<u32>().ok().filter(|digits| (5..=MOST_DIGITS).contains(digits));
    digits.ok_or_else(|| Failure::input(format!("the digits of a proof are a whole number from 5 to {MOST_DIGITS}")))
}

/// The widest enclosure wanted.
pub fn proof_bound(text: &str) -> Result<f64, Failure> {
    let bound = float(text).ok().filter(|bound| (1e-140..=1.0).contains(bound));
    bound.ok_or_else(|| Failure::input("the widest interval wanted is from 1e-140 to 1, such as 1e-12"))
}

pub fn orbits(text: &str) -> Result<NonZeroU32, Failure> {
    /// The memory of many more would be the limit.
    const MOST: u32 = 1_000_000;
    count(text, "orbits", MOST)
}

pub fn crossings(text: &str) -> Result<NonZeroU32, Failure> {
    /// Crossings are numbered by 32-bit integers in the data.
    const MOST: u32 = i32::MAX.unsigned_abs();
    count(text, "crossings", MOST)
}

fn count(text: &str, things: &str, most: u32) -> Result<NonZeroU32, Failure> {
    let count = text.parse::<NonZeroU32>().ok().filter(|count| count.get() <= most);
    count.ok_or_else(|| Failure::input(format!("the number of {things} is a whole number from 1 to {most}")))
}

pub fn share_error(text: &str) -> Result<f64, Failure> {
    let error = float(text)?;
    let is_possible = (1e-4..=0.5).contains(&error);
    is_possible.then_some(error).ok_or_else(|| Failure::input("a standard deviation from 0.0001 to 0.5 is needed"))
}

pub fn seed(text: &str) -> Result<u64, Failure> {
    text.parse().map_err(|_not_a_seed| Failure::input(format!("a seed is a whole number from 0 to {}", u64::MAX)))
}

/// An angle: a number of radians, or a multiple of pi such as pi/2, -pi, 3pi/4.
pub fn angle(text: &str) -> Result<f64, Failure> {
    use std::f64::consts::PI;
    let Some((factor, divisor)) = text.split_once("pi") else { return float(text) };
    let wrong = || {
        Failure::input(format!(
            "`{text}` is not an angle; write a number of radians, or a multiple of pi such as pi/2, -pi or 3pi/4"
        ))
    };
    let factor = match factor.trim() {
        "" | "+" => 1.0,
        "-" => -1.0,
        "*" => return Err(wrong()),
        factor => float(factor.strip_suffix('*').unwrap_or(factor))?,
    };
    let divisor = match divisor.trim() {
        "" => 1.0,
        divisor => {
            let divisor = divisor.strip_prefix('/').filter(|divisor| !divisor.contains('/')).ok_or_else(wrong)?;
            Some(float(divisor)?).filter(|divisor| *divisor != 0.0).ok_or_else(wrong)?
        }
    };
    Ok(factor * PI / divisor)
}

/// Euler's angles ϑ, ψ, φ.
pub fn angles(text: &str) -> Result<[f64; 3], Failure> {
    entries(text, &["theta", "psi", "phi"], "write three angles, such as pi/3,0,0", angle)
}

/// A sheet of the PP-torus: 1, + or T+; -1, - or T-.
pub fn sheet(text: &str) -> Result<i8, Failure> {
    match text {
        "1" | "+1" | "+" | "T+" => Ok(1),
        "-1" | "-" | "T-" => Ok(-1),
        _ => Err(Failure::input("a sheet is + (or 1) or - (or -1), by the sign of Delta")),
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
    let value =
        |preset: &Preset| PossibleValue::new(preset.name()).aliases(preset.other_spellings()).help(preset.note());
    let names = Preset::all().iter().map(value);
    PossibleValuesParser::new(names).try_map(|name| Preset::find(&name).ok_or("bifdiag bodies lists the names"))
}

/// The values of `--accuracy`.
const LEVELS: [Named<Accuracy>; 2] = [
    ("exact", "Never undecided: f64 where its error bounds suffice, exact arithmetic elsewhere", Accuracy::Exact),
    ("fast", "f64 with error bounds; may say undecided or refuse", Accuracy::Fast),
];

/// What became of the words of version 1.
const SUCCESSORS: [(&str, &str); 3] = [
    ("draft", "coarser answers were removed: leave it out for `exact`, or give `fast`"),
    ("standard", "leave it out for `exact`, which is never undecided, or give `fast` for f64 alone"),
    ("certified", "answers are `exact` by default; `bifdiag atlas --certificate` adds the certificate"),
];

/// Reads a level; the words of version 1 name their successors.
pub fn accuracy() -> impl TypedValueParser<Value = Accuracy> {
    AccuracyParser
}

#[derive(Clone)]
struct AccuracyParser;

impl TypedValueParser for AccuracyParser {
    type Value = Accuracy;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<Self::Value, Error> {
        let successor = SUCCESSORS.into_iter().find(|(word, _)| value == *word);
        let Some((word, successor)) = successor else { return named(&LEVELS).parse_ref(command, arg, value) };
        let mut error = Error::new(ErrorKind::InvalidValue).with_cmd(command);
        let option = arg.map_or_else(|| "--accuracy".to_owned(), ToString::to_string);
        let levels = LEVELS.map(|(word, ..)| word.to_owned()).to_vec();
        error.insert(ContextKind::InvalidArg, ContextValue::String(option));
        error.insert(ContextKind::InvalidValue, ContextValue::String(word.to_owned()));
        error.insert(ContextKind::ValidValue, ContextValue::Strings(levels));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![successor.into()]));
        Err(error)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let levels: Vec<_> = named(&LEVELS).possible_values()?.collect();
        Some(Box::new(levels.into_iter()))
    }
}
