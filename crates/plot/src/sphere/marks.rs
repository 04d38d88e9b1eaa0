//! Poles, relative equilibria and principal axes.

use super::names::Names;
use super::scene::SphereScene;
use super::view::{Vector, View, turned};
use crate::page::{Canvas, FAINT_INK, INK, Ink, PAPER, POLE, Point, Rect, rgb};
use bifdiag_schema::Multiplicity;
use plotters::style::RGBColor;

/// Font sizes of names, and of the numbers of components.
const LABEL: f64 = 12.0;
const NUMBER: f64 = 15.0;
pub(super) const MARK: f64 = 4.2;
/// Round the mark of an equilibrium.
const POLE_RING: f64 = 7.4;
/// Principal axes so near to a pole have no mark of their own.
const NEAR: f64 = 0.1;
/// Relative equilibria stand out from every tint and from the level lines.
pub(super) const EQUILIBRIUM: RGBColor = rgb(0x9a_10_2a);

/// What a mark stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// A relative equilibrium of this Morse index.
    Equilibrium(u8),
    /// +r̂ (true) or −r̂.
    Pole(bool),
    /// The end of a principal axis.
    Axis,
}

/// By what a mark and a row of the table are connected: a, b, …, by rising h.
pub(super) fn letter(place: usize) -> String {
    u8::try_from(place)
        .ok()
        .filter(|place| *place < 26)
        .map_or_else(String::new, |place| char::from(b'a' + place).to_string())
}

pub(super) fn draw(canvas: &Canvas, mark: Mark, at: Point) {
    let thin = Ink { color: EQUILIBRIUM, width: 1.8 };
    match mark {
        Mark::Equilibrium(0) => {
            canvas.disc(at, MARK + 1.0, PAPER);
            canvas.disc(at, MARK, EQUILIBRIUM);
        }
        Mark::Equilibrium(1) => {
            for [dx, dy] in [[1.0, 1.0], [1.0, -1.0]] {
                let [x, y] = [MARK * dx, MARK * dy];
                let ends = [[at[0] - x, at[1] - y], [at[0] + x, at[1] + y]];
                canvas.path(&ends, Ink { color: PAPER, width: 3.8 });
                canvas.path(&ends, thin);
            }
        }
        Mark::Equilibrium(_) => canvas.ring(at, MARK, thin),
        Mark::Pole(plus) => {
            canvas.ring(at, POLE_RING, Ink { color: POLE, width: 2.2 });
            if plus {
                canvas.disc(at, 1.7, POLE);
            }
        }
        Mark::Axis => canvas.disc(at, 1.6, FAINT_INK),
    }
}

/// Draws the ends of the principal axes, the poles, the equilibria and the numbers of components that a view shows, with
/// their names.
pub(super) fn draw_all(canvas: &Canvas, scene: &SphereScene<'_>, names: &mut Names<'_>, numbers: &[(usize, Point)]) {
    let view = names.view;
    let r_hat = scene.r_hat;
    let poles: Vec<Vector> = r_hat.into_iter().flat_map(|r| [r, r.map(|c| -c)]).collect();
    let mut named: Vec<(Point, String, f64, RGBColor)> = Vec::new();
    for (place, equilibrium) in scene.equilibria.iter().enumerate() {
        if let Some(at) = view.position(equilibrium.gamma) {
            named.push((at, letter(place), LABEL, EQUILIBRIUM));
        }
    }
    for &(number, at) in numbers {
        named.push((at, number.to_string(), NUMBER, INK));
    }
    for (plus, name) in [(true, "+r̂"), (false, "−r̂")] {
        let sign = if plus { 1.0 } else { -1.0 };
        if let Some(at) = r_hat.and_then(|r| view.position(r.map(|c| sign * c))) {
            draw(canvas, Mark::Pole(plus), at);
            names.take(Rect::around(at, POLE_RING + 1.0));
            named.push((at, name.to_owned(), LABEL, INK));
        }
    }
    for (axis, ends) in [["e₁", "−e₁"], ["e₂", "−e₂"], ["e₃", "−e₃"]].into_iter().enumerate() {
        for (sign, name) in [1.0, -1.0].into_iter().zip(ends) {
            let mut gamma = [0.0; 3];
            gamma[axis] = sign;
            // At a pole the mark of the pole says more.
            let near = |pole: &Vector| (0..3).all(|k| (pole[k] - gamma[k]).abs() < NEAR);
            if let Some(at) = view.position(gamma).filter(|_| !poles.iter().any(near)) {
                draw(canvas, Mark::Axis, at);
                names.take(Rect::around(at, 2.0));
                named.push((at, name.to_owned(), LABEL, FAINT_INK));
            }
        }
    }
    // On top: an equilibrium at a pole lies inside its ring.
    for equilibrium in scene.equilibria {
        if equilibrium.multiplicity == Multiplicity::Circle {
            circle(canvas, view, equilibrium.gamma, scene.axis);
        }
        if let Some(at) = view.position(equilibrium.gamma) {
            draw(canvas, Mark::Equilibrium(equilibrium.index), at);
            names.take(Rect::around(at, MARK + 1.0));
        }
    }
    for (at, name, size, color) in named {
        names.write(canvas, at, &name, (size, color), size > LABEL);
    }
}

/// The visible part of the circle on which γ turns about an axis.
fn circle(canvas: &Canvas, view: &View, gamma: Vector, axis: Vector) {
    const STEPS: u32 = 180;
    let step = std::f64::consts::TAU / f64::from(STEPS);
    let places = (0..=STEPS).map(|k| view.position(turned(gamma, axis, step * f64::from(k))));
    let places: Vec<Option<Point>> = places.collect();
    for run in places.split(Option::is_none) {
        let points: Vec<Point> = run.iter().copied().flatten().collect();
        canvas.path(&points, Ink { color: EQUILIBRIUM, width: 1.6 });
    }
}
