//! The two states over a point of the Poisson sphere, and the points from which the curves of a portrait are traced.

use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use super::chart::{Axes, SectionChart};
use super::equations::{SectionEquations, Zero};
use super::linear::PhaseVector;
use crate::field::{State, add, dot, scale};
use crate::section::condition::SectionCondition;
use crate::section::error::{SectionError, check_stop};
use crate::section::torus::{PpTorus, TorusPoint};

/// Bisections of an edge.
const HALVINGS: usize = 50;

/// The places of one portrait, in the units of its top.
#[derive(Clone, Copy)]
pub(super) struct Field<'a> {
    pub torus: &'a PpTorus,
    pub equations: &'a SectionEquations,
}

impl Field<'_> {
    fn condition(&self) -> SectionCondition {
        self.equations.condition
    }

    /// The states over a point (ψ', ϑ').
    pub fn states(&self, place: [f64; 2]) -> Option<[State; 2]> {
        states(self.torus, self.condition(), (self.equations.h, self.equations.l), place)
    }

    /// Ṡ < 0 on each sheet.
    fn incoming(&self, place: [f64; 2]) -> Option<[bool; 2]> {
        self.states(place).map(|states| states.map(|state| self.equations.rate(&state) < 0.0))
    }

    /// What a grid of places shows: points of the boundary of the projection between places with states and places
    /// without, and points of tangency between places where Ṡ has different signs.
    pub fn on_grid(
        &self,
        chart: SectionChart,
        rows: usize,
        stop: Option<&AtomicBool>,
    ) -> Result<GridSeeds, SectionError> {
        let axes = Axes::new(chart, self.torus);
        let torus = Axes::new(SectionChart::Torus, self.torus);
        let columns = 2 * rows;
        let place = |row: usize, column: usize| {
            [(column as f64 + 0.25) * TAU / columns as f64, (row as f64 + 0.5) * PI / rows as f64]
        };
        let look = |place: [f64; 2]| self.incoming(torus.angles(axes.gamma(place)));
        let mut nodes: Vec<Vec<Option<[bool; 2]>>> = Vec::with_capacity(rows);
        for row in 0..rows {
            check_stop(stop)?;
            nodes.push((0..=columns).map(|column| look(place(row, column))).collect());
        }
        let mut seeds = GridSeeds { boundary: Vec::new(), tangency: Vec::new() };
        for row in 0..rows {
            check_stop(stop)?;
            for column in 0..columns {
                for (to_row, to_column) in [(row, column + 1), (row + 1, column)] {
                    let Some(to) = nodes.get(to_row).map(|row| row[to_column]) else {
                        continue;
                    };
                    let from = nodes[row][column];
                    let (p, q) = (place(row, column), place(to_row, to_column));
                    let at = |t: f64| {
                        let place = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
                        torus.angles(axes.gamma(place))
                    };
                    self.look_along(at, [from, to], &mut seeds);
                }
            }
        }
        Ok(seeds)
    }

    /// Looks for points on an edge of the grid.
    fn look_along(&self, at: impl Fn(f64) -> [f64; 2], ends: [Option<[bool; 2]>; 2], seeds: &mut GridSeeds) {
        let [from, to] = ends;
        if from.is_none() && to.is_none() {
            return;
        }
        // The accessible part of the edge, from a place where Ṡ is known.
        let (known, other, span) = if let (Some(known), Some(other)) = (from, to) {
            (known, other, [0.0, 1.0])
        } else {
            let change = bisect(|t| self.states(at(t)).is_some() == to.is_some());
            let (inside, near) = if from.is_some() { (0.0, change - 1e-12) } else { (1.0, change + 1e-12) };
            let Some(states) = self.states(at(near)) else { return };
            if let Some(x) = self.equations.polish(Zero::Sheets, &self.equations.vector(&states[0])) {
                seeds.boundary.push(x);
            }
            let Some(known) = from.or(to) else { return };
            (known, states.map(|state| self.equations.rate(&state) < 0.0), [inside, near])
        };
        for sheet in 0..2 {
            if known[sheet] == other[sheet] {
                continue;
            }
            let part = |t: f64| at(span[0] + t * (span[1] - span[0]));
            let change = bisect(|t| self.incoming(part(t)).is_none_or(|incoming| incoming[sheet] != known[sheet]));
            if let Some(states) = self.states(part(change)) {
                let guess = self.equations.vector(&states[sheet]);
                seeds.tangency.extend(self.equations.polish(Zero::Tangency, &guess));
            }
        }
    }
}

/// What a grid shows.
pub(super) struct GridSeeds {
    pub boundary: Vec<PhaseVector>,
    pub tangency: Vec<PhaseVector>,
}

/// Where in [0, 1] a condition changes that fails at 0 and holds at 1.
pub(super) fn bisect(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if holds(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// The states with Δ < 0 and Δ > 0 over γ(ϑ', ψ'); `None` if there are none.
fn states(
    torus: &PpTorus,
    condition: SectionCondition,
    (h, l): (f64, f64),
    [psi, theta]: [f64; 2],
) -> Option<[State; 2]> {
    match condition {
        SectionCondition::Height => {
            let state = |sheet| torus.state(TorusPoint { theta, psi, sheet }, h, l).ok();
            Some([state(-1)?, state(1)?])
        }
        SectionCondition::AngularMomentum => {
            // S = ⟨l, γ×r⟩ = 0 and ⟨γ, l⟩ = l: l = lγ + t e with e = ∂γ/∂ϑ'; H = h is a quadratic equation for t.
            let [e_x, e_y, r_hat] = torus.axes();
            let ((sin_psi, cos_psi), (sin, cos)) = (libm::sincos(psi), libm::sincos(theta));
            let equator = add(scale(sin_psi, e_x), scale(cos_psi, e_y));
            let gamma = add(scale(sin, equator), scale(cos, r_hat));
            let e = add(scale(cos, equator), scale(-sin, r_hat));
            let top = torus.top();
            let (weighted_e, weighted_gamma) = (top.inverse_inertia(e), top.inverse_inertia(gamma));
            let a = dot(e, weighted_e);
            let b = l * dot(gamma, weighted_e);
            let c = l * l * dot(gamma, weighted_gamma) - 2.0 * (h + dot(gamma, top.center()));
            let discriminant = b * b - a * c;
            if discriminant.is_nan() || discriminant < 0.0 {
                return None;
            }
            // Δ = ⟨ω, e⟩ |r| sin ϑ' = ∂H/∂t |r| sin ϑ' has the sign of the root.
            let root = discriminant.sqrt();
            let state = |t: f64| State { gamma, l: add(scale(l, gamma), scale(t / a, e)) };
            Some([state(-b - root), state(-b + root)])
        }
    }
}
