//! Witnesses as documents.

use schema::WitnessDocument;
use survey::search::Witness;

use crate::body::texts;
use crate::classification::{candidate, margin};

/// A body and a point that show what was sought.
#[must_use]
pub fn witness(witness: &Witness) -> WitnessDocument {
    WitnessDocument {
        kind: witness.target.to_string(),
        moments: texts(witness.body.moments()),
        center: texts(witness.body.center()),
        h: witness.h.text().to_owned(),
        l: witness.l.text().to_owned(),
        components: candidate(&witness.components),
        margin: margin(&witness.margin),
        critical_points: witness.critical_points,
    }
}
