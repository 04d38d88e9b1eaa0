//! Every word that the program prints is explained by `bifdiag explain`, and so by the glossary of the documentation.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use bifdiag::schema::Stability;
use serde_json::Value;

use crate::builder::{PROGRAM, bifdiag};

/// The texts that stand in a schema as the values of a field.
fn constants(schema: &Value, found: &mut BTreeSet<String>) {
    if let Some(constant) = schema.get("const").and_then(Value::as_str) {
        found.insert(constant.to_owned());
    }
    if let Some(Value::Array(values)) = schema.get("enum") {
        found.extend(values.iter().filter_map(Value::as_str).map(str::to_owned));
    }
    match schema {
        Value::Array(items) => items.iter().for_each(|item| constants(item, found)),
        Value::Object(fields) => fields.values().for_each(|field| constants(field, found)),
        _ => {}
    }
}

/// The headings of the tables that the sources make.
fn headings(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let path = entry.path();
        if path.is_dir() {
            headings(&path, found);
        } else {
            let text = fs::read_to_string(&path).unwrap();
            let tests = text.find("#[cfg(test)]").unwrap_or(text.len());
            for begin in
                ["Table::new(&[", "heading = vec![", "names = vec![", "heading.extend([", "names.splice(4.., ["]
            {
                for table in text[..tests].split(begin).skip(1) {
                    let list = table.split(']').next().unwrap();
                    found.extend(list.split('"').skip(1).step_by(2).map(str::to_owned));
                }
            }
        }
    }
}

/// Headings that are sentences, or say what stands below them in words that everybody knows.
const PLAIN: [&str; 37] = [
    "above",
    "at",
    "at most so far",
    "axis (up)",
    "axis there",
    "below",
    "bodies",
    "change of stability",
    "describes",
    "direction",
    "distance",
    "distance at most",
    "error (rad/s)",
    "first",
    "from",
    "from rpm",
    "id",
    "in 1",
    "in 2",
    "kind",
    "name",
    "note",
    "rad/s",
    "regions of 1",
    "regions of 2",
    "rpm",
    "sample (h, l)",
    "then",
    "to",
    "to rpm",
    "types",
    "up",
    "angle to com",
    "class beside it",
    "class beyond",
    "what happens on the border",
    "axis",
];

/// Terms that stand in sentences.
const IN_SENTENCES: [&str; 33] = [
    "steady rotation",
    "further integral",
    "invariant relation",
    "spectrally only",
    "Arnold's theorem",
    "threshold",
    "Kovalevski",
    "permanent axis",
    "steady axes",
    "principal axes",
    "minimum of energy",
    "saddles",
    "maxima",
    "fold",
    "fork",
    "circle",
    "tolerance",
    "inside too",
    "frequency",
    "growth",
    "normal form",
    "1:2 resonance",
    "D4 = 0",
    "the forbidden region",
    "with friction",
    "eigenvalues",
    "border",
    "special bodies",
    "neighbours",
    "rotation number",
    "largest deviation",
    "error bound",
    "certificate",
];

#[test]
fn every_word_of_documents_and_tables_is_explained() {
    let mut words = BTreeSet::new();
    constants(&bifdiag("schema --json").succeeds().json(), &mut words);
    assert!(words.len() > 60, "{words:?}");
    let types = [
        Stability::Elliptic,
        Stability::SaddleCentre,
        Stability::Saddle,
        Stability::Complex,
        Stability::DoubleElliptic,
        Stability::DoubleReal,
        Stability::Zero,
    ];
    words.extend(types.map(|of| of.word().to_owned()));
    // As tables have them.
    words.extend(["stable (energy)", "stable (Arnold)", "unstable", "open"].map(str::to_owned));
    words.extend(IN_SENTENCES.map(str::to_owned));
    headings(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/cli"), &mut words);
    assert!(words.contains("signature") && words.contains("small motions"));
    words.remove("");
    words.retain(|word| !PLAIN.contains(&word.as_str()));
    let missing: Vec<&String> = words.iter().filter(|word| !is_explained(word)).collect();
    assert!(missing.is_empty(), "docs/glossary.md explains none of {missing:?}");
}

/// Cells of tables that everybody understands.
const PLAIN_CELLS: [&str; 6] = ["inf", "no", "rest", "same", "twice", "yes"];

/// The parts of a cell of a table: without numbers, and of a list its entries.
fn phrases(cell: &str) -> Vec<String> {
    let is_number = |word: &str| !word.chars().any(|c| c.is_alphabetic() && !"ei".contains(c));
    let words = |part: &str| part.split(' ').filter(|word| !is_number(word)).map(str::to_owned).collect::<Vec<_>>();
    if cell.starts_with(['R', 'E', 'k', 'M']) {
        return words(cell);
    }
    let named = cell.contains("axis") || cell.contains("axes") || cell.contains("direction");
    let parts = if named { vec![cell] } else { cell.split(", ").collect() };
    parts.into_iter().map(|part| if named { part.to_owned() } else { words(part).join(" ") }).collect()
}

/// What stands in the cells of tables is explained in full, as it is printed.
#[test]
fn every_phrase_of_tables_is_explained() {
    let bodies = [
        "--body paper",
        "--body lagrange",
        "--body euler",
        "--body isotropic",
        "--body katok:7",
        "--A 1,0.75,1.75 --r 1,0,0",
        "--A 1,1,2 --r 0.3,0.4,0.5",
        "--A 1,1,1 --r 0,0,0",
        "--A 1,2,2 --r 0,0,0",
    ];
    let mut lines = vec![
        "classes".to_owned(),
        "show R5 --body paper".to_owned(),
        "critical-spin --body lagrange --axis z".to_owned(),
        "critical-spin --A 1,0.75,1.75 --r 1,0,0 --axis x".to_owned(),
        "chaos --body paper --h 5.3 --l 3.25 --error 0.5".to_owned(),
        "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times 0:5:3".to_owned(),
    ];
    lines.extend(bodies.iter().flat_map(|body| [format!("critical --l 2 {body}"), format!("critical-spin {body}")]));
    lines.extend(["L-.1", "L+.1", "S2.1"].map(|curve| format!("show {curve} --A 1,0.75,1.75 --r 1,0,0")));
    let mut found = BTreeSet::new();
    for line in lines {
        let text = bifdiag(&line).succeeds().stdout();
        let cells = text.lines().map(|row| row.trim().split("  ").map(str::trim).filter(|cell| !cell.is_empty()));
        let rows = cells.map(Iterator::collect::<Vec<_>>).filter(|row| row.len() > 1);
        found.extend(rows.flatten().flat_map(phrases));
    }
    found.remove("");
    found.retain(|phrase| !PLAIN.contains(&phrase.as_str()) && !PLAIN_CELLS.contains(&phrase.as_str()));
    for phrase in ["pair over axis 1", "from +r̂", "between axes 1 and 2 and axis 3", "by an integral"] {
        assert!(found.contains(phrase), "{phrase}: {found:?}");
    }
    for reason in
        ["stable (minimum of energy)", "stable (Arnold's theorem)", "unstable in 2 directions", "open (degenerate)"]
    {
        assert!(found.contains(reason), "{reason}: {found:?}");
    }
    let is_class = |phrase: &str| phrase.len() == 12 && phrase.bytes().all(|byte| byte.is_ascii_hexdigit());
    found.retain(|phrase| !is_class(phrase));
    // At single spins and momenta.
    found.extend(["stable (a further integral)", "unstable (1:2 resonance)", "D4 = 0", "from −r̂"].map(str::to_owned));
    let missing: Vec<&String> = found.iter().filter(|phrase| !is_explained(phrase)).collect();
    assert!(missing.is_empty(), "docs/glossary.md explains none of {missing:?}");
}

fn is_explained(word: &str) -> bool {
    Command::new(PROGRAM).args(["explain", "--", word]).output().unwrap().status.success()
}

#[test]
fn every_name_of_an_atlas_is_explained() {
    let mut words: BTreeSet<String> = BTreeSet::new();
    for body in ["paper", "lagrange", "katok:7", "isotropic", "ten"] {
        let atlas = bifdiag(&format!("--body {body} --json --no-drawing")).succeeds().json();
        let ids = ["regions", "curves"].into_iter().flat_map(|list| atlas[list].as_array().unwrap());
        words.extend(ids.map(|entry| entry["id"].as_str().unwrap().to_owned()));
        for region in atlas["regions"].as_array().unwrap() {
            words.extend(region["signature"].as_str().map(str::to_owned));
            for component in region["components"].as_array().unwrap() {
                let names = ["accessible_region", "energy_surface", "section"].map(|key| component[key].as_str());
                words.extend(names.into_iter().flatten().map(str::to_owned));
            }
        }
    }
    bifdiag("explain R1").succeeds().printing("region").printing("centre of mass");
    for word in &words {
        bifdiag("explain").and(word).succeeds().telling_nothing();
    }
    assert!(words.len() > 20, "{words:?}");
}

#[test]
fn the_glossary_is_the_one_of_the_documentation() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/glossary.md")).unwrap();
    let all = bifdiag("explain --json").succeeds().json();
    let entries = all["entries"].as_array().unwrap();
    assert_eq!(
        entries.len(),
        page.lines().filter(|line| line.starts_with("| ") && line.ends_with('|')).count()
            - 2 * page.matches("| term |").count()
    );
    for entry in entries {
        let first = entry["terms"][0].as_str().unwrap();
        let reply = bifdiag("explain --json").and(first).succeeds().json();
        assert!(reply["entries"].as_array().unwrap().contains(entry), "{first}");
    }
    bifdiag("explain").succeeds().printing("Stability\n").printing("hamiltonian-hopf");
}

#[test]
fn other_spellings_lead_to_the_same_thing() {
    let reply = |word: &str| bifdiag("explain").and(word).succeeds().telling_nothing().stdout();
    let kovalevskaya = reply("Kovalevskaya");
    for word in ["Kowalevski", "kovalevskaja", "Kowalevskaya"] {
        assert_eq!(reply(word), kovalevskaya, "{word}");
    }
    assert_eq!(reply("Staude"), reply("relative equilibria"));
    assert_eq!(reply("pitchforks"), reply("fork"));
    assert_eq!(reply("hamiltonian hopf"), reply("Hamiltonian-Hopf"));
    // What stands in parentheses tells things of one name apart.
    for word in ["fold", "folds"] {
        let reply = reply(word);
        assert!(
            reply.contains("fold (of steady axes)") && reply.contains("of periodic orbits") && reply.contains("cusp")
        );
    }
    assert_eq!(reply("fold of steady axes"), reply("fold (of steady axes)"));
    bifdiag("explain pichfork").refused().telling("the nearest is pitchfork").printing_nothing();
    bifdiag("explain xyzzyxyzzy").refused().telling("has no such term; `bifdiag explain` lists");
    let atlas = |body: &str| bifdiag(&format!("--body {body} --json")).succeeds().stdout();
    for body in ["kowalevski", "Kovalevskaya", "kovalevskaja"] {
        assert_eq!(atlas(body), atlas("kovalevskaya"), "{body}");
    }
    assert_eq!(atlas("Goryachev-Chaplygin"), atlas("chaplygin"));
}

#[test]
fn show_knows_the_names_of_surfaces() {
    let explained = bifdiag("explain M4").succeeds().stdout();
    assert_eq!(bifdiag("show M4").succeeds().stdout(), explained);
    bifdiag("show R5").refused().telling("no body is given");
    bifdiag("show M4 --body paper").succeeds().printing("no region of this body has M4");
    let shown = bifdiag("show M2 --body paper").succeeds();
    shown.printing("M2 occurs in the regions R3, R6").printing("region R6, sections M2");
    for name in ["k2n1", "S2+T2", "T2+S2", "RP3", "s1xs2"] {
        bifdiag(&format!("show {name} --body paper")).succeeds().printing("occurs in the region");
    }
    // A branch of this body comes before a surface.
    bifdiag("show S2 --body paper").succeeds().printing("curve S2.1").printing("S2 occurs in the region");
    bifdiag("show R9 --A 2,2,1 --r 0,0,0").refused().telling("it has the regions R1 and R2");
}

/// Without weight there are neither poles nor sections, and a scan counts what there is all the same.
#[test]
fn show_finds_what_a_scan_counts() {
    let bodies =
        ["3,2,1,0,0,0", "2,2,1,0,0,0", "1,2,2,0,0,0", "1,1,1,0,0,0", "1,1,1,0,0,1", "2,2,1,0,0,1", "2,1,1,1,0,0"];
    let place = tempfile::tempdir().unwrap();
    let table = format!("A1,A2,A3,r1,r2,r3\n{}\n", bodies.join("\n"));
    std::fs::write(place.path().join("bodies.csv"), table).unwrap();
    let rows = bifdiag("scan --bodies bodies.csv --format jsonl --out -").inside(place.path()).succeeds().json_lines();
    assert_eq!(rows.len(), bodies.len());
    for row in rows {
        let list = |name: &str| {
            let numbers: [f64; 3] = [1, 2, 3].map(|axis| row[format!("{name}{axis}")].as_f64().expect("a number"));
            numbers.map(|x| x.to_string()).join(",")
        };
        let body = format!("--A {} --r {}", list("A"), list("r"));
        // Each with its count.
        let counted = [&row["types"], &row["signatures"]].map(|text| text.as_str().expect("a text").to_owned());
        let names = counted.iter().flat_map(|text| text.split(' ')).map(|pair| pair.split_once(':').unwrap().0);
        let names: Vec<&str> = names.collect();
        assert!(names.len() > 1, "{body}: {names:?}");
        for name in names {
            bifdiag(&format!("show {name} {body}")).succeeds().printing(" occurs in the region");
        }
    }
    bifdiag("show D2+D2 --A 3,2,1 --r 0,0,0").succeeds().printing("region R1, U = D2+D2");
}

/// The commands of a command are commands.
#[test]
fn names_of_commands_are_explained() {
    for (name, reply) in [
        ("scan", "Find the classes of diagrams of many bodies. `bifdiag scan --help`"),
        ("scan map", "Draw the class of each body over two parameters. `bifdiag scan map --help`"),
        ("periodic family", "`bifdiag periodic family --help`"),
        ("chaos merge", "`bifdiag chaos merge --help`"),
    ] {
        let explained =
            bifdiag("explain").and(name).succeeds().stdout().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(explained.contains(reply), "{name}: {explained}");
    }
}
