//! `bifdiag find`: a body and a point that show a wanted thing.

use std::ops::ControlFlow;

use bifdiag_body::{Number, ParseNumberError};
use bifdiag_documents::CommandLine;
use bifdiag_documents::words::counted;
use bifdiag_schema::{Accuracy, FindDocument};
use bifdiag_survey::search::{SearchDomain, SearchOptions, Target, find};
use clap::Args;

use super::export::answer;
use super::failure::Failure;
use super::input::accuracy;
use super::terminal::{Progress, Report, significant};

pub const FIND_EXAMPLES: &str = "\
Examples:
  bifdiag find --type M4
  bifdiag find --circles 2 --poles 1 --physical --json
  bifdiag find --signature T2+S2
  bifdiag find --critical-points 8 --samples 20000

If a built-in witness has the type, it is printed at once; --search, --seed and --all look for another. If nothing is \
found (exit status 1), the answer says how many bodies were tried and, with --critical-points, how close the best one \
came. Where a theorem shows that none exists, the answer says so (exit status 0).";

/// `bifdiag find`.
#[derive(Debug, Args)]
pub struct FindArguments {
    /// Find a section such as M4, or a component of U with circles and poles such as k3n1
    #[arg(long = "type", value_name = "TYPE", help_heading = "Target")]
    #[arg(conflicts_with_all = ["circles", "poles", "signature", "critical_points"])]
    pub kind: Option<String>,
    /// Find a component of U with K boundary circles
    #[arg(long, value_name = "K", help_heading = "Target")]
    #[arg(conflicts_with_all = ["signature", "critical_points"])]
    pub circles: Option<u32>,
    /// Find a component of U with N poles
    #[arg(long, value_name = "N", help_heading = "Target", value_parser = clap::value_parser!(u32).range(0..=2))]
    #[arg(conflicts_with_all = ["signature", "critical_points"])]
    pub poles: Option<u32>,
    /// Find a region with these sections
    #[arg(long, value_name = "S2+T2", help_heading = "Target", conflicts_with = "critical_points")]
    pub signature: Option<String>,
    /// Find at least N isolated relative equilibria at one l
    #[arg(long, value_name = "N", help_heading = "Target")]
    pub critical_points: Option<u32>,
    /// Only physical bodies: A_i + A_j > A_k, or equality and r_k = 0
    #[arg(long, help_heading = "Work")]
    pub physical: bool,
    /// Only bodies whose largest moment is at most R times the smallest
    #[arg(long, value_name = "R", default_value_t = 10.0, help_heading = "Work", value_parser = moment_ratio, hide_short_help = true)]
    pub moment_ratio: f64,
    /// Search even if a built-in witness is known
    #[arg(long, help_heading = "Work", hide_short_help = true)]
    pub search: bool,
    /// Draw at most N bodies
    #[arg(long, value_name = "N", default_value_t = 20_000, help_heading = "Work")]
    #[arg(value_parser = clap::value_parser!(u64).range(1..1 << 53))]
    pub samples: u64,
    /// Draw all N bodies, even after a match; implies --search
    #[arg(long, help_heading = "Work", hide_short_help = true)]
    pub all: bool,
    /// Seed of the sequence of bodies (default: 0); implies --search
    #[arg(long, value_name = "N", help_heading = "Work", hide_short_help = true)]
    pub seed: Option<u64>,
    /// Required accuracy of the answers
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work", hide_short_help = true)]
    pub accuracy: Accuracy,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

fn moment_ratio(text: &str) -> Result<f64, String> {
    let ratio: Number = text.parse().map_err(|error: ParseNumberError| error.to_string())?;
    let ratio = ratio.to_f64();
    if ratio >= 1.0 { Ok(ratio) } else { Err("a ratio is a number of 1 or more, such as 10".to_owned()) }
}

pub fn run(arguments: &FindArguments, quiet: bool) -> Result<(), Failure> {
    let target = target(arguments)?;
    let document = search(arguments, &target, quiet);
    answer(arguments.json, &document, || report(&document))?;
    if document.found || document.exists == Some(false) {
        return Ok(());
    }
    let tried = counted(document.tried, "body", "bodies");
    Err(Failure::work(format!("{} among {tried}", not_found(&document.sought))))
}

fn target(arguments: &FindArguments) -> Result<Target, Failure> {
    if let Some(kind) = &arguments.kind {
        return Target::of_type(kind).map_err(|error| Failure::input(format!("--type: {error}")));
    }
    if let Some(signature) = &arguments.signature {
        return Target::of_signature(signature).map_err(|error| Failure::input(format!("--signature: {error}")));
    }
    if let Some(count) = arguments.critical_points {
        if count < 3 {
            let why = "every body has a minimum and a maximum of U_l at every l; give 3 or more";
            return Err(Failure::input(format!("--critical-points {count}: {why}")));
        }
        return Ok(Target::CriticalPoints(count));
    }
    if arguments.circles.is_none() && arguments.poles.is_none() {
        return Err(Failure::input(
            "no target is given; use --type M4, --circles 3 --poles 1, --signature S2+T2 or --critical-points 8",
        ));
    }
    Ok(Target::Component { circles: arguments.circles, poles: arguments.poles })
}

/// What the library finds.
fn search(arguments: &FindArguments, target: &Target, quiet: bool) -> FindDocument {
    let options = SearchOptions {
        domain: SearchDomain { physical: arguments.physical, moment_ratio: arguments.moment_ratio },
        samples: arguments.samples,
        all: arguments.all,
        seed: arguments.seed.unwrap_or_default(),
        accuracy: arguments.accuracy,
    };
    let progress = Progress::new(0, arguments.samples, "bodies", quiet);
    let mut watch = |bodies| {
        progress.add(bodies);
        ControlFlow::Continue(())
    };
    let searches = arguments.search || arguments.all || arguments.seed.is_some();
    let known = if searches { Vec::new() } else { bifdiag_documents::shipped_witnesses() };
    let found = find(target, &known, &options, &mut watch);
    progress.finish();
    for (values, error) in &found.refused {
        tracing::debug!("the body {values:?} is no witness: {error}");
    }
    bifdiag_documents::find(target, &found, command(arguments))
}

/// The search as it was asked for.
fn command(arguments: &FindArguments) -> CommandLine {
    let usual = |ratio: &f64| *ratio != SearchOptions::default().domain.moment_ratio;
    CommandLine::new("find")
        .option_if("type", arguments.kind.as_ref())
        .option_if("circles", arguments.circles)
        .option_if("poles", arguments.poles)
        .option_if("signature", arguments.signature.as_ref())
        .option_if("critical-points", arguments.critical_points)
        .flag("physical", arguments.physical)
        .option_if("moment-ratio", Some(arguments.moment_ratio).filter(usual))
        .flag("search", arguments.search)
        .option("samples", arguments.samples)
        .flag("all", arguments.all)
        .option_if("seed", arguments.seed)
        .option_if("accuracy", bifdiag_documents::accuracy_option(arguments.accuracy))
}

fn report(document: &FindDocument) -> String {
    let mut report = Report::default();
    if let Some(why) = &document.why {
        let verb = if is_plural(&document.sought) { "do" } else { "does" };
        report.line(format!("{} {verb} not exist for r ≠ 0: {why}", document.sought));
        return report.text();
    }
    let Some(witness) = &document.witness else {
        report.line(format!("{}: {}", not_found(&document.sought), tried(document)));
        if let Some(nearest) = &document.nearest {
            let list = |values: [f64; 3]| values.map(|x| x.to_string()).join(",");
            report.line(format!(
                "nearest: {} missing with --A {} --r {}",
                significant(nearest.missing, 6),
                list(nearest.moments),
                list(nearest.center)
            ));
        }
        report.line("this does not show that none exists");
        return report.text();
    };
    let body = format!("--A {} --r {}", witness.body.moments.join(","), witness.body.center.join(","));
    let is = if is_plural(&document.sought) { "are" } else { "is" };
    let command = if witness.critical_points.is_some() {
        format!("critical {body} --l {}", witness.l)
    } else {
        format!("classify {body} --h={} --l {}", witness.h, witness.l)
    };
    report.line(format!("{} {is} shown by", document.sought));
    report.line(format!("  bifdiag {command}"));
    if witness.critical_points.is_some() {
        report.line(format!("  at h = {}:", witness.h));
    }
    for component in &witness.components {
        report.line(format!(
            "  U: {:8} poles: {:4} section: {}",
            component.accessible_region,
            component.poles.as_ref().map_or_else(|| "-".to_owned(), |poles| poles.join("")),
            component.section.as_deref().unwrap_or("-")
        ));
    }
    if let Some(count) = witness.critical_points {
        report.line(format!(
            "  {} at this l",
            counted(count, "isolated relative equilibrium", "isolated relative equilibria")
        ));
    }
    report.line(format!(
        "distance in h to the nearest curve ({}): {}",
        witness.margin.nearest,
        significant(witness.margin.h, 6)
    ));
    report.line(format!("components of U confirmed by the {}", document.verified_by.join(" and the ")));
    report.line(tried(document));
    report.text()
}

/// True if what is sought has a plural name.
fn is_plural(sought: &str) -> bool {
    sought.ends_with("relative equilibria")
}

fn not_found(sought: &str) -> String {
    let verb = if is_plural(sought) { "were" } else { "was" };
    format!("{sought} {verb} not found")
}

/// What was examined.
fn tried(document: &FindDocument) -> String {
    let FindDocument { drawn, tried, showing, .. } = *document;
    if drawn == 0 {
        return "a built-in witness".to_owned();
    }
    let bodies = counted(drawn, "body", "bodies");
    let it = match (document.found, showing) {
        (false, 1) => "seemed to show it, which was not confirmed",
        (false, 2..) => "seemed to show it, none of which was confirmed",
        (_, 1) => "shows it",
        _ => "show it",
    };
    let text = match tried {
        0 if drawn == 1 => {
            format!("{bodies} drawn, but it was not within the limits or not decided, so it was not tried")
        }
        0 => format!("{bodies} drawn, but none of them was within the limits and decided, so none was tried"),
        1 if drawn == 1 => {
            format!(
                "one body tried, {}",
                if showing == 1 { format!("which {it}") } else { "which does not show it".to_owned() }
            )
        }
        _ if tried == drawn => format!("{bodies} tried, {showing} of them {it}"),
        _ => format!(
            "{bodies} drawn, {tried} of them tried (the rest is outside the limits or undecided), {showing} {it}"
        ),
    };
    let is_changed = document.found && showing == 0;
    let changed = if tried == 1 { "the one tried" } else { "those that came nearest" };
    text + &if is_changed { format!("; the witness was found by changing {changed}") } else { String::new() }
}
