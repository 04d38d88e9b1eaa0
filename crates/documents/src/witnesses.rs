//! The witnesses that come with the program.

use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::topology::{Component, Poles};
use bifdiag_numbers::{Number, ParseNumberError};
use bifdiag_schema::{ComponentDocument, WitnessDocument};
use bifdiag_survey::search::KnownPoint;
use thiserror::Error;

/// `data/witnesses.json` of the repository; a test keeps the two the same.
const SHIPPED: &str = include_str!("../data/witnesses.json");

/// Why a document is not that of a witness.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ReadWitnessError {
    /// A number of the point.
    #[error(transparent)]
    Number(#[from] ParseNumberError),
    /// The body.
    #[error(transparent)]
    Body(#[from] BodyError),
}

/// The shipped witnesses: for each type that is known to occur a body and a point, bodies that exist before others.
///
/// # Panics
/// Never: the file is a part of this package.
#[must_use]
pub fn shipped_witnesses() -> Vec<KnownPoint> {
    let documents: Vec<WitnessDocument> = serde_json::from_str(SHIPPED).expect("the shipped witnesses are whole");
    documents.iter().map(|document| read_witness(document).expect("the shipped witnesses are whole")).collect()
}

/// The point of a witness with what it says to show.
///
/// # Errors
/// [`ReadWitnessError`].
pub fn read_witness(document: &WitnessDocument) -> Result<KnownPoint, ReadWitnessError> {
    let [h, l]: [Number; 2] = [document.h.parse()?, document.l.parse()?];
    let body = Body::parse(&document.body.moments, &document.body.center)?;
    Ok(KnownPoint { body, h, l, components: document.components.iter().map(read_component).collect() })
}

fn read_component(document: &ComponentDocument) -> Component {
    let poles = document.poles.as_ref().map(|signs| {
        let has = |sign: &str| signs.iter().any(|pole| pole == sign);
        Poles { plus: has("+"), minus: has("-") }
    });
    Component { boundary_circles: document.boundary_circles, poles }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_exact::Accuracy;
    use bifdiag_survey::search::{Exclusion, SearchDomain, Target, known_witness};

    #[test]
    fn the_published_file_is_the_shipped_one() {
        let published = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/witnesses.json");
        // A packaged crate has no repository around it.
        if let Ok(text) = std::fs::read_to_string(published) {
            assert!(text == SHIPPED, "copy data/witnesses.json to crates/documents/data/");
        }
    }

    #[test]
    fn every_shipped_witness_is_confirmed_for_its_type() {
        let documents: Vec<WitnessDocument> = serde_json::from_str(SHIPPED).unwrap();
        assert_eq!(documents.len(), shipped_witnesses().len());
        for document in &documents {
            let target = Target::of_type(&document.kind).or_else(|_| Target::of_signature(&document.kind)).unwrap();
            assert_eq!(Exclusion::of(&target), None, "{}", document.kind);
            let known = [read_witness(document).unwrap()];
            let everything = SearchDomain { physical: false, moment_ratio: f64::INFINITY };
            let witness = known_witness(&known, &target, &everything, Accuracy::Exact).unwrap();
            assert_eq!(crate::witness(&witness), *document);
        }
    }

    #[test]
    fn bodies_that_exist_are_asked_for() {
        let known = shipped_witnesses();
        let physical = SearchDomain { physical: true, ..SearchDomain::default() };
        for kind in ["k1n0", "k2n0", "k1n1", "k2n1", "k3n1", "k0n2", "k1n2", "k2n2", "k3n2", "k4n1", "k4n2", "M5"] {
            let witness = known_witness(&known, &Target::of_type(kind).unwrap(), &physical, Accuracy::Exact);
            assert!(!witness.unwrap().body.flags().unphysical, "{kind}");
        }
        assert_eq!(known_witness(&known, &Target::of_type("k5n1").unwrap(), &physical, Accuracy::Exact), None);
        assert_eq!(known_witness(&known, &Target::CriticalPoints(6), &physical, Accuracy::Exact), None);
    }
}
