//! The figure of docs/algorithms.md: an accessible region, cut by circles of latitude, with the ridges and valleys of J (Lemma
//! 9.6).

use std::error::Error;
use std::f64::consts::{PI, TAU};

use bifdiag_body::Frame;
use bifdiag_plot::page::{Anchor, Canvas, FAINT_INK, INK, Ink, Picture, Point, Theme, render, rgb};

use super::frame;

type Vector = [f64; 3];

/// x and h of the accessible region.
const AT: [f64; 2] = [2.5, 1.75];
/// How far the axis r̂ is tilted towards the viewer, and turned.
const TILT: f64 = 0.3;
const TURN: f64 = 1.6;
const RADIUS: f64 = 140.0;
const CENTER: Point = [165.0, 165.0];
const TEXT: f64 = 13.0;
const RIDGE: Ink = Ink { color: rgb(0xb7_1c_1c), width: 2.6 };
const VALLEY: Ink = Ink { color: rgb(0x12_50_a8), width: 2.6 };
const REGION: Ink = Ink { color: rgb(0x7f_b5_8a), width: 3.4 };
const LATITUDE: Ink = Ink { color: rgb(0xd2_d2_d2), width: 1.0 };

fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

fn normalised(u: Vector) -> Vector {
    let length = dot(u, u).sqrt();
    u.map(|c| c / length)
}

fn cross(u: Vector, v: Vector) -> Vector {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// The sphere with r̂ as its axis, seen from the side.
struct View {
    /// Two directions across r̂, and r̂.
    axes: [Vector; 3],
}

impl View {
    fn of(frame: &Frame) -> Self {
        let pole = normalised(frame.r);
        let across = normalised(cross(pole, [0.0, 0.0, 1.0]));
        Self { axes: [across, cross(pole, across), pole] }
    }

    /// At a height ⟨γ, r̂⟩ and a longitude.
    fn on_latitude(&self, height: f64, longitude: f64) -> Vector {
        let (sin, cos) = libm::sincos(longitude);
        let radius = (1.0 - height * height).sqrt();
        let [p, q, z] = self.axes;
        std::array::from_fn(|k| radius * (cos * p[k] + sin * q[k]) + height * z[k])
    }

    /// The place on the page, and the nearness.
    fn seen(&self, gamma: Vector) -> (Point, f64) {
        let [x, y, z] = self.axes.map(|axis| dot(axis, gamma));
        let ((sin, cos), (tilt_sin, tilt_cos)) = (libm::sincos(TURN), libm::sincos(TILT));
        let (x, y) = (cos * x - sin * y, sin * x + cos * y);
        let up = z * tilt_cos - y * tilt_sin;
        ([CENTER[0] + RADIUS * x, CENTER[1] - RADIUS * up], y * tilt_cos + z * tilt_sin)
    }

    /// The visible parts of a line on the sphere, where `is_drawn`.
    fn line(&self, canvas: &Canvas, line: &[Vector], is_drawn: impl Fn(Vector) -> bool, ink: Ink) {
        let mut part: Vec<Point> = Vec::new();
        for &gamma in line {
            let (at, nearness) = self.seen(gamma);
            if nearness >= 0.0 && is_drawn(gamma) {
                part.push(at);
            } else {
                canvas.path(&std::mem::take(&mut part), ink);
            }
        }
        canvas.path(&part, ink);
    }
}

/// γ ∥ adj(μ − A) r, and the sign of c(μ): positive on the ridge.
fn on_curve(frame: &Frame, mu: f64) -> (Vector, bool) {
    let tau = frame.a.map(|a| mu - a);
    let others = |k: usize| [(k + 1) % 3, (k + 2) % 3];
    let gamma = std::array::from_fn(|k| others(k).map(|j| tau[j]).iter().product::<f64>() * frame.r[k]);
    let term = |k: usize| {
        let [i, j] = others(k);
        let weight = frame.r[i] * frame.r[j] * frame.diff[i][j];
        weight * weight * tau[k] * tau[k] * tau[k]
    };
    (normalised(gamma), (0..3).map(term).sum::<f64>() > 0.0)
}

pub(super) fn draw(theme: Theme) -> Result<Picture, Box<dyn Error>> {
    const PARTS: u32 = 2400;
    const LATITUDES: u32 = 28;
    let frame = frame(["1", "1.5", "2"], ["0.55", "0.35", "0.75"])?;
    let view = View::of(&frame);
    let [x, h] = [AT[0] / (frame.momentum_unit * frame.momentum_unit), AT[1] / frame.energy_unit];
    let is_accessible = |gamma: Vector| {
        let moment = std::array::from_fn(|k| frame.a[k] * gamma[k]);
        x / dot(gamma, moment) - dot(gamma, frame.r) <= h
    };
    let scale = frame.a[2] - frame.a[0];
    let parameters = (1..PARTS).map(|k| frame.a[1] + scale * libm::tan(PI * (f64::from(k) / f64::from(PARTS) - 0.5)));
    let curve: Vec<(Vector, bool)> = parameters.map(|mu| on_curve(&frame, mu)).collect();
    let title = "Ridges and valleys of J on the Poisson sphere";
    Ok(render([490.0, 330.0], title, theme, |canvas| {
        let circle = |height: f64| -> Vec<Vector> {
            (0..=360).map(|k| view.on_latitude(height, TAU * f64::from(k) / 360.0)).collect()
        };
        for k in 1..LATITUDES {
            let line = circle(libm::cos(PI * f64::from(k) / f64::from(LATITUDES)));
            view.line(canvas, &line, |_| true, LATITUDE);
            view.line(canvas, &line, is_accessible, REGION);
        }
        for (is_ridge, ink) in [(true, RIDGE), (false, VALLEY)] {
            for sign in [1.0, -1.0] {
                let part = curve.iter().filter(|(_, ridge)| *ridge == is_ridge);
                let part: Vec<Vector> = part.map(|(gamma, _)| gamma.map(|c| sign * c)).collect();
                view.line(canvas, &part, |_| true, ink);
            }
        }
        let rim: Vec<Point> = (0..=180)
            .map(|k| {
                let (sin, cos) = libm::sincos(TAU * f64::from(k) / 180.0);
                [CENTER[0] + RADIUS * cos, CENTER[1] + RADIUS * sin]
            })
            .collect();
        canvas.path(&rim, Ink { color: FAINT_INK, width: 1.0 });
        let pole = view.seen(view.axes[2]).0;
        canvas.disc(pole, 4.0, INK);
        canvas.text("r̂", [pole[0] + 8.0, pole[1] - 6.0], TEXT, INK, Anchor::Start);
        for (row, (ink, text)) in
            [(RIDGE, "ridge"), (VALLEY, "valley"), (REGION, "accessible region")].iter().enumerate()
        {
            #[allow(clippy::cast_precision_loss)]
            let y = 40.0 + 24.0 * row as f64;
            canvas.path(&[[326.0, y - 4.0], [350.0, y - 4.0]], *ink);
            canvas.text(text, [358.0, y], TEXT, INK, Anchor::Start);
        }
    })?)
}
