//! Figure 2 of docs/mathematics.md: a cusp and a pitchfork in the plane of x and h (Definition 4.4).

use std::error::Error;

use bifdiag_equilibria::curves::{CriticalSet, Curve, End, Orbit};
use bifdiag_plot::page::{Anchor, FAINT_INK, INK, Ink, Picture, Point, Theme, render, rgb};

use super::frame;

/// Of x, and of h less [`SHEAR`] x: every slope 1/J is near the same value, which is taken off.
const RANGE: [[f64; 2]; 2] = [[1.2, 6.4], [-1.15, 0.75]];
const SHEAR: f64 = 0.8;
const FRAME: [f64; 4] = [56.0, 20.0, 366.0, 250.0];
const TEXT: f64 = 13.0;
const COLORS: [u32; 3] = [0x12_50_a8, 0x002e_7d32, 0xb7_1c_1c];

/// The place of the point of a curve over x, in the units of the frame.
fn place(set: &CriticalSet, curve: &Curve, x: f64) -> Point {
    let [left, top, width, height] = FRAME;
    let [[x0, x1], [y0, y1]] = RANGE;
    let [x, h] = [x * unit(set), curve.point(&set.frame, x).h() * set.frame.energy_unit];
    [left + width * (x - x0) / (x1 - x0), top + height * (y1 - (h - SHEAR * x)) / (y1 - y0)]
}

/// The unit of x.
fn unit(set: &CriticalSet) -> f64 {
    set.frame.momentum_unit * set.frame.momentum_unit
}

/// Points of a curve, closer together where it begins, with a vertical slope of its parameter.
fn points(set: &CriticalSet, curve: &Curve) -> Vec<Point> {
    const PARTS: u32 = 120;
    let [from, to] = curve.x();
    let to = to.min(RANGE[0][1] / unit(set));
    let over = |k: u32| {
        let t = f64::from(k) / f64::from(PARTS);
        place(set, curve, from + (to - from) * t * t)
    };
    (0..=PARTS).map(over).collect()
}

pub(super) fn draw(theme: Theme) -> Result<Picture, Box<dyn Error>> {
    let set = CriticalSet::new(frame(["2", "1.1", "1"], ["0.94868", "0", "0.61623"])?)?;
    let of_cusp = |curve: &Curve| curve.ends.iter().any(|end| matches!(end, End::Cusp(_)));
    let of_fork = |curve: &Curve| curve.ends.iter().any(|end| matches!(end, End::Pitchfork(_)));
    let shown: Vec<&Curve> = set.curves.iter().filter(|curve| of_cusp(curve) || of_fork(curve)).collect();
    let title = "A cusp and a pitchfork";
    Ok(render([590.0, 316.0], title, theme, |canvas| {
        let [left, top, width, height] = FRAME;
        let frame = [[left, top], [left + width, top], [left + width, top + height], [left, top + height]];
        canvas.outline(&frame, Ink { color: FAINT_INK, width: 1.0 });
        canvas.text("x = l²/2", [left + 0.5 * width, top + height + 32.0], TEXT, INK, Anchor::Middle);
        canvas.text(&format!("h − {SHEAR} x"), [left + 8.0, top + 20.0], TEXT, INK, Anchor::Start);
        for curve in &shown {
            let color = rgb(COLORS[usize::from(curve.index.unwrap_or(0)).min(2)]);
            let points = points(&set, curve);
            canvas.path(&points, Ink { color, width: 2.0 });
            let [_, to] = curve.x();
            if let (Some(&[x, y]), true) = (points.last(), to * unit(&set) > RANGE[0][1]) {
                let kind = match (curve.orbit, curve.index) {
                    (Orbit::Pair(_), Some(1)) => "mirror pair of saddles",
                    (_, Some(0)) => "minimum",
                    (_, Some(1)) => "saddle",
                    _ => "maximum",
                };
                canvas.text(kind, [x + 6.0, y + 4.0], TEXT, color, Anchor::Start);
            }
            for (end, x) in curve.ends.iter().zip(curve.x()) {
                let name = match end {
                    End::Cusp(_) => "cusp",
                    End::Pitchfork(_) => "pitchfork",
                    End::Origin | End::Infinity => continue,
                };
                let at = place(&set, curve, x);
                canvas.disc(at, 4.0, INK);
                // Each is an end of several curves: named once.
                if curve.index == Some(1) && (name == "cusp" || matches!(curve.orbit, Orbit::Pair(_))) {
                    canvas.text(name, [at[0] - 8.0, at[1] - 10.0], TEXT, INK, Anchor::End);
                }
            }
        }
    })?)
}
