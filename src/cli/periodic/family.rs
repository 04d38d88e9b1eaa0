//! `bifdiag periodic family`: the families of periodic orbits that begin at relative equilibria.

use std::path::{Path, PathBuf};

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_periodic::catalogue::Catalogue;
use bifdiag_periodic::family::{Family, FamilyError, FamilyOptions, Held};
use bifdiag_plot::{Theme, draw_periods};
use bifdiag_schema::{
    FamilyEnd, FamilyEndingDocument, OrbitEventKind, PeriodicFamiliesDocument, PeriodicFamilyDocument,
};
use clap::Args;

use crate::cli::export::{FileSet, PictureArguments, PictureFormat, answer};
use crate::cli::failure::{Failure, failed, no_such_curve};
use crate::cli::input::{BodyArguments, head, motion_units, values};
use crate::cli::terminal::{Progress, Report, Table, Timings, counted, significant};

pub const FAMILY_EXAMPLES: &str = "\
Examples:
  bifdiag periodic family --body paper --l 1.5
  bifdiag periodic family --body paper --from G2.1 --l 1.5 --branches --json
  bifdiag periodic family --body paper --from G2.1 --h 1 --out families

From each imaginary pair of eigenvalues of an isolated relative equilibrium a family of periodic orbits begins, if no other pair \
is a multiple of it (Lyapunov's centre theorem). It is followed at fixed l or fixed h; folds, doublings, triplings and crossings \
with other families are located on the way.";

/// `bifdiag periodic family`.
#[derive(Debug, Args)]
pub struct FamilyArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Start at the equilibria on this curve, by its id in `bifdiag atlas` (default: all curves)
    #[arg(long, value_name = "CURVE", help_heading = "Family")]
    pub from: Option<String>,
    /// Vertical angular momentum, held fixed
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number, help_heading = "Family")]
    pub momentum: Option<Number>,
    /// Instead of l: the energy, held fixed
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number, help_heading = "Family")]
    #[arg(conflicts_with = "momentum")]
    pub energy: Option<Number>,
    /// Follow each family for at most N orbits
    #[arg(long, value_name = "N", default_value_t = 200, help_heading = "Family")]
    pub members: usize,
    /// Also follow the families that begin at doublings, triplings and crossings
    #[arg(long, help_heading = "Family")]
    pub branches: bool,
    /// Draw the periods to DIR/periodic.svg
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Print the families as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// Significant digits.
pub const DIGITS: usize = 6;
/// The message if the work fails.
pub const NOT_FOUND: &str = "the families could not be followed";

pub fn run(arguments: &FamilyArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let id = arguments.from.as_deref().map(values::id);
    let (held, value) = match (&arguments.momentum, &arguments.energy) {
        (Some(l), _) => (Held::Momentum, l),
        (None, Some(h)) => (Held::Energy, h),
        (None, None) => {
            return Err(Failure::input(
                "--l is missing: the momentum of the family, such as --l 1.5, or --h, its energy",
            ));
        }
    };
    if arguments.members == 0 {
        return Err(Failure::input("--members 0: a family has at least one orbit"));
    }
    let catalogue = Catalogue::new(&subject.body).map_err(failed(NOT_FOUND))?;
    let equilibria = starts(&catalogue, held, value, id.as_deref())?;
    let monitor = Monitor::default();
    let options = FamilyOptions { held, members: arguments.members, branches: arguments.branches, monitor: &monitor };
    let follow = |equilibrium: Equilibrium| {
        let families = catalogue.families(&equilibrium, &options)?;
        Ok((equilibrium, families))
    };
    let work = || equilibria.into_iter().map(follow).collect::<Result<Vec<(Equilibrium, Vec<Family>)>, FamilyError>>();
    let progress = Progress::open("orbits found", quiet);
    let found = timings.stage("families", || progress.watching(&monitor.orbits, work)).map_err(failed(NOT_FOUND))?;
    let mut command = subject.command("periodic family");
    if let Some(id) = &id {
        command = command.option("from", id);
    }
    let name = if held == Held::Momentum { "l" } else { "h" };
    let members = arguments.members.to_string();
    command = command.option(name, value.text()).option("members", members).flag("branches", arguments.branches);
    let document = bifdiag_documents::periodic_families(&subject, command, (held, value.text()), &found);
    let written = match &arguments.out {
        Some(directory) => drawn(&document, directory, timings)?,
        None => Vec::new(),
    };
    answer(arguments.json, &document, || text(&subject, &document, &written))
}

/// The equilibria at this l, or at this h one for each curve that reaches it; only those of one curve, if it is named.
pub fn starts(
    catalogue: &Catalogue<'_>,
    held: Held,
    value: &Number,
    id: Option<&str>,
) -> Result<Vec<Equilibrium>, Failure> {
    let curve = id.and_then(|id| catalogue.curves().into_iter().find(|name| name.to_string() == id));
    if let Some(id) = id
        && curve.is_none()
    {
        return Err(no_such_curve("--from", id, catalogue.curves()));
    }
    let found = catalogue.starts(held, value, curve).map_err(failed(NOT_FOUND))?;
    if found.is_empty() {
        let (name, text) = (if held == Held::Momentum { "l" } else { "h" }, value.text());
        let of = id.map_or_else(|| "the body".to_owned(), |id| format!("the curve {id}"));
        return Err(Failure::input(format!("--{name} {text}: {of} has no equilibrium there")));
    }
    Ok(found)
}

fn drawn(document: &PeriodicFamiliesDocument, directory: &Path, timings: &Timings) -> Result<Vec<PathBuf>, Failure> {
    let picture = timings.stage("picture", || draw_periods(document, Theme::Light))?;
    let mut files = FileSet::new(directory);
    files.remove_pictures("periodic");
    files.pictures("periodic", &picture, &PictureArguments::plain(PictureFormat::Svg), timings)?;
    files.write()
}

fn text(subject: &Subject, document: &PeriodicFamiliesDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let free = if document.fixed_l.is_some() { "h" } else { "l" };
    for family in &document.families {
        report.line("");
        let curve = family.curve.as_deref().unwrap_or("no curve");
        let side = side(family, &document.families);
        report.line(format!(
            "from {curve}{side} at h = {}, l = {}, frequency {}: {}, {}",
            significant(family.h, DIGITS),
            significant(family.l, DIGITS),
            significant(family.frequency, DIGITS),
            counted(family.members.len(), "orbit", "orbits"),
            ending(&family.end)
        ));
        if !family.members.is_empty() {
            report.line(table(family, free).text());
        }
        for event in &family.events {
            for branch in &event.branches {
                let count = counted(branch.members.len(), "orbit", "orbits");
                let place = significant(if free == "h" { event.h } else { event.l }, DIGITS);
                report.line(format!("  family from {free} = {place}: {count}, {}", ending(&branch.end)));
            }
        }
    }
    if document.families.iter().any(|family| !family.events.is_empty()) {
        report.line("two special orbits of the same kind between neighbouring orbits are missed");
    }
    report.line("");
    report.line(if document.families.is_empty() {
        "no family begins here: no equilibrium has a pair of imaginary eigenvalues"
    } else {
        "T period; crossings of P in a period; trace the sum of the two multipliers"
    });
    motion_units(subject, &mut report);
    report.written(written);
    report.text()
}

/// Which of a mirror pair of equilibria, equal in h and l, a family begins at: the side of the plane between them.
fn side(family: &PeriodicFamilyDocument, all: &[PeriodicFamilyDocument]) -> String {
    let is_image = |other: &&PeriodicFamilyDocument, k: usize| {
        other.curve == family.curve
            && (0..3).all(|i| other.gamma[i] == if i == k { -family.gamma[i] } else { family.gamma[i] })
    };
    let axis = (0..3).find(|&k| family.gamma[k] != 0.0 && all.iter().any(|other| is_image(&other, k)));
    axis.map_or_else(String::new, |k| {
        let sign = if family.gamma[k] > 0.0 { '>' } else { '<' };
        format!(" (γ{} {sign} 0)", k + 1)
    })
}

/// Rows of the text between two events.
const ROWS: usize = 6;

/// A selection of the orbits of a family, with its special ones.
fn table(family: &PeriodicFamilyDocument, free: &'static str) -> Table {
    let mut table = Table::new(&[free, "T", "trace", "stability", "crossings", "symmetric", "action", ""]);
    let every = family.members.len().div_ceil(ROWS * (family.events.len() + 1)).max(1);
    let mut events = family.events.iter().peekable();
    let last = family.members.len() - 1;
    let mut shown: Option<[String; 8]> = None;
    for (number, orbit) in family.members.iter().enumerate() {
        if number % every == 0 || number == last {
            let row = [
                significant(if free == "h" { orbit.h } else { orbit.l }, DIGITS),
                significant(orbit.period, DIGITS),
                significant(orbit.multipliers[0][0] + orbit.multipliers[1][0], DIGITS),
                orbit.stability.word().to_owned(),
                orbit.crossings.to_string(),
                if orbit.symmetric { "yes" } else { "no" }.to_owned(),
                significant(orbit.action, DIGITS),
                String::new(),
            ];
            // Near an equilibrium neighbouring rows may be equal in the digits printed.
            if shown.as_ref() != Some(&row) {
                table.row(row.clone());
            }
            shown = Some(row);
        }
        while let Some(event) = events.next_if(|event| event.after == number) {
            let place = if free == "h" { event.h } else { event.l };
            let words = match event.kind {
                OrbitEventKind::Fold => "fold",
                OrbitEventKind::Branch => "another family crosses",
                OrbitEventKind::Doubling => "doubling",
                OrbitEventKind::Tripling => "tripling",
            };
            let blank = || String::new();
            table.row([
                significant(place, DIGITS),
                significant(event.period, DIGITS),
                blank(),
                blank(),
                blank(),
                blank(),
                blank(),
                words.to_owned(),
            ]);
            shown = None;
        }
    }
    table
}

/// How a family ends.
fn ending(end: &FamilyEndingDocument) -> String {
    let curves = end.curves.join(", ");
    match end.kind {
        FamilyEnd::Equilibrium => format!("shrinks to an equilibrium of {curves}"),
        FamilyEnd::Separatrix => format!("ends at the separatrix of {curves}, T without bound"),
        FamilyEnd::Joined => "joins another family".to_owned(),
        FamilyEnd::Members => "goes on".to_owned(),
        FamilyEnd::Lost => "was followed no further".to_owned(),
        FamilyEnd::Circle => format!("runs along the circle {curves} ever more slowly, T without bound"),
        FamilyEnd::Resonant => "not begun: the other pair is a multiple of this one, or zero".to_owned(),
        FamilyEnd::NotIsolated => "not begun: the equilibrium is one of a circle or sphere of them".to_owned(),
    }
}
