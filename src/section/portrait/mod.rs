//! What a section looks like before any orbit is drawn: the accessible parts of its two sheets, their boundary and
//! the line of tangency Ṡ = 0.
//!
//! All curves are traced on P_hl itself, in phase space: there the line of tangency runs smoothly from one sheet
//! over ∂U to the other, and no pole is an exception. They start from points that a scan finds: ∂U from its
//! certified arcs on circles of latitude, until the number of its circles is that of the certified sweep; the line of
//! tangency from the points where it leaves ∂U and from a grid, whose spacing is the size below which a closed line
//! can be overlooked.

mod chart;
mod cut;
mod equations;
mod lift;
mod linear;
mod seeds;
mod trace;

use std::f64::consts::{PI, TAU};

pub use chart::{Area, Chart};

use super::condition::SectionCondition;
use super::error::SectionError;
use super::sweep::SectionPoint;
use super::torus::PpTorus;
use crate::body::Body;
use crate::dynamics::{HeavyTop, State};
use crate::topology::latitude::{Latitudes, components};
use chart::Axes;
use cut::{Piece, boundary_pieces, tangency_pieces};
use equations::{Equations, Zero};
use linear::Vector;
use seeds::Field;
use trace::{Spacing, Traced, trace};

/// Places on the edge of a chart at which its kind is looked up.
const EDGE_PLACES: usize = 720;
/// The most circles of latitude on which ∂U is looked for.
const MOST_ROWS: usize = 4096;

/// How finely a portrait is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PortraitOptions {
    /// The section.
    pub condition: SectionCondition,
    /// Rows of the grid on which the line of tangency is looked for: closed lines smaller than π/rows may be missed.
    pub rows: usize,
}

impl Default for PortraitOptions {
    fn default() -> Self {
        Self { condition: SectionCondition::Height, rows: 120 }
    }
}

/// A polyline of unit vectors γ.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
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
    /// How many there are, if the certified sweep could tell.
    pub certified_circles: Option<usize>,
    /// Lines that could not be followed to their end.
    pub open_lines: usize,
}

impl PortraitReport {
    /// Is ∂U known to be complete, and was every line followed?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.open_lines == 0 && self.certified_circles.is_none_or(|circles| circles == self.boundary_circles)
    }
}

/// The section P_hl of a body as a map of its two sheets.
#[derive(Clone, Debug)]
pub struct Portrait {
    torus: PpTorus,
    equations: Equations,
    boundary: Vec<Line>,
    /// ∂U cut where the line of tangency touches it; whether Ṡ < 0.
    boundary_pieces: Vec<(Line, bool)>,
    /// On T⁻ and T⁺.
    tangency: [Vec<Line>; 2],
    report: PortraitReport,
}

/// Shorter steps near the poles of both charts.
struct BothCharts([Axes; 2]);

impl Spacing for BothCharts {
    fn at(&self, gamma: [f64; 3]) -> f64 {
        let nearest = self.0.iter().map(|axes| axes.sine(gamma)).fold(1.0, f64::min);
        (4.0 * nearest).clamp(0.01, 1.0)
    }
}

impl Portrait {
    /// The section at energy h and vertical angular momentum l.
    ///
    /// # Errors
    /// [`SectionError::WeightlessBody`] for r = 0; [`SectionError::Parameter`] for h or l that is not finite;
    /// [`SectionError::Inaccessible`] where no point is accessible.
    pub fn new(body: &Body, h: f64, l: f64, options: &PortraitOptions) -> Result<Self, SectionError> {
        for (name, value) in [("h", h), ("l", l)] {
            if !value.is_finite() {
                return Err(SectionError::Parameter { name, value, expected: "a finite number is needed" });
            }
        }
        let top = HeavyTop::new(body);
        let torus = PpTorus::new(&top)?;
        let equations = Equations::new(top, options.condition, h, l);
        let field = Field { torus: &torus, equations: &equations };
        let spacing = BothCharts([Chart::Torus, Chart::Sphere].map(|chart| Axes::new(chart, &torus)));
        let rows = options.rows.max(8);
        let grid = field.on_grid(Chart::Torus, rows);
        let mut report = PortraitReport::default();
        let mut boundary = Vec::new();
        match options.condition {
            SectionCondition::Height => {
                let frame = body.frame();
                let (h, l) = (h / frame.energy_unit, l / frame.momentum_unit);
                let circles = components(&frame, h, l).ok();
                let count = |parts: Vec<crate::topology::Component>| {
                    parts.iter().map(|part| part.boundary_circles as usize).sum::<usize>()
                };
                report.certified_circles = circles.map(count);
                if let Ok(latitudes) = Latitudes::new(&frame, h, l) {
                    let mut rows = rows;
                    loop {
                        let seeds = field.boundary_on_latitudes(&latitudes, rows);
                        trace_all(&equations, Zero::Sheets, seeds, &spacing, &mut boundary);
                        rows *= 2;
                        let complete = report.certified_circles.is_none_or(|circles| boundary.len() >= circles);
                        if complete || rows > MOST_ROWS {
                            break;
                        }
                    }
                }
            }
            SectionCondition::AngularMomentum => {
                trace_all(&equations, Zero::Sheets, grid.boundary, &spacing, &mut boundary);
            }
        }
        let mut meetings = cut::sign_changes(&equations, &boundary);
        let mut tangency = Vec::new();
        let seeds = meetings.iter().copied().chain(grid.tangency);
        trace_all(&equations, Zero::Tangency, seeds, &spacing, &mut tangency);
        let on_sheets = tangency_pieces(&equations, &tangency, &mut meetings);
        let along_boundary = boundary_pieces(&equations, &boundary, &meetings);

        report.boundary_circles = boundary.iter().filter(|line| line.closed).count();
        report.open_lines = boundary.iter().chain(&tangency).filter(|line| !line.closed).count();
        let gamma = |x: &Vector| [x[0], x[1], x[2]];
        let line = |piece: &Piece| Line { points: piece.points.iter().map(gamma).collect(), closed: piece.closed };
        let whole = |traced: &Traced| Line { points: traced.points.iter().map(gamma).collect(), closed: traced.closed };
        let sheet = |positive: bool| on_sheets.iter().filter(|piece| piece.positive == positive).map(line).collect();
        let portrait = Self {
            boundary: boundary.iter().map(whole).collect(),
            boundary_pieces: along_boundary.iter().map(|piece| (line(piece), !piece.positive)).collect(),
            tangency: [sheet(false), sheet(true)],
            torus,
            equations,
            report,
        };
        portrait.check_accessible(rows)?;
        Ok(portrait)
    }

    /// An error that names the lowest U_l on the grid if nothing is accessible.
    fn check_accessible(&self, rows: usize) -> Result<(), SectionError> {
        if !self.boundary.is_empty() {
            return Ok(());
        }
        let (h, l) = (self.equations.h, self.equations.l);
        let mut lowest = f64::INFINITY;
        let mut tried = 0;
        for row in 0..rows {
            for column in 0..2 * rows {
                let [x, y] = [(column as f64 + 0.25) * PI / rows as f64, (row as f64 + 0.5) * PI / rows as f64];
                if self.states(Chart::Torus, [x, y]).is_some() {
                    return Ok(());
                }
                tried += 1;
                lowest = lowest.min(self.torus.top().effective_potential(self.torus.gamma(y, x), l));
            }
        }
        Err(SectionError::Inaccessible { h, lowest, tried })
    }

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
        (self.equations.h, self.equations.l)
    }

    /// How complete it is.
    #[must_use]
    pub fn report(&self) -> PortraitReport {
        self.report
    }

    /// ∂U, or for S = ⟨l, γ×r⟩ the boundary of the projection of P_hl.
    #[must_use]
    pub fn boundary(&self) -> &[Line] {
        &self.boundary
    }

    /// The line of tangency on T⁺ (`sheet` > 0) or T⁻.
    #[must_use]
    pub fn tangency(&self, sheet: i8) -> &[Line] {
        &self.tangency[usize::from(sheet > 0)]
    }

    /// The states on T⁻ and T⁺ over a point (x, y) of a chart; `None` if it is inaccessible.
    #[must_use]
    pub fn states(&self, chart: Chart, point: [f64; 2]) -> Option<[State; 2]> {
        let place = match chart {
            Chart::Torus => point,
            Chart::Sphere => {
                let gamma = Axes::new(chart, &self.torus).gamma(point);
                Axes::new(Chart::Torus, &self.torus).angles(gamma)
            }
        };
        Field { torus: &self.torus, equations: &self.equations }.states(place)
    }

    /// Ṡ on T⁻ and T⁺ at a point of a chart; `None` if it is inaccessible.
    #[must_use]
    pub fn rates(&self, chart: Chart, point: [f64; 2]) -> Option<[f64; 2]> {
        self.states(chart, point).map(|states| states.map(|state| self.equations.rate(&state)))
    }

    /// Is +r̂ (`sign` > 0) or −r̂ accessible, so that the polar circle belongs to the section?
    #[must_use]
    pub fn has_pole(&self, sign: i8) -> bool {
        self.states(Chart::Torus, [0.0, if sign > 0 { 0.0 } else { PI }]).is_some()
    }

    /// (x, y) of a vector in a chart.
    #[must_use]
    pub fn position(&self, chart: Chart, gamma: [f64; 3]) -> [f64; 2] {
        Axes::new(chart, &self.torus).angles(gamma)
    }

    /// (x, y) of a crossing in a chart, and its sheet.
    #[must_use]
    pub fn crossing(&self, chart: Chart, point: &SectionPoint) -> ([f64; 2], i8) {
        let sheet = match self.equations.condition {
            SectionCondition::Height => point.sheet,
            SectionCondition::AngularMomentum => {
                let state = State { gamma: point.gamma, l: point.l };
                if self.equations.delta(&state) < 0.0 { -1 } else { 1 }
            }
        };
        let place = match chart {
            Chart::Torus => [point.psi, point.theta],
            Chart::Sphere => self.position(chart, point.gamma),
        };
        (place, sheet)
    }

    /// A line in a chart, cut at its seam.
    #[must_use]
    pub fn in_chart(&self, chart: Chart, line: &Line) -> Vec<Vec<[f64; 2]>> {
        Axes::new(chart, &self.torus).cut(&line.points, line.closed)
    }

    /// The accessible area of a chart.
    #[must_use]
    pub fn accessible(&self, chart: Chart) -> Area {
        let lines = self.boundary.iter().flat_map(|line| self.in_chart(chart, line)).collect();
        Area::new(lines, &self.bottom(&|x| self.states(chart, [x, PI]).is_some()))
    }

    /// The area where Ṡ < 0 on T⁺ (`sheet` > 0) or T⁻.
    #[must_use]
    pub fn incoming(&self, chart: Chart, sheet: i8) -> Area {
        let own = self.tangency(sheet).iter();
        let along_boundary = self.boundary_pieces.iter().filter(|(_, incoming)| *incoming).map(|(line, _)| line);
        let lines = own.chain(along_boundary).flat_map(|line| self.in_chart(chart, line)).collect();
        let incoming = |x: f64| self.rates(chart, [x, PI]).is_some_and(|rates| rates[usize::from(sheet > 0)] < 0.0);
        Area::new(lines, &self.bottom(&incoming))
    }

    /// The parts of the edge y = π of which something holds.
    fn bottom(&self, holds: &dyn Fn(f64) -> bool) -> Vec<[f64; 2]> {
        let place = |k: usize| (k as f64 + 0.5) * TAU / EDGE_PLACES as f64;
        let mut parts = Vec::new();
        let mut open = holds(place(0)).then_some(0.0);
        for k in 1..EDGE_PLACES {
            let here = holds(place(k));
            if here == open.is_some() {
                continue;
            }
            let (mut low, mut high) = (place(k - 1), place(k));
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if holds(middle) == here { high = middle } else { low = middle }
            }
            match open.take() {
                Some(from) => parts.push([from, high]),
                None => open = Some(high),
            }
        }
        parts.extend(open.map(|from| [from, TAU]));
        parts
    }
}

/// Traces every curve that has a seed and is not among `lines` yet.
fn trace_all(
    equations: &Equations,
    zero: Zero,
    seeds: impl IntoIterator<Item = Vector>,
    spacing: &dyn Spacing,
    lines: &mut Vec<Traced>,
) {
    for seed in seeds {
        let Some(direction) = equations.tangent(zero, &seed) else { continue };
        if !lines.iter().any(|line| line.covers(&seed, &direction)) {
            lines.extend(trace(equations, zero, seed, spacing).filter(|line| line.points.len() > 1));
        }
    }
}

#[cfg(test)]
mod tests;
