//! How large the letters of a picture are in print.

use plot::Picture;

use super::picture_svg::{content, each_text, tree};

/// Texts with letters of less than 6 pt where the picture takes both columns of a journal, 178 mm.
pub fn too_small(picture: &Picture) -> Vec<String> {
    const LEAST: f32 = 6.0;
    const COLUMNS: f32 = 178.0 / 25.4 * 72.0;
    let tree = tree(picture);
    let points = COLUMNS / tree.size().width();
    let mut found = Vec::new();
    each_text(tree.root(), &mut |text| {
        let sizes = text.chunks().iter().flat_map(|chunk| chunk.spans()).map(|span| span.font_size().get());
        let size = sizes.fold(f32::INFINITY, f32::min) * text.abs_transform().sx * points;
        if size < LEAST {
            found.push(format!("`{}` has letters of {size} pt", content(text)));
        }
    });
    found
}
