//! The figures of docs/mathematics.md and docs/algorithms.md, from the curves and the list of accessible regions that the
//! program itself uses.

use std::error::Error;

use bifdiag_body::{Body, Frame};
use bifdiag_plot::Picture;

use crate::figure::{Figure, THEME};

mod curves;
mod ridges;
mod trees;

/// Draws a figure.
type Draw = fn() -> Result<Picture, Box<dyn Error>>;

/// Name of the file and what is drawn.
const THEOREMS: [(&str, Draw); 3] = [
    ("curves-cusp-and-pitchfork", || curves::draw(THEME)),
    ("trees-of-components", || Ok(trees::draw(THEME)?)),
    ("ridges-and-valleys", || ridges::draw(THEME)),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    THEOREMS.into_iter().map(|(stem, draw)| Figure { stem, draw: Box::new(draw) })
}

/// A body in its frame.
fn frame(moments: [&str; 3], center: [&str; 3]) -> Result<Frame, Box<dyn Error>> {
    Ok(Body::parse(&moments, &center)?.frame())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reading::picture_texts::{assert_texts_are_apart, texts};

    #[test]
    fn figures_of_theorems_can_be_read() {
        for ((stem, draw), wanted) in THEOREMS.into_iter().zip(["pitchfork", "disc, annulus", "valley"]) {
            let texts = texts(&draw().unwrap());
            assert!(texts.iter().any(|(text, _)| text.contains(wanted)), "{stem}");
            assert_texts_are_apart(&texts);
        }
    }
}
