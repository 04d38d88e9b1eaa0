//! Campbell's diagram: frequencies of small oscillations over the spin.

use crate::page::{
    Anchor, Axis, FAINT_INK, INK, Ink, Picture, PlotError, Point, Rect, Theme, draw_axes, render, rgb, short_number,
    text_width, ticks,
};

/// Frequencies over the spin, and the spins at which the type changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Campbell {
    /// Spin in rpm, two frequencies in Hz (NaN for a pair of eigenvalues that does not oscillate), and what is known of the
    /// stability; by rising spin.
    pub rows: Vec<(f64, [f64; 2], Known)>,
    /// Spins in rpm.
    pub changes: Vec<f64>,
}

/// What is known of the stability of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// Stable, also with friction.
    Lasting,
    /// Stable as long as there is no friction.
    Frictionless,
    /// Neither is known.
    Open,
    /// Unstable.
    Unstable,
}

const RECT: Rect = Rect { x: 74.0, y: 62.0, width: 540.0, height: 340.0 };
const COLORS: [u32; 2] = [0x12_50_a8, 0xc2_14_2d];
const TEXT: f64 = 12.0;

/// Draws frequencies over the spin: solid where the rotation is stable (thin if only without friction), dashed where it is
/// unstable.
///
/// # Errors
/// [`PlotError`].
pub fn draw_campbell(campbell: &Campbell, theme: Theme) -> Result<Picture, PlotError> {
    let spin = campbell.rows.last().map_or(1.0, |row| row.0);
    let highest = campbell.rows.iter().flat_map(|row| row.1).fold(0.0, f64::max);
    let top = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let at =
        |rpm: f64, hertz: f64| [RECT.x + RECT.width * rpm / spin, RECT.bottom() - RECT.height * (hertz / top).min(1.0)];
    let (below, left) = (ticks("spin in rpm", 0.0, spin, 8), ticks("frequency in Hz, seen from the body", 0.0, top, 8));
    render([650.0, 506.0], "Frequencies over the spin", theme, |canvas| {
        let axes = [Axis { range: [0.0, spin], ticks: &below }, Axis { range: [0.0, top], ticks: &left }];
        draw_axes(canvas, &RECT, [24.0, 52.0], axes);
        // Once per turn: the spin itself.
        let once = Ink { color: rgb(0xc8_c8_c8), width: 1.0 };
        let end = (spin / 60.0).min(top);
        canvas.path(&[at(0.0, 0.0), at(60.0 * end, end)], once);
        for (which, color) in COLORS.into_iter().enumerate() {
            for (known, points) in stretches(campbell, which, &at) {
                let color = rgb(color);
                match known {
                    Known::Lasting => canvas.path(&points, Ink { color, width: 2.0 }),
                    Known::Frictionless => canvas.path(&points, Ink { color, width: 0.8 }),
                    Known::Open => canvas.dashed(&points, &[(Some(color), 2.0), (None, 3.0)], 2.0),
                    Known::Unstable => canvas.dashed(&points, &[(Some(color), 7.0), (None, 5.0)], 2.0),
                }
            }
        }
        let mut rows = [f64::NEG_INFINITY; 2];
        for &change in &campbell.changes {
            let x = at(change, 0.0)[0];
            // At rest every axis changes its type.
            if x < RECT.x + 1.0 {
                continue;
            }
            let dots = [(Some(INK), 2.0), (None, 4.0)];
            canvas.dashed(&[[x, RECT.y], [x, RECT.bottom()]], &dots, 1.2);
            let text = format!("{} rpm", short_number(change, 6));
            let half = text_width(&text, TEXT - 1.0) / 2.0;
            // In the first of two rows that has room; a table beside the picture tells all.
            if let Some(row) = rows.iter().position(|right| x - half > right + 6.0) {
                rows[row] = x + half;
                let above = [x, RECT.y - 6.0 - 15.0 * row as f64];
                canvas.text(&text, above, TEXT - 1.0, INK, Anchor::Middle);
            }
        }
        canvas.text(&below.quantity, [RECT.center()[0], RECT.bottom() + 42.0], TEXT, INK, Anchor::Middle);
        canvas.text(&left.quantity, [16.0, RECT.y - 40.0], TEXT, INK, Anchor::Start);
        let legend = "solid: stable, thin: stable without friction only, dashed: unstable, dotted: the type changes";
        let colors = "blue, red: the frequencies (none for a real pair of eigenvalues), grey: once per turn";
        canvas.text(colors, [RECT.x, RECT.bottom() + 84.0], TEXT, FAINT_INK, Anchor::Start);
        canvas.text(legend, [RECT.x, RECT.bottom() + 66.0], TEXT, FAINT_INK, Anchor::Start);
    })
}

/// Runs of equally known stability without gaps, each with the first point of the next.
fn stretches(campbell: &Campbell, which: usize, at: &impl Fn(f64, f64) -> Point) -> Vec<(Known, Vec<Point>)> {
    let mut runs: Vec<(Known, Vec<Point>)> = Vec::new();
    let mut is_open = false;
    for (rpm, frequencies, known) in &campbell.rows {
        if frequencies[which].is_nan() {
            is_open = false;
            continue;
        }
        let point = at(*rpm, frequencies[which]);
        match runs.last_mut().filter(|_| is_open) {
            Some((kind, points)) if kind == known => points.push(point),
            last => {
                if let Some((_, points)) = last {
                    points.push(point);
                }
                runs.push((*known, vec![point]));
            }
        }
        is_open = true;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_that_does_not_oscillate_leaves_a_gap() {
        let row = |rpm: f64, slow: f64, known| (rpm, [slow, 1.0], known);
        let (stable, unstable) = (Known::Lasting, Known::Unstable);
        let rows =
            vec![row(1.0, 0.5, stable), row(2.0, f64::NAN, unstable), row(3.0, 0.5, stable), row(4.0, 0.6, stable)];
        let campbell = Campbell { rows, changes: Vec::new() };
        let lengths =
            |which| stretches(&campbell, which, &|x, y| [x, y]).iter().map(|(_, p)| p.len()).collect::<Vec<_>>();
        assert_eq!((lengths(0), lengths(1)), (vec![1, 2], vec![2, 2, 2]));
    }
}
