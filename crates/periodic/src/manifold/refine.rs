//! Adds seeds until neighbouring points of a curve are close and its bends small, and classifies the jumps that remain.

use bifdiag_dynamics::section::SectionError;

use super::curve::{Branch, Place};
use super::world::World;
use crate::flow::Phase;
use crate::section_map::Image;

/// The largest distance between neighbours.
pub const GAP: f64 = 0.02;
/// The largest difference between the unit vectors along neighbouring chords, nearly their angle in radians, …
const BEND: f64 = 0.2;
/// … unless they are shorter than this.
const SHORT: f64 = 1e-3;
/// Seeds this close are not refined; where their images are farther apart than `GAP`, the curve is broken.
const CLOSEST: f64 = 1e-9;
/// A crossing closer than this to its twin was just born.
const BORN: f64 = 1e-2;

/// An equilibrium tears a motion that passes this close from its neighbours.
const TORN: f64 = 1e-2;

/// A seed and its image.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// The seed.
    pub s: f64,
    /// Its image.
    pub place: Place,
}

/// Why two neighbours are not joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Break {
    /// The curve begins between them, or begins anew beyond a motion that approaches an equilibrium, or ends where it
    /// began.
    Begin,
    /// Between them lies a motion that touches P.
    Tangency,
    /// Between them lies a motion that approaches an equilibrium.
    Rest,
    /// They could not be brought closer.
    Gap,
}

fn distance(a: &Node, b: &Node) -> f64 {
    match (a.place, b.place) {
        (Place::On(a), Place::On(b)) => (b - a).norm(),
        (Place::Before | Place::Rest, Place::Before | Place::Rest) => 0.0,
        _ => f64::INFINITY,
    }
}

fn is_broken(pair: &[Node]) -> bool {
    pair[1].s - pair[0].s <= CLOSEST && distance(&pair[0], &pair[1]) > GAP
}

/// Adds nodes until the curve is fine enough up to `length`; false where that needs more returns than are `left`.
pub fn refine(
    world: &World<'_>,
    branch: &Branch,
    level: usize,
    nodes: &mut Vec<Node>,
    length: f64,
    left: &mut usize,
) -> Result<bool, SectionError> {
    loop {
        let coarse = coarse(nodes, length);
        let added: Vec<f64> = coarse.iter().map(|k| 0.5 * (nodes[*k].s + nodes[k + 1].s)).collect();
        if added.is_empty() {
            return Ok(true);
        }
        let work = added.len() * (level + 1);
        if work > *left {
            return Ok(false);
        }
        *left -= work;
        let places: Vec<(usize, f64)> = added.iter().map(|s| (level, *s)).collect();
        let points = branch.at(world, &places)?;
        nodes.extend(added.into_iter().zip(points).map(|(s, place)| Node { s, place }));
        nodes.sort_by(|a, b| a.s.total_cmp(&b.s));
    }
}

/// The intervals to be cut.
fn coarse(nodes: &[Node], length: f64) -> Vec<usize> {
    let mut marked = vec![false; nodes.len() - 1];
    let mut covered = 0.0;
    let mut before: Option<Phase> = None;
    for (k, pair) in nodes.windows(2).enumerate() {
        if covered >= length {
            break;
        }
        if is_broken(pair) {
            before = None;
            continue;
        }
        let gap = distance(&pair[0], &pair[1]);
        let can_be_cut = pair[1].s - pair[0].s > CLOSEST;
        if gap > GAP {
            marked[k] = true;
        }
        let chord = pair[0].place.point().zip(pair[1].place.point()).map(|(a, b)| b - a);
        if let Some((a, b)) = before.zip(chord) {
            let turned = (b / b.norm() - a / a.norm()).norm();
            if turned > BEND && a.norm().max(b.norm()) > SHORT {
                let longer = if a.norm() > b.norm() { k - 1 } else { k };
                marked[longer] |= can_be_cut;
            }
        }
        before = chord.filter(|chord| chord.norm() > 0.0);
        if gap.is_finite() {
            covered += gap;
        }
    }
    (0..marked.len()).filter(|k| marked[*k]).collect()
}

/// For each pair of neighbours, whether the curve is broken between them, and why.
pub fn breaks(
    world: &World<'_>,
    branch: &Branch,
    level: usize,
    nodes: &[Node],
) -> Result<Vec<Option<Break>>, SectionError> {
    let is_apart = |pair: &[Node]| {
        let kind = match (pair[0].place, pair[1].place) {
            (Place::Before, _) | (_, Place::Before) | (Place::Rest, Place::On(_)) => Break::Begin,
            (Place::On(_), Place::Rest) => Break::Rest,
            _ => Break::Gap,
        };
        (distance(&pair[0], &pair[1]) > GAP).then_some(kind)
    };
    let mut broken: Vec<Option<Break>> = nodes.windows(2).map(is_apart).collect();
    let seed = |k: usize| branch.seed(world.surface(), nodes[k].s);
    let jumps = (0..broken.len()).filter(|k| broken[*k] == Some(Break::Gap) && is_broken(&nodes[*k..=k + 1]));
    let jumps = jumps.filter_map(|k| Some((k, [seed(k)?, seed(k + 1)?])));
    let (places, starts): (Vec<usize>, Vec<[Phase; 2]>) = jumps.unzip();
    if places.is_empty() {
        return Ok(broken);
    }
    let most = nodes.iter().filter_map(|node| branch.returns_to(level, node.s)).max().unwrap_or(1);
    let courses = world.courses(&starts.concat(), most.max(1))?;
    for (pair, k) in courses.chunks(2).zip(places) {
        // The same crossing may have different numbers on the two motions.
        let numbers = [k, k + 1].map(|k| branch.returns_to(level, nodes[k].s).unwrap_or(0).max(1));
        let least = numbers[0].min(numbers[1]);
        let [a, b] = [0, 1].map(|end| {
            let images = &pair[end].images;
            let last = numbers[end].min(images.len());
            &images[(numbers[end] - least).min(last)..last]
        });
        // At the first return that jumps, a crossing was just born or an equilibrium lies on the way.
        let jump = a.iter().zip(b).position(|(a, b)| (a.point - b.point).norm() > 0.1 * GAP);
        broken[k] = Some(match jump {
            Some(at) if a[at].pair.min(b[at].pair) < BORN => Break::Tangency,
            Some(at) if at > 0 && is_torn(world, &a[at - 1..=at]) => Break::Rest,
            _ => Break::Gap,
        });
    }
    Ok(broken)
}

/// Whether the motion passes close to an equilibrium between two returns.
fn is_torn(world: &World<'_>, pair: &[Image]) -> bool {
    world.passes(&pair[0].point, pair[1].time - pair[0].time, TORN)
}
