//! The windows in which a diagram is seen: a pure function of curves and events.

use schema::{AtlasDocument, CurveDocument, CurveKind, WindowDocument};

use super::Refused;
use super::plane::Plane;

/// Numbers of a window are right to this share of it.
const ACCURACY: f64 = 1e-6;
const WHY: Refused = Refused::Field { field: "view" };

struct View<'a> {
    document: &'a AtlasDocument,
    plane: &'a Plane<'a>,
}

/// Checks both windows.
pub(super) fn check(document: &AtlasDocument, plane: &Plane) -> Result<(), Refused> {
    let view = View { document, plane };
    let l: Vec<f64> = document.events.iter().map(|event| event.l).collect();
    let last = l.last().copied().unwrap_or(0.0);
    // An event at more than twelve times the l of the one before is left to an inset.
    let before_leap = l.windows(2).find(|pair| pair[1] > 12.0 * pair[0]).map_or(last, |pair| pair[0]);
    // Of curves that begin at one height any may be called the lowest.
    let confirmed = view.lowest().ok_or(WHY)?.into_iter().any(|lowest| {
        let holds = |claim, last| view.window(last, lowest).is_some_and(|found| is_near(claim, &found));
        holds(&document.view.everything, last) && holds(&document.view.main, before_leap)
    });
    if confirmed { Ok(()) } else { Err(WHY) }
}

fn is_near(claim: &WindowDocument, found: &WindowDocument) -> bool {
    let near = |p: [f64; 2], q: [f64; 2]| (0..2).all(|k| (p[k] - q[k]).abs() <= ACCURACY * (q[1] - q[0]).abs());
    near(claim.h, found.h) && near(claim.l, found.l)
}

impl View<'_> {
    /// All events up to one, a quarter of its l beyond it; energies from the lowest curve to the highest of what begins at
    /// l = 0 and half as far again, of the events, of curves of the last events, and of the middle one of the curves at the top.
    fn window(&self, last: f64, lowest: Option<&CurveDocument>) -> Option<WindowDocument> {
        let events = || self.document.events.iter().filter(move |event| event.l <= last);
        let [_, end] = self.plane.extent(self.document);
        let top = if last > 0.0 {
            1.25 * last.max(self.start_of_positive_energies(lowest, end.min(12.0 * last))?)
        } else {
            end
        };
        let mut at_top = Vec::new();
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for curve in self.curves() {
            let Some([first, highest]) = self.heights_below(curve, top)? else { continue };
            low = low.min(first);
            if curve.l_range[0] == Some(0.0) {
                high = high.max(first);
            }
            if curve.l_range[1].is_none_or(|to| to >= top) {
                at_top.extend(std::iter::repeat_n(highest, 1 + usize::from(!curve.coincides_with.is_empty())));
            }
        }
        if high.is_finite() {
            high += 0.5 * (high - low).max(0.0);
        }
        at_top.sort_by(f64::total_cmp);
        high = events().map(|event| event.h).fold(high, f64::max);
        for id in events().filter(|event| event.l > 0.7 * last).flat_map(|event| &event.curves) {
            let curve = self.curves().find(|curve| curve.id == *id)?;
            high = self.heights_below(curve, top)?.map_or(high, |[_, h]| high.max(h));
        }
        if let (Some(&median), Some(&largest)) = (at_top.get(at_top.len() / 2), at_top.last()) {
            let without_events = largest.min(4.0 * median.abs());
            high = high.max(median).max(if last > 0.0 { high } else { without_events });
        }
        let margin = 0.05 * (high - low);
        Some(WindowDocument { h: [low - margin, high + margin], l: [0.0, top] })
    }

    /// All but the pole lines that run on critical lines.
    fn curves(&self) -> impl Iterator<Item = &CurveDocument> {
        let line = |curve: &CurveDocument| matches!(curve.kind, CurveKind::PolePlus | CurveKind::PoleMinus);
        self.document.curves.iter().filter(move |curve| !line(curve) || curve.coincides_with.is_empty())
    }

    /// Heights at both ends of the part of a curve up to an l, if it begins there; an outer `None` if they are not known.
    #[allow(clippy::option_option)]
    fn heights_below(&self, curve: &CurveDocument, top: f64) -> Option<Option<[f64; 2]>> {
        let from = curve.l_range[0]?;
        let to = curve.l_range[1].unwrap_or(f64::INFINITY).min(top);
        if from > to {
            return Some(None);
        }
        let height = |l: f64| Some(self.plane.height(&curve.id, l)?[0]);
        Some(Some([height(from)?, height(to)?]))
    }

    /// The curves that are lowest at l = 0; `None` alone if none begins there.
    fn lowest(&self) -> Option<Vec<Option<&CurveDocument>>> {
        let beginning = self.curves().filter(|curve| curve.l_range[0] == Some(0.0));
        let starts = beginning.map(|curve| Some((curve, self.plane.height(&curve.id, 0.0)?)));
        let starts: Vec<(&CurveDocument, [f64; 2])> = starts.collect::<Option<_>>()?;
        let least = starts.iter().map(|(_, [h, _])| *h).fold(f64::INFINITY, f64::min);
        let lowest = starts.into_iter().filter(|(_, [h, room])| h - least <= *room).map(|(curve, _)| Some(curve));
        let lowest: Vec<_> = lowest.collect();
        Some(if lowest.is_empty() { vec![None] } else { lowest })
    }

    /// The l at which the lowest curve from l = 0 reaches h = 0, at most `top`; 0 where it starts there.
    fn start_of_positive_energies(&self, lowest: Option<&CurveDocument>, top: f64) -> Option<f64> {
        let Some(curve) = lowest else { return Some(0.0) };
        let end = curve.l_range[1].unwrap_or(f64::INFINITY).min(top);
        let is_negative = |l: f64| Some(self.plane.height(&curve.id, l)?[0] < 0.0);
        if is_negative(end)? {
            return Some(0.0);
        }
        let (mut below, mut above) = (0.0, end);
        for _ in 0..30 {
            let middle = 0.5 * (below + above);
            if is_negative(middle)? { below = middle } else { above = middle }
        }
        Some(above)
    }
}
