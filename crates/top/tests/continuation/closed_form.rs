//! The closed form of the relative equilibria, written a second time, in partial fractions about the nearest moment of
//! inertia; random bodies; starts for the tracker.

use top::body::{Axis, Body, Frame};
use top::continuation::{Direction, Start, TrackOptions, TrackReport, Vertex, VertexKind, track};
use top::stability::RelativeEquilibrium;

/// Steele, Lea and Flood's SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number whose logarithm is spread evenly over these decades, more or less.
    pub fn magnitude(&mut self, decades: std::ops::Range<i32>) -> f64 {
        let decade = self.between(f64::from(decades.start), f64::from(decades.end)).floor();
        format!("{}e{decade}", self.between(1.0, 10.0)).parse().unwrap()
    }

    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v: [f64; 3] = std::array::from_fn(|_| self.between(-1.0, 1.0));
            let square: f64 = v.iter().map(|x| x * x).sum();
            if square > 0.01 && square <= 1.0 {
                return v.map(|x| x / square.sqrt());
            }
        }
    }

    pub fn moments(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.between(0.1, 2.0))
    }
}

pub fn frame(a: [f64; 3], r: [f64; 3]) -> Frame {
    Body::from_f64(a, r).unwrap().frame()
}

/// The generic family at μ = A_i + δ.
#[derive(Debug)]
pub struct Closed {
    pub gamma: [f64; 3],
    pub omega: f64,
    pub l: f64,
    pub h: f64,
    /// |δ|(4Q'/Q − 3P'/P): changes its sign at cusps.
    pub turning: f64,
}

pub fn closed(frame: &Frame, i: usize, delta: f64) -> Closed {
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
        turning: delta.abs() * (4.0 * q_slope / q - 3.0 * p_slope / p),
    }
}

/// The pair over μ = A_i at squared angular velocity s, with γ_i ≥ 0: (γ, l, h).
pub fn closed_pair(frame: &Frame, i: Axis, s: f64) -> ([f64; 3], f64, f64) {
    let mut gamma = [0.0; 3];
    let mut r_tilde = 0.0;
    let mut rest = 1.0;
    for j in Axis::ALL.into_iter().filter(|&j| j != i && frame.r[j] != 0.0) {
        gamma[j] = frame.r[j] / (s * frame.diff[i][j]);
        rest -= gamma[j] * gamma[j];
        r_tilde += frame.r[j] * frame.r[j] / frame.diff[i][j];
    }
    gamma[i] = rest.max(0.0).sqrt();
    let l = s.sqrt() * (frame.a[i] - r_tilde / (s * s));
    (gamma, l, 0.5 * s * frame.a[i] - 1.5 * r_tilde / s)
}

/// √P̂: the squared angular velocity at which the pair over A_i leaves the generic family.
pub fn pair_start(frame: &Frame, i: Axis) -> f64 {
    Axis::ALL
        .into_iter()
        .filter(|&j| j != i && frame.r[j] != 0.0)
        .map(|j| frame.r[j] / frame.diff[i][j])
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt()
}

/// The intervals of μ between those moments that the generic family feels, as points (i, δ), each interval in order.
pub fn intervals(frame: &Frame) -> Vec<Vec<(usize, f64)>> {
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
    all.iter().map(|points| with_dips(frame, points)).collect()
}

/// The same points, and one between each two cusps that fall between neighbours: there the turning dips through zero.
fn with_dips(frame: &Frame, points: &[(usize, f64)]) -> Vec<(usize, f64)> {
    let turning = |(i, delta): (usize, f64)| closed(frame, i, delta).turning;
    let values: Vec<f64> = points.iter().map(|&point| turning(point)).collect();
    let mut refined = points.to_vec();
    for (three, values) in points.windows(3).zip(values.windows(3)) {
        let [first, last] = [three[0], three[2]];
        let sign = values[1].signum();
        let dips = sign * values[1] <= sign * values[0] && sign * values[1] <= sign * values[2];
        if first.0 != last.0 || !dips {
            continue;
        }
        let height = |point| sign * turning(point);
        let (mut low, mut high) = (first.1, last.1);
        for _ in 0..60 {
            let (left, right) = (low + 0.4 * (high - low), high - 0.4 * (high - low));
            if height((first.0, left)) < height((first.0, right)) { high = right } else { low = left }
        }
        if height((first.0, low)) < 0.0 {
            refined.push((first.0, low));
        }
    }
    let offset = |i: usize| frame.diff[i][points[0].0];
    let rising = points.windows(2).all(|pair| offset(pair[0].0) + pair[0].1 <= offset(pair[1].0) + pair[1].1);
    assert!(rising);
    refined.sort_by(|&(i, x), &(k, y)| if i == k { x.total_cmp(&y) } else { i.cmp(&k) });
    refined
}

/// A start inside an interval where l is small.
pub fn start_in(frame: &Frame, interval: &[(usize, f64)]) -> Start {
    Start::on(frame, start_in_equilibrium(frame, interval))
}

pub fn start_in_equilibrium(frame: &Frame, interval: &[(usize, f64)]) -> RelativeEquilibrium {
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
pub fn difference_generic(frame: &Frame, vertex: &Vertex) -> f64 {
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

pub fn cusps(report: &TrackReport) -> Vec<Vertex> {
    report.vertices.iter().filter(|vertex| vertex.kind == VertexKind::Cusp).copied().collect()
}

pub fn both_ways(frame: &Frame, start: &Start, options: &TrackOptions) -> [TrackReport; 2] {
    [Direction::Falling, Direction::Rising].map(|way| track(frame, start, way, options).unwrap())
}

/// The cusps of an interval as (i, δ), in its order, by bisection of the closed form.
pub fn cusp_points(frame: &Frame, interval: &[(usize, f64)]) -> Vec<(usize, f64)> {
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
pub fn cusps_of(frame: &Frame, interval: &[(usize, f64)], l_max: f64) -> Vec<f64> {
    let mut found: Vec<f64> =
        cusp_points(frame, interval).iter().map(|&(i, delta)| closed(frame, i, delta).l).collect();
    found.retain(|&l| l < l_max);
    found.sort_by(f64::total_cmp);
    found
}

pub fn wide(l_max: f64) -> TrackOptions {
    TrackOptions { l_max, l_scale: l_max, h_scale: l_max * l_max, chord_tolerance: 1e-3, ..TrackOptions::default() }
}

pub fn picture(l_max: f64) -> TrackOptions {
    TrackOptions { l_max, l_scale: l_max, h_scale: l_max * l_max, chord_tolerance: 1e-3, ..TrackOptions::default() }
}
