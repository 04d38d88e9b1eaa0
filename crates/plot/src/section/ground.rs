//! What a portrait says: the shaded areas, ∂U, the line of tangency and the poles; and what the legend says of them and of the
//! colours of orbits.

use std::collections::BTreeSet;

use plotters::style::RGBColor;

use super::colors::{family, shades, unknown};
use super::layout::SheetPanel;
use super::scene::{OrbitColors, Projection, SectionScene};
use bifdiag_dynamics::section::{Portrait, SectionChart, SectionCondition};
use bifdiag_page::{Canvas, INK, Ink, Path, Point, Rect, Symbol, rgb, union};

/// Ground where Ṡ < 0 and where Ṡ > 0.
const INCOMING: RGBColor = rgb(0xcd_d5_df);
const OUTGOING: RGBColor = rgb(0xf1_ee_e6);
/// The line of tangency.
const TANGENCY: Ink = Ink { color: rgb(0x6e_6e_6e), width: 1.1 };
/// ∂U.
const BOUNDARY: Ink = Ink { color: INK, width: 1.2 };
/// An accessible polar circle.
const POLAR: Ink = Ink { color: INK, width: 3.0 };

/// Shades the areas.
pub(super) fn shade(canvas: &Canvas, portrait: &Portrait, panel: &SheetPanel) {
    for (area, color) in
        [(portrait.accessible(panel.chart), OUTGOING), (portrait.incoming(panel.chart, panel.sheet), INCOMING)]
    {
        let path = union(area.loops.iter().map(|polygon| panel.positions(polygon)), 0);
        canvas.draw(&path, &format!("{} fill-rule=\"evenodd\"", canvas.fill(color)));
    }
}

/// Draws the lines, the poles and the frame.
pub(super) fn outline(canvas: &Canvas, portrait: &Portrait, panel: &SheetPanel) {
    for (lines, ink) in [(portrait.tangency(panel.sheet), TANGENCY), (portrait.boundary(), BOUNDARY)] {
        let mut path = Path::default();
        for piece in lines.iter().flat_map(|line| portrait.in_chart(panel.chart, line)) {
            path.line(&panel.positions(&piece), false);
        }
        canvas.draw(&path, &canvas.stroke(ink));
    }
    canvas.draw(&frame(&panel.rect), &canvas.stroke(Ink { color: INK, width: 0.9 }));
    let poles: Vec<i8> = [1, -1].into_iter().filter(|&sign| portrait.has_pole(sign)).collect();
    match panel.chart {
        SectionChart::Torus => {
            let mut rims = Path::default();
            for sign in poles {
                let y = if sign > 0 { panel.rect.y } else { panel.rect.bottom() };
                rims.line(&[[panel.rect.x, y], [panel.rect.right(), y]], false);
            }
            canvas.draw(&rims, &canvas.stroke(POLAR));
        }
        SectionChart::Sphere => {
            let [.., r_hat] = portrait.torus().axes();
            for sign in poles {
                let gamma = r_hat.map(|x| f64::from(sign) * x);
                let at = panel.position(portrait.position(SectionChart::Sphere, gamma));
                pole_marker(canvas, sign, at);
            }
        }
    }
}

/// The frame of a panel.
fn frame(rect: &Rect) -> Path {
    let mut frame = Path::default();
    frame.line(&rect.corners(), true);
    frame
}

/// The mark of +r̂ (`sign` > 0) or −r̂ on a sphere.
fn pole_marker(canvas: &Canvas, sign: i8, at: Point) {
    canvas.ring(at, 4.0, Ink { color: INK, width: 1.0 });
    if sign > 0 {
        canvas.disc(at, 1.2, INK);
    }
}

/// What the sections need explained.
pub(super) fn legend(scenes: &[SectionScene<'_>], projection: Projection) -> Vec<(Symbol, String)> {
    let mut entries = vec![
        (Symbol::Swatch(vec![INCOMING]), "Ṡ < 0, incoming".to_owned()),
        (Symbol::Swatch(vec![OUTGOING]), "Ṡ > 0, outgoing".to_owned()),
        (Symbol::solid(TANGENCY), "Ṡ = 0, tangency".to_owned()),
    ];
    if scenes.iter().any(|scene| !scene.portrait.boundary().is_empty()) {
        let boundary = match scenes[0].portrait.condition() {
            SectionCondition::Height => "∂U",
            SectionCondition::AngularMomentum => "boundary of the projection",
        };
        entries.push((Symbol::solid(BOUNDARY), boundary.to_owned()));
    }
    let poles = [1, -1].map(|sign| scenes.iter().any(|scene| scene.portrait.has_pole(sign)));
    if projection != Projection::Torus {
        for (_, (sign, name)) in poles.into_iter().zip([(1, "+r̂"), (-1, "−r̂")]).filter(|(any, _)| *any) {
            let mark = Box::new(move |canvas: &Canvas, at| pole_marker(canvas, sign, at));
            entries.push((Symbol::Mark("marker", mark), format!("{name}, accessible")));
        }
    }
    if projection != Projection::Sphere && poles.contains(&true) {
        let pole = "accessible polar circle (above +r̂, below −r̂), T⁻ and T⁺ glued with ψ′ + π";
        entries.push((Symbol::solid(POLAR), pole.to_owned()));
    }
    entries.extend(meaning_of_colors(scenes));
    entries
}

/// What the colours of the orbits mean.
fn meaning_of_colors(scenes: &[SectionScene<'_>]) -> Vec<(Symbol, String)> {
    let orbits = || scenes.iter().flat_map(|scene| (0..scene.orbits.len()).map(move |index| (scene, index)));
    if scenes.iter().any(|scene| scene.values.is_some()) {
        let is_open = |(scene, index): (&SectionScene<'_>, usize)| {
            scene.values.is_none_or(|values| !values.values[index].is_finite())
        };
        let entry = (Symbol::Dots(vec![unknown()]), "orbits without a value".to_owned());
        return orbits().any(is_open).then_some(entry).into_iter().collect();
    }
    let families: BTreeSet<usize> = orbits().map(|(scene, index)| family(scene, index)).collect();
    let of = scenes.iter().find_map(|scene| scene.families);
    let names = of.map_or(&[][..], |families| families.names);
    let has_verdicts = of.is_some_and(|families| families.colors == OrbitColors::Verdicts);
    let entry = |family: usize| {
        let colors = shades(&scenes[0], family);
        let apart = if colors.len() > 1 { ", told apart by shades" } else { "" };
        let text = match names.get(family) {
            Some(name) if has_verdicts => format!("{name} orbits"),
            Some(name) => format!("{name}: orbits"),
            None => "orbits".to_owned(),
        };
        (Symbol::Dots(colors), format!("{text}{apart}"))
    };
    families.into_iter().map(entry).collect()
}
