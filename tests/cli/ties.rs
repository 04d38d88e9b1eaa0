//! What is said at exact ties, at the ends of ranges, and of numbers that differ by little.

use serde_json::Value;

use crate::builder::bifdiag;

/// Where two axes, or two families of steady rotations, are equally near, none of them is said to be the nearest alone.
#[test]
fn equally_near_axes_are_all_listed_with_weight_too() {
    let tied = "--A 1,1.5,2 --r 0.1,0.2,0.3 --axis 1,1,0";
    let found = bifdiag(&format!("critical-spin {tied} --json")).succeeds().json();
    let axes: Vec<String> =
        found["families"].as_array().unwrap().iter().map(|family| family["fast_axis"].to_string()).collect();
    for axis in ["[1.0,0.0,0.0]", "[0.0,1.0,0.0]", "[-1.0,0.0,0.0]", "[0.0,-1.0,0.0]"] {
        assert!(axes.iter().any(|known| known == axis), "{axis} {axes:?}");
    }
    bifdiag(&format!("critical-spin {tied}")).succeeds().printing("are equally near to the given one: all are listed");
    bifdiag(&format!("critical-spin {tied} --tolerance 1%"))
        .succeeds()
        .printing("for bounds give an axis that is nearer");
    let refused = bifdiag(&format!("campbell {tied} --no-plot --to")).and("20 rad/s").refused();
    refused.telling("are equally near to it; give an axis that is nearer");
    // With r on the third axis the cone is two planes, and what lies midway has two nearest axes.
    let between = bifdiag("critical-spin --A 1,1.5,2 --r 0,0,1 --axis 1,1,1").succeeds();
    between.printing("equally near: (");
    // Nothing tends to an axis across all limits of fast spins.
    let across = bifdiag("critical-spin --A 2,2,1 --r 1,0,0 --axis 0,1,0").succeeds();
    let across = across
        .printing("at fast spins all steady axes are perpendicular to the given one, so that none is nearest")
        .stdout();
    assert!(!across.contains("nearest at fast spins"), "{across}");
}

/// Of a circle of steady rotations the one nearest to the given axis is followed, not one that is listed for all.
#[test]
fn the_end_of_a_circle_is_the_axis_that_was_given() {
    let place = tempfile::tempdir().unwrap();
    for (axis, named) in
        [("1,1,0", "(0.707107, 0.707107, 0)"), ("-3,4,0", "(-0.6, 0.8, 0)"), ("3,4,1", "(0.6, 0.8, 0)")]
    {
        let line = format!("campbell --A 2,2,1 --r 0,0,1 --no-plot --axis={axis} --to");
        let reply = bifdiag(&line).and("20 rad/s").inside(place.path()).succeeds();
        reply.printing(&format!("and tends to {named} at fast spins (S12, one of a circle of them)"));
    }
    let found = bifdiag("critical-spin --A 2,2,1 --r 0,0,1 --axis=-3,4,0 --json").succeeds().json();
    let families = found["families"].as_array().unwrap();
    assert_eq!(families.len(), 1);
    let axis = |value: &Value| -> [f64; 3] { std::array::from_fn(|k| value[k].as_f64().unwrap()) };
    let [x, y, z] = axis(&families[0]["fast_axis"]);
    assert!((x + 0.6).abs() + (y - 0.8).abs() + z.abs() < 1e-12, "{found}");
    // At the spin where it begins it lies on the axis of symmetry, hanging.
    let [x, y, z] = axis(&families[0]["stretches"][0]["from"]["axis"]);
    assert!(x.abs() + y.abs() + (z + 1.0).abs() < 1e-9, "{found}");
}

/// Every sample in the table of regions lies in its region, however thin that is; where none in doubles does, it is marked.
#[test]
fn printed_samples_lie_in_their_regions() {
    let narrow = "--A 1,2,2.5 --r 1,1e-8,0";
    let bodies = ["--A 1e9,2e9,1.5e9 --r 1e-3,1,2e-3", "--body ten", "--body paper", "--A 3,2,1 --r 0.1,1,0.2", narrow];
    let (mut seen, mut marked) = (0, 0);
    for body in bodies {
        let atlas = bifdiag(&format!("{body} --no-plot")).succeeds().stdout();
        for line in atlas.lines().filter(|line| line.starts_with('R')) {
            // The last pair of numbers in parentheses: E may have some before.
            let Some((_, pair)) = line.rsplit_once('(') else { continue };
            let Some((h, l)) = pair.split_once(')').and_then(|(pair, _)| pair.split_once(", ")) else { continue };
            let id = line.split_whitespace().next().unwrap().trim_end_matches('*');
            let found = bifdiag(&format!("classify {body} --h={h} --l={l} --json")).succeeds().json();
            let is_marked = line.contains('~');
            assert_eq!(found["region"] != id, is_marked, "{body}: {line}");
            seen += 1;
            marked += u32::from(is_marked);
        }
        assert_eq!(atlas.contains("~ rounded to doubles"), body == narrow, "{atlas}");
    }
    assert!(seen > 30 && marked == 2, "{seen} {marked}");
}

/// Where two pitchforks are at one l, the pair that begins and the pair that ends are never there together. The proof says the same
/// as the answer without it, in the same order.
#[test]
fn relative_equilibria_at_one_l_are_counted_where_events_coincide() {
    for (body, most) in [
        ("--A 3,2,1 --r 0,1,0", 6),
        ("--A 7,5,3 --r 0,1,0", 6),
        ("--A 4,3,2 --r 0,1,0", 6),
        ("--A 3,2,1.02 --r 0,1,0", 8),
        ("--A 4,3,2 --r 1,0,0", 6),
        ("--A 2,2,1 --r 1,0,0", 6),
        ("--A 1,1,2 --r 0,0,1", 4),
        ("--A 5,4,1 --r 0,1,0", 6),
    ] {
        let [found, proved] =
            ["", " --certificate"].map(|how| bifdiag(&format!("{body} --no-plot --json{how}")).succeeds().json());
        for document in [&found, &proved] {
            assert_eq!(document["summary"]["critical_points_max"], most, "{body}");
        }
        let events = |document: &serde_json::Value| -> Vec<_> {
            let all = document["events"].as_array().unwrap();
            all.iter().map(|event| (event["kind"].clone(), event["curves"].clone())).collect()
        };
        assert_eq!(events(&found), events(&proved), "{body}");
    }
}

/// What is said of a region by `show` lies in it, too.
#[test]
fn shown_samples_lie_in_their_regions() {
    let body = "--A 1,1,1e-9 --r 0,0,1";
    let text = bifdiag(&format!("show R3 {body}")).succeeds().stdout();
    let sample = text.lines().find_map(|line| line.trim().strip_prefix("sample: ")).unwrap();
    let (h, rest) = sample.strip_prefix("h = ").unwrap().split_once(", l = ").unwrap();
    let l = rest.split(' ').next().unwrap();
    let found = bifdiag(&format!("classify {body} --h={h} --l={l} --json")).succeeds().json();
    assert_eq!(found["region"], "R3", "{sample}");
}

/// Cells whose range of l is one double lie on the side that the arrangement gives them.
#[test]
fn ways_across_the_curves_of_narrow_regions_go_up_and_down_as_they_do() {
    let body = "--A 2.99999999,4,5 --r 0,1,0";
    let region = bifdiag(&format!("show R3 {body}")).succeeds();
    let region = region.printing("rising h, across S1.2 ").printing("to R1:\n    two holes of U close (S2-3D2 to D2)");
    region.printing("rising h, across L-.1 ").printing("to R4:\n    a hole of U closes (S2-3D2 to S2-2D2)");
    bifdiag(&format!("show S1.2 {body}")).succeeds().printing("from R3 to R1: two holes of U close (S2-3D2 to D2)");
    for body in ["--A 1,2,3 --r 1e-9,1,0", "--A 1,2,3 --r 5e-10,1,0"] {
        let document = bifdiag(&format!("atlas {body} --json")).succeeds().json();
        for region in document["regions"].as_array().unwrap() {
            let text = bifdiag(&format!("show {} {body}", region["id"].as_str().unwrap())).succeeds().stdout();
            let opens_rising = text.split("rising h").skip(1).any(|way| {
                let way = way.split("falling h").next().unwrap();
                way.contains("a hole of U opens") || way.contains("holes of U open ")
            });
            assert!(!opens_rising, "{text}");
        }
    }
}

/// Events of two points that doubles tell apart have regions of their own, and the forbidden region is one.
#[test]
fn the_regions_that_meet_at_an_event_are_those() {
    let narrow = "--A 2,1,0.5 --r 1,0,2.11866e-06";
    bifdiag(&format!("show E4 {narrow}")).succeeds().printing("regions that meet there: R2, R3, R5, R8\n");
    bifdiag(&format!("show E5 {narrow}")).succeeds().printing("regions that meet there: R3, R4, R8, R9\n");
    let lowest = bifdiag("show E1 --A 1,1.5,2 --r 1,0,0").succeeds();
    lowest.printing("regions that meet there: the forbidden region, R1, R3\n");
}

/// What is printed of an event differs from it by no more than is printed, and a width is no less than it is.
#[test]
fn printed_bounds_hold_for_what_is_printed() {
    let document = bifdiag("atlas --body paper --json").succeeds().json();
    for (number, event) in (1..).zip(document["events"].as_array().unwrap()) {
        let text = bifdiag(&format!("show E{number} --body paper")).succeeds().stdout();
        for name in ["h", "l"] {
            let rest = text.split(&format!(" {name} = ")).nth(1).unwrap();
            let (value, rest) = rest.split_once(" (± ").unwrap();
            let bound: f64 = rest.split(')').next().unwrap().parse().unwrap();
            let differs = (value.parse::<f64>().unwrap() - event[name].as_f64().unwrap()).abs();
            assert!(differs <= bound, "{text}");
        }
    }
    let text = bifdiag("show R6 --body paper").succeeds().stdout();
    let width = text.split("at most ").nth(1).unwrap().split(' ').next().unwrap().parse::<f64>().unwrap();
    assert!(width >= document["drawing"]["regions"]["R6"]["h_width"].as_f64().unwrap(), "{width}");
}

/// Two moments whose difference is below all doubles are not equal.
#[test]
fn moments_that_differ_below_all_doubles_are_not_equal() {
    let second = format!("1.{}1", "0".repeat(399));
    for question in ["critical --l 3 --r 0,0,0", "critical --l 3 --r 0,0,1", "atlas --no-plot --r 1,0,0"] {
        bifdiag(&format!("{question} --A 1,{second},2")).fails().telling("differ by more than 10^25");
    }
}

/// Only axes of steady rotations are as near as the nearest one of these.
#[test]
fn axes_without_a_steady_rotation_are_not_equally_near() {
    for body in [
        "--A 5,4,1 --r 1,1,0 --axis 0,5,3",
        "--A 1,4,5 --r 0,1,1 --axis 1,5,5",
        "--A 2,2.5,2.5 --r 0,0,1 --axis 1,1,1",
        "--A 2,2.5,2.5 --r 1,0,1 --axis 1,1,1",
    ] {
        let text = bifdiag(&format!("critical-spin {body}")).succeeds().stdout();
        assert!(!text.lines().any(|line| line.starts_with("equally near")), "{text}");
    }
}

/// The slow types of an axis that is not permanent say whether U_l has a minimum, like those of one that is.
#[test]
fn families_begin_at_minima_with_that_name() {
    let part = "critical-spin --inertia-com=0.02,0.05,0.06,0,0,0 --com 0,0,-0.12 --mass 2.2 --g 9.80665 --json --axis";
    let slow = |axis: &str| bifdiag(part).and(axis).succeeds().json()["slow"].clone();
    assert_eq!(slow("0,0.02,1"), slow("z"));
}

/// Energies that differ by more than their errors are printed with other digits.
#[test]
fn energies_that_differ_are_told_apart() {
    let text = bifdiag("critical --A 3,5,7 --r 1,2,2 --l 1e6").succeeds();
    text.printing("7.1428571427e10").printing("7.1428571431e10").printing("9.9999999998e10").printing("1e11 ");
}

/// The bound and the refused l are not printed as one number.
#[test]
fn a_refused_momentum_differs_from_its_bound() {
    let line = "spin-down --A 3,5.5,8 --r 0,1,0.5 --from G1.2 --l 5.67261339225";
    bifdiag(line).refused().telling("--l 5.6726133922: the curve G1.2 has l above 5.6726133923");
}

/// A spin that is too slow for doubles is refused where l is 0 or not a number in them, too.
#[test]
fn no_answer_is_not_a_number() {
    bifdiag("critical --A 1e-50,1e-50,3e-50 --r 1,1,1 --spin").and("1e-140 rad/s").refused().telling("is too slow");
}
