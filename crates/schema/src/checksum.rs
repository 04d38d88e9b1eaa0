//! The checksum of an atlas with a certificate.

use sha2::{Digest, Sha256};

use super::{AtlasDocument, json};

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
