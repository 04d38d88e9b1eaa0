//! `bifdiag periodic manifolds`: stable and unstable manifolds of periodic orbits and equilibria in the section, and
//! where they cross.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_documents::Subject;
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, PpTorus, SectionError};
use bifdiag_periodic::catalogue::Catalogue;
use bifdiag_periodic::family::Held;
use bifdiag_periodic::manifold::{ManifoldError, ManifoldOptions, Manifolds, manifolds, manifolds_of_equilibria};
use bifdiag_schema::ManifoldsDocument;
use clap::Args;

use super::family::{NOT_FOUND, starts};
use super::manifolds_output::{columns, text};
use super::short::{listed, point_and_crossings};
use crate::cli::export::{DataFormat, DataTarget, FileSet, PictureArguments, answer};
use crate::cli::failure::{Failure, failed};
use crate::cli::input::{BodyArguments, PointArguments, values};
use crate::cli::section::poincare_failure;
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Progress, Timings, print};
use crate::pictures::{self, ManifoldBackground};

pub const MANIFOLDS_EXAMPLES: &str = "\
Examples:
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25 --length 5 --out dir
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25 --data curves.csv
  bifdiag periodic manifolds --body paper --from G0.1 --l 0.5

The unstable and stable manifolds of the unstable periodic orbits at (h, l), as curves in the part of P where \
<gamma,r> is largest, or those of an unstable equilibrium, at its energy (--from); and the orbits that connect them \
(homoclinic, heteroclinic), refined to 1e-10. --data writes a row for each point of a curve, with theta, psi and sheet \
as in `bifdiag section`.";

/// `bifdiag periodic manifolds`.
#[derive(Debug, Args)]
pub struct ManifoldsArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Use the equilibria of this curve at l instead, by its id in `bifdiag atlas`
    #[arg(long, value_name = "CURVE", conflicts_with_all = ["energy", "crossings"], help_heading = "Orbits")]
    pub from: Option<String>,
    /// Use the orbits with at most N crossings of P in a period, inward and outward
    #[arg(long, value_name = "N", default_value_t = 2, help_heading = "Orbits")]
    pub crossings: u32,
    /// Follow each curve for this length, in units in which |gamma| and a bound of |l| are 1
    #[arg(long, value_name = "L", default_value_t = 10.0, value_parser = length, allow_hyphen_values = true, help_heading = "Orbits")]
    pub length: f64,
    /// Draw the curves over the section to DIR/manifolds.svg
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    /// Write the points of the curves to FILE (.parquet, .csv, .jsonl, .npz; -: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Print the curves and the orbits that connect them as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// The longest curve.
const LONGEST: f64 = 1000.0;

fn length(text: &str) -> Result<f64, Failure> {
    let length = values::float(text)?;
    if length > 0.0 && length <= LONGEST {
        Ok(length)
    } else {
        Err(Failure::input(format!("{text}: a length above 0 and up to {LONGEST} is possible, such as 10")))
    }
}

/// The manifolds found, with what the outputs need.
struct Found {
    document: ManifoldsDocument,
    manifolds: Manifolds,
    torus: PpTorus,
    /// Only if a picture is drawn.
    background: Option<ManifoldBackground>,
}

pub fn run(arguments: &ManifoldsArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    if arguments.json && arguments.data == Some(DataTarget::Stdout) {
        return Err(Failure::input("--json and --data - both write to stdout; give --data a file"));
    }
    let subject = arguments.body.subject()?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let found = match &arguments.from {
        Some(id) => of_equilibria(arguments, &subject, &values::id(id), &monitor, timings, quiet),
        None => of_orbits(arguments, &subject, &monitor, timings, quiet),
    };
    drop(interruptible);
    let Found { document, manifolds, torus, background } = found?;
    let mut files = FileSet::new(arguments.out.as_deref().unwrap_or(Path::new(".")));
    if let Some(background) = background {
        let draw = || pictures::manifolds(&background, &manifolds, arguments.picture.theme);
        let picture = timings.stage("picture", draw).map_err(failed("the picture could not be drawn"))?;
        files.remove_pictures("manifolds");
        files.pictures("manifolds", &picture, &arguments.picture, timings)?;
    }
    match &arguments.data {
        Some(DataTarget::File { path, format }) => {
            files.add_at(path, format.bytes(&columns(&torus, &manifolds, &document)?)?);
        }
        Some(DataTarget::Stdout) => {
            files.write()?;
            return print(DataFormat::Csv.bytes(&columns(&torus, &manifolds, &document)?)?);
        }
        None => {}
    }
    let written = files.write()?;
    answer(arguments.json, &document, || text(&subject, &document, &written))
}

fn of_orbits(
    arguments: &ManifoldsArguments,
    subject: &Subject,
    monitor: &Monitor,
    timings: &Timings,
    quiet: bool,
) -> Result<Found, Failure> {
    let (h, l) = point_and_crossings(&arguments.point, arguments.crossings)?;
    let setting = SectionSetting::new(&subject.body, h, l).map_err(poincare_failure)?;
    let listed = listed(&setting, arguments.crossings, monitor, timings, quiet)?;
    let options = ManifoldOptions { length: arguments.length };
    let progress = Progress::open("motions followed", quiet);
    let work = || progress.watching(&monitor.orbits, || manifolds(&setting, &listed, &options, monitor));
    let found = timings.stage("manifolds", work).map_err(not_followed)?;
    let asked = (arguments.crossings, arguments.length);
    let document = bifdiag_documents::manifolds(subject, [h, l], asked, &listed, &found);
    let background = || ManifoldBackground::of_orbits(&setting, &listed).map_err(poincare_failure);
    let background = arguments.out.as_ref().map(|_| background()).transpose()?;
    Ok(Found { document, manifolds: found, torus: *setting.torus(), background })
}

fn of_equilibria(
    arguments: &ManifoldsArguments,
    subject: &Subject,
    id: &str,
    monitor: &Monitor,
    timings: &Timings,
    quiet: bool,
) -> Result<Found, Failure> {
    let Some(l) = &arguments.point.momentum else {
        return Err(Failure::input("--l is missing: --from also needs it, such as --l 1.5"));
    };
    let body = &subject.body;
    let catalogue = Catalogue::new(body).map_err(failed(NOT_FOUND))?;
    let equilibria = starts(&catalogue, Held::Momentum, l, Some(id))?;
    let options = ManifoldOptions { length: arguments.length };
    let progress = Progress::open("motions followed", quiet);
    let follow = || manifolds_of_equilibria(body, &equilibria, &options, monitor);
    let found =
        timings.stage("manifolds", || progress.watching(&monitor.orbits, follow)).map_err(|error| match error {
            ManifoldError::Section(SectionError::WeightlessBody)
            | ManifoldError::Type(_)
            | ManifoldError::NotIsolated
            | ManifoldError::Series
            | ManifoldError::Ring => Failure::input(format!("--from {id} --l {}: {error}", l.text())),
            error => not_followed(error),
        })?;
    let document = bifdiag_documents::equilibrium_manifolds(subject, (id, l), arguments.length, &equilibria, &found);
    let background = || ManifoldBackground::of_equilibria(body, &equilibria).map_err(failed(NO_BACKGROUND));
    let background = arguments.out.as_ref().map(|_| background()).transpose()?;
    let torus = PpTorus::new(&HeavyTop::new(body)).map_err(|error| not_followed(error.into()))?;
    Ok(Found { document, manifolds: found, torus, background })
}

/// The message if the background cannot be computed.
const NO_BACKGROUND: &str = "the orbits behind the curves could not be started";

fn not_followed(error: ManifoldError) -> Failure {
    match error {
        ManifoldError::Section(SectionError::Interrupted) => Failure::work("interrupted"),
        error => failed("the manifolds could not be followed")(error),
    }
}
