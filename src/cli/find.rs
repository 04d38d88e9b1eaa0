//! `bifdiag find`: a body and a point that show a wanted thing.

use clap::Args;
use rayon::prelude::*;
use schema::{Accuracy, SCHEMA_VERSION};
use schema::{FindDocument, NearestDocument};
use survey::search::{Domain, Score, Seen, Target, Witness, improve, look, sample, witness};

use super::export::answer;
use super::failure::Failure;
use super::input::AccuracyArgument;
use super::scan::ScanInput;
use super::terminal::{Progress, Report, significant};

pub const FIND_EXAMPLES: &str = "\
Examples:
  bifdiag find --type M4
  bifdiag find --circles 2 --poles 1 --physical --json
  bifdiag find --signature T2+S2
  bifdiag find --critical-points 8 --samples 20000

Nothing found means that so many bodies were tried, and how near the best one came; never that there is none.";

/// Bodies between two looks at what was found.
const BLOCK: u64 = 2048;

/// Candidates that are improved.
const CANDIDATES: usize = 6;

/// Steps of each improvement.
const STEPS: u64 = 150;

/// `bifdiag find`.
#[derive(Debug, Args)]
pub struct FindArguments {
    /// A section such as M4, or circles and poles of a component of U such as k3n1
    #[arg(long = "type", value_name = "TYPE", help_heading = "What is sought")]
    #[arg(conflicts_with_all = ["circles", "poles", "signature", "critical_points"])]
    pub kind: Option<String>,
    /// A component of U with K boundary circles
    #[arg(long, value_name = "K", help_heading = "What is sought")]
    #[arg(conflicts_with_all = ["signature", "critical_points"])]
    pub circles: Option<u32>,
    /// A component of U with N poles
    #[arg(long, value_name = "N", help_heading = "What is sought", value_parser = clap::value_parser!(u32).range(0..=2))]
    #[arg(conflicts_with_all = ["signature", "critical_points"])]
    pub poles: Option<u32>,
    /// A region with these sections
    #[arg(long, value_name = "S2+T2", help_heading = "What is sought", conflicts_with = "critical_points")]
    pub signature: Option<String>,
    /// N relative equilibria at one l, or more
    #[arg(long, value_name = "N", help_heading = "What is sought")]
    pub critical_points: Option<u32>,
    /// Only bodies that exist: A_i + A_j >= A_k
    #[arg(long, help_heading = "Work")]
    pub physical: bool,
    /// Only bodies whose largest moment is at most R times the smallest
    #[arg(long, value_name = "R", default_value_t = 10.0, help_heading = "Work", value_parser = moment_ratio)]
    pub moment_ratio: f64,
    /// The most bodies that are tried
    #[arg(long, value_name = "N", default_value_t = 20_000, help_heading = "Work")]
    #[arg(value_parser = clap::value_parser!(u64).range(1..1 << 53))]
    pub samples: u64,
    /// Try all of them, although something was found before
    #[arg(long, help_heading = "Work")]
    pub all: bool,
    /// Where the sequence of bodies starts
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Work")]
    pub seed: u64,
    /// What the answers must be worth
    #[arg(long, value_enum, default_value = "standard", help_heading = "Work")]
    pub accuracy: AccuracyArgument,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

fn moment_ratio(text: &str) -> Result<f64, String> {
    let ratio = text.parse::<f64>().ok().filter(|ratio| *ratio >= 1.0 && ratio.is_finite());
    ratio.ok_or_else(|| "a ratio is a number from 1 on, such as 10".to_owned())
}

/// A body and what was seen of it.
type Candidate = ([[f64; 3]; 2], Seen);

pub fn run(arguments: &FindArguments, quiet: bool) -> Result<(), Failure> {
    let target = target(arguments)?;
    let document = search(arguments, &target, quiet);
    Ok(answer(arguments.json, &document, || report(&document))?)
}

fn target(arguments: &FindArguments) -> Result<Target, ScanInput> {
    let wrong = |option: &str, error: &dyn std::fmt::Display| ScanInput::Find(format!("--{option}: {error}"));
    if let Some(kind) = &arguments.kind {
        return Target::of_type(kind).map_err(|error| wrong("type", &error));
    }
    if let Some(signature) = &arguments.signature {
        return Target::of_signature(signature).map_err(|error| wrong("signature", &error));
    }
    if let Some(count) = arguments.critical_points {
        return Ok(Target::CriticalPoints(count));
    }
    if arguments.circles.is_none() && arguments.poles.is_none() {
        let text = "nothing says what is sought; give --type M4, --circles 3 --poles 1, --signature S2+T2 or \
                    --critical-points 8";
        return Err(ScanInput::Find(text.to_owned()));
    }
    Ok(Target::Component { circles: arguments.circles, poles: arguments.poles })
}

/// Sampling, then improvement of the best; the same for any number of threads.
fn search(arguments: &FindArguments, target: &Target, quiet: bool) -> FindDocument {
    let progress = Progress::new(0, arguments.samples, "bodies", quiet);
    let domain = Domain { physical: arguments.physical, moment_ratio: arguments.moment_ratio };
    let mut best: Vec<Candidate> = Vec::new();
    let (mut tried, mut showing) = (0, 0);
    while tried < arguments.samples {
        let to = arguments.samples.min(tried + BLOCK);
        let found: Vec<Candidate> = (tried..to)
            .into_par_iter()
            .map(|n| {
                let values = sample(n, arguments.seed, arguments.physical);
                (values, look(values, target, &domain))
            })
            .collect();
        showing += found.iter().filter(|(_, seen)| matches!(seen.score, Score::Shown(_))).count() as u64;
        best.extend(found.into_iter().filter(|(_, seen)| seen.score != Score::Nothing));
        // A stable sort: of equal ones the first stays first.
        best.sort_by(|p, q| q.1.score.compare(p.1.score));
        best.truncate(CANDIDATES);
        progress.add(to - tried);
        tried = to;
        if showing > 0 && !arguments.all {
            break;
        }
    }
    progress.finish();
    let mut improved: Vec<Candidate> = best
        .par_iter()
        .map(|(values, _)| {
            let values = improve(*values, target, &domain, STEPS);
            (values, look(values, target, &domain))
        })
        .collect();
    improved.extend(best);
    improved.sort_by(|p, q| q.1.score.compare(p.1.score));
    let accuracy = arguments.accuracy.level();
    let found = improved.iter().find_map(|(values, _)| confirmed(*values, target, accuracy));
    let mut methods = vec!["merge tree".to_owned(), "latitude sweep".to_owned()];
    if accuracy == Accuracy::Certified {
        methods.push("certified atlas".to_owned());
    }
    let nearest = match (&found, improved.first()) {
        (None, Some((values, seen))) => Some(nearest(*values, seen)),
        _ => None,
    };
    FindDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        found: found.is_some(),
        sought: target.to_string(),
        verified_by: if found.is_some() { methods } else { Vec::new() },
        witness: found.as_ref().map(documents::witness),
        tried,
        showing,
        nearest,
    }
}

/// A witness, or a warning why a candidate is none.
fn confirmed(values: [[f64; 3]; 2], target: &Target, accuracy: Accuracy) -> Option<Witness> {
    match witness(values, target, accuracy.into()) {
        Ok(witness) => Some(witness),
        Err(error) => {
            tracing::debug!("the body {values:?} is no witness: {error}");
            None
        }
    }
}

fn nearest([moments, center]: [[f64; 3]; 2], seen: &Seen) -> NearestDocument {
    let missing = match seen.score {
        Score::Near(missing) => missing,
        Score::Shown(_) | Score::Nothing => 0.0,
    };
    let [h, l] = seen.at.map_or([None; 2], |[h, l]| [Some(h), Some(l)]);
    NearestDocument { moments, center, h, l, missing }
}

fn report(document: &FindDocument) -> String {
    let mut report = Report::default();
    let tried = format!("{} bodies tried, {} of them show it", document.tried, document.showing);
    let Some(witness) = &document.witness else {
        report.line(format!("{} was not found: {tried}", document.sought));
        if let Some(nearest) = &document.nearest {
            let list = |values: [f64; 3]| values.map(|x| x.to_string()).join(",");
            report.line(format!(
                "nearest: {} missing with --A {} --r {}",
                significant(nearest.missing, 6),
                list(nearest.moments),
                list(nearest.center)
            ));
        }
        report.line("this does not say that there is none");
        return report.text();
    };
    report.line(format!("{} is shown by", document.sought));
    report.line(format!(
        "  bifdiag classify --A {} --r {} --h={} --l {}",
        witness.moments.join(","),
        witness.center.join(","),
        witness.h,
        witness.l
    ));
    for component in &witness.components {
        report.line(format!(
            "  U: {:8} poles: {:4} section: {}",
            component.accessible_region,
            component.poles.as_ref().map_or_else(|| "-".to_owned(), |poles| poles.join("")),
            component.section.as_deref().unwrap_or("-")
        ));
    }
    if let Some(count) = witness.critical_points {
        report.line(format!("  {count} relative equilibria at this l"));
    }
    report.line(format!(
        "distance in h to the nearest curve ({}): {}",
        witness.margin.nearest,
        significant(witness.margin.h, 6)
    ));
    report.line(format!("confirmed by the {}", document.verified_by.join(" and the ")));
    report.line(tried);
    report.text()
}
