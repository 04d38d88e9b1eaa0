//! Newton's method for closed orbits, by multiple shooting.
//!
//! An orbit is a ring of nodes, equal times apart; its **defects** are the differences between where the flow takes a node
//! and the next node. Between two nodes the flow stretches by a bounded factor, so that defects can be small for unstable
//! orbits too. Since the flow keeps γ², ⟨γ,l⟩ and H, three of the six equations of closing say nothing: those that count are
//! the parts of the last defect along and across the orbit; the others are replaced by what is to be kept.

use bifdiag_dynamics::integrator::StepError;
use nalgebra::{SMatrix, SVector};
use thiserror::Error;

use crate::flow::{Frame, Passage, Phase, Space, Tangent};

/// A direction in the space of orbits: of the first node, and of the period as a part of the period.
pub type Direction = SVector<f64, 7>;

/// A closed orbit, or a guess of one.
#[derive(Clone, Debug)]
pub struct Ring {
    /// Points of the orbit, equal times apart.
    pub nodes: Vec<Phase>,
    /// Its period.
    pub period: f64,
}

/// What remains fixed while an orbit is corrected, beside |γ| = 1 and its phase; two of these determine it.
#[derive(Clone, Copy, Debug)]
pub enum Keep {
    /// ⟨γ,l⟩ in units of the space.
    Momentum(f64),
    /// H.
    Energy(f64),
    /// The place of the guess along this direction.
    Place(Direction),
}

/// Why an orbit was not closed.
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
        /// The smallest defect.
        residual: f64,
    },
}

/// A ring whose flow was followed.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The ring.
    pub ring: Ring,
    /// From each node to the next.
    pub passages: Vec<Passage>,
    /// Directions at each node.
    pub frames: Vec<Frame>,
    /// The largest part of a defect.
    pub residual: f64,
    /// Corrections that were made.
    pub corrections: u32,
}

/// How the nodes of an orbit, and its period, change along its family.
#[derive(Clone, Debug)]
pub struct Slopes {
    /// Of each node.
    pub nodes: Vec<Phase>,
    /// Of the period.
    pub period: f64,
}

/// A defect that no correction has to better; the integrator rounds to a few 1e-16.
const CLOSED: f64 = 1e-14;
/// The largest defect of an orbit that counts as closed.
pub const RESIDUAL: f64 = 1e-13;
const CORRECTIONS: u32 = 12;
/// A guess whose defect is larger than this is none.
const LOST: f64 = 0.5;

impl Ring {
    /// Follows the flow from node to node.
    ///
    /// # Errors
    /// [`ShootingError::Step`], and [`ShootingError::Singular`] at an equilibrium.
    pub fn shoot(self, space: &Space) -> Result<Shot, ShootingError> {
        let count = self.nodes.len();
        let time = self.period / count as f64;
        let mut passages = Vec::with_capacity(count);
        let mut frames = Vec::with_capacity(count);
        let mut residual = 0.0_f64;
        for (i, node) in self.nodes.iter().enumerate() {
            let passage = space.pass(node, time)?;
            residual = residual.max((passage.end - self.nodes[(i + 1) % count]).amax());
            passages.push(passage);
            frames.push(space.frame(node).ok_or(ShootingError::Singular)?);
        }
        Ok(Shot { ring: self, passages, frames, residual, corrections: 0 })
    }

    /// Corrects the orbit until its defects are those of rounding.
    ///
    /// # Errors
    /// [`ShootingError`].
    pub fn close(self, space: &Space, keep: [Keep; 2]) -> Result<Shot, ShootingError> {
        let mut best = self.shoot(space)?;
        for corrections in 1..=CORRECTIONS {
            if best.residual > LOST || !best.residual.is_finite() {
                break;
            }
            let (is_small, kept) = (best.residual <= RESIDUAL, best.kept(space, &keep));
            // A guess is corrected once in any case: its defect may be small in a direction in which it is far off.
            if corrections > 1 && best.residual <= CLOSED && kept <= CLOSED {
                return Ok(best);
            }
            let mut next = best.corrected(space, &keep)?.shoot(space)?;
            next.corrections = corrections;
            // Rounding is reached where a correction betters nothing.
            if is_small && kept <= RESIDUAL && next.residual >= 0.5 * best.residual {
                return Ok(if next.residual <= best.residual.max(CLOSED) { next } else { best });
            }
            best = next;
        }
        Err(ShootingError::Stalled { residual: best.residual })
    }
}

/// The defects of a ring, carried to its end: the last node comes to A δ + b δT/T + c beside the first, δ being the first
/// one's move.
struct Carried {
    tangent: Tangent,
    of_period: Phase,
    defect: Phase,
}

impl Shot {
    fn carried(&self, space: &Space) -> Vec<Carried> {
        let count = self.ring.nodes.len();
        let mut all = Vec::with_capacity(count + 1);
        all.push(Carried { tangent: Tangent::identity(), of_period: Phase::zeros(), defect: Phase::zeros() });
        for (i, passage) in self.passages.iter().enumerate() {
            let last = &all[i];
            let moved = space.field(&passage.end) * (self.ring.period / count as f64);
            all.push(Carried {
                tangent: passage.tangent * last.tangent,
                of_period: passage.tangent * last.of_period + moved,
                defect: passage.tangent * last.defect + passage.end - self.ring.nodes[(i + 1) % count],
            });
        }
        all
    }

    /// The five equations that every closed orbit satisfies, and the two that are kept.
    fn equations(&self, space: &Space, last: &Carried, keep: &[Keep; 2]) -> (SMatrix<f64, 7, 7>, Direction) {
        let first = &self.ring.nodes[0];
        let frame = &self.frames[0];
        let closing = last.tangent - Tangent::identity();
        let mut matrix = SMatrix::<f64, 7, 7>::zeros();
        let mut right = Direction::zeros();
        let mut row = 0;
        let mut set = |of_node: Phase, of_period: f64, value: f64| {
            for j in 0..6 {
                matrix[(row, j)] = of_node[j];
            }
            matrix[(row, 6)] = of_period;
            right[row] = value;
            row += 1;
        };
        for unit in frame.across.iter().chain([&frame.along]) {
            set(closing.transpose() * unit, unit.dot(&last.of_period), -unit.dot(&last.defect));
        }
        set(frame.along, 0.0, 0.0);
        let [sphere, momentum, energy] = space.gradients(first);
        set(sphere, 0.0, 0.5 * (1.0 - sphere.norm_squared()));
        for condition in keep {
            match condition {
                Keep::Momentum(l) => set(momentum / space.unit, 0.0, l - self.momentum()),
                Keep::Energy(h) => set(energy, 0.0, h - space.top.energy(&space.state(first))),
                Keep::Place(direction) => {
                    set(direction.fixed_rows::<6>(0).into_owned(), direction[6], 0.0);
                }
            }
        }
        (matrix, right)
    }

    /// ⟨γ,l⟩ at the first node.
    fn momentum(&self) -> f64 {
        let x = &self.ring.nodes[0];
        x[0] * x[3] + x[1] * x[4] + x[2] * x[5]
    }

    /// How far |γ| and what is kept are from their values.
    fn kept(&self, space: &Space, keep: &[Keep; 2]) -> f64 {
        let first = &self.ring.nodes[0];
        let sphere = (first.fixed_rows::<3>(0).norm_squared() - 1.0).abs();
        keep.iter().fold(sphere, |most: f64, condition| {
            most.max(match condition {
                Keep::Momentum(l) => (l - self.momentum()).abs(),
                Keep::Energy(h) => {
                    (h - space.top.energy(&space.state(first))).abs() / (h.abs() + space.top.center_norm())
                }
                Keep::Place(_) => 0.0,
            })
        })
    }

    /// One step of Newton's method.
    fn corrected(&self, space: &Space, keep: &[Keep; 2]) -> Result<Ring, ShootingError> {
        let carried = self.carried(space);
        let (matrix, right) = self.equations(space, &carried[self.passages.len()], keep);
        let step = matrix.lu().solve(&right).ok_or(ShootingError::Singular)?;
        // A guess that is so far from any orbit is none; nor is a step of singular equations that rounding left.
        if step.amax() > LOST || step.iter().any(|x| x.is_nan()) {
            return Err(ShootingError::Singular);
        }
        Ok(self.moved(&carried, &step, 1.0))
    }

    /// The ring that has moved in a direction; `defects` is the share of the defects that is taken away.
    fn moved(&self, carried: &[Carried], step: &Direction, defects: f64) -> Ring {
        let first = step.fixed_rows::<6>(0).into_owned();
        let nodes = self.ring.nodes.iter().zip(carried);
        let nodes = nodes.map(|(node, c)| node + c.tangent * first + c.of_period * step[6] + c.defect * defects);
        Ring { nodes: nodes.collect(), period: self.ring.period * (1.0 + step[6]) }
    }

    /// The direction of the family that keeps what is given, along `before`; of length 1.
    #[must_use]
    pub fn direction(&self, space: &Space, keep: Keep, before: &Direction) -> Option<Direction> {
        let carried = self.carried(space);
        let (matrix, _) = self.equations(space, &carried[self.passages.len()], &[keep, Keep::Place(*before)]);
        let mut right = Direction::zeros();
        right[6] = 1.0;
        let direction = matrix.lu().solve(&right)?;
        let size = direction.norm();
        size.is_finite().then(|| direction / size)
    }

    /// The slopes in a direction.
    #[must_use]
    pub fn slopes(&self, space: &Space, direction: &Direction) -> Slopes {
        let first = direction.fixed_rows::<6>(0).into_owned();
        let carried = self.carried(space);
        let nodes = carried.iter().take(self.ring.nodes.len());
        let nodes = nodes.map(|c| c.tangent * first + c.of_period * direction[6]);
        Slopes { nodes: nodes.collect(), period: self.ring.period * direction[6] }
    }

    /// The guess at a distance along a direction.
    #[must_use]
    pub fn ahead(&self, space: &Space, direction: &Direction, distance: f64) -> Ring {
        self.moved(&self.carried(space), &(direction * distance), 0.0)
    }

    /// The same orbit from another node on, with the direction that it has there.
    #[must_use]
    pub fn turned(mut self, space: &Space, by: usize, direction: &Direction) -> (Self, Direction) {
        let carried = &self.carried(space)[by];
        let first = direction.fixed_rows::<6>(0).into_owned();
        let mut moved = carried.tangent * first + carried.of_period * direction[6];
        let along = self.frames[by].along;
        moved -= along * along.dot(&moved);
        let direction = moved.push(direction[6]).normalize();
        self.ring.nodes.rotate_left(by);
        self.passages.rotate_left(by);
        self.frames.rotate_left(by);
        (self, direction)
    }

    /// The largest factor by which the flow stretches from one node to the next.
    #[must_use]
    pub fn stretch(&self) -> f64 {
        self.passages.iter().map(|passage| passage.tangent.norm()).fold(0.0, f64::max)
    }

    /// The reduced derivative of the return to the first node: the trace of the product, and the product of the determinants
    /// from node to node, which is 1 but for rounding.
    #[must_use]
    pub fn reduced(&self) -> Reduced {
        let count = self.frames.len();
        let mut product = SMatrix::<f64, 2, 2>::identity();
        let mut determinant = 1.0;
        for (i, passage) in self.passages.iter().enumerate() {
            let (from, to) = (&self.frames[i], &self.frames[(i + 1) % count]);
            let part = SMatrix::<f64, 2, 2>::from_fn(|a, b| to.across[a].dot(&(passage.tangent * from.across[b])));
            product = part * product;
            determinant *= part.determinant();
        }
        Reduced { matrix: product, determinant }
    }
}

/// The derivative of the return of an orbit, across it.
#[derive(Clone, Copy, Debug)]
pub struct Reduced {
    /// In the directions across at the first node.
    pub matrix: SMatrix<f64, 2, 2>,
    /// Its determinant, without the cancellation of large entries.
    pub determinant: f64,
}

impl Reduced {
    /// Its trace: 2 at folds, −2 at doublings.
    #[must_use]
    pub fn trace(&self) -> f64 {
        self.matrix.trace()
    }

    /// The multipliers, [re, im]: on the unit circle, or the larger first.
    #[must_use]
    pub fn multipliers(&self) -> [[f64; 2]; 2] {
        let (half, product) = (0.5 * self.trace(), self.determinant);
        let discriminant = half * half - product;
        if discriminant < 0.0 {
            let im = (-discriminant).sqrt();
            return [[half, im], [half, -im]];
        }
        let larger = half + discriminant.sqrt().copysign(half);
        if larger == 0.0 { [[0.0; 2]; 2] } else { [[larger, 0.0], [product / larger, 0.0]] }
    }
}
