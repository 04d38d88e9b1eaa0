//! `bifdiag orbit --proved`: enclosures of the motion.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use bifdiag_body::Number;
use bifdiag_documents::{EnclosureRow, ProofAsked, enclosure_rows, enclosures, proved_motion};
use bifdiag_enclosure::orbit::{Ends, ProofEnd, ProofOptions, ProvedMotion, prove};
use bifdiag_schema::ProvedMotionDocument;
use dashu_ratio::RBig;

use super::arguments::Problem;
use crate::cli::export::{Columns, DataFormat, DataTarget, FileSet, Values, answer};
use crate::cli::failure::Failure;
use crate::cli::input::{head, motion_units};
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Progress, Report, Table, Timings, bound, counted, fixed, print, significant};

pub fn run(problem: &Problem<'_>, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let Problem { arguments, subject, times, .. } = problem;
    let asked = asked(problem)?;
    let exact_times = times.iter().map(|time| number(*time).map(|time| time.value().clone()));
    let exact_times = exact_times.collect::<Result<Vec<RBig>, Failure>>()?;
    let stop = Arc::new(AtomicBool::new(false));
    let stopping = Arc::clone(&stop);
    let work = stoppable(move || stopping.store(true, Ordering::Relaxed));
    let steps = AtomicU64::new(0);
    let options = ProofOptions { digits: arguments.digits, bound: arguments.bound, stop: &stop, steps: &steps };
    let progress = Progress::open("steps proved", quiet);
    let start = asked.start();
    let proof = || progress.watching(&steps, || prove(&subject.body, &start, &exact_times, &options));
    let motion = timings.stage("proof", proof);
    let interrupted = !work.over();
    let mut document = proved_motion(subject, &asked, times, &motion);
    let mut files = FileSet::new(Path::new("."));
    match &arguments.data {
        Some(DataTarget::Stdout) => {
            return finish(&document, &motion, problem, print(DataFormat::Csv.bytes(&columns(&document, &motion)?)?));
        }
        Some(DataTarget::File { path, format }) if !interrupted => {
            files.add_at(path, format.bytes(&columns(&document, &motion)?)?);
        }
        Some(DataTarget::File { .. }) => {}
        None => document.enclosures = Some(enclosures(&motion)),
    }
    let written = timings.stage("files", || files.write())?;
    let answered = answer(arguments.json, &document, || text(problem, &document, &motion, &written));
    drop(work);
    finish(&document, &motion, problem, answered)
}

/// An answer with times missing is an answer, but not the one that was asked for.
fn finish(
    document: &ProvedMotionDocument,
    motion: &ProvedMotion,
    problem: &Problem<'_>,
    answered: Result<(), Failure>,
) -> Result<(), Failure> {
    answered?;
    let (found, all) = (motion.samples.len(), problem.times.len());
    let count =
        format!("{found} of {} {} enclosed", counted(all, "time", "times"), if found == 1 { "is" } else { "are" });
    match motion.end {
        None => Ok(()),
        Some(ProofEnd::Wide) => Err(Failure::work(format!("{count}: {}", document.notes.join("; ")))),
        Some(ProofEnd::Interrupted) => Err(Failure::work(format!("interrupted: {count}; no file was written"))),
    }
}

/// A double as the decimal that is written for it.
fn number(x: f64) -> Result<Number, Failure> {
    Number::from_f64(x).map_err(Failure::input)
}

fn numbers(v: [f64; 3]) -> Result<[Number; 3], Failure> {
    let [x, y, z] = v;
    Ok([number(x)?, number(y)?, number(z)?])
}

/// What was given, exactly; what was computed from angles or from a point of the section, to the decimals of a double.
fn asked(problem: &Problem<'_>) -> Result<ProofAsked, Failure> {
    let Problem { arguments, subject, start, .. } = problem;
    let gamma = match &arguments.gamma {
        Some(gamma) => gamma.given.0.clone(),
        None => numbers(start.gamma)?,
    };
    let a = subject.body.moments();
    let by_inertia = |l: &[Number; 3]| std::array::from_fn(|i| Number::from_rational(l[i].value() / a[i].value()));
    let omega = match (&arguments.omega, &arguments.l_vector) {
        (Some(omega), _) => omega.0.clone(),
        (None, Some(l)) => by_inertia(&l.0),
        (None, None) => by_inertia(&numbers(start.l)?),
    };
    Ok(ProofAsked {
        gamma,
        omega,
        phi: number(arguments.start_phi())?,
        times: arguments.times.to_string(),
        digits: arguments.digits,
        bound: arguments.bound,
    })
}

/// One row for each time, doubles rounded outward; `meta` is the document on one line.
fn columns(document: &ProvedMotionDocument, motion: &ProvedMotion) -> Result<Columns, Failure> {
    let [lower, upper] = [0, 1].map(|side| enclosure_rows(motion, side));
    let gamma = |rows: &[EnclosureRow]| Values::vectors(rows.iter().map(|row| row.gamma));
    let omega = |rows: &[EnclosureRow]| Values::vectors(rows.iter().map(|row| row.omega));
    let rotation = |rows: &[EnclosureRow], k: usize| Values::vectors(rows.iter().map(|row| row.rotation[k]));
    let quaternion = |rows: &[EnclosureRow]| Values::quaternions(rows.iter().map(|row| row.quaternion));
    let columns = [
        ("time", Values::floats(document.times.iter().copied())),
        ("gamma_lo", gamma(&lower)),
        ("gamma_hi", gamma(&upper)),
        ("omega_lo", omega(&lower)),
        ("omega_hi", omega(&upper)),
        ("rotation1_lo", rotation(&lower, 0)),
        ("rotation1_hi", rotation(&upper, 0)),
        ("rotation2_lo", rotation(&lower, 1)),
        ("rotation2_hi", rotation(&upper, 1)),
        ("rotation3_lo", rotation(&lower, 2)),
        ("rotation3_hi", rotation(&upper, 2)),
        ("attitude_lo", quaternion(&lower)),
        ("attitude_hi", quaternion(&upper)),
    ];
    Ok(Columns::new(columns, document)?)
}

/// Times that are listed.
const LISTED: usize = 40;

fn text(problem: &Problem<'_>, document: &ProvedMotionDocument, motion: &ProvedMotion, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(&problem.subject, &mut report);
    report.line("");
    if written.is_empty() && !motion.samples.is_empty() {
        let middle = |[lo, hi]: &Ends| ((lo + hi) / RBig::from(2)).to_f64().value();
        let vector = |v: &[Ends; 3]| {
            let [x, y, z] = v.each_ref().map(|ends| fixed(middle(ends), 8));
            format!("({x:>11}, {y:>11}, {z:>11})")
        };
        let mut table = Table::new(&["time", "gamma", "omega", "width"]);
        for (time, sample) in document.times.iter().zip(&motion.samples).take(LISTED) {
            table.row([significant(*time, 6), vector(&sample.gamma), vector(&sample.omega), bound(sample.width(), 2)]);
        }
        report.line(table.text());
        if motion.samples.len() > LISTED {
            report.line(format!("… and {} more; --data FILE.csv writes all", motion.samples.len() - LISTED));
        }
        report.line(super::report::FRAME);
        motion_units(&problem.subject, &mut report);
        report.line("");
    }
    // Where the proof began anew with more bits and no time was reached, there is nothing to say of these.
    if !motion.samples.is_empty() {
        report.line(format!(
            "widest enclosure: {}, of gamma, omega, rotation and quaternion; {} bits, {}",
            bound(document.widest, 2),
            document.bits,
            counted(document.steps, "step", "steps")
        ));
        report.line("The ends of each interval are in --json and --data; the table shows middles.");
    }
    let arguments = problem.arguments;
    if arguments.euler.is_some() || arguments.theta.is_some() || arguments.start_phi() != 0.0 {
        let start = &document.start;
        report.line(format!(
            "proved from the start rounded to doubles: gamma = ({}), omega = ({}), phi = {}",
            start.gamma.join(", "),
            start.omega.join(", "),
            start.phi
        ));
    }
    for note in &document.notes {
        report.line(note);
    }
    report.written(written);
    report.text()
}
