//! Parts whose principal form is irrational, and which are exactly on a border or a threshold.

use serde_json::json;

use crate::builder::bifdiag;

/// Parts with equal entries in their tensors: J_r is a moment, and the principal form is irrational.
#[test]
fn coincidences_of_a_part_survive_the_rounding_of_its_principal_form() {
    // A = (0.99, 1, 1.01) and r = (-1, 0, 1)/√2: fold and fork are at 10 rad/s both.
    let cube = "--inertia 1,1,1,0,0.01,0 --products tensor --com 0,0,0.1 --mass 1 --g 10";
    bifdiag(&format!("critical-spin {cube}"))
        .succeeds()
        .printing("95.492966 (fold)  95.505691      saddle-centre")
        .printing("2 below 95.492966 rpm, 6 at faster spins");
    let axes = bifdiag(&format!("critical {cube} --spin")).and("10 rad/s").and("--json").succeeds().json();
    let axes = axes["axes"].as_array().unwrap();
    assert_eq!(axes.len(), 3);
    assert_eq!((&axes[1]["h"], &axes[1]["l"], &axes[1]["stability"]), (&json!(50.0), &json!(10.0), &json!("zero")));
    bifdiag(&format!("state {cube} --axis 1,0,0 --spin"))
        .and("10 rad/s")
        .succeeds()
        .printing("steady rotation, open (degenerate): zero")
        .printing("rotation about this axis is steady at this spin only");
    bifdiag(&format!("spin-down {cube} --from G0.1")).succeeds();
    for part in [
        cube,
        "--inertia 3,3,5,0,1,0 --products tensor --com 0.1,0,0 --mass 1 --g 10",
        "--inertia 1,1,1,0.1,0.2,0 --products tensor --com 0,0,0.1 --mass 1 --g 10",
        "--inertia 4/3,4/3,2,0,1/3,0 --products tensor --com 0.1,0,0 --mass 1 --g 10",
    ] {
        let atlas = bifdiag(&format!("atlas {part} --certificate --json")).succeeds();
        assert_eq!(atlas.json()["regions"].as_array().map(Vec::len), Some(8), "{part}");
        bifdiag("verify -").reading(atlas.stdout()).succeeds().printing("verified: 8 regions, 4 events");
    }
}

/// The pair over axis 2 has its cusp at its pitchfork: whether it is a minimum is decided by the next term of U_l.
#[test]
fn a_cusp_at_a_pitchfork_is_no_minimum() {
    for part in [
        "--inertia 4,3,3,1/2,0,0 --com 1/5,1/10,0 --mass 2",
        "--inertia 4,3,3,-1/2,0,0 --com 1/5,-1/10,0 --mass 2",
        "--inertia 8,5,6,1,0,0 --com 4/5,2/5,0 --mass 1",
    ] {
        let part = format!("{part} --products tensor --g 10");
        bifdiag(&format!("state {part} --axis 1,0,0 --spin"))
            .and("2 rad/s")
            .succeeds()
            .printing("steady rotation, open (degenerate): zero")
            .printing("with friction that conserves l: unstable\n")
            .printing("regions beside it: R2 below, R5 above in h");
        bifdiag(&format!("critical-spin {part}")).succeeds().printing("by Arnold's theorem");
        let atlas = bifdiag(&format!("atlas {part} --certificate --json")).succeeds();
        bifdiag("verify -").reading(atlas.stdout()).succeeds().printing("verified: 9 regions, 5 events");
    }
}

/// Hess and Appelrot's case: the eigenvalues at rest are double, and split at once.
#[test]
fn a_brick_of_hess_and_appelrot_has_no_stretch_of_rounding() {
    let brick = "--inertia-com 15625/6,53125/6,62500/6,0,0,0 --com 100,0,25 --mass 2.5 --units kg,mm,s --g 9.80665";
    bifdiag(&format!("critical-spin {brick}")).succeeds().printing("G0      0                 1942.8821  complex");
    bifdiag(&format!("critical {brick} --l 0")).succeeds().printing("double-elliptic").printing("double-real");
}

/// Parts whose principal moments are irrational, exactly at a fork, a fold and resonances: the tensor decides.
#[test]
fn a_part_may_lie_exactly_on_a_threshold() {
    let part = |numbers: &str| format!("--products tensor --g 10 {numbers}");
    // About z at 2 rad/s, l = 10, h = 14: r_z = Ω²(Izz − Iyy).
    let fork = part("--inertia 3,4,5,0,1,0 --com 0.2,0,0.2 --mass 2");
    let found = bifdiag(&format!("critical {fork} --l 10 --json")).succeeds().json();
    let list = found["critical"].as_array().unwrap();
    assert_eq!(list.iter().map(|point| &point["stability"]).filter(|word| **word == "zero").count(), 1, "{found}");
    assert_eq!(list.len(), 4);
    bifdiag(&format!("classify {fork} --l 10 --h 14")).succeeds().printing("critical: exactly on a curve");
    bifdiag(&format!("critical-spin {fork} --axis z")).succeeds().printing("open (degenerate): zero");
    let fold = part("--inertia 3,4,5,0,1,0 --com 0.1,0,0.2 --mass 1");
    bifdiag(&format!("critical {fold} --spin"))
        .and("1 rad/s")
        .succeeds()
        .printing("on G1.2: steady axes meet at this spin");
    for (numbers, expected) in [
        ("--inertia 4,4,5,0,1,1/2 --com 1/10,1/20,157/770 --mass 1", "unstable (1:2 resonance)"),
        ("--inertia 6,6,7,0,1,1 --com 1/10,1/10,1/4 --mass 1", "double-elliptic"),
        ("--inertia 3,4,3,1,0,0 --com 0,0,0.08 --mass 1", "double-elliptic"),
    ] {
        let part = part(numbers);
        bifdiag(&format!("state {part} --axis z --spin")).and("1 rad/s").succeeds().printing(expected);
        bifdiag(&format!("critical {part} --spin")).and("1 rad/s").succeeds().printing(expected);
    }
    // r along a rational axis whose moment is the mean of two irrational ones: both ends at their forks at 1 rad/s.
    let upright = part("--inertia 3,3,3,0,1,-1 --com 1,1,0 --mass 0.1");
    let axes = bifdiag(&format!("critical {upright} --spin")).and("1 rad/s").and("--json").succeeds().json();
    let axes = axes["axes"].as_array().unwrap();
    assert!(axes.len() == 2 && axes.iter().all(|axis| axis["stability"] == "zero"), "{axes:?}");
    for end in ["1,1,0", "-1,-1,0"] {
        let state = bifdiag(&format!("state {upright} --axis={end} --spin")).and("1 rad/s").succeeds();
        state.printing(": zero").printing("this spin is a threshold");
    }
}

/// A symmetric body whose axis has no rational direction: the hanging end is a minimum up to the fork alone.
#[test]
fn a_tilted_axis_of_symmetry_has_the_thresholds_of_its_body() {
    let part = "--inertia 3,3,3,-0.5,-0.5,-0.5 --products tensor --mass 2 --g 10 --com 0.1,0.1,0.1 --axis 1,1,1";
    let tilted = bifdiag(&format!("critical-spin {part}")).succeeds().stdout();
    let upright = bifdiag("critical-spin --A 2,3.5,3.5 --r 3.4641016151377545870548926830117,0,0 --axis x").succeeds();
    let rows = |text: &str| -> Vec<String> {
        text.lines().filter(|line| line.starts_with(['+', '-'])).map(str::to_owned).collect()
    };
    assert!(rows(&tilted).len() > 3, "{tilted}");
    assert_eq!(rows(&tilted), rows(&upright.stdout()));
}
