//! Families of periodic orbits: their periods over the energy, or over l, by stability.

use bifdiag_schema::{OrbitEventKind, OrbitStability, PeriodicFamiliesDocument, PeriodicOrbitDocument};
use plotters::style::RGBColor;

use crate::page::{
    Anchor, Axis, Dash, INK, Ink, Legend, Picture, PlotError, Point, Rect, Symbol, TICK_SIZE, Theme, draw_axes, render,
    rgb, ticks,
};

const RECT: Rect = Rect { x: 74.0, y: 48.0, width: 500.0, height: 360.0 };
const SIZE: [f64; 2] = [650.0, 540.0];
const TEXT: f64 = 12.0;
/// Between the ends of the families and the frame, in parts of their range.
const MARGIN: f64 = 0.04;
/// A period so many times as long as the longest at an equilibrium is left out: separatrices have no end.
const LONG: f64 = 4.0;
/// A period so short, in parts of the shortest at an equilibrium, is left out, too: fast rotation has no end.
const SHORT: f64 = 0.25;

fn color(stability: OrbitStability) -> RGBColor {
    match stability {
        OrbitStability::Elliptic => rgb(0x12_50_a8),
        OrbitStability::Parabolic => rgb(0x0e_7c_5a),
        OrbitStability::Hyperbolic => rgb(0xc2_14_2d),
        OrbitStability::InverseHyperbolic => rgb(0xb0_5c_00),
    }
}

fn pattern(stability: OrbitStability) -> Vec<Dash> {
    let color = Some(color(stability));
    match stability {
        OrbitStability::Elliptic => vec![(color, 1.0)],
        OrbitStability::Parabolic => vec![(color, 9.0), (None, 3.0), (color, 2.0), (None, 3.0)],
        OrbitStability::Hyperbolic => vec![(color, 6.0), (None, 4.0)],
        OrbitStability::InverseHyperbolic => vec![(color, 3.0), (None, 3.0)],
    }
}

fn meaning(kind: OrbitEventKind) -> (&'static str, RGBColor) {
    match kind {
        OrbitEventKind::Fold => ("fold", rgb(0x40_40_40)),
        OrbitEventKind::Branch => ("another family crosses", rgb(0x80_20_a0)),
        OrbitEventKind::Doubling => ("doubling", rgb(0xc2_14_2d)),
        OrbitEventKind::Tripling => ("tripling", rgb(0x0e_7c_5a)),
    }
}

/// Draws the period of every member over what changes along its family, unless it is much longer or shorter than those of all
/// small oscillations: towards a separatrix and towards fast rotation nothing else happens, and takes all the room.
///
/// # Errors
/// [`PlotError`].
pub fn draw_periods(document: &PeriodicFamiliesDocument, theme: Theme) -> Result<Picture, PlotError> {
    let (over_l, symbol) = (document.fixed_h.is_some(), if document.fixed_h.is_some() { "l" } else { "h" });
    let value = |orbit: &PeriodicOrbitDocument| if over_l { orbit.l } else { orbit.h };
    let longest = LONG * document.families.iter().map(|family| family.period).fold(0.0, f64::max);
    let shortest = SHORT * document.families.iter().map(|family| family.period).fold(f64::INFINITY, f64::min);
    let is_shown = |period: f64| (shortest..=longest).contains(&period);
    let strands = document.families.iter().flat_map(|family| {
        let branches = family.events.iter().flat_map(|event| &event.branches).map(|branch| &branch.members);
        std::iter::once(&family.members).chain(branches)
    });
    let strands: Vec<Vec<(Point, OrbitStability)>> = strands
        .map(|members| {
            let shown = members.iter().filter(|orbit| is_shown(orbit.period));
            shown.map(|orbit| ([value(orbit), orbit.period], orbit.stability)).collect()
        })
        .collect();
    let range = |k: usize| {
        let values = || strands.iter().flatten().map(move |(point, _)| point[k]);
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let margin = MARGIN * (most - least).max(1e-9 * most.abs()).max(f64::MIN_POSITIVE);
        if most >= least { [least - margin, most + margin] } else { [0.0, 1.0] }
    };
    let [of_value, of_period] = [range(0), range(1)];
    let below = ticks(symbol, of_value[0], of_value[1], 8);
    let left = ticks("period T", of_period[0], of_period[1], 8);
    let at = |[x, y]: Point| {
        [
            RECT.x + RECT.width * (x - of_value[0]) / (of_value[1] - of_value[0]),
            RECT.bottom() - RECT.height * (y - of_period[0]) / (of_period[1] - of_period[0]),
        ]
    };
    let title = format!("Periodic orbits: T over {symbol}");
    render(SIZE, title.as_str(), theme, |canvas| {
        let axes = [Axis { range: of_value, ticks: &below }, Axis { range: of_period, ticks: &left }];
        draw_axes(canvas, &RECT, [24.0, 52.0], axes);
        let mut entries: Vec<(Symbol, String)> = Vec::new();
        for stability in OrbitStability::ALL {
            let mut is_drawn = false;
            for strand in &strands {
                for pair in strand.windows(2).filter(|pair| pair[1].1 == *stability) {
                    let line = [at(pair[0].0), at(pair[1].0)];
                    match stability {
                        OrbitStability::Elliptic => {
                            canvas.path(&line, Ink { color: color(*stability), width: 1.8 });
                        }
                        _ => canvas.dashed(&line, &pattern(*stability), 1.8),
                    }
                    is_drawn = true;
                }
            }
            if is_drawn {
                entries.push((Symbol::Line(pattern(*stability), 1.8), stability.word().to_owned()));
            }
        }
        for kind in OrbitEventKind::ALL {
            let (words, color) = meaning(*kind);
            let events = document.families.iter().flat_map(|family| &family.events);
            let mut is_drawn = false;
            for event in events.filter(|event| event.kind == *kind && is_shown(event.period)) {
                canvas.disc(at([if over_l { event.l } else { event.h }, event.period]), 3.2, color);
                is_drawn = true;
            }
            if is_drawn {
                entries.push((Symbol::Dots(vec![color]), words.to_owned()));
            }
        }
        // A family begins where its equilibrium is.
        for family in &document.families {
            let start = at([if over_l { family.l } else { family.h }, family.period]);
            canvas.disc(start, 2.4, INK);
            if let Some(curve) = &family.curve {
                canvas.text(curve, [start[0] + 5.0, start[1] - 5.0], TICK_SIZE, INK, Anchor::Start);
            }
        }
        canvas.text(&below.quantity, [RECT.center()[0], RECT.bottom() + 42.0], TEXT, INK, Anchor::Middle);
        canvas.text(&left.quantity, [16.0, RECT.y - 24.0], TEXT, INK, Anchor::Start);
        Legend::new(entries, SIZE[0] - 2.0 * 30.0).draw(canvas, [30.0, RECT.bottom() + 58.0]);
    })
}
