//! Atlases for drawing, from the closed form of the relative equilibria by means of their own: brute-force events and
//! cells glued by the order of the curves.

use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_plot::CurveSource;
use bifdiag_schema::CurveKind::{Axis, Generic, Pair, PoleMinus, PolePlus};
use bifdiag_schema::{
    Accuracy, AtlasDocument, BodyDocument, CellDocument, ComponentDocument, CurveDocument, CurveDrawing, CurveKind,
    Damped, DrawingDocument, EventDocument, EventKind, FrictionDocument, GivenBody, Head, MarginDocument,
    NonlinearDocument, NonlinearVerdict, Reason, RegionDocument, RegionDrawing, SCHEMA_VERSION, SampleDocument,
    Stability, StabilitySpan, SummaryDocument, TailDocument, ViewDocument, WindowDocument,
};

/// (h, l) by a parameter.
type Course = Box<dyn Fn(f64) -> [f64; 2]>;

/// A curve on which l rises with the parameter running from `ends[0]` to `ends[1]`.
pub struct Curve {
    id: &'static str,
    kind: CurveKind,
    branch: &'static str,
    index: Option<u8>,
    multiplicity: u32,
    coincides_with: Vec<String>,
    course: Course,
    ends: [f64; 2],
    /// Range of l; the upper end may be infinite.
    l: [f64; 2],
    tail: Option<TailDocument>,
}

impl Curve {
    fn h_at(&self, l: f64) -> f64 {
        let [mut low, mut high] = self.ends;
        for _ in 0..200 {
            let middle = low + (high - low) / 2.0;
            if middle == low || middle == high {
                break;
            }
            if (self.course)(middle)[1] < l {
                low = middle;
            } else {
                high = middle;
            }
        }
        (self.course)(high)[0]
    }

    fn reaches(&self, l: f64) -> bool {
        l >= self.l[0] && l <= self.l[1]
    }

    fn points(&self, from: f64, to: f64, tolerance: f64) -> Vec<[f64; 2]> {
        let (from, to) = (from.max(self.l[0]), to.min(self.l[1]));
        let mut points = vec![[self.h_at(from), from]];
        self.refine([self.h_at(from), from], [self.h_at(to), to], tolerance, 0, &mut points);
        points
    }

    fn refine(&self, a: [f64; 2], b: [f64; 2], tolerance: f64, level: u32, points: &mut Vec<[f64; 2]>) {
        let l = a[1] + (b[1] - a[1]) / 2.0;
        let h = self.h_at(l);
        if level < 12 && (level < 4 || (h - f64::midpoint(a[0], b[0])).abs() > tolerance) {
            self.refine(a, [h, l], tolerance, level + 1, points);
            self.refine([h, l], b, tolerance, level + 1, points);
        } else {
            points.push(b);
        }
    }
}

/// The curves of a body, as a source of dense polylines.
pub struct Fixture {
    pub curves: Vec<Curve>,
    pub atlas: AtlasDocument,
}

impl CurveSource for Fixture {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.curves.iter().find(|candidate| candidate.id == curve).map(|curve| curve.points(l[0], l[1], tolerance))
    }
}

fn generic(moments: [f64; 3], r: [f64; 3], mu_of: impl Fn(f64) -> f64 + 'static) -> Course {
    Box::new(move |t| {
        let mu = mu_of(t);
        let [mut p, mut q, mut rr] = [0.0; 3];
        for i in 0..3 {
            let d = mu - moments[i];
            if r[i] != 0.0 {
                p += r[i] * r[i] / (d * d);
                q += moments[i] * r[i] * r[i] / (d * d);
                rr += r[i] * r[i] / d;
            }
        }
        [(q / 2.0 - rr) / p.sqrt(), q / p.powf(0.75)]
    })
}

fn parabola(moment: f64, offset: f64) -> Course {
    Box::new(move |l| [l * l / (2.0 * moment) + offset, l])
}

/// The parameter of the least l between `from` and `to`.
fn least(course: &Course, from: f64, to: f64) -> f64 {
    let [mut a, mut b] = [from, to];
    for _ in 0..300 {
        let (u, v) = (a + (b - a) * 0.382, a + (b - a) * 0.618);
        if course(u)[1] < course(v)[1] { b = v } else { a = u }
    }
    a
}

/// A = (2, 1.1, 1), r = (0.94868, 0, 0.61623) and its nine regions.
pub fn paper() -> Fixture {
    let (moments, r): ([f64; 3], [f64; 3]) = ([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
    let length = (r[0] * r[0] + r[2] * r[2]).sqrt();
    let pole_moment = (2.0 * r[0] * r[0] + r[2] * r[2]) / (length * length);
    let inside = || generic(moments, r, |u: f64| 1.0 + 1.0 / (1.0 + (-u).exp()));
    // Over A2 = 1.1: l² = s(A − R/s²)², h = sA/2 − 3R/(2s).
    let r_hat = r[0] * r[0] / (1.1 - 2.0) + r[2] * r[2] / (1.1 - 1.0);
    let p_hat = (r[0] / 0.9).powi(2) + (r[2] / 0.1).powi(2);
    let pair: Course = Box::new(move |s| [0.55 * s - 1.5 * r_hat / s, s.sqrt() * (1.1 - r_hat / (s * s)).abs()]);
    let cusp = least(&inside(), -9.0, 9.0);
    let l_cusp = inside()(cusp)[1];
    let fork = -(9.0_f64).ln();
    let l_fork = inside()(fork)[1];
    let free = f64::INFINITY;
    let curve = |id, kind, branch, index, course, ends, l, tail: Option<(f64, f64)>| Curve {
        id,
        kind,
        branch,
        index,
        multiplicity: if kind == CurveKind::Pair { 2 } else { 1 },
        coincides_with: Vec::new(),
        course,
        ends,
        l,
        tail: tail.map(|(moment, h_offset)| TailDocument { moment, h_offset }),
    };
    let minimum = generic(moments, r, |u: f64| 2.0 + u.exp());
    let maximum = generic(moments, r, |u: f64| 1.0 - u.exp());
    let curves = vec![
        curve("c1", Generic, "b1", Some(0), minimum, [25.0, -9.0], [0.0, free], Some((2.0, -0.94868))),
        curve("c2", Generic, "b2", Some(2), maximum, [25.0, -9.0], [0.0, free], Some((1.0, 0.61623))),
        curve("c3", Generic, "b3", Some(0), inside(), [cusp, 9.0], [l_cusp, free], Some((2.0, 0.94868))),
        curve("c4", Generic, "b3", Some(1), inside(), [cusp, fork], [l_cusp, l_fork], None),
        curve("c5", Generic, "b3", Some(2), inside(), [fork, -9.0], [l_fork, free], Some((1.0, -0.61623))),
        curve("c6", Pair, "b4", Some(1), pair, [p_hat.sqrt(), 3e3], [l_fork, free], Some((1.1, 0.0))),
        curve(
            "P+",
            PolePlus,
            "P+",
            None,
            parabola(pole_moment, -length),
            [0.0, 1e3],
            [0.0, free],
            Some((pole_moment, -length)),
        ),
        curve(
            "P-",
            PoleMinus,
            "P-",
            None,
            parabola(pole_moment, length),
            [0.0, 1e3],
            [0.0, free],
            Some((pole_moment, length)),
        ),
    ];
    let points = [
        ([1.8, 3.25], "S2"),
        ([2.6, 3.25], "T2"),
        ([3.8, 3.25], "S2+T2"),
        ([4.45, 3.25], "T2+T2"),
        ([4.675, 3.25], "M3"),
        ([5.3, 3.25], "M2"),
        ([6.5, 3.25], "T2"),
        ([3.1486, 2.72], "M2"),
        ([14.0, 7.2], "S2+S2"),
    ];
    assemble(["2", "1.1", "1"], ["0.94868", "0", "0.61623"], curves, &points)
}

/// A = (2, 2, 1), r = (1, 0, 0).
pub fn kovalevskaya() -> Fixture {
    let pair = || -> Course { Box::new(|s| [0.5 * s + 1.5 / s, s.sqrt() * (1.0 + 1.0 / (s * s))]) };
    let l_cusp = (16.0 * 3.0_f64.sqrt() / 9.0).sqrt();
    let root3 = 3.0_f64.sqrt();
    let curve = |id, kind, branch, index, course, ends, l, tail: Option<(f64, f64)>, twin: &[&str]| Curve {
        id,
        kind,
        branch,
        index,
        multiplicity: if kind == CurveKind::Pair { 2 } else { 1 },
        coincides_with: twin.iter().map(|&twin| twin.to_owned()).collect(),
        course,
        ends,
        l,
        tail: tail.map(|(moment, h_offset)| TailDocument { moment, h_offset }),
    };
    let free = f64::INFINITY;
    let low = Some((2.0, -1.0));
    let high = Some((2.0, 1.0));
    let curves = vec![
        curve("c1", Axis, "b1", Some(0), parabola(2.0, -1.0), [0.0, 1e3], [0.0, free], low, &["P+"]),
        curve("c2", Axis, "b2", Some(2), parabola(2.0, 1.0), [0.0, 1e3], [0.0, 2.0], None, &["P-"]),
        curve("c3", Axis, "b2", Some(1), parabola(2.0, 1.0), [0.0, 1e3], [2.0, free], high, &["P-"]),
        curve("c4", Pair, "b3", Some(1), pair(), [root3, 1.0], [l_cusp, 2.0], None, &[]),
        curve("c5", Pair, "b3", Some(2), pair(), [root3, 1e4], [l_cusp, free], Some((1.0, 0.0)), &[]),
        curve("P+", PolePlus, "P+", None, parabola(2.0, -1.0), [0.0, 1e3], [0.0, free], low, &["c1"]),
        curve("P-", PoleMinus, "P-", None, parabola(2.0, 1.0), [0.0, 1e3], [0.0, free], high, &["c2", "c3"]),
    ];
    let points = [([0.0, 1.84], "T2"), ([1.84, 1.84], "M3"), ([1.85, 1.84], "M3"), ([3.0, 1.84], "T2")];
    assemble(["2", "2", "1"], ["1", "0", "0"], curves, &points)
}

/// Regions between parabolas h = l²/2J + c for given (J, c), as for a body with r = 0: no section exists.
pub fn parabolas(lines: &[(f64, f64)]) -> Fixture {
    let ids = ["c1", "c2", "c3", "c4", "c5", "c6"];
    let curve = |(place, &(moment, offset)): (usize, &(f64, f64))| Curve {
        id: ids[place],
        kind: CurveKind::Axis,
        branch: ids[place],
        index: Some(0),
        multiplicity: 1,
        coincides_with: Vec::new(),
        course: parabola(moment, offset),
        ends: [0.0, 1e3],
        l: [0.0, f64::INFINITY],
        tail: Some(TailDocument { moment, h_offset: offset }),
    };
    assemble(["3", "2", "1"], ["0", "0", "0"], lines.iter().enumerate().map(curve).collect(), &[])
}

/// Curves of one set of coincidences by height at `l`, one of each set.
fn order(curves: &[Curve], l: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..curves.len())
        .filter(|&i| curves[i].reaches(l))
        .filter(|&i| !curves[i].id.starts_with('P') || curves[i].coincides_with.is_empty())
        .collect();
    order.sort_by(|&a, &b| curves[a].h_at(l).total_cmp(&curves[b].h_at(l)));
    order
}

fn events(curves: &[Curve], l_end: f64) -> Vec<EventDocument> {
    let mut events: Vec<EventDocument> = Vec::new();
    let event = |kind, l: f64, h, curves: Vec<usize>, all: &[Curve]| EventDocument {
        kind,
        l,
        h,
        curves: curves.into_iter().map(|i| all[i].id.to_owned()).collect(),
        l_error: 1e-12,
        h_error: 1e-12,
        enclosure: None,
    };
    let begin = |l: f64| (0..curves.len()).filter(|&i| curves[i].l[0] == l).collect::<Vec<_>>();
    for l in curves.iter().map(|curve| curve.l[0]).filter(|&l| l > 0.0) {
        if events.iter().any(|event| event.l == l) {
            continue;
        }
        let mut meeting = begin(l);
        let h = curves[meeting[0]].h_at(l);
        let ends: Vec<usize> = (0..curves.len()).filter(|&i| curves[i].l[1] == l).collect();
        let kind = if ends.is_empty() { EventKind::Cusp } else { EventKind::Pitchfork };
        meeting.extend(ends);
        events.push(event(kind, l, h, meeting, curves));
    }
    for a in 0..curves.len() {
        for b in 0..a {
            let from = curves[a].l[0].max(curves[b].l[0]).max(0.05);
            let to = curves[a].l[1].min(curves[b].l[1]).min(l_end);
            if curves[a].coincides_with.iter().any(|id| id == curves[b].id) || from >= to {
                continue;
            }
            let gap = |l: f64| curves[a].h_at(l) - curves[b].h_at(l);
            let l_of = |step: usize| from + 1e-3 * (to - from) + (to - from) * 0.998 * step as f64 / 3000.0;
            for step in 0..3000 {
                let [mut low, mut high] = [l_of(step), l_of(step + 1)];
                if gap(low) * gap(high) >= 0.0 {
                    continue;
                }
                for _ in 0..60 {
                    let middle = low + (high - low) / 2.0;
                    if gap(low) * gap(middle) < 0.0 { high = middle } else { low = middle }
                }
                if !events.iter().any(|event| (event.l - low).abs() < 1e-12) {
                    events.push(event(EventKind::Crossing, low, curves[a].h_at(low), vec![a, b], curves));
                }
            }
        }
    }
    events.sort_by(|a, b| a.l.total_cmp(&b.l));
    events
}

/// A cell: strip, lower curve, upper curve.
type Key = (usize, usize, Option<usize>);

fn assemble(moments: [&str; 3], r: [&str; 3], curves: Vec<Curve>, points: &[([f64; 2], &str)]) -> Fixture {
    let body = Body::parse(&moments, &r).expect("the fixture's body is valid");
    let events = events(&curves, 12.0);
    let mut bounds = vec![0.0];
    bounds.extend(events.iter().map(|event| event.l));
    bounds.push(f64::INFINITY);
    let middle = |strip: usize| {
        if bounds[strip + 1].is_finite() {
            f64::midpoint(bounds[strip], bounds[strip + 1])
        } else {
            bounds[strip] + 1.0
        }
    };
    let orders: Vec<Vec<usize>> = (0..bounds.len() - 1).map(|strip| order(&curves, middle(strip))).collect();
    let cells_of = |strip: usize| -> Vec<Key> {
        let order = &orders[strip];
        (0..order.len()).map(|i| (strip, order[i], order.get(i + 1).copied())).collect()
    };
    let mut faces: Vec<Vec<Key>> = cells_of(0).into_iter().map(|cell| vec![cell]).collect();
    for (strip, event) in events.iter().enumerate() {
        let meets = |i: &usize| event.curves.iter().any(|id| *id == curves[*i].id);
        let split = |order: &[usize]| -> [usize; 2] {
            let below = order.iter().take_while(|i| !meets(i) && curves[**i].h_at(event.l) < event.h).count();
            let inside = order.iter().skip(below).take_while(|i| meets(i)).count();
            [below, below + inside]
        };
        let (before, after) = (cells_of(strip), cells_of(strip + 1));
        let ([b0, b1], [a0, a1]) = (split(&orders[strip]), split(&orders[strip + 1]));
        let mut joined = Vec::new();
        joined.extend((0..b0).map(|i| (i, i)));
        joined.extend((b1.max(1) - 1..before.len()).map(|i| (i, i + a1 - b1)));
        let mut known = vec![false; after.len()];
        for (from, to) in joined {
            let at = |cell: &Key| faces.iter().position(|face| face.contains(cell));
            let Some(face) = at(&before[from]) else { continue };
            match at(&after[to]) {
                Some(other) if other != face => {
                    let moved = faces.swap_remove(other.max(face));
                    faces[other.min(face)].extend(moved);
                }
                Some(_) => {}
                None => faces[face].push(after[to]),
            }
            known[to] = true;
        }
        let _ = a0;
        faces.extend(after.iter().zip(known).filter(|(_, known)| !known).map(|(cell, _)| vec![*cell]));
    }
    let mut regions = Vec::new();
    for mut face in faces {
        face.sort_unstable();
        let inside = |[h, l]: [f64; 2]| {
            face.iter().any(|&(strip, lower, upper)| {
                l > bounds[strip]
                    && l < bounds[strip + 1]
                    && h > curves[lower].h_at(l)
                    && upper.is_none_or(|upper| h < curves[upper].h_at(l))
            })
        };
        let signature = points.iter().find(|(point, _)| inside(*point)).map(|(_, signature)| (*signature).to_owned());
        regions.push(region(&format!("R{}", regions.len() + 1), &face, &bounds, &curves, signature));
    }
    let documents = curves.iter().map(document).collect();
    let mut atlas = atlas(&body, documents, events, regions);
    atlas.drawing = Some(drawing(&curves, &atlas));
    Fixture { curves, atlas }
}

fn region(id: &str, face: &[Key], bounds: &[f64], curves: &[Curve], signature: Option<String>) -> RegionDocument {
    let mut sample = [0.0, 0.0, -1.0];
    for &(strip, lower, upper) in face {
        let [from, to] = [bounds[strip], bounds[strip + 1].min(bounds[strip] + 4.0)];
        for step in 1..64 {
            let l = from + (to - from) * f64::from(step) / 64.0;
            let low = curves[lower].h_at(l);
            let high = upper.map_or(low + 1.0, |upper| curves[upper].h_at(l));
            if high - low > sample[2] {
                sample = [f64::midpoint(low, high), l, high - low];
            }
        }
    }
    let first = face.iter().map(|key| bounds[key.0]).fold(f64::INFINITY, f64::min);
    let last = face.iter().map(|key| bounds[key.0 + 1]).fold(0.0, f64::max);
    let end = |l: f64| l.is_finite().then_some(l);
    let mut boundary: Vec<String> =
        face.iter().flat_map(|key| [Some(key.1), key.2]).flatten().map(|i| curves[i].id.to_owned()).collect();
    boundary.sort_unstable();
    boundary.dedup();
    RegionDocument {
        id: id.to_owned(),
        sample: SampleDocument {
            h: sample[0],
            l: sample[1],
            margin: MarginDocument { h: sample[2] / 2.0, nearest: boundary[0].clone(), error_bound: 1e-15 },
        },
        components: components(signature.as_deref()),
        signature,
        bounded: last.is_finite() && face.iter().all(|key| key.2.is_some()),
        l_range: [Some(first), end(last)],
        boundary,
        neighbours: Vec::new(),
        cells: face
            .iter()
            .map(|&(strip, lower, upper)| CellDocument {
                l_range: [Some(bounds[strip]), end(bounds[strip + 1])],
                lower: curves[lower].id.to_owned(),
                upper: upper.map(|upper| curves[upper].id.to_owned()),
            })
            .collect(),
        clipped: false,
    }
}

fn document(curve: &Curve) -> CurveDocument {
    let end = |l: f64| l.is_finite().then_some(l);
    let stability = if curve.index == Some(1) { Stability::SaddleCentre } else { Stability::Elliptic };
    let (verdict, why) = match curve.index {
        Some(1) => (NonlinearVerdict::Unstable, Reason::Spectrum),
        Some(2) => (NonlinearVerdict::Stable, Reason::Arnold),
        _ => (NonlinearVerdict::Stable, Reason::Energy),
    };
    let spans = curve.index.map(|index| StabilitySpan {
        l_from: curve.l[0],
        l_to: end(curve.l[1]),
        stability,
        nonlinear: NonlinearDocument::along(verdict, why, true),
        friction: FrictionDocument {
            conserving_l: Some(if index == 0 { Damped::Survives } else { Damped::Lost }),
            growing: index,
            rates: Vec::new(),
        },
    });
    CurveDocument {
        id: curve.id.to_owned(),
        kind: curve.kind,
        branch: curve.branch.to_owned(),
        branch_name: format!("branch {}", curve.branch),
        index: curve.index,
        multiplicity: curve.multiplicity,
        coincides_with: curve.coincides_with.clone(),
        mu_range: None,
        l_range: [Some(curve.l[0]), end(curve.l[1])],
        stability: spans.into_iter().collect(),
        tail: curve.tail.clone(),
    }
}

/// An atlas document of given parts.
pub fn atlas(
    body: &Body,
    curves: Vec<CurveDocument>,
    events: Vec<EventDocument>,
    regions: Vec<RegionDocument>,
) -> AtlasDocument {
    let flags = body.flags();
    AtlasDocument {
        head: Head { schema_version: SCHEMA_VERSION.to_owned(), ..Head::default() },
        accuracy: Accuracy::Exact,
        body: BodyDocument {
            given: GivenBody {
                moments: body.moments().each_ref().map(ToString::to_string),
                center: body.center().each_ref().map(ToString::to_string),
            },
            flags,
            degenerate: body.flags().degenerate(),
            integrable: Vec::new(),
            part: None,
        },
        window: None,
        summary: SummaryDocument {
            regions: regions.len(),
            events: events.len(),
            signatures: BTreeMap::new(),
            critical_points_max: 6,
            undecided: Vec::new(),
            complete: true,
        },
        curves,
        events,
        stability_changes: Vec::new(),
        verdict_changes: None,
        regions,
        drawing: None,
        certificate: None,
    }
}

/// Curves of these points; a region is as wide as twice the margin of its sample.
fn drawing(curves: &[Curve], atlas: &AtlasDocument) -> DrawingDocument {
    let polylines: Vec<Vec<[f64; 2]>> = curves.iter().map(|curve| curve.points(curve.l[0], 8.0, 1e-4)).collect();
    let width = |region: &RegionDocument| {
        region.cells.iter().all(|cell| cell.upper.is_some()).then_some(2.0 * region.sample.margin.h)
    };
    let region =
        |region: &RegionDocument| (region.id.clone(), RegionDrawing { polygon: Vec::new(), h_width: width(region) });
    DrawingDocument {
        view: view(&atlas.events, &polylines),
        curves: curves
            .iter()
            .zip(&polylines)
            .map(|(curve, line)| (curve.id.to_owned(), CurveDrawing { polyline: line.clone() }))
            .collect(),
        regions: atlas.regions.iter().map(region).collect(),
    }
}

/// The view of the events, without those that lie far beyond the others in the main window.
fn view(events: &[EventDocument], curves: &[Vec<[f64; 2]>]) -> ViewDocument {
    let mut l: Vec<f64> = events.iter().map(|event| event.l).collect();
    l.sort_by(f64::total_cmp);
    let last = l.last().copied().unwrap_or(0.0);
    let before_leap = l.windows(2).find(|pair| pair[1] > 12.0 * pair[0]).map_or(last, |pair| pair[0]);
    let [main, everything] = [before_leap, last].map(|last| window(events, curves, last));
    ViewDocument { main, everything }
}

/// A window for the events up to `last` in l: they, the beginnings of the curves, and the middle of them above.
fn window(events: &[EventDocument], curves: &[Vec<[f64; 2]>], last: f64) -> WindowDocument {
    let top = if last > 0.0 { 1.25 * last } else { 4.0 };
    let below =
        |line: &Vec<[f64; 2]>| -> Vec<[f64; 2]> { line.iter().copied().filter(|point| point[1] <= top).collect() };
    let parts: Vec<Vec<[f64; 2]>> = curves.iter().map(below).filter(|part| !part.is_empty()).collect();
    let begins: Vec<f64> = parts.iter().map(|part| part[0][0]).collect();
    let mut ends: Vec<f64> = parts.iter().map(|part| part[part.len() - 1][0]).collect();
    ends.sort_by(f64::total_cmp);
    let low = begins.iter().copied().fold(f64::INFINITY, f64::min);
    let begin = begins.iter().copied().fold(low, f64::max);
    let seen = events.iter().filter(|event| event.l <= last).map(|event| event.h);
    let high = seen.fold((begin + 0.5 * (begin - low)).max(ends[ends.len() / 2]), f64::max);
    let margin = 0.05 * (high - low);
    WindowDocument { h: [low - margin, high + margin], l: [0.0, top] }
}

/// Discs with the sections of a signature; without one a disc of which no more is known.
fn components(signature: Option<&str>) -> Vec<ComponentDocument> {
    let names: Vec<Option<&str>> = signature.map_or_else(|| vec![None], |names| names.split('+').map(Some).collect());
    let disc = |name: Option<&str>| ComponentDocument {
        boundary_circles: 1,
        poles: None,
        accessible_region: "D2".to_owned(),
        energy_surface: "S3".to_owned(),
        section: name.map(str::to_owned),
        genus: name.map(|name| match name {
            "S2" => 0,
            "T2" => 1,
            more => more[1..].parse().expect("a genus"),
        }),
    };
    names.into_iter().map(disc).collect()
}
