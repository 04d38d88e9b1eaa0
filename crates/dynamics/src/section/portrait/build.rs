//! From a body, h and l to the traced curves of its section.

use std::f64::consts::PI;

use super::chart::{Axes, Chart};
use super::cut::{self, Piece, boundary_pieces, tangency_pieces};
use super::equations::{Equations, Zero};
use super::linear::Vector;
use super::seeds::Field;
use super::trace::{Spacing, Traced, trace};
use super::{Line, Portrait, PortraitOptions, PortraitReport};
use crate::field::HeavyTop;
use crate::section::{PpTorus, SectionCondition, SectionError};
use top::body::Body;
use top::topology::latitude::{Latitudes, components};

/// The most circles of latitude on which ∂U is looked for.
const MOST_ROWS: usize = 4096;

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
                let count = |parts: Vec<top::topology::Component>| {
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
