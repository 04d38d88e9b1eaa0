//! Bodies with some r_i = 0: pitchforks, switching of branches, effort.

use top::body::{Axis, Body};
use top::continuation::{Direction, Effort, Start, StopReason, TrackOptions, VertexKind, track};
use top::stability::RelativeEquilibrium;

use crate::closed_form::{
    Random, both_ways, closed_pair, cusps, difference_generic, frame, intervals, pair_start, picture, start_in, wide,
};

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
        let free: Vec<Axis> = Axis::ALL.into_iter().filter(|&i| frame.r[i] == 0.0).collect();
        let expected = free.iter().filter(|&&i| closed_pair(&frame, i, pair_start(&frame, i)).1 < l_max).count();
        assert_eq!(met.len(), expected, "{frame:?}");
        for (axis, vertex) in met {
            assert!(free.contains(&axis));
            let s = pair_start(&frame, axis);
            let (gamma, l, h) = closed_pair(&frame, axis, s);
            worst = worst.max(((vertex.l - l) / l).abs()).max((vertex.h - h).abs() / (s * frame.a[2] + frame.r_norm));
            for j in axis.others() {
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
                for j in axis.others() {
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

const EFFORT: [[usize; 5]; 7] = [
    [5, 4, 1, 20, 7],
    [18, 17, 4, 74, 23],
    [12, 11, 5, 130, 43],
    [8, 7, 3, 44, 12],
    [9, 8, 3, 51, 15],
    [5, 4, 0, 17, 6],
    [15, 14, 0, 47, 16],
];
