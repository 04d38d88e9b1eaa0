//! Bodies as documents: numbers as they were given, flags, real parts, presets.

use numbers::Number;
use schema::{BodiesDocument, Flags, InertiaDocument, PresetDocument, SCHEMA_VERSION, UnitsDocument};
use top::body::{Body, MassProperties, Preset, PrincipalBody};

/// Numbers as they were written.
#[must_use]
pub fn texts<const N: usize>(numbers: &[Number; N]) -> [String; N] {
    numbers.each_ref().map(|number| number.text().to_owned())
}

/// What is special about a body.
#[must_use]
pub fn flags(body: &Body) -> Flags {
    let top::body::Flags { unphysical, plate, symmetric, plane, axis, euler } = body.flags();
    Flags { unphysical, plate, symmetric, plane, axis, euler }
}

/// A part and its reduction to principal axes.
#[must_use]
pub fn part(part: &MassProperties, principal: &PrincipalBody) -> InertiaDocument {
    let realizability = principal.realizability();
    InertiaDocument {
        tensor: texts(&part.tensor),
        com: texts(&part.center_of_mass),
        mass: part.mass.text().to_owned(),
        g: part.gravity.text().to_owned(),
        rotation: principal.rotation(),
        exact: principal.exact(),
        residual: principal.residual(),
        unphysical: realizability.unphysical,
        plate: realizability.plate,
        parallel_axes: realizability.parallel_axes,
        units: UnitsDocument {
            moments: "kg m^2".to_owned(),
            center: "N m".to_owned(),
            h: "J".to_owned(),
            l: "kg m^2/s".to_owned(),
            omega: "rad/s".to_owned(),
        },
    }
}

/// Every named body.
#[must_use]
pub fn all_bodies() -> BodiesDocument {
    let describe = |preset: &Preset| {
        let body = preset.body();
        PresetDocument {
            name: preset.name().to_owned(),
            moments: texts(body.moments()),
            center: texts(body.center()),
            note: preset.note().to_owned(),
        }
    };
    BodiesDocument { schema_version: SCHEMA_VERSION.to_owned(), bodies: Preset::all().iter().map(describe).collect() }
}
