//! Values of options, read exactly and refused with what would be right.

use std::num::NonZeroUsize;

use bifdiag::body::{Body, BodyError, Number, ParseNumberError, Preset};
use bifdiag::document::WindowDocument;
use clap::builder::{PossibleValue, PossibleValuesParser};
use thiserror::Error;

/// The most threads that can be asked for.
const MAX_THREADS: usize = 1024;

/// Three numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple(pub [Number; 3]);

/// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz.
#[derive(Clone, Debug, PartialEq)]
pub struct Tensor(pub [Number; 6]);

/// Why a value is refused.
#[derive(Debug, PartialEq, Error)]
pub enum ValueError {
    #[error("{0}; write three positive numbers with commas between them, such as 2,1.1,1")]
    Moments(BodyError),
    #[error("{0}; write three numbers with commas between them, such as 0.94868,0,0.61623")]
    Center(BodyError),
    #[error("{count} numbers given; write the three coordinates in m, such as 0,0.02,0.15")]
    CenterOfMassCount { count: usize },
    #[error("{count} numbers given; write the six matrix entries Ixx,Iyy,Izz,Ixy,Ixz,Iyz in kg m²")]
    TensorCount { count: usize },
    #[error("{name}: {source}")]
    Entry { name: &'static str, source: ParseNumberError },
    #[error("{0}")]
    Number(#[from] ParseNumberError),
    #[error("a mass must be greater than zero; give it in kg")]
    Mass,
    #[error("the acceleration of gravity must not be negative; give its magnitude in m/s², such as 9.80665")]
    Gravity,
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

pub fn tensor(text: &str) -> Result<Tensor, ValueError> {
    const NAMES: [&str; 6] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
    Ok(Tensor(entries(text, &NAMES, |count| ValueError::TensorCount { count })?))
}

fn entries<const N: usize>(
    text: &str,
    names: &[&'static str; N],
    wrong_count: impl Fn(usize) -> ValueError,
) -> Result<[Number; N], ValueError> {
    let parts = parts(text);
    if parts.len() != N {
        return Err(wrong_count(parts.len()));
    }
    let mut numbers = Vec::with_capacity(N);
    for (&name, part) in names.iter().zip(parts) {
        numbers.push(part.parse().map_err(|source| ValueError::Entry { name, source })?);
    }
    numbers.try_into().map_err(|numbers: Vec<Number>| wrong_count(numbers.len()))
}

pub fn mass(text: &str) -> Result<Number, ValueError> {
    let mass = number(text)?;
    if mass.to_f64() > 0.0 { Ok(mass) } else { Err(ValueError::Mass) }
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

pub fn threads(text: &str) -> Result<NonZeroUsize, ValueError> {
    let count = text.parse::<NonZeroUsize>().map_err(|_not_a_count| ValueError::Threads)?;
    if count.get() <= MAX_THREADS { Ok(count) } else { Err(ValueError::Threads) }
}

pub fn preset_names() -> PossibleValuesParser {
    Preset::all().iter().map(|preset| PossibleValue::new(preset.name()).help(preset.note())).collect::<Vec<_>>().into()
}
