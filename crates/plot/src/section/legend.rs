//! What the shades and lines of a section are.

use std::collections::BTreeSet;

use plotters::style::RGBColor;

use super::colors::{family, shades, unknown};
use super::ground::{BOUNDARY, INCOMING, OUTGOING, POLAR, TANGENCY, pole_marker};

use super::scene::{Projection, SectionScene};
use crate::page::{Canvas, Ink, Legend, Path, Rect};
use bifdiag_dynamics::section::SectionCondition;

const SAMPLE: f64 = 26.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 20.0;

/// What is explained.
pub(super) enum Symbol {
    Shade(RGBColor),
    Line(Ink),
    /// +r̂ (1) or −r̂.
    Pole(i8),
    /// The shades of a family of orbits.
    Dots(Vec<RGBColor>),
}

/// What the sections need explained, on a page of this width.
pub(super) fn legend(scenes: &[SectionScene<'_>], projection: Projection, width: f64) -> Legend<Symbol> {
    let mut entries = vec![
        (Symbol::Shade(INCOMING), "Ṡ < 0, incoming".to_owned()),
        (Symbol::Shade(OUTGOING), "Ṡ > 0, outgoing".to_owned()),
        (Symbol::Line(TANGENCY), "Ṡ = 0, tangency".to_owned()),
    ];
    if scenes.iter().any(|scene| !scene.portrait.boundary().is_empty()) {
        let boundary = match scenes[0].portrait.condition() {
            SectionCondition::Height => "∂U",
            SectionCondition::AngularMomentum => "boundary of the projection",
        };
        entries.push((Symbol::Line(BOUNDARY), boundary.to_owned()));
    }
    let poles = [1, -1].map(|sign| scenes.iter().any(|scene| scene.portrait.has_pole(sign)));
    if projection != Projection::Torus {
        for (_, (sign, name)) in poles.into_iter().zip([(1, "+r̂"), (-1, "−r̂")]).filter(|(any, _)| *any) {
            entries.push((Symbol::Pole(sign), format!("{name}, accessible")));
        }
    }
    if projection != Projection::Sphere && poles.contains(&true) {
        let pole = "accessible polar circle (above +r̂, below −r̂), T⁻ and T⁺ glued with ψ′ + π";
        entries.push((Symbol::Line(POLAR), pole.to_owned()));
    }
    entries.extend(colors_told(scenes));
    Legend::new(entries, |_| SAMPLE, width - LEFT - RIGHT)
}

/// What the colours of the orbits mean.
fn colors_told(scenes: &[SectionScene<'_>]) -> Vec<(Symbol, String)> {
    let orbits = || scenes.iter().flat_map(|scene| (0..scene.orbits.len()).map(move |index| (scene, index)));
    if scenes.iter().any(|scene| scene.values.is_some()) {
        let is_open = |(scene, index): (&SectionScene<'_>, usize)| {
            scene.values.is_none_or(|values| !values.values[index].is_finite())
        };
        let entry = (Symbol::Dots(vec![unknown()]), "orbits without a value".to_owned());
        return orbits().any(is_open).then_some(entry).into_iter().collect();
    }
    let families: BTreeSet<usize> = orbits().map(|(scene, index)| family(scene, index)).collect();
    let names = scenes.iter().find_map(|scene| scene.families).map_or(&[][..], |families| families.names);
    let told = |family: usize| {
        let name = names.get(family).map_or_else(String::new, |name| format!("{name}: "));
        (Symbol::Dots(shades(family).to_vec()), format!("{name}orbits, told apart by shades"))
    };
    families.into_iter().map(told).collect()
}

/// Draws a legend below `top`.
pub(super) fn draw(legend: &Legend<Symbol>, canvas: &Canvas, top: f64) {
    for (symbol, [x, middle]) in legend.symbols([LEFT, top]) {
        let mut path = Path::default();
        match symbol {
            Symbol::Shade(color) => {
                let swatch = Rect { x, y: middle - 6.0, width: SAMPLE, height: 12.0 };
                path.line(&swatch.corners(), true);
                path.draw(canvas, &format!("{} stroke=\"#8A8A8A\" stroke-width=\"5\"", canvas.fill(*color)));
            }
            Symbol::Line(ink) => {
                path.line(&[[x, middle], [x + SAMPLE, middle]], false);
                path.draw(canvas, &canvas.stroke(*ink));
            }
            Symbol::Pole(_) | Symbol::Dots(_) => {}
        }
    }
    for (symbol, [x, middle]) in legend.symbols([LEFT, top]) {
        if let Symbol::Dots(colors) = symbol {
            for (place, color) in colors.iter().enumerate() {
                let step = SAMPLE / colors.len() as f64;
                canvas.disc([x + step * (place as f64 + 0.5), middle], 2.2, *color);
            }
        }
        if let Symbol::Pole(sign) = symbol {
            pole_marker(canvas, *sign, [x + SAMPLE / 2.0, middle]);
        }
    }
    legend.draw(canvas, [LEFT, top], |_, _| {});
}
