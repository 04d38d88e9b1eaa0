//! Manifolds of periodic orbits or equilibria over a section.

use plotters::style::RGBColor;

use super::layout::SheetPanel;
use super::scene::{SectionCurves, SectionScene};
use bifdiag_dynamics::section::{Portrait, SectionLine};
use bifdiag_page::{Canvas, INK, Ink, PAPER, Path, Point, Symbol, rgb};

/// Of motions that leave.
const UNSTABLE: Ink = Ink { color: rgb(0xc8_30_00), width: 0.9 };
/// Of motions that come to them.
const STABLE: Ink = Ink { color: rgb(0x0b_4f_b0), width: 0.9 };
/// A connection.
const RING: Ink = Ink { color: INK, width: 0.8 };
const CONNECTION: RGBColor = PAPER;
/// Radius of a point of a motion.
const DOT: f64 = 1.3;

/// Draws what lies on the sheet of a panel.
pub(super) fn draw(canvas: &Canvas, portrait: &Portrait, curves: &SectionCurves, panel: &SheetPanel) {
    for (lines, ink) in [(&curves.stable, STABLE), (&curves.unstable, UNSTABLE)] {
        let mut path = Path::default();
        for run in lines.iter().flat_map(|line| line.chunk_by(|a, b| a.1 == b.1)) {
            if run.first().is_some_and(|(_, sheet)| *sheet == panel.sheet) {
                let line = SectionLine { points: run.iter().map(|(gamma, _)| *gamma).collect(), closed: false };
                for piece in portrait.in_chart(panel.chart, &line) {
                    path.line(&panel.positions(&piece), false);
                }
            }
        }
        canvas.draw(&path, &format!("{} stroke-linejoin=\"round\"", canvas.stroke(ink)));
        let dots = lines.iter().filter(|line| line.len() == 1).flatten().filter(|(_, sheet)| *sheet == panel.sheet);
        for (gamma, _) in dots {
            canvas.disc(panel.position(portrait.position(panel.chart, *gamma)), DOT, ink.color);
        }
    }
    let places = |points: &[([f64; 3], i8)]| -> Vec<Point> {
        let own = points.iter().filter(|(_, sheet)| *sheet == panel.sheet);
        own.map(|(gamma, _)| panel.position(portrait.position(panel.chart, *gamma))).collect()
    };
    for at in places(&curves.connections) {
        connection(canvas, at);
    }
    for at in places(&curves.orbits).into_iter().chain(places(&curves.rests)) {
        orbit(canvas, at);
    }
}

fn connection(canvas: &Canvas, at: Point) {
    canvas.spot(at, 1.9, CONNECTION);
    canvas.ring(at, 1.9, RING);
}

fn orbit(canvas: &Canvas, at: Point) {
    canvas.disc(at, 3.0, INK);
}

/// What of it the legend explains.
pub(super) fn legend(scenes: &[SectionScene<'_>]) -> Vec<(Symbol, String)> {
    let any = |of: fn(&SectionCurves) -> bool| scenes.iter().filter_map(|scene| scene.curves).any(of);
    let mut entries = Vec::new();
    if any(|curves| !curves.unstable.is_empty()) {
        entries.push((Symbol::solid(UNSTABLE), "unstable manifolds".to_owned()));
        entries.push((Symbol::solid(STABLE), "stable manifolds".to_owned()));
    }
    if any(|curves| !curves.orbits.is_empty()) {
        entries.push((Symbol::Mark("disc", Box::new(orbit)), "unstable periodic orbits".to_owned()));
    }
    if any(|curves| !curves.rests.is_empty()) {
        entries.push((Symbol::Mark("disc", Box::new(orbit)), "unstable equilibria".to_owned()));
    }
    if any(|curves| !curves.connections.is_empty()) {
        let text = "homoclinic and heteroclinic orbits, one point each";
        entries.push((Symbol::Mark("ring", Box::new(connection)), text.to_owned()));
    }
    entries
}
