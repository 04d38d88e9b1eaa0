//! What can go wrong when an atlas is checked.

use std::io;
use std::path::PathBuf;

use bifdiag_documents::reading::ReadError;
use bifdiag_schema::SCHEMA_VERSION;
use bifdiag_verify::Refused;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum VerifyError {
    #[error("{path}: {source}; give an atlas.json that can be read, or - for stdin", path = path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{path} is no atlas of version {SCHEMA_VERSION}: {source}", path = path.display())]
    NoAtlas { path: PathBuf, source: ReadError },
    #[error("{path} is refused: its bytes are not those that bifdiag writes for an atlas with certificate", path = path.display())]
    Damaged { path: PathBuf },
    #[error("the atlas is refused")]
    Refused(#[from] Refused),
}

impl CommandError for VerifyError {
    fn exit(&self) -> Exit {
        match self {
            Self::File { .. } | Self::NoAtlas { .. } => Exit::WrongInput,
            Self::Damaged { .. } | Self::Refused(_) => Exit::Failed,
        }
    }
}
