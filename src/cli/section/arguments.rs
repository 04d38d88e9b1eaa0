//! Options of `bifdiag section`.

use std::num::NonZeroU32;
use std::path::PathBuf;

use bifdiag_dynamics::section::SectionCondition;
use bifdiag_plot::Projection;
use bifdiag_schema::VerdictsName;
use clap::{Args, ValueEnum};

use crate::cli::export::{DataTarget, PictureArguments, WidthArgument};
use crate::cli::input::values::Named;
use crate::cli::input::{BodyArguments, PointArguments, values};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag section --A 2,1.1,1 --r 0.94868,0,0.61623 --h 4.45 --l 3.25
  bifdiag section --body paper --region R5 --crossings 2000 --data chaos.npz
  bifdiag section --body kovalevskaya --h 3.4 --l 2.87 --json | jq .orbits
  bifdiag section --body paper --h 5.3 --l 3.25 --condition angular-momentum
  bifdiag section --body paper --h 4.45 --l 3.25 --color lyapunov --format png
  bifdiag section --body paper --region R4 --crossings 4000 --verdict early
  bifdiag section --body kovalevskaya --region R1,R3 --crossings 200
  bifdiag section --atlas bifdiag-out/atlas.json --region all --out sections

--starts FILE.csv has the header theta,psi,sheet and one point of the PP-torus per line (other columns are ignored, \
so that each crossing in a table written by --data starts an orbit); --data writes for each crossing orbit, index, \
time, gamma, l, sheet, s_dot, theta, psi (index 0 is a start on this section). Crossings go to FILE.partial as they are found, with \
--data FILE --no-plot alone in constant memory. The first Ctrl-C ends the run with exit status 1 and replaces no \
file; the same command resumes from FILE.partial.";

/// Which function vanishes on the section.
const CONDITIONS: [Named<SectionCondition>; 2] = [
    (
        "height",
        "S = d/dt <gamma,r>: the height of the centre of mass is extremal (the paper's)",
        SectionCondition::Height,
    ),
    (
        "angular-momentum",
        "S = <l, gamma x r>: |l| is extremal (Gashenenko and Richter)",
        SectionCondition::AngularMomentum,
    ),
];

/// On what the picture shows the section.
const PROJECTIONS: [Named<Projection>; 3] = [
    ("torus", "Each sheet of the section on its own half of the PP-torus, T- or T+", Projection::Torus),
    ("sphere", "S- and S+, two copies of the Poisson sphere", Projection::Sphere),
    ("both", "The sphere above the torus", Projection::Both),
];

/// What the colour of a point shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ColorArgument {
    /// Whether its orbit is regular, chaotic, or open
    Verdict,
    /// The side of the section, that of +r or of -r
    Side,
    /// Its orbit
    Orbit,
    /// The Lyapunov exponent of its orbit
    Lyapunov,
    /// The rotation number of its orbit
    Rotation,
}

/// How orbits are judged.
const VERDICTS: [Named<VerdictsName>; 4] = [
    (
        "whole",
        "From the whole of each orbit; open ones are followed further for the verdict alone",
        VerdictsName::Whole,
    ),
    ("early", "End each orbit where its verdict is found", VerdictsName::Early),
    (
        "only",
        "The verdict without exponents and rotation numbers: the work for it ends once it is found",
        VerdictsName::Only,
    ),
    ("none", "No verdict, which takes a quarter of the time", VerdictsName::None),
];

/// `bifdiag section`.
#[derive(Debug, Args)]
pub struct SectionArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Take the body and the points from an atlas.json (-: stdin), for all regions or those of --region
    #[arg(long, value_name = "FILE", help_heading = "Point", hide_short_help = true)]
    pub atlas: Option<PathBuf>,
    /// Instead of --h and --l: use the sample of a region such as R4, of several in one picture, or of all
    #[arg(long, value_name = "ID,…|all", value_delimiter = ',', value_parser = values::trimmed, help_heading = "Point")]
    pub region: Vec<String>,
    /// Number of orbits, spread evenly over the section (default: 24)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = values::orbits)]
    #[arg(help_heading = "Orbits")]
    pub orbits: Option<NonZeroU32>,
    /// Seed for the starting points; all choices are equally spread (default: 0)
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = values::seed, help_heading = "Orbits", hide_short_help = true)]
    pub seed: Option<u64>,
    /// Start at the points of FILE (-: stdin) instead: CSV with the header theta,psi,sheet
    #[arg(long, value_name = "FILE.csv", help_heading = "Orbits", hide_short_help = true)]
    pub starts: Option<PathBuf>,
    /// Crossings of each orbit
    #[arg(long, value_name = "M", default_value = "500", allow_hyphen_values = true)]
    #[arg(value_parser = values::crossings, help_heading = "Orbits")]
    pub crossings: NonZeroU32,
    /// Stop each orbit at time T, such as 1e4, even if it has fewer crossings; the last step may end after T, but no
    /// crossing lies there
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = values::duration)]
    #[arg(help_heading = "Orbits", hide_short_help = true)]
    pub max_time: Option<f64>,
    /// Decide whether each orbit is regular, chaotic or open (default: whole; none where only --data is written)
    #[arg(long, value_parser = values::named(&VERDICTS), help_heading = "Orbits", hide_short_help = true)]
    pub verdict: Option<VerdictsName>,
    /// The section condition S = 0
    #[arg(long, value_parser = values::named(&CONDITIONS), default_value = "height", help_heading = "Orbits", hide_short_help = true)]
    pub condition: SectionCondition,
    /// Truncation error of a step of the Taylor series, relative to the size of the motion
    #[arg(long, value_name = "TOL", allow_hyphen_values = true, value_parser = values::step_tolerance)]
    #[arg(default_value = "1e-15", hide_short_help = true, help_heading = "Orbits")]
    pub tol: f64,
    /// Write the points to FILE.npz, FILE.parquet, FILE.csv or FILE.jsonl (-: CSV to stdout); one file per region if
    /// there are several
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Write picture, points and summary to DIR (default: bifdiag-out; with --json or --data -: nowhere)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Surface on which the section is drawn
    #[arg(long, value_parser = values::named(&PROJECTIONS), default_value = "torus", help_heading = "Output", hide_short_help = true)]
    pub projection: Projection,
    /// What the colour of a point shows (default: verdict where verdicts are found, else orbit)
    #[arg(long, value_enum, help_heading = "Output", hide_short_help = true)]
    pub color: Option<ColorArgument>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Print the results, and how accurate each orbit is, as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
