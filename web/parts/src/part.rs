//! What a form of the page says of a part, and the part.

use std::path::Path;

use bifdiag::body::TensorError;
use bifdiag::body::part::file::{FileError, FileOptions, of_bytes};
use bifdiag::body::part::{Existence, MassError, MassProperties, Part, Products, Units, UnitsError, tensor_of};
use bifdiag::documents;
use bifdiag::numbers::Number;
use bifdiag::numbers::ParseNumberError;
use bifdiag::schema::PartDocument;
use thiserror::Error;

/// Why there is no part.
#[derive(Debug, Error)]
pub enum Refused {
    #[error("{name}: {source}")]
    Number { name: &'static str, source: ParseNumberError },
    #[error("{name} needs {wanted} numbers, {found} given")]
    Count { name: &'static str, wanted: usize, found: usize },
    #[error(transparent)]
    Units(#[from] UnitsError),
    #[error(transparent)]
    Mass(#[from] MassError),
    #[error(transparent)]
    Tensor(#[from] TensorError),
    #[error(transparent)]
    File(#[from] FileError),
    #[error(
        "this part cannot exist: about its centre of mass {inequality} ({unit}); check digits, units, reference point and \
         the sign of the products"
    )]
    Impossible { inequality: String, unit: String },
}

/// Standard gravity in m/s².
const GRAVITY: &str = "9.80665";

/// What a form says of a part; empty texts say nothing.
pub struct Form<'a> {
    pub density: &'a str,
    pub mass: &'a str,
    pub units: &'a str,
    /// The fixed point in the frame of a file; the centre of mass of a tensor.
    pub point: &'a str,
}

impl Form<'_> {
    fn units(&self) -> Result<Option<Units>, Refused> {
        if self.units.is_empty() { Ok(None) } else { Ok(Some(self.units.parse()?)) }
    }

    fn triple(&self, name: &'static str) -> Result<[Number; 3], Refused> {
        let numbers = list(name, if self.point.is_empty() { "0,0,0" } else { self.point })?;
        numbers.try_into().map_err(|numbers: Vec<_>| Refused::Count { name, wanted: 3, found: numbers.len() })
    }
}

/// The part of a mesh or of an inertial block; the name tells the format.
pub fn of_file(name: &str, bytes: Vec<u8>, form: &Form<'_>) -> Result<PartDocument, Refused> {
    let given = |name, text: &str| if text.is_empty() { Ok(None) } else { number(name, text).map(Some) };
    let (density, mass) = (given("density", form.density)?, given("mass", form.mass)?);
    let options = FileOptions { link: None, density: density.as_ref(), mass: mass.as_ref() };
    let pivot = form.triple("pivot")?.map(|number| number.value().clone());
    let (properties, units) = of_bytes(Path::new(name), bytes, &options)?.seen_from(&pivot, form.units()?);
    document(properties, units)
}

/// The part of a tensor Ixx, Iyy, Izz, Ixy, Ixz, Iyz about its centre of mass or about the fixed point.
pub fn of_tensor(entries: &str, products: Products, about_com: bool, form: &Form<'_>) -> Result<PartDocument, Refused> {
    let entries = list("tensor", entries)?;
    let found = entries.len();
    let entries = entries.into_iter().map(|number| number.value().clone()).collect::<Vec<_>>();
    let entries = entries.try_into().map_err(|_| Refused::Count { name: "tensor", wanted: 6, found })?;
    let tensor = tensor_of(entries, products);
    let com = form.triple("centre of mass")?.map(|number| number.value().clone());
    let mass = number("mass", form.mass)?.value().clone();
    let properties = if about_com {
        MassProperties::about_com(mass, com, tensor)?
    } else {
        MassProperties::about_origin(mass, com, &tensor)?
    };
    document(properties, form.units()?.unwrap_or_default())
}

fn document(properties: MassProperties, units: Units) -> Result<PartDocument, Refused> {
    if let Existence::Impossible(inequality) = properties.existence() {
        return Err(Refused::Impossible { inequality: inequality.to_string(), unit: units.moment() });
    }
    let part = Part { properties, gravity: number("g", GRAVITY)?.value().clone(), units };
    let principal = part.principal()?;
    Ok(documents::part(&part, &principal))
}

fn number(name: &'static str, text: &str) -> Result<Number, Refused> {
    text.parse().map_err(|source| Refused::Number { name, source })
}

fn list(name: &'static str, text: &str) -> Result<Vec<Number>, Refused> {
    let separator = |c: char| c == ',' || c == ';' || c.is_whitespace();
    text.split(separator).filter(|word| !word.is_empty()).map(|word| number(name, word)).collect()
}
