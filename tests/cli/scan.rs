//! Scans: the same bytes whole, in shards, broken off and taken up again; and what is refused.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use serde_json::Value;
use tempfile::tempdir;

use crate::builder::{PROGRAM, bifdiag};

const GENERAL: &str = "scan --family general --samples 300 --seed 4";

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&read(path)).unwrap()
}

#[test]
fn a_scan_writes_rows_and_a_summary_and_the_same_again() {
    let place = tempdir().unwrap();
    for format in ["csv", "jsonl", "parquet"] {
        let out = format!("a.{format}");
        bifdiag(&format!("{GENERAL} --out {out}"))
            .inside(place.path())
            .succeeds()
            .telling_nothing()
            .printing("300 bodies");
        let first = [&out, &format!("{out}.summary.json")].map(|name| read(&place.path().join(name)));
        bifdiag(&format!("{GENERAL} --out {out} --threads 1")).inside(place.path()).succeeds();
        let second = [&out, &format!("{out}.summary.json")].map(|name| read(&place.path().join(name)));
        assert!(first == second, "{format}");
    }
    let summary = json(&place.path().join("a.csv.summary.json"));
    assert_eq!((&summary["rows"], &summary["classified"]), (&Value::from(300), &Value::from(300)));
    let counted: u64 = summary["classes"].as_array().unwrap().iter().map(|c| c["bodies"].as_u64().unwrap()).sum();
    assert_eq!(counted, 300);
    let parquet = json(&place.path().join("a.parquet.summary.json"));
    assert_eq!(parquet["classes"], summary["classes"]);
    let mut left: Vec<String> = fs::read_dir(place.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| name.contains("partial") || name.contains("new"))
        .collect();
    left.sort();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn rows_on_stdout_are_those_of_the_file() {
    let place = tempdir().unwrap();
    for format in ["csv", "jsonl"] {
        bifdiag(&format!("{GENERAL} --out a.{format}")).inside(place.path()).succeeds();
        let printed = bifdiag(&format!("{GENERAL} --format {format} --out -")).succeeds().stdout();
        assert_eq!(printed.into_bytes(), read(&place.path().join(format!("a.{format}"))), "{format}");
    }
}

#[test]
fn katok_bodies_of_a_grid_have_seven_classes() {
    let place = tempdir().unwrap();
    let grid = "scan --family katok --vary A2=0.3025:1.6925:30,A3=0.3075:1.6975:30 --out katok.parquet --json";
    let summary = bifdiag(grid).inside(place.path()).succeeds().json();
    assert_eq!((summary["rows"].as_u64(), summary["classes"].as_array().unwrap().len()), (Some(900), 7));
    assert_eq!(summary["undecided"], 0);
    bifdiag("scan map katok.parquet --x A2 --y A3 --out maps --format svg,png").inside(place.path()).succeeds();
    let svg = fs::read_to_string(place.path().join("maps/map.svg")).unwrap();
    assert!(svg.contains("7 classes") && svg.contains("katok:5"));
    // Numbers in place of names, which the caption has; bodies that cannot exist are hatched and not counted.
    let class = summary["classes"][0]["class"].as_str().unwrap();
    assert!(!svg.contains(&format!(">{class}<")) && svg.contains("id=\"impossible\""), "{class}");
    assert!(svg.contains("that can exist (") && svg.contains("no body exists: a moment exceeds"));
    let key = fs::read_to_string(place.path().join("maps/map.caption.txt")).unwrap();
    assert_eq!(key.lines().filter(|line| line.contains("katok:")).count(), 7, "{key}");
    for show in ["regions", "critical-points"] {
        bifdiag(&format!("scan map katok.parquet --x A2 --y A3 --show {show}")).inside(place.path()).succeeds();
    }
}

#[test]
fn a_map_of_many_classes_shows_the_largest_and_lists_all() {
    let place = tempdir().unwrap();
    let scan = "scan --body paper --vary A2=0.72:1.2:16,r3=0.02:0.14:16 --out near.parquet";
    bifdiag(scan).inside(place.path()).succeeds();
    bifdiag("scan map near.parquet --x A2 --y r3 --out maps").inside(place.path()).succeeds();
    let svg = fs::read_to_string(place.path().join("maps/map.svg")).unwrap();
    let key = fs::read_to_string(place.path().join("maps/map.caption.txt")).unwrap();
    let classes = key.lines().count() - 2;
    assert!(classes > 30, "{classes} classes");
    assert!(svg.contains(&format!("{} smaller class", classes - 30)), "of {classes}");
    assert!(
        svg.contains(&format!("{classes} classes"))
            && svg.contains("id=\"area-30\"")
            && !svg.contains("id=\"area-31\"")
    );
}

/// What the bodies of a scan show on the edge of a map has no area there, and what lies between them has.
#[test]
fn shares_of_a_map_are_those_of_the_area_that_is_painted() {
    let place = tempdir().unwrap();
    bifdiag("scan --body paper --vary A2=1:1.9:4,r2=0:0.5:3 --out few.csv").inside(place.path()).succeeds();
    bifdiag("scan map few.csv --x A2 --y r2 --out maps").inside(place.path()).succeeds();
    let key = fs::read_to_string(place.path().join("maps/map.caption.txt")).unwrap();
    assert!(key.lines().nth(1).is_some_and(|heading| heading.contains("share of the area")), "{key}");
    let share = |class: &str| key.lines().find(|line| line.contains(class)).map(|row| row.contains("below 0.1%"));
    // How many regions each class has, also where none of the bodies has it.
    let regions = key.lines().find(|line| line.contains("4ba1a9867682")).and_then(|row| row.split_whitespace().nth(2));
    assert_eq!(regions, Some("10"), "{key}");
    // None of the bodies has the first, two on the edge the second; those with the third cannot exist.
    let shares = ["4ba1a9867682", "b08c7fbbe74e", "bddb4c712713"].map(share);
    assert_eq!(shares, [Some(false), Some(true), None], "{key}");
}

/// Of 102 damaged files five were drawn: none of them may be.
#[test]
fn a_map_of_altered_rows_is_refused() {
    let place = tempdir().unwrap();
    bifdiag("scan --family katok --vary A2=0.4:1.6:4,A3=0.4:1.6:4 --out a.csv").inside(place.path()).succeeds();
    let map = || bifdiag("scan map a.csv --x A2 --y A3").inside(place.path());
    map().succeeds().telling_nothing();
    let whole = fs::read_to_string(place.path().join("a.csv")).unwrap();
    // The last body again in the place of the one before.
    let lines: Vec<&str> = whole.lines().collect();
    let (rest, last) = (lines[..lines.len() - 2].join("\n"), lines[lines.len() - 1]);
    fs::write(place.path().join("a.csv"), format!("{rest}\n{last}\n{last}\n")).unwrap();
    map().refused().telling("a.csv does not match its summary");
    fs::remove_file(place.path().join("a.csv.summary.json")).unwrap();
    map().succeeds().telling("no summary beside it");
}

#[test]
fn a_body_that_fails_is_a_row_with_its_error() {
    let place = tempdir().unwrap();
    // A3 = 1e-80 leaves the range of f64.
    let line = "scan --A 1,1,1 --r 1,0,0 --vary A3=1e-80:1:3 --out a.jsonl --json";
    let summary = bifdiag(line).inside(place.path()).succeeds().json();
    assert_eq!((&summary["failed"], &summary["classified"]), (&Value::from(1), &Value::from(2)));
    let text = fs::read_to_string(place.path().join("a.jsonl")).unwrap();
    let first: Value = serde_json::from_str(text.lines().next().unwrap()).unwrap();
    assert_eq!(first["status"], "failed");
    assert!(first["error"].as_str().unwrap().contains("10^25") && first["class"].is_null());
}

fn shards(place: &Path, count: usize, ending: &str) -> Vec<PathBuf> {
    (1..=count)
        .map(|i| {
            let name = format!("shard-{i}.{ending}");
            bifdiag(&format!("{GENERAL} --shard {i}/{count} --out {name}")).inside(place).succeeds();
            PathBuf::from(name)
        })
        .collect()
}

fn merge(place: &Path, shards: &[PathBuf], out: &str) -> crate::builder::Run {
    let mut run = bifdiag(&format!("scan merge --out {out}")).inside(place);
    for shard in shards {
        run = run.and(shard);
    }
    run
}

#[test]
fn merged_shards_are_the_scan_in_one_piece() {
    for ending in ["csv", "parquet"] {
        let place = tempdir().unwrap();
        let mut parts = shards(place.path(), 7, ending);
        parts.reverse();
        let whole = format!("whole.{ending}");
        bifdiag(&format!("{GENERAL} --out {whole}")).inside(place.path()).succeeds();
        merge(place.path(), &parts, &format!("merged.{ending}")).succeeds();
        for end in ["", ".summary.json"] {
            let [one, other] =
                ["whole", "merged"].map(|name| read(&place.path().join(format!("{name}.{ending}{end}"))));
            assert!(one == other, "{ending}{end}");
        }
        // A shard of another format is no obstacle.
        merge(place.path(), &parts, "merged.jsonl").succeeds();
    }
}

#[test]
fn overlapping_missing_foreign_truncated_and_altered_shards_are_refused_by_name() {
    let place = tempdir().unwrap();
    let parts = shards(place.path(), 3, "csv");
    let run = |shards: &[PathBuf]| merge(place.path(), shards, "out.csv");
    run(&[]).refused().telling("merge needs shards");
    run(&parts[..2]).refused().telling("bodies 200 to 299 of 300, numbered from 0, are missing (after shard-2.csv)");
    run(&parts[1..]).refused().telling("bodies 0 to 99 of 300, numbered from 0, are missing (before shard-2.csv)");
    let gap = [parts[0].clone(), parts[2].clone()];
    run(&gap).refused().telling("bodies 100 to 199").telling("between shard-1.csv and shard-3.csv");
    let twice = [parts[0].clone(), parts[1].clone(), parts[1].clone(), parts[2].clone()];
    run(&twice).refused().telling("shard-2.csv overlaps shard-2.csv");
    bifdiag(&format!("{GENERAL} --shard 1/2 --out half.csv")).inside(place.path()).succeeds();
    run(&[PathBuf::from("half.csv"), parts[1].clone(), parts[2].clone()])
        .refused()
        .telling("shard-2.csv overlaps half.csv: both hold body 100");
    bifdiag("scan --family general --samples 300 --seed 5 --shard 3/3 --out foreign.csv")
        .inside(place.path())
        .succeeds();
    run(&[parts[0].clone(), parts[1].clone(), PathBuf::from("foreign.csv")])
        .refused()
        .telling("foreign.csv belongs to another scan than shard-1.csv")
        .telling("the choice of bodies");
    run(&[parts[0].clone(), PathBuf::from("nowhere.csv")]).refused().telling("nowhere.csv");
    merge(place.path(), &parts, "shard-1.csv").refused().telling("the output is one of the shards");
    let good = read(&place.path().join("shard-2.csv"));
    fs::write(place.path().join("shard-2.csv"), &good[..good.len() - 200]).unwrap();
    run(&parts).refused().telling("shard-2.csv does not match its summary").telling("truncated or altered");
    let mut altered = good.clone();
    let digit = altered.iter().rposition(|byte| *byte == b'1').unwrap();
    altered[digit] = b'2';
    fs::write(place.path().join("shard-2.csv"), &altered).unwrap();
    run(&parts).refused().telling("shard-2.csv does not match its summary");
    fs::write(place.path().join("shard-2.csv"), &good).unwrap();
    fs::remove_file(place.path().join("shard-2.csv.summary.json")).unwrap();
    run(&parts).refused().telling("shard-2.csv: its summary shard-2.csv.summary.json cannot be read");
    assert!(!place.path().join("out.csv").exists());
}

/// Twenty kills at moments that depend on nothing but a generator of numbers; the result is that of an unbroken scan.
#[test]
fn a_scan_killed_twenty_times_ends_with_the_same_bytes() {
    for ending in ["csv", "parquet"] {
        let place = tempdir().unwrap();
        let line = |name: &str| format!("scan --family general --samples 3000 --out {name}.{ending}");
        bifdiag(&line("whole")).inside(place.path()).succeeds();
        let mut state = 88_172_645_463_325_252_u64;
        let mut kills = 0;
        while kills < 20 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let mut child = Command::new(PROGRAM)
                .args(line("broken").split_whitespace())
                .current_dir(place.path())
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            sleep(Duration::from_millis(5 + state % 90));
            if child.try_wait().unwrap().is_some() {
                // It was done before: begin anew.
                for end in ["", ".summary.json"] {
                    fs::remove_file(place.path().join(format!("broken.{ending}{end}"))).unwrap();
                }
                continue;
            }
            child.kill().unwrap();
            child.wait().unwrap();
            kills += 1;
        }
        bifdiag(&line("broken")).inside(place.path()).succeeds();
        for end in ["", ".summary.json"] {
            let [one, other] =
                ["whole", "broken"].map(|name| read(&place.path().join(format!("{name}.{ending}{end}"))));
            assert!(one == other, "{ending}{end}");
        }
        assert!(!place.path().join(format!("broken.{ending}.partial")).exists());
    }
}

#[test]
fn the_beginning_of_another_scan_is_not_taken_up() {
    let place = tempdir().unwrap();
    let mut child = Command::new(PROGRAM)
        .args("scan --family general --samples 1000000 --out a.csv".split_whitespace())
        .current_dir(place.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let journal = place.path().join("a.csv.partial");
    while fs::metadata(&journal).map_or(0, |journal| journal.len()) < 1000 {
        sleep(Duration::from_millis(5));
    }
    bifdiag("scan --family general --samples 1000000 --out a.csv")
        .inside(place.path())
        .refused()
        .telling("another process");
    child.kill().unwrap();
    child.wait().unwrap();
    let other = "scan --family general --samples 20 --out a.csv";
    bifdiag(other)
        .inside(place.path())
        .refused()
        .telling("a.csv.partial belongs to another unfinished scan")
        .telling("--restart");
    bifdiag(&format!("{other} --restart")).inside(place.path()).succeeds().printing("20 bodies");
    assert!(!journal.exists());
}

#[test]
fn classes_are_the_same_at_both_levels() {
    let scan = |options: &str| bifdiag(&format!("scan {options} --out -")).succeeds().json_lines();
    for bodies in ["--family katok --samples 6", "--family general --samples 4"] {
        let (exact, fast) = (scan(bodies), scan(&format!("{bodies} --accuracy fast")));
        for (one, other) in exact.iter().zip(&fast) {
            assert_eq!(one["class"], other["class"], "{other}");
        }
        assert!(!exact[0]["class"].is_null());
    }
    let border = bifdiag("scan border --body katok:2 --vary A3=0.7:0.8 --accuracy fast --json").succeeds().json();
    assert!((border["borders"][0]["at"][0]["value"].as_f64().unwrap() - 0.75).abs() < 1e-12);
}

#[test]
fn a_shard_of_version_1_names_the_command_that_makes_it_anew() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("part.csv"), "").unwrap();
    let design = r#"{"bodies": {"family": "katok"}, "samples": 10, "seed": 5}"#;
    let old = format!(r#"{{"schema_version": "1", "accuracy": "standard", "range": [5, 10], "design": {design}}}"#);
    fs::write(folder.path().join("part.csv.summary.json"), old).unwrap();
    let wanted = "bifdiag scan --family katok --samples 10 --seed 5 --shard 2/2 --out part.csv";
    bifdiag("scan merge part.csv --out whole.csv").inside(folder.path()).refused().telling("version 1").telling(wanted);
}

#[test]
fn found_witnesses_are_what_they_say() {
    for (line, section) in [("--type M4", "M4"), ("--circles 2 --poles 1 --physical", "M2")] {
        let found = bifdiag(&format!("find {line} --json")).succeeds().json();
        assert_eq!(found["found"], true, "{line}");
        let list = |key: &str| {
            let numbers: Vec<&str> = found[key].as_array().unwrap().iter().map(|x| x.as_str().unwrap()).collect();
            numbers.join(",")
        };
        let (h, l) = (found["h"].as_str().unwrap(), found["l"].as_str().unwrap());
        let again = format!("classify --A {} --r {} --h {h} --l {l} --json", list("A"), list("r"));
        let point = bifdiag(&again).succeeds().json();
        assert_eq!(point["components"], found["components"], "{line}");
        let sections: Vec<&str> =
            found["components"].as_array().unwrap().iter().map(|c| c["section"].as_str().unwrap()).collect();
        assert!(sections.contains(&section), "{line}: {sections:?}");
    }
    // Theorem 11.1: three circles without a pole do not occur; that is an answer.
    let never = bifdiag("find --type k3n0 --json").succeeds().json();
    assert_eq!((&never["found"], &never["exists"]), (&Value::Bool(false), &Value::Bool(false)));
    assert!(never["why"].as_str().unwrap().contains("Theorem"), "{never}");
    // Known, or searched for.
    let tried =
        |options: &str| bifdiag(&format!("find --type M4 {options} --json")).succeeds().json()["tried"].as_u64();
    assert_eq!(tried(""), Some(0));
    assert!(tried("--search").is_some_and(|tried| tried > 0));
    bifdiag("find --critical-points 8 --samples 2048")
        .succeeds()
        .printing("equilibria are shown by")
        .printing("at h = ");
    bifdiag("find --signature M2+S2").succeeds().printing("S2+M2 is shown by");
    // No body that is drawn is a ball.
    let none = bifdiag("find --type k0n2 --samples 200 --moment-ratio 1").fails();
    none.printing("200 bodies drawn, but none of them was within the limits");
    let never = bifdiag("find --critical-points 15").succeeds();
    never.printing("at least 15 isolated relative equilibria do not exist for r ≠ 0: ").printing("Theorem 4.9");
}

#[test]
#[cfg(not(feature = "parquet"))]
fn without_parquet_the_feature_is_named() {
    bifdiag(&format!("{GENERAL} --out a.parquet")).refused().telling("feature `parquet`").telling(".csv");
}

/// Of three shards of one body two have none.
#[test]
fn an_empty_shard_has_no_classes() {
    let place = tempfile::tempdir().unwrap();
    let reply = |shard: u32| {
        let line = format!("scan --family general --samples 1 --shard {shard}/3 --out {shard}.csv");
        bifdiag(&line).inside(place.path()).succeeds().stdout()
    };
    let empty = "0 bodies: 0 classified, 0 undecided, 0 failed\nno class was found\n\nwritten: ";
    let all = [1, 2, 3].map(reply);
    assert_eq!(all.iter().filter(|reply| reply.starts_with(empty)).count(), 2, "{all:?}");
    assert_eq!(all.iter().filter(|reply| reply.contains("\n1 class, met once\n")).count(), 1, "{all:?}");
}

/// No body has A2 < 5: shares are of what is left, and where that is a single value there is no table.
#[test]
fn shares_of_events_are_of_the_range_in_which_bodies_exist() {
    let place = tempfile::tempdir().unwrap();
    let caption = |line: &str| {
        bifdiag(&format!("scan events {line} --out here")).inside(place.path()).succeeds();
        fs::read_to_string(place.path().join("here/events.caption.txt")).unwrap()
    };
    let cut = caption("--A 3,5,8 --r 0,1,0.5 --vary A2=3:8:30");
    assert!(cut.contains("share of the range in which bodies exist") && cut.contains("83.3%"), "{cut}");
    let none = caption("--A 3,4,8 --r 0,1,0 --vary A2=3.2:5:19");
    assert!(!none.contains("share"), "{none}");
    let empty = bifdiag("scan events --A 6,6,6 --r 1,0,0 --vary r2=0:2:20 --no-plot").succeeds();
    assert!(!empty.printing("no events").stdout().contains("from, to: values"));
}

/// The events of A = (2, A2, 1), r = (1, 0, 0): each momentum is that of the atlas of the body, and each stretch has one class.
#[test]
fn events_are_followed_from_border_to_border() {
    let place = tempfile::tempdir().unwrap();
    let line = "scan events --body kovalevskaya --vary A2=1:2.2:48";
    let text = bifdiag(&format!("{line} --data e.csv")).inside(place.path()).succeeds();
    text.printing("A = (2, A2, 1)")
        .printing("48 bodies; 3 borders or special bodies between them")
        .printing("A2 = 1.5: the cusp of S2 reaches its pitchfork\nA2 = 2: a pitchfork goes through infinity");
    // One of 49 bodies is beside A2 = 2, where a pitchfork has a momentum of 1e8: it is not drawn to there.
    bifdiag("scan events --body kovalevskaya --vary A2=1:2.2:49 --out far").inside(place.path()).succeeds();
    let rows = fs::read_to_string(place.path().join("e.csv")).unwrap();
    assert!(rows.starts_with("track,event,value,h,l\n"), "{rows}");
    let picture = fs::read_to_string(place.path().join("bifdiag-out/events.svg")).unwrap();
    assert!(picture.contains(">7 regions<") && !picture.contains(">0 regions<"));
    let document = bifdiag(&format!("{line} --json")).inside(place.path()).succeeds().json();
    let events = document["events"].as_array().unwrap();
    let mut seen = 0;
    // Where one class ends, so do its events.
    for body in [5, 20, 30, 44] {
        let value = 1.0 + 1.2 * f64::from(body) / 47.0;
        let atlas = bifdiag(&format!("--A 2,{value},1 --r 1,0,0 --json")).inside(place.path()).succeeds().json();
        let mut expected: Vec<f64> =
            atlas["events"].as_array().unwrap().iter().map(|e| e["l"].as_f64().unwrap()).collect();
        let mut found: Vec<f64> = Vec::new();
        for event in events {
            let [at, l] = ["at", "l"].map(|name| event[name].as_array().unwrap());
            let here = at.iter().position(|at| (at.as_f64().unwrap() - value).abs() < 1e-9);
            found.extend(here.map(|here| l[here].as_f64().unwrap()));
        }
        for list in [&mut expected, &mut found] {
            list.sort_by(f64::total_cmp);
        }
        assert_eq!(found.len(), expected.len(), "{value}: {found:?} {expected:?}");
        assert!(found.iter().zip(&expected).all(|(p, q)| (p - q).abs() < 1e-9 * q), "{value}: {found:?} {expected:?}");
        seen += found.len();
    }
    assert!(seen > 12);
}
