//! The first orbits: around an equilibrium, and beside a special orbit.

use bifdiag_dynamics::field::{Dimension, State};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity};
use bifdiag_schema::{FamilyEnd, OrbitEventKind};
use nalgebra::{Matrix2, Vector2};

use super::follow::Course;
use super::member::Member;
use super::model::{FamilyError, Stretch};
use crate::flow::{Phase, Tangent};
use crate::shooting::{Direction, Ring};

/// Size of the first orbit around an equilibrium, γ being of length 1.
const FIRST: f64 = 1e-3;
/// Distances from a special orbit at which a branch is looked for, the best first.
const BESIDE: [f64; 3] = [1e-2, 3e-3, 3e-2];
/// Two frequencies in a whole ratio within this are in resonance.
const RESONANT: f64 = 1e-6;

impl Course<'_> {
    /// The family of the pair ±i`frequency`, in the units of the reduced top.
    pub fn beginning_at(&self, equilibrium: &Equilibrium, frequency: f64) -> Result<Stretch, FamilyError> {
        if !matches!(equilibrium.multiplicity, Multiplicity::Points(1)) {
            return Ok(Stretch::none(FamilyEnd::NotIsolated));
        }
        let units = self.units;
        let point = self.space.point(&state_of(equilibrium, self.moments).reduced(units));
        let others = equilibrium.eigenvalues.pairs.map(|[re, im]| (re, units.reduce(im, Dimension::FREQUENCY)));
        let is_other = |(re, im): &&(f64, f64)| *re != 0.0 || *im != frequency;
        let resonant = match others.iter().find(is_other) {
            // The other pair is this one, or a multiple of it.
            None => true,
            Some((re, im)) => *re == 0.0 && ((im / frequency).round() - im / frequency).abs() < RESONANT,
        };
        if resonant {
            return Ok(Stretch::none(FamilyEnd::Resonant));
        }
        let Some(direction) = oscillation(&self.space.linearised(&point), frequency) else {
            return Ok(Stretch::none(FamilyEnd::Resonant));
        };
        // Two nodes, half a turn apart: a family may end at orbits of half its period, where they meet.
        let nodes = vec![point + direction * FIRST, point - direction * FIRST];
        let guess = Ring { nodes, period: std::f64::consts::TAU / frequency };
        match self.setting().close(guess, &direction.push(0.0)) {
            Ok(first) => self.follow(first, 0.5 * FIRST, false),
            Err(_) => Ok(Stretch::none(FamilyEnd::Lost)),
        }
    }

    /// The family that begins at a special orbit, if one is found.
    pub fn beside(&self, special: &Member, kind: OrbitEventKind) -> Result<Option<Stretch>, FamilyError> {
        let (eigenvalue, laps) = match kind {
            OrbitEventKind::Doubling => (-1.0, 2),
            OrbitEventKind::Branch => (1.0, 1),
            _ => return Ok(None),
        };
        let Some(kernel) = kernel(special.shot.reduced().matrix - eigenvalue * Matrix2::identity()) else {
            return Ok(None);
        };
        let [first, second] = special.shot.frames[0].across;
        let direction: Direction = (first * kernel[0] + second * kernel[1]).push(0.0);
        let once = &special.shot.ring;
        let nodes: Vec<Phase> = (0..laps).flat_map(|_| once.nodes.iter().copied()).collect();
        let ring = Ring { nodes, period: f64::from(laps) * once.period };
        let Ok(several) = ring.shoot(&self.space) else { return Ok(None) };
        for distance in BESIDE {
            let guess = several.ahead(&self.space, &direction, distance);
            let Ok(found) = self.setting().close(guess, &direction) else { continue };
            // Newton's method may have fallen back onto the family that is left.
            let is_new = match kind {
                OrbitEventKind::Doubling => found.distance_from_half() > distance,
                _ => special.orbit.symmetric && !found.orbit.symmetric,
            };
            if is_new {
                return Ok(Some(self.follow(found, 0.5 * distance, true)?));
            }
        }
        Ok(None)
    }
}

/// (γ, l) of a steady rotation: l = ΩAγ.
fn state_of(equilibrium: &Equilibrium, moments: [f64; 3]) -> State {
    let gamma = equilibrium.gamma;
    State { gamma, l: std::array::from_fn(|i| equilibrium.omega * moments[i] * gamma[i]) }
}

/// A direction of length 1 in the plane in which the linearised flow turns with this frequency, where J² + ω² vanishes.
fn oscillation(linearised: &Tangent, frequency: f64) -> Option<Phase> {
    let squared = linearised * linearised + Tangent::identity() * (frequency * frequency);
    let svd = squared.svd(false, true);
    let (sizes, rows) = (svd.singular_values, svd.v_t?);
    let mut order: Vec<usize> = (0..6).collect();
    order.sort_by(|&i, &j| sizes[i].total_cmp(&sizes[j]));
    // Two directions, and no third.
    (sizes[order[2]] > 1e-5 * sizes[order[5]]).then(|| rows.row(order[0]).transpose())
}

/// The direction on which a matrix of rank 1 vanishes.
fn kernel(matrix: Matrix2<f64>) -> Option<Vector2<f64>> {
    let row = if matrix.row(0).norm() > matrix.row(1).norm() { matrix.row(0) } else { matrix.row(1) };
    let across = Vector2::new(row[1], -row[0]);
    (across.norm() > 1e-9).then(|| across.normalize())
}
