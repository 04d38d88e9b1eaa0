//! The events of the diagrams along a way through the bodies: each followed from where it comes into being to where it ends.

use bifdiag_diagram::class::ClassName;

use crate::border::{BodySegment, Border, BorderOptions, EventLabel, NamedEvent, all, class_of, named_events};
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

/// A part of the way on which the class is the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Its ends.
    pub t: [f64; 2],
    /// The class; none where the body at its middle has none.
    pub class: Option<ClassName>,
    /// The number of regions.
    pub regions: usize,
}

/// The events along a way, and where the class changes.
#[derive(Clone, Debug, PartialEq)]
pub struct EventTracks {
    /// The borders, in order.
    pub borders: Vec<Border>,
    /// What lies between them.
    pub stretches: Vec<Stretch>,
    /// The events, by their labels.
    pub tracks: Vec<EventTrack>,
    /// Bodies that were looked at.
    pub bodies: usize,
    /// Those of them that have another class than their stretch, or none: special bodies, and undecided ones beside borders.
    pub passed: usize,
}

/// What a body shows.
struct Seen {
    t: f64,
    class: ClassName,
    regions: usize,
    events: Vec<NamedEvent>,
}

/// Follows the events over so many bodies, in equal steps between the ends of the way.
#[must_use]
pub fn follow(segment: &BodySegment, bodies: usize, options: &BorderOptions) -> EventTracks {
    let mut borders = all(segment, options);
    // A special body at an end of the way has a class of its own.
    borders.retain(|border| border.t > border.error && border.t < 1.0 - border.error);
    let places: Vec<f64> = (0..bodies).map(|k| (k as f64 + 0.5) / bodies as f64).collect();
    let seen = each(&places, |&t| {
        let (atlas, class) = class_of(&segment.body(t), options.accuracy).ok()?;
        let events = named_events(&atlas);
        Some(Seen { t, class: class.name().clone(), regions: class.regions(), events })
    });
    let ends: Vec<f64> = [0.0].into_iter().chain(borders.iter().map(|border| border.t)).chain([1.0]).collect();
    let mut found =
        EventTracks { stretches: Vec::with_capacity(ends.len()), tracks: Vec::new(), bodies, passed: 0, borders };
    for (number, pair) in ends.windows(2).enumerate() {
        let t = [pair[0], pair[1]];
        let inside = seen.iter().flatten().filter(|body| t[0] < body.t && body.t < t[1]);
        // Borders know what lies beside them; without one, the first body that has a class does.
        let beside = match (found.borders.get(number), number.checked_sub(1).and_then(|n| found.borders.get(n))) {
            (Some(above), _) => Some(above.classes[0].name().clone()),
            (None, Some(below)) => Some(below.classes[1].name().clone()),
            (None, None) => inside.clone().map(|body| body.class.clone()).next(),
        };
        let own: Vec<&Seen> = inside.filter(|body| Some(&body.class) == beside.as_ref()).collect();
        let regions = own.first().map_or(0, |body| body.regions);
        add(&mut found.tracks, &own, number);
        found.stretches.push(Stretch { t, class: beside, regions });
        found.passed += own.len();
    }
    // So many bodies belong to no stretch.
    found.passed = bodies - found.passed;
    let last = found.borders.len();
    for track in &mut found.tracks {
        track.between[1] = track.between[1].filter(|border| *border < last);
    }
    found.tracks.sort_by_key(|track| track.label);
    found
}

/// Adds the bodies of a stretch. Events of one label follow each other by their momenta; those that cross the border before the
/// stretch go on.
fn add(tracks: &mut Vec<EventTrack>, bodies: &[&Seen], number: usize) {
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
        for points in runs {
            go_on(tracks, label, points, number);
        }
    }
}

/// Continues the nearest event of this label that reaches the border before a stretch, or begins another one.
fn go_on(tracks: &mut Vec<EventTrack>, label: EventLabel, points: Vec<EventPoint>, number: usize) {
    let Some(first) = points.first().copied() else { return };
    let before = number.checked_sub(1);
    let gap = |track: &EventTrack| track.points.last().map_or(f64::INFINITY, |last| (last.l - first.l).abs());
    let reaches = |track: &&mut EventTrack| track.label == label && before.is_some() && track.between[1] == before;
    match tracks.iter_mut().filter(reaches).min_by(|p, q| gap(p).total_cmp(&gap(q))) {
        Some(track) => {
            track.points.extend(points);
            track.between[1] = Some(number);
        }
        None => tracks.push(EventTrack { label, points, between: [before, Some(number)] }),
    }
}

#[cfg(test)]
mod tests {
    use bifdiag_body::Body;

    use super::*;

    /// From Lagrange's to Kovalevskaya's top, A = (2, η, 1), r = (1, 0, 0): the cusp of S2 is at the pitchfork at η = 3/2, and
    /// both momenta are known.
    #[test]
    fn the_cusp_of_a_pair_ends_at_its_pitchfork() {
        let body = |eta: &str| Body::parse(&["2", eta, "1"], &["1", "0", "0"]).unwrap();
        let segment = BodySegment::new(body("1.05"), body("1.9"));
        let found = follow(&segment, 34, &BorderOptions::default());
        let value = |t: f64| segment.coordinate(1, t).to_f64().value();
        let borders: Vec<f64> = found.borders.iter().map(|border| value(border.t)).collect();
        assert!((borders[0] - 10.0 / 9.0).abs() < 1e-9 && (borders[1] - 1.5).abs() < 1e-9, "{borders:?}");
        assert_eq!((found.stretches.len(), found.passed), (3, 0));
        let of = |name: &str| found.tracks.iter().filter(|track| track.label.to_string() == name).collect::<Vec<_>>();
        let [cusp] = of("cusp of S2")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!(cusp.between, [None, Some(1)]);
        let [pitchfork] = of("pitchfork of L- and S2")[..] else { panic!("{:?}", found.tracks) };
        assert_eq!(pitchfork.between, [None, None]);
        // On the upright axis p² = J1 − J2 in ω = 1/√(A1 − A2): l = A1 ω.
        for point in &pitchfork.points {
            let expected = 2.0 / (2.0 - value(point.t)).sqrt();
            assert!((point.l - expected).abs() < 1e-9, "{point:?} {expected}");
        }
    }
}
