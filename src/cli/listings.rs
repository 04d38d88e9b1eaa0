//! What the program knows of itself: `bifdiag bodies`, `bifdiag schema`, `bifdiag completions` and `bifdiag man`.

use std::path::PathBuf;

use bifdiag_schema::{
    AtlasDocument, BatchErrorDocument, BodiesDocument, BorderDocument, ChaosMapDocument, ChaosPointDocument,
    ClassDocument, ClassesDocument, ClassificationDocument, ComparisonDocument, CriticalDocument, CriticalSpinDocument,
    EventTracksDocument, ExplanationDocument, FindDocument, GridDocument, ManifoldsDocument, MotionDocument,
    PartAnswerDocument, PeriodicDocument, PeriodicFamiliesDocument, PeriodicListDocument, PointProofDocument,
    ProvedMotionDocument, RowDocument, ScanSummaryDocument, SectionDocument, SectionsDocument, SpinDownDocument,
    StandingDocument, StateDocument, SteadyAxesDocument, SteadySpinsDocument,
};
use clap::{Args, Command, ValueEnum};
use schemars::{Schema, schema_for};

use super::export::{FileSet, answer};
use super::failure::{Failure, failed};
use super::terminal::{Report, Table, print};

pub const BODIES_EXAMPLES: &str = "\
Examples:
  bifdiag bodies
  bifdiag bodies --json | jq -r '.bodies[].name'";

/// `bifdiag bodies`.
#[derive(Debug, Args)]
pub struct BodiesArguments {
    /// Print the list as JSON
    #[arg(long)]
    pub json: bool,
}

pub fn bodies(arguments: &BodiesArguments) -> Result<(), Failure> {
    let document = bifdiag_documents::all_bodies();
    answer(arguments.json, &document, || {
        let mut table = Table::new(&["name", "A", "r", "note"]);
        for preset in &document.bodies {
            table.row([
                preset.name.clone(),
                preset.body.moments.join(","),
                preset.body.center.join(","),
                preset.note.clone(),
            ]);
        }
        table.text()
    })
}

pub const SCHEMA_EXAMPLES: &str = "\
Examples:
  bifdiag schema                 the names and what they describe
  bifdiag schema atlas > atlas.schema.json
  bifdiag schema --json          all of them in one JSON object";

/// `bifdiag schema`.
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// The document to describe
    #[arg(value_enum)]
    pub name: Option<Name>,
    /// Without NAME: all schemas in one JSON object
    #[arg(long)]
    pub json: bool,
}

/// The documents that have a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Name {
    /// atlas.json, the answer of `bifdiag atlas --json`
    Atlas,
    /// The answer of `bifdiag classify --json`, and a line of its batch
    Classify,
    /// The `meta` of `bifdiag classify --grid`
    Grid,
    /// The answer of `bifdiag critical --json`, and a line of its batch
    Critical,
    /// The answer of `bifdiag critical --spin … --json`
    SteadyAxes,
    /// The answer of `bifdiag section --json`, and the `meta` of its data
    Section,
    /// The answer of `bifdiag section --atlas … --json`
    Sections,
    /// The answer of `bifdiag orbit --json`, and the `meta` of its data
    Orbit,
    /// The answer of `bifdiag orbit --proved --json`, and the `meta` of its data
    ProvedOrbit,
    /// The answer of `bifdiag chaos --json` at one point
    Chaos,
    /// FILE.json of `bifdiag chaos --window`, and without `rows` the `meta` of its tables
    ChaosMap,
    /// The answer of `bifdiag body --json`
    Body,
    /// The answer of `bifdiag state --json`
    State,
    /// The answer of `bifdiag critical-spin --json` about one axis, or with a tolerance
    CriticalSpin,
    /// The answer of `bifdiag critical-spin --json` without an axis or a tolerance
    SteadySpins,
    /// The answer of `bifdiag spin-down --json`
    SpinDown,
    /// The answer of `bifdiag periodic --json`
    Periodic,
    /// The answer of `bifdiag periodic family --json`
    PeriodicFamilies,
    /// The answer of `bifdiag periodic list --json`
    PeriodicList,
    /// The answer of `bifdiag periodic manifolds --json`, and the `meta` of its data
    PeriodicManifolds,
    /// The answer of `bifdiag bodies --json`
    Bodies,
    /// The answer of `bifdiag explain --json`
    Explain,
    /// The answer to an invalid line of a batch
    BatchError,
    /// A line of `bifdiag scan --format jsonl`
    ScanRow,
    /// FILE.summary.json of `bifdiag scan`
    ScanSummary,
    /// The answer of `bifdiag scan border --json`
    ScanBorder,
    /// The answer of `bifdiag scan events --json`
    ScanEvents,
    /// The answer of `bifdiag compare --json`
    Compare,
    /// The answer of `bifdiag classify --certificate`
    PointProof,
    /// The answer of `bifdiag find --json`
    Find,
    /// data/classes.json, the answer of `bifdiag classes --json`
    Classes,
    /// The answer of `bifdiag class NAME --json`
    Class,
    /// The answer of `bifdiag classes --at --json`
    ClassesAt,
}

impl Name {
    fn schema(self) -> Schema {
        match self {
            Self::Atlas => schema_for!(AtlasDocument),
            Self::Classify => schema_for!(ClassificationDocument),
            Self::Grid => schema_for!(GridDocument),
            Self::Critical => schema_for!(CriticalDocument),
            Self::SteadyAxes => schema_for!(SteadyAxesDocument),
            Self::Section => schema_for!(SectionDocument),
            Self::Sections => schema_for!(SectionsDocument),
            Self::Orbit => schema_for!(MotionDocument),
            Self::ProvedOrbit => schema_for!(ProvedMotionDocument),
            Self::Chaos => schema_for!(ChaosPointDocument),
            Self::ChaosMap => schema_for!(ChaosMapDocument),
            Self::Body => schema_for!(PartAnswerDocument),
            Self::State => schema_for!(StateDocument),
            Self::CriticalSpin => schema_for!(CriticalSpinDocument),
            Self::SteadySpins => schema_for!(SteadySpinsDocument),
            Self::SpinDown => schema_for!(SpinDownDocument),
            Self::Periodic => schema_for!(PeriodicDocument),
            Self::PeriodicFamilies => schema_for!(PeriodicFamiliesDocument),
            Self::PeriodicList => schema_for!(PeriodicListDocument),
            Self::PeriodicManifolds => schema_for!(ManifoldsDocument),
            Self::Bodies => schema_for!(BodiesDocument),
            Self::Explain => schema_for!(ExplanationDocument),
            Self::BatchError => schema_for!(BatchErrorDocument),
            Self::ScanRow => schema_for!(RowDocument),
            Self::ScanSummary => schema_for!(ScanSummaryDocument),
            Self::ScanBorder => schema_for!(BorderDocument),
            Self::ScanEvents => schema_for!(EventTracksDocument),
            Self::Compare => schema_for!(ComparisonDocument),
            Self::PointProof => schema_for!(PointProofDocument),
            Self::Find => schema_for!(FindDocument),
            Self::Classes => schema_for!(ClassesDocument),
            Self::Class => schema_for!(ClassDocument),
            Self::ClassesAt => schema_for!(StandingDocument),
        }
    }
}

pub fn schema(arguments: &SchemaArguments) -> Result<(), Failure> {
    if let Some(name) = arguments.name {
        return answer(true, &name.schema(), String::new);
    }
    let mut table = Table::new(&["name", "describes"]);
    let mut all = serde_json::Map::new();
    for name in Name::value_variants() {
        let Some(value) = name.to_possible_value() else { continue };
        let description = value.get_help().map(ToString::to_string).unwrap_or_default();
        table.row([value.get_name().to_owned(), description]);
        all.insert(value.get_name().to_owned(), name.schema().to_value());
    }
    answer(arguments.json, &all, || table.text())
}

pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  bifdiag completions bash > ~/.local/share/bash-completion/completions/bifdiag
  bifdiag completions zsh > ~/.zfunc/_bifdiag
  bifdiag completions fish > ~/.config/fish/completions/bifdiag.fish";

pub const MAN_EXAMPLES: &str = "\
Examples:
  bifdiag man | man -l -
  bifdiag man --out ~/.local/share/man/man1      a page for each command";

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

pub fn completions(arguments: &CompletionsArguments, mut root: Command) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut root, "bifdiag", &mut text);
    print(&text)
}

pub fn man(arguments: &ManArguments, mut root: Command) -> Result<(), Failure> {
    root.build();
    let Some(directory) = &arguments.out else {
        return print(page(root)?);
    };
    let mut files = FileSet::new(directory);
    for command in root.get_subcommands().chain([&root]) {
        let file = clap_mangen::Man::new(command.clone()).get_filename();
        files.add(file, page(command.clone())?);
    }
    print(Report::of_written(&files.write()?).text())
}

fn page(command: Command) -> Result<Vec<u8>, Failure> {
    let failed = failed(format!("the manual page of {} cannot be made", command.get_name()));
    let mut text = Vec::new();
    clap_mangen::Man::new(command).render(&mut text).map_err(failed)?;
    Ok(text)
}
