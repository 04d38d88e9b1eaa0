//! How large the letters of a picture are in print.

use plot::{Picture, Width};
use resvg::usvg::TextChunk;

use super::picture_svg::{content, each_text, tree};

/// Texts with letters of less than 6 pt in print.
#[allow(clippy::cast_possible_truncation)]
pub fn too_small(picture: &Picture, width: Width) -> Vec<String> {
    const LEAST: f32 = 6.0;
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
    found
}
