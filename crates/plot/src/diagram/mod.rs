//! The bifurcation diagram of an atlas.
//!
//! In the order in which the data flow: `scene` resolves the ids of the document, `trace` gives each curve as a polyline
//! fit for one window, `grid` is the coarse picture of a `panel` from which sizes and label places are read, `window` and
//! `insets` (with `closeup`) choose the panels, `layout` puts them on the page, `placement` finds room for the `labels`,
//! `paint` draws.

mod apart;
mod closeup;
mod grid;
mod insets;
mod labels;
mod layout;
mod legend;
mod markers;
mod motions;
mod notes;
mod outline;
mod paint;
mod palette;
mod panel;
mod placement;
mod plan;
mod ranges;
mod room;
mod scene;
mod stroke;
mod trace;
mod view;
mod window;

pub(crate) use palette::tint;
pub use scene::{CurveSource, MarkedPoints};

use crate::page::{Anchor, FAINT_INK, INK, Picture, PlotError, Point, Rect, Theme, Width, pattern, render, title_size};
use insets::{Magnifications, magnifications};
use layout::{BELOW, LEFT, RIGHT, TOP, below_all, frames, inset_place, legend_place, page_width};
use legend::{legend, paint_symbol};
use notes::{NOTE_SIZE, heading, notes, remark, units};
use paint::Diagram;
use palette::branch_styles;
use panel::Panel;
use plan::Plan;
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
    /// Points marked in place of the samples of the regions.
    pub points: Option<MarkedPoints>,
    /// Colours.
    pub theme: Theme,
    /// For what width the panels are laid out.
    pub width: Width,
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
    let plan = Plan::of(options.width);
    let scene = Scene::new(atlas, source, options.points.as_ref(), plan)?;
    let styles = branch_styles(atlas);
    let strokes = strokes(atlas, &styles);
    let (panels, mut magnified) = panels(&scene, options.window)?;
    let frames = frames(&panels);
    let mut texts = placement::place(&scene, &panels, &frames);
    // A region that a label points at is drawn, and one that a note tells is not in the key.
    let is_unlabelled = |region: &usize| !texts.labels.iter().flatten().any(|label| label.region == *region);
    magnified.invisible.retain(is_unlabelled);
    magnified.outside.retain(is_unlabelled);
    texts.key.retain(|(region, _)| !magnified.invisible.contains(region) && !magnified.outside.contains(region));

    let insets = panels.len() - 1;
    let width = page_width(plan, insets);
    let dots = options.points.as_ref().map_or("sample point of a region", |marked| marked.text.as_str());
    let explained = |width| legend(&scene, &styles, &strokes, &panels, &texts, dots, width);
    let place = |(at, width)| (at, width, explained(width));
    let (mut legend_at, room, mut legend) = place(legend_place(plan, insets));
    if legend.widest() > room {
        (legend_at, _, legend) = place(below_all(plan, insets));
    }
    let axes = panels.iter().map(|panel| panel.view.rect.bottom() + BELOW + 6.0);
    let motions_at = [LEFT, axes.fold(legend_at[1] + legend.height(), f64::max) + 6.0];
    let motions = motions::table(&scene, &strokes, &panels, options.width.pixels() - LEFT - RIGHT);
    let below = motions_at[1] + motions.height();
    let notes = notes(atlas, &magnified, width - LEFT - RIGHT);
    let page = width.max(LEFT + motions.width() + RIGHT).ceil();
    let height = below + notes.len() as f64 * NOTE_SIZE * 1.4 + 14.0;
    let heading = heading(atlas, width - LEFT - RIGHT, TITLE_SIZE);
    let title = heading.title.clone();
    let diagram = Diagram { scene, strokes, panels, frames, texts, units: units(atlas) };
    render([page, height.ceil()], heading, options.theme, |canvas| {
        let size = title_size(&title, TITLE_SIZE, page - LEFT);
        canvas.text(&title, [LEFT, 24.0], size, INK, Anchor::Start);
        canvas.text(remark(atlas), [LEFT + plan.main[0], TOP - plan.remark], NOTE_SIZE, FAINT_INK, Anchor::End);
        diagram.paint(canvas);
        canvas.group("legend", "", || legend.draw(canvas, legend_at, |symbol, at| paint_symbol(canvas, symbol, at)));
        canvas.group("motions", "", || {
            motions.draw(canvas, motions_at, |line, [x, y]| {
                pattern::draw(canvas, &[[x, y], [x + motions::SAMPLE, y]], line, stroke::WIDTH);
            });
        });
        for (row, note) in notes.iter().enumerate() {
            let base = below + (row as f64 + 1.0) * NOTE_SIZE * 1.4;
            canvas.text(note, [LEFT, base], NOTE_SIZE, FAINT_INK, Anchor::Start);
        }
    })
}

/// The main panel and its insets, and what could not be magnified.
fn panels(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<(Vec<Panel>, Magnifications), PlotError> {
    let view = |window, [x, y]: Point, [width, height]: [f64; 2]| View { window, rect: Rect { x, y, width, height } };
    let Windows { main, everything } = windows(scene, asked)?;
    let main = Panel::new(scene, view(main, [LEFT, TOP], scene.plan.main))?;
    let mut magnified = magnifications(scene, &main, &everything)?;
    if everything != main.view.window {
        // It takes the first place, so that what lies far out is seen in its frame.
        magnified.windows.insert(0, everything);
    }
    let mut panels = vec![main];
    for (index, window) in magnified.windows.iter().enumerate() {
        panels.push(Panel::new(scene, view(*window, inset_place(scene.plan, index), scene.plan.inset))?);
    }
    Ok((panels, magnified))
}
