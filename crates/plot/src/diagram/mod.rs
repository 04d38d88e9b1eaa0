//! The bifurcation diagram of an atlas.
//!
//! In the order in which the data flow: `scene` resolves the ids of the document, `trace` gives each curve as a polyline
//! fit for one window, `straight` the straightened plane, `panel` the regions of its pixels, from which sizes and label places are read, `insets` (with
//! `closeup`) chooses the panels, `layout` puts them on the page, `placement` finds room for the `labels`, `paint` draws, and
//! `page` does all that for one of the plans of `plan`.

mod axes;
mod closeup;
mod described;
mod insets;
mod labels;
mod layout;
mod legend;
mod notes;
mod page;
mod paint;
mod palette;
mod panel;
mod placement;
mod plan;
mod scene;
mod straight;
mod straight_panel;
mod straightened;
mod stroke;
mod trace;
mod windows;

pub use described::{DashPattern, DiagramDescription, DiagramLabel, DiagramStroke, DiagramSymbol};
pub use scene::{CurveSource, DiagramOptions, DiagramTitle, DiagramView, LegendPlace, MarkedPoints};
pub use straight::{LabelBoxes, StraightColumn, StraightShares};
pub use straight_panel::{PanelTicks, StraightPanel};
pub use straightened::StraightDiagram;

use bifdiag_page::{FAINT_INK, Figure, INK, PAPER, Picture, PlotError, png};
use bifdiag_schema::{AtlasDocument, WindowDocument};
use page::Page;
use palette::tint;
use plan::Plan;

/// A plane with more insets than these is better straightened.
const INSETS: usize = 2;

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
    draw_figure(atlas, source, options).map(|figure| figure.picture)
}

/// Draws the diagram, as [`draw`] does, with what is said beside it: the legend where that has left the picture, and texts for
/// a caption.
///
/// # Errors
/// As those of [`draw`].
pub fn draw_figure(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<Figure, PlotError> {
    chosen(atlas, source, options)?.0.draw(options.theme)
}

/// Where everything lies in the straightened plane, for those who draw it themselves.
///
/// # Errors
/// As those of [`draw`], and [`PlotError::NotStraight`] for a document that does not say which curves lie above each
/// other.
pub fn straight_diagram(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<StraightDiagram, PlotError> {
    let plan = Plan::straight(options.width, options.title != DiagramTitle::None);
    StraightDiagram::new(Page::new(atlas, source, options, plan)?, options.theme)
}

/// What [`draw`] draws, for those who draw it themselves.
///
/// # Errors
/// As those of [`draw`].
pub fn describe(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<DiagramDescription, PlotError> {
    Ok(DiagramDescription::of(&chosen(atlas, source, options)?.0, options.theme))
}

/// What is drawn in one panel of a given size in pixels, without insets.
///
/// # Errors
/// As those of [`draw`].
pub fn describe_panel(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    window: WindowDocument,
    size: [f64; 2],
    options: &DiagramOptions,
) -> Result<DiagramDescription, PlotError> {
    let options = DiagramOptions { window: Some(window), ..options.clone() };
    Ok(DiagramDescription::of(&Page::new(atlas, source, &options, Plan::panel(size))?, options.theme))
}

/// The view that [`draw`] chooses: [`DiagramView::Plane`] or [`DiagramView::Straight`].
///
/// # Errors
/// As those of [`draw`].
pub fn chosen_view(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<DiagramView, PlotError> {
    chosen(atlas, source, options).map(|(_, view)| view)
}

/// The page that is drawn, and its view.
fn chosen<'a>(
    atlas: &'a AtlasDocument,
    source: Option<&'a dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<(Page<'a>, DiagramView), PlotError> {
    let (width, has_title) = (options.width, options.title != DiagramTitle::None);
    let page = |plan| Page::new(atlas, source, options, plan);
    let straight = || page(Plan::straight(width, has_title));
    if options.view == DiagramView::Straight {
        return Ok((straight()?, DiagramView::Straight));
    }
    let mut plans = Plan::of(width, has_title);
    let Some(first) = plans.next() else { return Ok((straight()?, DiagramView::Straight)) };
    let mut drawn = page(first)?;
    let (insets, is_crowded) = drawn.insets();
    if insets == 0 && first.beside > 0 {
        drawn = page(first.without_insets(width))?;
    }
    let is_free = options.view == DiagramView::Auto && options.window.is_none() && atlas.window.is_none();
    let better = |is_poor: bool| match (is_free && is_poor).then(straight) {
        None | Some(Err(PlotError::NotStraight)) => Ok(None),
        Some(straight) => straight.map(Some),
    };
    if let Some(straight) = better(insets > INSETS || is_crowded)? {
        return Ok((straight, DiagramView::Straight));
    }
    // The first plan is for few insets; of the others each has room for fewer and more for the key.
    let mut is_done = drawn.is_complete() && drawn.fits();
    while let Some(plan) = plans.next().filter(|_| !is_done) {
        drawn = page(plan)?;
        is_done = drawn.fits();
    }
    Ok(match better(!drawn.fits())? {
        Some(straight) => (straight, DiagramView::Straight),
        None => (drawn, DiagramView::Plane),
    })
}

/// The image of a grid: rows of `width` codes from below, each the number of a region (whose sections are `kinds`), or
/// negative: forbidden (transparent), critical (black), undecided (grey). Equal arguments give equal bytes.
///
/// # Errors
/// [`PlotError`] when the image cannot be written.
pub fn draw_codes(width: usize, codes: &[i32], kinds: &[String]) -> Result<Vec<u8>, PlotError> {
    /// Colours that are no regions.
    const OTHERS: usize = 3;
    let regions = kinds.iter().take(usize::from(u8::MAX) + 1 - OTHERS).map(|kind| tint(kind));
    let colors: Vec<u8> =
        [PAPER, INK, FAINT_INK].into_iter().chain(regions).flat_map(|color| [color.0, color.1, color.2]).collect();
    let index = |code: i32| match code {
        -1 => 0,
        -2 => 1,
        // More regions than a palette holds share its last colour.
        code => usize::try_from(code).map_or(2_u8, |region| u8::try_from(OTHERS + region).unwrap_or(u8::MAX)),
    };
    let pixels: Vec<u8> = codes.chunks(width.max(1)).rev().flatten().map(|&code| index(code)).collect();
    let size = [width, codes.len() / width.max(1)].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    png(size, Some(colors), &pixels, None)
}
