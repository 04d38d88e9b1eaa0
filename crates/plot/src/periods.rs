//! Families of periodic orbits: their periods over the energy, or over l, by stability.

use bifdiag_schema::{
    FamilyEnd, GivenBody, OrbitEventKind, OrbitStability, PeriodicFamiliesDocument, PeriodicFamilyDocument,
    PeriodicOrbitDocument,
};
use plotters::style::RGBColor;

use bifdiag_page::{
    Anchor, Chart, Dash, INK, Legend, Picture, PlotError, Point, Rect, Symbol, TICK_SIZE, Theme, render, rgb,
};

const RECT: Rect = Rect { x: 74.0, y: 48.0, width: 500.0, height: 360.0 };
const SIZE: [f64; 2] = [650.0, 540.0];
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
        OrbitEventKind::Fold => ("fold", rgb(0xd8_98_00)),
        OrbitEventKind::Branch => ("another family crosses", rgb(0x80_20_a0)),
        OrbitEventKind::Doubling => ("doubling", rgb(0xc2_14_2d)),
        OrbitEventKind::Tripling => ("tripling", rgb(0x0e_7c_5a)),
    }
}

/// The room of a label.
const LABEL: Point = [34.0, 13.0];

/// Between the first and the last place at which a family begins, ends or has a special orbit, and as far again on either side:
/// families that go on for ever would take all the room.
fn eventful(document: &PeriodicFamiliesDocument, value: impl Fn(&PeriodicOrbitDocument) -> f64) -> [f64; 2] {
    let over_l = document.fixed_h.is_some();
    let of_family = |family: &PeriodicFamilyDocument| {
        let start = if over_l { family.l } else { family.h };
        let events = family.events.iter().map(|event| if over_l { event.l } else { event.h });
        let last = family.members.last().filter(|_| family.end.kind != FamilyEnd::Members).map(&value);
        std::iter::once(start).chain(events).chain(last).collect::<Vec<_>>()
    };
    let places: Vec<f64> = document.families.iter().flat_map(of_family).collect();
    let (least, most) =
        places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(*x), most.max(*x)));
    // A single place gives no scale.
    if most > least { [2.0 * least - most, 2.0 * most - least] } else { [f64::NEG_INFINITY, f64::INFINITY] }
}

/// The body and what is held.
fn about(document: &PeriodicFamiliesDocument) -> String {
    let GivenBody { moments, center, .. } = &document.body;
    let held = [("l", &document.fixed_l), ("h", &document.fixed_h)];
    let held = held.into_iter().find_map(|(name, value)| value.as_ref().map(|value| format!("; {name} = {value}")));
    format!("A = ({}), r = ({}){}", moments.join(", "), center.join(", "), held.unwrap_or_default())
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
    let [least, most] = eventful(document, value);
    let is_shown = |value: f64, period: f64| (shortest..=longest).contains(&period) && (least..=most).contains(&value);
    let strands = document.families.iter().flat_map(|family| {
        let branches = family.events.iter().flat_map(|event| &event.branches).map(|branch| &branch.members);
        std::iter::once(&family.members).chain(branches)
    });
    let strands: Vec<Vec<(Point, OrbitStability)>> = strands
        .map(|members| {
            let shown = members.iter().filter(|orbit| is_shown(value(orbit), orbit.period));
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
    let chart = Chart::new(RECT, [symbol, "period T"], [of_value, of_period]).with_room_above(24.0);
    let title = format!("Periodic orbits: T over {symbol}");
    render(SIZE, title.as_str(), theme, |canvas| {
        chart.draw(canvas);
        let mut entries: Vec<(Symbol, String)> = Vec::new();
        for stability in OrbitStability::ALL {
            let mut is_drawn = false;
            for strand in &strands {
                for pair in strand.windows(2).filter(|pair| pair[1].1 == *stability) {
                    chart.line(canvas, &[pair[0].0, pair[1].0], &pattern(*stability), 1.8);
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
            for event in events.filter(|event| event.kind == *kind) {
                let value = if over_l { event.l } else { event.h };
                if is_shown(value, event.period) {
                    canvas.disc(chart.at([value, event.period]), 3.2, color);
                    is_drawn = true;
                }
            }
            if is_drawn {
                entries.push((Symbol::Dots(vec![color]), words.to_owned()));
            }
        }
        // A family begins where its equilibrium is.
        let mut labels: Vec<(Point, (Point, &str))> = Vec::new();
        for family in &document.families {
            let start = chart.at([if over_l { family.l } else { family.h }, family.period]);
            canvas.disc(start, 2.4, INK);
            if let Some(curve) = &family.curve {
                let mut place = [start[0] + 5.0, start[1] - 5.0];
                // The two of a pair begin at one place.
                if labels.iter().any(|(_, (from, name))| *from == start && *name == curve.as_str()) {
                    continue;
                }
                let is_near = |place: Point, other: Point| {
                    (place[0] - other[0]).abs() < LABEL[0] && (place[1] - other[1]).abs() < LABEL[1]
                };
                while labels.iter().any(|(other, _)| is_near(place, *other)) {
                    place[1] += LABEL[1];
                }
                canvas.text(curve, place, TICK_SIZE, INK, Anchor::Start);
                labels.push((place, (start, curve.as_str())));
            }
        }
        if !document.families.is_empty() {
            entries.push((Symbol::Dots(vec![INK]), "equilibrium".to_owned()));
        }
        canvas.text(&about(document), [RECT.right(), RECT.y - 24.0], TICK_SIZE, INK, Anchor::End);
        Legend::new(entries, SIZE[0] - 2.0 * 30.0).draw(canvas, [30.0, RECT.bottom() + 58.0]);
    })
}
