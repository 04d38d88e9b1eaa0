//! The state of the campaign in a file.

use std::fmt;
use std::path::Path;

use serde::{Deserialize, Serialize};
use survey::graph::{ClassGraph, Domain, Edge, Node, Place, Step};

use crate::Failure;

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

#[derive(Serialize, Deserialize)]
struct NodeState {
    class: String,
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
    distance: f64,
    met: [u64; 2],
}

#[derive(Serialize, Deserialize)]
struct EdgeState {
    classes: [String; 2],
    event: String,
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
    error: f64,
    walls: [u64; 2],
}

#[derive(Serialize, Deserialize)]
struct Stored {
    rounds: Vec<Round>,
    classes: Vec<NodeState>,
    borders: Vec<EdgeState>,
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

pub fn word(domain: Domain) -> &'static str {
    match domain {
        Domain::Existing => "existing",
        Domain::All => "all",
    }
}

impl Round {
    pub fn new(domain: Domain, seed: u64, number: u64) -> Self {
        let domain = word(domain).to_owned();
        Self { domain, seed, number, lines: 0, walls: 0, lost: 0, new_at: Vec::new() }
    }

    pub fn add(&mut self, step: &Step, graph: &mut ClassGraph, domain: Domain) {
        let (walls, new) = graph.add_step(step, domain);
        self.lines += 1;
        self.lost += step.sides.iter().map(|(chord, _)| u64::from(chord.lost)).sum::<u64>();
        self.new_at.extend(new.into_iter().map(|place| self.walls + place));
        self.walls += walls;
    }

    /// Walls since the last new class, if there were so many before.
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

    /// Every witness is looked at again: what the file says its class is must be so.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let stored: Stored = serde_json::from_str(&std::fs::read_to_string(path)?)?;
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
            let place = Place { a: border.moments, r: border.center };
            let edge = Edge { place, error: border.error, walls: border.walls };
            state.graph.edges.insert(([one.parse()?, other.parse()?], border.event), edge);
        }
        Ok(state)
    }

    pub fn join(&mut self, other: Self) {
        self.graph.join(other.graph);
        self.rounds.extend(other.rounds);
    }

    pub fn write(&self, path: &Path) -> Result<(), Failure> {
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
        let stored = Stored { rounds: self.rounds.clone(), classes: classes.collect(), borders: borders.collect() };
        // Never half a file: the next round would begin with it.
        let partial = path.with_extension("partial");
        std::fs::write(&partial, serde_json::to_string(&stored)?)?;
        Ok(std::fs::rename(&partial, path)?)
    }
}
