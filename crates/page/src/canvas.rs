//! The SVG under construction: shapes and texts in pixels, written in tenths of a pixel as whole numbers. What plotters
//! draws, the axes of charts, comes through the same canvas, which is a backend of plotters.

use std::cell::RefCell;
use std::convert::Infallible;

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::style::text_anchor::{HPos, VPos};
use plotters::style::{Color, IntoFont, RGBColor, ShapeStyle, TextStyle};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};

use super::color::{Ink, PAPER, Theme, rgb};
use super::error::PlotError;
use super::formula::{Part, parts, stacked};
use super::geometry::{Point, UNITS, length_units, to_pixels, to_units};
use super::path::{Dash, Path, colors, intervals};
use super::picture::{FORMULA_CLASS, Heading, Picture, escaped};
use super::text::{self, FAMILY, FORMULAS};

/// Width of a stripe in pixels.
const STRIPE: f64 = 5.0;
/// A hatch: one line per this many stripes, and the width of each.
const HATCH: [RGBColor; 5] = [PAPER, PAPER, PAPER, PAPER, rgb(0x9c_9c_9c)];
const HATCH_LINE: f64 = 1.2;

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

impl Anchor {
    /// Which part of the text is before it.
    fn share(self) -> f64 {
        match self {
            Self::Start => 0.0,
            Self::Middle => 0.5,
            Self::End => 1.0,
        }
    }
}

/// Where a picture is drawn; all positions and sizes in pixels. The first failure is kept for the end, so that drawing code
/// need not handle it.
pub struct Canvas {
    size: [f64; 2],
    theme: Theme,
    body: RefCell<String>,
    /// Patterns that areas refer to: the colours of their stripes, and how wide each is.
    stripes: RefCell<Vec<(Vec<RGBColor>, f64)>>,
    outcome: RefCell<Result<(), PlotError>>,
}

/// Draws a picture of `size` pixels on the theme's paper.
///
/// # Errors
/// The first failure while drawing.
pub fn render(
    size: [f64; 2],
    heading: impl Into<Heading>,
    theme: Theme,
    paint: impl FnOnce(&Canvas),
) -> Result<Picture, PlotError> {
    let outcome = RefCell::new(text::register());
    let canvas = Canvas { size, theme, body: RefCell::default(), stripes: RefCell::default(), outcome };
    canvas.element(&format!("<rect width=\"100%\" height=\"100%\" {}/>", canvas.fill(PAPER)));
    paint(&canvas);
    canvas.outcome.replace(Ok(()))?;
    let patterns = canvas.stripes.borrow();
    let patterns = patterns.iter().enumerate().map(|(number, (colors, width))| canvas.pattern(number, colors, *width));
    let elements: String = patterns.chain([canvas.body.take()]).collect();
    Ok(Picture::new(&elements, size, &heading.into()))
}

/// A part of a text of this size as SVG: formulas in their own font, an index below its exponent.
fn set(part: &Part, size: f64) -> String {
    if !part.is_formula {
        return escaped(&part.text);
    }
    let span = |text: &str, rest: &str| format!("<tspan class=\"{FORMULA_CLASS}\"{rest}>{text}</tspan>");
    match stacked(&part.text) {
        None => span(&part.text, ""),
        Some([base, exponent, index]) => {
            let back = to_units(-text::width_in(FORMULAS, exponent, size));
            span(&format!("{base}{exponent}"), "") + &span(index, &format!(" dx=\"{back}\""))
        }
    }
}

/// A colour as SVG writes it.
#[must_use]
pub fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

impl Canvas {
    /// Draws with plotters.
    pub fn plotters(
        &self,
        draw: impl FnOnce(&DrawingArea<&Self, Shift>) -> Result<(), DrawingAreaErrorKind<Infallible>>,
    ) {
        self.keep(draw(&self.into_drawing_area()).map_err(PlotError::from));
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

    /// Draws a group with an id of its own in the picture, and a tooltip unless `title` is empty.
    pub fn group(&self, id: &str, title: &str, paint: impl FnOnce()) {
        let title = if title.is_empty() { String::new() } else { format!("<title>{}</title>", escaped(title)) };
        self.element(&format!("<g id=\"{}\">{title}", escaped(id)));
        paint();
        self.element("</g>");
    }

    /// The colour of a line or a text as the theme shows it.
    pub fn color(&self, color: RGBColor) -> RGBColor {
        self.theme.color(color)
    }

    /// The attributes of an area.
    pub fn fill(&self, color: RGBColor) -> String {
        format!("fill=\"{}\"", self.ground(color))
    }

    /// The attributes of an area in stripes of several colours; of one colour, without stripes.
    pub fn fill_striped(&self, colors: &[RGBColor]) -> String {
        if let [color] = colors {
            return self.fill(*color);
        }
        self.pattern_of(colors, STRIPE)
    }

    /// The attributes of an area outside the drawn set: paper with thin lines.
    pub fn fill_hatched(&self) -> String {
        self.pattern_of(&HATCH, HATCH_LINE)
    }

    fn pattern_of(&self, colors: &[RGBColor], width: f64) -> String {
        let mut known = self.stripes.borrow_mut();
        let number = known.iter().position(|other| other.0 == colors).unwrap_or_else(|| {
            known.push((colors.to_vec(), width));
            known.len() - 1
        });
        format!("fill=\"url(#stripes-{number})\"")
    }

    /// The pattern of a striped area as an SVG element.
    fn pattern(&self, number: usize, colors: &[RGBColor], width: f64) -> String {
        let width = width * UNITS;
        let period = width * colors.len() as f64;
        let stripe = |(place, color): (usize, &RGBColor)| {
            let (x, fill) = (width * place as f64, self.fill(*color));
            // A little over the edge, so that no seam shows.
            format!("<rect x=\"{x}\" width=\"{}\" height=\"{period}\" {fill}/>", width + 2.0)
        };
        let ground = format!("<rect width=\"{period}\" height=\"{period}\" {}/>", self.fill(colors[0]));
        let stripes: String = colors.iter().enumerate().map(stripe).collect();
        format!(
            "<defs><pattern id=\"stripes-{number}\" width=\"{period}\" height=\"{period}\" \
             patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(-45)\">{ground}{stripes}</pattern></defs>\n"
        )
    }

    /// The colour of an area as SVG writes it.
    pub fn ground(&self, color: RGBColor) -> String {
        hex(self.theme.ground(color))
    }

    /// The attributes of a line.
    pub fn stroke(&self, ink: Ink) -> String {
        let width = length_units(ink.width);
        format!("fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"", hex(self.color(ink.color)))
    }

    /// An open polyline.
    pub fn path(&self, points: &[Point], ink: Ink) {
        self.polyline(points, false, &self.stroke(ink));
    }

    /// A closed outline.
    pub fn outline(&self, points: &[Point], ink: Ink) {
        self.polyline(points, true, &self.stroke(ink));
    }

    /// A filled polygon in the colour of a line.
    pub fn polygon(&self, points: &[Point], color: RGBColor) {
        self.polyline(points, true, &format!("fill=\"{}\"", hex(self.color(color))));
    }

    /// A filled polygon in the colour of an area.
    pub fn patch(&self, points: &[Point], color: RGBColor) {
        self.polyline(points, true, &self.fill(color));
    }

    /// A path with these attributes, unless it is empty.
    pub fn draw(&self, path: &Path, attributes: &str) {
        if !path.data().is_empty() {
            self.element(&format!("<path d=\"{}\" {attributes}/>", path.data()));
        }
    }

    /// A path with these attributes and a tooltip.
    pub fn draw_titled(&self, path: &Path, attributes: &str, title: &str) {
        if !path.data().is_empty() {
            let (data, title) = (path.data(), escaped(title));
            self.element(&format!("<path d=\"{data}\" {attributes}><title>{title}</title></path>"));
        }
    }

    /// A polyline in a pattern of dashes.
    pub fn dashed(&self, points: &[Point], pattern: &[Dash], width: f64) {
        let mut path = Path::default();
        path.line(points, false);
        self.draw_dashed(&path, pattern, width);
    }

    /// A path in a pattern of dashes, which restarts with each of its lines.
    pub fn draw_dashed(&self, path: &Path, pattern: &[Dash], width: f64) {
        for color in colors(pattern) {
            let dashes = match &intervals(pattern, color)[..] {
                // Solid.
                [_] => String::new(),
                [offset, lengths @ ..] => {
                    let lengths: Vec<String> = lengths.iter().map(f64::to_string).collect();
                    let shift = if *offset > 0.0 { format!(" stroke-dashoffset=\"-{offset}\"") } else { String::new() };
                    format!(" stroke-dasharray=\"{}\"{shift}", lengths.join(" "))
                }
                [] => continue,
            };
            self.draw(path, &format!("{}{dashes}", self.stroke(Ink { color, width })));
        }
    }

    fn polyline(&self, points: &[Point], closed: bool, attributes: &str) {
        if points.len() > 1 {
            let mut path = Path::default();
            path.line(points, closed);
            self.draw(&path, attributes);
        }
    }

    /// A filled disc in the colour of a line.
    pub fn disc(&self, center: Point, radius: f64, color: RGBColor) {
        self.circle(center, radius, &format!("fill=\"{}\"", hex(self.color(color))));
    }

    /// A filled disc in the colour of an area.
    pub fn spot(&self, center: Point, radius: f64, color: RGBColor) {
        self.circle(center, radius, &self.fill(color));
    }

    /// A circle, empty in the colour of the page.
    pub fn ring(&self, center: Point, radius: f64, ink: Ink) {
        let stroke = self.stroke(ink).replacen("fill=\"none\"", &format!("fill=\"{}\"", hex(self.color(PAPER))), 1);
        self.circle(center, radius, &stroke);
    }

    fn circle(&self, center: Point, radius: f64, attributes: &str) {
        let [x, y] = center.map(to_units);
        self.element(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" {attributes}/>", length_units(radius)));
    }

    /// A line of text with its base line at `at`.
    pub fn text(&self, text: &str, at: Point, size: f64, color: RGBColor, anchor: Anchor) {
        self.write(text, at, size, &hex(self.color(color)), anchor);
    }

    fn write(&self, text: &str, at: Point, size: f64, fill: &str, anchor: Anchor) {
        if text.is_empty() {
            return;
        }
        let parts = parts(text);
        // If an index goes back below its exponent, some programs forget the way back when they centre the text.
        let (at, anchor) = if parts.iter().any(|part| part.is_formula && stacked(&part.text).is_some()) {
            ([at[0] - anchor.share() * text::text_width(text, size), at[1]], Anchor::Start)
        } else {
            (at, anchor)
        };
        let [x, y] = at.map(to_units);
        let text: String = parts.iter().map(|part| set(part, size)).collect();
        let size = (size * UNITS * 100.0).round() / 100.0;
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        self.element(&format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{fill}\"{anchor}>{text}</text>"));
    }

    /// plotters' style of text of `size` pixels.
    pub fn text_style(&self, size: f64, color: RGBColor) -> TextStyle<'static> {
        (FAMILY, size * UNITS).into_font().color(&self.color(color))
    }

    /// plotters' style of a line.
    pub fn style(&self, ink: Ink) -> ShapeStyle {
        Color::stroke_width(&self.color(ink.color), length_units(ink.width))
    }
}

/// plotters' coordinates are canvas units, its colours those of the theme.
impl DrawingBackend for &Canvas {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (length_units(self.size[0]), length_units(self.size[1]))
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Result<(), DrawingErrorKind<Infallible>> {
        let fill = hex(RGBColor(color.rgb.0, color.rgb.1, color.rgb.2));
        self.element(&format!("<rect x=\"{x}\" y=\"{y}\" width=\"1\" height=\"1\" fill=\"{fill}\"/>"));
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let points: Vec<Point> = path.into_iter().map(|(x, y)| [x, y].map(to_pixels)).collect();
        let (red, green, blue) = style.color().rgb;
        let (color, width) = (hex(RGBColor(red, green, blue)), style.stroke_width());
        self.polyline(&points, false, &format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\""));
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        (x, y): BackendCoord,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        // The base line below the point given, for digits of 0.73 em.
        let below = match style.anchor().v_pos {
            VPos::Top => 0.76,
            VPos::Center => 0.36,
            VPos::Bottom => 0.0,
        };
        let (red, green, blue) = style.color().rgb;
        let size = style.size() / UNITS;
        let at = [to_pixels(x), to_pixels(y) + below * size];
        self.write(text, at, size, &hex(RGBColor(red, green, blue)), anchor);
        Ok(())
    }
}
