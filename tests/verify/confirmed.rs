//! Documents that are true are confirmed.

use std::cell::RefCell;

use bifdiag_body::Preset;
use bifdiag_exact::CertifiedAtlas;
use bifdiag_verify::{Refused, verify};
use proptest::prelude::*;
use support::property::{body_text, holds_for_bodies};
use support::strata::STRATA;

use crate::made::{body, certified, document, forged, whole};

fn are_verified(bodies: &[[[&str; 3]; 2]]) {
    for numbers in bodies {
        verify(&whole(&body(*numbers))).unwrap_or_else(|refused| panic!("{numbers:?}: {refused}"));
    }
}

#[test]
fn bodies_of_every_stratum_are_verified() {
    let unproved = RefCell::new(Vec::new());
    for stratum in STRATA {
        holds_for_bodies(stratum, 2, |body| {
            match CertifiedAtlas::new(body) {
                Ok(atlas) => {
                    verify(&certified(&atlas)).map_err(|refused| TestCaseError::fail(refused.to_string()))?;
                }
                // Two curves of a planted body may lie closer than the prover's bits tell.
                Err(_) if stratum.is_planted() => unproved.borrow_mut().push(body_text(body)),
                Err(error) => return Err(TestCaseError::fail(error.to_string())),
            }
            Ok(())
        });
    }
    assert!(unproved.borrow().len() <= 1, "not proved: {unproved:?}");
}

#[test]
fn the_presets_are_verified() {
    for preset in Preset::all() {
        let report = verify(&document(&preset.body())).unwrap_or_else(|error| panic!("{}: {error}", preset.name()));
        assert!(report.regions > 0, "{}", preset.name());
    }
    let border = body([["1", "5/9", "1/2"], ["1", "0", "0"]]);
    assert!(verify(&document(&border)).unwrap().regions > 0);
}

/// A distance ε from the triple point of Katok's borders, two of its events are 2ε² apart: their enclosures are written
/// with as many digits as it takes.
#[test]
fn events_next_to_a_triple_point_are_verified() {
    for exponent in [22, 50] {
        let third = format!("0.5{}1", "0".repeat(exponent - 2));
        let numbers = [["1", "5/9", &third], ["1", "0", "0"]];
        let report = verify(&document(&body(numbers))).unwrap_or_else(|refused| panic!("1e-{exponent}: {refused}"));
        assert_eq!((report.regions, report.events), (7, 7), "1e-{exponent}");
    }
}

/// Two families over moments that differ by 10⁻¹², each with a cusp.
#[test]
fn families_beside_each_other_on_an_axis_are_verified() {
    let true_one = document(&body([["2", "1.000000000001", "1"], ["1", "0", "0"]]));
    verify(&true_one).unwrap();
    // The order that one lemma gives all along, the other way round.
    let refused = forged(&true_one, |d| {
        let pairs = &mut d.certificate.as_mut().unwrap().pairs;
        let mut stretches = pairs.iter_mut().flat_map(|pair| &mut pair.stretches);
        let at_once = stretches.find(|stretch| stretch.from.x.is_none() && stretch.to.x.is_none()).unwrap();
        at_once.sign = -at_once.sign;
    });
    assert!(matches!(refused, Err(Refused::Pair { .. })), "{refused:?}");
}

/// Moments that differ by 10⁻¹², r as near an axis or a plane, and a rod: the order follows from Lemma 7.8.
#[test]
fn curves_side_by_side_are_verified() {
    are_verified(&[
        [["1.26", "1.26000000000126", "1.56"], ["38e-14", "68e-14", "0.11"]],
        [["2", "1.000000000001", "1"], ["1", "1e-12", "0"]],
        [["1e-9", "1.74", "1.74000000174"], ["0.89", "0", "1e-11"]],
        [["1/5", "100000000000000001/500000000000000000", "9999/50000"], ["1/1000", "1001/1000000", "1/1000"]],
    ]);
}

/// Two branches run side by side from the cusps at which both begin to that at which one of them ends: no box holds the
/// family that joins them beside a cusp (Lemma 7.6).
#[test]
fn branches_that_end_at_a_cusp_are_verified() {
    are_verified(&[
        [["2", "0.1", "2.169"], ["1.56e-8", "1.2e-12", "1"]],
        [["5.1e-7", "1.343", "6.3e-2"], ["6.7e-15", "6.6e-9", "1.871"]],
        [["1", "1e-7", "2"], ["0", "1e-7", "1"]],
    ]);
}

/// Their atlases are true, but for polylines beside the border of Katok's classes, which are no part of the proof.
#[test]
fn bodies_beside_three_quarters_are_verified() {
    are_verified(&[
        [["1", "1.4", "0.7499999999"], ["1", "0", "0"]],
        [["1", "1.4", "0.7499999999999"], ["1", "0", "0"]],
    ]);
}

/// Two real pairs meet at 0, where the discriminant vanishes exactly at the end of a curve.
#[test]
fn all_eigenvalues_may_vanish_at_a_pitchfork() {
    are_verified(&[
        [["3", "4", "5"], ["0", "0", "1"]],
        [["5", "3", "4"], ["1", "0", "0"]],
        [["0.8", "1", "0.6"], ["0", "-2", "0"]],
    ]);
}

/// A hypothesis of Arnold's theorem fails exactly in the middle of the range in which the rotation is elliptic.
#[test]
fn arnolds_theorem_may_fail_in_the_middle_of_a_range() {
    are_verified(&[[["6", "2", "1"], ["0", "1", "0"]]]);
}

/// The place of a meeting with a pole line is a rational number, and so both ends of the range in which it is isolated.
#[test]
fn a_meeting_at_a_rational_place_is_verified() {
    are_verified(&[[["3", "5", "2"], ["1", "3", "0"]]]);
}

/// Just below ¾ a pair of saddles lies beside the standing or hanging rotation, with barriers of the square of what is missing: what
/// they join follows from the symmetry and the saddle between the two other minima (Corollary 9.8), where no path is proved.
#[test]
fn bodies_just_below_three_quarters_are_verified() {
    are_verified(&[
        [["1", "0.749999925", "0.393"], ["1", "0", "0"]],
        [["1.634", "6127497549/5000000000", "0.492"], ["1", "0", "0"]],
        [["0.509", "1526998473/4000000000", "0.345"], ["1", "0", "0"]],
        [["1.339", "100424999999995983/100000000000000000", "0.921"], ["1", "0", "0"]],
        [["1.739", "26084999999984349/20000000000000000", "0.477"], ["1", "0", "0"]],
        [["1.8", "2.8000000000000003", "2.1"], ["0", "-1", "0"]],
    ]);
}

/// Rods whose curves are no lines that doubles can draw.
#[test]
fn rods_whose_drawing_is_coarse_are_verified() {
    are_verified(&[
        [["6e-15", "1.841", "7.3e-12"], ["1.076", "0", "4e-18"]],
        [["1e-17", "0.357", "0.574"], ["0.954", "1.171", "0.572"]],
    ]);
}

/// Bodies whose curves run side by side over x up to 10¹⁵.
#[test]
fn curves_of_close_moments_are_verified() {
    are_verified(&[
        [["1", "1.000000000000001", "1.7"], ["0.3", "0.2", "1e-8"]],
        [["1", "1.000000000000001", "1.7"], ["0.3", "0.2", "1e-9"]],
        [["1", "1.00000000000001", "1.7"], ["0.3", "0.2", "1e-9"]],
        [["1", "1.0000000000000001", "1.7"], ["0.3", "0.2", "1e-9"]],
        [["1", "1.000000000000001", "1.7"], ["0.5", "0.2", "3e-9"]],
        [["1", "1.000000000000001", "1.7"], ["0.3", "0.6", "1e-9"]],
    ]);
}

/// Two branches side by side with a moment between them that no r_i carries them over: their moments of inertia over one x are
/// close (Lemma 7.8).
#[test]
fn branches_beside_two_close_moments_are_verified() {
    are_verified(&[[["1.2190000000000000073140", "1.219", "1.484"], ["1.0e-8", "2.2e-9", "1.560"]]]);
}

/// Saddles that are mirror images of each other, beside a minimum to which no path leads in doubles, and maxima above all
/// else: what is known of the other saddles tells what they join (Corollary 9.8).
#[test]
fn saddles_to_which_no_path_is_found_are_verified() {
    are_verified(&[
        [["2", "1.076", "1e-12"], ["1e-12", "0", "1"]],
        [["0.351", "1.085", "1.436"], ["5.3e-15", "0", "1.408"]],
    ]);
}

/// Two moments that are nearly equal, so that valleys run along circles: a way down one of them is a few arcs, and would be
/// hundreds of segments.
#[test]
fn valleys_along_circles_are_gone_down() {
    are_verified(&[[["1", "1.00000001", "1.338"], ["7e-15", "3e-9", "-0.910"]]]);
}

/// A change of the linear type lies so near the end of a family that its h is that of the document to the last digit only:
/// a range of 2⁻¹⁰⁰ of the family does not tell it.
#[test]
fn a_change_beside_the_end_of_a_family_is_verified() {
    let true_one = whole(&body([["1", "1e-10", "1"], ["1e-10", "1", "0"]]));
    verify(&true_one).unwrap();
    for shift in [-1e-12, 1e-12] {
        let refused = forged(&true_one, |d| d.stability_changes.iter_mut().for_each(|change| change.h += shift));
        assert!(refused.is_err(), "{shift}: {refused:?}");
    }
}

/// The pair leaves its curve at a pitchfork with a cusp, where its curvature is infinite: on the axis of Katok's border
/// A2/A1 = 3/4, and in a plane, where the curve it leaves is bent.
#[test]
fn pitchforks_on_their_border_are_verified() {
    are_verified(&[[["1", "3/4", "1.4"], ["1", "0", "0"]], [["7/6", "1", "137/96"], ["5/2", "0", "205/24"]]]);
}

/// A cusp lies next to the middle between two moments, where a curve goes on from one chart to the other.
#[test]
fn places_beside_the_middle_between_two_moments_are_verified() {
    are_verified(&[[["1", "1.00000001", "1.736"], ["3e-9", "3e-9", "0.385"]]]);
}

/// A change of the linear type lies at μ = 0, which halvings of the range of μ meet exactly; other roots lie beside it.
#[test]
fn a_change_at_the_middle_of_a_range_is_verified() {
    are_verified(&[
        [["1", "3", "1/2"], ["2", "1", "0"]],
        [["1", "3", "1/2"], ["1", "1", "0"]],
        [["1", "3", "2"], ["2", "1", "0"]],
    ]);
}

/// The slope turns at a moment itself, on no branch; an event lies at h = 0, up to the least double; the slope of one
/// branch turns over a chord of another.
#[test]
fn coincidences_of_plain_bodies_are_verified() {
    are_verified(&[
        [["3", "2", "1"], ["1", "1", "1"]],
        [["6", "2", "1"], ["2", "3", "1"]],
        [["3", "2", "1"], ["0", "1", "0"]],
        [["0.513", "0.187", "1.62"], ["-2", "-1", "-1.98"]],
    ]);
}

/// Two pitchforks whose places are one double, on axes whose moments differ by 1e-18, and a width that lies inside a cell
/// above which another is higher at an end.
#[test]
fn what_doubles_take_for_one_is_told_apart() {
    are_verified(&[
        [["0.8", "1", "0.999999999999999999"], ["1", "0", "0"]],
        [["0.8", "0.999999999999999999", "1"], ["-1", "0", "0"]],
        [["1", "0.8", "1.000000000000000001"], ["0", "1", "0"]],
        [["0.77", "1.05", "0.76"], ["0.4", "0.052", "-0.9"]],
        [["0.45", "0.91", "0.46"], ["-0.9625", "0.1094", "0.925"]],
    ]);
}

/// One long moment: the slope turns on one curve of a branch, over an x over which others of that branch run, whose slopes are far
/// from that one.
#[test]
fn curves_beside_the_turn_of_another_curve_are_verified() {
    are_verified(&[
        [["2", "1000", "0.854"], ["-0.7606", "0.9684", "-0.0368"]],
        [
            ["30.636550862654893", "0.6493153639350644", "0.6774292206081391"],
            ["1.6643372663", "-0.1734923069", "-2.2490240439"],
        ],
        [["1.2709", "2.6409", "1018.24"], ["-0.000047666", "-0.0897132", "-0.000776789"]],
    ]);
}

/// Energies in the document are larger than any number that a body may have, and a unit of the certificate smaller.
#[test]
fn bodies_at_the_ends_of_what_is_read_are_verified() {
    are_verified(&[
        [["2", "1", "1"], ["1e149", "2e149", "1e149"]],
        [["2e-149", "1e-149", "1.5e-149"], ["1e149", "2e149", "1e149"]],
        [["1e150", "0.4e150", "0.7e150"], ["0.3e150", "1e150", "0"]],
        [["2e-150", "1e-150", "1.5e-150"], ["1e-150", "1e-150", "1e-150"]],
    ]);
}
