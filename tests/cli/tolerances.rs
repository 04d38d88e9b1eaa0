//! What tolerances of a part leave of `critical-spin`.

use serde_json::json;

use super::spins::number;
use crate::builder::bifdiag;

/// Off the principal axes no rotation is permanent: bounds hold for the one that moves with the spin, and every part of the box
/// that is tried has it there, with the type that is reported.
#[test]
fn tolerances_off_the_principal_axes_have_bounds() {
    let part = |tensor: [f64; 6], com: [f64; 3], within: bool| {
        let text = |list: &[f64], share: f64| {
            let one = |x: &f64| if within { format!("{x:?}±{:?}", x.abs() * share + 1e-6) } else { format!("{x:?}") };
            list.iter().map(one).collect::<Vec<_>>().join(",")
        };
        format!(
            "--inertia-com={} --com={} --mass 2 --products tensor --g 9.81",
            text(&tensor, 0.002),
            text(&com, 0.002)
        )
    };
    let (tensor, com) = ([0.03, 0.024, 0.017, 0.002, -0.001, 0.0015], [0.01, 0.02, 0.05]);
    let found = bifdiag(&format!("critical-spin {} --axis z --json", part(tensor, com, true))).succeeds().json();
    assert_eq!((&found["permanent"], &found["tolerance"]["moving"]), (&json!(false), &json!(true)));
    let ranges = found["tolerance"]["ranges"].as_array().unwrap();
    assert!(ranges.iter().any(|range| range["to"] != json!(null)), "{found}");
    let tilt = number(&found["tolerance"]["tilt_deg"]);
    assert!(tilt < 5.0, "{tilt}");
    assert_eq!(found["families"].as_array().unwrap().len(), 2);
    // Fast, the type of both families of some corners of the box is that which is reported.
    for corner in 0..4 {
        let side = |k: usize| if corner >> (k % 2) & 1 == 0 { 0.998 } else { 1.002 };
        let moved: [f64; 6] = std::array::from_fn(|k| tensor[k] * side(k));
        let one = bifdiag(&format!("critical-spin {} --axis z --json", part(moved, com.map(|x| x * side(1)), false)));
        let one = one.succeeds().json();
        for (end, up) in ["+axis", "-axis"].into_iter().enumerate() {
            let stretches = one["families"][end]["stretches"].as_array().unwrap();
            let here = ranges.iter().filter(|range| range["up"] == json!(up));
            for range in here.filter(|range| !range["to"].is_null()) {
                let after = number(&range["rpm"][1]) * 1.0001;
                let at =
                    stretches.iter().rfind(|stretch| stretch["from"]["spin"]["rpm"].as_f64().unwrap_or(0.0) <= after);
                let reply = range["to"].as_str().unwrap().split(' ').next().unwrap();
                assert_eq!(at.unwrap()["stability"], json!(reply), "{range} {one}");
            }
        }
    }
    let share = bifdiag("critical-spin --body paper --axis 1,0,0 --tolerance 0.1%").succeeds();
    share.printing("of that of the nominal part at this spin").printing("components of r");
    bifdiag("critical-spin --body paper --axis 1,0,0 --tolerance axis=1%")
        .succeeds()
        .printing("give one share for all");
}

/// What is said of all parts within a tolerance was decided.
#[test]
fn sentences_about_all_parts_are_true() {
    let reply = |line: &str| bifdiag(&format!("critical-spin {line} --tolerance 1%")).succeeds().stdout();
    let middle = reply("--A 1,2,3 --r 0,1,0 --axis y");
    assert!(middle.contains("+axis up, each of these parts is unstable at every spin outside the ranges"), "{middle}");
    assert!(middle.contains("the ranges are those of the type; regions and frequencies may change at other spins"));
    assert!(!middle.contains("at no spin"), "{middle}");
    let free = reply("--A 1,2,3 --r 0,0,0 --axis y");
    assert!(free.contains("+axis up, each of these parts is saddle-centre at every spin: all are unstable"), "{free}");
    let fast = reply("--A 1,2,3 --r 0,0,0 --axis z");
    assert!(
        fast.contains("each of these parts is elliptic (local minimum) at every spin: none is linearly unstable"),
        "{fast}"
    );
}

/// Where nothing is known of all parts, those that were tried and never change are reported all the same: A2 = 3.6, A3 = 3.2.
#[test]
fn types_of_parts_without_a_change_are_inside_too() {
    let text = bifdiag("critical-spin --A 5,3,4 --r 0,0,0 --axis y --tolerance 20%").succeeds();
    text.printing("+axis  0 .. inf  -      -      elliptic, saddle-centre");
}

/// Where moments of all parts are exactly equal, no range comes from their rounding: C = A = B, C = A and A = B, with a weight,
/// a distance and a mass that are not exact.
#[test]
fn equal_moments_of_a_part_make_no_ranges() {
    let part = |rest: &str| {
        let line = format!("critical-spin --units kg,m,s --axis z {rest}");
        let found = bifdiag(&line).succeeds();
        let json = bifdiag(&format!("{line} --json")).succeeds().json();
        let ranges = json["tolerance"]["ranges"].as_array().unwrap();
        (found.stdout(), ranges.iter().map(|range| range["up"].as_str().unwrap().to_owned()).collect::<Vec<_>>())
    };
    let (text, ends) = part("--inertia-com 0.03,0.03,0.05,0,0,0 --com 0,0,0.1 --mass 2 --g 9.81±0.5%");
    assert_eq!(ends, ["+axis"], "{text}");
    assert!(text.contains("-axis up, each of these parts is elliptic (local minimum) at every spin"), "{text}");
    assert!(text.contains("none of these parts is linearly unstable from 119.936 rpm on"), "{text}");
    let (text, ends) = part("--inertia 0.05,0.05,0.05,0,0,0 --com 0,0,0.1±1% --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis"], "{text}");
    let (text, ends) = part("--inertia-com 0.03,0.03,0.058,0,0,0 --com 0,0,0.1±1% --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis", "+axis"], "{text}");
    let (text, ends) = part("--inertia 0.05,0.06,0.05,0,0,0 --com 0,0,0.1 --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis", "+axis", "-axis"], "{text}");
    // K_B = ρ + s (C − B): Ω² = 1.962 / 0.01 ± 1%.
    assert!(text.contains("133.087 .. 134.426"), "{text}");
    // C = A while B is open: there is no root of K_A. About the centre of mass m z² = 0.02 is added to A and B.
    for rest in
        ["--inertia 0.05,0.06±1%,0.05,0,0,0 --com 0,0,0.1", "--inertia-com 0.03,0.04±1%,0.05,0,0,0 --com 0,0,0.1"]
    {
        let (text, ends) = part(&format!("{rest} --mass 2 --g 9.81"));
        assert_eq!(ends, ["+axis", "+axis", "-axis"], "{text}");
        assert!(!text.contains(".. inf"), "{text}");
    }
    let (text, ends) = part("--inertia 0.05,0.06±1%,0.05,0,0,0 --com 0,0,0 --mass 2 --g 9.81");
    assert!(ends.is_empty() && text.contains("+axis up, each of these parts is elliptic at every spin"), "{text}");
    let (text, _) =
        part("--inertia-com 0.05,0.06,0.07,0.001±1%,0,0 --products integral --com 0,0,0.1 --mass 2 --g 9.81");
    assert!(text.contains("Ixy -0.001 ± 0.00001 (products as entries of the tensor; bounds"), "{text}");
}

/// Only what has a tolerance is named.
#[test]
fn tolerances_of_zero_are_not_reported_as_such() {
    let text = bifdiag("critical-spin --A 1,1,1 --r 0,0,1 --tolerance weight=1%").succeeds();
    text.printing("every part with the weight times 1 ± 0.01 (bounds, not samples; what is not named is exact):");
    let text = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z --tolerance axis=1%,across=2%").succeeds();
    text.printing(
        "with the moment about the axis times 1 ± 0.01, the two moments across the axis times 1 ± 0.02 (bounds",
    );
    for twice in ["axis=1%,axis=2%", "moments=1%,across=2%"] {
        let refused = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z --tolerance").and(twice).refused();
        refused.telling("another item sets the same");
    }
}

/// Ω = 1 rad/s = 30/π rpm grows with the root of the distance of the centre of mass: by 5e-9 of itself.
#[test]
fn a_narrow_range_is_printed_as_narrow_as_it_is() {
    let line = "critical-spin --inertia 4,3,2,0,0,0 --axis z --g 10 --com";
    bifdiag(line).and("0,0,0.1±1e-9").and("--mass").and("1").succeeds().printing("9.549296537 .. 9.549296634");
}

/// The nearest rotation is one of a circle, which parts with other moments lack: the bounds were those of the axis of symmetry.
#[test]
fn no_bounds_are_given_of_a_circle_of_rotations() {
    for line in [
        "--A 2,2,1 --r 0,0,1 --axis 1,1,1 --tolerance 1%",
        "--inertia-com 2,2,1,0,0,0±0.01 --products tensor --com 0,0,0.1 --mass 1 --axis 1,1,1",
    ] {
        let text = bifdiag(&format!("critical-spin {line}")).succeeds().stdout();
        assert!(text.contains("no bounds: the steady axis") && !text.contains("outside these ranges"), "{text}");
    }
}

/// With two equal moments the nearest rotation tends to an axis in their plane, not to the principal axis of most of the axis that was
/// given: the bounds were those of the latter.
#[test]
fn bounds_are_those_of_the_rotation_that_is_listed() {
    for body in ["--A 2,2,1 --r 0.3,0.3,1", "--A 2,2,1 --r 0.3,0.3,0", "--A 2,2,1 --r 0,0,0"] {
        let line = format!("critical-spin {body} --axis 1,1,1.2 --tolerance 1%");
        let text = bifdiag(&line).succeeds().stdout();
        assert!(!text.contains("linearly unstable from"), "{line}: {text}");
    }
    let moving = bifdiag("critical-spin --A 2,2,1 --r 0.3,0.3,1 --axis 0.1,0,1 --tolerance 1%").succeeds();
    moving.printing("of that of the nominal part at this spin");
}

/// Ends that differ in the last digit of a double, and ranges side by side.
#[test]
fn bounds_that_differ_have_other_digits() {
    let exact = bifdiag("critical-spin --A 4,3,2 --r 0,0,1 --axis z --tolerance 0").succeeds().stdout();
    let ends: Vec<[String; 2]> = exact
        .lines()
        .filter_map(|line| {
            let mut words = line.split_whitespace().skip_while(|word| *word != "..");
            let high = words.nth(1)?.to_owned();
            let low = line.split(" ..").next()?.rsplit(' ').next()?.to_owned();
            Some([low, high])
        })
        .collect();
    assert_eq!(ends.len(), 4, "{exact}");
    for [low, high] in ends {
        let [from, to] = [&low, &high].map(|text| text.parse::<f64>().unwrap());
        assert!(low != high && from < to && to - from < 1e-13 * to, "{exact}");
    }
    // K_A and K_B vanish at rates of 1/(C − A) and 1/(C − B), which differ by 1e-9 of themselves.
    let beside = bifdiag("critical-spin --A 2,2.000000004,1 --r 0,0,1 --axis z --tolerance weight=1e-10").succeeds();
    let text = beside.stdout();
    let up = |line: &&str| line.starts_with("-axis") && line.contains(" .. ");
    let rows: Vec<&str> = text.lines().filter(up).collect();
    assert_eq!(rows.len(), 2, "{text}");
    let ends =
        |row: &str| -> Vec<f64> { row.split_whitespace().filter_map(|word| word.parse().ok()).take(2).collect() };
    assert!(ends(rows[0])[1] < ends(rows[1])[0], "{text}");
}

/// What is not said of all parts, and of which type some of them may be, whichever the nominal one has.
#[test]
fn what_is_of_the_nominal_part_is_told_apart() {
    for line in [
        "--A 2,3,4 --r 0,0,1 --axis z --tolerance 1%",
        "--inertia-com 2,3,5±0.1,0,0,0 --com 0,0,0 --mass 1 --g 10 --axis z",
        "--body paper --axis 1,0,0 --tolerance 0.1%",
    ] {
        let text = bifdiag(&format!("critical-spin {line}")).succeeds();
        text.printing("what stands above is of the nominal part alone")
            .printing("of these parts elliptic means elliptic or double-elliptic");
    }
    let nowhere = bifdiag("critical-spin --A 2,2,1 --r 0.3,0.3,1 --axis 1,1,1.2 --tolerance 1%").succeeds().stdout();
    assert!(nowhere.contains("no spin was found") && !nowhere.contains("tilt too far"), "{nowhere}");
}
