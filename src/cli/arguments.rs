//! Every option of the command line.

use std::ffi::OsString;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::parser::ValueSource;
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use plot::{Picture, PlotError};
use schema::{Accuracy, WindowDocument};
use top::body::Number;

use super::failure::{InputError, Refusal};
use super::find::{FIND_EXAMPLES, FindArguments};
use super::orbit::{self, OrbitArguments};
use super::scan::{SCAN_EXAMPLES, ScanArguments};
use super::section::{self, SectionArguments};
use super::values::{self, Tensor, Triple};

const ABOUT: &str = "Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body";

const MAIN_EXAMPLES: &str = "\
Examples:
  bifdiag --A 2,1.1,1 --r 0.94868,0,0.61623        all regions of the (h, l) plane
  bifdiag --body kovalevskaya --format svg,png --out kovalevskaya
  bifdiag --body paper --json | jq .summary
  bifdiag classify --body paper --h 3.8 --l 3.25   the type of U, E and P at one point
  bifdiag critical --body paper --l 3.25           all relative equilibria at one l
  bifdiag section --body paper --h 4.45 --l 3.25   a Poincaré section: regular or chaotic
  bifdiag orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,1   the motion in space
  bifdiag bodies                                   the named bodies

Numbers are decimals, decimals with exponent or rationals (1.1, 11e-1, 11/10) and are read exactly.
Exit status: 0 done; 2 the input is wrong; 1 anything else.";

const ATLAS_EXAMPLES: &str = "\
Examples:
  bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623
  bifdiag atlas --body katok:7 --window 0:4,0:3 --format png --out katok7
  bifdiag atlas --A 2,11/10,1 --r=-1,0,1/2 --json > atlas.json
  bifdiag atlas --inertia 0.30,0.21,0.17,0.01,0,-0.02 --com 0,0.02,0.15 --mass 2.5 --g 9.80665 --no-plot";

const CLASSIFY_EXAMPLES: &str = "\
Examples:
  bifdiag classify --A 2,1.1,1 --r 0.94868,0,0.61623 --h 3.8 --l 3.25
  bifdiag classify --body kovalevskaya --h 1.84 --l=-1.84 --json
  bifdiag classify --batch points.jsonl > types.jsonl
  echo '{\"h\": 3.8, \"l\": \"13/4\"}' | bifdiag classify --body paper --batch -

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"h\": 3.8, \"l\": 3.25}, numbers or strings; a
line without A and r means the body of the command line, other keys are ignored. One line is written for each, in
the same order; a wrong line gives {\"error\": …, \"line\": n}.";

const CRITICAL_EXAMPLES: &str = "\
Examples:
  bifdiag critical --A 2,1.1,1 --r 0.94868,0,0.61623 --l 3.25
  bifdiag critical --body katok:6 --l 7/3 --json
  bifdiag critical --batch momenta.jsonl --threads 4 > equilibria.jsonl

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"l\": 3.25}, numbers or strings; a line
without A and r means the body of the command line, other keys are ignored. One line is written for each, in the
same order; a wrong line gives {\"error\": …, \"line\": n}.";

const VERIFY_EXAMPLES: &str = "\
Examples:
  bifdiag --body paper --accuracy certified && bifdiag verify bifdiag-out/atlas.json
  bifdiag --body katok:6 --accuracy certified --json | bifdiag verify -

A certified atlas is checked as a proof, by separate code; any other is compared with the second topological method,
which is no proof. Exit status: 0 verified; 1 refused, with the first thing that is wrong; 2 the file is no atlas.";

const BODIES_EXAMPLES: &str = "\
Examples:
  bifdiag bodies
  bifdiag bodies --json | jq -r '.bodies[].name'";

const SCHEMA_EXAMPLES: &str = "\
Examples:
  bifdiag schema                 the names and what they describe
  bifdiag schema atlas > atlas.schema.json
  bifdiag schema --json          all of them in one JSON object";

const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  bifdiag completions bash > ~/.local/share/bash-completion/completions/bifdiag
  bifdiag completions zsh > ~/.zfunc/_bifdiag
  bifdiag completions fish > ~/.config/fish/completions/bifdiag.fish";

const MAN_EXAMPLES: &str = "\
Examples:
  bifdiag man | man -l -
  bifdiag man --out ~/.local/share/man/man1      a page for each command";

const FIGURES_EXAMPLES: &str = "\
Examples:
  bifdiag figures
  bifdiag figures --out my-figures --format svg,png";

/// The whole command line.
#[derive(Debug, Parser)]
#[command(
    name = "bifdiag",
    version,
    about = ABOUT,
    after_help = MAIN_EXAMPLES,
    arg_required_else_help = true,
    disable_help_subcommand = true,
    max_term_width = 100
)]
pub struct Options {
    #[command(flatten)]
    pub atlas: AtlasArguments,
    #[command(flatten)]
    pub common: CommonArguments,
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The commands; without one, `atlas` is meant.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find every region of the (h, l) plane with its topology (the default)
    #[command(after_help = ATLAS_EXAMPLES)]
    Atlas(AtlasArguments),
    /// Tell the type of U, E and P at one point (h, l), or at many
    #[command(after_help = CLASSIFY_EXAMPLES)]
    Classify(ClassifyArguments),
    /// List all relative equilibria at one l, or at many
    #[command(after_help = CRITICAL_EXAMPLES)]
    Critical(CriticalArguments),
    /// Look at many bodies: which classes of diagrams they have
    #[command(after_help = SCAN_EXAMPLES)]
    Scan(Box<ScanArguments>),
    /// Search for a body and a point that show a wanted type
    #[command(after_help = FIND_EXAMPLES)]
    Find(FindArguments),
    /// Compute a Poincaré section on the PP-torus
    #[command(after_help = section::EXAMPLES)]
    Section(SectionArguments),
    /// Follow the body's motion in space: attitude, Euler's angles, angular velocity
    #[command(after_help = orbit::EXAMPLES)]
    Orbit(OrbitArguments),
    /// Check an atlas by other means than those that made it
    #[command(after_help = VERIFY_EXAMPLES)]
    Verify(VerifyArguments),
    /// List the named bodies
    #[command(after_help = BODIES_EXAMPLES)]
    Bodies(BodiesArguments),
    /// Print the JSON Schemas of the documents
    #[command(after_help = SCHEMA_EXAMPLES)]
    Schema(SchemaArguments),
    /// Print the completions of a shell
    #[command(after_help = COMPLETIONS_EXAMPLES)]
    Completions(CompletionsArguments),
    /// Print the manual page, or write the pages of all commands
    #[command(after_help = MAN_EXAMPLES)]
    Man(ManArguments),
    /// Draw every figure of the paper and of the documentation
    #[command(after_help = FIGURES_EXAMPLES)]
    Figures(FiguresArguments),
}

/// Options of every command.
#[derive(Debug, Args)]
pub struct CommonArguments {
    /// Use N threads for batches and sections (default: one for each core)
    #[arg(long, value_name = "N", global = true, allow_hyphen_values = true, value_parser = values::threads)]
    #[arg(help_heading = "General")]
    pub threads: Option<NonZeroUsize>,
    /// Tell on stderr how long each stage took
    #[arg(long, global = true, help_heading = "General")]
    pub timings: bool,
    /// Print no warnings and no progress
    #[arg(short, long, global = true, conflicts_with = "verbose", help_heading = "General")]
    pub quiet: bool,
    /// Tell on stderr what is done; twice: in detail
    #[arg(short, long, global = true, action = ArgAction::Count, help_heading = "General")]
    pub verbose: u8,
}

/// The body, in one of three ways.
#[derive(Debug, Args)]
#[command(next_help_heading = "Body (one of three ways)")]
pub struct BodyArguments {
    /// Principal moments of inertia
    #[arg(long = "A", value_name = "A1,A2,A3", allow_hyphen_values = true, value_parser = values::moments)]
    pub moments: Option<Triple>,
    /// Centre of mass in principal axes, m g absorbed
    #[arg(long = "r", value_name = "r1,r2,r3", allow_hyphen_values = true, value_parser = values::center)]
    pub center: Option<Triple>,
    /// A named body; `bifdiag bodies` lists them
    #[arg(long, value_name = "NAME", hide_possible_values = true, value_parser = values::preset_names())]
    pub body: Option<String>,
    /// Inertia tensor about the fixed point in kg m²: matrix entries, so that Ixy = -∫ x y dm
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor)]
    pub inertia: Option<Tensor>,
    /// Centre of mass from the fixed point in m (with --inertia)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::center_of_mass)]
    pub com: Option<Triple>,
    /// Mass in kg (with --inertia)
    #[arg(long, value_name = "m", allow_hyphen_values = true, value_parser = values::mass)]
    pub mass: Option<Number>,
    /// Acceleration of gravity in m/s² (with --inertia)
    #[arg(long = "g", value_name = "g", allow_hyphen_values = true, value_parser = values::gravity)]
    pub gravity: Option<Number>,
}

/// How accurate the answer must be, as it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AccuracyArgument {
    /// Regions as in standard; coarser curves from the closed form, without stability
    Draft,
    /// f64 with error bounds; undecided where they do not suffice
    Standard,
    /// Proved, with a certificate that `bifdiag verify` checks
    Certified,
}

impl AccuracyArgument {
    /// The level.
    pub fn level(self) -> Accuracy {
        match self {
            Self::Draft => Accuracy::Draft,
            Self::Standard => Accuracy::Standard,
            Self::Certified => Accuracy::Certified,
        }
    }
}

/// Formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    Svg,
    Png,
    Pdf,
}

/// `bifdiag atlas`.
#[derive(Debug, Args)]
pub struct AtlasArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Only this part of the plane
    #[arg(long, value_name = "hmin:hmax,lmin:lmax", allow_hyphen_values = true, value_parser = values::window)]
    #[arg(help_heading = "Work")]
    pub window: Option<WindowDocument>,
    /// What the answer must be worth
    #[arg(long, value_enum, default_value = "standard", help_heading = "Work")]
    pub accuracy: AccuracyArgument,
    /// Write atlas.json and the diagram to DIR (default: bifdiag-out; with --json: nowhere)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    /// Formats of the diagram
    #[arg(long, value_enum, value_delimiter = ',', default_value = "svg", help_heading = "Output")]
    pub format: Vec<Format>,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Print the atlas as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// Many points at once.
#[derive(Debug, Args)]
#[command(next_help_heading = "Batch")]
pub struct BatchArguments {
    /// Read one JSON object a line from FILE (-: stdin) and write one line for each
    #[arg(long, value_name = "FILE")]
    pub batch: Option<PathBuf>,
    /// Exit with status 2 if a line of the batch is wrong
    #[arg(long)]
    pub strict: bool,
}

impl BatchArguments {
    /// The file of the batch, if one is asked for and none of the options that its lines replace is given.
    pub fn path(&self, replaced: &[(&'static str, bool)]) -> Result<Option<&Path>, InputError> {
        let Some(path) = &self.batch else {
            return if self.strict { Err(InputError::StrictWithoutBatch) } else { Ok(None) };
        };
        match replaced.iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(InputError::PointWithBatch { option }),
            None => Ok(Some(path)),
        }
    }
}

/// `bifdiag classify`.
#[derive(Debug, Args)]
pub struct ClassifyArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Energy
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Point")]
    pub energy: Option<Number>,
    /// Vertical angular momentum; its sign does not matter
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Point")]
    pub momentum: Option<Number>,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// What the answer must be worth
    #[arg(long, value_enum, default_value = "standard", help_heading = "Work")]
    pub accuracy: AccuracyArgument,
    /// Print the answer as JSON (a batch always is)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag critical`.
#[derive(Debug, Args)]
pub struct CriticalArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Vertical angular momentum; its sign is that of omega
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Momentum")]
    pub momentum: Option<Number>,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// Print the answer as JSON (a batch always is)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The atlas.json to check (-: stdin)
    #[arg(value_name = "ATLAS.json")]
    pub file: PathBuf,
}

/// `bifdiag bodies`.
#[derive(Debug, Args)]
pub struct BodiesArguments {
    /// Print the list as JSON
    #[arg(long)]
    pub json: bool,
}

/// `bifdiag schema`.
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// The document to describe
    #[arg(value_enum)]
    pub name: Option<super::schema::Name>,
    /// Without NAME: all schemas in one JSON object
    #[arg(long)]
    pub json: bool,
}

/// `bifdiag completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// `bifdiag man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Write a page for each command to DIR
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `bifdiag figures`.
#[derive(Debug, Args)]
pub struct FiguresArguments {
    /// Write the figures to DIR
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub out: PathBuf,
    /// Formats
    #[arg(long, value_enum, value_delimiter = ',', default_value = "svg")]
    pub format: Vec<Format>,
}

impl Options {
    /// The clap command, for completions and manual pages.
    pub fn command() -> clap::Command {
        <Self as CommandFactory>::command()
    }

    /// The options of a command line; the first argument is the name of the program.
    pub fn from_arguments(arguments: impl IntoIterator<Item = OsString>) -> Result<Self, Refusal> {
        let arguments: Vec<OsString> = arguments.into_iter().collect();
        let command = Self::command();
        check_values(&command, &arguments)?;
        let matches = command.clone().try_get_matches_from(arguments)?;
        if let Some(name) = matches.subcommand_name() {
            check_no_stray_option(&command, &matches, name)?;
        }
        check_formats(&matches)?;
        Ok(Self::from_arg_matches(&matches)?)
    }
}

/// Values may start with a hyphen, so `--A --r 1,0,0` would take `--r` for the value of `--A`.
fn check_values(command: &clap::Command, arguments: &[OsString]) -> Result<(), InputError> {
    let find = |text: &OsString| {
        let long = text.to_str()?.strip_prefix("--")?;
        let mut everywhere = command.get_subcommands().chain([command]).flat_map(clap::Command::get_arguments);
        everywhere.find(|argument| argument.get_long() == Some(long))
    };
    for pair in arguments.windows(2) {
        let [option, next] = pair else { continue };
        let Some(argument) = find(option).filter(|argument| argument.get_action().takes_values()) else { continue };
        if find(next).is_some() {
            let names = argument.get_value_names().unwrap_or_default();
            return Err(InputError::ValueMissing {
                option: option.to_string_lossy().into_owned(),
                next: next.to_string_lossy().into_owned(),
                value: names.iter().map(ToString::to_string).collect(),
            });
        }
    }
    Ok(())
}

/// Options of the atlas in front of another command would be ignored in silence.
fn check_no_stray_option(command: &clap::Command, matches: &clap::ArgMatches, name: &str) -> Result<(), InputError> {
    let stray = command.get_arguments().find(|argument| {
        let id = argument.get_id().as_str();
        let there = matches.ids().any(|there| there == argument.get_id());
        !argument.is_global_set() && there && matches.value_source(id) == Some(ValueSource::CommandLine)
    });
    match stray.and_then(clap::Arg::get_long) {
        Some(long) => Err(InputError::OptionBeforeCommand { option: format!("--{long}"), command: name.to_owned() }),
        None => Ok(()),
    }
}

/// PDF is refused before any work where this build does not make it.
fn check_formats(matches: &clap::ArgMatches) -> Result<(), InputError> {
    let wanted = matches.try_get_many::<Format>("format").ok().flatten();
    if !Picture::MAKES_PDF && wanted.is_some_and(|mut formats| formats.any(|format| *format == Format::Pdf)) {
        return Err(InputError::Format(PlotError::NoPdf));
    }
    matches.subcommand().map_or(Ok(()), |(_, matches)| check_formats(matches))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_finds_the_command_consistent() {
        Options::command().debug_assert();
    }

    #[test]
    fn every_help_page_has_examples() {
        let root = Options::command();
        for command in root.get_subcommands().chain([&root]) {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.starts_with("Examples:\n  bifdiag"), "{}", command.get_name());
        }
    }
}
