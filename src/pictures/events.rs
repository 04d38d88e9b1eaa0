//! The picture of the events along a way through the bodies: their momenta over the parameter, above the classes.

use bifdiag_body::Body;
use bifdiag_numbers::decimal::{all_apart, significant};
use bifdiag_plot::{Map, MapAxis, MapLine, MapNote};
use bifdiag_schema::BodyParameter;
use bifdiag_survey::border::{BodySegment, EventLabel};
use bifdiag_survey::events::{EventTrack, EventTracks, Stretch};
use bifdiag_survey::subdivision::Subdivision;

use super::existence::Existence;
use super::map::{Counted, areas, counted_by, entries, is_rounded, share};
use super::shown::{Seen, Shown, Shows};

/// Digits of the value of a parameter at a border.
const DIGITS: usize = 6;
/// Bodies sampled to find where some exist.
const LOOKS: u32 = 64;
/// Numbers of borders are at least this fraction of the width apart.
const APART: f64 = 0.025;
/// Their distance below the upper edge.
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
    let existence = scene.existence();
    let strip = |stretch: &Stretch| {
        let [from, to] = stretch.t.map(value);
        (shown(stretch), existence.possible(&[[from, l[0]], [to, l[0]], [to, l[1]], [from, l[1]]]))
    };
    // Where no body exists nothing is painted.
    let pieces: Vec<_> = tracks.stretches.iter().map(strip).filter(|(_, corners)| corners.len() > 2).collect();
    let impossible = existence.impossible([range, *l]);
    let strips = Subdivision { pieces, seen: Vec::new(), borders: Vec::new() };
    let order = counted_by(&[], Some(&strips), Shown::Class);
    let entry = |shown: &Option<Shows>| order.iter().position(|counted| Some(counted.shows) == shown.as_ref());
    let mut map = Map {
        title: format!("Events over {name}"),
        subtitle: format!("{}; colours: class; lines: momenta l of the events", scene.bodies()),
        x: MapAxis { name: name.to_owned(), range },
        y: MapAxis { name: "l".to_owned(), range: *l },
        entries: entries(&order, usize::MAX),
        ordered: false,
        unknown: "class not decided".to_owned(),
        bodies: areas(&strips, entry, Shown::Class),
        key: key(&order, impossible.is_empty()),
        impossible,
        lines: scene.lines(),
        notes: Vec::new(),
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
        let triple = |name: &str, first: usize, values: [f64; 3]| {
            let is_rounded = |(place, value): (usize, f64)| place != self.parameter.place() && is_rounded(value);
            let number = |(place, value): (usize, f64)| {
                if place == self.parameter.place() {
                    self.parameter.name().to_owned()
                } else {
                    significant(value, DIGITS)
                }
            };
            let numbered = || (first..).zip(values);
            let sign = if numbered().any(is_rounded) { "≈" } else { "=" };
            format!("{name} {sign} ({})", numbered().map(number).collect::<Vec<_>>().join(", "))
        };
        format!("{}, {}", triple("A", 0, body.moments_f64()), triple("r", 3, body.center_f64()))
    }

    fn existence(&self) -> Existence {
        let seen = |k: u32| {
            let body: Body = self.segment.body(f64::from(k) / f64::from(LOOKS));
            let values = [body.moments_f64(), body.center_f64()];
            Seen { at: [values.as_flattened()[self.parameter.place()], 0.0], values, shows: None }
        };
        Existence::over(&(0..=LOOKS).map(seen).collect::<Vec<_>>(), [self.parameter; 2])
    }

    /// The events; of those with one name the longest bears it.
    fn lines(&self) -> Vec<MapLine> {
        let mut lines = Vec::new();
        for same in self.tracks.tracks.chunk_by(|p, q| p.label == q.label) {
            let longest = (0..same.len()).max_by_key(|&place| same[place].points.len());
            lines.extend(same.iter().enumerate().map(|(place, track)| self.line(track, longest == Some(place))));
        }
        lines
    }

    fn line(&self, track: &EventTrack, is_named: bool) -> MapLine {
        let (hue, kind) = match track.label {
            EventLabel::Pitchfork(_) => (1, "pitchfork"),
            EventLabel::Cusp(_) => (2, "cusp"),
            EventLabel::Crossing(_) => (3, "crossing"),
        };
        MapLine {
            points: track.points.iter().map(|point| [self.value(point.t), point.l]).collect(),
            dashed: false,
            hue,
            text: format!("momentum of a {kind}"),
            name: if is_named { track.label.to_string().replace('-', "−") } else { String::new() },
        }
    }

    /// The borders with their numbers, which the legend explains.
    fn add_borders(&self, map: &mut Map) {
        let [from, to] = map.y.range;
        let mut last = f64::NEG_INFINITY;
        let places: Vec<f64> = self.tracks.borders.iter().map(|border| self.value(border.t)).collect();
        let texts = all_apart(&places, DIGITS);
        for ((number, border), value) in (1..).zip(&self.tracks.borders).zip(texts) {
            let at = self.value(border.t);
            let text = format!("{number}: {} = {value}: {}", self.parameter, border.event.kind);
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

/// The classes by their numbers in the picture, under a heading; empty without classes. Shares are of the whole range, or of
/// the part of it in which bodies exist.
fn key(order: &[Counted<'_>], is_whole: bool) -> Vec<Vec<String>> {
    if order.is_empty() {
        return Vec::new();
    }
    let share_of = if is_whole { "share of the range" } else { "share of the range in which bodies exist" };
    let heading = ["number", "class", "regions", share_of].map(str::to_owned).to_vec();
    let row = |(number, counted): (usize, &Counted<'_>)| {
        let regions = match counted.shows {
            Shows::Class(_, regions) | Shows::Count(regions) => regions,
        };
        vec![(number + 1).to_string(), counted.shows.to_string(), regions.to_string(), share(counted.part)]
    };
    [heading].into_iter().chain(order.iter().enumerate().map(row)).collect()
}
