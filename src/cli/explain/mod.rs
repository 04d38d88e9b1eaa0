//! `bifdiag explain`: a word of the program, by the glossary of its documentation.

mod glossary;

use bifdiag_documents::{CommandLine, head};
use bifdiag_schema::{ExplainedTermDocument, ExplanationDocument};
use clap::Args;

use super::export::answer;
use super::failure::Failure;
use super::terminal::{Report, wrapped};
use glossary::{Entry, Glossary};

pub const EXPLAIN_EXAMPLES: &str = "\
Examples:
  bifdiag explain saddle-centre
  bifdiag explain Kowalevski
  bifdiag explain M4
  bifdiag explain \"relative equilibrium\"
  bifdiag explain                     all terms

The entries come from docs/glossary.md. Capitals, hyphens, plurals and other spellings do not matter; R5, G2.1 or \
S2-3D2 are explained by their kind. Names of commands are explained, too.";

/// `bifdiag explain`.
#[derive(Debug, Args)]
pub struct ExplainArguments {
    /// A term that the program prints
    #[arg(value_name = "WORD")]
    pub words: Vec<String>,
    /// Print the answer as JSON
    #[arg(long)]
    pub json: bool,
}

/// Explains a word; `commands` are the names of all commands with what each does.
pub fn run(arguments: &ExplainArguments, commands: &[(String, String)]) -> Result<(), Failure> {
    let glossary = Glossary::new();
    if arguments.words.is_empty() {
        let all: Vec<&Entry> = glossary.entries.iter().collect();
        return answer(arguments.json, &document("", &all), || list(&glossary));
    }
    let word = arguments.words.join(" ");
    let command = commands.iter().find(|(name, _)| glossary::folded(name) == glossary::folded(&word));
    let document = match (explain(&glossary, &word), command) {
        (Ok(mut document), Some(command)) => {
            document.entries.push(of_command(command));
            document
        }
        (Err(_), Some(command)) => {
            ExplanationDocument { entries: vec![of_command(command)], ..self::document(&word, &[]) }
        }
        (explained, None) => explained?,
    };
    answer(arguments.json, &document, || text(&document))
}

/// The entry of a command.
fn of_command((name, about): &(String, String)) -> ExplainedTermDocument {
    ExplainedTermDocument {
        terms: vec![name.clone()],
        meaning: format!("{about}. `bifdiag {name} --help` describes all of its options, with examples."),
        also_called: Vec::new(),
        section: "Commands".to_owned(),
    }
}

/// What a word means, as text.
pub fn explanation(word: &str) -> Result<String, Failure> {
    explain(&Glossary::new(), word).map(|document| text(&document))
}

fn explain(glossary: &Glossary, word: &str) -> Result<ExplanationDocument, Failure> {
    let mut found = glossary.find(word);
    if found.is_empty() && word.contains('+') {
        found = signature(glossary, word);
    }
    if found.is_empty()
        && let Some((verdict, reason)) = word.strip_suffix(')').and_then(|word| word.split_once(" ("))
    {
        let parts = [verdict, reason].map(|part| glossary.find(part));
        found = if parts.iter().any(Vec::is_empty) { Vec::new() } else { parts.concat() };
    }
    if found.is_empty() {
        let near = match &glossary.nearest(word)[..] {
            [] => String::new(),
            [one] => format!("; the nearest is {one}"),
            near => format!("; the nearest are {}", near.join(", ")),
        };
        return Err(Failure::input(format!(
            "WORD {word}: the glossary has no such term{near}; `bifdiag explain` lists all of them"
        )));
    }
    Ok(document(word, &found))
}

/// The entries of the surfaces of a signature, such as S2+T2; none if one of them is no term.
fn signature<'a>(glossary: &'a Glossary, word: &str) -> Vec<&'a Entry> {
    let mut parts: Vec<&str> = word.split('+').collect();
    parts.sort_unstable();
    parts.dedup();
    let found: Vec<Vec<&Entry>> = parts.into_iter().map(|part| glossary.find(part)).collect();
    if found.iter().any(Vec::is_empty) {
        return Vec::new();
    }
    let mut entries = glossary.find("signature");
    for entry in found.into_iter().flatten() {
        if !entries.contains(&entry) {
            entries.push(entry);
        }
    }
    entries
}

fn document(word: &str, entries: &[&Entry]) -> ExplanationDocument {
    let texts = |list: &[&str]| list.iter().map(|&text| text.to_owned()).collect();
    let term = |entry: &&Entry| ExplainedTermDocument {
        terms: texts(&entry.terms),
        meaning: entry.meaning.clone(),
        also_called: texts(&entry.also_called),
        section: entry.section.to_owned(),
    };
    let line = CommandLine::new("explain");
    ExplanationDocument {
        head: head(if word.is_empty() { line } else { line.argument(word) }.json()),
        word: word.to_owned(),
        entries: entries.iter().map(term).collect(),
    }
}

fn text(document: &ExplanationDocument) -> String {
    let mut report = Report::default();
    for (place, entry) in document.entries.iter().enumerate() {
        if place > 0 {
            report.line("");
        }
        report.line(format!("{} ({})", entry.terms.join(", "), entry.section));
        report.line(wrapped(&entry.meaning));
        if !entry.also_called.is_empty() {
            report.line(wrapped(&format!("also called: {}", entry.also_called.join(", "))));
        }
    }
    report.text()
}

/// All terms, by the sections of the page.
fn list(glossary: &Glossary) -> String {
    let mut report = Report::default();
    let mut sections: Vec<&str> = glossary.entries.iter().map(|entry| entry.section).collect();
    sections.dedup();
    for section in sections {
        let of_section = glossary.entries.iter().filter(|entry| entry.section == section);
        let terms: Vec<&str> = of_section.flat_map(|entry| entry.terms.iter().copied()).collect();
        report.line(section);
        report.line(wrapped(&terms.join("; ")));
    }
    report.text()
}
