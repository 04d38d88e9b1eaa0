//! What proofs add to an atlas: its checksum, and one point in it with its proof (`classify --certificate`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::{AtlasDocument, CertifiedSlab, ComponentDocument, Head, Number, Status, json};

/// The answer of `classify --certificate`: where a point lies, and the proof. The atlas of the body with its certificate proves the regions; the curves over
/// the momentum of the point, with their places, prove in which of them it lies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PointProofDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// Energy as given.
    #[schemars(with = "Number")]
    pub h: String,
    /// Vertical angular momentum as given.
    #[schemars(with = "Number")]
    pub l: String,
    /// `regular` or `forbidden`.
    pub status: Status,
    /// Id of the region; null where it is forbidden.
    pub region: Option<String>,
    /// The components of U_hl; none where it is forbidden.
    pub components: Vec<ComponentDocument>,
    /// Number of the slab of the certificate in which l²/2 lies, from 0.
    pub slab: usize,
    /// The curves over l²/2 by rising h, in the units of the certificate.
    pub level: CertifiedSlab,
    /// The atlas of the body with its certificate.
    pub atlas: AtlasDocument,
}

/// SHA-256 of an atlas whose checksum is left empty, in hexadecimal.
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn checksum(document: &AtlasDocument) -> Result<String, serde_json::Error> {
    let mut bare = document.clone();
    if let Some(certificate) = &mut bare.certificate {
        certificate.checksum.clear();
    }
    Ok(base16ct::lower::encode_string(&Sha256::digest(json(&bare)?)))
}
