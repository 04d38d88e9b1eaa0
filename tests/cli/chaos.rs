//! `bifdiag chaos`: shares at a point, and maps that are cut, joined and taken up again.

use serde_json::Value;

use crate::builder::{PROGRAM, bifdiag, plain};

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
    bifdiag("chaos --body paper --h -3 --l 1").refused().telling("the lowest energy at l = 1 is -0.8463380454231034");
    bifdiag("chaos --body kovalevskaya --h 1 --l 0").refused().telling("(1, 0) lies on the curve L-.1");
    bifdiag("chaos --body paper --h 5").refused().telling("--l is missing");
    bifdiag(&format!("{POINT} --error 0")).refused().telling("a standard deviation from");
    bifdiag(&format!("{POINT} --out map.npz")).refused().telling("--h applies to one point");
    bifdiag("chaos --body paper --window 5:6,1:2 --out map.txt").refused().telling("FILE.npz");
    bifdiag("chaos --body paper --window 5:6,1:2 --cells 0x3 --out map.npz").refused().telling("NxM");
    bifdiag("chaos --body paper --window 5:6,1:2").refused().telling("--out is missing");
}

/// Over the curves of the paper's body, between which regions of one and of two components lie.
const MAP: &str = "chaos --body paper --window 3.2:4.2,2.9:3.5 --cells 11x9 --error 0.3 --steps 320 -q";

#[test]
fn a_map_is_the_same_in_one_piece_in_shards_and_on_any_number_of_threads() {
    let place = tempfile::tempdir().unwrap();
    let run = |line: &str| bifdiag(line).inside(place.path()).succeeds();
    let read = |name: &str| std::fs::read(place.path().join(name)).unwrap();
    run(&format!("{MAP} --threads 1 --out whole.json"));
    run(&format!("{MAP} --threads 2 --out whole.npz"));
    for part in 1..=3 {
        run(&format!("{MAP} --shard {part}/3 --out part-{part}.json"));
    }
    run("chaos merge part-2.json part-3.json part-1.json --out joined.json");
    run("chaos merge part-2.json part-3.json part-1.json --out joined.npz");
    assert!(read("whole.json") == read("joined.json"));
    assert!(read("whole.npz") == read("joined.npz"));
    let merge = |parts: &str| bifdiag(&format!("chaos merge {parts} --out x.json")).inside(place.path()).refused();
    merge("part-1.json part-3.json").telling("tile 1 is missing");
    merge("part-1.json part-1.json part-2.json part-3.json").telling("twice");
    merge("whole.npz").telling("name the .json file");
    run("chaos map joined.json --out .");
    let picture = plain(&String::from_utf8(read("chaos.svg")).unwrap());
    for text in [">chaotic share<", ">R5<", "without a verdict", ">component 1 of E, in R5, R8<"] {
        assert!(picture.contains(text), "{text}");
    }
    run("chaos map joined.json --width 86mm --out column");
    assert!(String::from_utf8(read("column/chaos.svg")).unwrap().contains("width=\"86mm\""));
    bifdiag("chaos map whole.npz").inside(place.path()).refused().telling("name the .json file");
    // Each cell has a row for each component of each region in it.
    let map: Value = serde_json::from_slice(&read("whole.json")).unwrap();
    let rows = map["rows"].as_array().unwrap();
    let parts = |i: u64, j: u64| -> Vec<(String, u64, f64)> {
        let here = rows.iter().filter(|row| row["cell"] == serde_json::json!([i, j]));
        here.map(|row| {
            let region = row["region"].as_str().unwrap().to_owned();
            (region, row["component"].as_u64().unwrap(), row["part"].as_f64().unwrap())
        })
        .collect()
    };
    let (mut mixed, mut several) = (0, 0);
    for i in 0..11 {
        for j in 0..9 {
            let parts = parts(i, j);
            let whole: f64 = parts.iter().filter(|(_, component, _)| *component == 0).map(|(.., part)| part).sum();
            assert!(whole <= 1.0 + 1e-12 && whole > 0.8, "({i}, {j}): {parts:?}");
            mixed += u32::from(parts.iter().any(|(region, ..)| *region != parts[0].0));
            several += u32::from(parts.iter().any(|(_, component, _)| *component > 0));
        }
    }
    assert!(mixed > 3 && several > 3, "{mixed} {several}");
}

#[test]
fn a_map_goes_on_where_it_was() {
    let place = tempfile::tempdir().unwrap();
    let run = |line: &str| bifdiag(line).inside(place.path()).succeeds();
    let line = "chaos --body paper --window 3.2:4.2,2.9:3.5 --cells 40x49 --error 0.3 --steps 320";
    run(&format!("{line} -q --out whole.csv"));
    // What a killed run leaves: the journal as far as it came, cut in the middle of a block.
    let partial = place.path().join("cut.csv.partial");
    let journal = half_of_a_journal(place.path(), line);
    std::fs::write(&partial, journal).unwrap();
    let reply = run(&format!("{line} --out cut.csv")).stderr();
    assert!(reply.contains("resuming after"), "{reply}");
    assert_eq!(
        std::fs::read(place.path().join("cut.csv")).unwrap(),
        std::fs::read(place.path().join("whole.csv")).unwrap()
    );
    assert!(!partial.exists());
    std::fs::write(&partial, "{\"another\": 1}\n").unwrap();
    bifdiag(&format!("{line} --out cut.csv")).inside(place.path()).refused().telling("another unfinished map");
}

/// The beginning of the journal of a run that is killed, cut in the middle of its second block.
fn half_of_a_journal(directory: &std::path::Path, line: &str) -> Vec<u8> {
    let journal = directory.join("stopped.csv.partial");
    for _ in 0..20 {
        let mut child = std::process::Command::new(PROGRAM)
            .args(line.split(' '))
            .args(["-q", "--threads", "1", "--out", "stopped.csv"])
            .current_dir(directory)
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let mut bytes = Vec::new();
        while !holds_two_blocks(&bytes) && child.try_wait().unwrap().is_none() {
            bytes = std::fs::read(&journal).unwrap_or_default();
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        let _ended = child.kill();
        child.wait().unwrap();
        if holds_two_blocks(&bytes) {
            return bytes[..bytes.len() - 500].to_vec();
        }
    }
    panic!("it was over before it could be stopped");
}

/// The first block of a journal, and most of the second: a line, then each block as its length, its bytes and a checksum.
fn holds_two_blocks(journal: &[u8]) -> bool {
    let Some(end) = journal.iter().position(|byte| *byte == b'\n') else { return false };
    let Some(length) = journal[end + 1..].first_chunk::<8>() else { return false };
    let first = end + 1 + 8 + usize::try_from(u64::from_le_bytes(*length)).unwrap() + 32;
    journal.len() > first + 1000
}

/// The events of this body, beside Kovalevskaya's, lie at momenta of hundreds: its curves are no chords between them.
#[test]
fn curves_bend_in_the_window_of_a_map() {
    let place = tempfile::tempdir().unwrap();
    let window = "--window=-2:12,0:6 --cells 2x2 --error 0.3 --steps 320";
    let body = "--A 2,1.991,1 --r 0.999487,0,0.0061623";
    bifdiag(&format!("chaos {body} {window} --out m.json -q")).inside(place.path()).succeeds();
    bifdiag("chaos map m.json --out .").inside(place.path()).succeeds();
    let picture = std::fs::read_to_string(place.path().join("chaos.svg")).unwrap();
    let lines = picture.split("<path").filter(|path| path.contains("fill=\"none\"") && path.contains(" d=\""));
    let corners = |path: &str| {
        let data = path.split(" d=\"").nth(1).unwrap().split('"').next().unwrap();
        data.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '-').filter(|number| !number.is_empty()).count()
            / 2
    };
    // Each is drawn twice, once as its own border.
    let bent = lines.map(corners).filter(|corners| *corners > 20).count();
    assert!(bent >= 6, "{bent} lines have more than 20 points");
}

/// A pitchfork lies exactly at a cusp of this body: its diagram is not proved, its orbits are followed.
#[test]
fn a_body_without_an_atlas_has_shares() {
    let body = "--A 58,73,88 --r 2,0,1";
    bifdiag(&format!("atlas {body} --json")).fails();
    let found = bifdiag(&format!("chaos {body} --h 30 --l 3 --error 0.3 --json")).succeeds().json();
    let components = found["components"].as_array().unwrap();
    assert!(found.get("region").is_none() && !components.is_empty(), "{found}");
}
