//! What can be wrong about a scan.

use std::io;
use std::path::PathBuf;

use bifdiag_documents::scan::ReadScanError;
use bifdiag_survey::DesignError;
use thiserror::Error;

use super::table::TableError;
use crate::cli::failure::{CommandError, Exit};

/// The input is wrong.
#[derive(Debug, Error)]
pub enum ScanInput {
    #[error(
        "nothing says which bodies to scan; give --family general --samples 100000, --family katok, or a body with \
         --vary A2=0.5:2:200"
    )]
    NoFamily,
    #[error("--family and {option} both describe the bodies; give one of them")]
    FamilyAndBody { option: &'static str },
    #[error(
        "--samples is missing; give --samples 100000, or ranges with numbers of grid values such as --vary A2=0.5:2:200"
    )]
    NoSamples,
    #[error("{option}: {source}")]
    Design { option: &'static str, source: DesignError },
    #[error("--out is missing; give a file such as --out scan.parquet (or .csv, .jsonl), or --out - for stdout")]
    NoOut,
    #[error("--out {path}: the ending says no format; use .parquet, .csv or .jsonl, or say it with --format", path = path.display())]
    NoFormat { path: PathBuf },
    #[error("{path}: the ending is none of .parquet, .csv and .jsonl; name a file with the rows of a scan", path = path.display())]
    NoRows { path: PathBuf },
    #[error("--out -: Parquet cannot be written to stdout; use --format csv or --format jsonl")]
    ParquetToStdout,
    #[error("--json and --out - both want stdout; write the rows to a file, or leave out --json")]
    TwoToStdout,
    #[error(
        "{path}: this bifdiag was built without the feature `parquet`; use .csv or .jsonl, or build it with \
         --features parquet", path = path.display()
    )]
    NoParquet { path: PathBuf },
    #[error(
        "{journal} holds the beginning of another scan ({difference} differs); finish that scan with its own options, \
         choose another --out, or give --restart to discard it", journal = journal.display()
    )]
    OtherJournal { journal: PathBuf, difference: &'static str },
    #[error("{journal}: another process is working on this scan; wait for it, or choose another --out", journal = journal.display())]
    Busy { journal: PathBuf },
    #[error("{path}: {source}", path = path.display())]
    Table { path: PathBuf, source: TableError },
    #[error("{path}: body {body}: {source}; name a file with the rows of a scan", path = path.display())]
    Row { path: PathBuf, body: u64, source: ReadScanError },
    #[error("merge needs shards; name their files, such as shard-*.parquet")]
    NoShards,
    #[error("{path}: its summary {summary} cannot be read ({reason}); a shard is its file with rows and its summary",
        path = path.display(), summary = summary.display())]
    NoSummary { path: PathBuf, summary: PathBuf, reason: String },
    #[error("{path}: {source}; name the shards to be merged", path = path.display())]
    Shard { path: PathBuf, source: io::Error },
    #[error("{path} is not what its summary describes (its SHA-256 is another): it is truncated or altered; make it again",
        path = path.display())]
    Altered { path: PathBuf },
    #[error("{path}: row {row} has number {found} where {wanted} should stand; make this shard again", path = path.display())]
    WrongRow { path: PathBuf, row: u64, found: u64, wanted: u64 },
    #[error("{path} has {found} rows where its summary says {wanted}; make this shard again", path = path.display())]
    WrongCount { path: PathBuf, found: u64, wanted: u64 },
    #[error("{path} belongs to another scan than {first}: {difference} differs", path = path.display(), first = first.display())]
    Foreign { path: PathBuf, first: PathBuf, difference: &'static str },
    #[error("{second} overlaps {first}: both hold body {body}; name each shard once", first = first.display(), second = second.display())]
    Overlap { first: PathBuf, second: PathBuf, body: u64 },
    #[error("bodies {from} to {to} of {count} are missing ({place}); make that shard too and name it", to = to - 1)]
    Missing { from: u64, to: u64, count: u64, place: String },
    #[error("{path}: the output is one of the shards; choose another --out", path = path.display())]
    OutIsShard { path: PathBuf },
    #[error("{path}: no bodies are in it; name a file with the rows of a scan", path = path.display())]
    Empty { path: PathBuf },
    #[error("--out {path}: {source}; choose a file in a folder that is there", path = path.display())]
    Out { path: PathBuf, source: io::Error },
    #[error("{option} {name}: {reason}")]
    Axis { option: &'static str, name: String, reason: String },
    #[error("{0}")]
    Border(String),
    #[error("{0}")]
    Find(String),
}

/// Something else went wrong.
#[derive(Debug, Error)]
pub enum ScanFailure {
    #[error("cannot write {path}", path = path.display())]
    Write { path: PathBuf, source: io::Error },
    #[error("cannot write {path}", path = path.display())]
    Table { path: PathBuf, source: TableError },
    #[error("cannot read {path} back", path = path.display())]
    Journal { path: PathBuf, source: io::Error },
    #[error("cannot read {path} back", path = path.display())]
    JournalRow { path: PathBuf, source: serde_json::Error },
    #[error("cannot read body {body} of {path} back", path = path.display())]
    Row { path: PathBuf, body: u64, source: ReadScanError },
    #[error("the answer could not be written as JSON")]
    Json(#[from] serde_json::Error),
}

impl CommandError for ScanInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

impl CommandError for ScanFailure {}
