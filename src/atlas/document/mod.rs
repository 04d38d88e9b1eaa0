//! The document of an atlas: names, polylines, stability, and everything in the body's own units.

mod curves;
mod events;
mod regions;
mod trace;
mod window;

use std::collections::BTreeMap;

use super::Atlas;
use super::names::curve_name;
use crate::arrangement::Undecided;
use crate::document::{
    Accuracy, AtlasDocument, BodyDocument, SCHEMA_VERSION, SummaryDocument, UndecidedDocument, WindowDocument,
};
use crate::equilibria::Orbit;

/// What the document holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DocumentOptions {
    /// The part of the plane asked for; `None`: all of it.
    pub window: Option<WindowDocument>,
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Whether curves carry polylines and stability at all.
    pub polylines: bool,
    /// The level of accuracy.
    pub accuracy: Accuracy,
}

impl Default for DocumentOptions {
    fn default() -> Self {
        Self { window: None, chord_tolerance: 1e-3, polylines: true, accuracy: Accuracy::Standard }
    }
}

impl Atlas {
    /// The atlas as a document. Curves are traced by Newton continuation; events and regions come from the closed form.
    #[must_use]
    pub fn document(&self, options: &DocumentOptions) -> AtlasDocument {
        let flags = self.body.flags();
        let mut undecided = self.undecided();
        let curves = curves::documents(self, options, &mut undecided);
        let (regions, clipped) = regions::documents(self, options.window.as_ref(), &mut undecided);
        let mut signatures = BTreeMap::new();
        for region in &regions {
            let accessible = || {
                let names: Vec<&str> = region.components.iter().map(|c| c.accessible_region.as_str()).collect();
                names.join("+")
            };
            *signatures.entry(region.signature.clone().unwrap_or_else(accessible)).or_insert(0) += 1;
        }
        let events = events::documents(self, options.window.as_ref());
        let summary = SummaryDocument {
            regions: regions.len(),
            events: events.len(),
            signatures,
            critical_points_max: self.critical_points_max(),
            complete: undecided.is_empty() && !clipped && options.window.is_none(),
            undecided,
        };
        AtlasDocument {
            schema_version: SCHEMA_VERSION.to_owned(),
            accuracy: options.accuracy,
            body: BodyDocument {
                moments: self.body.moments().clone(),
                center: self.body.center().clone(),
                flags,
                degenerate: flags.degenerate(),
                inertia: None,
            },
            window: options.window,
            curves,
            events,
            regions,
            summary,
            certificate: None,
        }
    }

    /// The largest number of relative equilibria at one l; a critical circle or sphere counts once.
    #[must_use]
    pub fn critical_points_max(&self) -> usize {
        let count = |c: usize| match self.arrangement.set.curves[c].orbit {
            Orbit::Pair(_) => 2,
            Orbit::Pole(_) => 0,
            _ => 1,
        };
        self.arrangement.slabs.iter().map(|slab| slab.order.iter().map(|&c| count(c)).sum()).max().unwrap_or(0)
    }

    /// l in the body's units.
    fn momentum(&self, x: f64) -> f64 {
        (2.0 * x).sqrt() * self.arrangement.set.frame.momentum_unit
    }

    /// h in the body's units.
    fn energy(&self, h: f64) -> f64 {
        h * self.arrangement.set.frame.energy_unit
    }

    /// What the arrangement left undecided, in words.
    fn undecided(&self) -> Vec<UndecidedDocument> {
        let set = &self.arrangement.set;
        let name = |c: usize| curve_name(set, c);
        let mut found: Vec<UndecidedDocument> = Vec::new();
        for undecided in &self.arrangement.undecided {
            found.push(match *undecided {
                Undecided::Contact { curves, x } => {
                    let at = if x[1].is_finite() { 0.5 * (x[0] + x[1]) } else { x[0] };
                    let h = set.curves[curves[0]].point(&set.frame, at).h();
                    UndecidedDocument {
                        what: "whether two curves cross, closer than f64 resolves".to_owned(),
                        l: self.momentum(at),
                        h: self.energy(h),
                        curves: curves.map(name).to_vec(),
                    }
                }
                Undecided::Cusps { cluster } => {
                    let cluster = &set.clusters[cluster];
                    UndecidedDocument {
                        what: format!("whether branch G{} has two more cusps", cluster.interval),
                        l: self.momentum(cluster.point.x),
                        h: self.energy(cluster.point.h()),
                        curves: Vec::new(),
                    }
                }
                Undecided::Simultaneous { events } => {
                    let event = &self.arrangement.events[events[0]];
                    let mut curves: Vec<usize> =
                        events.iter().flat_map(|&e| self.arrangement.events[e].change.curves()).collect();
                    curves.sort_unstable();
                    curves.dedup();
                    UndecidedDocument {
                        what: "the order of two events closer than f64 resolves".to_owned(),
                        l: self.momentum(event.x),
                        h: self.energy(event.h),
                        curves: curves.into_iter().map(name).collect(),
                    }
                }
                Undecided::Order { event } => {
                    let event = &self.arrangement.events[event];
                    UndecidedDocument {
                        what: "the order of the curves".to_owned(),
                        l: self.momentum(event.x),
                        h: self.energy(event.h),
                        curves: event.change.curves().into_iter().map(name).collect(),
                    }
                }
            });
        }
        found
    }
}
