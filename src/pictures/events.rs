//! The picture of the events along a way through the bodies: their momenta over the parameter, above the classes.

use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_numbers::decimal::significant;
use bifdiag_plot::{Map, MapAxis, MapBodies, MapLine, MapNote};
use bifdiag_schema::BodyParameter;
use bifdiag_survey::border::{BodySegment, EventLabel};
use bifdiag_survey::events::{EventTrack, EventTracks, Stretch};

use super::existence::Existence;
use super::map::{Counted, area, entries, share};
use super::shown::{Seen, Shows};

/// Digits of the value of a parameter at a border.
const DIGITS: usize = 6;
/// Bodies that tell where some exist.
const LOOKS: u32 = 64;
/// Numbers of borders stand apart by this part of the width.
const APART: f64 = 0.025;
/// Where they stand, below the upper edge.
const BELOW: f64 = 0.04;

/// A way on which one parameter varies, with what was found on it.
pub struct EventScene<'a> {
    /// What was found.
    pub tracks: &'a EventTracks,
    /// The way.
    pub segment: &'a BodySegment,
    /// The parameter.
    pub parameter: BodyParameter,
    /// The momenta that are shown.
    pub l: [f64; 2],
}

/// Momenta from 0 to where nearly all events lie: one that goes to infinity must not press the others together.
#[must_use]
pub fn momenta(tracks: &EventTracks) -> [f64; 2] {
    let mut all: Vec<f64> = tracks.tracks.iter().flat_map(|track| &track.points).map(|point| point.l).collect();
    all.sort_by(f64::total_cmp);
    let Some(most) = all.last() else { return [0.0, 1.0] };
    let usual = all[9 * (all.len() - 1) / 10];
    [0.0, 1.08 * most.min(1.5 * usual)]
}

/// The map of the events.
#[must_use]
pub fn events(scene: &EventScene<'_>) -> Map {
    let EventScene { tracks, l, .. } = scene;
    let value = |t: f64| scene.value(t);
    let range = [value(0.0), value(1.0)];
    let name = scene.parameter.name();
    let shown = |stretch: &Stretch| {
        let regions = u32::try_from(stretch.regions).unwrap_or(u32::MAX);
        stretch.class.clone().map(|class| Shows::Class(class, regions))
    };
    let shows: Vec<Option<Shows>> = tracks.stretches.iter().map(shown).collect();
    let existence = scene.existence();
    let strip = |stretch: &Stretch| {
        let [from, to] = stretch.t.map(value);
        existence.possible(&[[from, l[0]], [to, l[0]], [to, l[1]], [from, l[1]]])
    };
    let strips: Vec<Vec<[f64; 2]>> = tracks.stretches.iter().map(strip).collect();
    let all: f64 = strips.iter().map(|corners| area(corners)).sum();
    let mut parts: BTreeMap<&Shows, f64> = BTreeMap::new();
    for (corners, shown) in strips.iter().zip(&shows) {
        // Where no body exists nothing is painted.
        if let Some(shown) = shown.as_ref().filter(|_| corners.len() > 2) {
            *parts.entry(shown).or_default() += area(corners) / all;
        }
    }
    let mut order: Vec<Counted<'_>> =
        parts.into_iter().map(|(shows, part)| Counted { shows, part, at: None }).collect();
    order.sort_by(|p, q| q.part.total_cmp(&p.part).then_with(|| p.shows.cmp(q.shows)));
    let pieces = strips.iter().zip(&shows).map(|(corners, shown)| {
        let entry = shown.as_ref().and_then(|shown| order.iter().position(|counted| counted.shows == shown));
        (entry, corners.clone())
    });
    let pieces = pieces.filter(|(_, corners)| corners.len() > 2);
    let mut map = Map {
        title: format!("Events over {name}"),
        subtitle: format!("{}; colours: class; lines: momenta l of the events", scene.bodies()),
        x: MapAxis { name: name.to_owned(), range },
        y: MapAxis { name: "l".to_owned(), range: *l },
        entries: entries(&order, usize::MAX),
        ordered: false,
        unknown: "class not decided".to_owned(),
        bodies: MapBodies::Areas {
            pieces: pieces.collect(),
            seen: Vec::new(),
            borders: Vec::new(),
            told: String::new(),
        },
        impossible: existence.impossible([range, *l]),
        lines: scene.lines(),
        notes: Vec::new(),
        key: key(&order),
    };
    scene.add_borders(&mut map);
    map
}

impl EventScene<'_> {
    fn value(&self, t: f64) -> f64 {
        self.segment.value(self.parameter.place(), t)
    }

    /// A and r, with the name of the parameter in its place.
    fn bodies(&self) -> String {
        let body = self.segment.body(0.0);
        let number = |place: usize, value: f64| {
            if place == self.parameter.place() { self.parameter.name().to_owned() } else { significant(value, DIGITS) }
        };
        let values = [body.moments_f64(), body.center_f64()].as_flattened().to_vec();
        let text: Vec<String> = values.into_iter().enumerate().map(|(place, value)| number(place, value)).collect();
        format!("A = ({}), r = ({})", text[..3].join(", "), text[3..].join(", "))
    }

    fn existence(&self) -> Existence {
        let seen = |k: u32| {
            let body: Body = self.segment.body(f64::from(k) / f64::from(LOOKS));
            let values = [body.moments_f64(), body.center_f64()];
            Seen { at: [values.as_flattened()[self.parameter.place()], 0.0], values, shows: None }
        };
        Existence::over(&(0..=LOOKS).map(seen).collect::<Vec<_>>(), [self.parameter; 2])
    }

    /// The events; of the lines with one name the longest bears it.
    fn lines(&self) -> Vec<MapLine> {
        let mut lines = Vec::new();
        for same in self.tracks.tracks.chunk_by(|p, q| p.label == q.label) {
            let mut own: Vec<MapLine> = same.iter().flat_map(|track| self.lines_of(track)).collect();
            if let Some(longest) = own.iter_mut().max_by_key(|line| line.points.len()) {
                longest.name = same[0].label.to_string().replace('-', "−");
            }
            lines.append(&mut own);
        }
        lines
    }

    fn lines_of(&self, track: &EventTrack) -> Vec<MapLine> {
        let (hue, kind) = match track.label {
            EventLabel::Pitchfork(_) => (1, "pitchfork"),
            EventLabel::Cusp(_) => (2, "cusp"),
            EventLabel::Crossing(_) => (3, "crossing"),
        };
        let points: Vec<[f64; 2]> = track.points.iter().map(|point| [self.value(point.t), point.l]).collect();
        let text = format!("momentum of a {kind}");
        let line = |points| MapLine { points, dashed: false, hue, text: text.clone(), name: String::new() };
        within(&points, self.l).into_iter().map(line).collect()
    }

    /// The borders with their numbers, which the legend explains.
    fn add_borders(&self, map: &mut Map) {
        let [from, to] = map.y.range;
        let mut last = f64::NEG_INFINITY;
        for (number, border) in (1..).zip(&self.tracks.borders) {
            let at = self.value(border.t);
            let text = format!("{number}: {} = {}: {}", self.parameter, significant(at, DIGITS), border.event.kind);
            map.lines.push(MapLine {
                points: vec![[at, from], [at, to]],
                dashed: true,
                text: text.replace('-', "−"),
                ..MapLine::default()
            });
            if at - last > APART * (map.x.range[1] - map.x.range[0]) {
                let y = to - BELOW * (to - from);
                map.notes.push(MapNote { at: [at, y], text: number.to_string(), hue: 0, ring: false });
                last = at;
            }
        }
    }
}

/// The classes by their numbers in the picture, under a heading.
fn key(order: &[Counted<'_>]) -> Vec<Vec<String>> {
    let heading = ["number", "class", "regions", "share of the range"].map(str::to_owned).to_vec();
    let row = |(number, counted): (usize, &Counted<'_>)| {
        let regions = match counted.shows {
            Shows::Class(_, regions) | Shows::Count(regions) => regions,
        };
        vec![(number + 1).to_string(), counted.shows.to_string(), regions.to_string(), share(counted.part)]
    };
    [heading].into_iter().chain(order.iter().enumerate().map(row)).collect()
}

/// The parts of a line within a range of l, cut at its ends.
fn within(points: &[[f64; 2]], range: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let is_inside = |l: f64| range[0] <= l && l <= range[1];
    let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut part = Vec::new();
    for (place, &[x, l]) in points.iter().enumerate() {
        if let Some(&[last_x, last_l]) = place.checked_sub(1).and_then(|before| points.get(before)) {
            let mut ends: Vec<f64> = range.into_iter().filter(|end| (last_l < *end) != (l < *end)).collect();
            if l < last_l {
                ends.reverse();
            }
            for end in ends {
                part.push([last_x + (x - last_x) * (end - last_l) / (l - last_l), end]);
                // Left here, the range is entered again with a part of its own.
                if part.len() > 1 && !is_inside(l) {
                    parts.push(std::mem::take(&mut part));
                }
            }
        }
        if is_inside(l) {
            part.push([x, l]);
        } else {
            part.clear();
        }
    }
    parts.push(part);
    parts.retain(|part| part.len() > 1);
    parts
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn lines_reach_the_frame_and_end_there() {
        assert_eq!(within(&[[0.0, 1.0], [1.0, 3.0]], [0.0, 2.0]), [[[0.0, 1.0], [0.5, 2.0]]]);
        assert_eq!(within(&[[0.0, 4.0], [4.0, 0.0]], [1.0, 2.0]), [[[2.0, 2.0], [3.0, 1.0]]]);
        let over = within(&[[0.0, 1.0], [1.0, 3.0], [2.0, 1.0]], [0.0, 2.0]);
        assert_eq!(over, [[[0.0, 1.0], [0.5, 2.0]], [[1.5, 2.0], [2.0, 1.0]]]);
        assert_eq!(within(&[[0.0, 1e9], [1.0, 1e8]], [0.0, 2.0]), Vec::<Vec<[f64; 2]>>::new());
    }
}
