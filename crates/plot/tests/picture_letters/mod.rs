//! How large a picture and its letters are in print.

use bifdiag_plot::{Picture, Width};
use resvg::usvg::TextChunk;

use super::picture_svg::{PIXELS_PER_INCH, content, each_text, tree};

/// What does not fit a page: a picture higher than 230 mm (of a page wider than 178 mm, in proportion), and letters of less than 6 pt.
#[allow(clippy::cast_possible_truncation)]
pub fn unprintable(picture: &Picture, width: Width) -> Vec<String> {
    const LEAST: f32 = 6.0;
    let highest = 230.0 * (width.millimetres() as f32 / 178.0).max(1.0);
    let tree = tree(picture);
    let points = width.millimetres() as f32 / 25.4 * 72.0 / tree.size().width();
    let mut found = Vec::new();
    each_text(tree.root(), &mut |text| {
        let sizes = text.chunks().iter().flat_map(TextChunk::spans).map(|span| span.font_size().get());
        let size = sizes.fold(f32::INFINITY, f32::min) * text.abs_transform().sx * points;
        if size < LEAST {
            found.push(format!("`{}` has letters of {size} pt", content(text)));
        }
    });
    let height = tree.size().height() / PIXELS_PER_INCH * 25.4;
    if height > highest {
        found.push(format!("it is {height} mm high"));
    }
    found
}
