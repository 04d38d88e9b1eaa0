//! Real parts: mass properties, meshes and inertial blocks as bodies.

use std::path::PathBuf;

use bifdiag::Number;
use bifdiag::body::part::file::{FileOptions, read};
use bifdiag::body::part::{Dimension, Existence, MassProperties, Measured, Part, Quantity, Units};
use bifdiag::documents::Subject;
use bifdiag::numbers::symmetric::Symmetric;
use dashu_ratio::RBig;
use pyo3::prelude::*;

use crate::body::Body;
use crate::errors;

/// The body of a tensor, its rows as texts, about the centre of mass or about the fixed point.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what was taken out of sequences")]
pub fn body_of_tensor(
    tensor: [[String; 3]; 3],
    com: [String; 3],
    mass: &str,
    gravity: &str,
    about_com: bool,
    units: &str,
    unphysical: bool,
) -> PyResult<Body> {
    let units = parsed(units)?;
    let mut given = Given::default();
    let mut entries = Vec::new();
    for (row, column) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        let [above, below] = [&tensor[row][column], &tensor[column][row]];
        let [found, mirrored] = [above, below].map(|text| given.measured(text, Dimension::MOMENT, &units));
        let (found, mirrored) = (found?, mirrored?);
        // One of the two entries may say for both how well they are known.
        let are_alike = found.within.is_zero() || mirrored.within.is_zero() || found.within == mirrored.within;
        if found.value != mirrored.value || !are_alike {
            let [row, column] = [row + 1, column + 1];
            return Err(errors::wrong(format!(
                "the tensor is not symmetric: entry {row},{column} is {above}, entry {column},{row} is {below}"
            )));
        }
        entries.push(found.value);
    }
    let tensor = Symmetric::new(entries.try_into().expect("six entries"));
    let mass = given.read(mass, Dimension::MASS, &units)?;
    let com = given.place(&com, &units)?;
    let properties = if about_com {
        MassProperties::about_com(mass, com, tensor)
    } else {
        MassProperties::about_origin(mass, com, &tensor)
    };
    let properties = properties.map_err(|error| errors::body(&error))?;
    given.of_properties(properties, gravity, units, unphysical)
}

/// The body of a mesh or of an inertial block.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what was taken out of sequences")]
pub fn body_of_file(
    path: PathBuf,
    weight: [Option<String>; 2],
    link: Option<&str>,
    pivot: [String; 3],
    gravity: &str,
    units: Option<&str>,
    unphysical: bool,
) -> PyResult<Body> {
    let own = units.map(parsed).transpose()?;
    let inner = own.clone().unwrap_or_default();
    let mut given = Given::default();
    let mut weigh = |text: &Option<String>, dimension| {
        let read = text.as_deref().map(|text| given.read(text, dimension, &inner)).transpose()?;
        Ok::<_, PyErr>(read.map(Number::from_rational))
    };
    let (density, mass) = (weigh(&weight[0], Dimension::DENSITY)?, weigh(&weight[1], Dimension::MASS)?);
    let options = FileOptions { link, density: density.as_ref(), mass: mass.as_ref() };
    let found = read(&path, &options).map_err(|error| errors::wrong(format!("{}: {error}", path.display())))?;
    let (properties, units) = found.seen_from(&given.place(&pivot, &inner)?, own);
    given.of_properties(properties, gravity, units, unphysical)
}

/// Lengths or moments, each perhaps with its unit and ±, as numbers in the units of a part.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what was taken out of sequences")]
pub fn in_units(texts: Vec<String>, of_length: bool, units: Option<&str>) -> PyResult<Vec<String>> {
    let units = units.map(parsed).transpose()?.unwrap_or_default();
    let dimension = if of_length { Dimension::LENGTH } else { Dimension::MOMENT };
    let written = |text: &String| {
        let Measured { value, within } = Given::default().measured(text, dimension, &units)?;
        Ok(if within.is_zero() { value.to_string() } else { format!("{value}±{within}") })
    };
    texts.iter().map(written).collect()
}

/// The numbers of a part as they are read, each with its unit or in those of the part.
#[derive(Default)]
struct Given {
    /// Some number is known to within so much only.
    is_measured: bool,
}

impl Given {
    /// The nominal value.
    fn read(&mut self, text: &str, dimension: Dimension, units: &Units) -> PyResult<RBig> {
        Ok(self.measured(text, dimension, units)?.value)
    }

    fn measured(&mut self, text: &str, dimension: Dimension, units: &Units) -> PyResult<Measured> {
        let quantity: Quantity = text.parse().map_err(|error| errors::input(&error))?;
        let found = quantity.measured(dimension, units).map_err(|error| errors::input(&error))?;
        self.is_measured |= !found.within.is_zero();
        Ok(found)
    }

    fn place(&mut self, texts: &[String; 3], units: &Units) -> PyResult<[RBig; 3]> {
        let [x, y, z] = texts.each_ref().map(|text| self.read(text, Dimension::LENGTH, units));
        Ok([x?, y?, z?])
    }

    fn of_properties(
        mut self,
        properties: MassProperties,
        gravity: &str,
        units: Units,
        unphysical: bool,
    ) -> PyResult<Body> {
        if let (Existence::Impossible(inequality), false) = (properties.existence(), unphysical) {
            return Err(errors::no_body(format!(
                "this part cannot exist: about its centre of mass {inequality} ({}). Check digits, units, reference point and \
             the sign of the products, or pass unphysical=True",
                units.moment()
            )));
        }
        // In m/s², whatever the units are.
        let gravity = self.read(gravity, Dimension::ACCELERATION, &Units::default())?;
        if gravity < RBig::ZERO {
            return Err(errors::wrong(
                "g must not be negative: give the magnitude of the acceleration of gravity".to_owned(),
            ));
        }
        let subject = Subject::of_part(&Part { properties, gravity, units }).map_err(|error| errors::body(&error))?;
        Ok(Body { subject, is_measured: self.is_measured })
    }
}

pub fn parsed(units: &str) -> PyResult<Units> {
    units.parse().map_err(|error: bifdiag::body::part::UnitsError| errors::input(&error))
}
