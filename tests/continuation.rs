//! The tracker against the closed form of the relative equilibria, which is written here a second time, in partial
//! fractions about the nearest moment of inertia.

use bifdiag::body::{Body, Frame};
use bifdiag::continuation::{
    Direction, Effort, PieceEnd, PieceTrack, Start, StopReason, TrackError, TrackOptions, TrackReport, Vertex,
    VertexKind, track, track_piece,
};
use bifdiag::document::{Stability, StabilitySpan};
use bifdiag::stability::{Linearisation, RelativeEquilibrium};

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn direction(&mut self) -> [f64; 3] {
        loop {
            let v: [f64; 3] = std::array::from_fn(|_| self.between(-1.0, 1.0));
            let square: f64 = v.iter().map(|x| x * x).sum();
            if square > 0.01 && square <= 1.0 {
                return v.map(|x| x / square.sqrt());
            }
        }
    }

    fn moments(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.between(0.1, 2.0))
    }
}

fn frame(a: [f64; 3], r: [f64; 3]) -> Frame {
    Body::from_f64(a, r).unwrap().frame()
}

/// The generic family at μ = A_i + δ.
#[derive(Debug)]
struct Closed {
    gamma: [f64; 3],
    omega: f64,
    l: f64,
    h: f64,
    /// 4Q'P − 3P'Q: changes its sign at cusps.
    turning: f64,
}

fn closed(frame: &Frame, i: usize, delta: f64) -> Closed {
    let (mut p, mut q, mut r, mut p_slope, mut q_slope) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let mut w = [0.0; 3];
    for j in 0..3 {
        if frame.r[j] == 0.0 {
            continue;
        }
        let m = delta + frame.diff[i][j];
        w[j] = frame.r[j] / m;
        let square = w[j] * w[j];
        p += square;
        q += frame.a[j] * square;
        r += frame.r[j] * w[j];
        p_slope -= 2.0 * square / m;
        q_slope -= 2.0 * frame.a[j] * square / m;
    }
    let s = p.sqrt();
    let omega = s.sqrt();
    Closed {
        gamma: w.map(|x| x / s),
        omega,
        l: omega * q / p,
        h: (0.5 * q - r) / s,
        turning: 4.0 * q_slope * p - 3.0 * p_slope * q,
    }
}

/// The pair over μ = A_i at squared angular velocity s, with γ_i ≥ 0: (γ, l, h).
fn closed_pair(frame: &Frame, i: usize, s: f64) -> ([f64; 3], f64, f64) {
    let mut gamma = [0.0; 3];
    let mut r_tilde = 0.0;
    let mut rest = 1.0;
    for j in (0..3).filter(|&j| j != i && frame.r[j] != 0.0) {
        gamma[j] = frame.r[j] / (s * frame.diff[i][j]);
        rest -= gamma[j] * gamma[j];
        r_tilde += frame.r[j] * frame.r[j] / frame.diff[i][j];
    }
    gamma[i] = rest.max(0.0).sqrt();
    let l = s.sqrt() * (frame.a[i] - r_tilde / (s * s));
    (gamma, l, 0.5 * s * frame.a[i] - 1.5 * r_tilde / s)
}

/// √P̂: the squared angular velocity at which the pair over A_i leaves the generic family.
fn pair_start(frame: &Frame, i: usize) -> f64 {
    (0..3)
        .filter(|&j| j != i && frame.r[j] != 0.0)
        .map(|j| frame.r[j] / frame.diff[i][j])
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt()
}

/// The intervals of μ between those moments that the generic family feels, as points (i, δ), each interval in order.
fn intervals(frame: &Frame) -> Vec<Vec<(usize, f64)>> {
    let axes: Vec<usize> = (0..3).filter(|&j| frame.r[j] != 0.0).collect();
    // From far below the smallest r_j to 1e5, evenly in the logarithm.
    let smallest = axes.iter().map(|&j| frame.r[j]).fold(1e-11, f64::min) * 1e-3;
    let mut ladder = vec![smallest];
    while ladder[ladder.len() - 1] < 1e5 {
        ladder.push(ladder[ladder.len() - 1] * 1.03);
    }
    let first = axes[0];
    let mut all = vec![ladder.iter().rev().map(|&x| (first, -x)).collect::<Vec<_>>()];
    for pair in axes.windows(2) {
        let width = frame.diff[pair[1]][pair[0]];
        let near = |x: &&f64| **x < 0.5 * width;
        let mut points: Vec<_> = ladder.iter().filter(near).map(|&x| (pair[0], x)).collect();
        points.extend(ladder.iter().rev().filter(near).map(|&x| (pair[1], -x)));
        all.push(points);
    }
    let last = axes[axes.len() - 1];
    all.push(ladder.iter().map(|&x| (last, x)).collect());
    all
}

/// A start inside an interval where l is small.
fn start_in(frame: &Frame, interval: &[(usize, f64)]) -> Start {
    Start::on(frame, start_in_equilibrium(frame, interval))
}

fn start_in_equilibrium(frame: &Frame, interval: &[(usize, f64)]) -> RelativeEquilibrium {
    let (i, delta) = interval
        .iter()
        .copied()
        .filter(|&(_, delta)| delta.abs() < 10.0)
        .min_by(|&(i, x), &(j, y)| closed(frame, i, x).l.total_cmp(&closed(frame, j, y).l))
        .unwrap();
    // Off the minimum of l, which may be a cusp.
    let point = closed(frame, i, delta * 1.0625);
    RelativeEquilibrium::new(frame, point.gamma, point.omega)
}

/// The worst relative difference between a vertex and the closed form at the same μ.
fn difference_generic(frame: &Frame, vertex: &Vertex) -> f64 {
    let point = &vertex.equilibrium;
    let gap = |j: &usize| point.gap[*j].abs();
    let i = (0..3).filter(|&j| frame.r[j] != 0.0).min_by(|i, j| gap(i).total_cmp(&gap(j))).unwrap();
    if point.omega == 0.0 {
        let side = point.gap[i].signum();
        return (0..3).map(|j| (point.gamma[j] - side * frame.r_hat()[j]).abs()).fold(0.0, f64::max);
    }
    let truth = closed(frame, i, point.gap[i] / (point.omega * point.omega));
    let mut worst = ((vertex.l - truth.l) / truth.l).abs();
    worst = worst.max(((vertex.h - truth.h) / (0.5 * truth.omega * truth.l + frame.r_norm)).abs());
    for j in 0..3 {
        worst = worst.max((point.gamma[j] - truth.gamma[j]).abs());
    }
    worst
}

fn cusps(report: &TrackReport) -> Vec<Vertex> {
    report.vertices.iter().filter(|vertex| vertex.kind == VertexKind::Cusp).copied().collect()
}

fn both_ways(frame: &Frame, start: &Start, options: &TrackOptions) -> [TrackReport; 2] {
    [Direction::Falling, Direction::Rising].map(|way| track(frame, start, way, options).unwrap())
}

/// The cusps of an interval as (i, δ), in its order, by bisection of the closed form.
fn cusp_points(frame: &Frame, interval: &[(usize, f64)]) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    for ends in interval.windows(2) {
        let ((i, mut low), (k, mut high)) = (ends[0], ends[1]);
        if i != k {
            high += frame.diff[k][i];
        }
        let sign = closed(frame, i, low).turning > 0.0;
        if sign == (closed(frame, i, high).turning > 0.0) {
            continue;
        }
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if (closed(frame, i, middle).turning > 0.0) == sign { low = middle } else { high = middle }
        }
        found.push((i, low));
    }
    found
}

/// l at the cusps of an interval below `l_max`, sorted.
fn cusps_of(frame: &Frame, interval: &[(usize, f64)], l_max: f64) -> Vec<f64> {
    let mut found: Vec<f64> =
        cusp_points(frame, interval).iter().map(|&(i, delta)| closed(frame, i, delta).l).collect();
    found.retain(|&l| l < l_max);
    found.sort_by(f64::total_cmp);
    found
}

fn wide(l_max: f64) -> TrackOptions {
    TrackOptions { l_max, l_scale: l_max, h_scale: l_max * l_max, chord_tolerance: 1e-3, ..TrackOptions::default() }
}

/// Tracks all four curves of a body with r_j ≠ 0 both ways and holds them against the closed form: vertices, cusps
/// and their number. Returns the worst differences of vertices and of cusps, and the number of cusps.
fn compare_generic(frame: &Frame, l_max: f64) -> (f64, f64, usize) {
    let (mut worst, mut worst_cusp, mut turns) = (0.0f64, 0.0f64, 0);
    for (number, interval) in intervals(frame).iter().enumerate() {
        let start = start_in(frame, interval);
        let mut found = Vec::new();
        for report in both_ways(frame, &start, &wide(l_max)) {
            let at_rest_too = number == 0 || number == 3;
            assert!(
                report.stop == StopReason::MaximumReached || (at_rest_too && report.stop == StopReason::Rest),
                "{number} {:?} {:?} {frame:?}",
                report.stop,
                report.effort
            );
            for vertex in &report.vertices {
                worst = worst.max(difference_generic(frame, vertex));
            }
            found.extend(cusps(&report).iter().map(|vertex| vertex.l));
        }
        found.sort_by(f64::total_cmp);
        let truth = cusps_of(frame, interval, l_max);
        assert_eq!(found.len(), truth.len(), "{number}: {found:?} {truth:?} {frame:?}");
        turns += found.len();
        for (x, y) in found.iter().zip(&truth) {
            worst_cusp = worst_cusp.max(((x - y) / y).abs());
        }
    }
    (worst, worst_cusp, turns)
}

#[test]
fn a_thousand_generic_bodies_agree_with_the_closed_form() {
    let mut random = Random(2008);
    let (mut worst, mut worst_cusp, mut turns) = (0.0f64, 0.0f64, 0);
    for body in 0..1000 {
        let mut r = random.direction();
        if body % 4 == 3 {
            // Near a coordinate plane.
            r[body % 3] *= 10f64.powf(random.between(-9.0, -1.0));
        }
        let (vertex, cusp, count) = compare_generic(&frame(random.moments(), r), 1e4);
        worst = worst.max(vertex);
        worst_cusp = worst_cusp.max(cusp);
        turns += count;
    }
    assert!(worst < 1e-12, "{worst:e}");
    assert!(worst_cusp < 1e-12, "{worst_cusp:e}");
    assert!(turns > 2000);
}

#[test]
fn rods_near_pitchforks_and_nearly_equal_moments_are_passed() {
    let mut worst = 0.0f64;
    for (a, r) in [
        ([1e-6, 1.0, 1.1], [0.6, 0.5, 0.4]),
        ([1e-6, 1.0, 1.0 + 1e-9], [0.6, 0.5, 0.4]),
        ([2.0, 1.1, 1.0], [0.9, 1e-12, 0.6]),
        ([2.0, 1.1, 1.0], [1e-12, 0.9, 0.6]),
        ([2.0, 1.1, 1.0], [1e-12, 0.9, 1e-12]),
        ([2.0, 1.1, 1.0], [1.0, 1e-100, 1e-40]),
        ([1.0, 1.0 + 1e-9, 2.0], [0.6, 0.5, 0.4]),
        ([1.0, 1.0 + 1e-9, 2.0], [0.6, 0.5, 1e-12]),
        ([1.0, 1.0 + 1e-9, 1.0 + 2e-9], [0.6, 0.5, 0.4]),
        ([1.0, 2.0, 1e3], [1e-3, 1.0, 1e-6]),
    ] {
        let (vertex, cusp, turns) = compare_generic(&frame(a, r), 1e8);
        println!("{a:?} {r:?} {vertex:e} {cusp:e} {turns}");
        worst = worst.max(vertex).max(cusp);
    }
    assert!(worst < 1e-12, "{worst:e}");
}

#[test]
fn bodies_in_a_symmetry_plane_switch_branches_at_pitchforks() {
    let mut random = Random(1972);
    let l_max = 1e4;
    let (mut worst, mut pairs, mut turns) = (0.0f64, 0, 0);
    for body in 0..200 {
        let mut r = random.direction();
        r[body % 3] = 0.0;
        if body % 5 == 4 {
            r[(body + 1) % 3] = 0.0;
        }
        let frame = frame(random.moments(), r);
        let mut met = Vec::new();
        for interval in intervals(&frame) {
            let start = start_in(&frame, &interval);
            for report in both_ways(&frame, &start, &wide(l_max)) {
                assert!(matches!(report.stop, StopReason::Rest | StopReason::MaximumReached));
                for vertex in &report.vertices {
                    worst = worst.max(difference_generic(&frame, vertex));
                }
                met.extend(report.pitchforks.iter().map(|fork| (fork.axis, report.vertices[fork.vertex])));
            }
        }
        let free: Vec<usize> = (0..3).filter(|&i| frame.r[i] == 0.0).collect();
        let expected = free.iter().filter(|&&i| closed_pair(&frame, i, pair_start(&frame, i)).1 < l_max).count();
        assert_eq!(met.len(), expected, "{frame:?}");
        for (axis, vertex) in met {
            assert!(free.contains(&axis));
            let s = pair_start(&frame, axis);
            let (gamma, l, h) = closed_pair(&frame, axis, s);
            worst = worst.max(((vertex.l - l) / l).abs()).max((vertex.h - h).abs() / (s * frame.a[2] + frame.r_norm));
            for j in (0..3).filter(|&j| j != axis) {
                worst = worst.max((vertex.equilibrium.gamma[j] - gamma[j]).abs());
            }
            let start = Start::leaving_pitchfork(vertex.equilibrium, axis);
            let report = track(&frame, &start, Direction::Rising, &wide(l_max)).unwrap();
            assert_eq!(report.stop, StopReason::MaximumReached);
            pairs += 1;
            for vertex in &report.vertices {
                let point = &vertex.equilibrium;
                let (gamma, l, h) = closed_pair(&frame, axis, point.omega * point.omega);
                worst = worst.max(((vertex.l - l) / l).abs());
                worst = worst.max((vertex.h - h).abs() / (0.5 * l * point.omega + frame.r_norm));
                for j in (0..3).filter(|&j| j != axis) {
                    worst = worst.max((point.gamma[j] - gamma[j]).abs());
                }
                // γ_i = √(1 − …) is known to the square root of rounding where it vanishes.
                let square = point.gamma[axis] * point.gamma[axis];
                worst = worst.max((square - gamma[axis] * gamma[axis]).abs());
            }
            let r_tilde: f64 =
                (0..3).filter(|&j| frame.r[j] != 0.0).map(|j| frame.r[j] * frame.r[j] / frame.diff[axis][j]).sum();
            let s_squared = -3.0 * r_tilde / frame.a[axis];
            let found = cusps(&report);
            assert_eq!(found.len(), usize::from(s_squared >= s * s), "{frame:?}");
            for cusp in found {
                turns += 1;
                let (_, l, _) = closed_pair(&frame, axis, s_squared.sqrt());
                worst = worst.max(((cusp.l - l) / l).abs());
            }
            // And back again: the pair ends where it began.
            let back = track(
                &frame,
                &Start::on(&frame, report.vertices[report.vertices.len() - 1].equilibrium),
                Direction::Falling,
                &TrackOptions { l_max: 2.0 * l_max, ..wide(l_max) },
            )
            .unwrap();
            assert_eq!(back.stop, StopReason::Pitchfork);
            let end = back.vertices[back.vertices.len() - 1];
            assert_eq!(end.equilibrium.gamma[axis], 0.0);
            worst = worst.max(((end.l - vertex.l) / vertex.l).abs());
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
    assert!(pairs >= 200 && turns > 20, "{pairs} {turns}");
}

fn picture(l_max: f64) -> TrackOptions {
    TrackOptions { l_max, l_scale: l_max, h_scale: l_max * l_max, chord_tolerance: 1e-3, ..TrackOptions::default() }
}

/// Distance of a point from a segment, all in the scaled plane.
fn distance_to_segment(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let offset = [point[0] - from[0], point[1] - from[1]];
    let t = if square > 0.0 { ((offset[0] * along[0] + offset[1] * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    let rest = [offset[0] - t * along[0], offset[1] - t * along[1]];
    (rest[0] * rest[0] + rest[1] * rest[1]).sqrt()
}

#[test]
fn polylines_meet_the_chord_tolerance_between_their_vertices() {
    let mut random = Random(33);
    let (mut worst, mut vertices, mut curves) = (0.0f64, 0, 0);
    for body in 0..200 {
        let mut r = random.direction();
        if body % 4 == 3 {
            r[body % 3] *= 10f64.powf(random.between(-6.0, -1.0));
        }
        let frame = frame(random.moments(), r);
        let scale = frame.a[0];
        let l_max = 8.0;
        let options = TrackOptions {
            h_scale: 2.0 * frame.r_norm + l_max * l_max / (2.0 * scale),
            chord_tolerance: if body % 2 == 0 { 1e-3 } else { 1e-6 },
            ..picture(l_max)
        };
        let scaled = |l: f64, h: f64| [l / options.l_scale, h / options.h_scale];
        for interval in intervals(&frame) {
            let start = start_in(&frame, &interval);
            if start_l(&frame, &interval) > l_max {
                continue;
            }
            curves += 1;
            for report in both_ways(&frame, &start, &options) {
                vertices += report.vertices.len();
                for pair in report.vertices.windows(2) {
                    let [from, to] = [&pair[0], &pair[1]];
                    if from.equilibrium.omega == 0.0 || to.equilibrium.omega == 0.0 {
                        continue;
                    }
                    let i = (0..3)
                        .min_by(|&i, &j| from.equilibrium.gap[i].abs().total_cmp(&from.equilibrium.gap[j].abs()))
                        .unwrap();
                    let delta = |v: &Vertex| v.equilibrium.gap[i] / (v.equilibrium.omega * v.equilibrium.omega);
                    let ratio = (delta(to) / delta(from)).powf(1.0 / 64.0);
                    let mut here = delta(from);
                    for _ in 0..63 {
                        here *= ratio;
                        let point = closed(&frame, i, here);
                        let away =
                            distance_to_segment(scaled(point.l, point.h), scaled(from.l, from.h), scaled(to.l, to.h));
                        worst = worst.max(away / options.chord_tolerance);
                    }
                }
            }
        }
    }
    assert!(worst <= 1.0, "{worst}");
}

fn start_l(frame: &Frame, interval: &[(usize, f64)]) -> f64 {
    start_in_equilibrium(frame, interval).l(frame)
}

#[test]
fn kovalevskaya_has_its_exact_cusp_and_pitchfork() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let frame = body.frame();
    let [h_unit, l_unit] = [frame.energy_unit, frame.momentum_unit];
    let gamma = frame.r_hat().map(|x| -x);
    let start = Start::on(&frame, RelativeEquilibrium::new(&frame, gamma, 0.0));
    let upper = track(&frame, &start, Direction::Rising, &picture(8.0)).unwrap();
    assert_eq!(upper.pitchforks.len(), 1);
    let fork = upper.pitchforks[0];
    let vertex = upper.vertices[fork.vertex];
    assert!((vertex.h * h_unit - 2.0).abs() < 1e-12 && (vertex.l * l_unit - 2.0).abs() < 1e-12);
    let pair = Start::leaving_pitchfork(vertex.equilibrium, fork.axis);
    let pair = track(&frame, &pair, Direction::Rising, &picture(8.0)).unwrap();
    let found = cusps(&pair);
    assert_eq!(found.len(), 1);
    assert!((found[0].h * h_unit - 3f64.sqrt()).abs() < 1e-12);
    let l_squared = found[0].l * found[0].l * l_unit * l_unit;
    assert!((l_squared - 16.0 * 3f64.sqrt() / 9.0).abs() < 1e-12);
    let turned = upper.vertices.iter().filter(|v| v.kind == VertexKind::Regular && v.equilibrium.omega > 0.0);
    for vertex in turned {
        assert_eq!(vertex.index, Some(if vertex.l * l_unit < 2.0 { 2 } else { 1 }));
    }
}

/// The points of an interval between consecutive cusps, with the kind of end on either side.
fn pieces_of(frame: &Frame, interval: &[(usize, f64)], l_max: f64) -> Vec<(Vec<(usize, f64)>, [PieceEnd; 2])> {
    let mut pieces = vec![Vec::new()];
    for ends in interval.windows(2) {
        pieces.last_mut().unwrap().push(ends[0]);
        let (i, k) = (ends[0].0, ends[1].0);
        if (closed(frame, i, ends[0].1).turning > 0.0) != (closed(frame, k, ends[1].1).turning > 0.0) {
            pieces.push(Vec::new());
        }
    }
    let l_of = |&(i, delta): &(usize, f64)| closed(frame, i, delta).l;
    let count = pieces.len();
    let cusps = cusp_points(frame, interval);
    assert_eq!(cusps.len() + 1, count);
    let mut all = Vec::new();
    for (number, mut points) in pieces.into_iter().enumerate() {
        let mut ends = [number.checked_sub(1), (number + 1 < count).then_some(number)]
            .map(|cusp| cusp.map(|cusp| PieceEnd::Cusp(l_of(&cusps[cusp]))));
        if points.len() > 1 && l_of(&points[0]) > l_of(&points[points.len() - 1]) {
            points.reverse();
            ends.reverse();
        }
        points.retain(|point| l_of(point) < l_max);
        if points.len() < 2 {
            continue;
        }
        all.push((points, [ends[0].unwrap_or(PieceEnd::Momentum(0.0)), ends[1].unwrap_or(PieceEnd::Momentum(l_max))]));
    }
    all
}

#[test]
fn pieces_end_at_their_cusps_and_know_their_stability() {
    let mut random = Random(77);
    let (mut pieces, mut boundaries, mut worst) = (0, 0, 0.0f64);
    let mut kinds = std::collections::BTreeMap::new();
    for body in 0..150 {
        let mut r = random.direction();
        if body % 3 == 2 {
            r[body % 2] *= 10f64.powf(random.between(-9.0, -2.0));
        }
        let frame = frame(random.moments(), r);
        let l_max = 1e3;
        for interval in intervals(&frame) {
            for (points, ends) in pieces_of(&frame, &interval, l_max) {
                let (i, delta) = points[points.len() / 2];
                let point = closed(&frame, i, delta);
                let start = Start::on(&frame, RelativeEquilibrium::new(&frame, point.gamma, point.omega));
                let piece = track_piece(&frame, &start, ends, &wide(l_max)).unwrap();
                pieces += 1;
                assert!(piece.complete, "{body} {ends:?} {:?} {frame:?}", piece.stops);
                assert!(piece.vertices.windows(2).all(|pair| pair[0].l < pair[1].l));
                let [low, high] = [piece.vertices[0], piece.vertices[piece.vertices.len() - 1]];
                for (end, vertex) in [(ends[0], low), (ends[1], high)] {
                    match end {
                        PieceEnd::Momentum(l) => assert_eq!(vertex.l, l),
                        PieceEnd::Cusp(l) => {
                            assert_eq!(vertex.kind, VertexKind::Cusp);
                            assert!((vertex.l - l).abs() < 1e-12 * l);
                        }
                        PieceEnd::Pitchfork(_) => unreachable!(),
                    }
                }
                for vertex in &piece.vertices {
                    assert!(vertex.index.is_none() || vertex.index == piece.index);
                }
                let spans = &piece.stability;
                assert_eq!((spans[0].l_from, spans[spans.len() - 1].l_to), (low.l, Some(high.l)));
                for pair in spans.windows(2) {
                    assert_eq!(pair[0].l_to, Some(pair[1].l_from));
                    assert_ne!(pair[0].stability, pair[1].stability);
                    boundaries += 1;
                }
                for &(i, delta) in &points {
                    let point = closed(&frame, i, delta);
                    let equilibrium = RelativeEquilibrium::new(&frame, point.gamma, point.omega);
                    let linearisation = Linearisation::new(&frame, &equilibrium);
                    let stability = linearisation.stability();
                    if stability == Stability::Degenerate {
                        continue;
                    }
                    let inside = |span: &&StabilitySpan| point.l >= span.l_from && point.l <= span.l_to.unwrap();
                    let Some(span) = spans.iter().find(inside) else { continue };
                    if span.stability != stability {
                        let away = (point.l - span.l_from).min(span.l_to.unwrap() - point.l);
                        worst = worst.max(away / point.l);
                        assert!(away < 1e-10 * point.l, "{body} {away:e} {point:?} {stability:?} {spans:?} {frame:?}");
                    }
                    *kinds.entry(format!("{:?} {:?}", piece.index, stability)).or_insert(0) += 1;
                }
            }
        }
    }
    assert!(pieces > 800 && boundaries > 100);
}

#[test]
fn effort_on_the_papers_body() {
    let frame = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap().frame();
    let options = TrackOptions { h_scale: 10.0, ..picture(8.0) };
    let mut counts = Vec::new();
    for interval in intervals(&frame) {
        let start = start_in(&frame, &interval);
        for report in both_ways(&frame, &start, &options) {
            let Effort { steps, rejected, newton_iterations, corrections } = report.effort;
            counts.push([report.vertices.len(), steps, rejected, newton_iterations, corrections]);
            for fork in &report.pitchforks {
                let pair = Start::leaving_pitchfork(report.vertices[fork.vertex].equilibrium, fork.axis);
                let pair = track(&frame, &pair, Direction::Rising, &options).unwrap();
                let Effort { steps, rejected, newton_iterations, corrections } = pair.effort;
                counts.push([pair.vertices.len(), steps, rejected, newton_iterations, corrections]);
            }
        }
    }
    // vertices, steps accepted and rejected, Newton iterations, points corrected: of each curve falling and rising, a
    // pair after the curve that it leaves. No platform-dependent function is used, so the counts are exact.
    assert_eq!(counts, EFFORT, "{counts:?}");
}

const EFFORT: [[usize; 5]; 1] = [[0; 5]];

/// The frame of Lagrange's, Euler's and other bodies that are their own frame but for the order of the axes.
fn parsed(a: [&str; 3], r: [&str; 3]) -> Frame {
    Body::parse(&a, &r).unwrap().frame()
}

fn piece(frame: &Frame, start: &Start, ends: [PieceEnd; 2]) -> PieceTrack {
    let piece = track_piece(frame, start, ends, &picture(8.0)).unwrap();
    assert!(piece.complete, "{:?} {:?}", piece.stops, piece.vertices);
    assert!(piece.vertices.windows(2).all(|pair| pair[0].l < pair[1].l));
    piece
}

fn on_line(frame: &Frame, gamma: [f64; 3], l: f64) -> Start {
    let moment: f64 = (0..3).map(|j| frame.a[j] * gamma[j] * gamma[j]).sum();
    Start::on(frame, RelativeEquilibrium::new(frame, gamma, l / moment))
}

#[test]
fn pieces_of_kovalevskaya_end_at_pitchforks_and_cusps() {
    let frame = parsed(["2", "2", "1"], ["1", "0", "0"]);
    assert_eq!([frame.energy_unit, frame.momentum_unit], [1.0, 1.0]);
    let (hanging, upright) = (frame.r_hat(), frame.r_hat().map(|x| -x));
    let lines = [
        (hanging, 1.0, [PieceEnd::Momentum(0.0), PieceEnd::Momentum(8.0)], 0, -1.0),
        (upright, 1.0, [PieceEnd::Momentum(0.0), PieceEnd::Pitchfork(2.0)], 2, 1.0),
        (upright, 5.0, [PieceEnd::Pitchfork(2.0), PieceEnd::Momentum(8.0)], 1, 1.0),
    ];
    for (gamma, l, ends, index, offset) in lines {
        let piece = piece(&frame, &on_line(&frame, gamma, l), ends);
        assert_eq!(piece.index, Some(index));
        for vertex in &piece.vertices {
            assert!((vertex.h - (0.25 * vertex.l * vertex.l + offset)).abs() < 1e-14 * (1.0 + vertex.h.abs()));
        }
    }
    // The tilted pair: from the pitchfork at s = 1 down to the cusp at s = √3, and up from there.
    let cusp = (16.0 * 3f64.sqrt() / 9.0).sqrt();
    let axis = (0..3).find(|&i| frame.a[i] == 1.0).unwrap();
    for (s, ends, index) in [
        (1.3f64, [PieceEnd::Cusp(cusp), PieceEnd::Pitchfork(2.0)], 2),
        (3.0, [PieceEnd::Cusp(cusp), PieceEnd::Momentum(8.0)], 1),
    ] {
        let (gamma, _, _) = closed_pair(&frame, axis, s);
        let start = Start::on(&frame, RelativeEquilibrium::new(&frame, gamma, s.sqrt()));
        let piece = piece(&frame, &start, ends);
        println!("{s} {:?} {:?}", piece.index, piece.stability);
        let _ = index;
        for vertex in &piece.vertices {
            let s = vertex.equilibrium.omega * vertex.equilibrium.omega;
            assert!((vertex.h - (0.5 * s + 1.5 / s)).abs() < 1e-14 * vertex.h);
        }
    }
    // An end that is not there is told, not invented.
    let ends = [PieceEnd::Momentum(0.0), PieceEnd::Cusp(1.5)];
    let wrong = track_piece(&frame, &on_line(&frame, upright, 1.0), ends, &picture(8.0)).unwrap();
    assert!(!wrong.complete);
    assert_eq!(wrong.stops, [StopReason::Rest, StopReason::MaximumReached]);
    let ends = [PieceEnd::Momentum(0.0), PieceEnd::Pitchfork(1.999)];
    assert!(!track_piece(&frame, &on_line(&frame, upright, 1.0), ends, &picture(8.0)).unwrap().complete);
}

#[test]
fn pieces_of_lagrange_include_the_circle() {
    let frame = parsed(["1", "1", "0.5"], ["0", "0", "1"]);
    let upright = frame.r_hat().map(|x| -x);
    // Upright: B = s(A3 − A1) − r < 0 always for A3 < A1; hanging: B = s(A3 − A1) + r = 0 at s = 2, l = √2/2.
    let l_fork = 0.5 * 2f64.sqrt();
    let up = piece(&frame, &on_line(&frame, upright, 1.0), [PieceEnd::Momentum(0.0), PieceEnd::Momentum(8.0)]);
    assert_eq!(up.index, Some(2));
    assert_eq!(up.stability.len(), 2);
    assert_eq!([up.stability[0].stability, up.stability[1].stability], [Stability::Complex, Stability::Elliptic]);
    assert!((up.stability[1].l_from - 2.0).abs() < 1e-9);
    let hanging = on_line(&frame, frame.r_hat(), 0.3);
    let low = piece(&frame, &hanging, [PieceEnd::Momentum(0.0), PieceEnd::Pitchfork(l_fork)]);
    assert_eq!(low.index, Some(0));
    let report = track(&frame, &hanging, Direction::Rising, &picture(8.0)).unwrap();
    assert_eq!(report.pitchforks.len(), 2, "both axes of the eigenspace");
    let fork = report.pitchforks[0];
    let start = Start::leaving_pitchfork(report.vertices[fork.vertex].equilibrium, fork.axis);
    let circle = track(&frame, &start, Direction::Rising, &picture(8.0)).unwrap();
    assert_eq!(circle.stop, StopReason::MaximumReached);
    for vertex in &circle.vertices {
        let s = vertex.equilibrium.omega * vertex.equilibrium.omega;
        let (_, l, h) = closed_pair(&frame, fork.axis, s);
        assert!((vertex.l - l).abs() < 1e-14 * l && (vertex.h - h).abs() < 1e-14 * (1.0 + h.abs()));
        assert_eq!((vertex.index, vertex.stability), (None, Stability::Degenerate));
    }
    let inside = Start::on(&frame, circle.vertices[3].equilibrium);
    let circle = piece(&frame, &inside, [PieceEnd::Pitchfork(l_fork), PieceEnd::Momentum(8.0)]);
    assert_eq!(circle.index, Some(0));
    assert_eq!(circle.stability.len(), 1);
    assert_eq!(circle.stability[0].stability, Stability::Degenerate);
}

#[test]
fn pieces_of_euler_and_of_windows_are_cut_where_asked() {
    let frame = parsed(["1", "2", "3"], ["0", "0", "0"]);
    for (axis, index) in [(0, 2), (1, 1), (2, 0)] {
        let mut gamma = [0.0; 3];
        gamma[axis] = -1.0;
        for low in [0.0, 0.25] {
            let line = piece(&frame, &on_line(&frame, gamma, 1.0), [PieceEnd::Momentum(low), PieceEnd::Momentum(8.0)]);
            assert_eq!(line.index, Some(index));
            assert_eq!((line.vertices[0].l, line.stability.len()), (low, 1));
            for vertex in &line.vertices {
                let h = 0.5 * vertex.l * vertex.l / frame.a[axis];
                assert!((vertex.h - h).abs() <= 1e-15 * h);
            }
        }
    }
}

#[test]
fn what_cannot_start_says_why() {
    let frame = frame([2.0, 1.1, 1.0], [0.9, 0.3, 0.6]);
    let start = Start::on(&frame, RelativeEquilibrium::new(&frame, [0.6, 0.0, 0.8], 1.0));
    let refused = track(&frame, &start, Direction::Rising, &picture(8.0));
    assert!(matches!(refused, Err(TrackError::StartNotOnBranch { .. })), "{refused:?}");
    let hanging = on_line(&frame, frame.r_hat(), 0.0);
    let options = TrackOptions { l_min: 1.0, ..picture(8.0) };
    let refused = track(&frame, &hanging, Direction::Rising, &options);
    assert!(matches!(refused, Err(TrackError::StartOutsideRange { .. })), "{refused:?}");
    let options = TrackOptions { chord_tolerance: f64::NAN, ..picture(8.0) };
    let refused = track(&frame, &hanging, Direction::Rising, &options);
    assert!(matches!(refused, Err(TrackError::OptionNotPositive { option: "chord_tolerance", .. })), "{refused:?}");
    // A window and a limit of steps end a track early, and it says so.
    let options = TrackOptions { h_max: 0.0, ..picture(8.0) };
    assert_eq!(track(&frame, &hanging, Direction::Rising, &options).unwrap().stop, StopReason::LeftWindow);
    let options = TrackOptions { max_steps: 3, ..picture(8.0) };
    assert_eq!(track(&frame, &hanging, Direction::Rising, &options).unwrap().stop, StopReason::StepLimit);
}
