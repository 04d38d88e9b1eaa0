//! The texts of a picture and whether they can be read.

use bifdiag_plot::Picture;

use super::picture_svg::{content, each_text, tree};

/// All texts with their boxes [left, top, right, bottom]; all on the page.
pub fn texts(picture: &Picture) -> Vec<(String, [f32; 4])> {
    let mut texts = Vec::new();
    let tree = tree(picture);
    each_text(tree.root(), &mut |text| {
        let area = text.abs_bounding_box();
        let is_inside = area.right() <= tree.size().width() && area.bottom() <= tree.size().height();
        assert!(area.left() >= 0.0 && area.top() >= 0.0 && is_inside, "`{}` leaves the page", content(text));
        texts.push((content(text), [area.left(), area.top(), area.right(), area.bottom()]));
    });
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
