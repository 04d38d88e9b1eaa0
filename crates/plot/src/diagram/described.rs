//! A diagram as numbers and colours, for those who draw it with their own means: lines, grounds, labels and legend are
//! those of the page of the picture.

use plotters::style::RGBColor;

use super::labels::Label;
use super::page::Page;
use super::paint::Diagram;
use super::palette::ground_of;
use super::stroke::{turn_of, width};
use bifdiag_page::{Dash, INK, PAPER, Point, Symbol, Theme, hex};
use bifdiag_schema::WindowDocument;

/// Lengths in pixels, each with its colour `#RRGGBB` or empty, alternating; for a solid line a single one, of any
/// length.
pub type DashPattern = Vec<(Option<String>, f64)>;

/// A stretch of a curve, or of several coincident ones.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramStroke {
    /// The number of the curve in the document that gives the points.
    pub curve: usize,
    /// From this l to that; the upper end may be infinite.
    pub l: [f64; 2],
    /// Its width in pixels.
    pub width: f64,
    /// For each curve with its own look, its number and its part of the pattern, drawn on top of each other.
    pub lines: Vec<(usize, DashPattern)>,
}

/// The label of a region.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramLabel {
    /// The number of the region in the document.
    pub region: usize,
    /// Two lines, the second may be empty.
    pub lines: [String; 2],
    /// Size of the letters of the first, in pixels.
    pub size: f64,
    /// Its middle.
    pub at: Point,
    /// Where its leader points, if it is beside its region.
    pub tip: Option<Point>,
}

/// What an entry of a legend shows.
#[derive(Clone, Debug, PartialEq)]
pub enum DiagramSymbol {
    /// An area in one colour, or in stripes of several.
    Ground(Vec<String>),
    /// A line of this pattern and width.
    Line(DashPattern, f64),
    /// A mark, by the name of its shape.
    Mark(&'static str),
}

/// What is drawn, with the colours of a theme.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramDescription {
    /// The title.
    pub title: String,
    /// The part of the plane that each panel shows, that of the main panel first.
    pub windows: Vec<WindowDocument>,
    /// For each region its fill colour, or those of its stripes.
    pub grounds: Vec<Vec<String>>,
    /// The lines, in the order in which they are drawn.
    pub strokes: Vec<DiagramStroke>,
    /// The labels of each panel: at [h, l], or in the unit square of the straightened plane.
    pub labels: Vec<Vec<DiagramLabel>>,
    /// What the symbols mean.
    pub legend: Vec<(DiagramSymbol, String)>,
    /// Colours of text and of the page.
    pub ink: String,
    /// The ground of the page.
    pub paper: String,
}

impl DiagramDescription {
    /// Of a page.
    pub(super) fn of(page: &Page<'_>, theme: Theme) -> Self {
        let Diagram { scene, strokes, panels, texts, .. } = page.diagram();
        let strokes = strokes.iter().map(|stroke| DiagramStroke {
            curve: stroke.curve,
            l: stroke.l,
            width: width(&stroke.lines),
            lines: (0..stroke.lines.len())
                .map(|own| (stroke.lines[own].curve, dash_pattern(&turn_of(&stroke.lines, own), theme)))
                .collect(),
        });
        let labels = panels.iter().zip(&texts.labels).map(|(panel, labels)| {
            let label = |label: &Label| DiagramLabel {
                region: label.region,
                lines: label.setting.texts(&texts.names[label.region]),
                size: label.setting.size,
                at: panel.point(label.rect.center()),
                tip: label.leader.map(|[tip, _]| panel.point(tip)),
            };
            labels.iter().map(label).collect()
        });
        let grounds = |colors: &[RGBColor]| colors.iter().map(|color| hex(theme.ground(*color))).collect();
        let symbol = |(symbol, text): (&Symbol, String)| {
            let symbol = match symbol {
                Symbol::Swatch(colors) => DiagramSymbol::Ground(grounds(colors)),
                Symbol::Line(pattern, width) => DiagramSymbol::Line(dash_pattern(pattern, theme), *width),
                Symbol::Mark(shape, _) => DiagramSymbol::Mark(shape),
                Symbol::None | Symbol::Dots(_) => return None,
            };
            Some((symbol, text))
        };
        Self {
            title: page.title().to_owned(),
            windows: panels.iter().map(|panel| panel.view.window).collect(),
            grounds: scene.atlas.regions.iter().map(|region| grounds(&ground_of(region))).collect(),
            strokes: strokes.collect(),
            labels: labels.collect(),
            legend: page.legend().entries().filter_map(symbol).collect(),
            ink: hex(theme.color(INK)),
            paper: hex(theme.color(PAPER)),
        }
    }
}

fn dash_pattern(pattern: &[Dash], theme: Theme) -> DashPattern {
    pattern.iter().map(|(color, length)| (color.map(|color| hex(theme.color(color))), *length)).collect()
}
