//! The first orbits of a family: around an equilibrium, and next to a special orbit.

use bifdiag_dynamics::field::Dimension;
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity};
use bifdiag_schema::{FamilyEnd, OrbitEventKind};
use nalgebra::{Matrix2, Vector2};

use super::follow::{Course, steady_state};
use super::member::Member;
use super::model::{FamilyError, Stretch};
use crate::flow::{Phase, Tangent};
use crate::orbit::NODES;
use crate::shooting::{Direction, Ring};

/// Sizes of the first orbit around an equilibrium, where |γ| = 1: beside another equilibrium a large one may be of that.
const FIRST: [f64; 3] = [1e-3, 1e-4, 1e-5];
/// The middle of the first orbit is nearer to the equilibrium than this share of its size.
const MIDDLE: f64 = 0.5;
/// Distances from a special orbit at which a branch is tried, the best first.
const BESIDE: [f64; 3] = [1e-2, 3e-3, 3e-2];
/// Directions in which the family that passes a tripling is tried. Up to a linear map its orbits lie in six, a sixth of
/// a turn apart.
const ROUND: u32 = 12;
/// Two frequencies in a whole ratio within this are in resonance.
const RESONANT: f64 = 1e-6;

impl Course<'_> {
    /// The family of the pair ±i`frequency`, in the units of the reduced top.
    pub fn beginning_at(&self, equilibrium: &Equilibrium, frequency: f64) -> Result<Stretch, FamilyError> {
        if !matches!(equilibrium.multiplicity, Multiplicity::Points(_)) {
            return Ok(Stretch::none(FamilyEnd::NotIsolated));
        }
        let units = self.units;
        let point = self.space.point(&steady_state(equilibrium, self.moments).reduced(units));
        let others = equilibrium.eigenvalues.pairs.map(|[re, im]| (re, units.reduce(im, Dimension::FREQUENCY)));
        let is_other = |(re, im): &&(f64, f64)| *re != 0.0 || *im != frequency;
        let resonant = match others.iter().find(is_other) {
            // The two pairs coincide.
            None => true,
            Some((re, im)) => *re == 0.0 && ((im / frequency).round() - im / frequency).abs() < RESONANT,
        };
        if resonant {
            return Ok(Stretch::none(FamilyEnd::Resonant));
        }
        let turn = self.space.linearised(&point);
        let Some(direction) = oscillation(&turn, frequency) else {
            return Ok(Stretch::none(FamilyEnd::Resonant));
        };
        // (The number of nodes is even: where a family ends at orbits of half its period, nodes half a turn apart
        // meet.)
        let first = FIRST.into_iter().find_map(|size| {
            let node = |k: usize| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / NODES as f64);
                point + (direction * cos + turn * direction * (sin / frequency)) * size
            };
            let guess = Ring { nodes: (0..NODES).map(node).collect(), period: std::f64::consts::TAU / frequency };
            let member = self.setting().close(guess, &direction.push(0.0), None).ok()?;
            let nodes = &member.shot.ring.nodes;
            let middle = nodes.iter().sum::<Phase>() / nodes.len() as f64;
            ((middle - point).norm() < MIDDLE * size).then_some((member, size))
        });
        match first {
            Some((first, size)) => self.follow(first, 0.5 * size, false),
            None => Ok(Stretch::none(FamilyEnd::Lost)),
        }
    }

    /// The families found to begin at a special orbit: at a tripling, both directions of the one that passes.
    pub fn beside(
        &self,
        special: &Member,
        is_symmetric: bool,
        kind: OrbitEventKind,
    ) -> Result<Vec<Stretch>, FamilyError> {
        let (laps, angles) = match kind {
            OrbitEventKind::Doubling => (2, kernel_of(special, -1.0)),
            OrbitEventKind::Branch => (1, kernel_of(special, 1.0)),
            // After three turns every direction returns to itself, and that of the passing family is unknown.
            OrbitEventKind::Tripling => (3, (0..ROUND).map(|k| f64::from(k) / f64::from(ROUND)).collect()),
            OrbitEventKind::Fold => return Ok(Vec::new()),
        };
        let once = &special.shot.ring;
        let nodes: Vec<Phase> = (0..laps).flat_map(|_| once.nodes.iter().copied()).collect();
        let ring = Ring { nodes, period: f64::from(laps) * once.period };
        let Ok(several) = ring.shoot(&self.space, self.setting().level, None) else { return Ok(Vec::new()) };
        let across = special.shot.frames[0].across;
        let look = |distance: f64, [x, y]: [f64; 2]| {
            let direction: Direction = (across[0] * x + across[1] * y).push(0.0);
            let guess = several.ahead(&direction, distance);
            let member = self.setting().close(guess, &direction, None).ok()?;
            // Newton's method may have fallen back onto the original family.
            let is_new = match kind {
                OrbitEventKind::Doubling => member.distance_from_half() > distance,
                OrbitEventKind::Tripling => member.distance_from_third() > distance,
                _ => is_symmetric && !self.describe(&member).symmetric,
            };
            is_new.then_some(member)
        };
        for (distance, angle) in BESIDE.iter().flat_map(|distance| angles.iter().map(move |angle| (*distance, *angle)))
        {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * angle);
            let Some(member) = look(distance, [cos, sin]) else { continue };
            let beside = |member: &Member| {
                let away = member.shot.ring.nodes[0] - once.nodes[0];
                across.map(|unit| unit.dot(&away))
            };
            let [x, y] = beside(&member);
            let size = (x * x + y * y).sqrt();
            let mut found = vec![self.follow(member, 0.5 * distance, true)?];
            // The family leaves in the opposite direction as well.
            let opposite = [-x / size, -y / size];
            if kind == OrbitEventKind::Tripling
                && let Some(other) = look(distance, opposite)
            {
                let [u, v] = beside(&other);
                if (u * opposite[1] - v * opposite[0]).abs() < 0.5 * distance {
                    found.push(self.follow(other, 0.5 * distance, true)?);
                }
            }
            return Ok(found);
        }
        Ok(Vec::new())
    }
}

/// The angle, as a fraction of a turn, of the eigendirection of the return for an eigenvalue.
fn kernel_of(special: &Member, eigenvalue: f64) -> Vec<f64> {
    let kernel = kernel(special.shot.reduced().matrix - eigenvalue * Matrix2::identity());
    kernel.map(|v| libm::atan2(v[1], v[0]) / std::f64::consts::TAU).into_iter().collect()
}

/// A direction of length 1 in the plane in which the linearised flow rotates with this frequency, the kernel of
/// J² + ω².
fn oscillation(linearised: &Tangent, frequency: f64) -> Option<Phase> {
    let squared = linearised * linearised + Tangent::identity() * (frequency * frequency);
    let svd = squared.svd(false, true);
    let (sizes, rows) = (svd.singular_values, svd.v_t?);
    let mut order: Vec<usize> = (0..6).collect();
    order.sort_by(|&i, &j| sizes[i].total_cmp(&sizes[j]));
    // The kernel has two dimensions, not more.
    (sizes[order[2]] > 1e-5 * sizes[order[5]]).then(|| rows.row(order[0]).transpose())
}

/// The kernel of a matrix of rank 1.
fn kernel(matrix: Matrix2<f64>) -> Option<Vector2<f64>> {
    let row = if matrix.row(0).norm() > matrix.row(1).norm() { matrix.row(0) } else { matrix.row(1) };
    let across = Vector2::new(row[1], -row[0]);
    (across.norm() > 1e-9).then(|| across.normalize())
}
