//! The whole command line: the commands, what is common to them, and command lines that are not accepted.

use std::ffi::OsString;
use std::num::NonZeroUsize;

use bifdiag_body::{Number, Preset};
use bifdiag_schema::one_line;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::parser::ValueSource;
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser};

use super::atlas::{self, AtlasArguments};
use super::chaos::{self, ChaosArguments};
use super::classes::{self, ClassArguments, ClassesArguments};
use super::classify::{self, ClassifyArguments};
use super::compare::{self, CompareArguments};
use super::critical::{self, CriticalArguments};
use super::explain::{self, ExplainArguments};
use super::explore::{self, ExploreArguments};
use super::failure::Failure;
use super::find::{self, FindArguments};
use super::input::{PART, values};
use super::listings::{self, BodiesArguments, CompletionsArguments, ManArguments, SchemaArguments};
use super::orbit::{self, OrbitArguments};
use super::part::{self, PartBodyArguments};
use super::periodic::{self, PeriodicArguments};
use super::scan::{self, ScanArguments};
use super::section::{self, SectionArguments};
use super::show::{self, ShowArguments};
use super::sphere::{self, SphereArguments};
use super::spin::{self, CampbellArguments, CriticalSpinArguments, SpinDownArguments, StateArguments};
use super::verify::{self, VerifyArguments};

const ABOUT: &str = "Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body";

const MAIN_EXAMPLES: &str = "\
Examples:
  bifdiag --A 2,1.1,1 --r 0.94868,0,0.61623        all regions of (h, l)
  bifdiag classify --body paper --h 3.8 --l 3.25   U, E and P at one point
  bifdiag section --body paper --region R5         regular or chaotic?

Numbers may be decimals, decimals with an exponent or fractions (1.1, 11e-1, 11/10) and are read exactly. Without a \
command, bifdiag runs `atlas`; `bifdiag atlas --help` describes all of its options.
Exit status: 0 success; 2 invalid input; 1 any other failure.";

/// The whole command line.
#[derive(Debug)]
pub struct Options {
    pub atlas: AtlasArguments,
    pub common: CommonArguments,
    pub command: Option<Command>,
}

/// The options before the commands.
#[derive(Debug, Parser)]
#[command(
    name = "bifdiag",
    version,
    about = ABOUT,
    arg_required_else_help = true,
    max_term_width = 100
)]
struct MainArguments {
    #[command(flatten)]
    atlas: AtlasArguments,
    #[command(flatten)]
    common: CommonArguments,
}

/// Where the options of every command are described.
const GENERAL: &str = "Every command takes --threads N, --timings, -q and -v; `bifdiag --help` describes them.";

/// The main command. Its page describes the options of every command, and of the atlas those of the first hour.
fn main_command() -> clap::Command {
    let is_of_atlas = |argument: &clap::Arg| {
        let is_rare = argument.is_hide_short_help_set() && !argument.is_global_set();
        is_rare || argument.get_help_heading() == Some(PART)
    };
    let main = MainArguments::command().disable_help_subcommand(true);
    with_examples(main, MAIN_EXAMPLES)
        .mut_args(|argument| if is_of_atlas(&argument) { argument.hide(true) } else { argument })
}

/// The options of every command, which the pages of the commands do not repeat.
fn general_options(main: &clap::Command) -> Vec<clap::Arg> {
    main.get_arguments()
        .filter(|argument| argument.is_global_set())
        .map(|argument| argument.clone().hide(true))
        .collect()
}

/// A command whose short page ends with its examples, and whose long page with all that is to be said.
fn with_examples(command: clap::Command, text: &str) -> clap::Command {
    let examples = text.split("\n\n").next().unwrap_or_default();
    command.after_help(examples.to_owned()).after_long_help(text.to_owned())
}

/// Declares the commands: with clap's derive the options of all of them would be made at every start, which takes longer
/// than many an answer.
macro_rules! commands {
    ($(#[doc = $about:literal] $variant:ident($arguments:ty) = $name:literal, $examples:expr;)+) => {
        /// The commands; without one, `atlas` is meant.
        #[derive(Debug)]
        // One value is made in a run, and moved once.
        #[allow(clippy::large_enum_variant)]
        pub enum Command {
            $(#[doc = $about] $variant($arguments)),+
        }

        impl Command {
            /// Adds the commands to the main one; only those that are `wanted` with their options.
            fn add_to(mut main: clap::Command, wanted: impl Fn(&str) -> bool) -> clap::Command {
                let general = general_options(&main);
                $(
                    let mut command = clap::Command::new($name);
                    if wanted($name) {
                        command = <$arguments>::augment_args(command).args(&general);
                    }
                    command = command.about($about.trim_start()).long_about(None::<&str>);
                    main = main.subcommand(with_examples(command, &format!("{}\n\n{GENERAL}", $examples)));
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
    /// Classify a point (h, l), or many: the types of U, E and P
    Classify(ClassifyArguments) = "classify", classify::EXAMPLES;
    /// List all relative equilibria at one l, or at many
    Critical(CriticalArguments) = "critical", critical::EXAMPLES;
    /// Find the classes of diagrams of many bodies
    Scan(Box<ScanArguments>) = "scan", scan::SCAN_EXAMPLES;
    /// Search for a body and a point that have a given type
    Find(FindArguments) = "find", find::FIND_EXAMPLES;
    /// List the classes of bodies, or find the class of a body and its borders
    Classes(Box<ClassesArguments>) = "classes", classes::CLASSES_EXAMPLES;
    /// Show one class of bodies: its types, an example, and the neighbouring classes
    Class(ClassArguments) = "class", classes::CLASS_EXAMPLES;
    /// Compare two bodies: regions, events and stability, and the borders between them
    Compare(CompareArguments) = "compare", compare::COMPARE_EXAMPLES;
    /// Explain a region, a curve or an event in words
    Show(ShowArguments) = "show", show::EXAMPLES;
    /// Explain a term that the program prints
    Explain(ExplainArguments) = "explain", explain::EXPLAIN_EXAMPLES;
    /// Compute a Poincaré section on the PP-torus
    Section(SectionArguments) = "section", section::EXAMPLES;
    /// Measure the chaotic share of the energy surface, at one point or over a window
    Chaos(Box<ChaosArguments>) = "chaos", chaos::CHAOS_EXAMPLES;
    /// Draw U on the Poisson sphere at one point
    Sphere(SphereArguments) = "sphere", sphere::EXAMPLES;
    /// Follow the body's motion in space: attitude, Euler's angles, angular velocity
    Orbit(OrbitArguments) = "orbit", orbit::EXAMPLES;
    /// Find the periodic orbits at a point, or follow families of them
    Periodic(PeriodicArguments) = "periodic", periodic::PERIODIC_EXAMPLES;
    /// Open the explorer, an interactive page, in the browser
    Explore(Box<ExploreArguments>) = "explore", explore::EXAMPLES;
    /// Check the proof of an atlas or of a point, with separate code
    Verify(VerifyArguments) = "verify", verify::EXAMPLES;
    /// Show how a real part was read, and draw it
    Body(PartBodyArguments) = "body", part::BODY_EXAMPLES;
    /// Locate a state: its (h, l), its region or curve, and whether it is stable
    State(Box<StateArguments>) = "state", spin::STATE_EXAMPLES;
    /// List the spins at which rotation about an axis changes its stability or its regions
    CriticalSpin(Box<CriticalSpinArguments>) = "critical-spin", spin::CRITICAL_SPIN_EXAMPLES;
    /// Plot the frequencies of small oscillations against the spin of a steady rotation
    Campbell(Box<CampbellArguments>) = "campbell", spin::CAMPBELL_EXAMPLES;
    /// Follow a steady rotation, slowed by friction, until it comes to rest or falls
    SpinDown(Box<SpinDownArguments>) = "spin-down", spin::SPIN_DOWN_EXAMPLES;
    /// List the named bodies
    Bodies(BodiesArguments) = "bodies", listings::BODIES_EXAMPLES;
    /// Print the JSON Schemas of the documents
    Schema(SchemaArguments) = "schema", listings::SCHEMA_EXAMPLES;
    /// Print shell completions
    Completions(CompletionsArguments) = "completions", listings::COMPLETIONS_EXAMPLES;
    /// Print the manual page, or write the pages of all commands
    Man(ManArguments) = "man", listings::MAN_EXAMPLES;
}

/// Options of every command.
#[derive(Debug, Args)]
#[command(next_help_heading = "Every command")]
pub struct CommonArguments {
    /// Use N threads for batches, scans and sections (default: all cores)
    #[arg(long, value_name = "N", global = true, allow_hyphen_values = true, value_parser = values::threads)]
    #[arg(hide_short_help = true)]
    pub threads: Option<NonZeroUsize>,
    /// Report on stderr how long it took, stage by stage where there are several, and how many questions f64, intervals and
    /// algebra decided where there were any
    #[arg(long, global = true, hide_short_help = true)]
    pub timings: bool,
    /// Suppress warnings and progress
    #[arg(short, long, global = true, conflicts_with = "verbose", hide_short_help = true)]
    pub quiet: bool,
    /// Report on stderr what `atlas` computes; with -vv also which bodies `find` rejected
    #[arg(short, long, global = true, action = ArgAction::Count, hide_short_help = true)]
    pub verbose: u8,
}

/// A command line that is not accepted; also the answer to --help and --version.
#[derive(Debug)]
pub enum Refusal {
    Clap(clap::Error),
    Failure(Failure),
}

impl From<clap::Error> for Refusal {
    fn from(error: clap::Error) -> Self {
        Self::Clap(error)
    }
}

impl From<Failure> for Refusal {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

impl Options {
    /// The clap command, for completions and manual pages.
    pub fn command() -> clap::Command {
        Command::add_to(main_command(), |_| true)
    }

    /// The name of each command, also of those of another one such as `scan map`, and what it does.
    pub fn abouts() -> Vec<(String, String)> {
        fn add(abouts: &mut Vec<(String, String)>, of: &clap::Command, before: &str) {
            for command in of.get_subcommands() {
                let name = format!("{before}{}", command.get_name());
                let about = command.get_about().map(ToString::to_string).unwrap_or_default();
                add(abouts, command, &format!("{name} "));
                abouts.push((name, about));
            }
        }
        let mut abouts = Vec::new();
        add(&mut abouts, &Self::command(), "");
        abouts
    }

    /// The options of a command line; the first argument is the name of the program.
    pub fn from_arguments(arguments: impl IntoIterator<Item = OsString>) -> Result<Self, Refusal> {
        let arguments: Vec<OsString> = arguments.into_iter().collect();
        let is_named = |name: &str| arguments.iter().any(|argument| argument == name);
        let mut command = Command::add_to(main_command(), is_named);
        check_gone(&arguments)?;
        check_forms(&command, &arguments)?;
        check_values(&command, &arguments)?;
        let mut matches = match command.try_get_matches_from_mut(&arguments) {
            Ok(matches) => matches,
            // clap quotes arguments as they are: it is asked again about what may be shown.
            Err(error) => {
                let shown = arguments.iter().map(|argument| one_line(&argument.to_string_lossy()));
                let error = command.try_get_matches_from_mut(shown).err().unwrap_or(error);
                check_part(&command, &error)?;
                return Err(without_wild_guess(error).into());
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

/// The options of a real part at a command that knows only A and r.
fn check_part(command: &clap::Command, error: &clap::Error) -> Result<(), Failure> {
    let Some(ContextValue::String(unknown)) = error.get(ContextKind::InvalidArg) else { return Ok(()) };
    let mut of_parts = command.get_arguments().filter(|argument| argument.get_help_heading() == Some(PART));
    let is_of_part = of_parts.any(|part| part.get_long() == unknown.strip_prefix("--"));
    if error.kind() != ErrorKind::UnknownArgument || !is_of_part {
        return Ok(());
    }
    Err(Failure::input(format!(
        "{unknown} describes a real part, which this command does not read; `bifdiag body` prints the part's --A and \
        --r: give those"
    )))
}

/// clap compares names by the letters that they share: of `--format` it would say that `--r` is similar, and of an unknown
/// option that it can be passed as a value, which no value of ours looks like.
fn without_wild_guess(mut error: clap::Error) -> clap::Error {
    let names = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    };
    let guesses = [
        (ContextKind::InvalidArg, ContextKind::SuggestedArg),
        (ContextKind::InvalidSubcommand, ContextKind::SuggestedSubcommand),
    ];
    let wild = guesses.map(|(written, guessed)| {
        let written = names(written).concat();
        (guessed, !names(guessed).iter().any(|guess| is_slip(&written, guess)))
    });
    for (guessed, _) in wild.into_iter().filter(|(_, wild)| *wild) {
        error.remove(guessed);
    }
    if error.kind() == ErrorKind::UnknownArgument {
        error.remove(ContextKind::Suggested);
    }
    error
}

/// A typing error changes at most two neighbouring letters of a name.
fn is_slip(written: &str, meant: &str) -> bool {
    let [written, meant] = [written, meant].map(|name| name.trim_start_matches('-').as_bytes());
    let start = written.iter().zip(meant).take_while(|(p, q)| p == q).count();
    let ends = written[start..].iter().rev().zip(meant[start..].iter().rev());
    let end = ends.take_while(|(p, q)| p == q).count();
    start + end > 0 && start + end + 2 >= written.len().max(meant.len())
}

/// Options of earlier versions, and what is written now.
const GONE: [(&str, &str); 5] = [
    ("no-polygons", "--no-drawing, which leaves out polylines, polygons, widths and views"),
    ("rng-seed", "--seed K"),
    ("seeds", "--starts FILE.csv"),
    ("integrator", "--tol 1e-12: motions are integrated by Taylor series to this tolerance"),
    ("step", "--tol 1e-12: motions are integrated by Taylor series, whose steps adapt to this tolerance"),
];

/// An option of an earlier version is named with its successor, unless some command still has it.
fn check_gone(arguments: &[OsString]) -> Result<(), Failure> {
    let long = |text: &OsString| Some(text.to_str()?.strip_prefix("--")?.split('=').next()?.to_owned());
    for name in arguments.iter().filter_map(long) {
        let Some((option, successor)) = GONE.into_iter().find(|(option, _)| *option == name) else { continue };
        let command = Options::command();
        let mut everywhere = command.get_subcommands().chain([&command]).flat_map(clap::Command::get_arguments);
        if !everywhere.any(|argument| argument.get_long() == Some(option)) {
            return Err(Failure::input(format!("--{option} was removed; use {successor}")));
        }
    }
    Ok(())
}

/// Forms that are near to right ones: `--A 2 1.1 1`, and the name of a body where a command should be.
fn check_forms(command: &clap::Command, arguments: &[OsString]) -> Result<(), Failure> {
    let texts: Vec<&str> = arguments.iter().filter_map(|text| text.to_str()).collect();
    let number = |text: &&&str| text.parse::<Number>().is_ok();
    for (place, option) in texts.iter().enumerate().filter(|(_, text)| matches!(**text, "--A" | "--r" | "--com")) {
        let list: Vec<&str> = texts[place + 1..].iter().take_while(number).copied().collect();
        if let [_, value, ..] = list[..] {
            let right = format!("write a list with commas: {option} {}", list.join(","));
            return Err(Failure::input(format!("{value} is not joined to {option}; {right}")));
        }
    }
    match texts.get(1) {
        Some(name) if command.find_subcommand(name).is_none() && Preset::find(name).is_some() => {
            Err(Failure::input(format!("{name} is a body, not a command; write bifdiag --body {name}")))
        }
        _ => Ok(()),
    }
}

/// Values may start with a hyphen, so `--A --r 1,0,0` would take `--r` for the value of `--A`.
fn check_values(command: &clap::Command, arguments: &[OsString]) -> Result<(), Failure> {
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
            let (option, next) = (option.to_string_lossy(), next.to_string_lossy());
            let value: String = names.iter().map(ToString::to_string).collect();
            return Err(Failure::input(format!(
                "{option} has no value ({next} follows it); write it as {option} {value}, or {option}=VALUE"
            )));
        }
    }
    Ok(())
}

/// Options of the atlas in front of another command would be ignored in silence.
fn check_no_stray_option(command: &clap::Command, matches: &clap::ArgMatches, name: &str) -> Result<(), Failure> {
    let stray = command.get_arguments().find(|argument| {
        let id = argument.get_id().as_str();
        let there = matches.ids().any(|there| there == argument.get_id());
        !argument.is_global_set() && there && matches.value_source(id) == Some(ValueSource::CommandLine)
    });
    match stray.and_then(clap::Arg::get_long) {
        Some(long) => Err(Failure::input(format!(
            "--{long} is before the command {name}; write it after: bifdiag {name} --{long} …"
        ))),
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
            let help = command.get_after_long_help().or(command.get_after_help());
            let help = help.map(ToString::to_string).unwrap_or_default();
            let (examples, prose) = help.split_once("\n\n").unwrap_or((&help, ""));
            assert!(examples.lines().all(|line| line.chars().count() <= 80), "{}: {examples}", command.get_name());
            let broken = |pair: &[&str]| !pair[0].is_empty() && !pair[1].is_empty() && !pair[1].starts_with(' ');
            let lines: Vec<&str> = prose.lines().collect();
            // A sentence on a line of its own ends with a full stop.
            let broken = lines.windows(2).find(|pair| broken(pair) && !pair[0].ends_with('.'));
            assert_eq!(broken, None, "{}", command.get_name());
        }
    }
}
