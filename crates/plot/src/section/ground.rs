//! What a portrait says: the shaded areas, ∂U, the line of tangency and the poles.

use plotters::style::RGBColor;

use super::layout::SheetPanel;
use super::walls;

use crate::page::{Canvas, INK, Ink, Path, Point, Rect, rgb};
use bifdiag_dynamics::section::{Portrait, SectionChart};

/// Ground where Ṡ < 0 and where Ṡ > 0.
pub(super) const INCOMING: RGBColor = rgb(0xcd_d5_df);
pub(super) const OUTGOING: RGBColor = rgb(0xf1_ee_e6);
/// The line of tangency.
pub(super) const TANGENCY: Ink = Ink { color: rgb(0x6e_6e_6e), width: 1.1 };
/// ∂U.
pub(super) const BOUNDARY: Ink = Ink { color: INK, width: 1.2 };
/// An accessible polar circle.
pub(super) const POLAR: Ink = Ink { color: INK, width: 3.0 };

/// Shades the areas.
pub(super) fn shade(canvas: &Canvas, portrait: &Portrait, panel: &SheetPanel) {
    for (area, color) in
        [(portrait.accessible(panel.chart), OUTGOING), (portrait.incoming(panel.chart, panel.sheet), INCOMING)]
    {
        let path = walls::area(area.loops.iter().map(|polygon| panel.positions(polygon)));
        path.draw(canvas, &format!("{} fill-rule=\"evenodd\"", canvas.fill(color)));
    }
}

/// Draws the lines, the poles and the frame.
pub(super) fn outline(canvas: &Canvas, portrait: &Portrait, panel: &SheetPanel) {
    for (lines, ink) in [(portrait.tangency(panel.sheet), TANGENCY), (portrait.boundary(), BOUNDARY)] {
        let mut path = Path::default();
        for piece in lines.iter().flat_map(|line| portrait.in_chart(panel.chart, line)) {
            path.line(&panel.positions(&piece), false);
        }
        path.draw(canvas, &canvas.stroke(ink));
    }
    frame(&panel.rect).draw(canvas, &canvas.stroke(Ink { color: INK, width: 0.9 }));
    let poles: Vec<i8> = [1, -1].into_iter().filter(|&sign| portrait.has_pole(sign)).collect();
    match panel.chart {
        SectionChart::Torus => {
            let mut rims = Path::default();
            for sign in poles {
                let y = if sign > 0 { panel.rect.y } else { panel.rect.bottom() };
                rims.line(&[[panel.rect.x, y], [panel.rect.right(), y]], false);
            }
            rims.draw(canvas, &canvas.stroke(POLAR));
        }
        SectionChart::Sphere => {
            let [.., r_hat] = portrait.torus().axes();
            for sign in poles {
                let gamma = r_hat.map(|x| f64::from(sign) * x);
                let at = panel.position(portrait.position(SectionChart::Sphere, gamma));
                pole_marker(canvas, sign, at);
            }
        }
    }
}

/// The frame of a panel with its ticks.
fn frame(rect: &Rect) -> Path {
    let mut frame = Path::default();
    frame.line(&rect.corners(), true);
    for k in 0..=4 {
        let x = rect.x + 0.25 * f64::from(k) * rect.width;
        frame.line(&[[x, rect.bottom()], [x, rect.bottom() + 4.0]], false);
    }
    for k in 0..=2 {
        let y = rect.y + 0.5 * f64::from(k) * rect.height;
        frame.line(&[[rect.x - 4.0, y], [rect.x, y]], false);
    }
    frame
}

/// The mark of +r̂ (`sign` > 0) or −r̂ on a sphere.
pub(super) fn pole_marker(canvas: &Canvas, sign: i8, at: Point) {
    canvas.ring(at, 4.0, Ink { color: INK, width: 1.0 });
    if sign > 0 {
        canvas.disc(at, 1.2, INK);
    }
}
