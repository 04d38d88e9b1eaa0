//! Searches and witnesses as documents.

use bifdiag_schema::{CommandLine, FindDocument, NearestDocument, WitnessDocument};
use bifdiag_survey::search::{METHODS, NearestBody, SearchAnswer, SearchResult, Target, Witness};

use crate::body::{given, head};
use crate::classification::{components, margin};

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
pub fn find(target: &Target, search: &SearchResult, command: CommandLine) -> FindDocument {
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
        SearchAnswer::Found(found) => {
            document.found = true;
            document.verified_by = METHODS.map(str::to_owned).to_vec();
            document.witness = Some(witness(found));
        }
        SearchAnswer::NotFound { nearest: body } => document.nearest = body.as_ref().map(nearest),
        SearchAnswer::Excluded(theorem) => {
            document.exists = Some(false);
            document.why = Some(theorem.to_string());
        }
        SearchAnswer::Stopped => {}
    }
    document
}

fn nearest(nearest: &NearestBody) -> NearestDocument {
    let [moments, center] = nearest.values;
    let [h, l] = nearest.at.map_or([None; 2], |at| at.map(Some));
    NearestDocument { moments, center, h, l, missing: nearest.missing }
}
