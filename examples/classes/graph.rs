//! The graph of classes that walks have met.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;
use bifdiag_survey::ComponentType;
use bifdiag_survey::border::class_of;
use bifdiag_survey::space::{BodySet, ReducedBody};

use crate::walk::Step;

/// A class in the graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The class.
    pub class: Class,
    /// Number of its regions.
    pub regions: usize,
    /// Types of the components that its regions show.
    pub types: BTreeSet<ComponentType>,
    /// A body of it, one that exists if there is any.
    pub witness: [[f64; 3]; 2],
    /// Bodies that exist have this class.
    pub physical: bool,
    /// How far the witness is from the nearest body of another class; 0 if that was not sought.
    pub distance: f64,
    /// Walls behind which it was met, by walks among bodies that exist, and among all.
    pub met: [u64; 2],
}

/// A border between two classes.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// A body on it, one that exists if there is any.
    pub place: ReducedBody,
    /// Estimate of its error, as a distance on the line on which it was found.
    pub error: f64,
    /// Walls of this kind that were met, by walks among bodies that exist, and among all.
    pub walls: [u64; 2],
}

/// Between which classes (in the order of their names), and what happens there.
pub type EdgeKey = ([ClassName; 2], String);

/// The classes that are known, and the borders between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassGraph {
    /// The classes.
    pub nodes: BTreeMap<ClassName, Node>,
    /// The borders.
    pub edges: BTreeMap<EdgeKey, Edge>,
}

fn index(domain: BodySet) -> usize {
    match domain {
        BodySet::Physical => 0,
        BodySet::All => 1,
    }
}

impl Node {
    /// The class of a body with all that is known of it; `None` where it has none.
    #[must_use]
    pub fn of(witness: [[f64; 3]; 2]) -> Option<Self> {
        let place = ReducedBody::of(witness);
        let body = Body::from_f64(witness[0], witness[1]).ok()?;
        let (atlas, class) = class_of(&body, Accuracy::Exact).ok()?;
        let (regions, types) = (atlas.regions().len(), types(&atlas));
        let physical = place.is_in(BodySet::Physical);
        Some(Self { class, regions, types, witness, physical, distance: 0.0, met: [0; 2] })
    }
}

fn types(atlas: &Atlas) -> BTreeSet<ComponentType> {
    atlas
        .regions()
        .iter()
        .filter_map(|region| region.components.as_ref().ok())
        .flatten()
        .map(ComponentType::of)
        .collect()
}

impl ClassGraph {
    /// Adds the class of a body; true if it was not known, or not known to be one of bodies that exist.
    pub fn add_body(&mut self, witness: [[f64; 3]; 2]) -> bool {
        let Some(node) = Node::of(witness) else { return false };
        match self.nodes.get_mut(node.class.name()) {
            Some(known) if known.physical || !node.physical => false,
            Some(known) => {
                *known = Node { met: known.met, ..node };
                true
            }
            None => {
                self.nodes.insert(node.class.name().clone(), node);
                true
            }
        }
    }

    /// Adds what a step has met. Gives the number of its walls, and for each that led to something new its number, from 1.
    pub fn add_step(&mut self, step: &Step, domain: BodySet) -> (u64, Vec<u64>) {
        let (mut walls, mut news) = (0, Vec::new());
        for (chord, places) in &step.sides {
            for (wall, place) in chord.walls.iter().zip(&places[1.min(places.len())..]) {
                walls += 1;
                let [from, to] = wall.classes.each_ref().map(Class::name);
                let news_here = match self.nodes.get(to) {
                    Some(known) => !known.physical && place.is_in(BodySet::Physical),
                    None => true,
                } && self.add_body(place.values());
                if news_here {
                    news.push(walls);
                }
                if let Some(node) = self.nodes.get_mut(to) {
                    node.met[index(domain)] += 1;
                }
                let mut between = [from.clone(), to.clone()];
                between.sort();
                let new = Edge { place: wall.place, error: wall.error, walls: [0; 2] };
                let edge = self.edges.entry((between, wall.event.to_string())).or_insert_with(|| new.clone());
                if new.place.is_in(BodySet::Physical) && !edge.place.is_in(BodySet::Physical) {
                    *edge = Edge { walls: edge.walls, ..new };
                }
                edge.walls[index(domain)] += 1;
            }
        }
        (walls, news)
    }

    /// Adds another graph, that of another shard.
    pub fn join(&mut self, other: Self) {
        for (name, node) in other.nodes {
            match self.nodes.get_mut(&name) {
                None => {
                    self.nodes.insert(name, node);
                }
                Some(known) => {
                    let met = [0, 1].map(|k| known.met[k] + node.met[k]);
                    let better = (node.physical, node.distance) > (known.physical, known.distance);
                    *known = Node { met, ..if better { node } else { known.clone() } };
                }
            }
        }
        for (key, edge) in other.edges {
            let known = self.edges.entry(key).or_insert_with(|| Edge { walls: [0; 2], ..edge.clone() });
            known.walls = [0, 1].map(|k| known.walls[k] + edge.walls[k]);
        }
    }

    /// What the walks of a domain have not met, estimated from what they have.
    #[must_use]
    pub fn unseen(&self, domain: BodySet) -> Unseen {
        Unseen::of(self.nodes.values().map(|node| node.met[index(domain)]).filter(|met| *met > 0))
    }
}

/// Estimates from how often each class was met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// Classes that were met once.
    pub once: u64,
    /// Classes that were met twice.
    pub twice: u64,
    /// The chance that the next meeting is with a class not met before: once / meetings (Good and Turing; I. J. Good,
    /// Biometrika 40, 1953).
    pub chance: f64,
    /// A lower bound on the number of classes not met, once (once − 1) / (2 (twice + 1)) (A. Chao, *Nonparametric
    /// estimation of the number of classes in a population*, Scand. J. Statist. 11, 1984; the form without bias).
    pub classes: f64,
}

impl Unseen {
    /// From the number of meetings with each class.
    #[must_use]
    pub fn of(meetings: impl Iterator<Item = u64>) -> Self {
        let (mut once, mut twice, mut all) = (0_u64, 0_u64, 0_u64);
        for count in meetings {
            all += count;
            once += u64::from(count == 1);
            twice += u64::from(count == 2);
        }
        let chance = if all == 0 { 1.0 } else { once as f64 / all as f64 };
        let classes = (once * once.saturating_sub(1)) as f64 / (2.0 * (twice + 1) as f64);
        Self { once, twice, chance, classes }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_meetings_estimate_what_was_not_met() {
        let unseen = Unseen::of([1, 1, 1, 2, 5, 90].into_iter());
        assert_eq!((unseen.once, unseen.twice, unseen.chance, unseen.classes), (3, 1, 0.03, 1.5));
        assert_eq!(Unseen::of([4, 9].into_iter()).classes, 0.0);
    }
}
