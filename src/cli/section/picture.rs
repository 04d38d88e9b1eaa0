//! The picture of sections: a row for each, with its orbits.

use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_dynamics::section::{FAMILIES, Portrait, PortraitOptions, families};
use bifdiag_plot::{
    OrbitColors, OrbitFamilies, OrbitValues, Picture, SectionOptions, SectionScene, draw_section_rows, section_type,
};
use bifdiag_schema::{ConditionName, OrbitDocument, SectionDocument, VerdictName, VerdictsName};

use super::arguments::ColorArgument;
use super::plan::Plan;
use super::sites::poincare_failure;
use super::table;
use super::work::Done;
use crate::cli::failure::Failure;

/// A section and what its picture needs beyond its orbits.
struct Row<'a> {
    section: &'a Done,
    portrait: Portrait,
    /// The kind of each orbit, a place in `names`.
    of: Vec<usize>,
    names: &'static [&'static str],
    colors: OrbitColors,
    values: Option<(&'static str, Vec<f64>)>,
    caption: String,
}

/// Draws sections below each other.
pub fn draw(plan: &Plan<'_>, sections: &[Done]) -> Result<Picture, Failure> {
    let rows: Vec<Row<'_>> = sections.iter().map(|section| row(plan, section)).collect::<Result<_, _>>()?;
    let scenes: Vec<SectionScene<'_>> = rows
        .iter()
        .map(|row| SectionScene {
            portrait: &row.portrait,
            orbits: &row.section.orbits,
            values: row.values.as_ref().map(|(label, values)| OrbitValues { label, values }),
            families: Some(OrbitFamilies { of: &row.of, names: row.names, colors: row.colors }),
            curves: None,
            caption: &row.caption,
        })
        .collect();
    let arguments = plan.arguments;
    let (projection, theme, width) = (arguments.projection, arguments.picture.theme, arguments.width.width);
    let options = SectionOptions { projection, theme, width, ..SectionOptions::default() };
    Ok(draw_section_rows(&scenes, &options)?)
}

fn row<'a>(plan: &Plan<'_>, section: &'a Done) -> Result<Row<'a>, Failure> {
    let (arguments, document, body) = (plan.arguments, &section.document, &plan.sites.subject.body);
    let options = PortraitOptions { condition: arguments.condition, ..PortraitOptions::default() };
    let portrait = Portrait::new(body, section.h, section.l, &options)
        .map_err(|error| poincare_failure(PoincareError::from(error)))?;
    if !portrait.report().is_complete() {
        tracing::warn!("the boundary or the line of tangency of this section may be incomplete in the picture");
    }
    let color = arguments.color.unwrap_or_else(|| {
        let is_judged = document.verdicts != VerdictsName::None;
        if is_judged { ColorArgument::Verdict } else { ColorArgument::Orbit }
    });
    let sides = || families(body, section.h, section.l, &section.orbits);
    let (of, names, colors) = match color {
        ColorArgument::Verdict => (verdicts(document), &VERDICTS[..], OrbitColors::Verdicts),
        ColorArgument::Side => (sides(), &FAMILIES[..], OrbitColors::Families),
        _ => (sides(), &FAMILIES[..], OrbitColors::Orbits),
    };
    let (values, caption) = (values(color, document), caption(document));
    Ok(Row { section, portrait, of, names, colors, values, caption })
}

/// The text after (h, l): the region and the type.
fn caption(document: &SectionDocument) -> String {
    // The type is that of the paper's section.
    let own = document.condition == ConditionName::Height;
    let signature = document.signature.as_ref().filter(|_| own).map(|signature| section_type(signature));
    let parts = [document.region.clone(), signature];
    parts.into_iter().flatten().collect::<Vec<_>>().join(",  ")
}

/// What verdicts are called.
const VERDICTS: [&str; 3] = ["regular", "chaotic", "undecided"];

/// The verdict of each orbit, a place in [`VERDICTS`].
fn verdicts(document: &SectionDocument) -> Vec<usize> {
    let verdict = |orbit: &OrbitDocument| match orbit.verdict {
        VerdictName::Regular => 0,
        VerdictName::Chaotic => 1,
        VerdictName::Open => 2,
    };
    document.orbits.iter().map(verdict).collect()
}

/// The numbers that colour the orbits, and what they are.
fn values(color: ColorArgument, document: &SectionDocument) -> Option<(&'static str, Vec<f64>)> {
    let (label, value): (_, fn(&_) -> Option<f64>) = match color {
        ColorArgument::Orbit | ColorArgument::Side | ColorArgument::Verdict => return None,
        ColorArgument::Lyapunov => ("Lyapunov exponent", table::lyapunov),
        ColorArgument::Rotation => ("rotation number", table::rotation),
    };
    let of = |orbit: &OrbitDocument| orbit.chaos.as_ref().and_then(value).unwrap_or(f64::NAN);
    Some((label, document.orbits.iter().map(of).collect()))
}
