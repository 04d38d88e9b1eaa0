//! Polylines and ranges of curves where moments are of very different size.

use bifdiag_body::Body;
use bifdiag_diagram::atlas::{Atlas, PolylineOptions};
use bifdiag_equilibria::curves::CurveName;
use proptest::prelude::*;
use support::property::holds_for_bodies;
use support::strata::STRATA;

fn atlas(a: [&str; 3], r: [&str; 3]) -> Atlas {
    bifdiag_diagram::fast::atlas(&Body::parse(&a, &r).unwrap()).unwrap()
}

/// Pole lines of a needle rise by 10¹² over the width of the diagram: measured in h alone their chords would be millions.
#[test]
fn polylines_of_a_needle_have_few_points() {
    for moment in ["1e-5", "1e-8", "1e-11", "1e-15"] {
        let atlas = atlas(["0.4066", moment, "1.9252"], ["1e-2", "1", "0"]);
        let options = PolylineOptions { chord_tolerance: 1.25e-3, l_least: 0.0 };
        for curve in atlas.arrangement().set.curves.ids() {
            let points = atlas.polyline_of(curve, &options).len();
            assert!((2..3000).contains(&points), "{moment}: {points} points");
        }
    }
}

/// The ends of an axis curve are the moments over which it has pitchforks, to the last bit.
#[test]
fn a_range_of_mu_ends_at_the_moment_of_its_pitchfork() {
    for moment in [1e-6, 1e-12, 1e-18] {
        let atlas = atlas(["0.4066", &format!("{moment:e}"), "1.9252"], ["0", "0", "1e-6"]);
        let curves = atlas.arrangement().set.curves.ids();
        let ranges: Vec<[Option<f64>; 2]> = curves.filter_map(|curve| atlas.mu_range(curve)).collect();
        for expected in [[None, Some(moment)], [Some(moment), Some(0.4066)], [Some(0.4066), Some(1.9252)]] {
            assert!(ranges.contains(&expected), "{moment}: {ranges:?}");
        }
    }
}

/// Chords are measured as docs/formats.md says: in h, across the chord, in units of the height and of the width.
#[test]
fn no_chord_leaves_its_curve_by_more_than_the_tolerance() {
    const TOLERANCE: f64 = 1.25e-3;
    let options = PolylineOptions { chord_tolerance: TOLERANCE, l_least: 0.0 };
    let (mut curves, mut points, mut largest, mut time) = (0, 0, 0.0_f64, std::time::Duration::ZERO);
    let totals = std::cell::RefCell::new((&mut curves, &mut points, &mut largest, &mut time));
    for stratum in STRATA {
        holds_for_bodies(stratum, 40, |body| {
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            let set = &atlas.arrangement().set;
            let frame = &set.frame;
            let last = atlas.arrangement().events.last().map_or(0.0, |event| (2.0 * event.x).sqrt());
            let width = (1.6 * last).max(3.0 * (frame.r_norm.max(1.0) * frame.a[2]).sqrt());
            let height = 0.5 * width * width / frame.a[2] + 2.0 * frame.r_norm;
            for id in set.curves.ids() {
                let curve = &set.curves[id];
                let begin = std::time::Instant::now();
                let course = atlas.polyline_of(id, &options);
                let mut totals = totals.borrow_mut();
                *totals.3 += begin.elapsed();
                *totals.0 += 1;
                *totals.1 += course.len();
                let scaled: Vec<[f64; 2]> =
                    course.iter().map(|[h, l]| [h / frame.energy_unit, l / frame.momentum_unit]).collect();
                let from = (2.0 * curve.x()[0]).sqrt();
                prop_assert!((scaled[0][1] - from).abs() <= 1e-9 * from, "{from} {scaled:?}");
                for pair in scaled.windows(2) {
                    let [[h0, l0], [h1, l1]] = [pair[0], pair[1]];
                    prop_assert!(l0 < l1, "{pair:?}");
                    let slope = (h1 - h0) / (l1 - l0);
                    let across = {
                        let steep = slope * width / height;
                        (1.0 + steep * steep).sqrt()
                    };
                    for k in 1..16 {
                        let t = f64::from(k) / 16.0;
                        let l = l0 + t * (l1 - l0);
                        let x = (0.5 * l * l).max(curve.x()[0]).min(curve.x()[1]);
                        let point = curve.point(frame, x.max(1e-60));
                        let noise = 4.0 * point.h_error() + 64.0 * f64::EPSILON * h0.abs().max(h1.abs());
                        let off = ((point.h() - h0 - t * (h1 - h0)).abs() - noise) / across / height / TOLERANCE;
                        prop_assert!(off <= 1.0, "{off} of the tolerance at {l} on {curve:?}");
                        *totals.2 = totals.2.max(off);
                    }
                }
            }
            Ok(())
        });
    }
    println!("{curves} curves, {points} points, largest deviation {largest} of the tolerance, {time:?}");
}

/// Insets over rods of 1e-9 and thinner took seconds and minutes.
#[test]
fn a_picture_of_a_rod_needs_few_points() {
    let count = |thickness: f64| {
        let atlas =
            bifdiag_diagram::fast::atlas(&Body::from_f64([1.0, thickness, 1.0], [1.0, 1.382, 1.0]).unwrap()).unwrap();
        let set = &atlas.arrangement().set;
        let names = set.curves.ids().map(|curve| CurveName::of(set, curve));
        names.filter_map(|name| atlas.polyline_to_draw(name, [0.0, 3.0], 1e-4)).map(|points| points.len()).max()
    };
    for thickness in [1e-3, 1e-9, 1e-14] {
        assert!(count(thickness).unwrap() < 2000, "{thickness:e}: {:?}", count(thickness));
    }
}
