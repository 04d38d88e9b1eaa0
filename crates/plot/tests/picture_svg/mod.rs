//! The SVG of a picture, read with the fonts of all pictures.

use std::sync::{Arc, OnceLock};

use bifdiag_plot::Picture;
use resvg::usvg::{Group, Node, Options, Text, Tree, fontdb::Database};

/// Pixels of the layout in an inch of print.
pub const PIXELS_PER_INCH: f32 = 25.4 * 924.0 / 178.0;

/// The elements of a picture, in pixels of the layout.
pub fn tree(picture: &Picture) -> Tree {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let fontdb = Arc::clone(FONTS.get_or_init(|| {
        let mut database = Database::new();
        database.load_font_data(include_bytes!("../../../page/fonts/DejaVuSans.ttf").to_vec());
        database.load_font_data(include_bytes!("../../../page/fonts/Math.otf").to_vec());
        Arc::new(database)
    }));
    let options = Options { dpi: PIXELS_PER_INCH, fontdb, ..Options::default() };
    Tree::from_str(&picture.svg, &options).expect("the SVG is well-formed")
}

/// Calls `visit` with every text of a group, in the order in which they are drawn.
pub fn each_text(group: &Group, visit: &mut impl FnMut(&Text)) {
    for node in group.children() {
        match node {
            Node::Group(group) => each_text(group, visit),
            Node::Text(text) => visit(text),
            Node::Path(_) | Node::Image(_) => {}
        }
    }
}

/// What a text says.
pub fn content(text: &Text) -> String {
    text.chunks().iter().map(|chunk| chunk.text().trim()).collect()
}
