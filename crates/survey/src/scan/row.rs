//! What a scan records of one body.

use std::collections::{BTreeMap, BTreeSet};

use crate::signature::{ComponentType, Signature};
use bifdiag_body::{Body, Flags};
use bifdiag_diagram::arrangement::Change;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::{Class, ClassName, MapError, Unclassified};
use bifdiag_exact::{Accuracy, AnswerError};
use bifdiag_schema::RowStatus;

/// One body of a scan.
#[derive(Clone, Debug, PartialEq)]
pub struct ScanRow {
    /// Number of the body in the scan, from 0.
    pub index: u64,
    /// A and r.
    pub values: [[f64; 3]; 2],
    /// How far the body was understood.
    pub status: RowStatus,
    /// The class of its diagram.
    pub class: Option<ClassName>,
    /// What its diagram shows, if there is an atlas.
    pub diagram: Option<DiagramCounts>,
    /// What is special about it.
    pub flags: Flags,
    /// Why the body has no class.
    pub error: Option<String>,
}

/// What a diagram shows.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramCounts {
    /// Number of regions.
    pub regions: u32,
    /// Number of cusps.
    pub cusps: u32,
    /// Number of pitchforks.
    pub pitchforks: u32,
    /// Number of crossings.
    pub crossings: u32,
    /// The largest number of relative equilibria at one l; a circle counts once.
    pub critical_points: u32,
    /// How many regions have each signature.
    pub signatures: BTreeMap<Signature, u32>,
    /// How many regions show a component of each type.
    pub types: BTreeMap<ComponentType, u32>,
    /// The region that is most easily seen, of all but those unbounded above.
    pub largest: Option<RegionMargin>,
    /// The region that is hardest to see, of the same.
    pub smallest: Option<RegionMargin>,
    /// Points of curves that were computed to find the crossings.
    pub work: u32,
}

/// How large a region is.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionMargin {
    /// The distance in h of its sample from the boundary, divided by |r|.
    pub margin: f64,
    /// What it shows.
    pub signature: Signature,
}

/// A count as stored.
fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

impl ScanRow {
    /// Looks at one body. Whatever is wrong with it is part of the row.
    #[must_use]
    pub fn of(index: u64, values: [[f64; 3]; 2], accuracy: Accuracy) -> Self {
        let body = match Body::from_f64(values[0], values[1]) {
            Ok(body) => body,
            Err(error) => return Self::failed(index, values, error.to_string()),
        };
        let row = Self { flags: body.flags(), ..Self::failed(index, values, String::new()) };
        match bifdiag_exact::atlas(&body, accuracy) {
            Ok(atlas) => {
                let (status, class, error) = classified(&atlas);
                Self { status, class, error, diagram: Some(DiagramCounts::of(&atlas)), ..row }
            }
            // What is not proved is open; without an atlas nothing is known.
            Err(error) => {
                let status =
                    if matches!(error, AnswerError::Fast(_)) { RowStatus::Failed } else { RowStatus::Undecided };
                Self { status, error: Some(error.to_string()), ..row }
            }
        }
    }

    /// The row of a body of which only the failure is known.
    #[must_use]
    pub fn failed(index: u64, values: [[f64; 3]; 2], error: String) -> Self {
        let flags = Flags::default();
        Self { index, values, status: RowStatus::Failed, class: None, diagram: None, flags, error: Some(error) }
    }
}

/// The class of an atlas, or why it has none.
fn classified(atlas: &Atlas) -> (RowStatus, Option<ClassName>, Option<String>) {
    match Class::of(atlas) {
        Ok(class) => (RowStatus::Classified, Some(class.name().clone()), None),
        Err(error) => {
            // An invalid map is a defect, not a question of accuracy.
            let is_defect = matches!(&error, Unclassified::Map(defect) if *defect != MapError::Coincident);
            let status = if is_defect { RowStatus::Failed } else { RowStatus::Undecided };
            (status, None, Some(error.to_string()))
        }
    }
}

impl DiagramCounts {
    fn of(atlas: &Atlas) -> Self {
        let arrangement = atlas.arrangement();
        let of_kind = |wanted: fn(&Change) -> bool| {
            count(arrangement.events.iter().filter(|event| wanted(&event.change)).count())
        };
        let mut counts = Self {
            regions: count(atlas.regions().len()),
            cusps: of_kind(|change| matches!(change, Change::Birth(_) | Change::Death(_))),
            pitchforks: of_kind(|change| matches!(change, Change::Open { .. } | Change::Close { .. })),
            crossings: of_kind(|change| matches!(change, Change::Swap(_))),
            critical_points: count(atlas.critical_points_max()),
            signatures: BTreeMap::new(),
            types: BTreeMap::new(),
            largest: None,
            smallest: None,
            work: arrangement.evaluations,
        };
        let frame = &arrangement.set.frame;
        let top = arrangement.slabs.first().and_then(|slab| slab.region_above.last().copied());
        for (number, region) in atlas.regions().pairs() {
            let Ok(components) = &region.components else { continue };
            let signature = Signature::of(components);
            for kind in components.iter().map(ComponentType::of).collect::<BTreeSet<_>>() {
                *counts.types.entry(kind).or_default() += 1;
            }
            let margin = region.sample.margin / frame.r_norm;
            if Some(number) != top && margin.is_finite() {
                counts.note_margin(&RegionMargin { margin, signature: signature.clone() });
            }
            *counts.signatures.entry(signature).or_default() += 1;
        }
        counts
    }

    fn note_margin(&mut self, region: &RegionMargin) {
        if self.largest.as_ref().is_none_or(|largest| region.margin > largest.margin) {
            self.largest = Some(region.clone());
        }
        if self.smallest.as_ref().is_none_or(|smallest| region.margin < smallest.margin) {
            self.smallest = Some(region.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_body_has_its_nine_regions() {
        let row = ScanRow::of(7, [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]], Accuracy::Exact);
        let diagram = row.diagram.unwrap();
        assert_eq!((row.index, row.status, diagram.regions, diagram.cusps), (7, RowStatus::Classified, 9, 1));
        assert_eq!((diagram.pitchforks, diagram.crossings, diagram.critical_points), (1, 3, 6));
        let types: Vec<String> = diagram.types.iter().map(|(kind, count)| format!("{kind}:{count}")).collect();
        assert_eq!(types.join(" "), "k0n2:1 k1n0:3 k1n1:3 k1n2:1 k2n1:1 k2n2:1");
        assert_eq!(diagram.signatures[&"S2+T2".parse().unwrap()], 1);
        assert!(row.flags.plane && !row.flags.axis && !row.flags.unphysical && row.error.is_none());
        assert!(diagram.smallest.unwrap().margin < 0.1 && diagram.largest.unwrap().margin > 0.1);
    }

    #[test]
    fn a_body_that_fails_is_a_row_with_its_error() {
        let row = ScanRow::of(0, [[2.0, -1.0, 1.0], [1.0, 0.0, 0.0]], Accuracy::Exact);
        assert_eq!((row.status, row.class), (RowStatus::Failed, None));
        assert!(row.error.unwrap().contains("A2 = -1.0 is not positive"));
        let row = ScanRow::of(0, [[2.0, 1.0, 1e-80], [1.0, 0.0, 0.0]], Accuracy::Exact);
        assert_eq!((row.status, row.diagram), (RowStatus::Failed, None));
    }
}
