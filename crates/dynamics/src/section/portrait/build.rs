//! From a body, h and l to the traced curves of its section.

use std::f64::consts::PI;

use super::boundary::traced_boundary;
use super::chart::{Axes, SectionChart};
use super::cut::{self, CurvePiece, boundary_pieces, tangency_pieces};
use super::equations::{SectionEquations, Zero};
use super::linear::PhaseVector;
use super::seeds::Field;
use super::trace::{Traced, Tracer};
use super::{Portrait, PortraitOptions, PortraitReport, SectionLine};
use crate::field::{Dimension, HeavyTop};
use crate::section::condition::SectionCondition;
use crate::section::error::{SectionError, check_finite};
use crate::section::torus::PpTorus;
use bifdiag_body::Body;

impl Portrait {
    /// The section at energy h and vertical angular momentum l.
    ///
    /// # Errors
    /// [`SectionError::WeightlessBody`] for r = 0; [`SectionError::Parameter`] for h or l that is not finite;
    /// [`SectionError::Inaccessible`] where no point is accessible; [`SectionError::Interrupted`].
    pub fn new(body: &Body, h: f64, l: f64, options: &PortraitOptions<'_>) -> Result<Self, SectionError> {
        check_finite(h, l)?;
        let torus = PpTorus::new(&HeavyTop::new(body))?;
        let reduced = torus.reduced();
        let units = torus.top().units();
        let reduced_h = units.reduce(h, Dimension::ENERGY);
        let reduced_l = units.reduce(l, Dimension::MOMENTUM);
        let equations = SectionEquations::new(*reduced.top(), options.condition, reduced_h, reduced_l);
        let field = Field { torus: &reduced, equations: &equations };
        let charts = [SectionChart::Torus, SectionChart::Sphere].map(|chart| Axes::new(chart, &torus));
        let (rows, stop) = (options.rows.max(8), options.stop);
        let tracer = |zero| Tracer { equations: &equations, charts: &charts, stop, zero };
        let grid = field.on_grid(SectionChart::Torus, rows, stop)?;
        let (boundary, certified_circles) = match options.condition {
            SectionCondition::Height => traced_boundary(body, (h, l), field, rows, tracer(Zero::Sheets))?,
            SectionCondition::AngularMomentum => {
                let mut lines = Vec::new();
                tracer(Zero::Sheets).extend(&mut lines, grid.boundary)?;
                (lines, None)
            }
        };
        let mut meetings = cut::sign_changes(&equations, &boundary);
        let mut tangency = Vec::new();
        let seeds = meetings.iter().copied().chain(grid.tangency);
        tracer(Zero::Tangency).extend(&mut tangency, seeds)?;
        let on_sheets = tangency_pieces(&equations, &tangency, &mut meetings);
        let along_boundary = boundary_pieces(&equations, &boundary, &meetings);
        let sheet = |positive: bool| on_sheets.iter().filter(|piece| piece.positive == positive).map(part).collect();
        let portrait = Self {
            report: PortraitReport {
                boundary_circles: boundary.iter().filter(|line| line.closed).count(),
                certified_circles,
                open_lines: boundary.iter().chain(&tangency).filter(|line| !line.closed).count(),
            },
            boundary: boundary.iter().map(whole).collect(),
            boundary_pieces: along_boundary.iter().map(|piece| (part(piece), !piece.positive)).collect(),
            tangency: [sheet(false), sheet(true)],
            torus,
            reduced,
            equations,
        };
        portrait.check_accessible(rows)?;
        Ok(portrait)
    }

    /// An error that names the lowest U_l on the grid if nothing is accessible.
    fn check_accessible(&self, rows: usize) -> Result<(), SectionError> {
        if !self.boundary.is_empty() {
            return Ok(());
        }
        let (h, l) = self.energy_momentum();
        let mut lowest = f64::INFINITY;
        let mut tried = 0;
        for row in 0..rows {
            for column in 0..2 * rows {
                let [x, y] = [(column as f64 + 0.25) * PI / rows as f64, (row as f64 + 0.5) * PI / rows as f64];
                if self.states(SectionChart::Torus, [x, y]).is_some() {
                    return Ok(());
                }
                tried += 1;
                lowest = lowest.min(self.torus.top().effective_potential(self.torus.gamma(y, x), l));
            }
        }
        Err(SectionError::Inaccessible { h, lowest, tried })
    }
}

fn gammas(points: &[PhaseVector]) -> Vec<[f64; 3]> {
    points.iter().map(|x| [x[0], x[1], x[2]]).collect()
}

fn whole(traced: &Traced) -> SectionLine {
    SectionLine { points: gammas(&traced.points), closed: traced.closed }
}

fn part(piece: &CurvePiece) -> SectionLine {
    SectionLine { points: gammas(&piece.points), closed: piece.closed }
}
