//! `bifdiag chaos`: shares at a point.

use crate::builder::bifdiag;

const POINT: &str = "chaos --body paper --h 5.3 --l 3.25";

#[test]
fn a_point_has_a_share_with_its_error() {
    let found = bifdiag(&format!("{POINT} --error 0.06 --json")).succeeds().json();
    assert_eq!((found["region"].as_str(), found["steps"].as_u64()), (Some("R3"), Some(20_480)));
    let [component] = &found["components"].as_array().unwrap()[..] else { panic!("{found}") };
    let number = |name: &str| component[name].as_f64().unwrap();
    // 129 of 400 orbits that were followed for eight times as long are chaotic, 249 are regular.
    assert!((0.15..0.45).contains(&number("fraction")), "{component}");
    assert!(number("error") <= 0.06 && number("error") > 0.0 && number("open") < 0.15, "{component}");
    assert_eq!(component["energy_surface"], "S3");
    let again = found["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap().to_owned();
    assert_eq!(bifdiag(&again).succeeds().json(), found);
    bifdiag(&format!("{POINT} --error 0.2 --steps 320")).succeeds().printing("one standard deviation");
}

#[test]
fn integrable_tops_have_no_chaos() {
    for place in [
        "kovalevskaya --h 3.4 --l 2.87",
        "lagrange --h 2 --l 1.3",
        "euler --h 2 --l 1",
        "goryachev-chaplygin --h 1.5 --l 0",
    ] {
        let found = bifdiag(&format!("chaos --body {place} --error 0.02 --json")).succeeds().json();
        for component in found["components"].as_array().unwrap() {
            assert_eq!(component["fraction"], 0.0, "{place}: {component}");
            assert!(component["open"].as_f64().unwrap() <= 0.05, "{place}: {component}");
        }
    }
}

#[test]
fn points_without_a_share_are_refused_with_the_reason() {
    bifdiag("chaos --body paper --h -3 --l 1").refused().telling("below the minimum of U_l");
    bifdiag("chaos --body kovalevskaya --h 1 --l 0").refused().telling("lies on a curve");
    bifdiag("chaos --body paper --h 5").refused().telling("--l is missing");
    bifdiag(&format!("{POINT} --error 0")).refused().telling("a standard deviation from");
}
