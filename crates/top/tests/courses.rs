//! Polylines and ranges of curves where moments are of very different size.

use top::atlas::{Atlas, CourseOptions};
use top::body::Body;

fn atlas(a: [&str; 3], r: [&str; 3]) -> Atlas {
    Atlas::new(&Body::parse(&a, &r).unwrap()).unwrap()
}

/// Pole lines of a needle rise by 10¹² over the width of the diagram: measured in h alone their chords would be millions.
#[test]
fn polylines_of_a_needle_have_few_points() {
    for moment in ["1e-5", "1e-8", "1e-11", "1e-15"] {
        let atlas = atlas(["0.4066", moment, "1.9252"], ["1e-2", "1", "0"]);
        let options = CourseOptions { chord_tolerance: 1.25e-3, l_least: 0.0 };
        for curve in atlas.arrangement().set.curves.ids() {
            let points = atlas.course(curve, &options).len();
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
