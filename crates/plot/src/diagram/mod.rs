//! The bifurcation diagram of an atlas.
//!
//! In the order in which the data flow: `scene` resolves the ids of the document, `trace` gives each curve as a polyline
//! fit for one window, `grid` is the coarse picture of a `panel` from which sizes and label places are read, `window` and
//! `insets` (with `closeup`) choose the panels, `layout` puts them on the page, `placement` finds room for the `labels`,
//! `paint` draws, and `page` does all that for one of the plans of `plan`.

mod apart;
mod axes;
mod closeup;
mod grid;
mod insets;
mod labels;
mod layout;
mod legend;
mod markers;
mod motions;
mod notes;
mod options;
mod outline;
mod page;
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

pub use options::DiagramOptions;
pub(crate) use palette::tint;
pub use scene::{CurveSource, MarkedPoints};

use crate::page::{Picture, PlotError};
use bifdiag_schema::AtlasDocument;
use page::Page;
use plan::Plan;

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
    let mut plans = Plan::of(options.width).iter();
    let mut page = Page::new(atlas, source, options, plans.next().unwrap_or(&plan::PAGE))?;
    // The first plan is for few insets; of the others each has room for fewer and more for the key.
    let mut is_done = page.is_complete() && page.fits();
    while let Some(plan) = plans.next().filter(|_| !is_done) {
        page = Page::new(atlas, source, options, plan)?;
        is_done = page.fits();
    }
    page.draw(options.theme)
}
