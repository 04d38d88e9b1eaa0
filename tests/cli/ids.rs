//! W6: every id and name that an output, a shipped picture or a page prints is accepted where such things are asked for.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::tempdir;

use crate::builder::bifdiag;

/// Words of a class's name: 12 hexadecimal digits that stand alone. (Twelve decimal digits are a number.)
fn class_names(text: &str) -> BTreeSet<String> {
    let digit = |c: char| matches!(c, '0'..='9' | 'a'..='f');
    text.split(|c: char| !(c.is_alphanumeric() || "-._+/=".contains(c)))
        .map(|word| word.trim_end_matches('.'))
        .filter(|word| word.len() == 12 && word.chars().all(digit) && word.chars().any(char::is_alphabetic))
        .map(str::to_owned)
        .collect()
}

/// The names of classes that come with the program.
fn shipped() -> BTreeSet<String> {
    let list = bifdiag("classes --json").succeeds().json();
    let names =
        |key: &str| list[key].as_array().unwrap().iter().map(|class| class["name"].as_str().unwrap().to_owned());
    names("classes").chain(names("others")).collect()
}

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

/// Files of a folder of the repository that end so.
fn files(folder: &str, ends: &[&str]) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.is_file() && ends.iter().any(|end| path.to_string_lossy().ends_with(end)));
    files.sort();
    files
}

#[test]
fn w6_every_class_that_a_picture_a_page_or_shipped_data_print_is_known() {
    let known = shipped();
    let mut seen = BTreeSet::new();
    let folders = [
        ("figures", &[".svg", ".md"][..]),
        ("docs", &[".md"]),
        ("data/survey", &[".json"]),
        ("data", &["witnesses.json", "classes.json"]),
        (".", &["README.md"]),
    ];
    for (folder, ends) in folders {
        for path in files(folder, ends) {
            let text = fs::read_to_string(&path).unwrap();
            // Clouds of points are images in base 64.
            let text: String =
                text.split('"').filter(|part| !part.starts_with("data:image")).collect::<Vec<_>>().join("\"");
            for name in class_names(&text) {
                assert!(known.contains(&name), "{} prints {name}", path.display());
                seen.insert(name);
            }
        }
    }
    assert!(seen.len() > 900, "only {} were found", seen.len());
}

#[test]
fn w6_class_answers_for_the_maps_of_katok_and_of_the_paper() {
    let mut names = BTreeSet::new();
    for map in ["map-katok.svg", "map-lagrange-kovalevskaya.svg"] {
        names.extend(class_names(&read(&format!("figures/{map}"))));
    }
    // Some of those of another.
    let near = class_names(&read("figures/map-paper-a2-r3-near.svg"));
    names.extend(near.into_iter().step_by(2));
    assert!(names.len() > 15);
    for name in &names {
        let class = bifdiag(&format!("class {name} --json")).succeeds().telling_nothing().json();
        assert_eq!(class["name"].as_str(), Some(name.as_str()));
        assert!(class["stratum"].is_string() && class["text"].as_str().unwrap().starts_with("map 1\n"), "{name}");
        let list = |key: &str| {
            let numbers = class["witness"][key].as_array().unwrap();
            numbers.iter().map(|number| number.as_str().unwrap()).collect::<Vec<_>>().join(",")
        };
        let line = format!("classes --at --lines 1 --A {} --r {} --json", list("A"), list("r"));
        let found = bifdiag(&line).succeeds().json();
        assert_eq!((found["name"].as_str(), &found["known"]), (Some(name.as_str()), &Value::from(true)), "{line}");
    }
    let place = tempdir().unwrap();
    bifdiag("class 2614395a2a0f").inside(place.path()).succeeds().printing("r on axis 1").printing("written: ");
}

/// All bodies with a name, so all kinds of special ones.
fn presets() -> Vec<String> {
    let list = bifdiag("bodies --json").succeeds().json();
    list["bodies"].as_array().unwrap().iter().map(|body| body["name"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn w6_the_class_of_every_named_body_is_known() {
    for body in presets() {
        let found = bifdiag(&format!("classes --at --body {body} --lines 1 --json")).succeeds().json();
        assert_eq!(found["known"], true, "{body}");
        let name = found["name"].as_str().unwrap();
        bifdiag(&format!("class {name} --no-plot")).succeeds().printing(name);
    }
}

#[test]
fn an_unknown_class_is_refused_with_the_way_to_a_body_of_it() {
    bifdiag("class 2614395a2a00").refused().telling("the nearest is 2614395a2a0f").telling("classes --at --body");
    bifdiag("class zzz").refused().telling("begins with it;");
    bifdiag("class 2614395A --no-plot").succeeds().printing("class 2614395a2a0f");
}

/// Every string below a key that is one of these, at any depth.
fn strings(value: &Value, keys: &[&str], found: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                if keys.contains(&key.as_str()) {
                    let list = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
                    found.extend(list.iter().filter_map(Value::as_str).map(str::to_owned));
                }
                strings(value, keys, found);
            }
        }
        Value::Array(list) => list.iter().for_each(|value| strings(value, keys, found)),
        _ => {}
    }
}

#[test]
fn w6_every_id_of_a_body_is_accepted_by_show() {
    let bodies = ["--A 2,1.4,1 --r 0.3,0.5,0.8", "--A 1,1,1.3 --r 0,0.6,0.8", "--A 1,1,1 --r 0,0,0"].map(str::to_owned);
    for body in presets().into_iter().map(|name| format!("--body {name}")).chain(bodies) {
        let atlas = bifdiag(&format!("{body} --no-drawing --json")).succeeds().json();
        let mut ids = BTreeSet::new();
        let keys = ["id", "region", "curve", "curves", "nearest", "coincides_with", "branch"];
        strings(&atlas, &keys, &mut ids);
        let sample = &atlas["regions"][0]["sample"];
        let (h, l) = (sample["h"].as_f64().unwrap(), sample["l"].as_f64().unwrap());
        for line in [
            format!("critical {body} --l={l} --json"),
            format!("classify {body} --h={h} --l={l} --json"),
            format!("state {body} --omega 1,2,0.5 --vertical 0.6,0,0.8 --json"),
        ] {
            strings(&bifdiag(&line).succeeds().json(), &keys, &mut ids);
        }
        // As pictures write them.
        ids.extend(ids.clone().into_iter().filter(|id| id.contains('-')).map(|id| id.replace('-', "−")));
        for id in &ids {
            bifdiag(&format!("show {id} {body}")).succeeds().printing(&id.replace('−', "-"));
        }
        for place in 1..=atlas["events"].as_array().unwrap().len() {
            bifdiag(&format!("show E{place} {body}")).succeeds().printing("regions that meet there");
        }
        let found = bifdiag(&format!("classify {body} --h={h} --l={l} --json")).succeeds().json();
        assert_eq!(found["region"], atlas["regions"][0]["id"], "{body}");
    }
}

#[test]
fn w6_every_region_is_accepted_by_section_and_sphere_and_every_type_by_find() {
    let place = tempdir().unwrap();
    let mut types = BTreeSet::new();
    for body in ["paper", "katok:7", "lagrange"] {
        let atlas = bifdiag(&format!("--body {body} --no-drawing --json")).succeeds().json();
        let mut regions = BTreeSet::new();
        strings(&atlas["regions"], &["id"], &mut regions);
        strings(&atlas["regions"], &["section"], &mut types);
        for id in &regions {
            let ask = format!("--body {body} --region {id}");
            bifdiag(&format!("section {ask} --orbits 1 --crossings 2 --json")).inside(place.path()).succeeds();
            bifdiag(&format!("sphere {ask}")).inside(place.path()).succeeds();
        }
        let mut signatures = BTreeSet::new();
        strings(&atlas["regions"], &["signature"], &mut signatures);
        for signature in &signatures {
            bifdiag(&format!("find --signature {signature}")).succeeds().printing(signature);
        }
    }
    strings(&bifdiag("classes --json").succeeds().json(), &["types"], &mut types);
    assert!(types.len() > 10, "{types:?}");
    for kind in &types {
        bifdiag(&format!("find --type {kind} --samples 1")).succeeds().printing(kind);
    }
}

/// r = 0 has no poles, so its regions of whole spheres are k0n0: it was said that this does not exist.
#[test]
fn w6_what_eulers_case_shows_is_only_denied_for_other_bodies() {
    let class = bifdiag("classes --at --body euler --lines 1 --json").succeeds().json();
    let shown = bifdiag(&format!("class {} --json", class["name"].as_str().unwrap())).succeeds().json();
    assert!(shown["types"].as_array().unwrap().contains(&Value::from("k0n0")));
    bifdiag("find --type k0n0").succeeds().printing("k0n0 does not exist for r ≠ 0").printing("--body euler");
}

/// The saddles of a pair: two circles more; a cusp of pairs: four relative equilibria.
#[test]
fn pairs_are_counted_twice() {
    let curve = bifdiag("show S2.1 --A 12,3,5 --r 3,0,0").succeeds().stdout();
    assert!(curve.contains("at two saddles U gets two more boundary circles"), "{curve}");
    let event = bifdiag("show E1 --A 12,3,5 --r 3,0,0").succeeds();
    event.printing("cusp: two symmetric pairs of relative equilibria meet and vanish");
    bifdiag("show E1 --A 2,1.1,1 --r 0.3,0.2,0.6").succeeds().printing("cusp: two relative equilibria meet and vanish");
}
