//! PDF of one page from an SVG, as large as in print; only with the feature `pdf`.

use resvg::usvg::Tree;

use super::error::PlotError;

#[cfg(feature = "pdf")]
pub(crate) fn page(tree: &Tree) -> Result<Vec<u8>, PlotError> {
    use krilla::geom::Size;
    use krilla::page::PageSettings;
    use krilla_svg::{SurfaceExt, SvgSettings};

    use super::width::POINTS;

    let [width, height] = [tree.size().width(), tree.size().height()].map(|side| side * POINTS);
    let no_page = || PlotError::Page { width, height };
    let page_settings = PageSettings::from_wh(width, height).ok_or_else(no_page)?;
    let page_size = Size::from_wh(width, height).ok_or_else(no_page)?;
    let mut document = krilla::Document::new();
    let mut page = document.start_page_with(page_settings);
    let mut surface = page.surface();
    surface.draw_svg(tree, page_size, SvgSettings::default()).ok_or_else(no_page)?;
    surface.finish();
    page.finish();
    document.finish().map_err(|error| PlotError::Pdf(Box::new(error)))
}

#[cfg(not(feature = "pdf"))]
pub(crate) fn page(_: &Tree) -> Result<Vec<u8>, PlotError> {
    Err(PlotError::NoPdf)
}
