//! What a section looks like before any orbit is drawn: the accessible parts of its two sheets, their boundary and
//! the line of tangency Ṡ = 0.
//!
//! All curves are traced on P_hl itself, in phase space: there the line of tangency runs smoothly from one sheet
//! over ∂U to the other, and no pole is an exception. They start from points that a scan finds: ∂U from its
//! certified arcs on circles of latitude, until the number of its circles is that of the certified sweep; the line of
//! tangency from the points where it leaves ∂U and from a grid, whose spacing is the size below which a closed line
//! can be overlooked.

mod boundary;
mod build;
mod chart;
mod cut;
mod equations;
mod linear;
mod seeds;
mod trace;

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

pub use chart::{ChartArea, SectionChart};

use super::condition::SectionCondition;
use super::orbit::SectionPoint;
use super::torus::PpTorus;
use crate::field::{Dimension, State};
use chart::{Axes, edge_parts};
use equations::SectionEquations;
use seeds::Field;

/// The resolution of a portrait.
#[derive(Clone, Copy, Debug)]
pub struct PortraitOptions<'a> {
    /// The section.
    pub condition: SectionCondition,
    /// Rows of the grid on which the line of tangency is looked for: closed lines smaller than π/rows may be missed.
    pub rows: usize,
    /// Cancellation: once it is set, the work ends with [`SectionError::Interrupted`](super::SectionError::Interrupted).
    pub stop: Option<&'a AtomicBool>,
}

impl Default for PortraitOptions<'_> {
    fn default() -> Self {
        Self { condition: SectionCondition::Height, rows: 120, stop: None }
    }
}

/// A polyline of unit vectors γ.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionLine {
    /// Vertices, on the curve to rounding; neighbours are at most 0.02 rad apart.
    pub points: Vec<[f64; 3]>,
    /// The last vertex is joined to the first.
    pub closed: bool,
}

/// What is known of how complete a portrait is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PortraitReport {
    /// Closed curves of ∂U that were traced.
    pub boundary_circles: usize,
    /// How many there are, if the certified sweep decided it.
    pub certified_circles: Option<usize>,
    /// Lines that could not be followed to their end.
    pub open_lines: usize,
}

impl PortraitReport {
    /// True when ∂U is known to be complete and every line was followed.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.open_lines == 0 && self.certified_circles.is_none_or(|circles| circles == self.boundary_circles)
    }
}

/// The section P_hl of a body as a map of its two sheets.
#[derive(Clone, Debug)]
pub struct Portrait {
    torus: PpTorus,
    /// The torus and the equations of the top in its own units.
    reduced: PpTorus,
    equations: SectionEquations,
    boundary: Vec<SectionLine>,
    /// ∂U cut where the line of tangency touches it; whether Ṡ < 0.
    boundary_pieces: Vec<(SectionLine, bool)>,
    /// On T⁻ and T⁺.
    tangency: [Vec<SectionLine>; 2],
    report: PortraitReport,
}

impl Portrait {
    /// The torus.
    #[must_use]
    pub fn torus(&self) -> &PpTorus {
        &self.torus
    }

    /// The section's condition.
    #[must_use]
    pub fn condition(&self) -> SectionCondition {
        self.equations.condition
    }

    /// (h, l).
    #[must_use]
    pub fn energy_momentum(&self) -> (f64, f64) {
        let units = self.torus.top().units();
        let (h, l) = (self.equations.h, self.equations.l);
        (units.restore(h, Dimension::ENERGY), units.restore(l, Dimension::MOMENTUM))
    }

    /// How complete it is.
    #[must_use]
    pub fn report(&self) -> PortraitReport {
        self.report
    }

    /// ∂U, or for S = ⟨l, γ×r⟩ the boundary of the projection of P_hl.
    #[must_use]
    pub fn boundary(&self) -> &[SectionLine] {
        &self.boundary
    }

    /// The line of tangency on T⁺ (`sheet` > 0) or T⁻.
    #[must_use]
    pub fn tangency(&self, sheet: i8) -> &[SectionLine] {
        &self.tangency[usize::from(sheet > 0)]
    }

    /// The states on T⁻ and T⁺ over a point (x, y) of a chart; `None` if it is inaccessible.
    #[must_use]
    pub fn states(&self, chart: SectionChart, point: [f64; 2]) -> Option<[State; 2]> {
        let units = self.torus.top().units();
        self.reduced_states(chart, point).map(|states| states.map(|state| state.restored(units)))
    }

    /// The same in the top's own units.
    fn reduced_states(&self, chart: SectionChart, point: [f64; 2]) -> Option<[State; 2]> {
        let place = match chart {
            SectionChart::Torus => point,
            SectionChart::Sphere => {
                let gamma = Axes::new(chart, &self.torus).gamma(point);
                Axes::new(SectionChart::Torus, &self.torus).angles(gamma)
            }
        };
        Field { torus: &self.reduced, equations: &self.equations }.states(place)
    }

    /// Ṡ on T⁻ and T⁺ at a point of a chart; `None` if it is inaccessible.
    #[must_use]
    pub fn rates(&self, chart: SectionChart, point: [f64; 2]) -> Option<[f64; 2]> {
        let (units, dimension) = (self.torus.top().units(), self.condition().dimension().rate());
        let rate = |state| units.restore(self.equations.rate(&state), dimension);
        self.reduced_states(chart, point).map(|states| states.map(rate))
    }

    /// True when +r̂ (`sign` > 0) or −r̂ is accessible, so that the polar circle belongs to the section.
    #[must_use]
    pub fn has_pole(&self, sign: i8) -> bool {
        self.states(SectionChart::Torus, [0.0, if sign > 0 { 0.0 } else { PI }]).is_some()
    }

    /// (x, y) of a vector in a chart.
    #[must_use]
    pub fn position(&self, chart: SectionChart, gamma: [f64; 3]) -> [f64; 2] {
        Axes::new(chart, &self.torus).angles(gamma)
    }

    /// (x, y) of a crossing in a chart, and its sheet.
    #[must_use]
    pub fn crossing(&self, chart: SectionChart, point: &SectionPoint) -> ([f64; 2], i8) {
        let sheet = match self.equations.condition {
            SectionCondition::Height => point.sheet,
            SectionCondition::AngularMomentum => {
                let state = State { gamma: point.gamma, l: point.l }.reduced(self.torus.top().units());
                if self.equations.delta(&state) < 0.0 { -1 } else { 1 }
            }
        };
        let place = match chart {
            SectionChart::Torus => [point.psi, point.theta],
            SectionChart::Sphere => self.position(chart, point.gamma),
        };
        (place, sheet)
    }

    /// A line in a chart, cut at its seam.
    #[must_use]
    pub fn in_chart(&self, chart: SectionChart, line: &SectionLine) -> Vec<Vec<[f64; 2]>> {
        Axes::new(chart, &self.torus).cut(&line.points, line.closed)
    }

    /// The accessible area of a chart.
    #[must_use]
    pub fn accessible(&self, chart: SectionChart) -> ChartArea {
        let lines = self.boundary.iter().flat_map(|line| self.in_chart(chart, line)).collect();
        ChartArea::new(lines, &edge_parts(&|x| self.states(chart, [x, PI]).is_some()))
    }

    /// The area where Ṡ < 0 on T⁺ (`sheet` > 0) or T⁻.
    #[must_use]
    pub fn incoming(&self, chart: SectionChart, sheet: i8) -> ChartArea {
        let own = self.tangency(sheet).iter();
        let along_boundary = self.boundary_pieces.iter().filter(|(_, incoming)| *incoming).map(|(line, _)| line);
        let lines = own.chain(along_boundary).flat_map(|line| self.in_chart(chart, line)).collect();
        let incoming = |x: f64| self.rates(chart, [x, PI]).is_some_and(|rates| rates[usize::from(sheet > 0)] < 0.0);
        ChartArea::new(lines, &edge_parts(&incoming))
    }
}

#[cfg(test)]
mod tests;
