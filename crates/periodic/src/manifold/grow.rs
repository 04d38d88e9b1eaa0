//! The growth of a branch: R maps the piece that one return of the branch to itself adds onward, again and again, and
//! points are added where it was stretched or bent.

use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::ManifoldEnd;

use super::curve::{Branch, Curve, Place, Vertex};
use super::model::{Manifold, Manifolds};
use super::refine::{Break, Node, breaks, refine};
use super::world::World;
use crate::flow::Phase;

/// The most returns of points to compute for a branch.
const WORK: usize = 1_000_000;
/// A piece this close to a point of a periodic orbit is followed no further: the errors of its points exceed its turns.
const CAME: f64 = 1e-4;
/// Seeds of the first piece.
const FIRST: u32 = 16;

/// The curves of all branches.
pub fn grow_all(
    worlds: &[World<'_>; 2],
    branches: &[Branch],
    targets: &[Phase],
    length: f64,
    found: &mut Manifolds,
) -> Result<(), SectionError> {
    for (place, branch) in branches.iter().enumerate() {
        let world = &worlds[usize::from(branch.is_stable)];
        let curves = grow(world, (place, branch), targets, length)?;
        let (orbit, kind, multiplier) = (branch.orbit, world.kind(), branch.multiplier);
        match found.manifolds.last_mut().filter(|last| last.orbit == orbit && last.kind == kind) {
            Some(last) => last.curves.extend(curves),
            None => found.manifolds.push(Manifold { orbit, kind, multiplier, curves, are_motions: false }),
        }
    }
    Ok(())
}

/// The curves of a branch, one for each of its returns, each up to its length.
fn grow(
    world: &World<'_>,
    (place, branch): (usize, &Branch),
    targets: &[Phase],
    length: f64,
) -> Result<Vec<Curve>, SectionError> {
    let targets: Vec<Phase> = targets.iter().map(|y| world.mirrored(y)).collect();
    let mut curves = begin(world, (place, branch))?;
    let mut seeds: Vec<f64> = (0..=FIRST).map(|k| f64::from(k) / f64::from(FIRST)).chain(branch.places()).collect();
    seeds.sort_by(f64::total_cmp);
    let first = branch.at(world, &seeds.iter().map(|s| (0, *s)).collect::<Vec<_>>())?;
    let mut nodes: Vec<Node> = seeds.iter().zip(first).map(|(s, place)| Node { s: *s, place }).collect();
    let mut left = WORK;
    for level in 0.. {
        let curve = &mut curves[level % branch.returns];
        if curve.end.is_none() {
            let whole = refine(world, branch, level, &mut nodes, length - curve.length, &mut left)?;
            let broken = breaks(world, branch, level, &nodes)?;
            let came = came_to(&targets, &nodes);
            let is_over = nodes.iter().all(|node| matches!(node.place, Place::Rest | Place::Lost));
            if branch.is_closed() {
                curve.pieces.push(Vec::new());
            }
            let joined = level >= branch.returns && !branch.is_closed();
            curve.extend(world, (level, joined), &nodes, &broken, length);
            curve.end = if curve.length >= length {
                Some(ManifoldEnd::Length)
            } else if came && (is_over || curve.length > 100.0 * CAME) {
                Some(ManifoldEnd::Orbit)
            } else {
                (is_over || !whole).then_some(ManifoldEnd::Work)
            };
        }
        let is_spent = left < nodes.len();
        left = left.saturating_sub(nodes.len());
        if is_spent || curves.iter().all(|curve| curve.end.is_some()) {
            break;
        }
        let (own, points): (Vec<usize>, Vec<Phase>) =
            nodes.iter().enumerate().filter_map(|(k, node)| node.place.point().map(|y| (k, y))).unzip();
        let begun = |(_, node): &(usize, &Node)| matches!(node.place, Place::Before);
        let (late, seeds): (Vec<usize>, Vec<(usize, f64)>) =
            nodes.iter().enumerate().filter(begun).map(|(k, node)| (k, (level + 1, node.s))).unzip();
        let courses = world.courses(&points, 1)?;
        let added = branch.at(world, &seeds)?;
        let places = courses.iter().map(|course| Place::of(course, 1)).chain(added);
        for (k, place) in own.into_iter().chain(late).zip(places) {
            nodes[k].place = place;
        }
    }
    for curve in &mut curves {
        curve.end.get_or_insert(ManifoldEnd::Work);
    }
    Ok(curves)
}

/// The curves at the start, which consist of the points of the orbit.
fn begin(world: &World<'_>, (place, branch): (usize, &Branch)) -> Result<Vec<Curve>, SectionError> {
    let images = if branch.is_of_rest() {
        vec![Vec::new()]
    } else {
        world.map.images(&[branch.start], branch.turns.saturating_sub(1).max(1))?
    };
    let point = |k: usize| match k {
        _ if branch.is_closed() => None,
        _ if k == 0 || branch.is_of_rest() => Some(branch.start),
        _ => images[0].get(k - 1).map(|image| image.point),
    };
    let curve = |k: usize| {
        let number = k % branch.turns;
        let vertex =
            point(number).map(|point| Vertex { point: world.mirrored(&point), level: k, s: f64::NEG_INFINITY });
        Curve::new((number, branch.side_of(k)), vec![vertex.into_iter().collect()], place)
    };
    Ok((0..branch.returns).map(curve).collect())
}

/// Whether the whole piece has reached a periodic orbit, or equilibria.
fn came_to(targets: &[Phase], nodes: &[Node]) -> bool {
    let is_at = |target: &Phase, place: &Place| match place {
        Place::On(y) => (y - target).norm() < CAME,
        Place::Rest => true,
        Place::Before | Place::Lost => false,
    };
    targets.iter().any(|target| nodes.iter().all(|node| is_at(target, &node.place)))
}

impl Curve {
    /// Adds a piece, as far as the length allows.
    fn extend(
        &mut self,
        world: &World<'_>,
        (level, joined): (usize, bool),
        nodes: &[Node],
        broken: &[Option<Break>],
        length: f64,
    ) {
        // The last seed of a return is the first of the next.
        for (k, node) in nodes.iter().enumerate().skip(usize::from(joined)) {
            let before = k.checked_sub(1).and_then(|k| broken[k]);
            if let Some(kind) = before {
                match kind {
                    Break::Begin => {}
                    Break::Tangency => self.tangencies += 1,
                    Break::Rest => self.rests += 1,
                    Break::Gap => self.gaps += 1,
                }
                // The equilibrium itself is joined to where its curve begins.
                if kind != Break::Begin || self.pieces.last().is_some_and(|piece| piece.len() > 1) {
                    self.pieces.push(Vec::new());
                }
            }
            let Some(point) = node.place.point().map(|y| world.mirrored(&y)) else { continue };
            let Some(piece) = self.pieces.last_mut() else { continue };
            if let Some(last) = piece.last() {
                self.length += (point - last.point).norm();
            }
            piece.push(Vertex { point, level, s: node.s });
            if self.length >= length {
                break;
            }
        }
        self.pieces.retain(|piece| !piece.is_empty());
    }
}
