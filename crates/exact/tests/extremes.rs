//! Bodies on the way into the extremes: the proof finishes, and what it finds far in is what `f64` finds where the way
//! begins, since no border of diagrams lies between.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_exact::{Accuracy, CertifiedAtlas};
use dashu_ratio::RBig;

type Parts = [RBig; 6];

fn n(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

fn body([a, b, c, x, y, z]: Parts) -> Body {
    Body::new([a, b, c].map(Number::from_rational), [x, y, z].map(Number::from_rational)).unwrap()
}

/// The classes of all regions, in a canonical order.
fn classes(atlas: &Atlas) -> Vec<String> {
    let mut all: Vec<String> =
        atlas.regions().ids().map(|region| format!("{:?}", atlas.components(region).unwrap())).collect();
    all.sort();
    all
}

/// At each of these distances 10⁻ᵏ the classes are those that `f64` finds at 10⁻ᶠⁱʳˢᵗ.
fn stays_the_same(first: isize, further: &[isize], parts: impl Fn(&RBig) -> Parts) {
    let at = |exponent: isize| body(parts(&(RBig::ONE / RBig::from(10).pow(exponent))));
    let near = bifdiag_diagram::fast::atlas(&at(first)).unwrap();
    assert!(near.arrangement().undecided.is_empty());
    let expected = classes(&near);
    for &exponent in further {
        let found = bifdiag_exact::atlas(&at(exponent), Accuracy::Exact)
            .unwrap_or_else(|error| panic!("1e-{exponent}: {error}"));
        assert_eq!(classes(&found), expected, "1e-{exponent}");
        let proved = CertifiedAtlas::new(&at(exponent)).unwrap_or_else(|error| panic!("1e-{exponent}: {error}"));
        assert_eq!(proved.region_count(), expected.len(), "1e-{exponent}");
        support::sanity::check(&found).unwrap_or_else(|contradiction| panic!("1e-{exponent}: {contradiction}"));
    }
}

#[test]
fn beside_a_principal_axis() {
    stays_the_same(6, &[12, 18], |e| [n("1.3"), n("1"), n("0.7"), n("2") * e, n("1"), e.clone()]);
}

#[test]
fn beside_a_principal_plane() {
    stays_the_same(6, &[9, 12, 15, 18], |e| [n("2"), n("1.1"), n("1"), n("0.94868"), e.clone(), n("0.61623")]);
    stays_the_same(6, &[12, 18], |e| [n("1"), n("1.3"), n("1.9"), n("0.8"), n("0.6"), e.clone()]);
}

#[test]
fn nearly_equal_moments() {
    stays_the_same(6, &[12, 15, 18], |e| [n("1"), n("1") + e, n("1.3"), n("0.3"), n("0.5"), n("0.7")]);
    stays_the_same(6, &[15, 18], |e| [n("1"), n("1") + e, n("1") + n("3") * e, n("0.3"), n("0.5"), n("0.7")]);
}

#[test]
fn beside_lagranges_top() {
    stays_the_same(4, &[6, 9, 12, 15, 18], |e| [n("1"), n("1") + e, n("0.7"), e.clone(), n("0"), n("1")]);
}

/// A pitchfork that closes, unfolded: the cusp, and where J turns, lie at r^(2/3) beside the moment.
#[test]
fn beside_a_pitchfork_that_closes() {
    let [a1, a2, a3] = ["0.5335445764818469", "0.2726262799294564", "1.791118966267618"];
    let [y, z] = ["0.24196137102693221", "-0.8578541005417981"];
    stays_the_same(6, &[9, 11, 12, 15, 18], |e| [n(a1), n(a2), n(a3), n("0.9987910082802236") * e, n(y), n(z)]);
}

/// The sample between two cusps lies so near to one of them that doubles do not tell the branches apart.
#[test]
fn beside_two_cusps_that_close() {
    let far = [12, 19, 24];
    stays_the_same(6, &far, |e| {
        [n("1.348005"), n("0.663727"), n("1.859914"), n("0.198682"), e.clone(), n("-1.391041")]
    });
    stays_the_same(6, &[12, 17, 24], |e| [n("1"), n("1e-6"), n("1"), n("0.5"), e.clone(), n("0.48")]);
}

/// Beside a tiny component the pair's family all but has no fold, and the terms of ∂x/∂v all but cancel over a long stretch.
/// Too near for `f64` from where on the number of regions stays the same.
#[test]
fn beside_a_fold_of_the_pair() {
    let regions = ["5.7314e-15", "5.7314e-18", "5.7314e-20"].map(|z| {
        let body = body(["0.63389", "1.335965", "1.001301", "-0.00862", "-0.257673", z].map(n));
        CertifiedAtlas::new(&body).unwrap_or_else(|error| panic!("{z}: {error}")).region_count()
    });
    assert_eq!(regions, [18; 3]);
}

#[test]
fn rods() {
    stays_the_same(6, &[9, 12, 18], |e| [e.clone(), n("1"), n("1") + e / n("2"), n("1"), n("0.3"), n("0.2")]);
}

/// A pair's cusp all but in its pitchfork, and three curves all but in one point: the borders of Katok's classes.
#[test]
fn beside_katoks_borders() {
    stays_the_same(4, &[6, 9, 12, 15, 18, 30], |e| [n("1"), n("1.4"), n("0.75") - e, n("1"), n("0"), n("0")]);
    stays_the_same(6, &[9, 12, 15, 18, 26, 30, 40, 50], |e| {
        [n("1"), RBig::from(5) / RBig::from(9), n("0.5") + e, n("1"), n("0"), n("0")]
    });
    stays_the_same(6, &[12, 18], |e| [n("1"), n("1") - e, n("1.4"), n("1"), n("0"), n("0")]);
}

/// Two families over moments that all but coincide, with their cusps, run side by side wherever r lies on the third axis.
#[test]
fn beside_lagranges_top_with_cusps() {
    for largest in ["2", "1.9", "1.5"] {
        stays_the_same(4, &[9, 10, 12, 15, 18], |e| [n(largest), n("1") + e, n("1"), n("1"), n("0"), n("0")]);
    }
    stays_the_same(4, &[11, 18], |e| [n("1.25"), n("1") + e, n("1"), n("0.6"), n("0"), n("0")]);
    // The smallest axis, and the other one of the two.
    stays_the_same(4, &[9, 12, 18], |e| [n("1"), n("1") + e, n("0.6"), n("0"), n("0"), n("1")]);
    stays_the_same(4, &[9, 12, 18], |e| [n("1"), n("1") + e, n("2"), n("0"), n("0"), n("-0.7")]);
}

/// Four curves and more run side by side: where they part follows from what their points share over one x.
#[test]
fn nearly_equal_moments_beside_an_axis() {
    stays_the_same(4, &[9, 18], |e| {
        [n("1.26"), n("1.26") * (n("1") + e), n("1.56"), n("0.38") * e, n("0.68") * e, n("0.11")]
    });
    stays_the_same(4, &[9, 12], |e| {
        [n("0.74"), n("0.74") * (n("1") + e), n("1.379"), n("0.9") * e, n("0.8") * e, n("0.69")]
    });
    stays_the_same(4, &[12, 18], |e| [n("2"), n("1") + e, n("1"), n("1"), e.clone(), n("0")]);
}

/// Rods whose other moments are nearly equal: too near for `f64` from where on the number of regions stays the same.
#[test]
fn rods_beside_a_plane_and_an_axis() {
    for exponent in [4, 9, 15] {
        let e = RBig::ONE / RBig::from(10).pow(exponent);
        let moments = |a: &str| [e.clone(), n(a), n(a) * (n("1") + &e)];
        for ([a, b, c], [x, y, z]) in [
            (moments("1.74"), [n("0.89"), n("0"), &e / n("100")]),
            (moments("1.96"), [n("0.6"), &e / n("300"), &e / n("5")]),
        ] {
            let proved = CertifiedAtlas::new(&body([a, b, c, x, y, z]));
            let regions = proved.unwrap_or_else(|error| panic!("1e-{exponent}: {error}")).region_count();
            assert_eq!(regions, 8, "1e-{exponent}");
        }
    }
}

#[test]
fn what_is_not_proved_is_named_by_the_ids_of_curves() {
    let parts = |e: RBig| [n("1"), RBig::from(5) / RBig::from(9), n("0.5") + e, n("1"), n("0"), n("0")];
    let error = CertifiedAtlas::new(&body(parts(RBig::ONE / RBig::from(10).pow(200)))).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("S2.2") && !text.contains('#'), "{text}");
}
