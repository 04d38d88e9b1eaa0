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
    bifdiag("periodic family --A 5,4,3 --r 0,0,1 --from L-.1 --l 0").succeeds().printing("no family begins here");
    let document = bifdiag("periodic family --body paper --from G2.1 --h 1 --members 20 --json").succeeds().json();
    for family in list(&document["families"]) {
        assert!((number(&family["h"]) - 1.0).abs() < 1e-12, "{family}");
        assert!(list(&family["members"]).iter().all(|orbit| (number(&orbit["h"]) - 1.0).abs() < 1e-12));
        assert!(list(&family["members"]).len() == 20 || family["end"]["kind"] != json!("members"));
    }
    assert_eq!((&document["fixed_h"], &document["fixed_l"]), (&json!("1"), &Value::Null));
}

#[test]
fn families_are_drawn_and_reported() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("periodic family --body paper --from G2.1 --l 1.5 --members 30 --out pictures")
        .inside(place.path())
        .succeeds()
        .printing("from G2.1 at h = ")
        .printing("elliptic")
        .printing("periodic.svg");
    let picture = std::fs::read_to_string(place.path().join("pictures/periodic.svg")).unwrap();
    assert!(picture.contains("G2.1") && picture.contains(">period <"));
    assert!(picture.contains(" = (2, 1.1, 1)") && picture.contains(" = 1.5") && picture.contains("equilibrium"));
}

/// Near this equilibrium S is of fourth order in the size of the orbits, which cross P all the same.
#[test]
fn small_orbits_cross_the_section_as_often_as_their_neighbours() {
    let found = bifdiag("periodic family --A 2,3,4 --r 0,0,1 --from L+.1 --h 0 --members 10 --json").succeeds().json();
    let members = list(&found["families"][1]["members"]);
    let crossings: Vec<u64> = members.iter().map(|orbit| orbit["crossings"].as_u64().unwrap()).collect();
    assert_eq!(crossings[3..], [8; 7], "{crossings:?}");
}

/// Exactly at a pitchfork the other pair is zero; no circle of equilibria is near.
#[test]
fn no_family_begins_at_a_pitchfork_because_a_pair_is_zero() {
    for line in ["--A 4,5,6 --r 0,1,0 --from L+.1 --l 5", "--A 2,3,4 --r 0,0,1 --from L-.3 --l 4"] {
        let reply = bifdiag(&format!("periodic family {line} --members 4")).succeeds();
        reply.printing("not begun: the other pair is a multiple of this one, or zero");
    }
}

/// The two equilibria of a mirror pair have the same h, l and frequencies: titles say on which side each lies.
#[test]
fn titles_tell_families_of_a_mirror_pair_apart() {
    let text = bifdiag("periodic family --body paper --l 3.1 --members 3").succeeds().stdout();
    let titles: Vec<&str> = text.lines().filter(|line| line.starts_with("from ")).collect();
    let different: std::collections::BTreeSet<&str> = titles.iter().copied().collect();
    assert_eq!((titles.len(), different.len()), (10, 10), "{titles:?}");
    assert_eq!(["γ2 > 0", "γ2 < 0"].map(|side| titles.iter().filter(|title| title.contains(side)).count()), [1, 1]);
}

/// Every family that `periodic family` follows is in the list, orbit by orbit, and filters leave out what they say.
#[test]
fn a_list_holds_all_families_and_filters_their_orbits() {
    let family = bifdiag("periodic family --body paper --l 2.3 --members 30 --json").succeeds().json();
    let all = bifdiag("periodic list --body paper --l 2.3 --members 30 --json").succeeds().json();
    assert_eq!(list(&all["families"]).len(), list(&family["families"]).len());
    for (listed, family) in list(&all["families"]).iter().zip(list(&family["families"])) {
        assert_eq!((&listed["frequency"], &listed["gamma"]), (&family["frequency"], &family["gamma"]));
        assert_eq!(listed["followed"], json!(list(&family["members"]).len()));
        for (number, (orbit, member)) in list(&listed["orbits"]).iter().zip(list(&family["members"])).enumerate() {
            assert_eq!((&orbit["member"], &orbit["period"]), (&json!(number), &member["period"]));
            assert_eq!(orbit["proved"], json!(false));
        }
    }
    let some = bifdiag("periodic list --body paper --l 2.3 --members 30 --stable --period 3:8 --crossings 2 --json");
    let some = some.succeeds().json();
    let is_wanted = |orbit: &&Value| {
        let period = number(&orbit["period"]);
        orbit["stability"] == json!("elliptic") && (3.0..=8.0).contains(&period) && number(&orbit["crossings"]) <= 2.0
    };
    let mut count = [0, 0];
    for (all, some) in list(&all["families"]).iter().zip(list(&some["families"])) {
        let wanted: Vec<&Value> = list(&all["orbits"]).iter().filter(is_wanted).collect();
        assert_eq!(wanted, list(&some["orbits"]).iter().collect::<Vec<_>>());
        count = [count[0] + wanted.len(), count[1] + list(&all["orbits"]).len()];
    }
    assert!(20 < count[0] && count[0] < count[1], "{count:?}");
    let one = bifdiag("periodic list --body paper --l 2.3 --members 30 --family g1.3/2 --json").succeeds().json();
    assert_eq!(list(&one["families"]).len(), 1);
    let same = list(&all["families"]).iter().find(|family| family["family"] == json!("G1.3/2"));
    assert_eq!(Some(&one["families"][0]), same);
}

/// A list says what it does not hold, and `verify` takes none.
#[test]
fn a_list_says_what_is_not_checked() {
    let place = tempfile::tempdir().unwrap();
    let list = bifdiag("periodic list --body paper --l 1.5 --members 20 --json").succeeds();
    let document = list.json();
    assert_eq!(document["complete"], json!(false));
    let why = document["why"].as_str().unwrap();
    assert!(why.starts_with("2 families go on") && why.contains("`bifdiag verify` does not check"), "{why}");
    std::fs::write(place.path().join("list.json"), list.stdout()).unwrap();
    bifdiag("verify list.json").inside(place.path()).refused().telling("neither an atlas nor the proof of a point");
    // An energy that is held is reported as it was asked for, not as the doubles of an orbit have it.
    let held = bifdiag("periodic list --body paper --h -0.5:0:2 --members 2").succeeds().stdout();
    let column = |name: &str, number: usize| -> Vec<&str> {
        let rows = held.lines().skip_while(|line| !line.starts_with(name)).skip(1).take_while(|line| !line.is_empty());
        rows.map(|row| row.split_whitespace().nth(number).unwrap_or_default()).collect()
    };
    assert_eq!(column("h ", 0), ["-0.5", "-0.5", "0", "0"], "{held}");
    assert_eq!(column("family", 2), ["-0.5", "-0.5", "-0.5", "-0.5", "0", "0", "0", "0"], "{held}");
    // At rest both families of the paper's body end, at one separatrix.
    let ended = bifdiag("periodic list --body paper --l 0 --json").succeeds().json();
    assert_eq!(ended["complete"], json!(true), "{}", ended["why"]);
    assert!(ended["why"].as_str().unwrap().starts_with("every family was followed to its end"));
}

/// Without l and h: at rest, and at a momentum between any two at which `atlas` tells that curves begin or end.
#[test]
fn a_list_without_a_place_has_every_kind_of_momentum() {
    let document = bifdiag("periodic list --body paper --members 2 --json").succeeds().json();
    let momenta: Vec<f64> =
        list(&document["fixed_l"]).iter().map(|text| text.as_str().unwrap().parse().unwrap()).collect();
    assert_eq!(momenta[0], 0.0);
    assert!(momenta.is_sorted());
    let atlas = bifdiag("--body paper --json").succeeds().json();
    let mut events: Vec<f64> = list(&atlas["events"])
        .iter()
        .filter(|event| event["kind"] == json!("cusp") || event["kind"] == json!("pitchfork"))
        .map(|event| number(&event["l"]))
        .collect();
    events.sort_by(f64::total_cmp);
    assert!(events.len() >= 2, "{events:?}");
    for pair in events.windows(2) {
        assert!(momenta.iter().any(|l| pair[0] < *l && *l < pair[1]), "{pair:?} {momenta:?}");
    }
    assert!(momenta.last() > events.last());
    for family in list(&document["families"]) {
        assert!(momenta.iter().any(|l| (l - number(&family["l"])).abs() < 1e-12), "{family}");
    }
}

/// Tables have the orbits of the document, and a stopped list goes on to the same bytes.
#[test]
fn a_list_is_written_as_a_table_and_goes_on_where_it_was() {
    let place = tempfile::tempdir().unwrap();
    let line = "periodic list --body paper --l 0.5:2.5:9 --members 25 --branches --stable";
    let read = |name: &str| std::fs::read(place.path().join(name)).unwrap();
    let document = bifdiag(&format!("{line} --json --data whole.csv")).inside(place.path()).succeeds().json();
    let rows: usize = list(&document["families"]).iter().map(|family| list(&family["orbits"]).len()).sum();
    let table = String::from_utf8(read("whole.csv")).unwrap();
    assert_eq!(table.lines().count(), rows + 1);
    assert!(table.starts_with("family,branch,member,h,l,gamma1,gamma2,gamma3,omega1,"));
    let first = table.lines().nth(1).unwrap();
    let orbit = &document["families"][0]["orbits"][0];
    assert!(first.starts_with(&format!("G2.1/1,0,0,{:?},0.5,", number(&orbit["h"]))), "{first}");
    assert!(first.contains(&format!(",{:?},", number(&orbit["period"]))) && first.contains(",elliptic,"), "{first}");
    assert!(!place.path().join("whole.csv.partial").exists());
    let streamed = bifdiag(&format!("{line} --data -")).succeeds().stdout();
    assert_eq!(streamed, table);
    // What a killed run leaves: the journal as far as it came, cut in the middle of a block.
    let partial = place.path().join("cut.csv.partial");
    let mut child = std::process::Command::new(crate::builder::PROGRAM)
        .args(line.split(' '))
        .args(["-q", "--threads", "1", "--data", "cut.csv"])
        .current_dir(place.path())
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let mut bytes = Vec::new();
    while bytes.len() < 60_000 && child.try_wait().unwrap().is_none() {
        bytes = std::fs::read(&partial).unwrap_or_default();
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let _ended = child.kill();
    child.wait().unwrap();
    assert!(bytes.len() >= 60_000, "it was over before it could be stopped");
    std::fs::write(&partial, &bytes[..bytes.len() - 300]).unwrap();
    let reply = bifdiag(&format!("{line} --data cut.csv")).inside(place.path()).succeeds().stderr();
    assert!(reply.contains("resuming after"), "{reply}");
    assert!(read("cut.csv") == read("whole.csv") && !partial.exists());
    std::fs::write(&partial, "{\"another\": 1}\n").unwrap();
    bifdiag(&format!("{line} --data cut.csv")).inside(place.path()).refused().telling("another unfinished list");
    bifdiag(&format!("{line} --data cut.csv --restart")).inside(place.path()).succeeds();
    assert!(read("cut.csv") == read("whole.csv"));
}

#[test]
fn wrong_questions_of_lists_say_what_is_right() {
    for (line, reply) in [
        ("--l 1 --family G7.1", "the body has no such curve of steady rotations; it has G0.1, G1.1,"),
        ("--l 1 --family G2.1/3", "an equilibrium has at most two, such as G2.1/1 and G2.1/2"),
        ("--l 1 --period 5:2", "A = 5 is above B = 2"),
        ("--l 1 --period 5", "periods are written A:B"),
        ("--l 1 --members 0", "a family has at least one orbit"),
        ("--l 1:2", "a range is written a:b:n"),
        ("--l 1 --json --data -", "both write to stdout"),
        ("--l 1 --data orbits.txt", "the extension selects the format"),
        ("--l 1 --restart", "--data"),
        ("--l 1 --h 2", "--h"),
    ] {
        bifdiag(&format!("periodic list --body paper {line}")).refused().telling(reply);
    }
}

/// Columns of words and numbers, read back.
#[cfg(feature = "parquet")]
#[test]
fn a_list_is_written_as_parquet() {
    use parquet::file::reader::SerializedFileReader;
    let place = tempfile::tempdir().unwrap();
    bifdiag("periodic list --body paper --l 1.5 --members 30 --data orbits.parquet").inside(place.path()).succeeds();
    let reader = SerializedFileReader::new(std::fs::File::open(place.path().join("orbits.parquet")).unwrap()).unwrap();
    let fields: Vec<_> = reader.into_iter().map(|row| row.unwrap().into_columns()).collect();
    assert_eq!(fields.len(), 60);
    assert_eq!((fields[0][0].0.as_str(), fields[0][0].1.to_string().as_str()), ("family", "\"G2.1/1\""));
    assert_eq!(fields[59][0].1.to_string(), "\"G2.1/2\"");
}

/// Columns of l and T hold the ends of what all orbits have, not those of the first and the last one.
#[test]
fn a_list_shows_the_ranges_of_its_families() {
    let line = "periodic list --A 5,4,3 --r 0,0,1 --h 1 --family S2.1";
    let document = bifdiag(&format!("{line} --json")).succeeds().json();
    let l: Vec<f64> = list(&list(&document["families"])[0]["orbits"]).iter().map(|orbit| number(&orbit["l"])).collect();
    let [least, most] = [f64::min, f64::max].map(|of| l.iter().copied().reduce(of).unwrap());
    // It begins and ends at one equilibrium.
    assert!((l[0] - l[l.len() - 1]).abs() < 1e-3 && most - least > 4.0, "{least} {most}");
    bifdiag(line).succeeds().printing(&format!("{least:.3} … {most:.3}"));
}

/// Why no family begins: which of the two reasons it is.
#[test]
fn a_family_that_does_not_begin_says_why() {
    let text = bifdiag("periodic family --A 1,1,2 --r 0,0,0 --l 1").succeeds().stdout();
    let reasons: Vec<&str> =
        text.lines().filter_map(|line| line.split_once("not begun: ")).map(|found| found.1).collect();
    let multiple = "the other pair is a multiple of this one, or zero";
    assert_eq!(
        reasons,
        [multiple, multiple, multiple, multiple, "the equilibrium is one of a circle or sphere of them"]
    );
}

/// The pair of axes S2 has left G1.1, 0.004 away, whose small orbits are stable.
#[test]
fn a_family_beside_a_pitchfork_begins_at_its_own_equilibrium() {
    let found = bifdiag("periodic family --body paper --from S2.1 --l 2.57145 --members 3 --json").succeeds().json();
    let members = found["families"][0]["members"].as_array().unwrap();
    assert!(!members.is_empty());
    for member in members {
        assert_eq!((&member["symmetric"], &member["stability"]), (&false.into(), &"hyperbolic".into()), "{member}");
    }
}
