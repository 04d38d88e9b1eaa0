//! The events of the diagrams along a way through the bodies: each followed from where it comes into being to where it ends.

use bifdiag_diagram::class::{Class, ClassName};

use crate::border::{
    BodySegment, Border, BorderEvent, BorderEventKind, BorderOptions, EventLabel, NamedEvent, all, class_of,
    named_events, special,
};
use crate::parallel::each;

/// A place of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EventPoint {
    /// Where on the way.
    pub t: f64,
    /// Energy, in the body's units.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
}

/// An event along the way.
#[derive(Clone, Debug, PartialEq)]
pub struct EventTrack {
    /// What meets.
    pub label: EventLabel,
    /// Its places, by rising t.
    pub points: Vec<EventPoint>,
    /// The numbers of the borders at which it begins and ends; none where it does at an end of the way.
    pub between: [Option<usize>; 2],
}

/// A part of the way between two borders.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Its ends.
    pub t: [f64; 2],
    /// The class; none where no body in it has one.
    pub class: Option<ClassName>,
    /// The number of regions.
    pub regions: usize,
}

/// The events along a way, and where the class changes.
#[derive(Clone, Debug, PartialEq)]
pub struct EventTracks {
    /// The borders, in order, and the special bodies between bodies of one class.
    pub borders: Vec<Border>,
    /// What lies between them.
    pub stretches: Vec<Stretch>,
    /// The events, by their labels.
    pub tracks: Vec<EventTrack>,
    /// Bodies in equal steps.
    pub bodies: usize,
    /// Those of them that are special, on a border, undecided, or of another class than their stretch. Neighbouring
    /// bodies were examined instead.
    pub passed: usize,
}

/// What a body shows.
struct Seen {
    t: f64,
    class: Class,
    events: Vec<NamedEvent>,
}

/// How far from a special or undecided body, or one on a border, its replacements are, in steps.
const BESIDE: f64 = 1e-3;
/// How far beside a special body borders are sought, in steps.
const NEAREST: f64 = 1e-6;

/// Follows the events over a number of bodies, in equal steps from one end of the path to the other. Borders are sought
/// between neighbours of different classes: two within one step, back to the same class, are not seen, nor is one that
/// is nearer to a special body than a millionth of a step.
#[must_use]
pub fn follow(segment: &BodySegment, bodies: usize, options: &BorderOptions) -> EventTracks {
    let bodies = bodies.max(2);
    let step = 1.0 / (bodies - 1) as f64;
    let places: Vec<f64> = (0..bodies).map(|k| k as f64 / (bodies - 1) as f64).collect();
    let look = |places: &[f64]| -> Vec<Seen> {
        let seen = each(places, |&t| {
            let (atlas, class) = class_of(&segment.body(t), options.accuracy).ok()?;
            Some(Seen { t, class, events: named_events(&atlas) })
        });
        seen.into_iter().flatten().collect()
    };
    let beside =
        |t: f64, steps: f64| [t - steps * step, t + steps * step].into_iter().filter(|t| (0.0..=1.0).contains(t));
    let add = |seen: &mut Vec<Seen>, places: &[f64]| {
        seen.extend(look(places));
        seen.sort_by(|p, q| p.t.total_cmp(&q.t));
    };
    let seek = |seen: &[Seen]| -> Vec<Border> {
        let pairs: Vec<&[Seen]> = seen.windows(2).collect();
        each(&pairs, |pair| between(segment, pair, options)).into_iter().flatten().collect()
    };
    // More special than its neighbours, a body has a class of its own: those on both sides are examined instead, one at
    // an end of the path, so that borders are sought up to it.
    let (special, others): (Vec<f64>, Vec<f64>) =
        places.iter().copied().partition(|&t| special(segment, [t, t]).is_some());
    let mut seen = look(&others);
    let decided: Vec<f64> = seen.iter().map(|body| body.t).collect();
    let undecided = others.iter().filter(|t| decided.binary_search_by(|decided| decided.total_cmp(t)).is_err());
    let in_place = undecided.chain(&special).flat_map(|t| beside(*t, BESIDE));
    let nearest: Vec<f64> = special.iter().flat_map(|t| beside(*t, NEAREST)).collect();
    add(&mut seen, &in_place.chain(nearest.iter().copied()).collect::<Vec<f64>>());
    let mut borders = seek(&seen);
    // So is a body on a border, which belongs to neither side.
    let is_on_border = |body: &Seen| borders.iter().any(|border| is_at(border, body.t));
    let in_place: Vec<f64> =
        seen.iter().filter(|body| is_on_border(body)).flat_map(|body| beside(body.t, BESIDE)).collect();
    if !in_place.is_empty() {
        seen.retain(|body| !is_on_border(body));
        add(&mut seen, &in_place);
        borders = seek(&seen);
    }
    // There events may be nearly at infinity.
    seen.retain(|body| !nearest.contains(&body.t));
    let ends: Vec<f64> = [0.0].into_iter().chain(borders.iter().map(|border| border.t)).chain([1.0]).collect();
    let is_inside = |t: &[f64], body: &Seen| {
        let is_end = (body.t == 0.0 && t[0] == 0.0) || (body.t == 1.0 && t[1] == 1.0);
        (t[0] < body.t && body.t < t[1]) || is_end
    };
    // Every stretch shows its events, however short it is.
    let is_empty = |t: &&[f64]| t[0] < t[1] && !seen.iter().any(|body| is_inside(t, body));
    let middles: Vec<f64> = ends.windows(2).filter(is_empty).map(|t| 0.5 * (t[0] + t[1])).collect();
    add(&mut seen, &middles);
    let mut found = EventTracks { stretches: Vec::new(), tracks: Vec::new(), bodies, passed: 0, borders };
    let is_asked = |body: &&Seen| places.binary_search_by(|place| place.total_cmp(&body.t)).is_ok();
    let mut shown = 0;
    for (number, pair) in ends.windows(2).enumerate() {
        let t = [pair[0], pair[1]];
        let inside: Vec<&Seen> = seen.iter().filter(|body| is_inside(pair, body)).collect();
        // The body farthest from the borders gives the class; if the middle one is undecided, the border below does.
        let below = number.checked_sub(1).and_then(|below| found.borders.get(below)).map(|border| &border.classes[1]);
        let far = |body: &Seen| (body.t - t[0]).min(t[1] - body.t);
        let inner = inside.iter().max_by(|p, q| far(p).total_cmp(&far(q)));
        let class = inner.map(|body| &body.class).or(below).cloned();
        let own: Vec<&Seen> = inside
            .into_iter()
            .filter(|body| class.as_ref().is_some_and(|class| class.name() == body.class.name()))
            .collect();
        let joins = number == 0 || !breaks(&found.borders[number - 1].event.kind);
        shown += own.iter().filter(|body| is_asked(body)).count();
        add_bodies(&mut found.tracks, &own, number, joins);
        let regions = class.as_ref().map_or(0, Class::regions);
        found.stretches.push(Stretch { t, class: class.map(|class| class.name().clone()), regions });
    }
    found.passed = found.bodies - shown;
    let last = found.borders.len();
    for track in &mut found.tracks {
        track.between[1] = track.between[1].filter(|border| *border < last);
    }
    found.tracks.sort_by_key(|track| track.label);
    found
}

/// What lies between two neighbours: the borders, or a special body with one class on both sides.
fn between(segment: &BodySegment, pair: &[Seen], options: &BorderOptions) -> Vec<Border> {
    let [from, to] = [0, 1].map(|side| pair[side].t);
    let classes = [0, 1].map(|side| pair[side].class.clone());
    let mut borders = Vec::new();
    if classes[0].name() != classes[1].name() {
        let step = BodySegment::new(segment.body(from), segment.body(to));
        borders.extend(all(&step, options).into_iter().map(|border| border.on_the_whole([from, to])));
    }
    let special = special(segment, [from, to]);
    if let Some((body, root)) = special
        && !borders.iter().any(|border| (border.t - root.t).abs() <= border.error + root.error + f64::EPSILON)
    {
        let event =
            BorderEvent { kind: body.kind(), curves: Vec::new(), place: None, vanish: Vec::new(), appear: Vec::new() };
        let at = borders.partition_point(|border| border.t < root.t);
        // The classes beside it are those of the borders around it.
        let below = at.checked_sub(1).map_or(&classes[0], |below| &borders[below].classes[1]);
        let above = borders.get(at).map_or(&classes[1], |above| &above.classes[0]);
        let classes = [below.clone(), above.clone()];
        let border =
            Border { enclosure: [from, to], t: root.t, error: root.error, classes, reached: true, event, atlases: 0 };
        borders.insert(at, border);
    }
    borders
}

/// Whether a place is that of a border, within its known error.
fn is_at(border: &Border, t: f64) -> bool {
    (border.t - t).abs() <= border.error + f64::EPSILON
}

/// Whether no event continues: where moments are equal the axes change their order and events go to infinity, and
/// without weight there are no events.
fn breaks(kind: &BorderEventKind) -> bool {
    matches!(kind, BorderEventKind::MomentsEqual { .. } | BorderEventKind::WeightVanishes)
}

/// Adds the bodies of a stretch. Events of one label follow each other by their momenta; those that reach the border
/// before the stretch continue if it `joins` them.
fn add_bodies(tracks: &mut Vec<EventTrack>, bodies: &[&Seen], number: usize, joins: bool) {
    let mut labels: Vec<EventLabel> =
        bodies.iter().flat_map(|body| body.events.iter().map(|event| event.label)).collect();
    labels.sort();
    labels.dedup();
    for label in labels {
        let mut runs: Vec<Vec<EventPoint>> = Vec::new();
        for body in bodies {
            let mut own: Vec<EventPoint> = body
                .events
                .iter()
                .filter(|event| event.label == label)
                .map(|event| EventPoint { t: body.t, h: event.h, l: event.l })
                .collect();
            own.sort_by(|p, q| p.l.total_cmp(&q.l));
            runs.resize_with(runs.len().max(own.len()), Vec::new);
            for (run, point) in runs.iter_mut().zip(own) {
                run.push(point);
            }
        }
        join(tracks, label, runs, number, joins);
    }
}

/// Continues the events of this label that reach the border before a stretch, the nearest first, and begins the others.
fn join(tracks: &mut Vec<EventTrack>, label: EventLabel, mut runs: Vec<Vec<EventPoint>>, number: usize, joins: bool) {
    let before = number.checked_sub(1);
    let reaches = |track: &EventTrack| joins && track.label == label && before.is_some() && track.between[1] == before;
    loop {
        let open = tracks.iter().enumerate().filter(|(_, track)| reaches(track));
        let pairs = open.flat_map(|(track, old)| {
            let last = old.points.last().map_or(f64::INFINITY, |point| point.l);
            let gap = move |run: &Vec<EventPoint>| run.first().map_or(f64::INFINITY, |point| (point.l - last).abs());
            runs.iter().enumerate().map(move |(place, run)| (gap(run), track, place))
        });
        let Some((_, track, place)) = pairs.min_by(|p, q| p.0.total_cmp(&q.0)) else { break };
        tracks[track].points.extend(runs.remove(place));
        tracks[track].between[1] = Some(number);
    }
    tracks.extend(runs.into_iter().map(|points| EventTrack { label, points, between: [before, Some(number)] }));
}

#[cfg(test)]
mod tests {
    use bifdiag_body::Body;

    use super::*;

    fn way(from: [&str; 6], to: [&str; 6]) -> BodySegment {
        let body = |x: [&str; 6]| Body::parse(&x[..3], &x[3..]).unwrap();
        BodySegment::new(body(from), body(to))
    }

    fn of<'a>(found: &'a EventTracks, name: &str) -> Vec<&'a EventTrack> {
        found.tracks.iter().filter(|track| track.label.to_string() == name).collect()
    }

    /// From Lagrange's to Kovalevskaya's top, A = (2, η, 1), r = (1, 0, 0): the cusp of S2 is at the pitchfork at η = 3/2, and
    /// both momenta are known.
    #[test]
    fn the_cusp_of_a_pair_ends_at_its_pitchfork() {
        let segment = way(["2", "1.05", "1", "1", "0", "0"], ["2", "1.9", "1", "1", "0", "0"]);
        let found = follow(&segment, 35, &BorderOptions::default());
        let value = |t: f64| segment.value(1, t);
        let borders: Vec<f64> = found.borders.iter().map(|border| value(border.t)).collect();
        assert_eq!(borders.len(), 2);
        assert!((borders[0] - 10.0 / 9.0).abs() < 1e-9 && (borders[1] - 1.5).abs() < 1e-9, "{borders:?}");
        // One of the bodies is that at 3/2.
        assert_eq!((found.stretches.len(), found.bodies, found.passed), (3, 35, 1));
        let [cusp] = of(&found, "cusp of S2")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!(cusp.between, [None, Some(1)]);
        let [pitchfork] = of(&found, "pitchfork of L- and S2")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!(pitchfork.between, [None, None]);
        // The upright axis turns with ω = 1/√(A1 − A2) there: l = A1 ω.
        for point in &pitchfork.points {
            let expected = 2.0 / (2.0 - value(point.t)).sqrt();
            assert!((point.l - expected).abs() < 1e-9, "{point:?} {expected}");
        }
    }

    /// A1 passes A2 = 1.7, where the cusp of G1 goes to infinity, with one class on both sides.
    #[test]
    fn a_cusp_that_goes_to_infinity_ends_where_moments_are_equal() {
        let segment = way(["1", "1.7", "2.4", "0.4", "0.2", "0.9"], ["2.4", "1.7", "2.4", "0.4", "0.2", "0.9"]);
        let found = follow(&segment, 81, &BorderOptions::default());
        let at = found.borders.iter().position(|border| border.t == 0.5).unwrap();
        assert_eq!(found.borders[at].event.kind.to_string(), "the moments A1 and A2 are equal there");
        let cusps = of(&found, "cusp of G1");
        assert!(
            cusps.iter().any(|cusp| cusp.between[1] == Some(at))
                && cusps.iter().any(|cusp| cusp.between[0] == Some(at))
        );
        // The body with A1 = A2 itself, and that with A1 = A3 at the end.
        assert_eq!(found.passed, 2);
    }

    /// Classes come back along the way: no border is lost, and every body shows the class that it has.
    #[test]
    fn classes_that_come_back_are_seen() {
        let segment = way(["0.4", "1", "0.7", "0.9", "0.3", "0.5"], ["1.5", "1", "0.7", "0.9", "0.3", "0.5"]);
        let found = follow(&segment, 240, &BorderOptions::default());
        assert_eq!(found.passed, 0);
        let value = |t: f64| segment.value(0, t);
        let borders: Vec<f64> = found.borders.iter().map(|border| value(border.t)).collect();
        for known in [2.0 / 3.0, 0.685_678, 0.7, 1.0] {
            assert!(borders.iter().any(|border| (border - known).abs() < 1e-6), "{known}: {borders:?}");
        }
        for stretch in &found.stretches {
            let (_, class) = class_of(&segment.body(0.5 * (stretch.t[0] + stretch.t[1])), options().accuracy).unwrap();
            assert_eq!(stretch.class.as_ref(), Some(class.name()), "{stretch:?}");
        }
    }

    /// Three bodies, none of which lies between the borders 10/9 and 3/2: events continue through the gap.
    #[test]
    fn short_stretches_are_looked_into() {
        let segment = way(["2", "1.05", "1", "1", "0", "0"], ["2", "1.95", "1", "1", "0", "0"]);
        let found = follow(&segment, 2, &options());
        assert_eq!((found.stretches.len(), found.bodies, found.passed), (3, 2, 0));
        assert!(found.stretches.iter().all(|stretch| stretch.regions > 4));
        let [pitchfork] = of(&found, "pitchfork of L- and S3")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!((pitchfork.between, pitchfork.points.len()), ([None, None], 3));
        let [crossing] = of(&found, "crossing of S2 and S3")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!(crossing.between, [None, Some(0)]);
    }

    /// A sampled body lies on a border: it belongs to neither side, and those beyond it are seen.
    #[test]
    fn a_body_on_a_border_is_left_out() {
        let end = |a2: &'static str| ["2", a2, "1", "1", "0", "0"];
        // The cusp of S2 is at its pitchfork at 10/9 and 3/2.
        let segment = way(end("1"), end("2"));
        let found = follow(&segment, 19, &options());
        let on_border = |body: &f64| found.borders.iter().any(|border| (border.t - body).abs() < 1e-9);
        let bodies: Vec<f64> = (0..19).map(|k| f64::from(k) / 18.0).collect();
        let left_out = bodies.iter().filter(|body| on_border(body)).count();
        assert_eq!(left_out, 2);
        assert!(found.borders.windows(2).all(|pair| pair[0].t < pair[1].t), "{:?}", found.borders);
        // Both ends have equal moments.
        assert_eq!(found.passed, left_out + 2);
        let [pitchfork] = of(&found, "pitchfork of L- and S2")[..] else { panic!("{:?}", found.tracks) };
        // Two next to each body on a border, one next to each end.
        assert_eq!(pitchfork.points.len(), found.bodies - found.passed + 2 * left_out + 2);
    }

    /// A = (3, A2, 1), r = (0.3, 0.4, 0.5): the class changes at A2 = 2.0658, and both A2 = 1 and A2 = 3 are special.
    #[test]
    fn borders_beside_a_special_end_are_found() {
        let end = |a2: &'static str| ["3", a2, "1", "0.3", "0.4", "0.5"];
        for (from, bodies, passed) in [("2", 2, 1), ("2.0655", 2, 1), ("1", 3, 2), ("1", 2, 2)] {
            let segment = way(end(from), end("3"));
            let found = follow(&segment, bodies, &options());
            assert_eq!((found.bodies, found.passed), (bodies, passed), "from {from}");
            let value = |t: f64| segment.value(1, t);
            let last = found.borders.last().unwrap();
            assert!((value(last.t) - 2.065_799).abs() < 1e-5, "from {from}: {}", value(last.t));
            let ends = of(&found, "crossing of G2 and P+").into_iter().filter_map(|track| track.points.last());
            assert!(ends.into_iter().all(|point| point.t < last.t), "from {from}: {:?}", found.tracks);
        }
        // A = (5, 4, 3), r = (1, 0.2, r3): a border at r3 = 8.378e-6, between the special body r3 = 0 and the next.
        let end = |r3: &'static str| ["5", "4", "3", "1", "0.2", r3];
        let segment = way(end("0"), end("0.00003"));
        let found = follow(&segment, 3, &options());
        let borders: Vec<f64> = found.borders.iter().map(|border| segment.value(5, border.t)).collect();
        assert!(borders.iter().any(|border| (border - 8.378_03e-6).abs() < 1e-10), "{borders:?}");
        // In the middle of a way, a special body leaves two steps.
        let segment = way(end("-0.000016"), end("0.000016"));
        let found = follow(&segment, 3, &options());
        let borders: Vec<f64> = found.borders.iter().map(|border| segment.value(5, border.t)).collect();
        let [left, zero, right] = borders[..] else { panic!("{borders:?}") };
        assert!(
            (left + right).abs() < 1e-10 && zero.abs() < 1e-15 && (right - 8.378_03e-6).abs() < 1e-10,
            "{borders:?}"
        );
    }

    /// The border r2 = 0.03654 of the paper's body and its mirror image, with r2 = 0 between them.
    #[test]
    fn mirror_images_have_the_same_borders() {
        let end = |r2: &'static str| ["2", "1.1", "1", "0.94868", r2, "0.61623"];
        let segment = way(end("-0.4"), end("0.3"));
        let found = follow(&segment, 71, &options());
        let borders: Vec<f64> = found.borders.iter().map(|border| segment.value(4, border.t)).collect();
        let [left, zero, right] = borders[..] else { panic!("{borders:?}") };
        assert!((left + right).abs() < 1e-9 && zero.abs() < 1e-12 && (right - 0.03654).abs() < 1e-5, "{borders:?}");
        assert_eq!(found.stretches[0].class, found.stretches[3].class);
        assert_eq!(found.stretches[1].class, found.stretches[2].class);
        assert_ne!(found.stretches[0].class, found.stretches[1].class);
    }

    fn options() -> BorderOptions {
        BorderOptions::default()
    }
}
