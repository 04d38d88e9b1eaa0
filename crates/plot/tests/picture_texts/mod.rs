//! The texts of a picture and whether they can be read.

use std::sync::Arc;

use plot::Picture;
use resvg::usvg::{Group, Node, Options, Tree, fontdb::Database};

/// All texts with their boxes [left, top, right, bottom].
pub fn texts(picture: &Picture) -> Vec<(String, [f32; 4])> {
    fn collect(group: &Group, texts: &mut Vec<(String, [f32; 4])>) {
        for node in group.children() {
            match node {
                Node::Group(group) => collect(group, texts),
                Node::Text(text) => {
                    let content: String = text.chunks().iter().map(|chunk| chunk.text().trim().to_owned()).collect();
                    let area = text.abs_bounding_box();
                    texts.push((content, [area.left(), area.top(), area.right(), area.bottom()]));
                }
                Node::Path(_) | Node::Image(_) => {}
            }
        }
    }
    let mut database = Database::new();
    database.load_font_data(include_bytes!("../../fonts/DejaVuSans.ttf").to_vec());
    let options = Options { fontdb: Arc::new(database), ..Options::default() };
    let tree = Tree::from_str(&picture.svg, &options).expect("the SVG is well-formed");
    let mut texts = Vec::new();
    collect(tree.root(), &mut texts);
    texts
}

/// No text covers another.
pub fn assert_texts_are_apart(texts: &[(String, [f32; 4])]) {
    for (i, (a, box_a)) in texts.iter().enumerate() {
        for (b, box_b) in &texts[..i] {
            // The boxes reach from ascender to descender; lines of one label may share that space.
            let slack = 0.3 * (box_a[3] - box_a[1]).min(box_b[3] - box_b[1]);
            let apart = box_a[2] <= box_b[0] + 1.0
                || box_b[2] <= box_a[0] + 1.0
                || box_a[3] <= box_b[1] + slack
                || box_b[3] <= box_a[1] + slack;
            assert!(apart, "`{a}` at {box_a:?} covers `{b}` at {box_b:?}");
        }
    }
}
