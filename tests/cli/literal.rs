//! What is printed holds as it is read: of rest, of windows, of samples, of shares and of colours.

use serde_json::Value;

use crate::builder::bifdiag;

/// At rest a symmetric top has another type than at the slowest spins: no change from it on is denied.
#[test]
fn rest_is_not_among_the_spins_without_a_change() {
    let top = "state --A 2,2,3 --r 0,0,1 --axis z --spin";
    let rest = bifdiag(top).and("0 rpm").succeeds();
    rest.printing("unstable: double-real").printing("\nnext change above the slowest spins: 9.0031632 rpm");
    bifdiag(top)
        .and("1 rpm")
        .succeeds()
        .printing("unstable: complex")
        .printing("\nno change at any smaller spin above 0\n");
}

/// Just above a fork another curve is nearer than the step beside it.
#[test]
fn the_regions_beside_a_moving_axis_are_those_of_its_curve() {
    let beside = |body: &str, spin: &str, axis: &str, regions: &str| {
        let found = bifdiag(&format!("state {body} --axis={axis} --spin")).and(spin).succeeds();
        found.printing(&format!("regions beside it: {regions} in h\n"));
    };
    beside("--body paper", "23.8767 rpm", "0.1686,0,-0.9857", "R6 below, R2 above");
    beside("--body paper", "23.8767 rpm", "0.1686,0.05,-0.9857", "R5 below, R6 above");
    beside("--A 2,2,3 --r 0,0,1", "9.5492966 rpm", "1,0,100", "R1 below, R3 above");
    beside("--A 1,2,2.5 --r 1e-12,0,1", "20 rpm", "-1,0,0", "R11 below, R9 above");
}

/// h rises with l along every curve, so that what a window holds is known without samples.
#[test]
fn a_window_has_all_regions_and_curves_that_reach_into_it() {
    let place = tempfile::tempdir().unwrap();
    let listed = |line: &str| -> Vec<String> {
        let document = bifdiag(line).and("--json").succeeds().json();
        let of = |region: &Value| {
            let star = if region["clipped"] == true { "*" } else { "" };
            format!("{}{star}", region["id"].as_str().unwrap())
        };
        document["regions"].as_array().unwrap().iter().map(of).collect()
    };
    let crossing = "--A=7/3,5/2,1/3 --r=0.2,-3,1/7 --window=24.15:24.18,10.2:10.7";
    assert_eq!(listed(crossing), ["R2*", "R6*", "R11*", "R12*"]);
    let wide = "--body kovalevskaya --window=5:6,0:200";
    assert_eq!(listed(wide), ["R1*", "R2*", "R4*"]);
    assert_eq!(listed("--A=5,3,2 --r=0,0,4 --window=-4.1:-3.9999,0:2"), ["R1*"]);
    // Only the corner of R2 is outside.
    assert_eq!(listed("--body paper --window=-2:12.6,0:10")[1], "R2*");
    bifdiag(wide).arguments("--out w").inside(place.path()).succeeds();
    let caption = std::fs::read_to_string(place.path().join("w/diagram.caption.txt")).unwrap();
    let row = |curve: &str| caption.lines().find(|line| line.starts_with(curve)).unwrap_or_else(|| panic!("{caption}"));
    assert!(row("L-.2,").contains("4 … 4.472"), "{caption}");
    assert!(row("S3.2,").contains("3.146 … 3.452"), "{caption}");
}

/// In another theme than the light one the names of colours do not hold.
#[test]
fn colours_of_the_dark_theme_are_not_called_by_names() {
    let place = tempfile::tempdir().unwrap();
    let line = "--A=4,7,9 --r=1,2,2 --legend file --view plane --out d --theme";
    bifdiag(line).and("dark").inside(place.path()).succeeds();
    let caption = std::fs::read_to_string(place.path().join("d/diagram.caption.txt")).unwrap();
    let lines: Vec<&str> = caption.lines().filter(|line| line.contains(" line: ")).collect();
    assert!(!lines.is_empty() && lines.iter().all(|line| line.starts_with('#')), "{caption}");
}

/// At a fold there are three axes, neither the two below nor the four above.
#[test]
fn nothing_is_claimed_of_the_number_of_axes_at_a_fold() {
    let found = bifdiag("critical-spin --A 6,6,11 --r 27,0,64").succeeds();
    found.printing(": 2 below 47.746483 rpm, 4 at faster spins");
    let steady = bifdiag("state --A 6,6,11 --r 27,0,64 --axis 3,0,-4 --spin").and("5 rad/s").succeeds();
    steady.printing("steady at one spin only: 47.746483 rpm, with its other end up");
    let place = tempfile::tempdir().unwrap();
    let drawn = bifdiag("critical --A 6,6,11 --r 27,0,64 --out axes.svg --spin").and("5:5:2 rad/s");
    drawn.inside(place.path()).refused().telling("a picture needs two spins that differ");
}

/// Of inputs that are exact no sample differs.
#[test]
fn sampled_parts_are_counted_once() {
    let found = |share: &str| bifdiag("critical-spin --A 3,2,1 --r 0,0,1 --axis z --tolerance").and(share).succeeds();
    found("0").printing("of the 1 sampled part:");
    let weight = found("weight=1%").printing("of the 3 sampled parts:").stdout();
    assert!(!weight.lines().any(|line| line.contains("saddle-centre") && line.contains(" zero ")), "{weight}");
    let cone = bifdiag("critical-spin --A 1,2,2.5 --r 0,0,1 --axis 1,1,0").succeeds();
    cone.printing("is (0, 1, 0), 45° away").printing("\nequally near: (1, 0, 0)\n");
}

/// Verdicts at neighbouring l are not printed at one l.
#[test]
fn isolated_momenta_are_told_apart() {
    let found = bifdiag("show G0.1 --A 4,3,2 --r 1,1,0").succeeds();
    found.printing("l = 3.382506 alone (1:2 resonance)").printing("l = 3.382514 alone (D4 = 0)");
    let close = "5000000000/12345678905,5000000000/12345678901,5000000000/12345678909";
    let found = bifdiag(&format!("critical --A={close} --r 1e-12,1e-13,1e-13 --l 1")).succeeds();
    found.printing("\n1.2345678900999 ").printing("\n1.2345678901001 ");
}

/// What a number is not, is not said of it.
#[test]
fn shares_bounds_and_refusals_hold_as_they_are_read() {
    bifdiag("class 60311ce8bd5e --no-plot")
        .succeeds()
        .printing("share of bodies with A > 0: none of a sample of 100000 bodies");
    let forbidden = bifdiag("sphere --A 2,2,1 --r 0,0,1 --h=-3/2 --l 0").refused();
    forbidden.telling("the lowest energy at l = 0 is -1 (curve L+.1)");
    let near = bifdiag("classes --at --A 4,5,3.0000000000001 --r 1,0,0").succeeds();
    near.printing("\n1e-13 ").printing("on a border of its class, or within 1e-13 of one");
    let fast = bifdiag("critical --A=1e140,1e140,1.5e140 --r=1e-140,0,0 --spin=-2rad/s").refused();
    fast.telling("use a spin from 1e-150 to 3.0303e-96 rad/s, or 0");
    let beyond = bifdiag("state --A 1e20,2e20,2.5e20 --r 0,0,1 --axis z --spin").and("1e150 rad/s").fails();
    beyond.telling("the state overflows");
    let scanned = bifdiag("scan events --A 4,5,8 --r 1,2,3 --vary A3=5:8.5 --json").succeeds().json();
    assert_eq!(scanned["vary"]["steps"], 240);
    let turned = bifdiag("compare A=2,2,2;r=0,0,3 A=4,5,6;r=0,1,0 --json").succeeds().json();
    assert_eq!(turned["path"]["turned"], serde_json::json!([true, false]));
}

/// A factor of the ticks is one of the quantity.
#[test]
fn scaled_ticks_do_not_change_the_unit() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("campbell --A 1,2,2.5 --r 0,0,1 --axis z --to").and("3e6 rpm").inside(place.path()).succeeds();
    let picture = std::fs::read_to_string(place.path().join("bifdiag-out/campbell.svg")).unwrap();
    assert!(picture.contains("spin·10⁻⁵ in rpm") && !picture.contains("rpm·10"), "{picture}");
    let impossible = "body --inertia-com 1,1,3,0,0,0 --com 0,0,4 --mass 1 --g 10 --unphysical --out d";
    bifdiag(impossible).inside(place.path()).succeeds();
    let picture = std::fs::read_to_string(place.path().join("d/part.svg")).unwrap();
    assert!(picture.contains("no ellipsoid has this tensor") && !picture.contains("with this tensor"), "{picture}");
    std::fs::write(place.path().join("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\n")
        .unwrap();
    bifdiag("body --part sheet.obj --mass 1").inside(place.path()).refused().telling("the mesh encloses no volume");
}

/// A place in so narrow a range of l that few digits leave it is confirmed with more.
#[test]
fn what_shows_what_is_sought_is_found() {
    let narrow = bifdiag("find --critical-points 8 --physical --moment-ratio 1.5").succeeds();
    narrow.printing("isolated relative equilibria at this l").printing(", 1 shows it\n");
    let signature = bifdiag("find --signature S2+T2+T2 --search --seed 532 --samples 500 --physical").succeeds();
    signature.printing("S2+T2+T2 is shown by");
    let changed = bifdiag("find --type k2n0 --search --seed 100 --samples 5 --moment-ratio 3").succeeds();
    changed.printing("0 show it; the witness was found by changing the one tried");
}

/// Of events that are near to each other those are named whose order changes across the border.
#[test]
fn borders_are_named_by_the_events_that_change_places() {
    let beside = |body: &str, class: &str, event: &str| {
        let text = bifdiag(&format!("classes --at {body}")).succeeds().stdout();
        let row = text.lines().find(|line| line.contains(class)).unwrap_or_else(|| panic!("{text}"));
        assert!(row.ends_with(event), "{row}");
    };
    beside(
        "--A 0.02498,0.5549,0.1008 --r=0.0273,0.127,0.0313",
        "8bad287eccc6",
        "curves of G0, G1, P- meet in one point",
    );
    beside(
        "--A 0.1869,0.003841,0.7235 --r=0.331,-0.0214,1.4",
        "19fd16c21e93",
        "curves of G0, G1, P- meet in one point",
    );
}

/// Beside the line to the centre of mass the one spin of an axis is small, and none of its digits is lost.
#[test]
fn the_one_spin_of_an_axis_has_its_digits() {
    let axis = "--A 1,2,3 --r 1,1,0 --axis 1,1.000000000001,0";
    let found = bifdiag(&format!("state {axis} --spin")).and("1 rad/s").succeeds();
    found.printing("steady at one spin only: 1.1356091e-5 rpm");
    bifdiag(&format!("critical-spin {axis}")).succeeds().printing("1.1356091e-5");
    let far = bifdiag("state --A 2,3,4 --r 1,1,1 --axis 1,0,0 --spin").and("1000 rad/s").succeeds();
    far.printing("(G0.1, error bound ");
    let four = bifdiag("critical --A=128/45,133/45,17/5 --r=1/15,0,16/45 --l 16/5").succeeds();
    four.printing("more where a cusp lies at a pitchfork");
}
