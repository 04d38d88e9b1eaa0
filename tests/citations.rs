//! Statements of docs/mathematics.md and docs/algorithms.md, which share their numbers, are cited by kind and number ("Lemma"
//! 7.5): each that is cited is there.
//!
//! A kind followed by a number, in any source or page, is a citation of these pages; theorems of others are cited by name.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const KINDS: [&str; 6] = ["Definition", "Lemma", "Proposition", "Theorem", "Corollary", "Example"];

const PAGES: [&str; 2] = ["docs/mathematics.md", "docs/algorithms.md"];

/// Section and place in it.
type Number = (u32, u32);

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files below a folder with one of these extensions.
fn files(folder: &Path, extensions: &[&str], found: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for path in entries.map(|entry| entry.expect("the folder can be listed").path()) {
        if path.is_dir() {
            if !path.ends_with("target") {
                files(&path, extensions, found);
            }
        } else if path.extension().is_some_and(|e| extensions.iter().any(|wanted| e == *wanted)) {
            found.push(path);
        }
    }
}

/// Every source and page in which statements may be cited.
fn citing_files() -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in ["src", "crates", "tests", "benches", "examples"] {
        files(&root().join(folder), &["rs"], &mut found);
    }
    files(&root().join("docs"), &["md"], &mut found);
    files(&root().join("data/oracles"), &["py", "md"], &mut found);
    found.extend(["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|page| root().join(page)));
    found.sort();
    found
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The text as one line, without the marks of comments: a citation may be broken between two lines.
fn flat(text: &str) -> String {
    let bare = |line: &str| {
        let line = line.trim_start();
        let comment = ["//!", "///", "//", "#"].into_iter().find_map(|mark| line.strip_prefix(mark));
        comment.unwrap_or(line).trim().to_owned()
    };
    text.lines().map(bare).collect::<Vec<_>>().join(" ")
}

/// A number N.M at the beginning of a text.
fn number(text: &str) -> Option<Number> {
    let digits = |text: &str| text.chars().take_while(char::is_ascii_digit).count();
    let section = digits(text);
    let rest = text[section..].strip_prefix('.')?;
    let place = digits(rest);
    Some((text[..section].parse().ok()?, rest[..place].parse().ok()?))
}

/// Kinds with numbers, also in the plural.
fn citations(text: &str) -> Vec<(&'static str, Number)> {
    let text = flat(text);
    let plural = |kind: &str| if kind == "Corollary" { "Corollaries".to_owned() } else { format!("{kind}s") };
    let mut found = Vec::new();
    for kind in KINDS {
        for name in [kind.to_owned(), plural(kind)] {
            let after = text.match_indices(&name).filter_map(|(at, _)| text[at + name.len()..].strip_prefix(' '));
            found.extend(after.filter_map(number).map(|number| (kind, number)));
        }
    }
    found
}

/// The statements of a page, by number. Each stands at the beginning of a line, bold.
fn statements(page: &str) -> BTreeMap<Number, &'static str> {
    let mut found = BTreeMap::new();
    let mut last = (0, 0);
    for line in page.lines() {
        let Some(bold) = line.strip_prefix("**") else { continue };
        for kind in KINDS {
            let Some(number) = bold.strip_prefix(kind).and_then(|rest| number(rest.strip_prefix(' ')?)) else {
                continue;
            };
            assert!(found.insert(number, kind).is_none(), "{number:?} is there twice");
            assert!(last < number, "{number:?} stands after {last:?}");
            last = number;
        }
    }
    found
}

/// Numbers N.M of at most two digits each outside formulas and tables: the page cites itself without kinds.
fn bare_numbers(page: &str) -> BTreeSet<Number> {
    let prose: Vec<&str> = page.lines().filter(|line| !line.starts_with('|')).collect();
    let prose = prose.join("\n");
    let outside: Vec<&str> = prose.split('$').step_by(2).collect();
    let outside = outside.join(" ");
    let words = outside.split(|c: char| !c.is_ascii_digit() && c != '.').map(|word| word.trim_matches('.'));
    let short = |word: &&str| word.split('.').count() == 2 && word.split('.').all(|part| part.len() <= 2);
    words.filter(short).filter_map(number).collect()
}

/// Formulas that are said to be derived, and where is not said; citations of a page outside the repository.
fn uncited(text: &str) -> Vec<String> {
    let text = flat(text);
    let mut found: Vec<String> = Vec::new();
    for outside in [concat!("MATH", " §"), concat!("MATH", ".md")] {
        found.extend(text.match_indices(outside).map(|_| outside.to_owned()));
    }
    for (at, derived) in text.match_indices(concat!("(", "derived")) {
        let rest = &text[at..];
        let remark = &rest[..rest.find(')').unwrap_or(rest.len())];
        if citations(remark).is_empty() {
            found.push(format!("{derived})"));
        }
    }
    found
}

/// The statements of both pages.
fn all_statements() -> BTreeMap<Number, &'static str> {
    let [mathematics, algorithms] = PAGES.map(|page| statements(&read(&root().join(page))));
    let mut all = mathematics;
    for (number, kind) in algorithms {
        assert!(all.insert(number, kind).is_none(), "{number:?} is on both pages");
    }
    all
}

/// Citations with a page, as in "7.5 of docs/algorithms.md": the number that stands last before the name of the page.
fn citations_with_page(text: &str, page: &str) -> Vec<Number> {
    let text = flat(text);
    let named = text.match_indices(page).map(|(at, _)| &text[..at]);
    let last = |before: &str| {
        let before = before.trim_end_matches('[').trim_end().strip_suffix("of")?.trim_end();
        let from = before.rfind(|c: char| !c.is_ascii_digit() && c != '.').map_or(0, |at| at + 1);
        number(before[from..].trim_end_matches('.'))
    };
    named.filter_map(last).collect()
}

#[test]
fn every_statement_that_is_cited_is_on_a_page() {
    let statements = all_statements();
    let mut cited = BTreeSet::new();
    let mut wrong = Vec::new();
    for path in citing_files().iter().filter(|path| !path.ends_with("tests/citations.rs")) {
        for (kind, number) in citations(&read(path)) {
            if statements.get(&number) != Some(&kind) {
                wrong.push(format!("{}: {kind} {}.{}", path.display(), number.0, number.1));
            }
            if path.extension().is_some_and(|extension| extension == "rs") {
                cited.insert(number);
            }
        }
    }
    assert!(wrong.is_empty(), "on neither page:\n{}", wrong.join("\n"));
    assert!(cited.len() >= 20, "only {} statements are cited in the sources", cited.len());
}

#[test]
fn a_statement_is_on_the_page_that_its_citation_names() {
    let mut wrong = Vec::new();
    for page in PAGES {
        let statements = statements(&read(&root().join(page)));
        let name = page.trim_start_matches("docs/");
        for path in citing_files().iter().filter(|path| !path.ends_with("tests/citations.rs")) {
            let text = read(path);
            let cited = [page, name].into_iter().flat_map(|name| citations_with_page(&text, name));
            let missing = cited.filter(|number| !statements.contains_key(number));
            wrong.extend(missing.map(|number| format!("{}: {number:?} of {page}", path.display())));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_pages_number_their_statements_in_order_and_refer_to_them() {
    let statements = all_statements();
    let mut last: Number = (0, 0);
    for number in statements.keys() {
        let follows = *number == (last.0, last.1 + 1) || (number.0 > last.0 && number.1 == 1);
        assert!(follows, "{number:?} after {last:?}");
        last = *number;
    }
    for page in PAGES {
        let numbers = bare_numbers(&read(&root().join(page)));
        let missing: Vec<_> = numbers.into_iter().filter(|number| !statements.contains_key(number)).collect();
        assert!(missing.is_empty(), "{page} refers to {missing:?}, which is on neither page");
    }
}

/// A referee reads it in two hours.
#[test]
fn the_mathematics_is_short() {
    let words = read(&root().join(PAGES[0])).split_whitespace().count();
    assert!(words <= 7_000, "{words} words");
}

#[test]
fn no_formula_is_derived_nowhere() {
    let found: Vec<String> = citing_files()
        .iter()
        .flat_map(|path| uncited(&read(path)).into_iter().map(move |what| format!("{}: {what}", path.display())))
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn citations_are_found_wherever_lines_break() {
    assert_eq!(citations("/// (Lemma\n    /// 7.5)."), [("Lemma", (7, 5))]);
    assert_eq!(citations("by Propositions 11.3 and"), [("Proposition", (11, 3))]);
    assert_eq!(citations("Theorem of Ehresmann, Lemma 7"), []);
    assert_eq!(
        statements("**Lemma 1.1 (a).**\ntext Lemma 1.2\n**Example 1.2.** b"),
        [((1, 1), "Lemma"), ((1, 2), "Example")].into()
    );
    assert_eq!(bare_numbers("by 3.5, $x = 1.5$ and 1.83216; (9.5)."), [(3, 5), (9, 5)].into());
    let page = "docs/algorithms.md";
    assert_eq!(citations_with_page("/// (Lemma 7.5 and Lemma\n/// 7.6 of docs/algorithms.md)", page), [(7, 6)]);
    assert_eq!(citations_with_page("4.11 of [docs/algorithms.md](x), 4.1 in docs/algorithms.md", page), [(4, 11)]);
    assert_eq!(uncited(concat!("h = 0 (", "derived)")).len(), 1);
    assert!(uncited(concat!("h = 0 (", "derived, Lemma 7.5)")).is_empty());
    assert_eq!(uncited(concat!("see MATH", " §2")).len(), 1);
}
