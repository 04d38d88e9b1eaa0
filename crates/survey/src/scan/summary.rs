//! What the bodies of a scan have in common.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::design::Design;
use super::row::{Row, Status, read_counts};
use proof::atlas_of;
use schema::{Accuracy, SCHEMA_VERSION};
use top::body::Body;
use top::class::Class;

/// A body that shows something, with its number in the scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodyRecord {
    /// Its number.
    pub index: u64,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [f64; 3],
}

/// A class and how often it was met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClassRecord {
    /// Its name.
    pub class: String,
    /// Number of bodies.
    pub bodies: u64,
    /// Number of its regions.
    pub regions: u32,
    /// Number of its cusps, pitchforks and crossings.
    pub events: [u32; 3],
    /// The first body of the class.
    pub first: BodyRecord,
    /// Its canonical form, line by line.
    pub text: Vec<String>,
}

/// Something that bodies show: how many do, and where it is seen best.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Record {
    /// Number of bodies.
    pub bodies: u64,
    /// The first body.
    pub first: BodyRecord,
}

/// Counts over the rows of a scan, or of a part of it.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    rows: u64,
    undecided: u64,
    failed: u64,
    work: u64,
    classes: BTreeMap<String, ClassCount>,
    signatures: BTreeMap<String, Record>,
    types: BTreeMap<String, Record>,
    critical_points: BTreeMap<u32, Record>,
    regions: BTreeMap<u32, Record>,
}

#[derive(Clone, Debug)]
struct ClassCount {
    bodies: u64,
    regions: u32,
    events: [u32; 3],
    first: BodyRecord,
}

/// The summary of a scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SummaryDocument {
    /// Version of this document.
    pub schema_version: String,
    /// Version of the program.
    pub program: String,
    /// What the answers are worth.
    #[serde(default)]
    pub accuracy: Accuracy,
    /// Which bodies the scan looks at.
    pub design: Design,
    /// The numbers of the bodies: from this one on, up to but without that one.
    pub range: [u64; 2],
    /// Number of bodies.
    pub rows: u64,
    /// Bodies with a class.
    pub classified: u64,
    /// Bodies whose class is open at this accuracy.
    pub undecided: u64,
    /// Bodies without an atlas.
    pub failed: u64,
    /// Points of curves that were computed in all.
    pub work: u64,
    /// Format of the file with the rows.
    pub format: String,
    /// SHA-256 of that file.
    pub sha256: String,
    /// For each number of relative equilibria at one l, at most: the bodies.
    pub critical_points: BTreeMap<u32, Record>,
    /// For each number of regions: the bodies.
    pub regions: BTreeMap<u32, Record>,
    /// For each type of component (boundary circles and poles): the bodies that show it.
    pub types: BTreeMap<String, Record>,
    /// For each signature: the bodies that show it.
    pub signatures: BTreeMap<String, Record>,
    /// Every class, the most frequent first.
    pub classes: Vec<ClassRecord>,
}

impl Summary {
    /// Counts one more body. Of an undecided body only that it is one.
    pub fn add(&mut self, row: &Row) {
        self.rows += 1;
        self.work += u64::from(row.work.unwrap_or(0));
        match row.status {
            Status::Classified => {}
            Status::Undecided => self.undecided += 1,
            Status::Failed => self.failed += 1,
        }
        let Some(class) = &row.class else { return };
        let [moments, center] = row.values();
        let body = BodyRecord { index: row.index, moments, center };
        let [regions, critical_points] = [row.regions, row.critical_points].map(Option::unwrap_or_default);
        let count = |n: Option<u32>| n.unwrap_or_default();
        let known = self.classes.entry(class.clone()).or_insert_with(|| ClassCount {
            bodies: 0,
            regions,
            events: [count(row.cusps), count(row.pitchforks), count(row.crossings)],
            first: body.clone(),
        });
        known.bodies += 1;
        note(&mut self.regions, regions, &body);
        note(&mut self.critical_points, critical_points, &body);
        for (name, _) in read_counts(row.signatures.as_deref().unwrap_or_default()) {
            note(&mut self.signatures, name.to_owned(), &body);
        }
        for (name, _) in read_counts(row.types.as_deref().unwrap_or_default()) {
            note(&mut self.types, name.to_owned(), &body);
        }
    }

    /// Number of bodies so far.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The document. The texts of the classes are made again from the first body of each.
    #[must_use]
    pub fn document(
        self,
        design: &Design,
        range: [u64; 2],
        accuracy: Accuracy,
        format: &str,
        sha256: String,
    ) -> SummaryDocument {
        let mut classes: Vec<ClassRecord> = self
            .classes
            .into_iter()
            .map(|(class, count)| {
                let text = text_of(&count.first, accuracy);
                let ClassCount { bodies, regions, events, first } = count;
                ClassRecord { class, bodies, regions, events, first, text }
            })
            .collect();
        classes.sort_by(|p, q| q.bodies.cmp(&p.bodies).then_with(|| p.class.cmp(&q.class)));
        SummaryDocument {
            schema_version: SCHEMA_VERSION.to_owned(),
            program: concat!("bifdiag ", env!("CARGO_PKG_VERSION")).to_owned(),
            accuracy,
            design: design.clone(),
            range,
            rows: self.rows,
            classified: self.rows - self.undecided - self.failed,
            undecided: self.undecided,
            failed: self.failed,
            work: self.work,
            format: format.to_owned(),
            sha256,
            critical_points: self.critical_points,
            regions: self.regions,
            types: self.types,
            signatures: self.signatures,
            classes,
        }
    }
}

fn note<K: Ord>(records: &mut BTreeMap<K, Record>, key: K, body: &BodyRecord) {
    records.entry(key).or_insert_with(|| Record { bodies: 0, first: body.clone() }).bodies += 1;
}

fn text_of(body: &BodyRecord, accuracy: Accuracy) -> Vec<String> {
    let class = Body::from_f64(body.moments, body.center)
        .ok()
        .and_then(|body| atlas_of(&body, accuracy.into()).ok())
        .and_then(|atlas| Class::of(&atlas).ok());
    class.map(|class| class.text().lines().map(str::to_owned).collect()).unwrap_or_default()
}
