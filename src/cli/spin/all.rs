//! `bifdiag critical-spin` without an axis: all steady axes, and every spin at which one appears or changes.

use bifdiag_documents::{Subject, words};
use bifdiag_equilibria::critical::RelativeEquilibria;
use bifdiag_exact::AllSpins;
use bifdiag_schema::{
    IsolatedSpinDocument, Multiplicity, PermanentAxisDocument, SpinDocument, SteadyFamilyDocument, SteadySpinsDocument,
    SteadyStart, Verdict,
};

use super::axis::{listed, one_of};
use super::changes::table_of_changes;
use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed};
use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, Timings, all_apart, fixed, significant};

pub fn run(subject: &Subject, json: bool, timings: &Timings) -> Result<(), Failure> {
    let prepared = RelativeEquilibria::new(&subject.body).map_err(failed("the steady axes could not be found"))?;
    let found = timings.stage("spins", || AllSpins::new(&subject.body, &prepared));
    let found = found.ok_or_else(|| Failure::work("the steady axes could not be told apart: roots are too close"))?;
    let document = bifdiag_documents::steady_spins(subject, &found);
    answer(json, &document, || text(subject, &document))
}

fn text(subject: &Subject, document: &SteadySpinsDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line("");
    if document.permanent.is_empty() {
        report.line("no axis is permanent at every spin");
    }
    for permanent in &document.permanent {
        permanent_axis_text(&mut report, subject, permanent, document.note.is_some());
    }
    let moving: Vec<&SteadyFamilyDocument> = document.families.iter().filter(|family| !family.permanent).collect();
    if !moving.is_empty() {
        report.line("");
        report.line("steady axes that move with the spin:");
        families(&mut report, &moving, document.part.is_some());
    }
    // For a ball this is said above.
    if document.families.iter().all(|family| family.axes != Multiplicity::Sphere) {
        report.line(counts(document, subject.body.is_euler()));
    }
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

fn permanent_axis_text(report: &mut Report, subject: &Subject, permanent: &PermanentAxisDocument, unknown: bool) {
    report.line(format!("permanent axis {}", listed(permanent.axis)));
    let [plus, minus] = &permanent.slow;
    report.line(format!("at slow spins: +axis up {}, -axis up {}", plus.word(), minus.word()));
    if let Some(one_of) = one_of(subject, permanent.axis) {
        report.line(one_of);
    }
    match (permanent.changes.is_empty(), unknown) {
        (true, true) => report.line("its type does not change with the spin"),
        (true, false) => report.line("its type and the regions beside it do not change with the spin"),
        (false, _) => {
            report.line(table_of_changes(&permanent.changes, if unknown { "not known" } else { "same" }));
        }
    }
}

/// Families as a table, and what its words mean.
pub fn families(report: &mut Report, families: &[&SteadyFamilyDocument], of_part: bool) {
    report.line(table(families));
    legend(report, families);
    let frame = if of_part { "in the part's frame" } else { "in principal axes" };
    report.line(format!("axis: the end that points up, {frame}"));
}

/// Each family by rising spin, a row for each type.
fn table(families: &[&SteadyFamilyDocument]) -> String {
    let mut table = Table::new(&["branch", "from rpm", "to rpm", "type", "stable", "axis there"]);
    let begins = families.iter().flat_map(|family| &family.stretches).filter_map(|stretch| stretch.from.as_ref());
    let spins = Spins::new(begins.map(|from| from.spin));
    for family in families {
        for (number, stretch) in family.stretches.iter().enumerate() {
            let next = family.stretches.get(number + 1).and_then(|next| next.from.as_ref());
            let start = match (number, family.start) {
                (0, SteadyStart::Fold) => " (fold)",
                (0, SteadyStart::Fork) => " (fork)",
                _ => "",
            };
            let [from, to] = [stretch.from.as_ref(), next].map(|place| place.map(|place| place.spin));
            let [from, to] = [spins.text(from, "0"), spins.text(to, "inf")];
            let axis = stretch.from.as_ref().map(|place| place.axis).or(family.slow_axis);
            table.row([
                if number == 0 { family.branch.clone() } else { String::new() },
                format!("{from}{start}"),
                to,
                stretch.stability.word().to_owned(),
                stretch.stable.word().to_owned(),
                axis.map_or_else(String::new, vector),
            ]);
        }
        table.row(["", "inf", "", "", ""].map(str::to_owned).into_iter().chain([vector(family.fast_axis)]));
    }
    table.text()
}

/// Spins in rpm as they are printed: those that differ do so in their digits, too.
pub struct Spins(Vec<(f64, String)>);

impl Spins {
    /// In any order.
    pub fn new(spins: impl Iterator<Item = SpinDocument>) -> Self {
        let mut rpm: Vec<f64> = spins.map(|spin| spin.rpm).collect();
        rpm.sort_by(f64::total_cmp);
        rpm.dedup();
        let texts = all_apart(&rpm, 8);
        Self(rpm.into_iter().zip(texts).collect())
    }

    /// One of them, or a word where there is none.
    pub fn text(&self, spin: Option<SpinDocument>, none: &str) -> String {
        let text = |spin: SpinDocument| {
            let place = self.0.binary_search_by(|(rpm, _)| rpm.total_cmp(&spin.rpm));
            place.map_or_else(|_absent| significant(spin.rpm, 8), |place| self.0[place].1.clone())
        };
        spin.map_or_else(|| none.to_owned(), text)
    }
}

fn vector(v: [f64; 3]) -> String {
    let [x, y, z] = v.map(|x| fixed(x, 4));
    format!("({x:>7}, {y:>7}, {z:>7})")
}

/// What the table's words mean.
fn legend(report: &mut Report, families: &[&SteadyFamilyDocument]) {
    let mut listed: Vec<&str> = Vec::new();
    for family in families {
        if listed.contains(&family.branch.as_str()) {
            continue;
        }
        listed.push(&family.branch);
        let axes = match family.axes {
            Multiplicity::Points(2) => ": two axes, each the other's mirror image",
            Multiplicity::Circle => ": a circle of axes, represented by one of them",
            _ => "",
        };
        report.line(format!("{}: {}{axes}", family.branch, family.branch_name));
    }
    let has_stretch = |stable: Verdict| families.iter().any(|f| f.stretches.iter().any(|found| found.stable == stable));
    if has_stretch(Verdict::Arnold) {
        let own = families.iter().flat_map(|family| family.stretches.iter().map(|found| (&family.branch, found)));
        let isolated =
            own.flat_map(|(branch, found)| found.isolated.iter().flatten().map(|one| (branch.clone(), *one)));
        exceptions(report, isolated);
    }
    if has_stretch(Verdict::Spectrum) {
        report.line(
            "spectrally only: no eigenvalue grows; `bifdiag critical --spin` says whether it is stable at a given spin",
        );
    }
    let has = |start| families.iter().any(|family| family.start == start);
    if has(SteadyStart::Fold) {
        report.line("fold: at this spin steady axes appear in one place; just below it they do not exist");
    }
    if has(SteadyStart::Fork) {
        report.line("fork: at this spin the axes leave another steady axis");
    }
}

/// The isolated spins at which Arnold's theorem does not apply, each with the family or axis that it belongs to.
pub fn exceptions(report: &mut Report, isolated: impl Iterator<Item = (String, IsolatedSpinDocument)>) {
    let mut lines: Vec<String> = Vec::new();
    let isolated: Vec<(String, IsolatedSpinDocument)> = isolated.collect();
    for (name, IsolatedSpinDocument { spin, kind, verdict, why }) in &isolated {
        let spins = Spins::new(isolated.iter().filter(|(of, _)| of == name).map(|(_, one)| one.spin));
        let line = format!("  {name}: {} rpm {}", spins.text(Some(*spin), ""), words::exception(*kind, *verdict, *why));
        // Both axes of a pair have the same.
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    if lines.is_empty() {
        report.line("by Arnold's theorem: at each of these spins");
    } else {
        report.line("by Arnold's theorem; spins at which its usual conditions fail:");
        for line in lines {
            report.line(line);
        }
    }
}

/// How many axes there are, in words.
fn counts(document: &SteadySpinsDocument, is_weightless: bool) -> String {
    // At rest without weight every axis is one.
    let spin = if is_weightless { "spin but 0" } else { "spin" };
    let spins = Spins::new(document.counts.iter().filter_map(|count| count.from));
    let list = document.counts.iter().enumerate().map(|(number, count)| {
        let circles = match count.circles {
            0 => String::new(),
            1 => " and a circle".to_owned(),
            more => format!(" and {more} circles"),
        };
        let next = document.counts.get(number + 1).and_then(|next| next.from);
        let until = match (number, next) {
            (0, None) => format!(" at every {spin}"),
            (0, Some(next)) => format!(" below {} rpm", spins.text(Some(next), "")),
            (_, Some(next)) => format!(" between that and {} rpm", spins.text(Some(next), "")),
            (_, None) => " at faster spins".to_owned(),
        };
        format!("{}{circles}{until}", count.axes)
    });
    format!("number of steady axes, counting each end that points up: {}", list.collect::<Vec<_>>().join(", "))
}
