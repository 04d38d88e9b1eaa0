//! Why there is no atlas.

use bifdiag_exact::{ConversionError, ProofError};
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

/// The input is wrong.
#[derive(Debug, Error)]
pub enum AtlasInput {
    #[error("--certificate speaks of the whole plane and --window of a part of it; leave out one of them")]
    CertificateOfWindow,
    #[error("--certificate is a proof and --accuracy fast does without; leave out one of them")]
    FastCertificate,
    #[error("--no-polygons is now --no-drawing, which leaves out polylines, polygons, widths and views")]
    NoPolygons,
}

impl CommandError for AtlasInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

#[derive(Debug, Error)]
pub enum NoAtlas {
    #[error("the atlas could not be made")]
    Atlas(#[from] bifdiag_exact::AnswerError),
    #[error("the atlas could not be proved")]
    Proof(#[from] ProofError),
    #[error("the proved atlas could not be written")]
    Conversion(#[from] ConversionError),
    #[error("the answer could not be written as JSON")]
    Json(#[from] serde_json::Error),
}

impl CommandError for NoAtlas {}
