//! What a picture of U on the Poisson sphere shows, and its title.

use bifdiag_page::{Anchor, Canvas, INK, Rect, lines, text_width};
use bifdiag_schema::{ComponentDocument, RelativeEquilibriumDocument};

const TITLE_SIZE: f64 = 14.0;
/// Also for the text below a view.
pub(super) const CAPTION_SIZE: f64 = 12.5;
/// Base lines of the first line of each, where each has one, and the distance of further lines.
const FIRST: [f64; 2] = [26.0, 46.0];
const LINE: f64 = 18.0;

/// The accessible region U_hl = {γ ∈ S²: U_l(γ) ≤ h}.
pub struct SphereScene<'a> {
    /// Printed above: the body.
    pub title: &'a str,
    /// Printed below the title: (h, l) and the region.
    pub caption: &'a str,
    /// U_l(γ) − h at a unit vector.
    pub potential_above: &'a dyn Fn([f64; 3]) -> f64,
    /// r̂; `None` for r = 0.
    pub r_hat: Option<[f64; 3]>,
    /// The components of U_hl in canonical order.
    pub components: &'a [ComponentDocument],
    /// The place in `components` of the component to which an accessible point belongs, if it is known.
    pub component_of: &'a dyn Fn([f64; 3]) -> Option<usize>,
    /// The relative equilibria at this l, by rising h.
    pub equilibria: &'a [RelativeEquilibriumDocument],
    /// The unit vector about which circles of equilibria turn.
    pub axis: [f64; 3],
    /// The unit of periods and growth times; empty for a body of numbers.
    pub time_unit: &'a str,
    /// From where the first view is taken; `None`: from where most is seen.
    pub view: Option<[f64; 3]>,
}

/// Lines of text with their font sizes and base lines.
pub(super) struct Titles {
    left: f64,
    lines: Vec<(String, f64, f64)>,
    /// How much lower everything else is than under a single line.
    pub more: f64,
}

impl Titles {
    /// The title and the caption of a scene in lines of at most `width` pixels.
    pub(super) fn new(scene: &SphereScene<'_>, left: f64, width: f64) -> Self {
        let (titles, captions) = (lines(scene.title, TITLE_SIZE, width), lines(scene.caption, CAPTION_SIZE, width));
        let lower = LINE * (titles.len() - 1) as f64;
        let more = lower + LINE * (captions.len() - 1) as f64;
        let place = |texts: Vec<String>, size: f64, first: f64| {
            texts.into_iter().enumerate().map(move |(number, text)| (text, size, first + LINE * number as f64))
        };
        let captions = place(captions, CAPTION_SIZE, FIRST[1] + lower);
        Self { left, lines: place(titles, TITLE_SIZE, FIRST[0]).chain(captions).collect(), more }
    }

    pub(super) fn boxes(&self) -> impl Iterator<Item = Rect> {
        self.lines.iter().map(|(text, size, base)| {
            let width = text_width(text, *size);
            Rect { x: self.left, y: base - 14.0, width, height: 20.0 }
        })
    }

    pub(super) fn draw(&self, canvas: &Canvas) {
        for (text, size, base) in &self.lines {
            canvas.text(text, [self.left, *base], *size, INK, Anchor::Start);
        }
    }
}
