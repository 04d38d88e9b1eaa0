//! The axes of a panel.

use super::labels::{H, L};
use super::layout::BELOW;
use super::panel::Panel;
use super::plan::{LEFT, RIGHT};
use super::windows::View;
use bifdiag_page::{Anchor, Axis, Canvas, INK, Point, TICK_SIZE, Ticks, draw_axes, text_width, ticks};

pub(super) const AXIS_SIZE: f64 = TICK_SIZE + 1.0;
/// The height of insets that are small.
const SMALL: f64 = 150.0;
/// Between two labels of ticks, at least.
const APART: f64 = 5.0;
/// More ticks than find room are never tried.
const COUNT_MAX: usize = 16;

/// The ticks of h and l.
pub(super) fn axis_ticks(panel: &Panel, is_main: bool) -> [Ticks; 2] {
    let wanted = match is_main {
        true => [70.0, 49.0],
        false if panel.view.rect.height < SMALL => [48.0, 28.0],
        false => [58.0, 41.0],
    };
    ticks_of(&panel.view, wanted)
}

/// The ticks of a view at the wanted distance in pixels; closer if there would be fewer than two, since one shows no
/// scale. No label of h leaves the page.
fn ticks_of(view: &View, wanted: [f64; 2]) -> [Ticks; 2] {
    let View { window, rect } = *view;
    let around = |at: f64, half: f64| [at - half, at + half];
    let across = |h: f64, label: &str| around(view.position([h, window.l[0]])[0], text_width(label, TICK_SIZE) / 2.0);
    let up = |l: f64, _: &str| around(-view.position([window.h[0], l])[1], TICK_SIZE / 2.0);
    let h = at_least_two(
        |count| fitting(ticks(H, window.h[0], window.h[1], count), across, rect.right() + RIGHT - 1.0),
        across,
        rect.width / wanted[0],
    );
    let l = at_least_two(|count| ticks(L, window.l[0], window.l[1], count), up, rect.height / wanted[1]);
    [h, l]
}

/// The ticks whose labels end before a place.
fn fitting(ticks: Ticks, extent: impl Fn(f64, &str) -> [f64; 2], end: f64) -> Ticks {
    let Ticks { values, labels, quantity } = ticks;
    let fitting = values.into_iter().zip(labels).filter(|(value, label)| extent(*value, label)[1] < end);
    let (values, labels) = fitting.unzip();
    Ticks { values, labels, quantity }
}

/// About as many ticks as wanted or, if these are one or none, as few more as possible without overlapping labels.
fn at_least_two(ticks: impl Fn(usize) -> Ticks, extent: impl Fn(f64, &str) -> [f64; 2], wanted: f64) -> Ticks {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
    let count = wanted.floor() as usize;
    let are_apart = |ticks: &Ticks| {
        let extents = ticks.values.iter().zip(&ticks.labels).map(|(value, label)| extent(*value, label));
        extents.collect::<Vec<_>>().windows(2).all(|pair| pair[0][1] + APART <= pair[1][0])
    };
    let first = ticks(count);
    if first.values.len() > 1 {
        return first;
    }
    // All of them, every second one or every third one.
    let parts =
        |ticks: Ticks| (1..=3).flat_map(move |step| (0..step).map(|from| part(&ticks, from, step)).collect::<Vec<_>>());
    let mut more = (count + 1..=COUNT_MAX).map(ticks).flat_map(parts);
    more.find(|ticks| ticks.values.len() > 1 && are_apart(ticks)).unwrap_or(first)
}

fn part(ticks: &Ticks, from: usize, step: usize) -> Ticks {
    Ticks {
        values: ticks.values.iter().copied().skip(from).step_by(step).collect(),
        labels: ticks.labels.iter().skip(from).step_by(step).cloned().collect(),
        quantity: ticks.quantity.clone(),
    }
}

/// Where the name of the l axis begins.
pub(super) fn l_name_at(panel: &Panel, name: &str) -> Point {
    let rect = panel.view.rect;
    [(rect.x - 12.0 - text_width(name, AXIS_SIZE)).max(rect.x - LEFT + 14.0), rect.y - 12.0]
}

/// The axes of a panel and its frame; those of the main panel say what h and l are.
pub(super) fn paint_axes(canvas: &Canvas, panel: &Panel, is_main: bool, units: &[String; 2]) {
    let View { window, rect } = panel.view;
    let [h_ticks, l_ticks] = axis_ticks(panel, is_main);
    let [h, l] = [(window.h, &h_ticks), (window.l, &l_ticks)].map(|(range, ticks)| Axis { range, ticks });
    draw_axes(canvas, &rect, [BELOW, LEFT], [h, l]);
    // In full where the labels are not scaled, in the main panel.
    let name = |quantity: &str, meaning: &str, unit: &str| {
        let unit = if unit.is_empty() { String::new() } else { format!(" in {unit}") };
        match quantity {
            H | L if is_main => format!("{meaning} {quantity}{unit}"),
            scaled => format!("{scaled}{}", if is_main { &unit } else { "" }),
        }
    };
    let h_name = name(&h_ticks.quantity, "energy", &units[0]);
    let l_name = name(&l_ticks.quantity, "vertical angular momentum", &units[1]);
    canvas.text(&h_name, [rect.x + rect.width / 2.0, rect.bottom() + 36.0], AXIS_SIZE, INK, Anchor::Middle);
    canvas.text(&l_name, l_name_at(panel, &l_name), AXIS_SIZE, INK, Anchor::Start);
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_page::Rect;
    use bifdiag_schema::WindowDocument;

    #[test]
    fn every_axis_of_an_inset_has_two_ticks_and_labels_are_apart() {
        let mut scale = 1e-9;
        for k in 0..4000_u32 {
            // A window anywhere, on scales from 1e-9 of its position to 100 times it.
            let at = |step: f64| (f64::from(k) * step).fract();
            scale *= 1.006_6;
            let from = [3.0 * at(0.754_877_666) - 1.0, 2.0 * at(0.569_840_291)];
            let size = [scale * (1.0 + 9.0 * at(0.618_034)), scale * (1.0 + 9.0 * at(0.414_213_6))];
            let window = WindowDocument { h: [from[0], from[0] + size[0]], l: [from[1], from[1] + size[1]] };
            for [width, height] in [[159.0, 110.0], [171.0, 112.0], [246.0, 200.0], [374.0, 200.0]] {
                let rect = Rect { x: LEFT, y: 0.0, width, height };
                let [h, l] = ticks_of(&View { window, rect }, [58.0, 41.0]);
                assert!(h.values.len() > 1 && l.values.len() > 1, "{window:?}: {h:?} {l:?}");
                assert_eq!([h.values.len(), l.values.len()], [h.labels.len(), l.labels.len()]);
                let half = |label: &String| text_width(label, TICK_SIZE) / 2.0;
                let x = |k: usize| (h.values[k] - window.h[0]) / size[0] * width;
                for k in 1..h.values.len() {
                    assert!(x(k - 1) + half(&h.labels[k - 1]) < x(k) - half(&h.labels[k]), "{window:?}: {h:?}");
                }
            }
        }
    }
}
