//! Ways from a point of the sphere to minima along which U stays below the point (Proposition 9.2).
//!
//! A way is a chain of segments and arcs. Where it goes is found in rounded arithmetic; that U stays below is proved on
//! each of their pieces.

use super::landscape::{Coordinates, Landscape, Origin, on_sphere};
use super::path::{Path, across, turns};
use crate::numbers::interval::Interval;
use crate::numbers::jet::Jet;

/// Pieces that are tried on a path to a minimum.
const PIECES: usize = 96;
/// Pieces that are tried on a step downwards.
const STEP_PIECES: usize = 8;
/// Steps downwards.
const STEPS: usize = 24;
/// A step that is shorter than this follows an arc if one leads farther.
const STRAIGHT: f64 = 1e-2;
/// Halvings of a first piece or a step.
const HALVINGS: usize = 80;

/// Where ways lead.
pub(crate) struct Descent<'a> {
    pub land: &'a Landscape<'a>,
    pub minima: &'a [&'a Coordinates],
}

/// Where they lead from, with the way to each minimum.
struct Ways<'a> {
    land: &'a Landscape<'a>,
    from: &'a Origin,
    minima: Vec<[Interval; 3]>,
}

impl Descent<'_> {
    fn from<'a>(&'a self, from: &'a Origin) -> Ways<'a> {
        let way = |minimum: &Coordinates| std::array::from_fn(|i| Interval::of(&(&minimum[i] - &from.gamma[i])));
        Ways { land: self.land, from, minima: self.minima.iter().map(|&minimum| way(minimum)).collect() }
    }

    /// Numbers of the minima to which the two sides of a saddle descend: along a line through it, or along an arc.
    pub fn arms(&self, saddle: &Origin) -> Option<[usize; 2]> {
        let (soft, ways) = (self.land.softest(saddle)?, self.from(saddle));
        let straight = || Some([ways.along(&soft)?, ways.along(&soft.map(|c| -c))?]);
        let round = |axis| Some([ways.round(axis, 1.0)?, ways.round(axis, -1.0)?]);
        (0..3).find_map(round).or_else(straight)
    }

    /// The number of a minimum that can be reached from a maximum or a point that is no equilibrium.
    pub fn any(&self, from: &Origin) -> Option<usize> {
        let ways = self.from(from);
        let down = || match from.order() {
            1 => Some(self.land.steepest(from, &[0.0; 3])),
            _ => self.land.softest(from),
        };
        let straight = |number: &usize| ways.leaves_for(&Path::line(&[0.0; 3], &ways.minima[*number]));
        (0..self.minima.len()).find(straight).or_else(|| ways.along(&down()?))
    }
}

impl Ways<'_> {
    /// Leaves the origin in a direction, and goes down from there until some minimum can be reached.
    fn along(&self, direction: &[f64; 3]) -> Option<usize> {
        let line = Path::line(&[0.0; 3], &direction.map(Interval::point));
        let length = self.first(&line)?;
        let mut w = direction.map(|c| c * length);
        // The product is rounded, so that the first piece is proved for the direction that is taken.
        if !self.leaves(&Path::line(&[0.0; 3], &w.map(Interval::point)), 1.0) {
            return None;
        }
        for _ in 0..STEPS {
            if let Some(found) = self.reached(&w) {
                return Some(found);
            }
            w = self.lower(&w)?;
        }
        None
    }

    /// Leaves the origin on an arc about an axis in a sense; the number of the first minimum to which one leads.
    fn round(&self, axis: usize, sense: f64) -> Option<usize> {
        (0..self.minima.len()).find(|&number| self.turns_to(&[0.0; 3], axis, sense, number).is_some())
    }

    /// The number of a minimum to which a segment leads, or an arc and a segment.
    fn reached(&self, w: &[f64; 3]) -> Option<usize> {
        let straight = |number: &usize| self.stays_below(&Path::line(w, &self.minima[*number]), 0.0, PIECES);
        let round = |number: &usize| {
            let ways = (0..3).flat_map(|axis| [(axis, 1.0), (axis, -1.0)]);
            ways.into_iter().any(|(axis, sense)| self.turns_to(w, axis, sense, *number).is_some())
        };
        let numbers = || 0..self.minima.len();
        numbers().find(straight).or_else(|| numbers().find(round))
    }

    /// Turns about an axis up to the meridian of a minimum, and goes straight to it.
    fn turns_to(&self, w: &[f64; 3], axis: usize, sense: f64, minimum: usize) -> Option<()> {
        let p = self.from.p.map(Interval::middle);
        let to = &self.minima[minimum];
        let plane = |w: &[f64; 3]| across(axis).map(|i| p[i] + w[i]);
        let mut w = *w;
        for tangent in turns(plane(&w), plane(&to.map(Interval::middle)), sense)? {
            let arc = Path::Arc { axis, start: w.map(Interval::point), tangent: Interval::point(tangent) };
            let starts = w.iter().all(|c| *c == 0.0);
            let proved = if starts { self.leaves_for(&arc) } else { self.stays_below(&arc, 0.0, PIECES) };
            if !proved {
                return None;
            }
            w = arc.end(&self.from.p);
            if !self.ends_at(&arc, &w) {
                return None;
            }
        }
        self.stays_below(&Path::line(&w, to), 0.0, PIECES).then_some(())
    }

    /// A point further down the valley: along a line, or, where the valley soon turns away from it, along an arc.
    fn lower(&self, w: &[f64; 3]) -> Option<[f64; 3]> {
        let [floor, down] = self.land.valley(self.from, w);
        let now = self.height(w);
        let lengths = || std::iter::successors(Some(0.5), |length| Some(0.5 * length)).take(HALVINGS);
        let ahead = |length: f64| on_sphere(self.from, &std::array::from_fn(|i| w[i] + floor[i] + length * down[i]));
        let is_free = |next: &[f64; 3]| self.stays_below(&Path::line(w, &next.map(Interval::point)), 0.0, STEP_PIECES);
        let found = lengths().find(|&length| self.height(&ahead(length)) < now && is_free(&ahead(length)));
        let reach = found.unwrap_or(0.0);
        let bottom = ahead(0.0);
        let round = if reach < STRAIGHT && is_free(&bottom) { self.bent(&bottom, &down, reach) } else { None };
        round.or_else(|| found.map(ahead))
    }

    /// The end of an arc that continues in a direction about the axis for which it does so best, farther than `reach`.
    fn bent(&self, w: &[f64; 3], down: &[f64; 3], reach: f64) -> Option<[f64; 3]> {
        let now = self.height(w);
        let at: [f64; 3] = std::array::from_fn(|i| self.from.p[i].middle() + w[i]);
        let along = |axis: usize| {
            let [j, k] = across(axis);
            let radius = (at[j] * at[j] + at[k] * at[k]).sqrt();
            [(at[j] * down[k] - at[k] * down[j]) / radius, radius]
        };
        let better = |p: &usize, q: &usize| along(*p)[0].abs().total_cmp(&along(*q)[0].abs());
        let axis = (0..3).filter(|&axis| along(axis)[1] > 0.0).max_by(better)?;
        let [sense, radius] = along(axis);
        let tangents = std::iter::successors(Some(sense.signum()), |tangent| Some(0.5 * tangent));
        tangents.take_while(|tangent| 2.0 * tangent.abs() * radius > 2.0 * reach).take(HALVINGS).find_map(|tangent| {
            let arc = Path::Arc { axis, start: w.map(Interval::point), tangent: Interval::point(tangent) };
            let end = arc.end(&self.from.p);
            (self.height(&end) < now && self.stays_below(&arc, 0.0, PIECES) && self.ends_at(&arc, &end)).then_some(end)
        })
    }

    /// U − U(p), rounded.
    fn height(&self, w: &[f64; 3]) -> f64 {
        let there = Path::line(w, &w.map(Interval::point));
        self.land.rise(self.from, &there, Interval::point(0.0))[0].0[0].middle()
    }

    /// What lies between the end of an arc and that end rounded is below the origin.
    fn ends_at(&self, arc: &Path, end: &[f64; 3]) -> bool {
        let last = arc.jets(&self.from.p, Interval::point(1.0)).map(|w| w.0[0]);
        self.is_below(&Path::line(end, &last), 0.0, 1.0)
    }

    /// A path from the origin stays below it.
    fn leaves_for(&self, path: &Path) -> bool {
        self.first(path).is_some_and(|t| self.stays_below(path, t, PIECES))
    }

    /// A parameter up to which a path from the origin stays below it.
    fn first(&self, path: &Path) -> Option<f64> {
        std::iter::successors(Some(1.0), |t| Some(0.5 * t)).take(HALVINGS).find(|&t| self.leaves(path, t))
    }

    /// Up to t a path from the origin stays below it: U − U(p) and, at an equilibrium, its first derivative are 0 at the
    /// origin, and the next derivative is negative.
    fn leaves(&self, path: &Path, t: f64) -> bool {
        let order = self.from.order();
        self.land.rise(self.from, path, Interval::between(0.0, t)).iter().any(|rise| rise.0[order].sign() == Some(-1))
    }

    /// U − U(p) < 0 from t up to 1, by pieces that grow where that is easy.
    fn stays_below(&self, path: &Path, mut t: f64, pieces: usize) -> bool {
        let mut step = if t > 0.0 { t } else { 1.0 };
        for _ in 0..pieces {
            if t >= 1.0 {
                break;
            }
            let next = (t + step).min(1.0);
            if self.is_below(path, t, next) {
                t = next;
                step *= 2.0;
            } else {
                step *= 0.5;
            }
        }
        t >= 1.0
    }

    /// U − U(p) < 0 on a piece, by Taylor's formula with the second derivative from all of it.
    fn is_below(&self, path: &Path, t: f64, next: f64) -> bool {
        let there = self.land.rise(self.from, path, Interval::point(t));
        if there.iter().all(|rise| rise.0[0].sign() != Some(-1)) {
            return false;
        }
        let run = Interval::between(0.0, (next - t).next_up());
        let over = self.land.rise(self.from, path, Interval::between(t, next));
        there.iter().zip(over).any(|(Jet([value, slope, _]), Jet([_, _, bend]))| {
            (*value + run * (*slope + run * bend)).sign() == Some(-1)
        })
    }
}
