//! How large the letters of a picture are in print.

use std::sync::Arc;

use plot::Picture;
use resvg::usvg::{Group, Node, Options, Tree, fontdb::Database};

/// Texts with letters of less than 6 pt where the picture takes both columns of a journal, 178 mm.
pub fn too_small(picture: &Picture) -> Vec<String> {
    const LEAST: f32 = 6.0;
    const COLUMNS: f32 = 178.0 / 25.4 * 72.0;
    fn collect(group: &Group, points: f32, found: &mut Vec<String>) {
        for node in group.children() {
            match node {
                Node::Group(group) => collect(group, points, found),
                Node::Text(text) => {
                    for chunk in text.chunks() {
                        let sizes = chunk.spans().iter().map(|span| span.font_size().get());
                        let size = sizes.fold(f32::INFINITY, f32::min) * text.abs_transform().sx * points;
                        if size < LEAST {
                            found.push(format!("`{}` has letters of {size} pt", chunk.text().trim()));
                        }
                    }
                }
                Node::Path(_) | Node::Image(_) => {}
            }
        }
    }
    let mut database = Database::new();
    database.load_font_data(include_bytes!("../../fonts/DejaVuSans.ttf").to_vec());
    let options = Options { fontdb: Arc::new(database), ..Options::default() };
    let tree = Tree::from_str(&picture.svg, &options).expect("the SVG is well-formed");
    let mut found = Vec::new();
    collect(tree.root(), COLUMNS / tree.size().width(), &mut found);
    found
}
