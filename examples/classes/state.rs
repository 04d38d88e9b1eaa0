//! The state of the campaign in a file.

use std::fmt;
use std::path::Path;

use bifdiag_diagram::class::ClassName;
use bifdiag_survey::scan::Shard;
use bifdiag_survey::space::{BodySet, ReducedBody};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::Failure;
use crate::graph::{ClassGraph, Edge, Node};
use crate::walk::{Step, Walk};

/// Everything that walks have met.
#[derive(Default)]
pub struct State {
    pub graph: ClassGraph,
    pub rounds: Vec<Round>,
}

/// One round of walks.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Round {
    pub domain: String,
    pub seed: u64,
    pub number: u64,
    pub lines: u64,
    pub walls: u64,
    /// Places where the class changes and no wall was pinned down.
    pub lost: u64,
    /// The numbers of the walls behind which a new class was met.
    pub new_at: Vec<u64>,
}

/// A class with a body of it.
#[derive(Serialize, Deserialize)]
pub struct NodeState {
    class: String,
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
    distance: f64,
    pub met: [u64; 2],
}

/// A border with a body on it.
#[derive(Serialize, Deserialize)]
pub struct EdgeState {
    pub classes: [String; 2],
    pub event: String,
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
    error: f64,
    pub walls: [u64; 2],
}

/// As it stands in a file.
#[derive(Serialize, Deserialize)]
pub struct Stored {
    pub rounds: Vec<Round>,
    pub classes: Vec<NodeState>,
    pub borders: Vec<EdgeState>,
}

/// What is needed of the summary of a scan; the published ones are of an earlier version.
#[derive(Deserialize)]
pub struct Summary {
    pub classified: u64,
    pub classes: Vec<ClassSummary>,
}

#[derive(Deserialize)]
pub struct ClassSummary {
    pub class: String,
    pub bodies: u64,
    /// Cusps, pitchforks, crossings.
    #[serde(default)]
    pub events: [u32; 3],
    pub first: FirstBody,
}

#[derive(Deserialize)]
pub struct FirstBody {
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    #[serde(rename = "r")]
    pub center: [f64; 3],
}

impl Summary {
    pub fn read(path: &str) -> Result<Self, Failure> {
        Ok(serde_json::from_str(&std::fs::read_to_string(path)?)?)
    }
}

pub fn word(domain: BodySet) -> &'static str {
    match domain {
        BodySet::Physical => "existing",
        BodySet::All => "all",
    }
}

impl Round {
    pub fn new(domain: BodySet, seed: u64, number: u64) -> Self {
        let domain = word(domain).to_owned();
        Self { domain, seed, number, lines: 0, walls: 0, lost: 0, new_at: Vec::new() }
    }

    pub fn add(&mut self, step: &Step, graph: &mut ClassGraph, domain: BodySet) {
        let (walls, new) = graph.add_step(step, domain);
        self.lines += 1;
        self.lost += step.sides.iter().map(|(chord, _)| u64::from(chord.lost)).sum::<u64>();
        self.new_at.extend(new.into_iter().map(|place| self.walls + place));
        self.walls += walls;
    }

    /// Walls since the last new class; `quiet` more where there was none.
    pub fn after(&self, quiet: u64) -> u64 {
        self.new_at.last().map_or(quiet + self.walls, |last| self.walls - last)
    }
}

impl fmt::Display for Round {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { domain, number, lines, walls, lost, new_at, .. } = self;
        write!(f, "{domain} round {number}: {lines} lines, {walls} walls, {lost} lost, {} new;", new_at.len())
    }
}

impl State {
    pub fn read_or_new(path: &Path) -> Result<Self, Failure> {
        if path.exists() { Self::read(path) } else { Ok(Self::default()) }
    }

    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::of(serde_json::from_str(&std::fs::read_to_string(path)?)?)
    }

    /// Every witness is looked at again: what the file says its class is must be so.
    pub fn of(stored: Stored) -> Result<Self, Failure> {
        let mut state = Self { rounds: stored.rounds, ..Self::default() };
        for known in stored.classes {
            let node =
                Node::of([known.moments, known.center]).ok_or_else(|| format!("{} has no class", known.class))?;
            if node.class.name().as_str() != known.class {
                return Err(format!("the witness of {} has the class {}", known.class, node.class.name()).into());
            }
            let node = Node { distance: known.distance, met: known.met, ..node };
            state.graph.nodes.insert(node.class.name().clone(), node);
        }
        for border in stored.borders {
            let [one, other] = &border.classes;
            let place = ReducedBody { a: border.moments, r: border.center };
            let edge = Edge { place, error: border.error, walls: border.walls };
            state.graph.edges.insert(([one.parse()?, other.parse()?], border.event), edge);
        }
        Ok(state)
    }

    pub fn rounds_of(&self, domain: BodySet, seed: u64) -> impl Iterator<Item = &Round> {
        self.rounds.iter().filter(move |round| round.domain == word(domain) && round.seed == seed)
    }

    /// Walls in a row that led to no new class.
    pub fn quiet(&self, domain: BodySet, seed: u64) -> u64 {
        self.rounds_of(domain, seed).fold(0, |quiet, round| round.after(quiet))
    }

    /// Lets each class of a domain, or a shard of them, walk `steps` steps. The numbers are the seed, that of the round, and
    /// that of the steps.
    pub fn round(&mut self, domain: BodySet, [seed, number, steps]: [u64; 3], shard: Shard) -> Round {
        let known: Vec<(ClassName, ReducedBody)> = self
            .graph
            .nodes
            .iter()
            .filter(|(_, node)| domain == BodySet::All || node.physical)
            .map(|(name, node)| (name.clone(), ReducedBody::of(node.witness)))
            .collect();
        let seed_here = seed.wrapping_mul(1 << 20).wrapping_add(number);
        let walks: Vec<_> = part(&known, shard)
            .into_par_iter()
            .map(|(name, place)| {
                let mut walk = Walk::new(name, place, domain, seed_here);
                (0..steps).map_while(|_| walk.step()).collect::<Vec<_>>()
            })
            .collect();
        let mut round = Round::new(domain, seed, number);
        for step in walks.iter().flatten() {
            round.add(step, &mut self.graph, domain);
        }
        round
    }

    pub fn join(&mut self, other: Self) {
        self.graph.join(other.graph);
        self.rounds.extend(other.rounds);
    }

    pub fn stored(&self) -> Stored {
        let classes = self.graph.nodes.iter().map(|(name, node)| NodeState {
            class: name.to_string(),
            moments: node.witness[0],
            center: node.witness[1],
            distance: node.distance,
            met: node.met,
        });
        let borders = self.graph.edges.iter().map(|((between, event), edge)| EdgeState {
            classes: between.each_ref().map(ToString::to_string),
            event: event.clone(),
            moments: edge.place.a,
            center: edge.place.r,
            error: edge.error,
            walls: edge.walls,
        });
        Stored { rounds: self.rounds.clone(), classes: classes.collect(), borders: borders.collect() }
    }

    pub fn write(&self, path: &Path) -> Result<(), Failure> {
        replace(path, &serde_json::to_string(&self.stored())?)
    }
}

/// Part of a list.
pub fn part<T: Clone>(list: &[T], shard: Shard) -> Vec<T> {
    let [from, to] = shard.range(list.len() as u64).map(|n| usize::try_from(n).unwrap_or(usize::MAX));
    list[from..to].to_vec()
}

/// Never half a file: what goes on would begin with it.
pub fn replace(path: &Path, text: &str) -> Result<(), Failure> {
    let partial = path.with_extension("partial");
    std::fs::write(&partial, text)?;
    Ok(std::fs::rename(&partial, path)?)
}
