//! The sphere with its poles taken out, and the cylinder with a polar circle in the place of each.

use std::f64::consts::{PI, TAU};

use super::shapes::arrow_head;
use bifdiag_plot::page::{Anchor, Canvas, INK, Ink, POLE, Picture, PlotError, Point, Theme, render, rgb};

/// How far the axis is tilted towards the viewer, in radians.
const TILT: f64 = 0.42;
const RADIUS: f64 = 105.0;
const FRONT: Ink = Ink { color: rgb(0x70_70_70), width: 0.9 };
const BACK: Ink = Ink { color: rgb(0xd2_d2_d2), width: 0.8 };
const CURVE: Ink = Ink { color: rgb(0x12_50_a8), width: 2.0 };
const CURVE_BACK: Ink = Ink { color: rgb(0xa9_c0_e0), width: 2.0 };
const TEXT: f64 = 13.0;

/// A point of space, z along the axis, seen from the side: place on the page from the centre, and nearness.
fn seen([x, y, z]: [f64; 3]) -> (Point, f64) {
    let (sin, cos) = libm::sincos(TILT);
    ([x, -(z * cos - y * sin)], y * cos + z * sin)
}

/// A map from (ψ', ϑ') to a point of space and the normal there.
type Surface = fn([f64; 2]) -> ([f64; 3], [f64; 3]);

/// (ψ', ϑ') on the sphere. ψ' is counted from the viewer's side.
fn on_sphere([psi, theta]: [f64; 2]) -> ([f64; 3], [f64; 3]) {
    let ((sin_psi, cos_psi), (sin, cos)) = (libm::sincos(psi), libm::sincos(theta));
    let point = [sin * sin_psi, sin * cos_psi, cos];
    (point, point)
}

/// (ψ', ϑ') on the cylinder, whose height is that of the sphere.
fn on_cylinder([psi, theta]: [f64; 2]) -> ([f64; 3], [f64; 3]) {
    let (sin_psi, cos_psi) = libm::sincos(psi);
    ([0.8 * sin_psi, 0.8 * cos_psi, 1.0 - 2.0 * theta / PI], [sin_psi, cos_psi, 0.0])
}

/// The hidden or the visible part of a curve in (ψ', ϑ') on a surface.
fn curve(canvas: &Canvas, center: Point, surface: Surface, points: &[[f64; 2]], hidden: bool, ink: Ink) {
    let mut part: Vec<Point> = Vec::new();
    for &point in points {
        let (place, normal) = surface(point);
        let at = seen(place).0;
        // Right at the rim both parts share a point.
        let here = seen(normal).1;
        if (here < 0.0) == hidden || here.abs() < 0.04 {
            part.push([center[0] + RADIUS * at[0], center[1] + RADIUS * at[1]]);
        } else {
            canvas.path(&std::mem::take(&mut part), ink);
        }
    }
    canvas.path(&part, ink);
}

fn sampled(line: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    (0..=96).map(|k| line(f64::from(k) / 96.0)).collect()
}

/// Circles of latitude and meridians.
fn net() -> Vec<Vec<[f64; 2]>> {
    let latitudes = (1..6).map(|k| sampled(|t| [TAU * t, PI * f64::from(k) / 6.0]));
    let meridians = (0..12).map(|k| sampled(|t| [TAU * f64::from(k) / 12.0, PI * t]));
    latitudes.chain(meridians).collect()
}

/// Fig. cylinder.
pub(super) fn draw(theme: Theme) -> Result<Picture, PlotError> {
    let (left, right) = ([140.0, 170.0], [430.0, 170.0]);
    // The rim of an inaccessible disc, the same on both.
    let rim = sampled(|t| {
        let (sin, cos) = libm::sincos(TAU * t);
        [0.35 + 0.75 * cos, 0.52 * PI + 0.42 * sin]
    });
    let surfaces: [(Point, Surface); 2] = [(left, on_sphere), (right, on_cylinder)];
    let faint_pole = Ink { color: rgb(0xf2_c9_97), width: 3.0 };
    render([580.0, 346.0], "The sphere without its poles is a cylinder", theme, |canvas| {
        // What is behind first.
        for hidden in [true, false] {
            let (net_ink, rim_ink) = if hidden { (BACK, CURVE_BACK) } else { (FRONT, CURVE) };
            for (center, surface) in surfaces {
                for line in net() {
                    curve(canvas, center, surface, &line, hidden, net_ink);
                }
                curve(canvas, center, surface, &rim, hidden, rim_ink);
            }
            for theta in [0.0, PI] {
                // The whole upper rim is seen.
                let ink = if hidden && theta > 0.0 { faint_pole } else { Ink { color: POLE, width: 3.0 } };
                curve(canvas, right, on_cylinder, &sampled(|t| [TAU * t, theta]), hidden, ink);
            }
        }
        let outline: Vec<Point> = sampled(|t| {
            let (sin, cos) = libm::sincos(TAU * t);
            [left[0] + RADIUS * cos, left[1] + RADIUS * sin]
        });
        canvas.path(&outline, Ink { color: INK, width: 1.0 });
        for (theta, name, label, color, aside) in
            [(0.0, "+r̂", "ϑ′ = 0", POLE, -RADIUS - 8.0), (PI, "−r̂", "ϑ′ = π", faint_pole.color, RADIUS + 18.0)]
        {
            let pole = seen(on_sphere([0.0, theta]).0).0;
            let at = [left[0] + RADIUS * pole[0], left[1] + RADIUS * pole[1]];
            canvas.ring(at, 5.0, Ink { color, width: 2.0 });
            canvas.text(name, [left[0], left[1] + aside], TEXT, INK, Anchor::Middle);
            let beside = seen(on_cylinder([PI / 2.0, theta]).0).0;
            let at = [right[0] + RADIUS * beside[0] + 10.0, right[1] + RADIUS * beside[1] + 4.0];
            canvas.text(label, at, TEXT, INK, Anchor::Start);
        }
        for side in [-1.0, 1.0] {
            let x = right[0] + side * 0.8 * RADIUS;
            let ends = [0.0, PI].map(|theta| right[1] + RADIUS * seen(on_cylinder([PI / 2.0, theta]).0).0[1]);
            canvas.path(&[[x, ends[0]], [x, ends[1]]], Ink { color: INK, width: 1.0 });
        }
        let arrow = Ink { color: INK, width: 1.4 };
        canvas.path(&[[272.0, 170.0], [312.0, 170.0]], arrow);
        arrow_head(canvas, [316.0, 170.0], [1.0, 0.0], arrow);
        canvas.text("the Poisson sphere", [left[0], 330.0], TEXT, INK, Anchor::Middle);
        canvas.text("the cylinder with its polar circles", [right[0], 330.0], TEXT, INK, Anchor::Middle);
    })
}
