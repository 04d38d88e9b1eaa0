//! The manuscript in `paper/`: its numbers come from the program and from records (`paper/values` checks their values), and
//! what it cites is there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const KINDS: [&str; 6] = ["Definition", "Lemma", "Proposition", "Theorem", "Corollary", "Example"];

fn paper() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("paper")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The sources that are written by hand, with their names.
fn sources() -> Vec<(String, String)> {
    let sections = fs::read_dir(paper().join("sections")).expect("the sections can be listed");
    let mut paths: Vec<PathBuf> = sections.map(|entry| entry.expect("a section can be listed").path()).collect();
    paths.push(paper().join("manuscript.tex"));
    paths.sort();
    paths.iter().map(|path| (path.file_name().expect("a file").to_string_lossy().into_owned(), read(path))).collect()
}

/// What stands in braces behind a command, for all of its uses.
fn arguments<'a>(text: &'a str, command: &str) -> Vec<&'a str> {
    let after = text.match_indices(command).filter_map(|(at, _)| {
        let rest = &text[at + command.len()..];
        let rest = match rest.strip_prefix('[') {
            Some(options) => options.split_once(']')?.1,
            None => rest,
        };
        rest.strip_prefix('{')?.split_once('}')
    });
    after.map(|(argument, _)| argument).collect()
}

/// The text without the arguments in which numbers are names, or lengths on the page.
fn without_names(text: &str) -> String {
    let mut rest = text.to_owned();
    for command in ["\\M", "\\cite", "\\ref", "\\label", "\\includegraphics", "\\begin"] {
        for argument in arguments(text, command) {
            rest = rest.replace(&format!("{{{argument}}}"), "");
        }
    }
    let is_layout = |line: &&str| !["\\textwidth", "\\documentclass"].iter().any(|word| line.contains(word));
    rest.lines().filter(is_layout).collect::<Vec<_>>().join("\n")
}

#[test]
fn no_measured_number_is_typed() {
    for (name, text) in sources() {
        for word in without_names(&text).split(|c: char| !(c.is_ascii_digit() || c == '.' || c == ',')) {
            let word = word.trim_matches(['.', ',']);
            // Larger than the numbers in theorems.
            let is_measured = word.contains('.') || word.parse::<u64>().is_ok_and(|number| number > 100);
            assert!(!is_measured, "{name}: {word} is typed; let paper/values make it");
        }
    }
}

#[test]
fn every_number_that_is_made_is_used() {
    let numbers = read(&paper().join("generated/numbers.tex"));
    let text: String = sources().into_iter().map(|(_, text)| text).collect();
    for macro_name in arguments(&numbers, "\\newcommand") {
        let is_whole = |at: usize| !text[at + macro_name.len()..].starts_with(|c: char| c.is_ascii_alphabetic());
        assert!(text.match_indices(macro_name).any(|(at, _)| is_whole(at)), "{macro_name} is not used");
    }
    for table in fs::read_dir(paper().join("generated")).expect("the tables can be listed") {
        let stem = table.expect("a table can be listed").path().with_extension("");
        let name = format!("generated/{}", stem.file_name().expect("a file").to_string_lossy());
        assert!(name == "generated/numbers" || text.contains(&format!("\\input{{{name}}}")), "{name} is not used");
    }
}

#[test]
fn statements_figures_and_works_that_are_cited_are_there() {
    let root = paper().join("..");
    let pages: String = ["docs/mathematics.md", "docs/algorithms.md"].map(|page| read(&root.join(page))).concat();
    // "**Theorem 4.12 (No tangency).**"
    let bold = pages.split("**").filter_map(|bold| bold.split_once(' ')).filter(|(kind, _)| KINDS.contains(kind));
    let is_number = |c: char| c == '.' || c.is_ascii_digit();
    let stated: BTreeSet<&str> =
        bold.map(|(_, rest)| rest.split(|c| !is_number(c)).next().unwrap_or_default().trim_matches('.')).collect();
    let works = read(&paper().join("references.bib"));
    for (name, text) in sources() {
        for number in arguments(&text, "\\M").into_iter().flat_map(|numbers| numbers.split(", ")) {
            assert!(stated.contains(number), "{name}: statement {number} is not in docs");
        }
        for figure in arguments(&text, "\\includegraphics") {
            let path = root.join(figure).with_extension("svg");
            assert!(path.exists(), "{name}: {} is missing", path.display());
        }
        for work in arguments(&text, "\\cite").into_iter().flat_map(|works| works.split(',')) {
            assert!(works.contains(&format!("{{{work},")), "{name}: {work} is not in references.bib");
        }
    }
}
