//! All short orbits at a point, and their proofs.

use bifdiag_body::{Body, Number};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_periodic::list::{Gap, ListOptions, ListedOrbit, OrbitList, Stage, list, list_watched};
use bifdiag_periodic::proof::{ProofError, prove};

fn number(text: &str) -> Number {
    text.parse().unwrap()
}

fn setting(moments: [&str; 3], center: [&str; 3], [h, l]: [&str; 2]) -> SectionSetting {
    SectionSetting::new(&Body::parse(&moments, &center).unwrap(), &number(h), &number(l)).unwrap()
}

fn found(setting: &SectionSetting, crossings: u32) -> OrbitList {
    list(setting, &ListOptions { crossings, ..ListOptions::default() }, &Monitor::default()).unwrap()
}

const PAPER: ([&str; 3], [&str; 3]) = (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]);
/// No coordinate of r is 0: no orbit is symmetric.
const GENERIC: ([&str; 3], [&str; 3]) = (["2", "1.5", "1"], ["0.3", "0.5", "0.8"]);

/// A symmetric pair of unstable orbits among six; each is proved, and the enclosures hold what was computed.
#[test]
fn all_orbits_of_a_point_are_proved() {
    let setting = setting(PAPER.0, PAPER.1, ["6.5", "3.25"]);
    let list = found(&setting, 2);
    assert!(list.gaps.is_empty() && list.continua.is_empty(), "{:?}", list.gaps);
    assert_eq!(list.orbits.len(), 6);
    assert_eq!(list.index_sums, [2]);
    for listed in &list.orbits {
        let (orbit, proof) = (&listed.orbit, listed.proof.unwrap());
        assert!(orbit.residual < 1e-12 && (orbit.product() - 1.0).abs() < 1e-9, "{orbit:?}");
        assert!((orbit.h - 6.5).abs() < 1e-12 && (orbit.l - 3.25).abs() < 1e-12);
        assert_eq!(proof.crossings, orbit.crossings);
        // The derivative is enclosed for all motions of a box, and is much wider than their times.
        for (bounds, x, width) in [(proof.period, orbit.period, 1e-6), (proof.trace, orbit.trace, 0.1)] {
            let slack = 1e-9;
            assert!(bounds[0] - slack < x && x < bounds[1] + slack && bounds[1] - bounds[0] < width, "{bounds:?} {x}");
        }
        assert_eq!(listed.index, if orbit.trace > 2.0 { -1 } else { 1 });
    }
}

/// A start that is not on a periodic orbit, an orbit that is run through twice, and one at another h.
#[test]
fn what_is_not_so_is_not_proved() {
    let setting = setting(PAPER.0, PAPER.1, ["2.6", "3.25"]);
    let list = found(&setting, 2);
    let orbit = &list.orbits[0].orbit;
    let ([g1, g2, g3], [w1, w2, w3]) = (orbit.start.gamma, setting.torus().top().inverse_inertia(orbit.start.l));
    let (body, start) = (setting.body(), [g1, g2, g3, w1, w2, w3]);
    let longest = 5.0 * orbit.period;
    assert!(prove(body, setting.point(), start, 1, longest).is_ok());
    assert_eq!(prove(body, setting.point(), start, 2, longest), Err(ProofError::Repeated));
    let beside = [g1, g2, g3, w1 + 1e-6, w2, w3];
    assert!(prove(body, setting.point(), beside, 1, longest).is_err());
    let other = [&number("2.600001"), &number("3.25")];
    assert_eq!(prove(body, other, start, 1, longest), Err(ProofError::NotContracting));
}

/// The flow expands by a thousand on the way and contracts again: its derivative must not be multiplied by both.
#[test]
fn an_orbit_with_a_large_multiplier_is_proved() {
    let setting = setting(["2", "2", "1"], ["1", "0", "0"], ["2.158", "2.048"]);
    let start = [
        -0.734_366_331_339_215_4,
        0.0,
        -0.678_753_336_194_660_5,
        -1.112_424_373_262_758,
        0.0,
        -0.610_156_836_283_500_5,
    ];
    let proof = prove(setting.body(), setting.point(), start, 2, 20.0).unwrap();
    assert!(proof.period[0] < 9.316_844_826_6 && 9.316_844_826_5 < proof.period[1], "{proof:?}");
    assert!(proof.trace[0] < 285.368_1 && 285.368_0 < proof.trace[1], "{proof:?}");
}

/// On resonant tori of Lagrange's top every orbit is one of a continuum; none is listed as isolated.
#[test]
fn continua_of_an_integrable_top_are_listed_once() {
    let setting = setting(["2", "2", "1"], ["0", "0", "1"], ["3.5", "2"]);
    let list = found(&setting, 2);
    assert!(list.orbits.is_empty(), "{:?}", list.orbits);
    for orbit in &list.continua {
        assert!((orbit.trace - 2.0).abs() < 1e-4 && orbit.residual < 1e-10, "{orbit:?}");
        // The plane of γ and r, in which ω lies too at a crossing, is a mirror of the body.
        assert!(orbit.symmetric, "{orbit:?}");
    }
}

/// A body without symmetry.
#[test]
fn a_body_without_symmetry_has_orbits_that_are_not_symmetric() {
    let setting = setting(GENERIC.0, GENERIC.1, ["1.5", "0.5"]);
    let list = found(&setting, 2);
    assert!(list.gaps.is_empty(), "{:?}", list.gaps);
    assert_eq!((list.orbits.len(), &list.index_sums[..]), (6, &[2][..]));
    assert!(list.orbits.iter().all(|listed| !listed.orbit.symmetric && listed.proof.is_ok()));
}

/// Between h = 0.2 and 0.3 an elliptic orbit becomes inverse-hyperbolic, and an elliptic one of twice its period splits off: one
/// orbit more, and the sum for R² stays what it was, as does that for R.
#[test]
fn index_sums_are_kept_across_a_doubling() {
    let [before, after] = ["0.2", "0.3"].map(|h| found(&setting(GENERIC.0, GENERIC.1, [h, "0.5"]), 4));
    assert!(before.gaps.is_empty() && after.gaps.is_empty(), "{:?} {:?}", before.gaps, after.gaps);
    assert_eq!((before.orbits.len(), after.orbits.len()), (4, 5));
    assert_eq!((&before.index_sums[..], &after.index_sums[..]), (&[1, 3][..], &[1, 3][..]));
    let short = |list: &OrbitList| list.orbits.iter().find(|listed| listed.orbit.crossings == 2).unwrap().orbit.clone();
    let (elliptic, doubled) = (short(&before), short(&after));
    assert!(elliptic.trace.abs() < 2.0 && doubled.trace < -2.0, "{} {}", elliptic.trace, doubled.trace);
    let is_new = |listed: &&ListedOrbit| listed.orbit.crossings == 4 && listed.orbit.trace.abs() < 2.0;
    assert_eq!(before.orbits.iter().filter(is_new).count(), 0);
    let split = after.orbits.iter().find(is_new).unwrap();
    assert!(
        (split.orbit.period / (2.0 * doubled.period) - 1.0).abs() < 2e-3,
        "{} {}",
        split.orbit.period,
        doubled.period
    );
}

/// An orbit with four crossings has two maxima of ⟨γ,r⟩: it starts at the higher one, and what is proved is proved there.
#[test]
fn an_orbit_starts_where_it_is_proved() {
    let setting = setting(GENERIC.0, GENERIC.1, ["1.5", "0.5"]);
    let list = found(&setting, 4);
    let longer: Vec<_> = list.orbits.iter().filter(|listed| listed.orbit.crossings == 4).collect();
    assert_eq!((longer.len(), &list.index_sums[..]), (4, &[2, 4][..]));
    for listed in &list.orbits {
        if let Ok(proof) = listed.proof {
            let gamma = listed.orbit.start.gamma;
            assert!((0..3).all(|i| (proof.state[i][0] - gamma[i]).abs() < 1e-6), "{listed:?}");
        }
    }
    assert!(longer.iter().any(|listed| listed.proof.is_ok()));
}

/// Near (h, l) = (0.9, 1.2) P bends sharply at places where its charts have to be smaller.
#[test]
fn a_sharply_bent_section_is_covered() {
    let setting = setting(["1.3", "0.9", "2.2"], ["0.4", "0", "0"], ["0.9", "1.2"]);
    let list = found(&setting, 2);
    assert!(list.gaps.is_empty(), "{:?}", list.gaps);
    assert_eq!((list.orbits.len(), &list.index_sums[..]), (2, &[2][..]));
}

/// Just above the lowest energy P is so small that no square fits: the list names the curve, and how far away it is.
#[test]
fn a_cover_that_fails_beside_a_curve_names_it() {
    let setting = setting(PAPER.0, PAPER.1, ["1.6397", "3.25"]);
    let options = ListOptions { crossings: 2, cells: 1 };
    let list = list(&setting, &options, &Monitor::default()).unwrap();
    let near = list.gaps.iter().find_map(|gap| if let Gap::Cover { near, .. } = gap { *near } else { None }).unwrap();
    assert_eq!(near.curve.to_string(), "G2.1");
    assert!((near.margin - 5.9155e-7).abs() < 1e-10 && near.within < 0.01, "{near:?}");
    let spent = list.gaps.iter().any(|gap| matches!(gap, Gap::Cells { spent: true, .. }));
    assert!(spent, "{:?}", list.gaps);
}

/// The squares of the cover are checked one after the other, then every cell is decided, then orbits are proved.
#[test]
fn the_stages_of_a_list_are_reported_in_order() {
    let setting = setting(GENERIC.0, GENERIC.1, ["0.2", "0.5"]);
    let mut stages = Vec::new();
    let options = ListOptions::default();
    let list = list_watched(&setting, &options, &Monitor::default(), &mut |stage| stages.push(stage)).unwrap();
    let is_cover = |stage: &&Stage| matches!(stage, Stage::Cover { .. });
    let covers = stages.iter().take_while(is_cover).count();
    let Stage::Cover { squares, checked } = stages[covers - 1] else { panic!("{:?}", stages[covers - 1]) };
    assert_eq!((checked, checked), (squares, covers));
    let cells = stages.iter().skip(covers).take_while(|stage| matches!(stage, Stage::Cells { .. })).count();
    let Stage::Cells { examined, open: 0, decided } = stages[covers + cells - 1] else {
        panic!("{:?}", stages[covers + cells - 1])
    };
    assert!(list.gaps.is_empty() && examined == list.effort[0] && (decided - 1.0).abs() < 1e-9, "{decided}");
    let shares: Vec<f64> = stages
        .iter()
        .filter_map(|stage| if let Stage::Cells { decided, .. } = stage { Some(*decided) } else { None })
        .collect();
    assert!(shares.is_sorted() && shares[0] < 0.9, "{shares:?}");
    let found = list.orbits.len();
    let proofs: Vec<Stage> = (0..found).map(|tried| Stage::Proofs { tried, found }).collect();
    assert_eq!(stages[covers + cells..], proofs);
}
