//! Rows of a legend, and lines of a text.

use super::font::text_width;
use super::geometry::Point;

/// Entries in rows.
pub struct Rows {
    /// Top left corner of each entry, relative to that of the first.
    pub corners: Vec<Point>,
    /// Height of all rows.
    pub height: f64,
}

impl Rows {
    /// Entries of the given widths and heights with `between` pixels between neighbours, as many in each row as `width`
    /// holds; a row is as high as its highest entry.
    pub fn new(entries: impl IntoIterator<Item = [f64; 2]>, between: f64, width: f64) -> Self {
        let [mut x, mut y, mut high] = [0.0_f64; 3];
        let mut corners = Vec::new();
        for [wide, own] in entries {
            if x > 0.0 && x + wide > width {
                (x, y, high) = (0.0, y + high, 0.0);
            }
            corners.push([x, y]);
            x += wide + between;
            high = high.max(own);
        }
        Self { corners, height: y + high }
    }
}

/// A text in lines of at most `width` pixels, broken between words.
pub(crate) fn lines(text: &str, size: f64, width: f64) -> Vec<String> {
    if text_width(text, size) <= width {
        return vec![text.to_owned()];
    }
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
