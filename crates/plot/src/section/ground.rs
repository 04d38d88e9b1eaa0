//! What a portrait says: the shaded areas, ∂U, the line of tangency and the poles.

use super::super::PlotError;
use super::super::canvas::{Canvas, Ink, Page, Point, UNITS};
use super::super::palette::{INK, PAPER};
use super::layout::SheetPanel;
use super::path::Path;
use dynamics::section::{Area, Chart, Portrait};

/// Ground where Ṡ < 0 and where Ṡ > 0.
pub(super) const INCOMING: &str = "#CDD5DF";
pub(super) const OUTGOING: &str = "#F1EEE6";
/// The line of tangency, and its width in pixels.
pub(super) const TANGENCY: (&str, f64) = ("#6E6E6E", 1.1);
/// ∂U.
pub(super) const BOUNDARY: (&str, f64) = ("#222222", 1.2);
/// An accessible polar circle.
pub(super) const POLAR: (&str, f64) = ("#222222", 3.0);

/// The attributes of a line.
pub(super) fn stroke((color, width): (&str, f64)) -> String {
    format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{}\"", width * UNITS)
}

/// Shades the areas.
pub(super) fn shade(page: &mut Page, portrait: &Portrait, panel: &SheetPanel) {
    for (area, color) in
        [(portrait.accessible(panel.chart), OUTGOING), (portrait.incoming(panel.chart, panel.sheet), INCOMING)]
    {
        let path = outline_of(&area, panel);
        if !path.is_empty() {
            page.element(&path.element(&format!("fill=\"{color}\" fill-rule=\"evenodd\"")));
        }
    }
}

fn outline_of(area: &Area, panel: &SheetPanel) -> Path {
    let mut path = Path::default();
    for polygon in &area.loops {
        path.line(&panel.positions(polygon), true);
    }
    path
}

/// Draws the lines, the poles and the frame.
pub(super) fn outline(page: &mut Page, portrait: &Portrait, panel: &SheetPanel) -> Result<(), PlotError> {
    for (lines, style) in [(portrait.tangency(panel.sheet), TANGENCY), (portrait.boundary(), BOUNDARY)] {
        let mut path = Path::default();
        for piece in lines.iter().flat_map(|line| portrait.in_chart(panel.chart, line)) {
            path.line(&panel.positions(&piece), false);
        }
        if !path.is_empty() {
            page.element(&path.element(&stroke(style)));
        }
    }
    let rect = panel.rect;
    let mut frame = Path::default();
    frame.line(&rect.corners(), true);
    for k in 0..=4 {
        let x = rect.x + 0.25 * f64::from(k) * rect.width;
        frame.line(&[[x, rect.y + rect.height], [x, rect.y + rect.height + 4.0]], false);
    }
    for k in 0..=2 {
        let y = rect.y + 0.5 * f64::from(k) * rect.height;
        frame.line(&[[rect.x - 4.0, y], [rect.x, y]], false);
    }
    page.element(&frame.element(&stroke(("#222222", 0.9))));
    let poles: Vec<i8> = [1, -1].into_iter().filter(|&sign| portrait.has_pole(sign)).collect();
    match panel.chart {
        Chart::Torus => {
            let mut rims = Path::default();
            for sign in poles {
                let y = if sign > 0 { rect.y } else { rect.y + rect.height };
                rims.line(&[[rect.x, y], [rect.x + rect.width, y]], false);
            }
            if !rims.is_empty() {
                page.element(&rims.element(&stroke(POLAR)));
            }
            Ok(())
        }
        Chart::Sphere => page.paint(|canvas| {
            let [.., r_hat] = portrait.torus().axes();
            for sign in poles {
                let gamma = r_hat.map(|x| f64::from(sign) * x);
                let at = panel.position(portrait.position(Chart::Sphere, gamma));
                pole_marker(canvas, sign, at)?;
            }
            Ok(())
        }),
    }
}

/// The mark of +r̂ (`sign` > 0) or −r̂ on a sphere.
pub(super) fn pole_marker(canvas: &Canvas<'_>, sign: i8, at: Point) -> Result<(), PlotError> {
    canvas.disc(at, 4.0, PAPER)?;
    canvas.circle(at, 4.0, Ink { color: INK, width: 1.0 })?;
    if sign > 0 { canvas.disc(at, 1.2, INK) } else { Ok(()) }
}
