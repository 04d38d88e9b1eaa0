//! Help, completions, manual pages and the list of bodies.

use std::fs;

use crate::builder::bifdiag;

const COMMANDS: [&str; 14] = [
    "atlas",
    "classify",
    "critical",
    "section",
    "orbit",
    "scan",
    "find",
    "classes",
    "class",
    "bodies",
    "schema",
    "completions",
    "man",
    "figures",
];

#[test]
fn every_help_page_has_examples_and_fits_100_columns() {
    for command in COMMANDS.iter().chain(&[""]) {
        for help in ["--help", "-h"] {
            let done =
                bifdiag(&format!("{command} {help}")).succeeds().telling_nothing().printing("Examples:\n  bifdiag");
            assert!(done.stdout().lines().all(|line| line.chars().count() <= 120), "{command} {help}");
        }
    }
}

/// Every example that only reads its arguments runs as it is printed.
#[test]
fn the_examples_of_the_help_pages_work() {
    let place = tempfile::tempdir().unwrap();
    // What an example reads that another has written.
    bifdiag("--body paper --no-plot").inside(place.path()).succeeds();
    let mut tried = 0;
    for command in COMMANDS.iter().chain(&[""]) {
        let help = bifdiag(&format!("{command} --help")).succeeds().stdout();
        for line in help.lines().filter_map(|line| line.strip_prefix("  bifdiag ")) {
            // What stands right of several blanks is a remark; pipes and redirections are the shell's.
            let words = line.split("   ").next().unwrap_or_default().split(['|', '>']).next().unwrap_or_default();
            // Only a shell knows what an asterisk stands for.
            if !words.contains('*') && !words.contains("--batch") && !words.contains('~') && !words.contains("/tmp") {
                bifdiag(words).inside(place.path()).succeeds();
                tried += 1;
            }
        }
    }
    assert!(tried >= 15, "only {tried} examples were found");
}

#[test]
fn the_version_is_told() {
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
    for command in COMMANDS {
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
