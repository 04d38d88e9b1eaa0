//! Real parts: mass properties, meshes and inertial blocks as bodies.

use std::path::PathBuf;

use bifdiag::body::part::file::{FileOptions, read};
use bifdiag::body::part::{Existence, MassProperties, Part, Units};
use bifdiag::documents::Subject;
use bifdiag::numbers::symmetric::Symmetric;
use dashu_ratio::RBig;
use pyo3::prelude::*;

use crate::body::Body;
use crate::errors;
use crate::texts::number;

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
    let mut entries = Vec::new();
    for (row, column) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        let [above, below] = [number(&tensor[row][column])?, number(&tensor[column][row])?];
        if above.value() != below.value() {
            let (above, below) = (above.text(), below.text());
            let [row, column] = [row + 1, column + 1];
            return Err(errors::wrong(format!(
                "the tensor is not symmetric: entry {row},{column} is {above}, entry {column},{row} is {below}"
            )));
        }
        entries.push(above.value().clone());
    }
    let tensor = Symmetric::new(entries.try_into().expect("six entries"));
    let mass = number(mass)?.value().clone();
    let com = rationals(&com)?;
    let properties = if about_com {
        MassProperties::about_com(mass, com, tensor)
    } else {
        MassProperties::about_origin(mass, com, &tensor)
    };
    of_properties(properties.map_err(|error| errors::body(&error))?, gravity, parsed(units)?, unphysical)
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
    let [density, mass] = weight.map(|text| text.as_deref().map(number).transpose());
    let (density, mass) = (density?, mass?);
    let options = FileOptions { link, density: density.as_ref(), mass: mass.as_ref() };
    let found = read(&path, &options).map_err(|error| errors::wrong(format!("{}: {error}", path.display())))?;
    let (properties, units) = found.seen_from(&rationals(&pivot)?, units.map(parsed).transpose()?);
    of_properties(properties, gravity, units, unphysical)
}

fn of_properties(properties: MassProperties, gravity: &str, units: Units, unphysical: bool) -> PyResult<Body> {
    if let (Existence::Impossible(inequality), false) = (properties.existence(), unphysical) {
        return Err(errors::no_body(format!(
            "this part cannot exist: about its centre of mass {inequality} ({}). Check digits, units, reference point and \
             the sign of the products, or pass unphysical=True",
            units.moment()
        )));
    }
    let part = Part { properties, gravity: number(gravity)?.value().clone(), units };
    let subject = Subject::of_part(&part).map_err(|error| errors::body(&error))?;
    Ok(Body { subject })
}

fn parsed(units: &str) -> PyResult<Units> {
    units.parse().map_err(|error: bifdiag::body::part::UnitsError| errors::input(&error))
}

fn rationals(texts: &[String; 3]) -> PyResult<[RBig; 3]> {
    let [x, y, z] = texts.each_ref().map(|text| number(text));
    Ok([x?, y?, z?].map(|number| number.value().clone()))
}
