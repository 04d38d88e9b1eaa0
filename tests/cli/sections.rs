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
fn every_integrator_gives_the_same_crossings() {
    let line = "section --body paper --h 2.6 --l 3.25 --orbits 2 --crossings 10 --data -";
    let column = |text: &str| -> Vec<f64> {
        text.lines().skip(1).map(|line| line.split(',').nth(2).unwrap().parse().unwrap()).collect()
    };
    let times = column(&bifdiag(line).succeeds().stdout());
    for (integrator, tolerance) in
        [("dop853", 1e-9), ("dop853 --tol 1e-9", 1e-6), ("rk4", 1e-3), ("rk4 --step 0.001", 1e-8), ("splitting", 1e-2)]
    {
        let found = column(&bifdiag(&format!("{line} --integrator {integrator}")).succeeds().stdout());
        let worst = times.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(found.len() == times.len() && worst < tolerance, "{integrator}: {worst:e}");
    }
    let document = bifdiag("section --body paper --h 2.6 --l 3.25 --orbits 1 --crossings 2 --integrator rk4 --json");
    let integrator = &document.succeeds().json()["integrator"];
    assert_eq!((&integrator["name"], integrator.get("tol")), (&json!("rk4"), None));
    assert!(integrator["step"].as_f64().unwrap() > 0.001);
}

#[test]
fn the_other_section_is_there_for_comparison() {
    let place = tempfile::tempdir().unwrap();
    let line = "section --body paper --h 2.6 --l 3.25 --orbits 4 --crossings 20 --condition angular-momentum";
    let done = bifdiag(&format!("{line} --projection sphere --json --out o")).inside(place.path()).succeeds();
    assert_eq!(done.json()["condition"], "angular-momentum");
    assert!(fs::read_to_string(place.path().join("o/section.svg")).unwrap().contains("S⁻"));
    // The starts lie on the other section, so that there is no point of index 0 here.
    assert!(integers(&place.path().join("o/section.npz"), "index").iter().all(|index| *index > 0));
}

#[test]
fn measures_of_chaos_go_into_the_data() {
    let place = tempfile::tempdir().unwrap();
    let line = format!("{CHAOS} --orbits 8 --crossings 400 --color lyapunov --json --out o");
    let document = bifdiag(&line).inside(place.path()).succeeds().json();
    let exponent = |k: usize| document["orbits"][k]["chaos"]["lyapunov"]["exponent"].as_f64().unwrap();
    // Round the north pole the motion is regular, round the south pole it is not (the paper, section 5).
    assert!((0..8).step_by(2).all(|k| exponent(k) < 0.02));
    assert!((1..8).step_by(2).any(|k| exponent(k) > 0.05));
    let archive = place.path().join("o/section.npz");
    let (orbit, lyapunov) = (integers(&archive, "orbit"), floats(&archive, "lyapunov"));
    assert!(orbit.iter().zip(&lyapunov).all(|(k, x)| *x == exponent(usize::try_from(*k).unwrap())));
    assert_eq!(floats(&archive, "rotation").len(), orbit.len());
    // λ(t) runs from the start, where there is none.
    let (index, running) = (integers(&archive, "index"), floats(&archive, "exponent"));
    assert!(index.iter().zip(&running).all(|(index, x)| x.is_nan() == (*index == 0)));
    bifdiag(&line.replace("--json", "")).inside(place.path()).succeeds().printing("Lyapunov");
}

#[test]
fn every_orbit_has_a_verdict_and_its_reason() {
    let all = format!("{CHAOS} --orbits 16 --crossings 1000");
    let document = bifdiag(&format!("{all} --json")).succeeds().json();
    let verdicts = |document: &Value| -> Vec<String> {
        let orbits = document["orbits"].as_array().unwrap();
        orbits.iter().map(|orbit| orbit["verdict"].as_str().unwrap().to_owned()).collect()
    };
    let found = verdicts(&document);
    assert!(found.iter().all(|verdict| ["regular", "chaotic", "open"].contains(&verdict.as_str())));
    // Starts of the two components take turns.
    assert!((0..16).step_by(2).all(|k| found[k] == "regular"), "{found:?}");
    assert!((1..16).step_by(2).any(|k| found[k] == "chaotic"), "{found:?}");
    for orbit in document["orbits"].as_array().unwrap() {
        assert!(orbit["reason"].as_str().unwrap().len() > 20);
        assert_eq!(orbit["verdict"] == "open", orbit["decided"].is_null());
    }
    let told = bifdiag(&format!("{all} --no-plot --out o")).inside(tempfile::tempdir().unwrap().path()).succeeds();
    told.printing("verdict").printing("chaotic is not unstable");

    let early = bifdiag(&format!("{all} --verdict early --json")).succeeds().json();
    assert!(early["command"].as_str().unwrap().contains("--verdict early"));
    let ended =
        |k: usize| early["orbits"][k]["end"] == "decided" && early["orbits"][k]["crossings"].as_u64() < Some(1000);
    assert!((0..16).any(ended));
    let unasked = bifdiag(&format!("{all} --verdict none --json")).succeeds().json();
    assert!(verdicts(&unasked).iter().all(|verdict| verdict == "open"));
    assert_eq!(unasked["orbits"][0]["reason"], "it was not asked for");
    bifdiag(&format!("{all} --verdict none --color rotation")).refused().telling("--color rotation");
}

/// Kovalevskaya's top is integrable.
#[test]
fn no_region_of_kovalevskayas_top_has_a_chaotic_orbit() {
    let line = "section --body kovalevskaya --region all --orbits 24 --crossings 3000 --json";
    let document = bifdiag(line).succeeds().json();
    let sections = document["sections"].as_array().unwrap();
    assert_eq!((sections.len(), &document["skipped"]), (4, &json!([])));
    let (mut regular, mut all) = (0, 0);
    for section in sections {
        for orbit in section["orbits"].as_array().unwrap() {
            assert_ne!(orbit["verdict"], "chaotic", "{}: {orbit}", section["region"]);
            regular += usize::from(orbit["verdict"] == "regular");
            all += 1;
        }
    }
    assert!(5 * regular > 4 * all, "{regular} of {all}");
}

#[test]
fn an_atlas_gives_body_and_samples() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("--body paper --no-plot --out .").inside(place.path()).succeeds();
    let all = bifdiag("section --atlas atlas.json --orbits 4 --crossings 5 --json --data s.npz").inside(place.path());
    let all = all.succeeds().json();
    let signatures: Vec<&str> =
        all["sections"].as_array().unwrap().iter().map(|section| section["signature"].as_str().unwrap()).collect();
    assert_eq!(signatures, ["S2", "T2", "M2", "T2", "S2+T2", "M2", "M3", "T2+T2", "S2+S2"]);
    assert_eq!((&all["complete"], &all["skipped"]), (&json!(true), &json!([])));
    assert_eq!(meta(&place.path().join("s-R7.npz")), all["sections"][6]);
    let one = bifdiag("section --atlas - --region R7 --orbits 4 --crossings 5 --json --no-plot");
    let atlas = fs::read_to_string(place.path().join("atlas.json")).unwrap();
    assert_eq!(one.reading(atlas).succeeds().json()["sections"][0], all["sections"][6]);
    bifdiag("section --atlas atlas.json --region R2 --out o --crossings 5").inside(place.path()).succeeds();
    assert_eq!(names(&place.path().join("o")), ["section-R2.json", "section-R2.npz", "section-R2.svg"]);
}

#[test]
fn an_atlas_without_weight_has_no_sections() {
    let atlas = bifdiag("--body euler --json").succeeds().stdout();
    bifdiag("section --atlas - --json").reading(atlas).refused().telling("r = 0").printing_nothing();
}

#[test]
fn a_regular_precession_is_recognised() {
    let place = tempfile::tempdir().unwrap();
    // Lagrange's top A = (1, 1, 0.6), r = e3, with cos ϑ = 0.8, l3 = 1: Ω = (1 + √4.2)/1.6, h and l to the last digit.
    let precession = (1.0 + 4.2_f64.sqrt()) / 1.6;
    let l = 0.6 * 0.6 * precession + 0.8;
    let h = 0.5 * (0.36 * precession * precession + 1.0 / 0.6) - 0.8;
    let theta = libm::atan2(0.6, 0.8);
    let mut found = 0;
    for sheet in ["+", "-"] {
        fs::write(place.path().join("seed.csv"), format!("theta,psi,sheet\n{theta:?},1,{sheet}\n")).unwrap();
        let line = format!("section --A 1,1,0.6 --r 0,0,1 --h {h:?} --l {l:?} --starts seed.csv --no-plot");
        let document = bifdiag(&format!("{line} --json --crossings 10")).inside(place.path()).succeeds().json();
        if document["orbits"][0]["end"] == "stays-on-section" {
            found += 1;
            assert_eq!(document["summary"]["stay_on_section"], 1);
            assert!(document["notes"][0].as_str().unwrap().contains("regular precession"), "{document}");
            bifdiag(&line).inside(place.path()).succeeds().printing("stays on S = 0").printing("note: orbit 0: S = 0");
        }
    }
    assert_eq!(found, 1, "one of the two sheets has this precession");
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
        ("jsonl", "only", "--integrator rk4"),
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
        for field in ["verdict", "reason", "decided"] {
            assert_eq!(one[field], other[field]);
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
    bifdiag(&line.replace("300", "301")).inside(place.path()).refused().telling("another section");
    assert_eq!(fs::read(file("s.npz.partial")).unwrap(), journal);
    fs::remove_file(file("s.npz.partial")).unwrap();
}
