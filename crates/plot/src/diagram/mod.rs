//! The bifurcation diagram of an atlas.
//!
//! In the order in which the data flow: `scene` resolves the ids of the document, `trace` gives each curve as a polyline
//! fit for one window, `grid` is the coarse picture of a `panel` from which sizes and label places are read, `window` and
//! `insets` (with `closeup`) choose the panels, `layout` puts them on the page, `placement` finds room for the `labels`,
//! `paint` draws.

mod closeup;
mod grid;
mod insets;
mod labels;
mod layout;
mod legend;
mod markers;
mod notes;
mod paint;
mod palette;
mod panel;
mod placement;
mod ranges;
mod scene;
mod space;
mod stroke;
mod trace;
mod view;
mod window;

pub(crate) use palette::tint;
pub use scene::CurveSource;

use crate::page::{Anchor, FAINT_INK, INK, Picture, PlotError, Point, Rect, render};
use insets::{Magnifications, magnifications};
use layout::{BELOW, INSET, LEFT, MAIN, RIGHT, TOP, frames, inset_place};
use legend::{legend, paint_symbol};
use notes::{NOTE_SIZE, notes, title};
use paint::Diagram;
use palette::branch_styles;
use panel::Panel;
use placement::place;
use scene::Scene;
use schema::{AtlasDocument, WindowDocument};
use stroke::strokes;
use view::View;
use window::{Windows, windows};

const TITLE_SIZE: f64 = 14.0;

/// How a diagram is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DiagramOptions {
    /// The part of the (h, l) plane of the main panel; `None`: chosen so that every event and every unbounded region
    /// is inside.
    pub window: Option<WindowDocument>,
}

/// Draws the bifurcation diagram: h to the right, l upwards, each region tinted and labelled with the type of its
/// section, and magnified insets for what the main panel is too coarse for.
///
/// `source` gives polylines fit for strong magnification; without it the document's own are used, and insets are as
/// sharp as they are. Equal arguments give equal bytes.
///
/// # Errors
/// [`PlotError`]: a document whose parts do not fit together, an empty window, or a failure of the drawing library.
pub fn draw(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<Picture, PlotError> {
    let scene = Scene::new(atlas, source)?;
    let styles = branch_styles(atlas);
    let (panels, magnified) = panels(&scene, options.window)?;
    let frames = frames(&panels);
    let texts = place(&scene, &panels, &frames);

    let farthest = |end: fn(&Rect) -> f64| panels.iter().map(|panel| end(&panel.view.rect)).fold(0.0, f64::max);
    let width = farthest(Rect::right) + RIGHT;
    let below = farthest(Rect::bottom) + BELOW + 6.0;
    let legend = legend(atlas, &styles, width - LEFT - RIGHT);
    let notes = notes(atlas, &magnified, &texts.unlabelled, width - LEFT - RIGHT);
    let notes_from = below + legend.height();
    let height = notes_from + notes.len() as f64 * NOTE_SIZE * 1.4 + 14.0;
    let title = title(atlas);
    let diagram = Diagram { scene, strokes: strokes(atlas, &styles), panels, frames, texts };
    render([width, height.ceil()], &title, |canvas| {
        canvas.text(&title, [LEFT, TOP - 34.0], TITLE_SIZE, INK, Anchor::Start);
        diagram.paint(canvas);
        legend.draw(canvas, [LEFT, below], |symbol, at| paint_symbol(canvas, symbol, at));
        for (row, note) in notes.iter().enumerate() {
            let base = notes_from + (row as f64 + 1.0) * NOTE_SIZE * 1.4;
            canvas.text(note, [LEFT, base], NOTE_SIZE, FAINT_INK, Anchor::Start);
        }
    })
}

/// The main panel and its insets, and what could not be magnified.
fn panels(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<(Vec<Panel>, Magnifications), PlotError> {
    let view = |window, [x, y]: Point, [width, height]: [f64; 2]| View { window, rect: Rect { x, y, width, height } };
    let Windows { main, everything } = windows(scene, asked)?;
    let main = Panel::new(scene, view(main, [LEFT, TOP], MAIN))?;
    let mut magnified = magnifications(scene, &main, &everything)?;
    if everything != main.view.window {
        // It takes the first place, so that what lies far out is seen in its frame.
        magnified.windows.insert(0, everything);
    }
    let mut panels = vec![main];
    for (index, window) in magnified.windows.iter().enumerate() {
        panels.push(Panel::new(scene, view(*window, inset_place(index), INSET))?);
    }
    Ok((panels, magnified))
}
