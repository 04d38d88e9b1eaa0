//! A walk inside one class.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use bifdiag_diagram::class::ClassName;
use bifdiag_survey::space::{BodySet, ReducedBody, TangentBasis};
use support::special::uniform;

use crate::chord::{Chord, chord, class_at};

/// A body that goes from place to place within its class (hit and run): each step draws a random line through it, notes
/// everything on the line, and goes to a random body of the stretch in which it stands.
#[derive(Clone, Debug)]
pub struct Walk {
    domain: BodySet,
    class: ClassName,
    place: ReducedBody,
    rng: SplitMix64,
}

/// What a step has met.
#[derive(Clone, Debug)]
pub struct Step {
    /// The two sides of the line, with the middle body of each of their stretches.
    pub sides: [(Chord, Vec<ReducedBody>); 2],
}

impl Walk {
    /// A walk from a body of a class; the class and the seed choose its numbers.
    #[must_use]
    pub fn new(class: ClassName, place: ReducedBody, domain: BodySet, seed: u64) -> Self {
        let number = class.as_str().bytes().fold(seed, |n, byte| n.wrapping_mul(0x0100_0000_01b3) ^ u64::from(byte));
        Self { domain, class, place, rng: SplitMix64::seed_from_u64(number) }
    }

    /// The next step; `None` where the body can change in no way.
    pub fn step(&mut self) -> Option<Step> {
        let chart = TangentBasis::new(self.place);
        let line = chart.line(&chart.random(&mut self.rng), self.domain)?;
        let shift = uniform(&mut self.rng);
        let sides = [false, true].map(|forth| {
            let found = chord(&line, &line.nodes(forth, shift), false);
            let middle = |s: [f64; 2]| ReducedBody::of(line.at(0.5 * (s[0] + s[1])));
            let places = found.stretches.iter().map(|stretch| middle(stretch.s)).collect();
            (found, places)
        });
        let end = |side: &(Chord, Vec<ReducedBody>)| side.0.stretches.first().map_or(0.0, |stretch| stretch.s[1]);
        let (back, forth) = (end(&sides[0]), end(&sides[1]));
        let s = back + (forth - back) * uniform(&mut self.rng);
        // The stretch may hold a cell of another class that no node has met.
        if class_at(&line, s).is_some_and(|class| *class.name() == self.class) {
            self.place = ReducedBody::of(line.at(s));
        }
        Some(Step { sides })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{ClassGraph, Node};

    #[test]
    fn a_walk_is_the_same_again_and_what_it_meets_is_on_its_borders() {
        let start = [[0.5, 0.6, 0.9], [0.6, 0.12, 0.45]];
        let name = Node::of(start).unwrap().class.name().clone();
        let walked = || {
            let mut walk = Walk::new(name.clone(), ReducedBody::of(start), BodySet::Physical, 3);
            let mut graph = ClassGraph::default();
            graph.add_body(start);
            let steps = (0..3).map(|_| graph.add_step(&walk.step().unwrap(), BodySet::Physical).0);
            let walls: u64 = steps.sum();
            (graph, walls)
        };
        let (graph, walls) = walked();
        assert_eq!(walked().0, graph);
        assert!(walls >= 3 && graph.nodes.len() > 1);
        assert_eq!(graph.edges.values().map(|edge| edge.walls[0]).sum::<u64>(), walls);
        assert_eq!(graph.nodes.values().map(|node| node.met[0]).sum::<u64>(), walls);
        for (([one, other], event), edge) in &graph.edges {
            assert!(one < other && edge.place.is_in(BodySet::Physical) && edge.error < 1e-8, "{event}");
        }
        for node in graph.nodes.values() {
            assert!(node.physical && Node::of(node.witness).unwrap().class == node.class);
        }
        // Joined with itself: the same classes, met twice as often.
        let mut twice = graph.clone();
        twice.join(graph.clone());
        assert!(twice.nodes.keys().eq(graph.nodes.keys()));
        assert!(twice.edges.iter().all(|(key, edge)| edge.walls[0] == 2 * graph.edges[key].walls[0]));
    }
}
