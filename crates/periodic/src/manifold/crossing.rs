//! Where unstable and stable manifolds cross: the orbits that leave one periodic orbit and approach the same or another
//! one.
//!
//! Crossings of the polylines are refined by Newton's method in the two seeds; the same homoclinic orbit crosses P⁻ in
//! infinitely many points, and R maps each to the next.

use std::collections::HashMap;

use bifdiag_dynamics::section::SectionError;
use bifdiag_numbers::table::Partition;

use super::curve::{Branch, Vertex};
use super::model::{Connection, Manifolds};
use super::refine::GAP;
use super::world::World;
use crate::flow::Phase;
use bifdiag_schema::ManifoldKind;

/// Curves that meet at a smaller angle cannot be distinguished from curves that coincide.
pub const ANGLE: f64 = 1e-4;
/// The largest distance between the points of the two curves at a crossing.
pub const RESIDUAL: f64 = 1e-10;
/// Curves that nearly coincide are no farther apart than this.
const BESIDE: f64 = 1e-6;
/// Crossings this close to the periodic orbits are ignored: they recur there endlessly, between curves that turn within
/// smaller and smaller distances.
const NEAR: f64 = 1e-3;
/// Points closer than this coincide.
const SAME: f64 = 1e-7;
/// Steps of Newton's method.
const STEPS: usize = 10;
/// The step of difference quotients, as a share of the distance between neighbouring seeds.
const SHARE: f64 = 0.01;
/// How far a chord is taken to reach beyond its ends, and how far Newton's method may move, in units of the chord.
const BEYOND: [f64; 2] = [0.02, 3.0];
/// Candidates refined together.
const BATCH: usize = 1024;
const CELL: f64 = 2.0 * GAP;

/// A chord of a curve, with the seeds of its ends at one level.
#[derive(Clone, Copy)]
struct Chord {
    branch: usize,
    level: usize,
    s: [f64; 2],
    ends: [Phase; 2],
}

/// A place on a curve, moved along it by Newton's method.
#[derive(Clone, Copy)]
struct Place {
    branch: usize,
    level: usize,
    s: f64,
    first: f64,
    spacing: f64,
}

impl Place {
    fn on(chord: &Chord, share: f64) -> Self {
        let spacing = chord.s[1] - chord.s[0];
        let s = chord.s[0] + share * spacing;
        Self { branch: chord.branch, level: chord.level, s, first: s, spacing }
    }

    /// Just before it, at it, and just after it.
    fn around(&self) -> [f64; 3] {
        [-SHARE, 0.0, SHARE].map(|share| self.s + share * self.spacing)
    }
}

/// A crossing of two curves.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// The point.
    pub point: Phase,
    /// The angle of the curves.
    pub angle: f64,
    /// The distance between the points of the two curves.
    pub residual: f64,
    from: usize,
    to: usize,
}

enum Outcome {
    Crossing(Crossing),
    Contact,
    Near,
    Lost,
}

/// Finds the crossings.
pub fn connect(
    worlds: &[World<'_>; 2],
    branches: &[Branch],
    targets: &[Phase],
    found: &mut Manifolds,
) -> Result<(), SectionError> {
    let finder = Finder { worlds, branches, targets };
    let candidates = finder.candidates(found);
    let mut crossings: Vec<Crossing> = Vec::new();
    for batch in candidates.chunks(BATCH) {
        for (pair, outcome) in batch.iter().zip(finder.refine(batch)?) {
            let [from, to] = pair.map(|place| branches[place.branch].orbit);
            match outcome {
                Outcome::Crossing(crossing) => {
                    let is_known = |known: &Crossing| (known.point - crossing.point).norm() < SAME;
                    if !crossings.iter().any(is_known) {
                        crossings.push(crossing);
                    }
                }
                Outcome::Contact => found.touch(from, to),
                Outcome::Near => {}
                Outcome::Lost => found.unresolved += 1,
            }
        }
    }
    found.connections = finder.orbits(&crossings)?;
    Ok(())
}

struct Finder<'a> {
    worlds: &'a [World<'a>; 2],
    branches: &'a [Branch],
    targets: &'a [Phase],
}

impl Finder<'_> {
    fn is_near_an_orbit(&self, y: &Phase) -> bool {
        self.targets.iter().any(|target| (y - target).norm() < NEAR)
    }

    fn chords(&self, found: &Manifolds, kind: ManifoldKind) -> Vec<Chord> {
        let own = found.manifolds.iter().filter(|manifold| manifold.kind == kind);
        let mut chords = Vec::new();
        for curve in own.flat_map(|manifold| &manifold.curves) {
            let pairs = curve.pieces.iter().flat_map(|piece| piece.windows(2));
            chords.extend(pairs.filter_map(|pair| chord(curve.branch, &pair[0], &pair[1])));
        }
        chords.retain(|chord| !chord.ends.iter().all(|y| self.is_near_an_orbit(y)));
        chords
    }

    /// Crossings of the polylines, in the tangent plane at one end.
    fn candidates(&self, found: &Manifolds) -> Vec<[Place; 2]> {
        let [leaving, coming] = [ManifoldKind::Unstable, ManifoldKind::Stable].map(|kind| self.chords(found, kind));
        let mut grid: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
        for (k, chord) in coming.iter().enumerate() {
            for cell in cells(chord) {
                grid.entry(cell).or_default().push(k);
            }
        }
        let mut candidates = Vec::new();
        for first in &leaving {
            let mut near: Vec<usize> =
                cells(first).iter().filter_map(|cell| grid.get(cell)).flatten().copied().collect();
            near.sort_unstable();
            near.dedup();
            let reach = |other: &Chord| (other.ends[0] - first.ends[0]).norm() < 4.0 * GAP;
            near.retain(|k| reach(&coming[*k]));
            if near.is_empty() {
                continue;
            }
            let Some(plane) = self.worlds[0].surface().tangent_plane(&first.ends[0]) else { continue };
            for k in near {
                if let Some([a, b]) = meet(&plane, first, &coming[k]) {
                    candidates.push([Place::on(first, a), Place::on(&coming[k], b)]);
                }
            }
        }
        candidates
    }

    /// The points at many places, in the world at l.
    fn points(&self, places: &[(usize, usize, f64)]) -> Result<Vec<Option<Phase>>, SectionError> {
        let mut points = vec![None; places.len()];
        for (number, branch) in self.branches.iter().enumerate() {
            let own: Vec<usize> = (0..places.len()).filter(|k| places[*k].0 == number).collect();
            let asked: Vec<(usize, f64)> = own.iter().map(|k| (places[*k].1, places[*k].2)).collect();
            let world = &self.worlds[usize::from(branch.is_stable)];
            for (k, point) in own.into_iter().zip(branch.at(world, &asked)?) {
                points[k] = point.point().map(|y| world.mirrored(&y));
            }
        }
        Ok(points)
    }

    /// Newton's method for each candidate.
    fn refine(&self, candidates: &[[Place; 2]]) -> Result<Vec<Outcome>, SectionError> {
        let mut outcomes: Vec<Outcome> = candidates.iter().map(|_| Outcome::Lost).collect();
        let mut active: Vec<(usize, [Place; 2])> = candidates.iter().copied().enumerate().collect();
        for _ in 0..STEPS {
            let asked: Vec<(usize, usize, f64)> = active
                .iter()
                .flat_map(|(_, pair)| *pair)
                .flat_map(|place| place.around().map(|s| (place.branch, place.level, s)))
                .collect();
            let points = self.points(&asked)?;
            let mut left = Vec::new();
            for ((k, mut pair), own) in active.into_iter().zip(points.chunks(6)) {
                let Some(own) = own.iter().copied().collect::<Option<Vec<Phase>>>() else { continue };
                let Some(approach) = self.approach(&own) else { continue };
                if self.is_near_an_orbit(&own[1]) {
                    outcomes[k] = Outcome::Near;
                    continue;
                }
                if approach.sine < ANGLE {
                    outcomes[k] = if approach.beside < BESIDE { Outcome::Contact } else { Outcome::Lost };
                    continue;
                }
                let best = if let Outcome::Crossing(crossing) = &outcomes[k] { crossing.residual } else { RESIDUAL };
                if approach.residual <= best {
                    let [from, to] = pair.map(|place| self.branches[place.branch].orbit);
                    let (point, residual) = (own[1], approach.residual);
                    let angle = libm::asin(approach.sine.min(1.0));
                    outcomes[k] = Outcome::Crossing(Crossing { point, angle, residual, from, to });
                    if residual < 1e-13 {
                        continue;
                    }
                } else if matches!(outcomes[k], Outcome::Crossing(_)) {
                    continue;
                }
                let mut stays = true;
                for (place, step) in pair.iter_mut().zip(approach.step) {
                    place.s += step * SHARE * place.spacing;
                    stays &= (place.s - place.first).abs() <= BEYOND[1] * place.spacing;
                }
                if stays {
                    left.push((k, pair));
                }
            }
            active = left;
            if active.is_empty() {
                break;
            }
        }
        Ok(outcomes)
    }

    fn approach(&self, own: &[Phase]) -> Option<Approach> {
        let plane = self.worlds[0].surface().tangent_plane(&own[1])?;
        let flat = |v: Phase| [plane[0].dot(&v), plane[1].dot(&v)];
        let [u, v] = [flat((own[2] - own[0]) * 0.5), flat((own[5] - own[3]) * 0.5)];
        let apart = own[4] - own[1];
        let [x, y] = flat(apart);
        let across = u[0] * v[1] - u[1] * v[0];
        let [long, wide] = [u, v].map(|[a, b]| (a * a + b * b).sqrt());
        let sine = (across / (long * wide)).abs();
        let step = [(x * v[1] - y * v[0]) / across, (x * u[1] - y * u[0]) / across];
        let beside = ((u[0] * y - u[1] * x) / long).abs();
        Some(Approach { sine, step, beside, residual: apart.norm() }).filter(|approach| approach.sine.is_finite())
    }

    /// Groups crossings into orbits.
    fn orbits(&self, crossings: &[Crossing]) -> Result<Vec<Connection>, SectionError> {
        let starts: Vec<Phase> = crossings.iter().map(|crossing| crossing.point).collect();
        let images = self.worlds[0].map.images(&starts, 1)?;
        let mut sets = Partition::new(crossings.len());
        for (k, images) in images.iter().enumerate() {
            let Some(image) = images.first() else { continue };
            for (other, crossing) in crossings.iter().enumerate() {
                let (a, b) = (&crossings[k], crossing);
                // The residual is stretched once.
                if a.from == b.from && a.to == b.to && (image.point - b.point).norm() < 10.0 * SAME {
                    sets.unite(k, other);
                }
            }
        }
        let away = |k: usize| {
            let far = self.targets.iter().map(|target| (starts[k] - target).norm());
            far.fold(f64::INFINITY, f64::min)
        };
        let mut connections = Vec::new();
        let of: Vec<usize> = (0..crossings.len()).map(|k| sets.find(k)).collect();
        for set in (0..crossings.len()).filter(|k| of[*k] == *k) {
            let own: Vec<usize> = (0..crossings.len()).filter(|k| of[*k] == set).collect();
            let Some(farthest) = own.iter().copied().max_by(|a, b| away(*a).total_cmp(&away(*b))) else { continue };
            let Crossing { point, angle, residual, from, to } = crossings[farthest];
            let state = self.worlds[0].surface().state(&point);
            connections.push(Connection { from, to, state, angle, residual, points: own.len() });
        }
        connections.sort_by(|a, b| {
            let key = |c: &Connection| (c.from, c.to, std::cmp::Reverse(c.points));
            key(a).cmp(&key(b)).then(b.angle.total_cmp(&a.angle))
        });
        Ok(connections)
    }
}

/// How two curves lie to each other at a pair of places.
struct Approach {
    /// The sine of their angle.
    sine: f64,
    /// The steps to where their tangents cross, in units of the difference step.
    step: [f64; 2],
    /// The distance of a point of the second from the tangent of the first.
    beside: f64,
    residual: f64,
}

fn chord(branch: usize, a: &Vertex, b: &Vertex) -> Option<Chord> {
    // The end of one return is the beginning of the next.
    let from = if a.level == b.level { a.s } else { a.s - 1.0 };
    let chord = Chord { branch, level: b.level, s: [from, b.s], ends: [a.point, b.point] };
    (from.is_finite() && b.s > from).then_some(chord)
}

/// The cells of γ-space that a chord meets, with a margin for its curve.
#[expect(clippy::cast_possible_truncation, reason = "γ is a unit vector, so that the numbers are small")]
fn cells(chord: &Chord) -> Vec<[i32; 3]> {
    let margin = 0.1 * GAP;
    let range = |i: usize| {
        let [a, b] = chord.ends.map(|y| y[i]);
        let [from, to] = [a.min(b) - margin, a.max(b) + margin].map(|x| (x / CELL).floor() as i32);
        from..=to
    };
    range(0).flat_map(|i| range(1).flat_map(move |j| range(2).map(move |k| [i, j, k]))).collect()
}

/// Where two chords cross in a plane, as fractions of each.
fn meet(plane: &[Phase; 2], first: &Chord, second: &Chord) -> Option<[f64; 2]> {
    let flat = |v: Phase| [plane[0].dot(&v), plane[1].dot(&v)];
    let [u, v] = [first, second].map(|chord| flat(chord.ends[1] - chord.ends[0]));
    let d = flat(second.ends[0] - first.ends[0]);
    let across = u[0] * v[1] - u[1] * v[0];
    let shares = [(d[0] * v[1] - d[1] * v[0]) / across, (d[0] * u[1] - d[1] * u[0]) / across];
    let is_on = |share: &f64| (-BEYOND[0]..=1.0 + BEYOND[0]).contains(share);
    let at = |chord: &Chord, share: f64| chord.ends[0] + (chord.ends[1] - chord.ends[0]) * share;
    let apart = || (at(first, shares[0]) - at(second, shares[1])).norm();
    (shares.iter().all(is_on) && apart() < 0.5 * GAP).then_some(shares)
}
