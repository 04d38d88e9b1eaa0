//! The families and orbits of `bifdiag periodic list`, as text and as a table.

use std::path::{Path, PathBuf};

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_numbers::decimal::counted;
use bifdiag_schema::{
    FamilyEnd, FamilyEndingDocument, ListedFamilyDocument, ListedOrbitDocument, OrbitStability, PeriodicListDocument,
    PeriodicOrbitDocument,
};

use super::family::DIGITS;
use super::short::yes;
use crate::cli::export::{Columns, DataFormat, FileSet, Journal, Values};
use crate::cli::failure::{Failure, failed};
use crate::cli::input::{head, motion_units};
use crate::cli::terminal::{Report, Table, significant, wrapped};

/// The families that a journal holds.
pub fn read_back(journal: &mut Journal) -> Result<Vec<ListedFamilyDocument>, Failure> {
    let mut families = Vec::new();
    for block in journal.blocks().to_vec() {
        let mut room = vec![0; usize::try_from(block.end - block.start).unwrap_or(usize::MAX)];
        journal.read(block.start, &mut room).map_err(failed("what was found before cannot be read back"))?;
        for line in room.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
            families.push(serde_json::from_slice(line)?);
        }
    }
    Ok(families)
}

/// A row for each orbit.
pub fn columns(document: &PeriodicListDocument) -> Result<Columns, Failure> {
    let mut names: Vec<&str> = Vec::new();
    let mut rows: Vec<(usize, &ListedFamilyDocument, &ListedOrbitDocument)> = Vec::new();
    for family in &document.families {
        let place = names.iter().position(|name| *name == family.family).unwrap_or_else(|| {
            names.push(&family.family);
            names.len() - 1
        });
        rows.extend(family.orbits.iter().map(|orbit| (place, family, orbit)));
    }
    let orbits = || rows.iter().map(|(_, _, listed)| &listed.orbit);
    let count = |x: usize| i32::try_from(x).unwrap_or(i32::MAX);
    let real = |value: fn(&PeriodicOrbitDocument) -> f64| Values::floats(orbits().map(value));
    let code = |stability| OrbitStability::ALL.iter().position(|word| *word == stability).unwrap_or_default();
    let words = |words: Vec<&str>, places: Vec<i32>| Values::words(&words, Values::Int32(places));
    let stability = orbits().map(|orbit| count(code(orbit.stability))).collect();
    let columns = [
        ("family", words(names, rows.iter().map(|(place, ..)| count(*place)).collect())?),
        ("branch", Values::Int32(rows.iter().map(|(_, family, _)| count(family.branch)).collect())),
        ("member", Values::Int32(rows.iter().map(|(_, _, listed)| count(listed.member)).collect())),
        ("h", real(|orbit| orbit.h)),
        ("l", real(|orbit| orbit.l)),
        ("gamma", Values::vectors(orbits().map(|orbit| orbit.gamma))),
        ("omega", Values::vectors(orbits().map(|orbit| orbit.omega))),
        ("crossings", Values::Int32(orbits().map(|orbit| orbit.crossings.cast_signed()).collect())),
        ("period", real(|orbit| orbit.period)),
        ("trace", real(trace)),
        ("stability", words(OrbitStability::ALL.iter().map(|word| word.word()).collect(), stability)?),
        ("action", real(|orbit| orbit.action)),
        ("symmetric", Values::Int8(orbits().map(|orbit| i8::from(orbit.symmetric)).collect())),
    ];
    // The orbits are in the rows.
    let families = document.families.iter().map(|family| ListedFamilyDocument { orbits: Vec::new(), ..family.clone() });
    Ok(Columns::new(columns, &PeriodicListDocument { families: families.collect(), ..document.clone() })?)
}

/// Writes the table.
pub fn written(table: &Columns, (path, format): (&Path, DataFormat)) -> Result<Vec<PathBuf>, Failure> {
    let mut files = FileSet::new(path.parent().unwrap_or(path));
    files.add_at(path, format.bytes(table)?);
    files.write()
}

/// Orbits that are listed individually.
const LISTED: usize = 40;

/// The answer as text.
pub fn text(subject: &Subject, document: &PeriodicListDocument, files: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let orbits: usize = document.families.iter().map(|family| family.orbits.len()).sum();
    if document.families.is_empty() {
        report.line("no family begins there");
    } else {
        report.line(of_families(document).text());
        report.line("");
    }
    let only = document.stable || document.period.is_some() || document.crossings.is_some();
    report.line(format!("{}{}", counted(orbits, "orbit", "orbits"), if only { " selected" } else { "" }));
    if (1..=LISTED).contains(&orbits) {
        report.line(of_orbits(document).text());
    } else if orbits > LISTED && files.is_empty() {
        report.line("  --json lists each, --data FILE writes them as a table");
    }
    if document.families.iter().any(|family| family.branch > 0) {
        report.line("b1, b2, …: families that begin at special orbits of the one above");
    }
    motion_units(subject, &mut report);
    report.line("");
    report.line(if document.complete { "complete:" } else { "not complete:" });
    report.line(wrapped(&document.why));
    report.written(files);
    report.text()
}

/// The names of the quantity held and of the other one.
fn held(document: &PeriodicListDocument) -> (&'static str, &'static str) {
    if document.fixed_l.is_some() { ("l", "h") } else { ("h", "l") }
}

/// The value held along a family, as requested; that of an orbit differs by rounding.
fn asked(document: &PeriodicListDocument, found: f64) -> f64 {
    let texts = document.fixed_l.iter().chain(&document.fixed_h).flatten();
    let values = texts.filter_map(|text| text.parse::<Number>().ok()).map(|number| number.to_f64());
    values.min_by(|p, q| (p - found).abs().total_cmp(&(q - found).abs())).unwrap_or(found)
}

fn of_families(document: &PeriodicListDocument) -> Table {
    let (fixed, free) = held(document);
    let mut table = Table::new(&[fixed, "family", "orbits", "stable", free, "T", "end"]);
    for family in &document.families {
        let orbits = &family.orbits;
        let stable = orbits.iter().filter(|listed| listed.orbit.stability == OrbitStability::Elliptic).count();
        let range = |value: &dyn Fn(&PeriodicOrbitDocument) -> f64| {
            let values = || orbits.iter().map(|listed| value(&listed.orbit));
            let (Some(least), Some(most)) = (values().reduce(f64::min), values().reduce(f64::max)) else {
                return String::new();
            };
            format!("{} … {}", significant(least, 4), significant(most, 4))
        };
        table.row([
            significant(asked(document, if fixed == "l" { family.l } else { family.h }), DIGITS),
            name(family),
            if orbits.len() == family.followed {
                orbits.len().to_string()
            } else {
                format!("{} of {}", orbits.len(), family.followed)
            },
            stable.to_string(),
            range(&|orbit| if free == "h" { orbit.h } else { orbit.l }),
            range(&|orbit| orbit.period),
            ending(&family.end),
        ]);
    }
    table
}

/// How a family ends, as a cell of the table.
fn ending(end: &FamilyEndingDocument) -> String {
    let curves = end.curves.join(", ");
    match end.kind {
        FamilyEnd::Equilibrium => format!("at equilibrium of {curves}"),
        FamilyEnd::Separatrix => format!("at separatrix of {curves}"),
        FamilyEnd::Joined => "joins another family".to_owned(),
        FamilyEnd::Members => "goes on".to_owned(),
        FamilyEnd::Lost => "followed no further".to_owned(),
        FamilyEnd::Circle => format!("along circle {curves}"),
        FamilyEnd::Resonant | FamilyEnd::NotIsolated => "not begun".to_owned(),
    }
}

fn of_orbits(document: &PeriodicListDocument) -> Table {
    let heading = ["family", "member", "h", "l", "T", "trace", "stability", "crossings", "symmetric", "action"];
    let mut table = Table::new(&heading);
    let is_held_l = document.fixed_l.is_some();
    for family in &document.families {
        for ListedOrbitDocument { member, orbit } in &family.orbits {
            let [h, l] =
                if is_held_l { [orbit.h, asked(document, orbit.l)] } else { [asked(document, orbit.h), orbit.l] };
            table.row([
                name(family),
                member.to_string(),
                significant(h, DIGITS),
                significant(l, DIGITS),
                significant(orbit.period, DIGITS),
                significant(trace(orbit), DIGITS),
                orbit.stability.word().to_owned(),
                orbit.crossings.to_string(),
                yes(orbit.symmetric),
                significant(orbit.action, DIGITS),
            ]);
        }
    }
    table
}

fn name(family: &ListedFamilyDocument) -> String {
    if family.branch == 0 { family.family.clone() } else { format!("{} b{}", family.family, family.branch) }
}

fn trace(orbit: &PeriodicOrbitDocument) -> f64 {
    orbit.multipliers[0][0] + orbit.multipliers[1][0]
}
