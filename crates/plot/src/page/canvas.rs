//! A thin layer over plotters' SVG backend with coordinates in tenths of a pixel.
//!
//! plotters rounds every coordinate to an integer; drawing on a canvas ten times too large and scaling it down with a
//! `viewBox` leaves a tenth of a pixel.

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
use super::picture::Picture;

/// A drawing area of plotters in canvas units.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// What goes wrong in plotters.
pub(crate) type Outcome = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// Left end of the base line.
    Start,
    /// Middle of the base line.
    Middle,
    /// Right end of the base line.
    End,
}

/// Where a picture is drawn; all positions and sizes in pixels. The first failure is kept for the end, so that what draws
/// need not look for it.
pub(crate) struct Canvas<'a> {
    area: Area<'a>,
    outcome: RefCell<Outcome>,
}

/// Draws a picture of `size` pixels on a white ground.
pub(crate) fn render(size: [f64; 2], title: &str, paint: impl FnOnce(&Canvas<'_>)) -> Result<Picture, PlotError> {
    let mut page = Page::new(size);
    page.paint(|canvas| {
        canvas.keep(canvas.area.fill(&PAPER));
        paint(canvas);
    });
    page.finish(title)
}

/// A picture in the making: layers of what plotters draws and of plain SVG, the lowest first.
pub(crate) struct Page {
    size: [f64; 2],
    layers: String,
    outcome: Result<(), PlotError>,
}

impl Page {
    /// An empty page of `size` pixels.
    pub(crate) fn new(size: [f64; 2]) -> Self {
        Self { size, layers: String::new(), outcome: font::register() }
    }

    /// Adds a layer.
    pub(crate) fn paint(&mut self, paint: impl FnOnce(&Canvas<'_>)) {
        let mut body = String::new();
        {
            let units = (length_units(self.size[0]), length_units(self.size[1]));
            let area = SVGBackend::with_string(&mut body, units).into_drawing_area();
            let canvas = Canvas { area, outcome: RefCell::new(Ok(())) };
            paint(&canvas);
            canvas.keep(canvas.area.present());
            if self.outcome.is_ok() {
                self.outcome = canvas.outcome.into_inner().map_err(PlotError::from);
            }
        }
        let inner = body.split_once('>').map_or("", |(_, inner)| inner);
        self.layers.push_str(inner.trim_start().strip_suffix("</svg>\n").unwrap_or(inner));
    }

    /// Adds an SVG element whose lengths are in canvas units.
    pub(crate) fn element(&mut self, element: &str) {
        self.layers.push_str(element);
        self.layers.push('\n');
    }

    /// The picture, or the first failure.
    pub(crate) fn finish(self, title: &str) -> Result<Picture, PlotError> {
        self.outcome.map(|()| Picture::from_canvas(&self.layers, self.size, title))
    }
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

impl<'a> Canvas<'a> {
    /// The plotters area below, for axes.
    pub(crate) fn area(&self) -> &Area<'a> {
        &self.area
    }

    /// Keeps the first failure.
    pub(crate) fn keep(&self, outcome: Outcome) {
        let mut first = self.outcome.borrow_mut();
        if first.is_ok() {
            *first = outcome;
        }
    }

    /// An open polyline.
    pub(crate) fn path(&self, points: &[Point], ink: Ink) {
        let positions = positions(points);
        if positions.len() > 1 {
            self.keep(self.area.draw(&PathElement::new(positions, style(ink))));
        }
    }

    /// A filled polygon.
    pub(crate) fn polygon(&self, points: &[Point], color: RGBColor) {
        let positions = positions(points);
        if positions.len() > 2 {
            self.keep(self.area.draw(&Polygon::new(positions, color.filled())));
        }
    }

    /// A closed outline.
    pub(crate) fn outline(&self, points: &[Point], ink: Ink) {
        let mut closed = points.to_vec();
        closed.extend(points.first());
        self.path(&closed, ink);
    }

    /// A filled disc.
    pub(crate) fn disc(&self, center: Point, radius: f64, color: RGBColor) {
        self.keep(self.area.draw(&Circle::new(position(&center), length_units(radius), color.filled())));
    }

    /// A circle, empty in the colour of the page.
    pub(crate) fn ring(&self, center: Point, radius: f64, ink: Ink) {
        self.disc(center, radius, PAPER);
        self.keep(self.area.draw(&Circle::new(position(&center), length_units(radius), style(ink))));
    }

    /// A line of text with its base line at `at`.
    pub(crate) fn text(&self, text: &str, at: Point, size: f64, color: RGBColor, anchor: Anchor) {
        let horizontal = match anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        // The backend's only shift in units of the font size alone: the base line lies 0.76 em below "top".
        let style = text_style(size, color).pos(Pos::new(horizontal, VPos::Top));
        self.keep(self.area.draw_text(text, &style, position(&[at[0], at[1] - 0.76 * size])));
    }
}

/// plotters' style of text of `size` pixels.
pub(crate) fn text_style(size: f64, color: RGBColor) -> plotters::style::TextStyle<'static> {
    (font::FAMILY, size * UNITS * font::PLOTTERS_SCALE).into_font().color(&color)
}

/// plotters' style of a line.
pub(crate) fn style(ink: Ink) -> ShapeStyle {
    ink.color.stroke_width(length_units(ink.width))
}
