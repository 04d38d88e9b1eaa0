//! A thin layer over plotters' SVG backend with coordinates in tenths of a pixel.
//!
//! plotters rounds every coordinate to an integer; drawing on a canvas ten times too large and scaling it down with a
//! `viewBox` leaves a tenth of a pixel.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, PathElement, Polygon};
use plotters::prelude::{RGBColor, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoFont, ShapeStyle};

use super::error::PlotError;
use super::font;
use super::ink::{Ink, PAPER};
use super::picture::Picture;
use super::units::{Point, UNITS, length_units, to_units};

/// A drawing area of plotters in canvas units.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    /// Left end of the base line.
    Start,
    /// Middle of the base line.
    Middle,
    /// Right end of the base line.
    End,
}

/// Where a picture is drawn; all positions and sizes in pixels.
pub(super) struct Canvas<'a> {
    area: Area<'a>,
}

/// Draws a picture of `size` pixels on a white ground.
pub(super) fn render(
    size: [f64; 2],
    title: &str,
    paint: impl FnOnce(&Canvas<'_>) -> Result<(), PlotError>,
) -> Result<Picture, PlotError> {
    let mut page = Page::new(size);
    page.paint(|canvas| {
        canvas.area.fill(&PAPER)?;
        paint(canvas)
    })?;
    Ok(page.finish(title))
}

/// A picture in the making: layers of what plotters draws and of plain SVG, the lowest first.
pub(super) struct Page {
    size: [f64; 2],
    layers: String,
}

impl Page {
    /// An empty page of `size` pixels.
    pub(super) fn new(size: [f64; 2]) -> Self {
        Self { size, layers: String::new() }
    }

    /// Adds a layer.
    pub(super) fn paint(&mut self, paint: impl FnOnce(&Canvas<'_>) -> Result<(), PlotError>) -> Result<(), PlotError> {
        font::register()?;
        let mut body = String::new();
        {
            let units = (length_units(self.size[0]), length_units(self.size[1]));
            let area = SVGBackend::with_string(&mut body, units).into_drawing_area();
            let canvas = Canvas { area };
            paint(&canvas)?;
            canvas.area.present()?;
        }
        let inner = body.split_once('>').map_or("", |(_, inner)| inner);
        self.layers.push_str(inner.trim_start().strip_suffix("</svg>\n").unwrap_or(inner));
        Ok(())
    }

    /// Adds an SVG element whose lengths are in canvas units.
    pub(super) fn element(&mut self, element: &str) {
        self.layers.push_str(element);
        self.layers.push('\n');
    }

    /// The picture.
    pub(super) fn finish(self, title: &str) -> Picture {
        Picture::from_canvas(&self.layers, self.size, title)
    }
}

fn positions(points: &[Point]) -> Vec<(i32, i32)> {
    let mut positions: Vec<(i32, i32)> = points.iter().map(|p| (to_units(p[0]), to_units(p[1]))).collect();
    positions.dedup();
    positions
}

impl<'a> Canvas<'a> {
    /// The plotters area below, for axes.
    pub(super) fn area(&self) -> &Area<'a> {
        &self.area
    }

    /// An open polyline.
    pub(super) fn path(&self, points: &[Point], ink: Ink) -> Result<(), PlotError> {
        let positions = positions(points);
        if positions.len() > 1 {
            self.area.draw(&PathElement::new(positions, style(ink)))?;
        }
        Ok(())
    }

    /// A filled polygon.
    pub(super) fn polygon(&self, points: &[Point], color: RGBColor) -> Result<(), PlotError> {
        let positions = positions(points);
        if positions.len() > 2 {
            self.area.draw(&Polygon::new(positions, color.filled()))?;
        }
        Ok(())
    }

    /// A closed outline.
    pub(super) fn outline(&self, points: &[Point], ink: Ink) -> Result<(), PlotError> {
        let mut closed = points.to_vec();
        closed.extend(points.first());
        self.path(&closed, ink)
    }

    /// A filled disc.
    pub(super) fn disc(&self, center: Point, radius: f64, color: RGBColor) -> Result<(), PlotError> {
        let center = (to_units(center[0]), to_units(center[1]));
        self.area.draw(&Circle::new(center, length_units(radius), color.filled()))?;
        Ok(())
    }

    /// A circle, empty in the colour of the page.
    pub(super) fn ring(&self, center: Point, radius: f64, ink: Ink) -> Result<(), PlotError> {
        self.disc(center, radius, PAPER)?;
        let center = (to_units(center[0]), to_units(center[1]));
        self.area.draw(&Circle::new(center, length_units(radius), style(ink)))?;
        Ok(())
    }

    /// A line of text with its base line at `at`.
    pub(super) fn text(
        &self,
        text: &str,
        at: Point,
        size: f64,
        color: RGBColor,
        anchor: Anchor,
    ) -> Result<(), PlotError> {
        let horizontal = match anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        // The backend's only shift in units of the font size alone: the base line lies 0.76 em below "top".
        let style = text_style(size, color).pos(Pos::new(horizontal, VPos::Top));
        self.area.draw_text(text, &style, (to_units(at[0]), to_units(at[1] - 0.76 * size)))?;
        Ok(())
    }
}

/// plotters' style of text of `size` pixels.
pub(super) fn text_style(size: f64, color: RGBColor) -> plotters::style::TextStyle<'static> {
    (font::FAMILY, size * UNITS * font::PLOTTERS_SCALE).into_font().color(&color)
}

/// plotters' style of a line.
pub(super) fn style(ink: Ink) -> ShapeStyle {
    ink.color.stroke_width(length_units(ink.width))
}
