//! Whole branches of generic bodies: vertices, cusps, chords.

use top::body::Frame;
use top::continuation::{StopReason, TrackOptions, Vertex};

use crate::closed_form::{
    Random, both_ways, closed, cusps, cusps_of, difference_generic, frame, intervals, picture, start_in,
    start_in_equilibrium, wide,
};

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
            r[body % 3] *= random.magnitude(-9..-1);
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
        let (vertex, cusp, _turns) = compare_generic(&frame(a, r), 1e8);
        worst = worst.max(vertex).max(cusp);
    }
    assert!(worst < 1e-12, "{worst:e}");
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
            r[body % 3] *= random.magnitude(-6..-1);
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
                    // The 64th root.
                    let ratio = (0..6).fold(delta(to) / delta(from), |x, _| x.sqrt());
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
    assert!(curves > 700 && vertices > 100_000, "{curves} {vertices}");
}

fn start_l(frame: &Frame, interval: &[(usize, f64)]) -> f64 {
    start_in_equilibrium(frame, interval).l(frame)
}
