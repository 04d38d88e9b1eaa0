//! The picture of a section.

use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_dynamics::section::{FAMILIES, Portrait, PortraitOptions, families};
use bifdiag_plot::{OrbitFamilies, OrbitValues, Picture, SectionOptions, SectionScene, draw_section, section_type};
use bifdiag_schema::{ConditionName, SectionDocument};

use super::arguments::ColorArgument;
use super::error::SectionFailure;
use super::settings::Settings;
use super::table;
use super::work::Done;
use crate::cli::export::ExportError;
use crate::cli::failure::Failure;

/// Draws a section with its orbits.
pub fn draw(settings: &Settings, section: &Done) -> Result<Picture, Failure> {
    let document = &section.document;
    let options = PortraitOptions { condition: settings.condition, ..PortraitOptions::default() };
    let portrait = Portrait::new(&settings.sites.subject.body, section.h, section.l, &options)
        .map_err(|error| SectionFailure::from(PoincareError::from(error)))?;
    if !portrait.report().is_complete() {
        tracing::warn!("the boundary or the line of tangency of this section may be incomplete in the picture");
    }
    let values = values(settings.color, document);
    let of = families(&settings.sites.subject.body, section.h, section.l, &section.orbits);
    let scene = SectionScene {
        portrait: &portrait,
        orbits: &section.orbits,
        values: values.as_ref().map(|(label, values)| OrbitValues { label, values }),
        families: Some(OrbitFamilies { of: &of, names: &FAMILIES }),
        caption: &caption(document),
    };
    let super::settings::Outputs { theme, width, .. } = settings.outputs;
    let options = SectionOptions { projection: settings.projection, theme, width, ..SectionOptions::default() };
    Ok(draw_section(&scene, &options).map_err(ExportError::from)?)
}

/// What stands beside (h, l): the region and the type.
fn caption(document: &SectionDocument) -> String {
    // The type is that of the paper's section.
    let own = document.condition == ConditionName::Height;
    let signature = document.signature.as_ref().filter(|_| own).map(|signature| section_type(signature));
    let parts = [document.region.clone(), signature];
    parts.into_iter().flatten().collect::<Vec<_>>().join(",  ")
}

/// The numbers that colour the orbits, and what they are.
fn values(color: ColorArgument, document: &SectionDocument) -> Option<(&'static str, Vec<f64>)> {
    let (label, value): (_, fn(&_) -> Option<f64>) = match color {
        ColorArgument::Orbit => return None,
        ColorArgument::Lyapunov => ("Lyapunov exponent", table::lyapunov),
        ColorArgument::Rotation => ("rotation number", table::rotation),
    };
    let of = |orbit: &bifdiag_schema::OrbitDocument| orbit.chaos.as_ref().and_then(value).unwrap_or(f64::NAN);
    Some((label, document.orbits.iter().map(of).collect()))
}
