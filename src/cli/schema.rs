//! `bifdiag schema`: the JSON Schemas of the documents.

use bifdiag_schema::{
    AtlasDocument, BatchErrorDocument, BodiesDocument, BorderDocument, ClassDocument, ClassesDocument,
    ClassificationDocument, CriticalDocument, CriticalSpinDocument, FindDocument, GridDocument, MotionDocument,
    PartAnswerDocument, RowDocument, ScanSummaryDocument, SectionDocument, SectionsDocument, StandingDocument,
    StateDocument, SteadyAxesDocument,
};
use clap::{Args, ValueEnum};
use schemars::{Schema, schema_for};

use super::export::answer;
use super::failure::Failure;
use super::terminal::Table;

pub const EXAMPLES: &str = "\
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
    /// The answer of `bifdiag body --json`
    Body,
    /// The answer of `bifdiag state --json`
    State,
    /// The answer of `bifdiag critical-spin --json`
    CriticalSpin,
    /// The answer of `bifdiag bodies --json`
    Bodies,
    /// What stands for a wrong line of a batch
    BatchError,
    /// A line of `bifdiag scan --format jsonl`
    ScanRow,
    /// FILE.summary.json of `bifdiag scan`
    ScanSummary,
    /// The answer of `bifdiag scan border --json`
    ScanBorder,
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
            Self::Body => schema_for!(PartAnswerDocument),
            Self::State => schema_for!(StateDocument),
            Self::CriticalSpin => schema_for!(CriticalSpinDocument),
            Self::Bodies => schema_for!(BodiesDocument),
            Self::BatchError => schema_for!(BatchErrorDocument),
            Self::ScanRow => schema_for!(RowDocument),
            Self::ScanSummary => schema_for!(ScanSummaryDocument),
            Self::ScanBorder => schema_for!(BorderDocument),
            Self::Find => schema_for!(FindDocument),
            Self::Classes => schema_for!(ClassesDocument),
            Self::Class => schema_for!(ClassDocument),
            Self::ClassesAt => schema_for!(StandingDocument),
        }
    }
}

pub fn run(arguments: &SchemaArguments) -> Result<(), Failure> {
    if let Some(name) = arguments.name {
        return Ok(answer(true, &name.schema(), String::new)?);
    }
    let mut table = Table::new(&["name", "describes"]);
    let mut all = serde_json::Map::new();
    for name in Name::value_variants() {
        let Some(value) = name.to_possible_value() else { continue };
        let description = value.get_help().map(ToString::to_string).unwrap_or_default();
        table.row([value.get_name().to_owned(), description]);
        all.insert(value.get_name().to_owned(), name.schema().to_value());
    }
    Ok(answer(arguments.json, &all, || table.text())?)
}
