//! Polylines from the closed form, for pole lines and for strong magnification.

use super::Atlas;
use crate::curves::{Curve, CurveId, CurveName, Pole};
use numbers::UNIT_ROUNDOFF;

/// How far a chord may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// In h.
    pub h: f64,
    /// Chords with a larger dh/dl are measured across, so that a line that leaves the diagram in a trice has few points.
    pub steep: f64,
}

impl Tolerance {
    /// In h, for a chord.
    fn of_chord(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        self.h * ((to[0] - from[0]).abs() / ((to[1] - from[1]) * self.steep)).max(1.0)
    }
}

impl Atlas {
    /// Points [h, l] of a curve by rising l over the common part of its range and `l`, such that the straight line
    /// between neighbours is off by at most `tolerance` in h. `None` when there is no such curve or no common part.
    #[must_use]
    pub fn polyline(&self, curve: CurveName, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        let set = &self.arrangement.set;
        let number = set
            .curves
            .ids()
            .find(|&c| CurveName::of(set, c) == curve || self.carries_pole(c).map(CurveName::Pole) == Some(curve))?;
        let curve = &set.curves[number];
        let range = curve.x().map(|x| self.momentum(x));
        let range = [range[0].max(l[0]), range[1].min(l[1])];
        (range[0] < range[1]).then(|| self.sampled(curve, range, Tolerance { h: tolerance, steep: f64::INFINITY }))
    }

    /// The pole whose line runs on the last piece of this axis curve.
    fn carries_pole(&self, curve: CurveId) -> Option<Pole> {
        let curve = &self.arrangement.set.curves[curve];
        curve.pole.filter(|_| curve.x()[1].is_infinite())
    }

    /// The polyline of a curve over a range of l inside its own.
    pub(super) fn sampled(&self, curve: &Curve, l: [f64; 2], tolerance: Tolerance) -> Vec<[f64; 2]> {
        const MAX_DEPTH: u32 = 24;
        /// A chord is not asked to be closer than so many units of roundoff of h, which no more points would mend.
        const ROUNDINGS: f64 = 64.0;
        let mut points = vec![[self.h_at(curve, l[0]), l[0]]];
        let last = [self.h_at(curve, l[1]), l[1]];
        let noise = ROUNDINGS * UNIT_ROUNDOFF * points[0][0].abs().max(last[0].abs());
        let tolerance = Tolerance { h: tolerance.h.max(noise), ..tolerance };
        self.refine(curve, points[0], last, tolerance, MAX_DEPTH, &mut points);
        points
    }

    /// Adds the points after `from` up to and including `to`.
    fn refine(
        &self,
        curve: &Curve,
        from: [f64; 2],
        to: [f64; 2],
        tolerance: Tolerance,
        depth: u32,
        points: &mut Vec<[f64; 2]>,
    ) {
        let at = |t: f64| from[1] + t * (to[1] - from[1]);
        let off = |t: f64| {
            let l = at(t);
            let h = self.h_at(curve, l);
            (h - (from[0] + t * (to[0] - from[0]))).abs()
        };
        // Three places inside: a chord that an inflected arc happens to meet in the middle is still seen to be off.
        let most = tolerance.of_chord(from, to);
        let straight = [0.5, 0.25, 0.75].iter().all(|&t| off(t) <= most);
        if straight || depth == 0 {
            points.push(to);
            return;
        }
        let l = at(0.5);
        let middle = [self.h_at(curve, l), l];
        self.refine(curve, from, middle, tolerance, depth - 1, points);
        self.refine(curve, middle, to, tolerance, depth - 1, points);
    }

    /// h of a curve at l, in the body's units; at its ends the limits.
    pub(super) fn h_at(&self, curve: &Curve, l: f64) -> f64 {
        let frame = &self.arrangement.set.frame;
        let scaled = l / frame.momentum_unit;
        let [from, to] = curve.x();
        // Below this x every curve that starts at l = 0 is at its limit to the last bit.
        let smallest = if from > 0.0 { from } else { 1e-60 };
        let x = (0.5 * scaled * scaled).max(smallest).min(to);
        self.energy(curve.point(frame, x).h())
    }
}
