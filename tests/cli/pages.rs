//! Help, completions, manual pages and the list of bodies.

use std::fs;

use crate::builder::{Run, bifdiag};

/// All commands, from the first page.
fn commands() -> Vec<String> {
    let page = bifdiag("--help").succeeds().stdout();
    let list = page.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let name = |line: &str| line.strip_prefix("  ").filter(|rest| !rest.starts_with(' ')).map(str::to_owned);
    let names = list.lines().filter_map(|line| Some(name(line)?.split(' ').next()?.to_owned()));
    let names: Vec<String> = names
        .chain(
            [
                "scan merge",
                "scan map",
                "scan border",
                "chaos map",
                "chaos merge",
                "periodic family",
                "periodic list",
                "periodic manifolds",
                "",
            ]
            .map(str::to_owned),
        )
        .collect();
    assert!(names.len() > 20, "{names:?}");
    names
}

#[test]
fn every_help_page_has_examples_and_fits_100_columns() {
    for command in commands() {
        for help in ["--help", "-h"] {
            let done =
                bifdiag(&format!("{command} {help}")).succeeds().telling_nothing().printing("Examples:\n  bifdiag");
            assert!(done.stdout().lines().all(|line| line.chars().count() <= 100), "{command} {help}");
        }
    }
}

/// The words of an example, of which those in quotation marks hold blanks.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    parts
        .flat_map(|(number, part)| match number % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        })
        .collect()
}

/// Every example that only reads its arguments, or what the one before it wrote, runs as it is printed.
#[test]
fn the_examples_of_the_help_pages_work() {
    let place = tempfile::tempdir().unwrap();
    // What an example reads that another has written.
    bifdiag("--body paper --no-plot --certificate").inside(place.path()).succeeds();
    let mut tried = 0;
    // Shards, tables and the page that these read are made elsewhere.
    let other = ["scan merge", "scan map", "chaos merge", "explore"];
    for command in commands().iter().filter(|command| !other.contains(&command.as_str())) {
        let help = bifdiag(&format!("{command} --help")).succeeds().stdout().replace("\\\n      ", "");
        for line in help.lines().filter_map(|line| line.strip_prefix("  bifdiag ")) {
            // What stands right of several blanks is a remark; pipes and redirections are the shell's.
            let line = line.split("   ").next().unwrap_or_default().split(['|', '>', '&']).next().unwrap_or_default();
            // Only a shell knows what an asterisk stands for.
            if !line.contains('*') && !line.contains("--batch") && !line.contains('~') {
                let run = words(line).iter().fold(bifdiag(""), Run::and);
                run.inside(place.path()).succeeds();
                tried += 1;
            }
        }
    }
    assert!(tried >= 50, "only {tried} examples were found");
}

#[test]
fn the_version_is_reported() {
    bifdiag("--version").succeeds().printing(concat!("bifdiag ", env!("CARGO_PKG_VERSION")));
}

#[test]
fn completions_know_the_commands_and_the_bodies() {
    for shell in ["bash", "zsh", "fish"] {
        bifdiag(&format!("completions {shell}")).succeeds().printing("classify").printing("kovalevskaya");
    }
    // These shells complete no values.
    for shell in ["elvish", "powershell"] {
        bifdiag(&format!("completions {shell}")).succeeds().printing("classify").printing("--inertia");
    }
}

#[test]
fn manual_pages_are_written_for_every_command() {
    bifdiag("man").succeeds().printing(".TH bifdiag 1").printing("Examples:");
    let place = tempfile::tempdir().unwrap();
    bifdiag("man --out").and(place.path()).succeeds().printing("bifdiag-classify.1");
    for command in commands().iter().filter(|name| !name.is_empty() && !name.contains(' ')) {
        let page = fs::read_to_string(place.path().join(format!("bifdiag-{command}.1"))).unwrap();
        assert!(page.contains(&format!(".TH bifdiag-{command} 1")), "{command}");
    }
    assert!(place.path().join("bifdiag.1").exists());
}

#[test]
fn bodies_are_listed_and_each_can_be_used() {
    let document = bifdiag("bodies --json").succeeds().json();
    let bodies = document["bodies"].as_array().unwrap().clone();
    let listed = bifdiag("bodies").succeeds().stdout();
    for body in &bodies {
        let name = body["name"].as_str().unwrap();
        assert!(listed.lines().any(|line| line.starts_with(&format!("{name} "))), "{name}");
        let critical = bifdiag(&format!("critical --l 1 --json --body {name}")).succeeds().json();
        assert_eq!((&critical["A"], &critical["r"]), (&body["A"], &body["r"]), "{name}");
    }
    assert!(bodies.len() >= 16);
}

/// Options on a page, but for those that ask for the page itself.
fn slots(page: &str) -> usize {
    let option = |line: &&str| {
        let (indent, name) = (line.len() - line.trim_start().len(), line.trim_start());
        (2..=6).contains(&indent) && name.starts_with('-') && !name.starts_with("-h,") && !name.starts_with("-V,")
    };
    page.lines().filter(option).count()
}

/// Options of `spin-down`, which issue 39 added: its own three, three of its picture and those of every body.
const SPIN_DOWN: usize = 21;
/// `scan events` (issue 37): its own six, four of its picture and those of a body.
const EVENTS: usize = 13;
/// And those of `explain`, `compare`, `classify --certificate` and `orbit --euler` (issue 37): one each.
const MATHEMATICS: usize = 4;
/// `scan --bodies` and `--keep` (issue 40), for arrays of bodies from Python.
const OWN_BODIES: usize = 2;
/// And those of pictures (issue 38), on the page of `atlas` and on the first one.
const PICTURES: usize = 4;
/// `--dpi` and `--standalone` of all pictures on eight pages; `--legend`, `--title` and `--table` of diagrams on three, of which
/// that of `class` has `--width`, `--view` and `--no-samples` too (issue 38); `--width` of `spin-down` and `chaos map`.
const FIGURES: usize = 16 + 9 + 3 + 2;

/// And `orbit --proved` with its digits and its bound (issue 42).
const PROVED_MOTION: usize = 3;
/// Options of `periodic family` (issue 43): its own seven and those of every body.
const PERIODIC_FAMILY: usize = 22;

/// Options of `periodic list` (issue 43): its own eleven and those of every body.
const PERIODIC_LIST: usize = 26;

/// `periodic` (issue 43): its own two, the point and those of every body.
const SHORT_ORBITS: usize = 19;

/// `periodic manifolds` (issue 43): its own six, four of its picture, the point and those of every body.
const MANIFOLDS: usize = 27;

/// Options of `chaos` (issue 41): its own nine, two of its point and those of every body; `--out` of `chaos merge`; that of
/// `chaos map` with four of its picture.
const CHAOS: usize = 32;

/// The options of the first hour fit a screen, and all pages together a patient reader.
#[test]
fn short_pages_fit_a_screen_and_long_ones_do_not_repeat_themselves() {
    let mut all = 0;
    for command in commands() {
        let short = bifdiag(&format!("{command} -h")).succeeds().stdout();
        assert!(short.lines().count() <= 50, "{command}: {} lines\n{short}", short.lines().count());
        all += slots(&bifdiag(&format!("{command} --help")).succeeds().stdout());
    }
    let periodic = PERIODIC_FAMILY + PERIODIC_LIST + SHORT_ORBITS + MANIFOLDS;
    let bound =
        330 + SPIN_DOWN + MATHEMATICS + OWN_BODIES + PICTURES + FIGURES + PROVED_MOTION + periodic + CHAOS + EVENTS;
    assert!(all < bound, "{all} options on all pages");
}

#[test]
fn what_is_like_nothing_gets_no_advice() {
    let misled = "similar argument";
    for line in ["bodies --format svg", "scan --family katok --inertia 1,1,1,0,0,0", "classify --certify"] {
        let reply = bifdiag(line).refused().stderr();
        assert!(!reply.contains(misled), "{reply}");
    }
    bifdiag("--boddy paper").refused().telling("a similar argument exists: '--body'");
    // Nor the advice to pass an option as a value, or a command that shares some letters.
    for line in ["show R5 --bodies paper", "class --witness x", "inertia --A 2,1,1"] {
        let reply = bifdiag(line).refused().stderr();
        assert!(!reply.contains("tip:"), "{reply}");
    }
    bifdiag("clasify --body paper").refused().telling("classify");
}
