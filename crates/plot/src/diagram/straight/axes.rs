//! The axes of the straightened plane: l below, h on the left at l = 0 and on the right at the last l, and curves of constant h
//! between them.

use super::super::axes::AXIS_SIZE;
use super::super::labels::{H, L};
use super::super::plan::LEFT;
use super::plane::Straight;
use bifdiag_page::{
    Anchor, Canvas, FAINT_INK, INK, Ink, Point, TICK_SIZE, number, short_number, text_width, value_text,
};

/// Length of a tick.
const TICK: f64 = 4.0;
/// Free pixels between the labels of two ticks.
const APART: f64 = 5.0;
/// The most characters of a label.
const LABEL_MAX: usize = 6;
/// Powers of ten between the coarsest and the finest ticks, and the maximum number of ticks of one fineness between
/// neighbouring curves or events.
const DECADES: i32 = 7;
const MOST: f64 = 60.0;
/// No level of h is labelled so close to the upper edge, where h goes to infinity.
const UPPER: f64 = 9.0;

/// Half the width of a label below the axis.
pub(crate) fn half_width(label: &str) -> f64 {
    text_width(label, TICK_SIZE) / 2.0
}

/// A round number on an axis.
pub(crate) struct Tick {
    value: f64,
    /// Along the axis.
    pub at: f64,
    pub label: String,
}

/// Round numbers between given ones: coarse ones first, finer ones where there is room between them.
fn round_numbers(pieces: &[f64], place: impl Fn(f64) -> Option<f64>, extent: impl Fn(&str) -> f64) -> Vec<Tick> {
    let mut ticks: Vec<Tick> = Vec::new();
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return ticks };
    let length = format!("{:e}", last - first);
    let largest: i32 = length.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0) + 1;
    let steps = (0..DECADES).flat_map(|finer| [5, 2, 1].map(|factor| (factor, largest - finer)));
    for ((factor, power), piece) in steps.flat_map(|step| pieces.windows(2).map(move |piece| (step, piece))) {
        let value = |count: f64| {
            format!("{}e{power}", count * f64::from(factor)).parse::<f64>().map_or(0.0, |value| value + 0.0)
        };
        let step: f64 = value(1.0);
        let (first, last) = ((piece[0] / step).ceil(), (piece[1] / step).floor());
        if last - first > MOST {
            continue;
        }
        let mut count = first;
        while count <= last {
            let value: f64 = value(count);
            count += 1.0;
            let plain = number(value);
            let label = if plain.chars().count() <= LABEL_MAX { plain } else { short_number(value, 2) };
            let is_exact = label.chars().count() <= LABEL_MAX && !ticks.iter().any(|tick| tick.label == label);
            let Some(at) = place(value).filter(|_| is_exact) else { continue };
            let half = extent(&label);
            if ticks.iter().all(|tick| (tick.at - at).abs() >= half + extent(&tick.label) + APART) {
                ticks.push(Tick { value, at, label });
            }
        }
    }
    ticks
}

impl Straight {
    /// The levels of h on the left and on the right.
    pub(crate) fn levels(&self) -> [Vec<Tick>; 2] {
        let Some((first, last)) = self.slabs.first().zip(self.slabs.last()) else { return [Vec::new(), Vec::new()] };
        [(first, 0, 0), (last, self.slabs.len() - 1, last.stations.len() - 1)].map(|(slab, number, station)| {
            let h = &slab.stations[station].h;
            let y = &self.placed[number][station].1;
            // Half of what is above the curves, and half of the rest again.
            let top = h[h.len() - 1] + 20.0 * (h[h.len() - 1] - h[0] + self.energy_unit());
            let place = |value: f64| self.height(value, h, y).filter(|y| *y > self.rect.y + UPPER);
            let pieces: Vec<f64> = h.iter().copied().chain([top]).collect();
            round_numbers(&pieces, place, |_| TICK_SIZE / 2.0)
        })
    }

    pub(crate) fn paint_levels(&self, canvas: &Canvas) {
        for line in self.level_lines() {
            canvas.path(&line, Ink { color: FAINT_INK, width: 0.3 });
        }
    }

    /// Curves of constant h: those of the ticks on the left, and between the curves those of the ticks on the right, which
    /// above them would be too close to each other.
    pub(crate) fn level_lines(&self) -> Vec<Vec<Point>> {
        let [left, right] = self.levels();
        let values = |ticks: &[Tick]| ticks.iter().map(|tick| tick.value).collect::<Vec<f64>>();
        let (left, right) = (values(&left), values(&right));
        let further = right.iter().filter(|value| !left.contains(value)).map(|level| (*level, false));
        let levels = left.iter().map(|level| (*level, true)).chain(further);
        levels.flat_map(|(level, above)| self.level(level, above)).collect()
    }

    /// Round momenta, their labels `half` as wide on each side.
    pub(crate) fn momenta(&self, half: impl Fn(&str) -> f64) -> Vec<Tick> {
        let x = |l: f64| self.at(l).map(|place| self.x(place));
        let pieces = self.slabs.iter().map(|slab| slab.l[0]).chain(self.l_end());
        round_numbers(&pieces.collect::<Vec<f64>>(), x, half)
    }

    /// The lines of constant h above the lowest curve, and `above` the highest.
    fn level(&self, level: f64, above: bool) -> Vec<Vec<Point>> {
        let mut lines: Vec<Vec<Point>> = vec![Vec::new()];
        for (slab, placed) in self.slabs.iter().zip(&self.placed) {
            let pairs = slab.stations.iter().zip(placed);
            for ((from, (x, y)), (to, (x_next, y_next))) in pairs.clone().zip(pairs.skip(1)) {
                // Where the level enters and leaves what it is drawn in, as shares of the way.
                let ends = [&from.h, &to.h].map(|h| [level - h[0], if above { 1.0 } else { h[h.len() - 1] - level }]);
                let mut range = [0.0_f64, 1.0];
                for [from, to] in [[ends[0][0], ends[1][0]], [ends[0][1], ends[1][1]]] {
                    match (from >= 0.0, to >= 0.0) {
                        (true, true) => {}
                        (true, false) => range[1] = range[1].min(from / (from - to)),
                        (false, true) => range[0] = range[0].max(from / (from - to)),
                        (false, false) => range = [1.0, 0.0],
                    }
                }
                if range[0] > range[1] {
                    continue;
                }
                let point = |t: f64| {
                    let between = |a: f64, b: f64| a + (b - a) * t;
                    let [h, y] = [[&from.h, &to.h], [y, y_next]]
                        .map(|[a, b]| a.iter().zip(b).map(|(a, b)| between(*a, *b)).collect::<Vec<f64>>());
                    // Rounding may put it below the lowest curve where it ends there.
                    [between(*x, *x_next), self.height(level, &h, &y).unwrap_or(y[0])]
                };
                if range[0] > 0.0 && !lines.iter().all(Vec::is_empty) {
                    lines.push(Vec::new());
                }
                if let Some(line) = lines.last_mut() {
                    line.extend(range.map(point));
                    line.dedup();
                }
            }
        }
        lines
    }

    /// The axes and the frame.
    pub(crate) fn paint_axes(&self, canvas: &Canvas, units: &[String; 2]) {
        let rect = &self.rect;
        let ink = Ink { color: INK, width: 0.9 };
        canvas.outline(&rect.corners(), ink);
        let l_end = self.l_end().unwrap_or(0.0);
        for tick in self.momenta(half_width) {
            canvas.path(&[[tick.at, rect.bottom()], [tick.at, rect.bottom() + TICK]], ink);
            let base = [tick.at, rect.bottom() + TICK + 1.2 * TICK_SIZE];
            canvas.text(&tick.label, base, TICK_SIZE, INK, Anchor::Middle);
        }
        let sides = [(rect.x, -TICK, Anchor::End), (rect.right(), TICK, Anchor::Start)];
        for (levels, (x, out, anchor)) in self.levels().iter().zip(sides) {
            for tick in levels {
                canvas.path(&[[x, tick.at], [x + out, tick.at]], ink);
                canvas.text(&tick.label, [x + 1.8 * out, tick.at + 0.36 * TICK_SIZE], TICK_SIZE, INK, anchor);
            }
        }
        let unit = |unit: &String| if unit.is_empty() { String::new() } else { format!(" in {unit}") };
        let [of_h, of_l] = [unit(&units[0]), unit(&units[1])];
        let middle = [rect.x + rect.width / 2.0, rect.bottom() + 36.0];
        canvas.text(&format!("vertical angular momentum {L}{of_l}"), middle, AXIS_SIZE, INK, Anchor::Middle);
        let left = [rect.x - LEFT + 14.0, rect.y - 12.0];
        canvas.text(&format!("energy {H}{of_h} at {L} = 0"), left, AXIS_SIZE, INK, Anchor::Start);
        let right = [rect.right() + self.right, rect.y - 12.0];
        canvas.text(&format!("{H} at {}", value_text(L, &l_end.to_string(), 6)), right, AXIS_SIZE, INK, Anchor::End);
    }
}
