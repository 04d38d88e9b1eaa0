//! Campbell's diagram: frequencies of small oscillations over the spin, seen from the body and from space, and rates of growth.

use plotters::style::RGBColor;

use crate::steady::Steadiness;
use bifdiag_page::{
    Anchor, CHART_TEXT, Canvas, Chart, Dash, INK, Legend, Picture, PlotError, Point, Rect, Symbol, Theme, render, rgb,
    rgbs, short_number, text_width,
};

/// Frequencies over the spin.
#[derive(Clone, Debug, PartialEq)]
pub struct Campbell {
    /// By rising spin.
    pub rows: Vec<CampbellRow>,
    /// Spins in rpm at which the type changes.
    pub changes: Vec<f64>,
}

/// Small oscillations at one spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CampbellRow {
    /// In rpm.
    pub spin: f64,
    /// In Hz, seen from the body; each mode keeps its place where two cross. NaN for a pair of eigenvalues that does not
    /// oscillate.
    pub frequencies: [f64; 2],
    /// The largest rate of growth in 1/s.
    pub growth: f64,
    /// What is known of the stability.
    pub known: Steadiness,
}

const LEFT: f64 = 74.0;
const WIDTH: f64 = 540.0;
const TOP: f64 = 62.0;
/// Heights of the panels of frequencies and of growth, and what is between two panels.
const HEIGHTS: [f64; 3] = [250.0, 250.0, 110.0];
const BETWEEN: f64 = 86.0;
/// The two modes, and in space the spin and a frequency together.
const COLORS: [RGBColor; 2] = rgbs([0x12_50_a8, 0xc2_14_2d]);
const SUMS: [RGBColor; 2] = rgbs([0x7f_a8_e0, 0xe8_8f_9a]);
const ONCE: RGBColor = rgb(0xa8_a8_a8);

fn width(known: Steadiness) -> f64 {
    if known == Steadiness::Frictionless { 0.8 } else { 2.0 }
}

fn pattern(known: Steadiness, color: RGBColor) -> Vec<Dash> {
    match known {
        Steadiness::Lasting | Steadiness::Frictionless => vec![(Some(color), 1.0)],
        Steadiness::Open => vec![(Some(color), 2.0), (None, 3.0)],
        Steadiness::Unstable => vec![(Some(color), 7.0), (None, 5.0)],
    }
}

fn meaning(known: Steadiness) -> &'static str {
    match known {
        Steadiness::Lasting => "stable, with friction too",
        Steadiness::Frictionless => "stable without friction, single spins aside",
        Steadiness::Open => "stability not decided",
        Steadiness::Unstable => "unstable",
    }
}

/// Draws the frequencies seen from the body, those seen from space, and below them the rate of growth where the rotation is
/// linearly unstable at some spin.
///
/// # Errors
/// [`PlotError`].
pub fn draw_campbell(campbell: &Campbell, theme: Theme) -> Result<Picture, PlotError> {
    let rows = &campbell.rows;
    let spin = rows.last().map_or(1.0, |row| row.spin);
    let hertz = |row: &CampbellRow| row.spin / 60.0;
    let in_space = |row: &CampbellRow, mode: usize, sign: f64| (hertz(row) + sign * row.frequencies[mode]).abs();
    let body = |mode: usize| (COLORS[mode], runs(rows, |row| row.frequencies[mode]));
    let both = |mode: usize| {
        [(SUMS, 1.0), (COLORS, -1.0)].map(|(colors, sign)| (colors[mode], runs(rows, |row| in_space(row, mode, sign))))
    };
    let grows = rows.iter().any(|row| row.growth > 0.0);
    let growth = if grows { vec![(INK, runs(rows, |row| row.growth))] } else { Vec::new() };
    let names = ["frequency in Hz, seen from the body", "frequency in Hz, seen from space", "rate of growth in 1/s"];
    let lines = [[0, 1].map(body).to_vec(), [0, 1].map(both).concat(), growth];
    let panels: Vec<_> =
        names.into_iter().zip(lines).zip(HEIGHTS).filter(|((_, lines), _)| !lines.is_empty()).collect();
    let mut top = TOP;
    let charts: Vec<(Chart, Vec<Curve>)> = panels
        .into_iter()
        .map(|((name, lines), height)| {
            let most = lines
                .iter()
                .flat_map(|(_, runs)| runs)
                .flat_map(|(_, points)| points)
                .map(|point| point[1])
                .fold(0.0, f64::max);
            let rect = Rect { x: LEFT, y: top, width: WIDTH, height };
            top += height + BETWEEN;
            let ranges = [[0.0, spin], [0.0, if most > 0.0 { 1.05 * most } else { 1.0 }]];
            let above = if rect.y > TOP { 14.0 } else { 40.0 };
            (Chart::new(rect, ["spin in rpm", name], ranges).with_room_above(above), lines)
        })
        .collect();
    let has_changes =
        charts.first().is_some_and(|(chart, _)| campbell.changes.iter().any(|&change| is_drawn(chart, change)));
    let legend = Legend::new(entries(rows, has_changes), WIDTH);
    let height = top - BETWEEN + 54.0 + legend.height() + 10.0;
    render([650.0, height], "Frequencies over the spin", theme, |canvas| {
        for (number, (chart, lines)) in charts.iter().enumerate() {
            chart.draw(canvas);
            // Once per turn: the spin itself.
            if number < 2 {
                let end = chart.top().min(spin / 60.0);
                chart.line(canvas, &[[0.0, 0.0], [60.0 * end, end]], &[(Some(ONCE), 1.0)], 1.0);
            }
            for (color, runs) in lines {
                for (known, points) in runs {
                    chart.line(canvas, points, &pattern(*known, *color), width(*known));
                }
            }
            changes(canvas, chart, &campbell.changes, number == 0);
        }
        legend.draw(canvas, [LEFT, top - BETWEEN + 54.0]);
    })
}

/// A colour and what is drawn in it.
type Curve = (RGBColor, Vec<(Steadiness, Vec<Point>)>);

/// What lines mean.
fn entries(rows: &[CampbellRow], has_changes: bool) -> Vec<(Symbol, String)> {
    let line = |color: RGBColor, known: Steadiness, text: &str| {
        (Symbol::Line(pattern(known, color), width(known)), text.to_owned())
    };
    let oscillates = |mode: &usize| rows.iter().any(|row| !row.frequencies[*mode].is_nan());
    let names = [
        ["one mode; in space, the spin less its frequency or the reverse", "the other mode"],
        [
            "in space, the spin plus its frequency",
            "the same for the other mode (a body symmetric about the axis shows only one of them)",
        ],
    ];
    let mut entries = Vec::new();
    for (colors, names) in [COLORS, SUMS].into_iter().zip(names) {
        let modes = (0..2).filter(oscillates).zip(names);
        entries.extend(modes.map(|(mode, name)| line(colors[mode], Steadiness::Lasting, name)));
    }
    entries.push(line(ONCE, Steadiness::Frictionless, "once per turn"));
    let is_there = |known: &Steadiness| rows.iter().any(|row| row.known == *known);
    entries.extend(Steadiness::ALL.into_iter().filter(is_there).map(|known| line(INK, known, meaning(known))));
    if has_changes {
        entries.push((Symbol::Line(CHANGE.to_vec(), 1.2), "the type changes".to_owned()));
    }
    entries
}

const CHANGE: [Dash; 2] = [(Some(INK), 2.0), (None, 4.0)];

/// Whether a change is far enough from rest, where every axis changes its type, for a line of its own.
fn is_drawn(chart: &Chart, change: f64) -> bool {
    chart.at([change, 0.0])[0] >= LEFT + 1.0
}

/// Lines where the type changes, with the spins above the frame.
fn changes(canvas: &Canvas, chart: &Chart, changes: &[f64], are_labelled: bool) {
    let mut rows = [f64::NEG_INFINITY; 2];
    for &change in changes {
        let [x, _] = chart.at([change, 0.0]);
        if !is_drawn(chart, change) {
            continue;
        }
        canvas.dashed(&[[x, chart.rect.y], [x, chart.rect.bottom()]], &CHANGE, 1.2);
        // As many digits as tell it from the others.
        let is_apart = |digits: &usize| {
            let text = short_number(change, *digits);
            changes.iter().all(|&other| other == change || short_number(other, *digits) != text)
        };
        let text = format!("{} rpm", short_number(change, (6..16).find(is_apart).unwrap_or(16)));
        let half = text_width(&text, CHART_TEXT - 1.0) / 2.0;
        // In the first of two rows that has room; the table lists all.
        if let Some(row) = rows.iter().position(|right| are_labelled && x - half > right + 6.0) {
            rows[row] = x + half;
            let above = [x, chart.rect.y - 6.0 - 15.0 * row as f64];
            canvas.text(&text, above, CHART_TEXT - 1.0, INK, Anchor::Middle);
        }
    }
}

/// Runs of equally known stability without gaps, each with the first point of the next.
fn runs(rows: &[CampbellRow], value: impl Fn(&CampbellRow) -> f64) -> Vec<(Steadiness, Vec<Point>)> {
    let mut runs: Vec<(Steadiness, Vec<Point>)> = Vec::new();
    let mut is_open = false;
    for row in rows {
        let point = [row.spin, value(row)];
        if point[1].is_nan() {
            is_open = false;
            continue;
        }
        match runs.last_mut().filter(|_| is_open) {
            Some((known, points)) if *known == row.known => points.push(point),
            last => {
                if let Some((_, points)) = last {
                    points.push(point);
                }
                runs.push((row.known, vec![point]));
            }
        }
        is_open = true;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(spin: f64, slow: f64, known: Steadiness) -> CampbellRow {
        CampbellRow {
            spin,
            frequencies: [slow, 1.0],
            growth: if known == Steadiness::Unstable { 0.5 } else { 0.0 },
            known,
        }
    }

    #[test]
    fn a_pair_that_does_not_oscillate_leaves_a_gap() {
        let (stable, unstable) = (Steadiness::Lasting, Steadiness::Unstable);
        let rows = [row(1.0, 0.5, stable), row(2.0, f64::NAN, unstable), row(3.0, 0.5, stable), row(4.0, 0.6, stable)];
        let lengths = |which: usize| {
            runs(&rows, |row| row.frequencies[which]).iter().map(|(_, points)| points.len()).collect::<Vec<_>>()
        };
        assert_eq!((lengths(0), lengths(1)), (vec![1, 2], vec![2, 2, 2]));
    }

    #[test]
    fn growth_has_a_panel_only_where_something_grows() {
        let picture = |known| {
            let rows = vec![row(30.0, 0.5, Steadiness::Lasting), row(60.0, 0.6, known)];
            draw_campbell(&Campbell { rows, changes: vec![45.0] }, Theme::Light).unwrap().svg
        };
        for name in ["seen from the body", "seen from space"] {
            assert!(picture(Steadiness::Lasting).contains(name), "{name}");
        }
        assert!(
            !picture(Steadiness::Lasting).contains("rate of growth")
                && picture(Steadiness::Unstable).contains("rate of growth")
        );
    }
}
