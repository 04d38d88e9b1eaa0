//! Newton's method for closed orbits, by multiple shooting.
//!
//! An orbit is a ring of nodes at equal time steps; its **defects** are the differences between where the flow takes a
//! node and the next node. Between two nodes the flow stretches by a bounded factor, so that defects can be small for
//! unstable orbits too. All nodes have |γ| = 1 and lie on one level of l or h, which the flow preserves. Two of the six
//! closing equations are therefore redundant, and so is a third, since the flow preserves the other integral as well.
//! What remains are the components of the last defect along and across the orbit.
//!
//! The derivative costs several times as much as the flow alone. So an orbit is corrected with the derivative
//! extrapolated from its neighbours as long as that reduces the defects, and with its own derivative otherwise. At the
//! end its own is always computed, since the multipliers must come from the orbit itself.

use bifdiag_dynamics::integrator::{StepError, TaylorStep};
use nalgebra::{SMatrix, SVector};
use thiserror::Error;

use crate::chain::{Chain, Link, Move, Reduced};
use crate::flow::{Frame, Level, Parts, Passage, Phase, Space};

/// A direction in the space of orbits: a direction of the first node, and the relative change of the period.
pub type Direction = SVector<f64, 7>;

/// A closed orbit, or a guess of one.
#[derive(Clone, Debug)]
pub struct Ring {
    /// Points of the orbit, at equal time steps.
    pub nodes: Vec<Phase>,
    /// Its period.
    pub period: f64,
}

/// What determines an orbit, besides its level and its phase.
#[derive(Clone, Copy, Debug)]
pub enum Keep {
    /// The energy, where the level fixes ⟨γ,l⟩.
    Energy(f64),
    /// The position of the guess along this direction.
    Place(Direction),
}

/// Why an orbit could not be closed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ShootingError {
    /// The motion leaves the range of `f64`.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The equations are singular: an equilibrium, or a continuum of orbits.
    #[error("the equations of the closed orbit are singular")]
    Singular,
    /// Newton's method did not converge.
    #[error("Newton's method left a defect of {residual:e}")]
    Stalled {
        /// The largest component of the last defects.
        residual: f64,
    },
}

/// A ring with the flow between its nodes.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The ring.
    pub ring: Ring,
    /// Directions at each node.
    pub frames: Vec<Frame>,
    /// The motion from each node to the next; empty if the derivative belongs to another ring.
    pub steps: Vec<Vec<TaylorStep>>,
    /// The largest component of a defect.
    pub residual: f64,
    /// The residual of the guess before it was corrected.
    pub missed: f64,
    /// The level of its nodes.
    pub level: Level,
    chain: Chain,
    defects: Vec<Parts>,
}

/// How the nodes of an orbit, and its period, change along its family.
#[derive(Clone, Debug)]
pub struct Slopes {
    /// Of each node.
    pub nodes: Vec<Phase>,
    /// Of the period.
    pub period: f64,
}

/// An approximate derivative for a guess: frames close to those of its nodes, and an extrapolated chain.
#[derive(Clone, Debug)]
pub struct Expected<'a> {
    /// Of a neighbour.
    pub frames: &'a [Frame],
    /// Of the guess.
    pub chain: Chain,
}

/// A defect that needs no further correction; the integrator rounds to a few 1e-16.
const CLOSED: f64 = 3e-15;
/// The largest defect of an orbit that counts as closed.
pub const RESIDUAL: f64 = 1e-13;
const CORRECTIONS: u32 = 20;
/// A correction that makes the period or the size of a guess different by this factor has left it.
const STRAYED: f64 = 4.0;
/// A guess with a larger defect is given up.
const LOST: f64 = 0.5;
/// Where a correction leaves more than this share of a defect, the derivative is computed anew.
const SLOW: f64 = 0.1;
/// The share of a defect that a correction with an extrapolated derivative is assumed to leave.
const NEIGHBOUR: f64 = 1e-2;

impl Ring {
    fn time(&self) -> f64 {
        self.period / self.nodes.len() as f64
    }

    /// The same ring, projected onto a level.
    fn onto(mut self, space: &Space, level: Level) -> Self {
        for node in &mut self.nodes {
            *node = space.onto(*node, level);
        }
        self
    }

    fn frames(&self, space: &Space, level: Level, like: Option<&[Frame]>) -> Result<Vec<Frame>, ShootingError> {
        let frame = |(k, node)| space.frame(node, level, like.map(|frames| &frames[k])).ok_or(ShootingError::Singular);
        self.nodes.iter().enumerate().map(frame).collect()
    }

    /// The defects in the frames, and the largest component of one.
    fn defects<'a>(&self, frames: &[Frame], ends: impl Iterator<Item = &'a Phase>) -> (Vec<Parts>, f64) {
        let mut residual = 0.0_f64;
        let next = |k: usize| (k + 1) % self.nodes.len();
        let defect = |(k, end): (usize, &Phase)| {
            let missed = end - self.nodes[next(k)];
            // (`max` would ignore NaN.)
            residual = if missed.amax() > residual || missed.amax().is_nan() { missed.amax() } else { residual };
            frames[next(k)].parts(&missed)
        };
        let defects = ends.enumerate().map(defect).collect();
        (defects, residual)
    }

    /// Follows the flow from node to node with its derivative, in frames close to those of a neighbour if these are
    /// given.
    ///
    /// # Errors
    /// [`ShootingError::Step`], and [`ShootingError::Singular`] at an equilibrium.
    pub fn shoot(self, space: &Space, level: Level, like: Option<&[Frame]>) -> Result<Shot, ShootingError> {
        let frames = self.frames(space, level, like)?;
        let passages = space.pass(&self.nodes, &frames, self.time())?;
        let link = |(k, passage): (usize, &Passage)| {
            let to = &frames[(k + 1) % frames.len()];
            let field = to.parts(&space.field(&passage.end));
            let [first, second, third] = passage.moved.each_ref().map(|moved| to.parts(moved));
            let tangent = SMatrix::from_columns(&[first, second, third, field / frames[k].speed]);
            Link { tangent, of_period: field * self.time() }
        };
        let chain = Chain::new(passages.iter().enumerate().map(link).collect());
        let (defects, residual) = self.defects(&frames, passages.iter().map(|passage| &passage.end));
        let steps = passages.into_iter().map(|passage| passage.steps).collect();
        Ok(Shot { ring: self, frames, steps, residual, missed: residual, level, chain, defects })
    }

    /// The same with a known approximate derivative.
    fn shoot_with(self, space: &Space, level: Level, frames: Vec<Frame>, chain: Chain) -> Result<Shot, ShootingError> {
        let ends = space.ends(&self.nodes, self.time())?;
        let (defects, residual) = self.defects(&frames, ends.iter());
        Ok(Shot { ring: self, frames, steps: Vec::new(), residual, missed: residual, level, chain, defects })
    }

    /// The largest distance of a node from the origin, at least 1 as |γ| is.
    fn size(&self) -> f64 {
        self.nodes.iter().map(Phase::norm).fold(1.0, f64::max)
    }

    /// Corrects the orbit until only rounding is left of its defects.
    ///
    /// # Errors
    /// [`ShootingError`].
    pub fn close(
        self,
        space: &Space,
        level: Level,
        keep: Keep,
        expected: Option<Expected<'_>>,
    ) -> Result<Shot, ShootingError> {
        let periods = self.period / STRAYED..self.period * STRAYED;
        let reach = STRAYED * self.size();
        let ring = self.onto(space, level);
        let mut shot = match expected {
            None => ring.shoot(space, level, None)?,
            Some(Expected { frames, chain }) => {
                let frames = ring.frames(space, level, Some(frames))?;
                ring.shoot_with(space, level, frames, chain)?
            }
        };
        let missed = shot.residual;
        // The last defect, and the share of the present one that a correction is expected to leave.
        let (mut before, mut share) = (f64::INFINITY, shot.leaves());
        let mut corrections = 0;
        // (The comparison is false for NaN.)
        while corrections < CORRECTIONS && shot.residual <= LOST {
            let off = shot.residual.max(shot.kept(space, &keep));
            // A guess is always corrected once: it may be far off in a direction in which its defect is small.
            let is_closed = corrections > 0 && (off <= CLOSED || off.max(before) <= RESIDUAL);
            if is_closed && shot.is_exact() {
                shot.missed = missed;
                return Ok(shot);
            }
            if !shot.is_exact() && (is_closed || off > SLOW * before) {
                shot = shot.ring.shoot(space, level, Some(&shot.frames))?;
                (before, share) = (off, shot.leaves());
                continue;
            }
            let ring = shot.corrected(space, &keep)?;
            // (The comparison is false for NaN.)
            if !(periods.contains(&ring.period) && ring.size() <= reach) {
                break;
            }
            let next = if shot.residual * share <= 0.3 * CLOSED {
                ring.shoot(space, level, Some(&shot.frames))?
            } else {
                ring.shoot_with(space, level, shot.frames.clone(), shot.chain.clone())?
            };
            corrections += 1;
            let is_worse = next.residual > shot.residual.max(CLOSED);
            let is_exact = shot.is_exact();
            // The extrapolated derivative was wrong, or only rounding was corrected: by a large move near a crossing of
            // families.
            if is_worse && (!is_exact || off <= RESIDUAL) {
                if !is_exact {
                    shot = shot.ring.shoot(space, level, Some(&shot.frames))?;
                    share = shot.leaves();
                }
                before = off;
                continue;
            }
            share = next.residual / shot.residual;
            before = off;
            shot = next;
        }
        Err(ShootingError::Stalled { residual: shot.residual })
    }
}

impl Shot {
    /// Whether the derivative belongs to this ring.
    fn is_exact(&self) -> bool {
        !self.steps.is_empty()
    }

    /// The share of its defect that a correction is expected to leave: the defect itself, with Newton's method.
    fn leaves(&self) -> f64 {
        if self.is_exact() { 10.0 * self.residual } else { NEIGHBOUR }
    }

    /// How far the quantity held fixed is from its value.
    fn kept(&self, space: &Space, keep: &Keep) -> f64 {
        match keep {
            Keep::Energy(h) => {
                let off = space.missed(&self.ring.nodes[0], Level::Energy(*h));
                off.abs() / (h.abs() + space.top.center_norm())
            }
            Keep::Place(_) => 0.0,
        }
    }

    /// One correction.
    fn corrected(&self, space: &Space, keep: &Keep) -> Result<Ring, ShootingError> {
        let (condition, value) = match keep {
            Keep::Energy(h) => {
                let missed = space.missed(&self.ring.nodes[0], Level::Energy(*h));
                (Move::new(0.0, 0.0, self.frames[0].rise, 0.0), missed)
            }
            Keep::Place(direction) => (self.first_move(direction), 0.0),
        };
        let carried = self.chain.carry(&self.defects);
        let step = self.chain.closing(&carried[self.ring.nodes.len()], (&condition, value));
        let step = step.ok_or(ShootingError::Singular)?;
        // A guess this far from any orbit is useless, and so is a step of singular equations made up of rounding.
        if step.amax() > LOST || step.iter().any(|x| x.is_nan()) {
            return Err(ShootingError::Singular);
        }
        let moved = self.moved(&step, 1.0, &carried);
        Ok(moved.onto(space, self.level))
    }

    /// The components of a direction at the first node, except the one along the orbit.
    fn first_move(&self, direction: &Direction) -> Move {
        let parts = self.frames[0].parts(&direction.fixed_rows::<6>(0).into_owned());
        Move::new(parts[0], parts[1], parts[2], direction[6])
    }

    /// The ring after a move, with a share of the defect carried to each node.
    fn moved(&self, step: &Move, share: f64, carried: &[Parts]) -> Ring {
        let nodes = self.ring.nodes.iter().zip(&self.frames).zip(self.chain.moved(*step)).zip(carried);
        let nodes = nodes.map(|(((node, frame), parts), defect)| node + frame.direction(&(parts + defect * share)));
        Ring { nodes: nodes.collect(), period: self.ring.period * (1.0 + step[3]) }
    }

    /// The direction of the family on the level, of length 1 and along `before`.
    #[must_use]
    pub fn direction(&self, before: &Direction) -> Option<Direction> {
        let step = self.chain.closing(&Parts::zeros(), (&self.first_move(before), 1.0))?;
        let node = self.frames[0].direction(&Parts::new(step[0], step[1], step[2], 0.0));
        let size = step.norm();
        size.is_finite().then(|| node.push(step[3]) / size)
    }

    /// The slopes in a direction.
    #[must_use]
    pub fn slopes(&self, direction: &Direction) -> Slopes {
        let moved = self.chain.moved(self.first_move(direction));
        let nodes = self.frames.iter().zip(moved).map(|(frame, parts)| frame.direction(&parts));
        Slopes { nodes: nodes.collect(), period: self.ring.period * direction[6] }
    }

    /// The guess at a distance along a direction.
    #[must_use]
    pub fn ahead(&self, direction: &Direction, distance: f64) -> Ring {
        let still = vec![Parts::zeros(); self.ring.nodes.len()];
        self.moved(&(self.first_move(direction) * distance), 0.0, &still)
    }

    /// The same orbit starting at another node, with the family's direction there.
    #[must_use]
    pub fn turned(mut self, by: usize, direction: &Direction) -> (Self, Direction) {
        let there = self.chain.moved(self.first_move(direction)).nth(by).unwrap_or_default();
        let node = self.frames[by].direction(&Parts::new(there[0], there[1], there[2], 0.0));
        self.ring.nodes.rotate_left(by);
        self.frames.rotate_left(by);
        self.steps.rotate_left(by);
        self.defects.rotate_left(by);
        self.chain = self.chain.turned(by);
        (self, node.push(direction[6]).normalize())
    }

    /// The derivatives from node to node.
    #[must_use]
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The derivative of the return, across the orbit.
    #[must_use]
    pub fn reduced(&self) -> Reduced {
        self.chain.reduced()
    }
}
