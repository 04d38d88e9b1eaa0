//! What the tints, lines and marks are.

use bifdiag_schema::ComponentDocument;
use plotters::style::RGBColor;

use super::ink::{BOUNDARY, FORBIDDEN, LEVEL, tint};
use super::marks::{self, Mark};
use super::scene::SphereScene;
use crate::page::{Canvas, Ink, Legend, Point, Rect, section_type};

const SAMPLE: f64 = 24.0;

pub(super) enum Symbol {
    Tint(RGBColor),
    Line(Ink),
    Mark(Mark),
}

/// What the scene needs explained, in rows of `width` pixels.
pub(super) fn legend(scene: &SphereScene<'_>, width: f64) -> Legend<Symbol> {
    let components = scene.components.iter().enumerate();
    let mut entries: Vec<(Symbol, String)> =
        components.map(|(place, component)| (Symbol::Tint(tint(place)), sentence(place + 1, component))).collect();
    if entries.is_empty() {
        entries.push((Symbol::Tint(tint(0)), "accessible: U(γ) ≤ h".to_owned()));
    }
    entries.push((Symbol::Tint(FORBIDDEN), "not accessible: U(γ) > h".to_owned()));
    entries.push((Symbol::Line(BOUNDARY), "∂U: U(γ) = h".to_owned()));
    entries.push((Symbol::Line(LEVEL), "other levels of U".to_owned()));
    if scene.r_hat.is_some() {
        entries.push((Symbol::Mark(Mark::Pole(true)), "+r̂, hanging".to_owned()));
        entries.push((Symbol::Mark(Mark::Pole(false)), "−r̂, upright".to_owned()));
    }
    Legend::new(entries, |_| SAMPLE, width)
}

/// A component in words: its boundary circles and poles, and what lies above it.
fn sentence(number: usize, component: &ComponentDocument) -> String {
    let circles = match component.boundary_circles {
        0 => "the whole sphere".to_owned(),
        1 => "1 boundary circle".to_owned(),
        many => format!("{many} boundary circles"),
    };
    let poles = match component.poles.as_deref() {
        None => String::new(),
        Some([]) => ", no pole".to_owned(),
        Some([pole]) => format!(", pole {}r̂", pole.replace('-', "−")),
        Some(_) => ", both poles".to_owned(),
    };
    let section = component
        .section
        .as_ref()
        .zip(component.genus)
        .map_or_else(String::new, |(section, genus)| format!(", P = {} (genus {genus})", section_type(section)));
    let energy = component.energy_surface.replace("S1xS2", "S¹×S²").replace("RP3", "RP³").replace("S3", "S³");
    format!("{number}: {circles}{poles};  E = {energy}{section}")
}

/// Draws the legend with its top left corner at `at`.
pub(super) fn draw(legend: &Legend<Symbol>, canvas: &Canvas, at: Point) {
    legend.draw(canvas, at, |symbol, [x, middle]| match symbol {
        Symbol::Tint(color) => {
            let swatch = Rect { x, y: middle - 6.0, width: SAMPLE, height: 12.0 };
            canvas.patch(&swatch.corners(), *color);
            canvas.outline(&swatch.corners(), Ink { color: crate::page::FAINT_INK, width: 0.6 });
        }
        Symbol::Line(ink) => canvas.path(&[[x, middle], [x + SAMPLE, middle]], *ink),
        Symbol::Mark(mark) => marks::draw(canvas, *mark, [x + SAMPLE / 2.0, middle]),
    });
}
