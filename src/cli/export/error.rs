//! Why a result could not be given out.

use std::io;
use std::path::PathBuf;

use bifdiag_plot::PlotError;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};
use crate::cli::terminal::OutputError;

/// Why a result could not be given out.
#[derive(Debug, Error)]
pub enum ExportError {
    #[error(transparent)]
    Output(#[from] OutputError),
    #[error(transparent)]
    Files(#[from] FilesError),
    #[error("the answer could not be written as JSON")]
    Json(#[from] serde_json::Error),
    #[error("the picture could not be drawn")]
    Plot(#[from] PlotError),
    #[error("the archive of arrays could not be made")]
    Archive(#[from] zip::result::ZipError),
    #[error("the table could not be written")]
    Table(#[source] io::Error),
    #[error("the table could not be written as CSV")]
    Csv(#[from] csv::Error),
    #[cfg(feature = "parquet")]
    #[error("the table could not be written as Parquet")]
    Parquet(#[from] ::parquet::errors::ParquetError),
}

impl CommandError for ExportError {
    fn exit(&self) -> Exit {
        match self {
            Self::Output(error) => error.exit(),
            _ => Exit::Failed,
        }
    }
}

/// Why files could not be written.
#[derive(Debug, Error)]
pub enum FilesError {
    #[error("cannot create the directory {path}: {source}; choose another with --out", path = path.display())]
    Directory { path: PathBuf, source: io::Error },
    #[error("cannot write {path}: {source}; nothing was changed", path = path.display())]
    Write { path: PathBuf, source: io::Error },
    #[error("cannot write {path}: a directory of this name is in the way; nothing was changed", path = path.display())]
    Occupied { path: PathBuf },
    #[error("cannot remove {path}, which tells of an earlier run: {source}", path = path.display())]
    Remove { path: PathBuf, source: io::Error },
    #[error("cannot replace {path}: {source}", path = path.display())]
    Replace { path: PathBuf, source: io::Error },
}

impl CommandError for FilesError {}
