//! Pieces of special bodies, and tracks that end early.

use top::body::{Axis, Body, Frame};
use top::continuation::{
    Direction, PieceEnd, PieceTrack, Start, StopReason, TrackError, TrackOptions, track, track_piece,
};
use top::stability::RelativeEquilibrium;

use crate::closed_form::{closed_pair, frame, picture};

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
    let axis = Axis::ALL.into_iter().find(|&i| frame.a[i] == 1.0).unwrap();
    for (s, ends, index) in [
        (1.3f64, [PieceEnd::Cusp(cusp), PieceEnd::Pitchfork(2.0)], 1),
        (3.0, [PieceEnd::Cusp(cusp), PieceEnd::Momentum(8.0)], 2),
    ] {
        let (gamma, _, _) = closed_pair(&frame, axis, s);
        let start = Start::on(&frame, RelativeEquilibrium::new(&frame, gamma, s.sqrt()));
        let piece = piece(&frame, &start, ends);
        assert_eq!(piece.index, Some(index));
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
        assert_eq!(vertex.index, None);
    }
    let inside = Start::on(&frame, circle.vertices[3].equilibrium);
    let circle = piece(&frame, &inside, [PieceEnd::Pitchfork(l_fork), PieceEnd::Momentum(8.0)]);
    assert_eq!(circle.index, Some(0));
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
            assert_eq!(line.vertices[0].l, low);
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
