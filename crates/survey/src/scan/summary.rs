//! What the bodies of a scan have in common.

use std::collections::BTreeMap;

use bifdiag_schema::{BodyRecordDocument, RecordDocument, RowStatus};

use super::row::ScanRow;
use crate::signature::{ComponentType, Signature};
use bifdiag_body::Body;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;

/// A class and how often it was met.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassRecord {
    /// Number of bodies, and the first one.
    pub record: RecordDocument,
    /// Number of its regions.
    pub regions: u32,
    /// Number of its cusps, pitchforks and crossings.
    pub events: [u32; 3],
}

/// Counts over the rows of a scan, or of a part of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Number of bodies.
    pub rows: u64,
    /// Bodies whose class is open at this accuracy.
    pub undecided: u64,
    /// Bodies without an atlas.
    pub failed: u64,
    /// Points of curves that were computed in all.
    pub work: u64,
    /// Every class.
    pub classes: BTreeMap<ClassName, ClassRecord>,
    /// The bodies that show each signature.
    pub signatures: BTreeMap<Signature, RecordDocument>,
    /// The bodies that show each type of component.
    pub types: BTreeMap<ComponentType, RecordDocument>,
    /// The bodies with each number of relative equilibria at one l, at most.
    pub critical_points: BTreeMap<u32, RecordDocument>,
    /// The bodies with each number of regions.
    pub regions: BTreeMap<u32, RecordDocument>,
}

impl Summary {
    /// Counts one more body; an undecided one only as undecided.
    pub fn add(&mut self, row: &ScanRow) {
        self.rows += 1;
        match row.status {
            RowStatus::Classified => {}
            RowStatus::Undecided => self.undecided += 1,
            RowStatus::Failed => self.failed += 1,
        }
        let Some(diagram) = &row.diagram else { return };
        self.work += u64::from(diagram.work);
        let Some(class) = &row.class else { return };
        let [moments, center] = row.values;
        let body = BodyRecordDocument { index: row.index, moments, center };
        let known = self.classes.entry(class.clone()).or_insert_with(|| ClassRecord {
            record: RecordDocument { bodies: 0, first: body.clone() },
            regions: diagram.regions,
            events: [diagram.cusps, diagram.pitchforks, diagram.crossings],
        });
        known.record.bodies += 1;
        note(&mut self.regions, diagram.regions, &body);
        note(&mut self.critical_points, diagram.critical_points, &body);
        for signature in diagram.signatures.keys() {
            note(&mut self.signatures, signature.clone(), &body);
        }
        for kind in diagram.types.keys() {
            note(&mut self.types, *kind, &body);
        }
    }

    /// Bodies with a class.
    #[must_use]
    pub fn classified(&self) -> u64 {
        self.rows - self.undecided - self.failed
    }

    /// The classes, the most frequent first.
    #[must_use]
    pub fn by_frequency(&self) -> Vec<(&ClassName, &ClassRecord)> {
        let mut classes: Vec<_> = self.classes.iter().collect();
        classes.sort_by(|p, q| q.1.record.bodies.cmp(&p.1.record.bodies).then_with(|| p.0.cmp(q.0)));
        classes
    }
}

fn note<K: Ord>(records: &mut BTreeMap<K, RecordDocument>, key: K, body: &BodyRecordDocument) {
    records.entry(key).or_insert_with(|| RecordDocument { bodies: 0, first: body.clone() }).bodies += 1;
}

/// The canonical form of the class of a body, made again; `None` where it has no class.
#[must_use]
pub fn class_text(body: &BodyRecordDocument, accuracy: Accuracy) -> Option<String> {
    let body = Body::from_f64(body.moments, body.center).ok()?;
    let class = Class::of(&bifdiag_exact::atlas(&body, accuracy).ok()?).ok()?;
    Some(class.text().to_owned())
}
