//! `bifdiag campbell`: frequencies over the spin.

use std::fs;

use serde_json::{Value, json};

use crate::builder::bifdiag;

#[test]
fn an_axis_that_is_not_permanent_names_the_nearest() {
    let body = "--A 2,1.1,1 --r 0.94868,0,0.61623";
    let found = bifdiag(&format!("critical-spin {body} --axis 1,0.1,0.6 --json")).succeeds().json();
    assert_eq!((&found["permanent"], &found["changes"]), (&json!(false), &json!([])));
    assert!(found["nearest"]["angle_deg"].as_f64().unwrap() > 0.1);
    bifdiag(&format!("critical-spin {body} --axis 1,0.1,0.6"))
        .succeeds()
        .printing("the nearest axis of a steady rotation is");
}

/// Off the principal axes the steady rotation that moves with the spin is followed from its fold on, with the eigenvalues that
/// `critical --spin` has.
#[test]
fn campbell_follows_the_rotation_that_moves_with_the_spin() {
    let directory = tempfile::tempdir().unwrap();
    let run = |axis: &str, to: &str| {
        bifdiag(&format!("campbell --body paper --axis={axis} --to")).and(to).inside(directory.path())
    };
    let upright = run("0,0,-1", "60 rpm").succeeds();
    upright
        .printing("begins at 14.151956 rpm and tends to (0, 0, -1)")
        .printing("15.914409 rpm: elliptic to saddle-centre");
    let csv = fs::read_to_string(directory.path().join("bifdiag-out/campbell.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(1).map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    assert!(rows[0][0] > 14.15 && rows[0][0] < 14.31 && rows.len() < 400, "{rows:?}");
    let last = &rows[rows.len() - 1];
    let axes = bifdiag("critical --body paper --json --spin").and("60 rpm").succeeds().json();
    let here = |axis: &&Value| axis["branch"] == "G1.1" || axis["branch"] == "G1.2" || axis["branch"] == "G1.3";
    let hertz = |axis: &Value, k: usize| axis["eigenvalues"][k][1].as_f64().unwrap() / std::f64::consts::TAU;
    let near = |axis: &&Value| (hertz(axis, 0).min(hertz(axis, 1)) - last[1]).abs() < 1e-9;
    assert_eq!(axes["axes"].as_array().unwrap().iter().filter(here).filter(near).count(), 1, "{last:?} {axes}");
    run("0,0,-1", "10 rpm").refused().telling("begins at 14.151956 rpm");
}

#[test]
fn campbell_writes_a_table_and_a_picture() {
    let directory = tempfile::tempdir().unwrap();
    let part = "--inertia-com 29625,31000,56250,0,0,0 --com 0,0,40 --mass 180 --units g,mm,s --g 9.80665";
    let run = bifdiag(&format!("campbell {part} --axis z --out c")).and("--to").and("3000 rpm");
    run.inside(directory.path()).succeeds().printing("complex to elliptic");
    let csv = fs::read_to_string(directory.path().join("c/campbell.csv")).unwrap();
    assert!(
        csv.starts_with("spin_rpm,frequency1_hz,frequency2_hz,growth_per_s,stable,survives_friction\n")
            && csv.lines().count() == 401
    );
    assert!(fs::read_to_string(directory.path().join("c/campbell.svg")).unwrap().contains("frequency in Hz"));
}

/// Changes and ends that agree in eight digits are printed with more.
#[test]
fn spins_that_differ_have_other_digits() {
    let directory = tempfile::tempdir().unwrap();
    let run =
        |line: &str, to: &str| bifdiag(&format!("campbell {line} --no-plot --to")).and(to).inside(directory.path());
    let narrow = run("--A 2,2.0000000001,1 --r=0,0,-1 --axis z", "5 rad/s").succeeds().stdout();
    let spins: Vec<&str> = narrow.lines().filter_map(|line| line.split_once(" rpm:")).map(|(spin, _)| spin).collect();
    assert!(spins.len() == 2 && spins[0] != spins[1], "{narrow}");
    let before = run("--A 1,2,3 --r=1,0,0 --axis=-x", "0.99999999999 rad/s").succeeds();
    before.printing("the next change of type is at 9.549296586 rpm, beyond --to");
    run("--body paper --axis=0,0,-1", "14.151956 rpm")
        .refused()
        .telling("begins at 14.1519562 rpm")
        .telling("up to 14.151956 rpm");
    let listed = bifdiag("critical-spin --A 2,2.0000000001,1 --r=0,0,-1 --axis z").succeeds().stdout();
    assert!(spins.iter().all(|spin| listed.contains(spin)), "{listed}");
    let state = bifdiag("state --A 1,2,3 --r=1,0,0 --axis=-x --spin").and("0.99999999999 rad/s").succeeds();
    state.printing("spin 9.549296585 rpm").printing("next change at larger spin: 9.549296586 rpm");
}

/// A change too near to rest for a line of its own has none in the legend either.
#[test]
fn the_legend_lists_what_is_drawn() {
    let directory = tempfile::tempdir().unwrap();
    let svg = |to: &str| {
        let run = bifdiag("campbell --A 2,3,4 --r 0,0,1 --axis=-z --out c --to").and(to);
        run.inside(directory.path()).succeeds();
        fs::read_to_string(directory.path().join("c/campbell.svg")).unwrap()
    };
    assert!(!svg("100000 rpm").contains("the type changes"));
    let run = bifdiag("campbell --A 4,3,2 --r 0,0,1 --axis=-z --out c --to").and("100 rpm");
    run.inside(directory.path()).succeeds();
    let drawn = fs::read_to_string(directory.path().join("c/campbell.svg")).unwrap();
    assert!(drawn.contains("the type changes"));
}

/// The line of an unstable rotation begins where its type changes: at no rate of growth, not at a row of the table beside it.
#[test]
fn lines_of_the_picture_end_where_the_type_changes() {
    let directory = tempfile::tempdir().unwrap();
    for body in ["--A 3,2,1.5 --r 0,0,1", "--A 3,2,1.5 --r 0.4,0,0.9"] {
        bifdiag(&format!("campbell {body} --axis=-z --to")).and("20 rpm").inside(directory.path()).succeeds();
        let picture = fs::read_to_string(directory.path().join("bifdiag-out/campbell.svg")).unwrap();
        let paths = |dashes: &str| -> Vec<String> {
            let is_dashed = |line: &&str| line.contains(&format!("stroke-dasharray=\"{dashes}\""));
            picture.lines().filter(is_dashed).map(|line| line.replace("<path d=\"M", "")).collect()
        };
        let numbers =
            |path: &str| -> Vec<u32> { path.split(['l', ' ', '"']).map_while(|number| number.parse().ok()).collect() };
        // The marks of the two changes in the last panel, but for that in the legend: x, the top and the height.
        let marks = paths("20 40");
        let [x, top, _, height] = numbers(&marks[marks.len() - 3])[..] else { panic!("{marks:?}") };
        let begins_there = |path: &String| {
            let [from, at, ..] = numbers(path)[..] else { return false };
            from.abs_diff(x) <= 1 && (top + height).abs_diff(at) <= height / 100
        };
        assert!(paths("70 50").iter().any(begins_there), "{body}: {x}");
    }
}

/// Where all steady axes are perpendicular at fast spins none is nearest, though some are permanent.
#[test]
fn an_axis_across_all_fast_ones_is_near_to_none() {
    let none = "at fast spins all steady axes are perpendicular to the given one, so that none is nearest to it";
    let body = "--A 3,3,5 --r 1,0,0 --axis y";
    bifdiag(&format!("critical-spin {body}")).succeeds().printing(none);
    bifdiag(&format!("campbell {body} --to")).and("3 rad/s").refused().telling(none).telling("such as one of (");
    for axis in ["1,0,0", "0,0,1"] {
        let again = format!("campbell --A 3,3,5 --r 1,0,0 --axis {axis} --no-plot --out");
        let directory = tempfile::tempdir().unwrap();
        bifdiag(&again).and("x").and("--to").and("3 rad/s").inside(directory.path()).succeeds();
    }
}

/// A top whose unstable range ends below the first row of the table grows at rest by 1/s, the root of r/A1.
#[test]
fn growth_below_the_first_row_is_drawn() {
    let directory = tempfile::tempdir().unwrap();
    let line = "campbell --A 1,1,1.2 --r 0,0,1 --axis z --to";
    bifdiag(line).and("20000 rpm").inside(directory.path()).succeeds().printing("15.915494 rpm: complex to elliptic");
    let picture = fs::read_to_string(directory.path().join("bifdiag-out/campbell.svg")).unwrap();
    let labels: Vec<&str> = picture.split("<text").filter_map(|text| text.split(['<', '>']).nth(1)).collect();
    let panel = labels.split(|label| *label == "spin in rpm").nth(2).unwrap();
    assert!(panel.contains(&"1"), "{panel:?}");
}
