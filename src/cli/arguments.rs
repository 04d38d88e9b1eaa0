//! The whole command line: the commands, what is common to them, and command lines that are not accepted.

use std::ffi::OsString;
use std::num::NonZeroUsize;

use bifdiag_body::{Number, Preset};
use bifdiag_schema::one_line;
use clap::parser::ValueSource;
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser};
use thiserror::Error;

use super::atlas::{self, AtlasArguments};
use super::bodies::{self, BodiesArguments};
use super::classes::{self, ClassArguments, ClassesArguments};
use super::classify::{self, ClassifyArguments};
use super::critical::{self, CriticalArguments};
use super::explore::{self, ExploreArguments};
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
  bifdiag --A 2,1.1,1 --r 0.94868,0,0.61623        all regions of (h, l)
  bifdiag --body kovalevskaya --format svg,png --out kovalevskaya
  bifdiag --body paper --json | jq .summary
  bifdiag classify --body paper --h 3.8 --l 3.25   U, E and P at one point
  bifdiag critical --body paper --l 3.25           relative equilibria at one l
  bifdiag show R5 --body paper                     a region in words
  bifdiag sphere --body paper --region R5          a picture of U
  bifdiag section --body paper --region R5         regular or chaotic?
  bifdiag orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,1
  bifdiag bodies                                   the named bodies

Numbers are decimals, decimals with exponent or rationals (1.1, 11e-1, 11/10) and are read exactly.
Exit status: 0 done; 2 the input is wrong; 1 anything else.";

/// The whole command line.
#[derive(Debug)]
pub struct Options {
    pub atlas: AtlasArguments,
    pub common: CommonArguments,
    pub command: Option<Command>,
}

/// What stands before the commands.
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
struct MainArguments {
    #[command(flatten)]
    atlas: AtlasArguments,
    #[command(flatten)]
    common: CommonArguments,
}

/// Commands that work on one thread: they take --threads, and do not show it.
const ON_ONE_THREAD: [&str; 15] = [
    "classes",
    "class",
    "show",
    "sphere",
    "orbit",
    "explore",
    "verify",
    "body",
    "state",
    "critical-spin",
    "campbell",
    "bodies",
    "schema",
    "completions",
    "man",
];

/// A command with its options, of which those of every command are shown only where they do something.
fn with_options<T: Args>(command: clap::Command) -> clap::Command {
    let command = T::augment_args(command);
    if !ON_ONE_THREAD.contains(&command.get_name()) {
        return command;
    }
    let threads = clap::Arg::new("threads").long("threads").value_name("N").allow_hyphen_values(true);
    command.arg(threads.value_parser(values::threads).hide(true))
}

/// Declares the commands: with clap's derive the options of all of them would be made at every start, which takes longer
/// than many an answer.
macro_rules! commands {
    ($(#[doc = $about:literal] $variant:ident($arguments:ty) = $name:literal, $examples:expr;)+) => {
        /// The commands; without one, `atlas` is meant.
        #[derive(Debug)]
        pub enum Command {
            $(#[doc = $about] $variant($arguments)),+
        }

        impl Command {
            /// Adds the commands to the main one; only those that are `wanted` with their options.
            fn add_to(mut main: clap::Command, wanted: impl Fn(&str) -> bool) -> clap::Command {
                $(
                    let mut command = clap::Command::new($name);
                    if wanted($name) {
                        command = with_options::<$arguments>(command);
                    }
                    let about = $about.trim_start();
                    main = main.subcommand(command.about(about).long_about(None::<&str>).after_help($examples));
                )+
                main
            }

            /// The command with this name.
            fn named(name: &str, matches: &mut clap::ArgMatches) -> Result<Option<Self>, clap::Error> {
                Ok(match name {
                    $($name => Some(Self::$variant(<$arguments as FromArgMatches>::from_arg_matches_mut(matches)?)),)+
                    _ => None,
                })
            }
        }
    };
}

commands! {
    /// Find every region of the (h, l) plane with its topology (the default)
    Atlas(AtlasArguments) = "atlas", atlas::EXAMPLES;
    /// Tell the type of U, E and P at one point (h, l), or at many
    Classify(ClassifyArguments) = "classify", classify::EXAMPLES;
    /// List all relative equilibria at one l, or at many
    Critical(CriticalArguments) = "critical", critical::EXAMPLES;
    /// Look at many bodies: which classes of diagrams they have
    Scan(Box<ScanArguments>) = "scan", scan::SCAN_EXAMPLES;
    /// Search for a body and a point that show a wanted type
    Find(FindArguments) = "find", find::FIND_EXAMPLES;
    /// List the classes of bodies, or tell where a body stands among them
    Classes(Box<ClassesArguments>) = "classes", classes::CLASSES_EXAMPLES;
    /// Show one class of bodies: its types, a body of it, the classes beside it
    Class(ClassArguments) = "class", classes::CLASS_EXAMPLES;
    /// Explain a region, a curve or an event in words
    Show(ShowArguments) = "show", show::EXAMPLES;
    /// Compute a Poincaré section on the PP-torus
    Section(SectionArguments) = "section", section::EXAMPLES;
    /// Draw U on the Poisson sphere at one point
    Sphere(SphereArguments) = "sphere", sphere::EXAMPLES;
    /// Follow the body's motion in space: attitude, Euler's angles, angular velocity
    Orbit(OrbitArguments) = "orbit", orbit::EXAMPLES;
    /// Open the explorer, a page for the browser, on this machine
    Explore(Box<ExploreArguments>) = "explore", explore::EXAMPLES;
    /// Check an atlas by other means than those that made it
    Verify(VerifyArguments) = "verify", verify::EXAMPLES;
    /// Show and draw a real part as it was understood
    Body(PartBodyArguments) = "body", part::BODY_EXAMPLES;
    /// Tell where a state lies: its (h, l), its region or curve, and whether it is stable
    State(Box<StateArguments>) = "state", spin::STATE_EXAMPLES;
    /// List the spins at which rotation about an axis changes its stability or its regions
    CriticalSpin(Box<CriticalSpinArguments>) = "critical-spin", spin::CRITICAL_SPIN_EXAMPLES;
    /// Draw the frequencies of small oscillations over the spin of a permanent axis
    Campbell(Box<CampbellArguments>) = "campbell", spin::CAMPBELL_EXAMPLES;
    /// List the named bodies
    Bodies(BodiesArguments) = "bodies", bodies::EXAMPLES;
    /// Print the JSON Schemas of the documents
    Schema(SchemaArguments) = "schema", schema::EXAMPLES;
    /// Print the completions of a shell
    Completions(CompletionsArguments) = "completions", pages::COMPLETIONS_EXAMPLES;
    /// Print the manual page, or write the pages of all commands
    Man(ManArguments) = "man", pages::MAN_EXAMPLES;
}

/// Options of every command.
#[derive(Debug, Args)]
pub struct CommonArguments {
    /// Use N threads for batches, scans and sections (default: all cores)
    #[arg(long, value_name = "N", global = true, allow_hyphen_values = true, value_parser = values::threads)]
    #[arg(help_heading = "General")]
    pub threads: Option<NonZeroUsize>,
    /// Tell on stderr how long each stage took, and how many questions were decided by f64, by intervals and by algebra
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
        Command::add_to(MainArguments::command(), |_| true)
    }

    /// The options of a command line; the first argument is the name of the program.
    pub fn from_arguments(arguments: impl IntoIterator<Item = OsString>) -> Result<Self, Refusal> {
        let arguments: Vec<OsString> = arguments.into_iter().collect();
        let is_named = |name: &str| arguments.iter().any(|argument| argument == name);
        let mut command = Command::add_to(MainArguments::command(), is_named);
        check_gone(&arguments)?;
        check_forms(&command, &arguments)?;
        check_values(&command, &arguments)?;
        let mut matches = match command.try_get_matches_from_mut(&arguments) {
            Ok(matches) => matches,
            // clap quotes arguments as they are: it is asked again about what may be shown.
            Err(error) => {
                let shown = arguments.iter().map(|argument| one_line(&argument.to_string_lossy()));
                return Err(command.try_get_matches_from_mut(shown).err().unwrap_or(error).into());
            }
        };
        let MainArguments { atlas, common } = MainArguments::from_arg_matches(&matches)?;
        let command = match matches.remove_subcommand() {
            None => None,
            Some((name, mut of_command)) => {
                check_no_stray_option(&command, &matches, &name)?;
                Command::named(&name, &mut of_command)?
            }
        };
        Ok(Self { atlas, common, command })
    }
}

/// Options of earlier versions, and what is written now.
const GONE: [(&str, &str); 4] = [
    ("rng-seed", "--seed K"),
    ("seeds", "--starts FILE.csv"),
    ("integrator", "--tol 1e-12: motions are integrated by Taylor series, and their tolerance says how finely"),
    ("step", "--tol 1e-12: motions are integrated by Taylor series, whose steps adapt to their tolerance"),
];

/// An option of an earlier version is named with its successor, unless some command still has it.
fn check_gone(arguments: &[OsString]) -> Result<(), Refusal> {
    let long = |text: &OsString| Some(text.to_str()?.strip_prefix("--")?.split('=').next()?.to_owned());
    for name in arguments.iter().filter_map(long) {
        let Some((option, successor)) = GONE.into_iter().find(|(option, _)| *option == name) else { continue };
        let command = Options::command();
        let mut everywhere = command.get_subcommands().chain([&command]).flat_map(clap::Command::get_arguments);
        if !everywhere.any(|argument| argument.get_long() == Some(option)) {
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

    /// Examples can be copied from a terminal of 80 columns; paragraphs are wrapped by the terminal's width alone.
    #[test]
    fn help_is_wrapped_once() {
        let root = Options::command();
        let scan = root.find_subcommand("scan").unwrap();
        for command in root.get_subcommands().chain(scan.get_subcommands()).chain([&root]) {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let (examples, prose) = help.split_once("\n\n").unwrap_or((&help, ""));
            assert!(examples.lines().all(|line| line.chars().count() <= 80), "{}: {examples}", command.get_name());
            let broken = |pair: &[&str]| !pair[0].is_empty() && !pair[1].is_empty() && !pair[1].starts_with(' ');
            let lines: Vec<&str> = prose.lines().collect();
            // What stands for itself on a line ends with a full stop.
            let broken = lines.windows(2).find(|pair| broken(pair) && !pair[0].ends_with('.'));
            assert_eq!(broken, None, "{}", command.get_name());
        }
    }
}
