//! Periodic orbits from the command line.

use serde_json::{Value, json};

use crate::builder::bifdiag;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value}"))
}

/// Every imaginary pair that `critical` lists has a family, with its period in the limit.
#[test]
fn families_begin_at_every_imaginary_pair_of_critical() {
    let critical = bifdiag("critical --body paper --l 1.5 --json").succeeds().json();
    let mut frequencies = Vec::new();
    for point in list(&critical["critical"]) {
        let pairs = list(&point["eigenvalues"]).iter().filter(|pair| pair[0] == json!(0.0));
        let mut of_it: Vec<f64> = pairs.map(|pair| number(&pair[1])).filter(|im| *im > 0.0).collect();
        of_it.sort_by(|p, q| q.total_cmp(p));
        frequencies.extend(of_it);
    }
    let families = bifdiag("periodic family --body paper --l 1.5 --members 8 --json").succeeds().json();
    let found: Vec<f64> = list(&families["families"]).iter().map(|family| number(&family["frequency"])).collect();
    assert_eq!(found, frequencies);
    for family in list(&families["families"]) {
        let first = &family["members"][0];
        let limit = std::f64::consts::TAU / number(&family["frequency"]);
        assert!((number(&first["period"]) / limit - 1.0).abs() < 1e-4, "{first}");
        assert!((number(&first["l"]) - 1.5).abs() < 1e-12, "{first}");
        assert_eq!(first["proved"], json!(false));
        let multipliers: Vec<[f64; 2]> =
            list(&first["multipliers"]).iter().map(|pair| [number(&pair[0]), number(&pair[1])]).collect();
        let [[a, b], [c, d]] = [multipliers[0], multipliers[1]];
        assert!((a * c - b * d - 1.0).abs() < 1e-10 && (a * d + b * c).abs() < 1e-10, "{first}");
    }
    assert_eq!((&families["fixed_l"], &families["fixed_h"]), (&json!("1.5"), &Value::Null));
}

/// Where h is held, the equilibrium is that of the curve at this h.
#[test]
fn families_at_one_energy_begin_at_its_equilibrium() {
    let document = bifdiag("periodic family --body paper --from G2.1 --h 1 --members 20 --json").succeeds().json();
    for family in list(&document["families"]) {
        assert!((number(&family["h"]) - 1.0).abs() < 1e-12, "{family}");
        assert!(list(&family["members"]).iter().all(|orbit| (number(&orbit["h"]) - 1.0).abs() < 1e-12));
        assert!(list(&family["members"]).len() == 20 || family["end"]["kind"] != json!("members"));
    }
    assert_eq!((&document["fixed_h"], &document["fixed_l"]), (&json!("1"), &Value::Null));
}

#[test]
fn families_are_drawn_and_told() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("periodic family --body paper --from G2.1 --l 1.5 --members 30 --out pictures")
        .inside(place.path())
        .succeeds()
        .printing("from G2.1 at h = ")
        .printing("elliptic")
        .printing("periodic.svg");
    let picture = std::fs::read_to_string(place.path().join("pictures/periodic.svg")).unwrap();
    assert!(picture.contains("G2.1") && picture.contains("period T"));
}
