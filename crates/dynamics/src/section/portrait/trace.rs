//! Curves on P_hl by prediction along the tangent and correction by Newton's method.

use std::sync::atomic::AtomicBool;

use super::chart::Axes;
use super::equations::{SectionEquations, Zero};
use super::linear::{PhaseVector, along, inner, length};
use crate::section::error::{SectionError, check_stop};

/// The largest change of γ in a step, in radians.
const STEP: f64 = 0.02;
/// Neighbouring tangents differ by at most this angle's cosine (a quarter of a radian).
const TURN: f64 = 0.97;
/// A step that must be shorter than this ends the curve.
const SHORTEST: f64 = 1e-9;
/// Vertices of one curve.
const VERTICES: usize = 100_000;

/// A traced curve.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Traced {
    pub points: Vec<PhaseVector>,
    pub tangents: Vec<PhaseVector>,
    /// It came back to its first point; else it ends where it could not be followed any further.
    pub closed: bool,
}

/// What is traced, and how.
#[derive(Clone, Copy)]
pub(super) struct Tracer<'a> {
    pub equations: &'a SectionEquations,
    /// Steps are shorter near the poles of these charts, whose angles change fast there.
    pub charts: &'a [Axes],
    pub stop: Option<&'a AtomicBool>,
    pub zero: Zero,
}

impl Tracer<'_> {
    /// Traces every curve that has a seed and is not among `lines` yet.
    pub fn extend(
        &self,
        lines: &mut Vec<Traced>,
        seeds: impl IntoIterator<Item = PhaseVector>,
    ) -> Result<(), SectionError> {
        for seed in seeds {
            check_stop(self.stop)?;
            let Some(direction) = self.equations.tangent(self.zero, &seed) else {
                continue;
            };
            if !lines.iter().any(|line| line.covers(&seed, &direction)) {
                let line = self.trace(seed, direction)?;
                lines.extend(Some(line).filter(|line| line.points.len() > 1));
            }
        }
        Ok(())
    }

    /// Follows the curve through `start` until it closes, or from one end to the other.
    fn trace(&self, start: PhaseVector, tangent: PhaseVector) -> Result<Traced, SectionError> {
        let forward = self.follow(start, tangent)?;
        if forward.closed {
            return Ok(forward);
        }
        let backward = self.follow(start, tangent.map(|t| -t))?;
        let join = |back: Vec<PhaseVector>, on: Vec<PhaseVector>, sign: f64| -> Vec<PhaseVector> {
            back.into_iter().skip(1).rev().map(|x| x.map(|entry| sign * entry)).chain(on).collect()
        };
        Ok(Traced {
            points: join(backward.points, forward.points, 1.0),
            tangents: join(backward.tangents, forward.tangents, -1.0),
            closed: false,
        })
    }

    fn follow(&self, start: PhaseVector, tangent: PhaseVector) -> Result<Traced, SectionError> {
        let mut line = Traced { points: vec![start], tangents: vec![tangent], closed: false };
        let (mut x, mut t) = (start, tangent);
        let mut step = 0.25 * longest(&x, &t, self.charts);
        let mut travelled = 0.0;
        while line.points.len() < VERTICES {
            check_stop(self.stop)?;
            step = step.min(longest(&x, &t, self.charts));
            let next = self.equations.correct(self.zero, &along(&x, step, &t), &t).and_then(|next| {
                let tangent = self.equations.tangent(self.zero, &next)?;
                let cosine = inner(&tangent, &t);
                (cosine.abs() > TURN).then(|| (next, tangent.map(|entry| entry * cosine.signum())))
            });
            let Some((next, tangent)) = next else {
                step *= 0.5;
                if step < SHORTEST {
                    break;
                }
                continue;
            };
            if travelled > 2.0 * step && passes(&x, &next, &t, &start, &line.tangents[0]) {
                line.closed = true;
                break;
            }
            travelled += length(&along(&next, -1.0, &x));
            (x, t) = (next, tangent);
            line.points.push(x);
            line.tangents.push(t);
            step *= 1.5;
        }
        Ok(line)
    }
}

/// The longest step from x, in the metric of phase space.
fn longest(x: &PhaseVector, t: &PhaseVector, charts: &[Axes]) -> f64 {
    let gamma = [x[0], x[1], x[2]];
    let nearest_pole = charts.iter().map(|axes| axes.sine(gamma)).fold(1.0, f64::min);
    let speed = (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]).sqrt();
    STEP * (4.0 * nearest_pole).clamp(0.01, 1.0) / speed.max(0.2)
}

/// True when the step from x to `next` along `t` comes past `target`, where the curve has the direction `there`.
fn passes(x: &PhaseVector, next: &PhaseVector, t: &PhaseVector, target: &PhaseVector, there: &PhaseVector) -> bool {
    let (step, offset) = (length(&along(next, -1.0, x)), along(target, -1.0, x));
    let advance = inner(&offset, t);
    let aside = length(&along(&offset, -advance, t));
    (0.0..=step).contains(&advance) && inner(t, there) > 0.5 && aside <= bulge(t, there, step)
}

/// How far a curve can deviate from a step with these tangents.
fn bulge(t: &PhaseVector, there: &PhaseVector, step: f64) -> f64 {
    let turn = (2.0 - 2.0 * inner(t, there)).max(0.0).sqrt();
    step * (turn + 0.01)
}

impl Traced {
    /// Indices of the vertices of each step.
    pub fn steps(&self) -> impl Iterator<Item = (usize, usize)> {
        let count = self.points.len();
        (0..count - usize::from(!self.closed)).map(move |k| (k, (k + 1) % count))
    }

    /// True when the curve, within its chords' error, comes through a point at which its direction is `direction`, up to
    /// its sign.
    pub fn covers(&self, x: &PhaseVector, direction: &PhaseVector) -> bool {
        self.steps().any(|(i, j)| {
            let chord = along(&self.points[j], -1.0, &self.points[i]);
            let step = length(&chord);
            let offset = along(x, -1.0, &self.points[i]);
            let share = (inner(&offset, &chord) / (step * step)).clamp(0.0, 1.0);
            let aside = length(&along(&offset, -share, &chord));
            aside <= 0.3 * step
                && inner(&self.tangents[i], direction).abs() > 0.5
                && aside <= 0.5 * bulge(&self.tangents[i], &self.tangents[j], step)
        })
    }
}
