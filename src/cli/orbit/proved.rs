//! `bifdiag orbit --proved`: enclosures of the motion.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag_body::Number;
use bifdiag_enclosure::orbit::{Ends, ProofEnd, ProofOptions, ProvedMotion, prove};
use bifdiag_enclosure::start::ExactStart;
use bifdiag_numbers::decimal;
use bifdiag_schema::{EnclosuresDocument, ExactStartDocument, ProvedMotionDocument};
use dashu_ratio::RBig;

use super::arguments::Problem;
use crate::cli::export::{Columns, DataFormat, DataTarget, FileSet, Values, answer};
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Report, Table, Timings, bound, print, significant};

/// The start as it is written: texts, from which the same command starts again.
struct Start {
    gamma: [Number; 3],
    omega: [Number; 3],
    phi: Number,
}

pub fn run(problem: &Problem<'_>, timings: &Timings) -> Result<(), Failure> {
    let arguments = problem.arguments;
    let start = start(problem)?;
    let exact = ExactStart {
        gamma: start.gamma.each_ref().map(|x| x.value().clone()),
        omega: start.omega.each_ref().map(|x| x.value().clone()),
        phi: start.phi.value().clone(),
    };
    let times = problem.times.iter().map(|time| number(*time).map(|time| time.value().clone()));
    let times = times.collect::<Result<Vec<RBig>, Failure>>()?;
    let stop = Arc::new(AtomicBool::new(false));
    let stopping = Arc::clone(&stop);
    let work = stoppable(move || stopping.store(true, Ordering::Relaxed));
    let options = ProofOptions { digits: arguments.digits, bound: arguments.bound, stop: &stop };
    let motion = timings.stage("proof", || prove(&problem.subject.body, &exact, &times, &options));
    let interrupted = !work.over();
    let mut document = document(problem, &start, &motion);
    let mut files = FileSet::new(Path::new("."));
    match &arguments.data {
        Some(DataTarget::Stdout) => {
            return finish(&motion, problem, print(DataFormat::Csv.bytes(&columns(&document, &motion)?)?));
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
    finish(&motion, problem, answered)
}

/// An answer with times missing is an answer, but not the one that was asked for.
fn finish(motion: &ProvedMotion, problem: &Problem<'_>, answered: Result<(), Failure>) -> Result<(), Failure> {
    answered?;
    let count = format!("{} of {} times are enclosed", motion.samples.len(), problem.times.len());
    match motion.end {
        None => Ok(()),
        Some(ProofEnd::Wide) => Err(Failure::work(format!("{count}: {}", reason(problem, motion)))),
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
fn start(problem: &Problem<'_>) -> Result<Start, Failure> {
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
    Ok(Start { gamma, omega, phi: number(arguments.start_phi())? })
}

fn texts(numbers: &[Number; 3]) -> [String; 3] {
    numbers.each_ref().map(|number| number.text().to_owned())
}

fn document(problem: &Problem<'_>, start: &Start, motion: &ProvedMotion) -> ProvedMotionDocument {
    let Problem { arguments, subject, times, .. } = problem;
    let line = subject.command("orbit").option("gamma", texts(&start.gamma).join(","));
    let line = line.option("omega", texts(&start.omega).join(","));
    let line = line.option_if("phi", (arguments.start_phi() != 0.0).then(|| start.phi.text()));
    let line = line.option("times", &arguments.times).flag("proved", true).option_if("digits", arguments.digits);
    let line = line.option_if("bound", (arguments.bound != 1e-10).then_some(arguments.bound));
    ProvedMotionDocument {
        head: bifdiag_documents::head(line.json()),
        body: bifdiag_documents::given(&subject.body),
        start: ExactStartDocument {
            gamma: texts(&start.gamma),
            omega: texts(&start.omega),
            phi: start.phi.text().to_owned(),
        },
        times: times.iter().copied().take(motion.samples.len()).collect(),
        enclosures: None,
        proved_to: motion.proved[1],
        proved_from: motion.proved[0],
        bound: arguments.bound,
        widest: motion.widest(),
        bits: motion.bits,
        steps: motion.steps,
        complete: motion.samples.len() == times.len(),
        notes: motion.end.iter().map(|_| reason(problem, motion)).collect(),
        part: subject.part.clone(),
    }
}

/// Where the proof ended and what goes further.
fn reason(problem: &Problem<'_>, motion: &ProvedMotion) -> String {
    let [from, to] = motion.proved;
    let proved = if from < 0.0 {
        format!("proved from t = {} to t = {}", significant(from, 6), significant(to, 6))
    } else {
        format!("proved to t = {}", significant(to, 6))
    };
    if motion.end == Some(ProofEnd::Interrupted) {
        return format!("{proved}; then it was interrupted");
    }
    let bits = motion.bits;
    match problem.arguments.digits {
        Some(digits) => {
            let more = (digits + digits / 2).max(digits + 10).min(bifdiag_enclosure::orbit::MOST_DIGITS);
            format!("{proved}; from there enclosures outrun {bits} bits: --digits {more}")
        }
        None => format!("{proved}; from there enclosures outrun {bits} bits, the most that there are: --bound 1e-2"),
    }
}

/// Decimals of both ends, as short as their width allows.
fn ends(ends: &Ends) -> [String; 2] {
    let [lo, hi] = ends;
    let width = (hi - lo).to_f64().value().max(1e-300);
    let size = lo.to_f64().value().abs().max(hi.to_f64().value().abs());
    // Two digits of the width remain.
    let digits = (3_u16..1000).take_while(|digits| f64::from(*digits) < libm::log10(size / width) + 3.0).count() + 3;
    decimal::outward(ends, digits)
}

fn enclosures(motion: &ProvedMotion) -> EnclosuresDocument {
    let mut document = EnclosuresDocument::default();
    for sample in &motion.samples {
        document.gamma.push(sample.gamma.each_ref().map(ends));
        document.omega.push(sample.omega.each_ref().map(ends));
        document.rotation.push(sample.rotation.each_ref().map(ends));
        document.quaternion.push(sample.quaternion.each_ref().map(ends));
    }
    document
}

/// A double not above (0) or not below (1) an end.
fn outward(ends: &Ends, side: usize) -> f64 {
    let nearest = ends[side].to_f64().value();
    let exact = RBig::try_from(nearest).unwrap_or(RBig::ZERO);
    match side {
        0 if exact > ends[0] => nearest.next_down(),
        1 if exact < ends[1] => nearest.next_up(),
        _ => nearest,
    }
}

/// One row for each time, doubles rounded outward; `meta` is the document on one line.
fn columns(document: &ProvedMotionDocument, motion: &ProvedMotion) -> Result<Columns, Failure> {
    let row = |first: usize, side: usize| {
        let row = move |s: &bifdiag_enclosure::orbit::ProvedSample| {
            std::array::from_fn(|i| outward(&s.rotation[first + i], side))
        };
        Values::vectors(motion.samples.iter().map(row))
    };
    let gamma =
        |side| Values::vectors(motion.samples.iter().map(move |s| s.gamma.each_ref().map(|x| outward(x, side))));
    let omega =
        |side| Values::vectors(motion.samples.iter().map(move |s| s.omega.each_ref().map(|x| outward(x, side))));
    let quaternion = |side| {
        Values::quaternions(motion.samples.iter().map(move |s| s.quaternion.each_ref().map(|x| outward(x, side))))
    };
    let columns = [
        ("time", Values::floats(document.times.iter().copied())),
        ("gamma_lo", gamma(0)),
        ("gamma_hi", gamma(1)),
        ("omega_lo", omega(0)),
        ("omega_hi", omega(1)),
        ("rotation1_lo", row(0, 0)),
        ("rotation1_hi", row(0, 1)),
        ("rotation2_lo", row(3, 0)),
        ("rotation2_hi", row(3, 1)),
        ("rotation3_lo", row(6, 0)),
        ("rotation3_hi", row(6, 1)),
        ("attitude_lo", quaternion(0)),
        ("attitude_hi", quaternion(1)),
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
            let [x, y, z] = v.each_ref().map(middle);
            format!("({x:>11.8}, {y:>11.8}, {z:>11.8})")
        };
        let mut table = Table::new(&["time", "gamma", "omega", "width"]);
        for (time, sample) in document.times.iter().zip(&motion.samples).take(LISTED) {
            table.row([significant(*time, 6), vector(&sample.gamma), vector(&sample.omega), bound(sample.width(), 2)]);
        }
        report.line(table.text());
        if motion.samples.len() > LISTED {
            report.line(format!("… and {} more; --data FILE.csv writes all", motion.samples.len() - LISTED));
        }
        report.line("");
    }
    report.line(format!(
        "widest enclosure: {}, of gamma, omega, rotation and quaternion; {} bits, {} steps",
        bound(document.widest, 2),
        document.bits,
        document.steps
    ));
    report.line("The ends of each interval are in --json and --data; the table shows middles.");
    for note in &document.notes {
        report.line(note);
    }
    report.written(written);
    report.text()
}
