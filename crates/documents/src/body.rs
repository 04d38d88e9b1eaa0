//! Bodies as documents: numbers as they were given, flags, real parts, presets.

use bifdiag_body::part::Part;
use bifdiag_body::{Body, Preset, PrincipalForm};
use bifdiag_numbers::symmetric::{PrincipalAxes, Real};
use bifdiag_numbers::{Number, decimal};
use bifdiag_schema::{
    BodiesDocument, CommandLine, GivenBody, Head, PartDocument, PresetDocument, PrincipalDocument, SCHEMA_VERSION,
};
use dashu_ratio::RBig;

/// Version of the program, for its documents.
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// What a document begins with; `command` makes it.
#[must_use]
pub fn head(command: String) -> Head {
    Head { schema_version: SCHEMA_VERSION.to_owned(), version: version(), command }
}

/// Numbers as they were written.
#[must_use]
pub fn texts<const N: usize>(numbers: &[Number; N]) -> [String; N] {
    numbers.each_ref().map(|number| number.text().to_owned())
}

/// A body by the texts of its numbers.
#[must_use]
pub fn given(body: &Body) -> GivenBody {
    GivenBody { moments: texts(body.moments()), center: texts(body.center()) }
}

/// A part as it was understood.
#[must_use]
pub fn part(part: &Part, principal: &PrincipalForm) -> PartDocument {
    let properties = &part.properties;
    let central = PrincipalAxes::new(&properties.about_com, &[RBig::ZERO, RBig::ZERO, RBig::ZERO], 20);
    let body = &principal.body;
    PartDocument {
        inertia: properties.tensor_about_origin().rows().each_ref().map(|row| row.each_ref().map(decimal::short)),
        com: properties.com.each_ref().map(decimal::short),
        mass: decimal::short(&properties.mass),
        g: decimal::short(&part.gravity),
        units: part.units.to_string(),
        principal: PrincipalDocument { moments: body.moments_f64(), axes: principal.axes },
        principal_com: PrincipalDocument { moments: central.values.each_ref().map(Real::to_f64), axes: central.axes },
        moments: texts(body.moments()),
        center: texts(body.center()),
        exact: principal.exact,
        physical: properties.existence().is_possible(),
    }
}

/// Every named body.
#[must_use]
pub fn all_bodies() -> BodiesDocument {
    let describe = |preset: &Preset| {
        let body = preset.body();
        PresetDocument { name: preset.name().to_owned(), body: given(&body), note: preset.note().to_owned() }
    };
    BodiesDocument {
        head: head(CommandLine::new("bodies").json()),
        bodies: Preset::all().iter().map(describe).collect(),
    }
}
