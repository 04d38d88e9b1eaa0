//! What the shades and lines of a section are.

use super::super::PlotError;
use super::super::canvas::{Anchor, Page};
use super::super::font::text_width;
use super::super::geometry::Rect;
use super::super::palette::INK;
use super::ground::{BOUNDARY, INCOMING, OUTGOING, POLAR, TANGENCY, pole_marker, stroke};
use super::path::Path;
use super::{Projection, SectionScene};
use dynamics::section::SectionCondition;

const SIZE: f64 = 11.5;
const SAMPLE: f64 = 26.0;
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;
const ROW: f64 = 20.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 20.0;

enum Symbol {
    Shade(&'static str),
    Line((&'static str, f64)),
    /// +r̂ (1) or −r̂.
    Pole(i8),
}

/// The entries in rows.
pub(super) struct Legend {
    rows: Vec<Vec<(Symbol, String)>>,
}

impl Legend {
    pub fn new(scenes: &[SectionScene<'_>], projection: Projection, width: f64) -> Self {
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
        let mut rows: Vec<Vec<(Symbol, String)>> = Vec::new();
        let mut used = f64::INFINITY;
        for entry in entries {
            let wide = SAMPLE + GAP + text_width(&entry.1, SIZE) + BETWEEN;
            if used + wide - BETWEEN > width - LEFT - RIGHT {
                rows.push(Vec::new());
                used = 0.0;
            }
            used += wide;
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
        }
        Self { rows }
    }

    pub fn height(&self) -> f64 {
        self.rows.len() as f64 * ROW + 10.0
    }

    pub fn draw(&self, page: &mut Page, top: f64) -> Result<(), PlotError> {
        let mut texts = Vec::new();
        let mut poles = Vec::new();
        for (row, entries) in self.rows.iter().enumerate() {
            let mut x = LEFT;
            let middle = top + (row as f64 + 0.5) * ROW;
            for (symbol, text) in entries {
                let mut path = Path::default();
                match symbol {
                    Symbol::Shade(color) => {
                        let swatch = Rect { x, y: middle - 6.0, width: SAMPLE, height: 12.0 };
                        path.line(&swatch.corners(), true);
                        page.element(&path.element(&format!("fill=\"{color}\" stroke=\"#8A8A8A\" stroke-width=\"5\"")));
                    }
                    Symbol::Pole(sign) => poles.push((*sign, [x + SAMPLE / 2.0, middle])),
                    Symbol::Line(style) => {
                        path.line(&[[x, middle], [x + SAMPLE, middle]], false);
                        page.element(&path.element(&stroke(*style)));
                    }
                }
                texts.push((text, [x + SAMPLE + GAP, middle + 0.36 * SIZE]));
                x += SAMPLE + GAP + text_width(text, SIZE) + BETWEEN;
            }
        }
        page.paint(|canvas| {
            poles.iter().try_for_each(|(sign, at)| pole_marker(canvas, *sign, *at))?;
            texts.iter().try_for_each(|(text, at)| canvas.text(text, *at, SIZE, INK, Anchor::Start))
        })
    }
}
