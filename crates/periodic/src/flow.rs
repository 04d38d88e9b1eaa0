//! The flow with its derivative as vectors and matrices, and what it leaves across an orbit.

use bifdiag_dynamics::field::{HeavyTop, State, cross};
use bifdiag_dynamics::integrator::{StepError, TaylorStep, transport};
use nalgebra::{SMatrix, SVector};

/// A point or a direction of phase space: γ, then l in a unit of momentum.
pub type Phase = SVector<f64, 6>;

/// The derivative of a map of phase space.
pub type Tangent = SMatrix<f64, 6, 6>;

/// Phase space with a unit of momentum, in which γ and l are of one size: lengths and right angles are meant in it.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    /// The top, in its own units.
    pub top: HeavyTop,
    /// The unit of l.
    pub unit: f64,
}

/// Where the flow takes a point in a time.
#[derive(Clone, Debug)]
pub struct Passage {
    /// The point there.
    pub end: Phase,
    /// The derivative with respect to the point where it began.
    pub tangent: Tangent,
    /// The motion between.
    pub steps: Vec<TaylorStep>,
}

impl Space {
    /// With √(2A_max(|h| + |r|)) as unit of l: no |l| is larger at this energy.
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

    /// The flow over a time ≥ 0, with its derivative.
    ///
    /// # Errors
    /// [`StepError`] where the motion leaves the range of `f64`.
    pub fn pass(&self, x: &Phase, time: f64) -> Result<Passage, StepError> {
        let found = transport(&self.top, &self.state(x), time)?;
        let size = |k: usize| if k < 3 { 1.0 } else { self.unit };
        let tangent = Tangent::from_fn(|i, j| found.tangent[j][i] * size(j) / size(i));
        Ok(Passage { end: self.point(&found.end), tangent, steps: found.steps })
    }

    /// What lies across the orbit at a point: see [`Frame`].
    #[must_use]
    pub fn frame(&self, x: &Phase) -> Option<Frame> {
        let field = self.field(x);
        let mut known: Vec<Phase> = Vec::with_capacity(6);
        for vector in self.gradients(x).into_iter().chain([field]) {
            known.push(without(vector, &known)?);
        }
        let speed = field.norm();
        let along = known.pop()?;
        known.push(along);
        let mut across = [Phase::zeros(); 2];
        for vector in &mut across {
            // The coordinate direction of which most is left.
            let left = |j: usize| 1.0 - known.iter().map(|u| u[j] * u[j]).sum::<f64>();
            let j = (0..6).max_by(|&i, &j| left(i).total_cmp(&left(j)))?;
            let mut direction = Phase::zeros();
            direction[j] = 1.0;
            *vector = without(direction, &known)?;
            known.push(*vector);
        }
        Some(Frame { along, across, speed })
    }
}

/// Right-angled directions at a point of an orbit: along it, and the two that neither it nor the gradients of the integrals
/// have a part in. The derivative of the return to the point, seen in the latter two, has the orbit's nontrivial multipliers.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Along the flow.
    pub along: Phase,
    /// Across it, on the surface of fixed h and l.
    pub across: [Phase; 2],
    /// |(γ̇, l̇)|.
    pub speed: f64,
}

/// The unit vector of what is left of a vector without its parts along orthonormal ones, taken away twice so that rounding
/// leaves none; `None` where nothing is left.
fn without(vector: Phase, known: &[Phase]) -> Option<Phase> {
    let mut left = vector;
    for _ in 0..2 {
        for unit in known {
            left -= unit * unit.dot(&left);
        }
    }
    let size = left.norm();
    (size > 1e-14 * vector.norm()).then(|| left / size)
}
