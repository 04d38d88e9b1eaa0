//! The whole command line: the commands, what is common to them, and command lines that are not accepted.

use std::ffi::OsString;
use std::num::NonZeroUsize;

use clap::parser::ValueSource;
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use thiserror::Error;
use top::body::{Number, Preset};

use super::atlas::{self, AtlasArguments};
use super::bodies::{self, BodiesArguments};
use super::classify::{self, ClassifyArguments};
use super::critical::{self, CriticalArguments};
use super::figures::{self, FiguresArguments};
use super::find::{self, FindArguments};
use super::input::values;
use super::orbit::{self, OrbitArguments};
use super::pages::{self, CompletionsArguments, ManArguments};
use super::part::{self, PartBodyArguments};
use super::scan::{self, ScanArguments};
use super::schema::{self, SchemaArguments};
use super::section::{self, SectionArguments};
use super::show::{self, ShowArguments};
use super::sphere::{self, SphereArguments};
use super::spin::{self, CampbellArguments, CriticalSpinArguments, StateArguments};
use super::verify::{self, VerifyArguments};

const ABOUT: &str = "Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body";

const MAIN_EXAMPLES: &str = "\
Examples:
  bifdiag --A 2,1.1,1 --r 0.94868,0,0.61623        all regions of the (h, l) plane
  bifdiag --body kovalevskaya --format svg,png --out kovalevskaya
  bifdiag --body paper --json | jq .summary
  bifdiag classify --body paper --h 3.8 --l 3.25   the type of U, E and P at one point
  bifdiag critical --body paper --l 3.25           all relative equilibria at one l
  bifdiag show R5 --body paper                     a region in words
  bifdiag sphere --body paper --h 4.45 --l 3.25    U on the Poisson sphere, as a picture
  bifdiag section --body paper --region R5         a Poincaré section: regular or chaotic
  bifdiag orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,1   the motion in space
  bifdiag bodies                                   the named bodies

Numbers are decimals, decimals with exponent or rationals (1.1, 11e-1, 11/10) and are read exactly.
Exit status: 0 done; 2 the input is wrong; 1 anything else.";

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
    #[command(after_help = atlas::EXAMPLES)]
    Atlas(AtlasArguments),
    /// Tell the type of U, E and P at one point (h, l), or at many
    #[command(after_help = classify::EXAMPLES)]
    Classify(ClassifyArguments),
    /// List all relative equilibria at one l, or at many
    #[command(after_help = critical::EXAMPLES)]
    Critical(CriticalArguments),
    /// Look at many bodies: which classes of diagrams they have
    #[command(after_help = scan::SCAN_EXAMPLES)]
    Scan(Box<ScanArguments>),
    /// Search for a body and a point that show a wanted type
    #[command(after_help = find::FIND_EXAMPLES)]
    Find(FindArguments),
    /// Explain a region, a curve or an event in words
    #[command(after_help = show::EXAMPLES)]
    Show(ShowArguments),
    /// Compute a Poincaré section on the PP-torus
    #[command(after_help = section::EXAMPLES)]
    Section(SectionArguments),
    /// Draw U on the Poisson sphere at one point: its components, their boundaries and poles
    #[command(after_help = sphere::EXAMPLES)]
    Sphere(SphereArguments),
    /// Follow the body's motion in space: attitude, Euler's angles, angular velocity
    #[command(after_help = orbit::EXAMPLES)]
    Orbit(OrbitArguments),
    /// Check an atlas by other means than those that made it
    #[command(after_help = verify::EXAMPLES)]
    Verify(VerifyArguments),
    /// Show and draw a real part as it was understood
    #[command(after_help = part::BODY_EXAMPLES)]
    Body(PartBodyArguments),
    /// Tell where a state lies: its (h, l), its region or curve, and whether it is stable
    #[command(after_help = spin::STATE_EXAMPLES)]
    State(Box<StateArguments>),
    /// List the spins at which rotation about an axis changes its stability or its regions
    #[command(after_help = spin::CRITICAL_SPIN_EXAMPLES)]
    CriticalSpin(Box<CriticalSpinArguments>),
    /// Draw the frequencies of small oscillations over the spin of a permanent axis
    #[command(after_help = spin::CAMPBELL_EXAMPLES)]
    Campbell(Box<CampbellArguments>),
    /// List the named bodies
    #[command(after_help = bodies::EXAMPLES)]
    Bodies(BodiesArguments),
    /// Print the JSON Schemas of the documents
    #[command(after_help = schema::EXAMPLES)]
    Schema(SchemaArguments),
    /// Print the completions of a shell
    #[command(after_help = pages::COMPLETIONS_EXAMPLES)]
    Completions(CompletionsArguments),
    /// Print the manual page, or write the pages of all commands
    #[command(after_help = pages::MAN_EXAMPLES)]
    Man(ManArguments),
    /// Draw every figure of the paper and of the documentation
    #[command(after_help = figures::EXAMPLES)]
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

/// A command line that is not accepted; also the answer to --help and --version.
#[derive(Debug, Error)]
pub enum Refusal {
    #[error("{}", .0.render())]
    Clap(#[from] clap::Error),
    #[error("{option} has no value ({next} follows it); write it as {option} {value}, or {option}=VALUE")]
    ValueMissing { option: String, next: String, value: String },
    #[error("{option} is gone; write {successor}")]
    Gone { option: String, successor: &'static str },
    #[error("{value} stands alone after {option}; write a list with commas: {option} {list}")]
    ListWithBlanks { option: String, value: String, list: String },
    #[error("{name} is a body, not a command; write bifdiag --body {name}")]
    BodyAsCommand { name: String },
    #[error("{option} stands before the command {command}; write it after: bifdiag {command} {option} …")]
    OptionBeforeCommand { option: String, command: String },
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
        check_gone(&command, &arguments)?;
        check_forms(&command, &arguments)?;
        check_values(&command, &arguments)?;
        let matches = command.clone().try_get_matches_from(arguments)?;
        if let Some(name) = matches.subcommand_name() {
            check_no_stray_option(&command, &matches, name)?;
        }
        Ok(Self::from_arg_matches(&matches)?)
    }
}

/// Options of earlier versions, and what is written now.
const GONE: [(&str, &str); 2] = [("rng-seed", "--seed K"), ("seeds", "--starts FILE.csv")];

/// An option of an earlier version is named with its successor, unless some command still has it.
fn check_gone(command: &clap::Command, arguments: &[OsString]) -> Result<(), Refusal> {
    let long = |text: &OsString| Some(text.to_str()?.strip_prefix("--")?.split('=').next()?.to_owned());
    let known = |name: &str| {
        let mut everywhere = command.get_subcommands().chain([command]).flat_map(clap::Command::get_arguments);
        everywhere.any(|argument| argument.get_long() == Some(name))
    };
    for name in arguments.iter().filter_map(long).filter(|name| !known(name)) {
        if let Some((option, successor)) = GONE.into_iter().find(|(option, _)| *option == name) {
            return Err(Refusal::Gone { option: format!("--{option}"), successor });
        }
    }
    Ok(())
}

/// Forms that are near to right ones: `--A 2 1.1 1`, and the name of a body where a command should be.
fn check_forms(command: &clap::Command, arguments: &[OsString]) -> Result<(), Refusal> {
    let texts: Vec<&str> = arguments.iter().filter_map(|text| text.to_str()).collect();
    let number = |text: &&&str| text.parse::<Number>().is_ok();
    for (place, option) in texts.iter().enumerate().filter(|(_, text)| matches!(**text, "--A" | "--r" | "--com")) {
        let list: Vec<&str> = texts[place + 1..].iter().take_while(number).copied().collect();
        if let [_, value, ..] = list[..] {
            let (option, value) = ((*option).to_owned(), value.to_owned());
            return Err(Refusal::ListWithBlanks { option, value, list: list.join(",") });
        }
    }
    match texts.get(1) {
        Some(name) if command.find_subcommand(name).is_none() && Preset::find(name).is_some() => {
            Err(Refusal::BodyAsCommand { name: (*name).to_owned() })
        }
        _ => Ok(()),
    }
}

/// Values may start with a hyphen, so `--A --r 1,0,0` would take `--r` for the value of `--A`.
fn check_values(command: &clap::Command, arguments: &[OsString]) -> Result<(), Refusal> {
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
            return Err(Refusal::ValueMissing {
                option: option.to_string_lossy().into_owned(),
                next: next.to_string_lossy().into_owned(),
                value: names.iter().map(ToString::to_string).collect(),
            });
        }
    }
    Ok(())
}

/// Options of the atlas in front of another command would be ignored in silence.
fn check_no_stray_option(command: &clap::Command, matches: &clap::ArgMatches, name: &str) -> Result<(), Refusal> {
    let stray = command.get_arguments().find(|argument| {
        let id = argument.get_id().as_str();
        let there = matches.ids().any(|there| there == argument.get_id());
        !argument.is_global_set() && there && matches.value_source(id) == Some(ValueSource::CommandLine)
    });
    match stray.and_then(clap::Arg::get_long) {
        Some(long) => Err(Refusal::OptionBeforeCommand { option: format!("--{long}"), command: name.to_owned() }),
        None => Ok(()),
    }
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
