//! The tracker against the closed form of the relative equilibria, which is written here a second time, in partial
//! fractions about the nearest moment of inertia.

use bifdiag::body::{Body, Frame};
use bifdiag::continuation::{
    AtEvent, Direction, PieceEnd, Start, StopReason, TrackOptions, TrackReport, Vertex, VertexKind, track, track_piece,
};
use bifdiag::stability::RelativeEquilibrium;

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
    let steps = 1500;
    // From 1e-14 to 1e5, evenly in the logarithm.
    let ratio = 10f64.powf(19.0 / f64::from(steps));
    let mut ladder = vec![1e-14];
    for _ in 0..steps {
        ladder.push(ladder[ladder.len() - 1] * ratio);
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

fn start_at(frame: &Frame, i: usize, delta: f64) -> Start {
    let point = closed(frame, i, delta);
    Start::on(frame, RelativeEquilibrium::new(frame, point.gamma, point.omega))
}

/// A start inside an interval where l is far below `l_max`.
fn start_in(frame: &Frame, interval: &[(usize, f64)]) -> Start {
    let (i, delta) = interval
        .iter()
        .copied()
        .filter(|&(_, delta)| delta.abs() < 10.0)
        .min_by(|&(i, x), &(j, y)| closed(frame, i, x).l.total_cmp(&closed(frame, j, y).l))
        .unwrap();
    // Off the minimum of l, which may be a cusp.
    start_at(frame, i, delta * 1.0625)
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

/// l at the cusps of an interval below `l_max`, by bisection of the closed form.
fn cusps_of(frame: &Frame, interval: &[(usize, f64)], l_max: f64) -> Vec<f64> {
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
        found.push(closed(frame, i, low).l);
    }
    found.retain(|&l| l < l_max);
    found.sort_by(f64::total_cmp);
    found
}

fn wide(l_max: f64) -> TrackOptions {
    TrackOptions { l_max, l_scale: l_max, h_scale: l_max * l_max, chord_tolerance: 1e-3, ..TrackOptions::default() }
}

#[test]
fn a_thousand_generic_bodies_agree_with_the_closed_form() {
    let mut random = Random(2008);
    let (mut worst, mut vertices, mut turns, mut worst_cusp) = (0.0f64, 0, 0, 0.0f64);
    let mut spent = 0.0;
    for body in 0..1000 {
        let mut r = random.direction();
        if body % 4 == 3 {
            // Near a coordinate plane.
            r[body % 3] *= 10f64.powf(random.between(-9.0, -1.0));
        }
        let frame = frame(random.moments(), r);
        let l_max = 1e4;
        for (number, interval) in intervals(&frame).iter().enumerate() {
            let start = start_in(&frame, interval);
            let began = std::time::Instant::now();
            let reports = both_ways(&frame, &start, &wide(l_max));
            spent += began.elapsed().as_secs_f64();
            let mut found = Vec::new();
            for report in &reports {
                let expected = if number == 0 || number == 3 {
                    [StopReason::Rest, StopReason::MaximumReached]
                } else {
                    [StopReason::MaximumReached; 2]
                };
                assert!(expected.contains(&report.stop), "{body} {number} {:?} {frame:?}", report.stop);
                for vertex in &report.vertices {
                    worst = worst.max(difference_generic(&frame, vertex));
                }
                vertices += report.vertices.len();
                found.extend(cusps(report).iter().map(|vertex| vertex.l));
            }
            found.sort_by(f64::total_cmp);
            let truth = cusps_of(&frame, interval, l_max);
            assert_eq!(found.len(), truth.len(), "{body} {number}: {found:?} {truth:?} {frame:?}");
            turns += found.len();
            for (x, y) in found.iter().zip(&truth) {
                worst_cusp = worst_cusp.max(((x - y) / y).abs());
            }
        }
    }
    println!(
        "worst {worst:e}, cusps {turns} worst {worst_cusp:e}, vertices {vertices}, {:.3} us/vertex",
        1e6 * spent / vertices as f64
    );
    assert!(worst < 1e-12, "{worst:e}");
    assert!(worst_cusp < 1e-12, "{worst_cusp:e}");
}
