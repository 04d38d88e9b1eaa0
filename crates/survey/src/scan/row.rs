//! What a scan notes about one body.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use proof::{Accuracy, NoAtlas, atlas_of};
use top::atlas::Atlas;
use top::body::Body;
use top::class::{Class, MapError, Unclassified};
use top::diagram::Change;
use top::topology::{Component, signature};

/// How far a body was understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It has a class.
    Classified,
    /// Something about its diagram is open at this accuracy; the numbers of the row are what was found.
    Undecided,
    /// There is no atlas; `error` says why.
    Failed,
}

/// One body of a scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// Number of the body in the scan, from 0.
    pub index: u64,
    /// A1.
    #[serde(rename = "A1")]
    pub a1: f64,
    /// A2.
    #[serde(rename = "A2")]
    pub a2: f64,
    /// A3.
    #[serde(rename = "A3")]
    pub a3: f64,
    /// r1.
    pub r1: f64,
    /// r2.
    pub r2: f64,
    /// r3.
    pub r3: f64,
    /// How far the body was understood.
    pub status: Status,
    /// Name of the class of its diagram.
    pub class: Option<String>,
    /// Number of regions.
    pub regions: Option<u32>,
    /// Number of cusps.
    pub cusps: Option<u32>,
    /// Number of pitchforks.
    pub pitchforks: Option<u32>,
    /// Number of crossings.
    pub crossings: Option<u32>,
    /// The largest number of relative equilibria at one l; a circle counts once.
    pub critical_points: Option<u32>,
    /// How many regions have each signature: `S2:2 S2+T2:1`.
    pub signatures: Option<String>,
    /// How many regions show a component with k boundary circles and n poles: `k0n2:1 k1n1:4`.
    pub types: Option<String>,
    /// Of the region that is most easily seen (all but those unbounded above): the distance in h of its sample from
    /// the boundary, divided by |r|.
    pub largest_margin: Option<f64>,
    /// Signature of that region.
    pub largest_region: Option<String>,
    /// As `largest_margin`, of the region that is hardest to see.
    pub smallest_margin: Option<f64>,
    /// Signature of that region.
    pub smallest_region: Option<String>,
    /// No mass distribution has these moments.
    pub unphysical: bool,
    /// A_i + A_j = A_k.
    pub plate: bool,
    /// Equal moments.
    pub symmetric: bool,
    /// Some r_i = 0.
    pub plane: bool,
    /// r is a principal direction.
    pub axis: bool,
    /// r = 0.
    pub euler: bool,
    /// Points of curves that were computed to find the crossings.
    pub work: Option<u32>,
    /// Why the body has no class.
    pub error: Option<String>,
}

/// A count as it is stored.
fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

impl Row {
    /// Looks at one body. Whatever is wrong with it is part of the row.
    #[must_use]
    pub fn of(index: u64, values: [[f64; 3]; 2], accuracy: Accuracy) -> Self {
        let [[a1, a2, a3], [r1, r2, r3]] = values;
        let mut row = Self { index, a1, a2, a3, r1, r2, r3, ..Self::failed() };
        match Body::from_f64(values[0], values[1]) {
            Ok(body) => row.look_at(&body, accuracy),
            Err(error) => row.error = Some(error.to_string()),
        }
        row
    }

    /// The row of a body of which nothing is known but why.
    #[must_use]
    pub fn lost(index: u64, values: [[f64; 3]; 2], error: &str) -> Self {
        let [[a1, a2, a3], [r1, r2, r3]] = values;
        Self { index, a1, a2, a3, r1, r2, r3, error: Some(error.to_owned()), ..Self::failed() }
    }

    fn failed() -> Self {
        Self {
            index: 0,
            a1: 0.0,
            a2: 0.0,
            a3: 0.0,
            r1: 0.0,
            r2: 0.0,
            r3: 0.0,
            status: Status::Failed,
            class: None,
            regions: None,
            cusps: None,
            pitchforks: None,
            crossings: None,
            critical_points: None,
            signatures: None,
            types: None,
            largest_margin: None,
            largest_region: None,
            smallest_margin: None,
            smallest_region: None,
            unphysical: false,
            plate: false,
            symmetric: false,
            plane: false,
            axis: false,
            euler: false,
            work: None,
            error: None,
        }
    }

    fn look_at(&mut self, body: &Body, accuracy: Accuracy) {
        let flags = body.flags();
        self.unphysical = flags.unphysical;
        self.plate = flags.plate;
        self.symmetric = flags.symmetric;
        self.plane = flags.plane;
        self.axis = flags.axis;
        self.euler = flags.euler;
        match atlas_of(body, accuracy) {
            Ok(atlas) => self.note(&atlas),
            Err(error) => {
                // What is not proved is open; without an atlas nothing is known.
                self.status = if matches!(error, NoAtlas::Atlas(_)) { Status::Failed } else { Status::Undecided };
                self.error = Some(error.to_string());
            }
        }
    }

    fn note(&mut self, atlas: &Atlas) {
        match Class::of(atlas) {
            Ok(class) => {
                self.status = Status::Classified;
                self.class = Some(class.id().to_owned());
            }
            Err(error) => {
                // A map that is none is a defect, and no question of accuracy.
                self.status = if matches!(&error, Unclassified::Map(defect) if *defect != MapError::Coincident) {
                    Status::Failed
                } else {
                    Status::Undecided
                };
                self.error = Some(error.to_string());
            }
        }
        let events = &atlas.arrangement().events;
        let of_kind = |wanted: fn(&Change) -> bool| count(events.iter().filter(|event| wanted(&event.change)).count());
        self.cusps = Some(of_kind(|change| matches!(change, Change::Birth(_) | Change::Death(_))));
        self.pitchforks = Some(of_kind(|change| matches!(change, Change::Open { .. } | Change::Close { .. })));
        self.crossings = Some(of_kind(|change| matches!(change, Change::Swap(_))));
        self.regions = Some(count(atlas.regions().len()));
        self.critical_points = Some(count(atlas.critical_points_max()));
        self.work = Some(atlas.arrangement().evaluations);
        self.note_regions(atlas);
    }

    fn note_regions(&mut self, atlas: &Atlas) {
        let mut signatures: BTreeMap<String, u32> = BTreeMap::new();
        let mut types: BTreeMap<String, u32> = BTreeMap::new();
        let frame = &atlas.arrangement().set.frame;
        let slabs = &atlas.arrangement().slabs;
        let top = slabs.first().and_then(|slab| slab.region_above.last().copied());
        for (number, region) in atlas.regions().pairs() {
            let Ok(components) = &region.components else { continue };
            let name = region_name(components);
            let mut kinds: Vec<String> = components.iter().map(component_type).collect();
            kinds.sort_unstable();
            kinds.dedup();
            for kind in kinds {
                *types.entry(kind).or_default() += 1;
            }
            let margin = region.sample.margin / frame.r_norm;
            if Some(number) != top && margin.is_finite() {
                if self.largest_margin.is_none_or(|largest| margin > largest) {
                    self.largest_margin = Some(margin);
                    self.largest_region = Some(name.clone());
                }
                if self.smallest_margin.is_none_or(|smallest| margin < smallest) {
                    self.smallest_margin = Some(margin);
                    self.smallest_region = Some(name.clone());
                }
            }
            *signatures.entry(name).or_default() += 1;
        }
        self.signatures = Some(counts_text(&signatures));
        self.types = Some(counts_text(&types));
    }

    /// A and r.
    #[must_use]
    pub fn values(&self) -> [[f64; 3]; 2] {
        [[self.a1, self.a2, self.a3], [self.r1, self.r2, self.r3]]
    }
}

/// A region's signature, or the components of U where there is no section.
pub(crate) fn region_name(components: &[Component]) -> String {
    signature(components)
        .unwrap_or_else(|| components.iter().map(Component::accessible_region).collect::<Vec<_>>().join("+"))
}

/// `k1n2`: boundary circles and poles.
pub(crate) fn component_type(component: &Component) -> String {
    format!("k{}n{}", component.boundary_circles, component.poles.unwrap_or_default().count())
}

/// `S2:2 S2+T2:1`.
fn counts_text(counts: &BTreeMap<String, u32>) -> String {
    counts.iter().map(|(name, count)| format!("{name}:{count}")).collect::<Vec<_>>().join(" ")
}

/// The names and counts of a text such as `S2:2 S2+T2:1`; what cannot be read is left out.
pub(super) fn read_counts(text: &str) -> impl Iterator<Item = (&str, u32)> {
    text.split(' ').filter_map(|part| {
        let (name, count) = part.rsplit_once(':')?;
        Some((name, count.parse().ok()?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_body_has_its_nine_regions() {
        let row = Row::of(7, [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]], Accuracy::Standard);
        assert_eq!((row.index, row.status, row.regions, row.cusps), (7, Status::Classified, Some(9), Some(1)));
        assert_eq!((row.pitchforks, row.crossings, row.critical_points), (Some(1), Some(3), Some(6)));
        assert_eq!(row.types.as_deref(), Some("k0n2:1 k1n0:3 k1n1:3 k1n2:1 k2n1:1 k2n2:1"));
        assert!(row.plane && !row.axis && !row.unphysical && row.error.is_none());
        assert!(row.smallest_margin.unwrap() < 0.1 && row.largest_margin.unwrap() > 0.1);
    }

    #[test]
    fn a_body_that_fails_is_a_row_with_its_error() {
        let row = Row::of(0, [[2.0, -1.0, 1.0], [1.0, 0.0, 0.0]], Accuracy::Standard);
        assert_eq!((row.status, row.class.as_deref()), (Status::Failed, None));
        assert!(row.error.unwrap().contains("A2 = -1.0 is not positive"));
        let row = Row::of(0, [[2.0, 1.0, 1e-80], [1.0, 0.0, 0.0]], Accuracy::Standard);
        assert_eq!(row.status, Status::Failed);
    }
}
