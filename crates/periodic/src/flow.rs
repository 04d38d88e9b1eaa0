//! The flow and its derivative as vectors and matrices, and the frames in which they act across an orbit.

use bifdiag_dynamics::field::{HeavyTop, State, cross};
use bifdiag_dynamics::integrator::{StepError, TaylorStep, transport};
use nalgebra::{SMatrix, SVector};

/// A point or a direction of phase space: γ, then l in a unit of momentum.
pub type Phase = SVector<f64, 6>;

/// The derivative of a map of phase space.
pub type Tangent = SMatrix<f64, 6, 6>;

/// Phase space with a unit of momentum that makes γ and l comparable: lengths and angles refer to it.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    /// The top, in its own units.
    pub top: HeavyTop,
    /// The unit of l.
    pub unit: f64,
}

/// The integral that all points of an orbit, and all orbits of a family, have in common, besides |γ| = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    /// ⟨γ,l⟩ in units of the space.
    Momentum(f64),
    /// H.
    Energy(f64),
}

/// Where the flow takes a node in a given time.
#[derive(Clone, Debug)]
pub struct Passage {
    /// The end point.
    pub end: Phase,
    /// The derivative in the first three directions of the node's frame.
    pub moved: [Phase; 3],
    /// The motion between.
    pub steps: Vec<TaylorStep>,
}

impl Space {
    /// With the unit √(2A_max(|h| + |r|)) of l, which no |l| at this energy exceeds.
    #[must_use]
    pub fn new(top: &HeavyTop, h: f64) -> Self {
        let top = top.reduced();
        Self { top, unit: top.momentum_scale(h.abs().max(top.center_norm())) }
    }

    /// A state as a point.
    #[must_use]
    pub fn point(&self, state: &State) -> Phase {
        let (g, l) = (state.gamma, state.l.map(|x| x / self.unit));
        Phase::new(g[0], g[1], g[2], l[0], l[1], l[2])
    }

    /// A point as a state.
    #[must_use]
    pub fn state(&self, x: &Phase) -> State {
        State { gamma: [x[0], x[1], x[2]], l: [x[3], x[4], x[5]].map(|l| l * self.unit) }
    }

    /// The vector field.
    #[must_use]
    pub fn field(&self, x: &Phase) -> Phase {
        self.point(&self.top.vector_field(&self.state(x)))
    }

    /// The gradients of ⟨γ,γ⟩/2, ⟨γ,l⟩ and H.
    #[must_use]
    pub fn gradients(&self, x: &Phase) -> [Phase; 3] {
        let State { gamma, l } = self.state(x);
        let covector = |of_gamma: [f64; 3], of_l: [f64; 3]| {
            let of_l = of_l.map(|x| x * self.unit);
            Phase::new(of_gamma[0], of_gamma[1], of_gamma[2], of_l[0], of_l[1], of_l[2])
        };
        let down = self.top.center().map(|r| -r);
        [covector(gamma, [0.0; 3]), covector(l, gamma), covector(down, self.top.inverse_inertia(l))]
    }

    /// The derivative of the vector field.
    #[must_use]
    pub fn linearised(&self, x: &Phase) -> Tangent {
        let State { gamma, l } = self.state(x);
        let omega = self.top.inverse_inertia(l);
        Tangent::from_columns(&std::array::from_fn::<_, 6, _>(|j| {
            let mut direction = Phase::zeros();
            direction[j] = 1.0;
            let State { gamma: dg, l: dl } = self.state(&direction);
            let turned = self.top.inverse_inertia(dl);
            let sum = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| a[i] + b[i]);
            let fall = cross(dg, self.top.center()).map(|x| -x);
            let of_gamma = sum(cross(dg, omega), cross(gamma, turned));
            self.point(&State { gamma: of_gamma, l: sum(sum(cross(dl, omega), cross(l, turned)), fall) })
        }))
    }

    /// Where the flow takes points in a given time ≥ 0.
    ///
    /// # Errors
    /// [`StepError`] where a motion leaves the range of `f64`.
    pub fn ends(&self, points: &[Phase], time: f64) -> Result<Vec<Phase>, StepError> {
        let starts: Vec<_> = points.iter().map(|x| (self.state(x), [])).collect();
        Ok(transport(&self.top, &starts, time)?.iter().map(|found| self.point(&found.end)).collect())
    }

    /// The same, with the derivatives in the directions of the points' frames.
    ///
    /// # Errors
    /// [`StepError`] where a motion leaves the range of `f64`.
    pub fn pass(&self, points: &[Phase], frames: &[Frame], time: f64) -> Result<Vec<Passage>, StepError> {
        let directions = |frame: &Frame| [frame.across[0], frame.across[1], frame.beyond].map(|unit| self.state(&unit));
        let starts: Vec<_> = points.iter().zip(frames).map(|(x, frame)| (self.state(x), directions(frame))).collect();
        let passages = transport(&self.top, &starts, time)?.into_iter().map(|found| Passage {
            end: self.point(&found.end),
            moved: found.directions.map(|moved| self.point(&moved)),
            steps: found.steps,
        });
        Ok(passages.collect())
    }

    /// The gradients of ⟨γ,γ⟩/2, of the integral that the level fixes and of the other one, ⟨γ,l⟩ being in units of the
    /// space.
    fn gradients_at(&self, x: &Phase, level: Level) -> [Phase; 3] {
        let [sphere, momentum, energy] = self.gradients(x);
        let momentum = momentum / self.unit;
        match level {
            Level::Momentum(_) => [sphere, momentum, energy],
            Level::Energy(_) => [sphere, energy, momentum],
        }
    }

    /// How far a point is below a level.
    #[must_use]
    pub fn missed(&self, x: &Phase, level: Level) -> f64 {
        match level {
            Level::Momentum(l) => l - x.fixed_rows::<3>(0).dot(&x.fixed_rows::<3>(3)),
            Level::Energy(h) => h - self.top.energy(&self.state(x)),
        }
    }

    /// Projects a point onto |γ| = 1 and the level, by Newton's method.
    #[must_use]
    pub fn onto(&self, mut x: Phase, level: Level) -> Phase {
        const STEPS: usize = 6;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let [sphere, kept, _] = self.gradients_at(&x, level);
            let missed = [0.5 * (1.0 - sphere.norm_squared()), self.missed(&x, level)];
            let size = missed[0].abs() + missed[1].abs();
            let [a, b, c] = [sphere.norm_squared(), sphere.dot(&kept), kept.norm_squared()];
            let determinant = a * c - b * b;
            // At rest the gradients are parallel; at convergence only rounding is left.
            if size == 0.0 || size >= 0.5 * last || determinant <= 1e-14 * a * c {
                break;
            }
            last = size;
            let [p, q] = [c * missed[0] - b * missed[1], a * missed[1] - b * missed[0]];
            x += (sphere * p + kept * q) / determinant;
        }
        x
    }

    /// The [`Frame`] at a point; if another frame is given, its directions across are as close to that one's as
    /// possible. `None` where there is no such frame, or none close to the other.
    #[must_use]
    pub fn frame(&self, x: &Phase, level: Level, like: Option<&Frame>) -> Option<Frame> {
        let field = self.field(x);
        let [sphere, kept, free] = self.gradients_at(x, level);
        let mut known = [Phase::zeros(); 6];
        for (k, vector) in [sphere, kept, free, field].into_iter().enumerate() {
            known[k] = without(vector, &known[..k])?;
        }
        for k in 4..6 {
            let vector = if let Some(like) = like {
                like.across[k - 4]
            } else {
                // The coordinate direction farthest from those already taken.
                let left = |j: usize| 1.0 - known[..k].iter().map(|u| u[j] * u[j]).sum::<f64>();
                Phase::ith((0..6).max_by(|&i, &j| left(i).total_cmp(&left(j)))?, 1.0)
            };
            known[k] = without(vector, &known[..k])?;
            if like.is_some() && known[k].dot(&vector) < ALIKE {
                return None;
            }
        }
        let [_, _, beyond, along, first, second] = known;
        Some(Frame { across: [first, second], beyond, along, speed: field.norm(), rise: beyond.dot(&free) })
    }
}

/// The cosine of the angle by which the directions of neighbouring frames may differ.
const ALIKE: f64 = 0.5;

/// Orthonormal directions at a point of an orbit: two across it, orthogonal to the flow and to the gradients of the
/// integrals; one beyond, out of the surface of fixed h and l but within the level; and one along the flow. The
/// derivative of the return to the point, restricted to the first two, has the orbit's nontrivial multipliers.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Across the flow, on the surface of fixed h and l.
    pub across: [Phase; 2],
    /// Within the level, out of this surface.
    pub beyond: Phase,
    /// Along the flow.
    pub along: Phase,
    /// |(γ̇, l̇)|.
    pub speed: f64,
    /// The derivative in that direction of the integral that the level does not fix.
    pub rise: f64,
}

/// The components of a direction in a frame: two across, then beyond and along.
pub type Parts = SVector<f64, 4>;

impl Frame {
    /// The components of a direction.
    #[must_use]
    pub fn parts(&self, vector: &Phase) -> Parts {
        let [first, second] = self.across;
        Parts::new(first.dot(vector), second.dot(vector), self.beyond.dot(vector), self.along.dot(vector))
    }

    /// The direction with these components.
    #[must_use]
    pub fn direction(&self, parts: &Parts) -> Phase {
        self.across[0] * parts[0] + self.across[1] * parts[1] + self.beyond * parts[2] + self.along * parts[3]
    }
}

/// A vector made orthogonal to orthonormal ones and scaled to length 1, projected twice where rounding would leave a
/// component; `None` where nothing is left.
fn without(vector: Phase, known: &[Phase]) -> Option<Phase> {
    let whole = vector.norm();
    let (mut left, mut size) = (vector, whole);
    for _ in 0..2 {
        let before = size;
        for unit in known {
            left -= unit * unit.dot(&left);
        }
        size = left.norm();
        if size > 0.7 * before {
            break;
        }
    }
    (size > 1e-14 * whole).then(|| left / size)
}
