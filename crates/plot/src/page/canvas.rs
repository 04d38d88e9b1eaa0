//! What pictures are drawn on: a thin layer over plotters' SVG backend with coordinates in tenths of a pixel, and elements
//! of SVG beside what plotters draws.
//!
//! plotters rounds every coordinate to an integer; drawing on a canvas ten times too large and scaling it down with a
//! `viewBox` leaves a tenth of a pixel. plotters knows no groups, titles, dashes and images; these are elements of their
//! own between what it draws.

use std::cell::RefCell;

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, PathElement, Polygon};
use plotters::prelude::{RGBColor, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoFont, ShapeStyle};

use super::error::PlotError;
use super::font;
use super::geometry::{Point, UNITS, length_units, to_units};
use super::ink::{Ink, PAPER};
use super::picture::{Heading, Picture, escaped};
use super::stripes::Stripes;
use super::theme::Theme;

/// A drawing area of plotters in canvas units.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// What goes wrong in plotters.
pub(crate) type Outcome = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Left end of the base line.
    Start,
    /// Middle of the base line.
    Middle,
    /// Right end of the base line.
    End,
}

/// Where a picture is drawn; all positions and sizes in pixels. The first failure is kept for the end, so that what draws
/// need not look for it.
pub struct Canvas {
    size: [f64; 2],
    theme: Theme,
    body: RefCell<String>,
    /// Patterns that areas refer to.
    stripes: RefCell<Vec<Stripes>>,
    outcome: RefCell<Result<(), PlotError>>,
}

/// Draws a picture of `size` pixels on the theme's paper.
///
/// # Errors
/// The first failure of the drawing library.
pub fn render(
    size: [f64; 2],
    heading: impl Into<Heading>,
    theme: Theme,
    paint: impl FnOnce(&Canvas),
) -> Result<Picture, PlotError> {
    let outcome = RefCell::new(font::register());
    let canvas = Canvas { size, theme, body: RefCell::default(), stripes: RefCell::default(), outcome };
    canvas.element(&format!("<rect width=\"100%\" height=\"100%\" {}/>", canvas.fill(PAPER)));
    paint(&canvas);
    canvas.outcome.replace(Ok(()))?;
    let mut elements = String::new();
    for (number, stripes) in canvas.stripes.borrow().iter().enumerate() {
        elements.push_str(&stripes.definition(number, |color| canvas.ground(color)));
    }
    elements.push_str(&canvas.body.borrow());
    Ok(Picture::from_canvas(&elements, size, &heading.into()))
}

/// A colour as SVG writes it.
fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// A position in canvas units.
fn position(point: &Point) -> (i32, i32) {
    (to_units(point[0]), to_units(point[1]))
}

fn positions(points: &[Point]) -> Vec<(i32, i32)> {
    let mut positions: Vec<(i32, i32)> = points.iter().map(position).collect();
    positions.dedup();
    positions
}

impl Canvas {
    /// Draws with plotters.
    pub fn plotters(&self, draw: impl FnOnce(&Area<'_>) -> Outcome) {
        let mut document = String::new();
        let outcome = {
            let units = (length_units(self.size[0]), length_units(self.size[1]));
            let area = SVGBackend::with_string(&mut document, units).into_drawing_area();
            draw(&area).and_then(|()| area.present())
        };
        self.keep(outcome.map_err(PlotError::from));
        // Between the tags of plotters' document stand its elements.
        let inner = document.split_once('>').map_or("", |(_, inner)| inner).trim_start();
        self.body.borrow_mut().push_str(inner.strip_suffix("</svg>\n").unwrap_or(inner));
    }

    /// Keeps the first failure.
    pub fn keep(&self, outcome: Result<(), PlotError>) {
        let mut first = self.outcome.borrow_mut();
        if first.is_ok() {
            *first = outcome;
        }
    }

    /// Adds an SVG element whose lengths are in canvas units.
    pub fn element(&self, element: &str) {
        let mut body = self.body.borrow_mut();
        body.push_str(element);
        body.push('\n');
    }

    /// Draws a group with an id of its own in the picture, and what is told when one points at it.
    pub fn group(&self, id: &str, title: &str, paint: impl FnOnce()) {
        let title = if title.is_empty() { String::new() } else { format!("<title>{}</title>", escaped(title)) };
        self.element(&format!("<g id=\"{}\">{title}", escaped(id)));
        paint();
        self.element("</g>");
    }

    /// A colour as the theme shows it.
    pub fn color(&self, color: RGBColor) -> RGBColor {
        self.theme.color(color)
    }

    /// The attributes of an area.
    pub fn fill(&self, color: RGBColor) -> String {
        format!("fill=\"{}\"", self.ground(color))
    }

    /// The colour of an area as SVG writes it.
    pub fn ground(&self, color: RGBColor) -> String {
        hex(self.theme.ground(color))
    }

    /// The attributes of a line.
    pub fn stroke(&self, ink: Ink) -> String {
        let width = (ink.width * UNITS).round();
        format!("fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"", hex(self.color(ink.color)))
    }

    /// The attributes of a striped area.
    pub(crate) fn stripes(&self, stripes: &Stripes) -> String {
        let mut known = self.stripes.borrow_mut();
        let number = known.iter().position(|other| other == stripes).unwrap_or_else(|| {
            known.push(stripes.clone());
            known.len() - 1
        });
        Stripes::fill(number)
    }

    /// An open polyline.
    pub fn path(&self, points: &[Point], ink: Ink) {
        let positions = positions(points);
        if positions.len() > 1 {
            self.plotters(|area| area.draw(&PathElement::new(positions, self.style(ink))));
        }
    }

    /// A filled polygon in the colour of a line.
    pub fn polygon(&self, points: &[Point], color: RGBColor) {
        self.filled(points, self.color(color));
    }

    /// A filled polygon in the colour of an area.
    pub fn patch(&self, points: &[Point], color: RGBColor) {
        self.filled(points, self.theme.ground(color));
    }

    fn filled(&self, points: &[Point], color: RGBColor) {
        let positions = positions(points);
        if positions.len() > 2 {
            self.plotters(|area| area.draw(&Polygon::new(positions, color.filled())));
        }
    }

    /// A closed outline.
    pub fn outline(&self, points: &[Point], ink: Ink) {
        let mut closed = points.to_vec();
        closed.extend(points.first());
        self.path(&closed, ink);
    }

    /// A filled disc in the colour of a line.
    pub fn disc(&self, center: Point, radius: f64, color: RGBColor) {
        self.dot(center, radius, self.color(color));
    }

    /// A filled disc in the colour of an area.
    pub fn spot(&self, center: Point, radius: f64, color: RGBColor) {
        self.dot(center, radius, self.theme.ground(color));
    }

    fn dot(&self, center: Point, radius: f64, color: RGBColor) {
        let disc = Circle::new(position(&center), length_units(radius), color.filled());
        self.plotters(|area| area.draw(&disc));
    }

    /// A circle, empty in the colour of the page.
    pub fn ring(&self, center: Point, radius: f64, ink: Ink) {
        self.disc(center, radius, PAPER);
        let circle = Circle::new(position(&center), length_units(radius), self.style(ink));
        self.plotters(|area| area.draw(&circle));
    }

    /// A line of text with its base line at `at`.
    pub fn text(&self, text: &str, at: Point, size: f64, color: RGBColor, anchor: Anchor) {
        let horizontal = match anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        // The backend's only shift in units of the font size alone: the base line lies 0.76 em below "top".
        let style = self.text_style(size, color).pos(Pos::new(horizontal, VPos::Top));
        self.plotters(|area| area.draw_text(text, &style, position(&[at[0], at[1] - 0.76 * size])));
    }

    /// plotters' style of text of `size` pixels.
    pub fn text_style(&self, size: f64, color: RGBColor) -> plotters::style::TextStyle<'static> {
        (font::FAMILY, size * UNITS * font::PLOTTERS_SCALE).into_font().color(&self.color(color))
    }

    /// plotters' style of a line.
    pub fn style(&self, ink: Ink) -> ShapeStyle {
        self.color(ink.color).stroke_width(length_units(ink.width))
    }
}
