//! The documents are what their schemas say.

use serde_json::Value;

use crate::builder::bifdiag;

/// Complaints of a small validator: types, required keys, enums, references and alternatives.
fn complaints(root: &Value, schema: &Value, value: &Value, path: &str) -> Vec<String> {
    if schema == &Value::Bool(true) {
        return Vec::new();
    }
    if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
        let target = root.pointer(reference.trim_start_matches('#')).unwrap_or_else(|| panic!("no {reference}"));
        return complaints(root, target, value, path);
    }
    for key in ["anyOf", "oneOf"] {
        if let Some(alternatives) = schema.get(key).and_then(Value::as_array)
            && alternatives.iter().all(|one| !complaints(root, one, value, path).is_empty())
        {
            return vec![format!("{path}: {value} is none of {key}")];
        }
    }
    let mut found = Vec::new();
    let is = |name: &str| match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("{path}: unknown type {other}"),
    };
    let right = match schema.get("type") {
        None => true,
        Some(Value::String(name)) => is(name),
        Some(Value::Array(names)) => names.iter().filter_map(Value::as_str).any(is),
        Some(other) => panic!("{path}: type {other}"),
    };
    if !right {
        found.push(format!("{path}: {value} is not of type {}", schema["type"]));
    }
    if let Some(allowed) = schema.get("enum").and_then(Value::as_array)
        && !allowed.contains(value)
    {
        found.push(format!("{path}: {value} is none of {allowed:?}"));
    }
    if schema.get("const").is_some_and(|constant| constant != value) {
        found.push(format!("{path}: {value} is not {}", schema["const"]));
    }
    if let Some(object) = value.as_object() {
        for key in schema.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str) {
            if !object.contains_key(key) {
                found.push(format!("{path}: {key} is missing"));
            }
        }
        let known = schema.get("properties").and_then(Value::as_object);
        for (key, item) in object {
            let path = format!("{path}/{key}");
            match known.and_then(|known| known.get(key)).or_else(|| schema.get("additionalProperties")) {
                Some(schema) => found.extend(complaints(root, schema, item, &path)),
                None if known.is_some() => found.push(format!("{path}: not in the schema")),
                None => {}
            }
        }
    }
    if let (Some(items), Some(schema)) = (value.as_array(), schema.get("items")) {
        for (i, item) in items.iter().enumerate() {
            found.extend(complaints(root, schema, item, &format!("{path}/{i}")));
        }
    }
    found
}

fn schema(name: &str) -> Value {
    bifdiag(&format!("schema {name}")).succeeds().json()
}

fn assert_fits(name: &str, document: &Value) {
    let schema = schema(name);
    assert_eq!(complaints(&schema, &schema, document, ""), Vec::<String>::new());
}

const PART: &str = "--inertia 0.30,0.21,0.17,0.01,0,-0.02 --products tensor --com 0,0.02,0.15 --mass 2.5 --g 9.80665";

#[test]
fn documents_fit_their_schemas() {
    for body in ["--body paper", "--body euler", "--body lagrange", "--body ten", PART] {
        assert_fits("atlas", &bifdiag(&format!("{body} --json")).succeeds().json());
        assert_fits("classify", &bifdiag(&format!("classify {body} --h 1.5 --l 0.5 --json")).succeeds().json());
        assert_fits("critical", &bifdiag(&format!("critical {body} --l 1.5 --json")).succeeds().json());
        let axes = bifdiag(&format!("critical {body} --json --spin")).and("300 rpm").succeeds().json();
        assert_fits("steady-axes", &axes);
        assert_fits("steady-spins", &bifdiag(&format!("critical-spin {body} --json")).succeeds().json());
    }
    assert_fits("atlas", &bifdiag("--body paper --json --window 0:6,0:4").succeeds().json());
    let section = "section --body paper --h 4.45 --l 3.25 --orbits 3 --crossings 40 --json";
    for more in ["", "--color lyapunov", "--tol 1e-9 --max-time 5", "--condition angular-momentum"] {
        assert_fits("section", &bifdiag(&format!("{section} {more}")).succeeds().json());
    }
    let part = format!("section {PART} --h 0.65 --l 0.464 --orbits 2 --crossings 5 --json");
    assert_fits("section", &bifdiag(&part).succeeds().json());
    let atlas = bifdiag("--body paper --json").succeeds().stdout();
    let sections = bifdiag("section --atlas - --orbits 1 --crossings 2 --json").reading(atlas);
    assert_fits("sections", &sections.succeeds().json());
    for more in ["--body paper", "--body euler", PART] {
        let orbit = format!("orbit {more} --gamma 0.6,0,0.8 --omega 1,0.3,1 --json");
        assert_fits("orbit", &bifdiag(&orbit).succeeds().json());
        assert_fits("proved-orbit", &bifdiag(&format!("{orbit} --proved --times -1:1:3")).succeeds().json());
    }
    assert_fits("body", &bifdiag(&format!("body {PART} --json")).succeeds().json());
    for state in ["--spin 1Hz --axis z", "--omega 1,0,2 --vertical 0,0,1"] {
        assert_fits("state", &bifdiag(&format!("state {PART} {state} --json")).succeeds().json());
        assert_fits("state", &bifdiag(&format!("state --A 2,1.1,1 --r 0,0,1 {state} --json")).succeeds().json());
    }
    for axis in ["--A 2,1.1,1 --r 0,0,1 --axis z --tolerance 1%", "--body euler --axis x", "--body paper --axis x"] {
        assert_fits("critical-spin", &bifdiag(&format!("critical-spin {axis} --json")).succeeds().json());
    }
    for point in ["--body paper --h 5.3 --l 3.25", "--body euler --h 2 --l 1"] {
        assert_fits("chaos", &bifdiag(&format!("chaos {point} --error 0.2 --steps 320 --json")).succeeds().json());
    }
    let place = tempfile::tempdir().unwrap();
    let map = "chaos --body paper --window 3.2:4.2,2.9:3.5 --cells 2x2 --error 0.3 --steps 320 -q --out map.json";
    bifdiag(map).inside(place.path()).succeeds();
    let map = std::fs::read(place.path().join("map.json")).unwrap();
    assert_fits("chaos-map", &serde_json::from_slice(&map).unwrap());
    for from in ["--A 2,2,3 --r 0,0,1 --from L-.2", "--body paper --from G2.1 --l 3.25", "--body lagrange --from L+.1"]
    {
        assert_fits("spin-down", &bifdiag(&format!("spin-down {from} --json")).succeeds().json());
    }
    for more in ["--body paper --l 1.5", "--body paper --from G1.1 --h 5", "--body lagrange --l 1"] {
        let families = format!("periodic family {more} --members 12 --branches --json");
        assert_fits("periodic-families", &bifdiag(&families).succeeds().json());
    }
    for more in ["--l 1.5", "--l 1:2:2 --branches --stable --period 2:6 --crossings 4", "--h 5 --family G2.1/1"] {
        let list = format!("periodic list --body paper {more} --members 12 --json");
        assert_fits("periodic-list", &bifdiag(&list).succeeds().json());
    }
    let manifolds = "periodic manifolds --body paper --h 6.5 --l 3.25 --length 2 --json";
    assert_fits("periodic-manifolds", &bifdiag(manifolds).succeeds().json());
    assert_fits("periodic", &bifdiag("periodic --body paper --h 2.6 --l 3.25 --json").succeeds().json());
    assert_fits("bodies", &bifdiag("bodies --json").succeeds().json());
    assert_fits("explain", &bifdiag("explain cusp --json").succeeds().json());
    assert_fits("compare", &bifdiag("compare paper katok:1 --json").succeeds().json());
    assert_fits("point-proof", &bifdiag("classify --body paper --h 3.8 --l 3.25 --certificate").succeeds().json());
    assert_fits("find", &bifdiag("find --type M3 --json").succeeds().json());
    assert_fits("find", &bifdiag("find --type k3n0 --json").succeeds().json());
    assert_fits("find", &bifdiag("find --critical-points 12 --samples 50 --json").fails().json());
    assert_fits("classes", &bifdiag("classes --physical --json").succeeds().json());
    assert_fits("class", &bifdiag("class 01036ac4a504 --json").succeeds().json());
    assert_fits("classes-at", &bifdiag("classes --at --body paper --lines 2 --json").succeeds().json());
    assert_fits("scan-border", &bifdiag("scan border --body katok:2 --vary A3=0.7:0.8 --json").succeeds().json());
    assert_fits("scan-events", &bifdiag("scan events --body paper --vary r2=0.01:0.4:9 --json").succeeds().json());
    let scan = "scan --body paper --vary r2=0:0.5:3,r3=0:0.5:3 --format jsonl --out -";
    for row in bifdiag(scan).succeeds().json_lines() {
        assert_fits("scan-row", &row);
    }
    let place = tempfile::tempdir().unwrap();
    let scan = "scan --family general --samples 20 --out a.csv --json";
    assert_fits("scan-summary", &bifdiag(scan).inside(place.path()).succeeds().json());
    assert_fits("batch-error", &bifdiag("classify --batch -").reading("x").succeeds().json());
}

#[test]
fn the_validator_sees_what_is_wrong() {
    let schema = schema("classify");
    let mut document = bifdiag("classify --body paper --h 1.5 --l 0.5 --json").succeeds().json();
    document["status"] = "maybe".into();
    assert!(!complaints(&schema, &schema, &document, "").is_empty());
    document["status"] = "regular".into();
    document["margin"]["h"] = "wide".into();
    assert!(!complaints(&schema, &schema, &document, "").is_empty());
    let empty = serde_json::json!({});
    assert!(complaints(&schema, &schema, &empty, "").len() >= 8);
}

#[test]
fn all_schemas_come_in_one_object() {
    let all = bifdiag("schema --json").succeeds().json();
    let names = [
        "atlas",
        "classify",
        "critical",
        "steady-axes",
        "section",
        "sections",
        "orbit",
        "proved-orbit",
        "body",
        "state",
        "critical-spin",
        "bodies",
        "explain",
        "batch-error",
        "scan-row",
        "scan-summary",
        "scan-border",
        "scan-events",
        "compare",
        "point-proof",
        "find",
        "classes",
        "class",
        "classes-at",
    ];
    for name in names {
        assert_eq!(all[name], schema(name));
        bifdiag("schema").succeeds().printing(&format!("\n{name} "));
    }
}
