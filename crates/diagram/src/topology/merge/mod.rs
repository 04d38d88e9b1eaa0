//! First method: the merge tree of the critical points (Proposition 9.2 of docs/mathematics.md).

mod descent;
mod partition;
mod slide;

use thiserror::Error;

pub use partition::Partition;

use super::component::{Component, Poles};
use super::potential::{Potential, Vector};
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::table;
use descent::{Floor, descend, is_nearly_critical, kick, sides_of_saddle};
use slide::sides_of_ridge;

/// What a critical point contributes to the sublevel set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// One point.
    Point,
    /// A circle of critical points around an axis, in the plane of this axis of the frame and the next; `index` counts
    /// its one normal direction.
    Circle(Axis),
    /// All of S².
    Sphere,
}

/// A critical point of U_l below the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalPoint {
    /// γ in the frame.
    pub gamma: Vector,
    /// Morse index.
    pub index: u8,
    /// Point, circle or sphere.
    pub extent: Extent,
}

/// Why the components are not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MergeError {
    /// Rounding hides on which side of a saddle U falls.
    #[error("a saddle is too flat for f64 to tell its two sides")]
    FlatSaddle,
    /// No downhill path could be proved.
    #[error("no downhill path from a point to a minimum could be proved in f64")]
    LostPath,
    /// The critical values are closer than rounding, or their order contradicts the one proved elsewhere.
    #[error("the critical values here are closer than f64 resolves")]
    UnknownOrder,
    /// The indices found do not describe a surface.
    #[error("the critical points below the level do not describe a surface: a component would have χ = {euler}")]
    Euler {
        /// The impossible Euler characteristic.
        euler: i32,
    },
}

/// Components of {U ≤ h} from the critical points below h, and the means to find the one in which a point lies.
///
/// Components are classes of minima joined by saddles; a component with m minima, σ saddles and x maxima has
/// χ = m − σ + x = 2 − k. With one minimum nothing has to be followed.
///
/// - `below`: all critical points with value below h, at x = l²/2.
/// - `poles`: which of ±r̂ have U ≤ h; `None` when r = 0.
///
/// # Errors
/// [`MergeError`] when rounding leaves a join open.
pub fn partition<'a>(
    frame: &'a Frame,
    x: f64,
    below: &[CriticalPoint],
    poles: Option<Poles>,
) -> Result<Partition<'a>, MergeError> {
    let potential = Potential { frame, x };
    let is_floor = |p: &CriticalPoint| p.index == 0;
    let floors: Vec<&CriticalPoint> = below.iter().filter(|p| is_floor(p)).collect();
    let minima: Vec<Floor> = floors
        .iter()
        .map(|p| Floor { gamma: p.gamma, circle: if let Extent::Circle(axis) = p.extent { Some(axis) } else { None } })
        .collect();
    let mut tree = Tree { potential, joined: table::Partition::new(minima.len()), minima };
    let higher: Vec<&CriticalPoint> = below.iter().filter(|p| !is_floor(p)).collect();
    let homes = higher.iter().map(|point| tree.join(point)).collect::<Result<Vec<usize>, MergeError>>()?;
    let inside = tree.poles(poles.unwrap_or_default())?;
    let mut euler = vec![0_i32; floors.len()];
    for (m, point) in floors.into_iter().enumerate().chain(homes.into_iter().zip(higher)) {
        euler[tree.joined.find(m)] += contribution(point);
    }
    let mut found = Vec::new();
    for (m, &euler) in euler.iter().enumerate() {
        if tree.joined.find(m) == m {
            let boundary_circles = u32::try_from(2 - euler).map_err(|_| MergeError::Euler { euler })?;
            found.push((m, Component { boundary_circles, poles: poles.map(|_| inside[m]) }));
        }
    }
    Ok(Partition::new(tree, found))
}

/// Contribution to the Euler characteristic.
fn contribution(point: &CriticalPoint) -> i32 {
    match point.extent {
        Extent::Point if point.index == 1 => -1,
        Extent::Point => 1,
        Extent::Circle(_) => 0,
        Extent::Sphere => 2,
    }
}

struct Tree<'a> {
    potential: Potential<'a>,
    minima: Vec<Floor>,
    /// The minima that are joined so far.
    joined: table::Partition,
}

impl Tree<'_> {
    /// The minimum below a critical point that is not itself a minimum; a saddle joins the minima on its two sides.
    fn join(&mut self, point: &CriticalPoint) -> Result<usize, MergeError> {
        if self.minima.len() == 1 {
            return Ok(0);
        }
        if point.index != 1 || self.joined.count() <= 1 {
            return self.home(point.gamma);
        }
        let [p, q] = sides_of_saddle(&self.potential, point.gamma)
            .or_else(|| sides_of_ridge(&self.potential, point.gamma))
            .ok_or(MergeError::FlatSaddle)?;
        let (p, q) = (self.descend(p)?, self.descend(q)?);
        self.joined.unite(p, q);
        Ok(p)
    }

    /// Which of these poles lie over each root, once all joins are made.
    fn poles(&mut self, poles: Poles) -> Result<Vec<Poles>, MergeError> {
        let mut inside = vec![Poles::default(); self.minima.len()];
        for (present, sign) in [(poles.plus, 1.0), (poles.minus, -1.0)] {
            if present {
                let home = self.home(self.potential.frame.r_hat().map(|c| sign * c))?;
                let root = self.joined.find(home);
                inside[root].plus |= sign > 0.0;
                inside[root].minus |= sign < 0.0;
            }
        }
        Ok(inside)
    }

    /// The minimum below a point; any one when all minima are joined already.
    fn home(&self, gamma: Vector) -> Result<usize, MergeError> {
        if self.joined.count() == 1 {
            return Ok(0);
        }
        let start = off_critical(&self.potential, gamma).ok_or(MergeError::LostPath)?;
        self.descend(start)
    }

    fn descend(&self, gamma: Vector) -> Result<usize, MergeError> {
        descend(&self.potential, gamma, &self.minima).ok_or(MergeError::LostPath)
    }
}

/// A point from which a descent can start: γ, or one below it where γ is all but critical.
fn off_critical(potential: &Potential, gamma: Vector) -> Option<Vector> {
    if is_nearly_critical(potential, gamma) { kick(potential, gamma) } else { Some(gamma) }
}
