//! `bifdiag section`: its documents, data and pictures.

use std::fs;
use std::io::Read;
use std::path::Path;

use serde_json::{Value, json};

use crate::builder::bifdiag;

const CHAOS: &str = "section --body paper --h 4.45 --l 3.25";

fn names(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// An array of an NPZ archive: its NumPy type and shape as written, and its bytes.
pub fn array(archive: &Path, name: &str) -> (String, Vec<u8>) {
    let mut zip = zip::ZipArchive::new(fs::File::open(archive).unwrap()).unwrap();
    let mut bytes = Vec::new();
    zip.by_name(&format!("{name}.npy")).unwrap().read_to_end(&mut bytes).unwrap();
    let data = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    (String::from_utf8(bytes[10..data].to_vec()).unwrap(), bytes.split_off(data))
}

pub fn floats(archive: &Path, name: &str) -> Vec<f64> {
    let (head, bytes) = array(archive, name);
    assert!(head.contains("'<f8'"), "{head}");
    bytes.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect()
}

pub fn integers(archive: &Path, name: &str) -> Vec<i32> {
    let (head, bytes) = array(archive, name);
    assert!(head.contains("'<i4'"), "{head}");
    bytes.chunks_exact(4).map(|x| i32::from_le_bytes(x.try_into().unwrap())).collect()
}

/// The document in the array `meta`.
pub fn meta(archive: &Path) -> Value {
    let (head, bytes) = array(archive, "meta");
    assert!(head.contains("'<U"), "{head}");
    let code = |x: &[u8]| char::from_u32(u32::from_le_bytes(x.try_into().unwrap())).unwrap();
    serde_json::from_str(&bytes.chunks_exact(4).map(code).collect::<String>()).unwrap()
}

#[test]
fn picture_points_and_summary_are_written() {
    let place = tempfile::tempdir().unwrap();
    let done = bifdiag(&format!("{CHAOS} --orbits 6 --crossings 50")).inside(place.path()).succeeds().telling_nothing();
    done.printing("P = T2 + T2").printing("300 crossings of 6 orbits").printing("written: bifdiag-out/section.npz");
    assert_eq!(names(&place.path().join("bifdiag-out")), ["section.json", "section.npz", "section.svg"]);
    let archive = place.path().join("bifdiag-out/section.npz");
    let rows = 6 * 51;
    let orbit = integers(&archive, "orbit");
    let index = integers(&archive, "index");
    assert_eq!((orbit.len(), index.iter().filter(|index| **index == 0).count()), (rows, 6));
    assert_eq!(floats(&archive, "time").len(), rows);
    let (gamma, l) = (floats(&archive, "gamma"), floats(&archive, "l"));
    assert!(array(&archive, "gamma").0.contains(&format!("({rows}, 3)")));
    for row in 0..rows {
        let dot = |u: &[f64], v: &[f64]| (0..3).map(|i| u[3 * row + i] * v[3 * row + i]).sum::<f64>();
        assert!((dot(&gamma, &gamma) - 1.0).abs() < 1e-13 && (dot(&gamma, &l) - 3.25).abs() < 1e-13);
    }
    let (head, sheet) = array(&archive, "sheet");
    assert!(head.contains("'|i1'") && sheet.iter().all(|x| *x == 1 || *x == 255));
    assert_eq!((floats(&archive, "s_dot").len(), floats(&archive, "psi").len()), (rows, rows));
    let summary: Value =
        serde_json::from_str(&fs::read_to_string(place.path().join("bifdiag-out/section.json")).unwrap()).unwrap();
    assert_eq!(meta(&archive), summary);
    assert_eq!(summary["signature"], "T2+T2");
    assert!(summary["summary"]["drift"]["h"].as_f64().unwrap() < 1e-13);
}

#[test]
fn starts_are_spread_over_all_components_and_both_sheets() {
    let document = bifdiag(&format!("{CHAOS} --orbits 8 --crossings 2 --json")).succeeds().json();
    let list = |key: &str| -> Vec<i64> {
        document["orbits"].as_array().unwrap().iter().map(|orbit| orbit[key].as_i64().unwrap()).collect()
    };
    assert_eq!(list("component"), [0, 1, 0, 1, 0, 1, 0, 1]);
    assert_eq!(list("sheet").iter().sum::<i64>(), 0);
    // Another seed gives other starts; the same seed the same bytes.
    let other = bifdiag(&format!("{CHAOS} --orbits 8 --crossings 2 --json --seed 1")).succeeds().json();
    assert_ne!(document["orbits"][0]["theta"], other["orbits"][0]["theta"]);
    assert_eq!(document["starts"], json!({"orbits": 8, "seed": 0}));
}

#[test]
fn the_same_input_gives_the_same_bytes_with_any_number_of_threads() {
    let place = tempfile::tempdir().unwrap();
    for threads in ["1", "3"] {
        let line =
            format!("{CHAOS} --orbits 20 --crossings 60 --threads {threads} --color rotation --data d{threads}.npz");
        bifdiag(&format!("{line} --out o{threads} --format svg,png")).inside(place.path()).succeeds();
    }
    let read = |name: &str| fs::read(place.path().join(name)).unwrap();
    assert!(read("d1.npz") == read("d3.npz"));
    for name in names(&place.path().join("o1")) {
        assert!(read(&format!("o1/{name}")) == read(&format!("o3/{name}")), "{name}");
    }
}

#[test]
fn csv_goes_to_stdout_or_a_file() {
    let place = tempfile::tempdir().unwrap();
    let line = format!("{CHAOS} --orbits 2 --crossings 3 --no-plot");
    let csv = bifdiag(&format!("{line} --data -")).inside(place.path()).succeeds().telling_nothing().stdout();
    assert_eq!(csv.lines().next(), Some("orbit,index,time,gamma1,gamma2,gamma3,l1,l2,l3,sheet,s_dot,theta,psi"));
    assert_eq!(csv.lines().count(), 1 + 2 * 4);
    bifdiag(&format!("{line} --data sub/points.csv")).inside(place.path()).succeeds().printing("sub/points.csv");
    assert_eq!(fs::read_to_string(place.path().join("sub/points.csv")).unwrap(), csv);
    bifdiag(&format!("{line} --data points.jsonl")).inside(place.path()).succeeds();
    let lines = fs::read_to_string(place.path().join("points.jsonl")).unwrap();
    let rows: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((rows.len(), rows[1]["gamma"].as_array().unwrap().len()), (8, 3));
    assert_eq!(names(place.path()), ["points.jsonl", "sub"], "--data with --no-plot writes nothing else");
}

#[test]
fn seeds_are_the_users() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("starts.csv"), "theta,psi,sheet\n0.9,1.5,1\n# the other sheet\n2.9,pi/2,-1\n").unwrap();
    let line = format!("{CHAOS} --crossings 5 --starts starts.csv --json");
    let document = bifdiag(&line).inside(place.path()).succeeds().json();
    assert_eq!(document["starts"], json!({"orbits": 2}));
    assert_eq!((&document["orbits"][0]["theta"], &document["orbits"][1]["sheet"]), (&json!(0.9), &json!(-1)));
    let points = fs::read_to_string(place.path().join("starts.csv")).unwrap();
    let piped = bifdiag(&line.replace("starts.csv", "-")).reading(points).succeeds().json();
    assert_eq!(piped, document);
    // What the program writes it can read: crossings as new starts.
    let csv = bifdiag(&format!("{CHAOS} --orbits 3 --crossings 4 --data -")).succeeds().stdout();
    let again = bifdiag(&line.replace("starts.csv", "-")).reading(csv).succeeds().json();
    assert_eq!(again["orbits"].as_array().unwrap().len(), 15);
}

#[test]
fn a_coarser_tolerance_gives_the_same_crossings_and_is_reported() {
    let line = "section --body paper --h 2.6 --l 3.25 --orbits 2 --crossings 10";
    let column = |text: &str| -> Vec<f64> {
        text.lines().skip(1).map(|line| line.split(',').nth(2).unwrap().parse().unwrap()).collect()
    };
    let times = column(&bifdiag(&format!("{line} --data -")).succeeds().stdout());
    let found = column(&bifdiag(&format!("{line} --tol 1e-9 --data -")).succeeds().stdout());
    let worst = times.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(found.len() == times.len() && worst > 0.0 && worst < 1e-6, "{worst:e}");
    let document = bifdiag(&format!("{line} --tol 1e-9 --json")).succeeds().json();
    assert_eq!(document["integrator"], json!({"name": "taylor", "tol": 1e-9}));
    assert!(document["command"].as_str().unwrap().contains("--tol 0.000000001"), "{}", document["command"]);
}

const LONG: &str = "section --body paper --h 4.45 --l 3.25 --orbits 7 --crossings 300 --no-plot";

#[test]
fn streamed_data_are_those_from_memory() {
    let place = tempfile::tempdir().unwrap();
    let parquet =
        if cfg!(feature = "parquet") { vec![("parquet", "none", "--seed 3"), ("parquet", "only", "")] } else { vec![] };
    let others = [
        ("npz", "none", ""),
        ("npz", "only", "--crossings 900"),
        ("npz", "only", "--condition angular-momentum"),
        ("csv", "none", "--condition angular-momentum"),
        ("jsonl", "only", "--tol 1e-12"),
    ];
    for (ending, verdict, rest) in others.into_iter().chain(parquet) {
        let line = format!("{LONG} {rest} --verdict {verdict}")
            .replace("--crossings 300 --no-plot --crossings", "--no-plot --crossings");
        bifdiag(&format!("{line} --data s.{ending}")).inside(place.path()).succeeds().printing("written: s.");
        bifdiag(&format!("{line} --data m.{ending} --out o")).inside(place.path()).succeeds();
        let read = |name: &str| fs::read(place.path().join(format!("{name}.{ending}"))).unwrap();
        assert!(read("s") == read("m"), "{ending}");
        assert!(!place.path().join(format!("s.{ending}.partial")).exists());
    }
}

/// Among orbits of the paper's chaos some are chaotic, some regular; those of a stream and from memory alike.
#[test]
fn streamed_verdicts_are_those_from_memory() {
    let place = tempfile::tempdir().unwrap();
    let line = "section --body paper --h 5.3 --l 3.25 --orbits 12 --crossings 3000 --no-plot --verdict";
    bifdiag(&format!("{line} only --data s.npz")).inside(place.path()).succeeds().printing("verdicts: ");
    let of = |verdict: &str| bifdiag(&format!("{line} {verdict} --json")).succeeds().json();
    let (whole, only) = (of("whole"), of("only"));
    let mut seen = std::collections::BTreeSet::new();
    for (one, other) in whole["orbits"].as_array().unwrap().iter().zip(only["orbits"].as_array().unwrap()) {
        // An orbit that is open after 3000 crossings is followed further by "whole" alone.
        if other["verdict"] != "open" {
            for field in ["verdict", "reason", "decided"] {
                assert_eq!(one[field], other[field]);
            }
        }
        seen.insert(one["verdict"].as_str().unwrap().to_owned());
    }
    assert!(seen.contains("regular") && seen.contains("chaotic"), "{seen:?}");
    // The document is in the archive as text of four bytes a letter.
    let archive = fs::read(place.path().join("s.npz")).unwrap();
    let letters: Vec<u8> =
        serde_json::to_string(&only["orbits"]).unwrap().chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
    assert!(archive.windows(letters.len()).any(|part| part == letters));
}

#[test]
fn a_journal_cut_anywhere_leads_to_the_same_bytes_and_that_of_another_section_is_refused() {
    let place = tempfile::tempdir().unwrap();
    for verdict in ["none", "only"] {
        a_journal_cut_anywhere(&format!("{LONG} --verdict {verdict} --data s.npz"), &place);
    }
}

fn a_journal_cut_anywhere(line: &str, place: &tempfile::TempDir) {
    let file = |name: &str| place.path().join(name);
    bifdiag(line).inside(place.path()).succeeds();
    let whole = fs::read(file("s.npz")).unwrap();
    // An interrupt leaves the journal; so does a directory in the way of the file.
    fs::remove_file(file("s.npz")).unwrap();
    fs::create_dir(file("s.npz")).unwrap();
    bifdiag(line).inside(place.path()).fails().telling("directory");
    fs::remove_dir(file("s.npz")).unwrap();
    let journal = fs::read(file("s.npz.partial")).unwrap();
    for cut in [0, 10, journal.len() / 3, journal.len() / 2 + 1, journal.len() - 1, journal.len()] {
        fs::write(file("s.npz.partial"), &journal[..cut]).unwrap();
        bifdiag(line).inside(place.path()).succeeds();
        assert!(fs::read(file("s.npz")).unwrap() == whole, "{cut}");
        assert!(!file("s.npz.partial").exists());
    }
    let mut altered = journal.clone();
    let last = altered.len() - 100;
    altered[last] ^= 1;
    fs::write(file("s.npz.partial"), &altered).unwrap();
    bifdiag(line).inside(place.path()).succeeds();
    assert!(fs::read(file("s.npz")).unwrap() == whole);
    fs::write(file("s.npz.partial"), &journal).unwrap();
    bifdiag(&line.replace("300", "301")).inside(place.path()).refused().telling("another unfinished section");
    assert_eq!(fs::read(file("s.npz.partial")).unwrap(), journal);
    fs::remove_file(file("s.npz.partial")).unwrap();
}

#[test]
fn sections_are_coloured_by_verdict_unless_there_is_none() {
    let place = tempfile::tempdir().unwrap();
    let svg = |options: &str| {
        let line = format!("section --body paper --h 5.3 --l 3.25 --orbits 8 --crossings 600 --out s {options}");
        bifdiag(&line).inside(place.path()).succeeds();
        fs::read_to_string(place.path().join("s/section.svg")).unwrap()
    };
    let sides = |svg: &str| svg.contains("on both sides: orbits") || svg.contains("on the side of");
    let judged = svg("");
    let is_judged = ["regular orbits", "chaotic orbits", "undecided orbits"];
    assert!(is_judged.iter().any(|text| judged.contains(text)) && !sides(&judged));
    assert_eq!(judged, svg("--color verdict --verdict only"));
    let side = svg("--color side");
    assert!(sides(&side) && !side.contains("told apart by shades"));
    let plain = svg("--verdict none");
    assert!(sides(&plain) && plain.contains("told apart by shades"));
    bifdiag("section --body paper --h 5.3 --l 3.25 --verdict none --color verdict")
        .refused()
        .telling("--verdict none and --color verdict contradict each other");
}

#[test]
fn regions_that_are_listed_share_a_picture_in_their_order() {
    let place = tempfile::tempdir().unwrap();
    let line = "section --body paper --region R7,R2 --orbits 3 --crossings 40 --out compared --json";
    let list = bifdiag(line).inside(place.path()).succeeds().json();
    let regions: Vec<&str> =
        list["sections"].as_array().unwrap().iter().map(|one| one["region"].as_str().unwrap()).collect();
    assert_eq!(regions, ["R7", "R2"]);
    let files = ["R2.json", "R2.npz", "R7-R2.svg", "R7.json", "R7.npz"].map(|end| format!("section-{end}"));
    assert_eq!(names(&place.path().join("compared")), files);
    let picture = fs::read_to_string(place.path().join("compared/section-R7-R2.svg")).unwrap();
    let at = |region: &str| picture.find(&format!(">{region},")).unwrap_or_else(|| panic!("no row of {region}"));
    assert!(at("R7") < at("R2"));
    let unknown = bifdiag("section --body paper --region R2,R90").refused();
    unknown.telling("--region R90: the body has no such region; it has R1, R2");
}

/// Two of three orbits that 400 crossings leave open are decided further on; what is drawn and written stays as it was asked for.
#[test]
fn open_orbits_are_followed_further_for_their_verdicts() {
    let line = format!("{CHAOS} --orbits 6 --no-plot --json");
    let short = bifdiag(&format!("{line} --crossings 400")).succeeds().json();
    let long = bifdiag(&format!("{line} --crossings 800 --verdict only")).succeeds().json();
    let orbits = |document: &Value| document["orbits"].as_array().unwrap().clone();
    let mut later = 0;
    for (short, long) in orbits(&short).iter().zip(&orbits(&long)) {
        assert_eq!(short["crossings"], 400);
        if short["verdict"] != "open" && short["decided"]["crossing"].as_u64() > Some(400) {
            later += 1;
        }
        assert!(long["verdict"] == "open" || short["verdict"] == long["verdict"], "{short} {long}");
    }
    assert!(later > 0);
    let notes = short["notes"].to_string();
    assert!(notes.contains("without a verdict after 400 crossings, followed for it alone over up to 1600"), "{notes}");
    let exact = bifdiag(&format!("{line} --crossings 400 --verdict only")).succeeds().json();
    assert!(exact["notes"].is_null(), "{exact}");
}

/// The sample of a certified atlas is another point of the region.
#[test]
fn the_command_of_a_section_leads_to_its_point() {
    let atlas = bifdiag("atlas --body paper --certificate --json").succeeds().stdout();
    let found =
        bifdiag("section --atlas - --region R5 --orbits 2 --crossings 10 --json").reading(atlas).succeeds().json();
    let made =
        "bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623 --certificate --json | bifdiag section --atlas=- --region R5 ";
    assert!(found["command"].as_str().unwrap().starts_with(made), "{}", found["command"]);
    let section = &found["sections"][0];
    let again = bifdiag(section["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap()).succeeds().json();
    for field in ["h", "l", "orbits", "command"] {
        assert_eq!(section[field], again[field], "{field}");
    }
}
