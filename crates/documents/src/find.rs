//! Searches and witnesses as documents.

use bifdiag_schema::{FindDocument, NearestDocument, WitnessDocument};
use bifdiag_survey::search::{Answer, Nearest, Search, Target, Witness};

use crate::body::given;
use crate::classification::{components, margin};
use crate::command::{CommandLine, head};

/// A body and a point that show what was sought.
#[must_use]
pub fn witness(witness: &Witness) -> WitnessDocument {
    WitnessDocument {
        kind: witness.target.to_string(),
        body: given(&witness.body),
        h: witness.h.text().to_owned(),
        l: witness.l.text().to_owned(),
        components: components(&witness.components),
        margin: margin(&witness.margin),
        critical_points: witness.critical_points,
    }
}

/// The answer of a search; `command` asked for it.
#[must_use]
pub fn find(target: &Target, search: &Search, command: CommandLine) -> FindDocument {
    let mut document = FindDocument {
        head: head(command.json()),
        found: false,
        exists: None,
        why: None,
        sought: target.to_string(),
        witness: None,
        verified_by: Vec::new(),
        drawn: search.drawn,
        tried: search.tried,
        showing: search.showing,
        nearest: None,
    };
    match &search.answer {
        Answer::Found(found) => {
            document.found = true;
            document.verified_by = found.methods.iter().map(ToString::to_string).collect();
            document.witness = Some(witness(found));
        }
        Answer::NotFound { nearest: body } => document.nearest = body.as_ref().map(nearest),
        Answer::Excluded(theorem) => {
            document.exists = Some(false);
            document.why = Some(theorem.to_string());
        }
        Answer::Stopped => {}
    }
    document
}

fn nearest(nearest: &Nearest) -> NearestDocument {
    let [moments, center] = nearest.values;
    let [h, l] = nearest.at.map_or([None; 2], |at| at.map(Some));
    NearestDocument { moments, center, h, l, missing: nearest.missing }
}
