//! The course of a curve: a polyline over the range of a picture; its ends from the limits.

use super::Atlas;
use super::polyline::Tolerance;
use bifdiag_equilibria::curves::{Branch, Curve, CurveId, End, Shape};

/// How finely curves are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CourseOptions {
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Curves that go on to infinity are drawn at least up to this l.
    pub l_least: f64,
}

/// h = l²/(2 J) + h0 + O(l⁻²) as l → ∞.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tail {
    /// J: the moment of inertia of the limiting axis.
    pub moment: f64,
    /// h0.
    pub h_offset: f64,
}

/// Ranges for which polylines are made, in the frame's units.
struct Extent {
    /// Curves that go on to infinity are cut here.
    l_max: f64,
    /// Range of h of the events and of both ends.
    h_scale: f64,
}

impl Atlas {
    /// A polyline of a curve by rising l: points [h, l] in the body's units.
    #[must_use]
    pub fn course(&self, curve: CurveId, options: &CourseOptions) -> Vec<[f64; 2]> {
        let extent = extent(self, options);
        let curve = &self.arrangement.set.curves[curve];
        let [from, to] = curve.x().map(|x| (2.0 * x).sqrt());
        let tolerance =
            Tolerance { h: options.chord_tolerance * extent.h_scale, aspect: extent.l_max / extent.h_scale };
        self.sampled(curve, [from, to.min(extent.l_max)], tolerance)
    }

    /// μ at both ends of a curve by rising μ, in the units of A; `None` where it is infinite, and for pole lines.
    #[must_use]
    pub fn mu_range(&self, curve: CurveId) -> Option<[Option<f64>; 2]> {
        mu_range(self, &self.arrangement.set.curves[curve])
    }

    /// How a curve goes on to infinity; `None` for one with two finite ends.
    #[must_use]
    pub fn tail(&self, curve: CurveId) -> Option<Tail> {
        tail(self, &self.arrangement.set.curves[curve])
    }
}

impl Atlas {
    /// The l up to which curves that go on to infinity are drawn, if nothing else is asked.
    pub(super) fn drawn_up_to(&self) -> f64 {
        let options = CourseOptions { chord_tolerance: 0.0, l_least: 0.0 };
        extent(self, &options).l_max * self.arrangement.set.frame.momentum_unit
    }
}

fn extent(atlas: &Atlas, options: &CourseOptions) -> Extent {
    let frame = &atlas.arrangement.set.frame;
    let last_event = atlas.arrangement.events.last().map_or(0.0, |event| (2.0 * event.x).sqrt());
    let window = options.l_least / frame.momentum_unit;
    // √(r a) is the momentum at which kinetic and potential energy are alike.
    let natural = 3.0 * (frame.r_norm.max(1.0) * frame.a[2]).sqrt();
    let l_max = (1.6 * last_event).max(window).max(natural);
    let h_scale = 0.5 * l_max * l_max / frame.a[2] + 2.0 * frame.r_norm;
    Extent { l_max, h_scale }
}

/// μ at both ends by rising μ, in the units of A; `None` where it is infinite.
fn mu_range(atlas: &Atlas, curve: &Curve) -> Option<[Option<f64>; 2]> {
    let frame = &atlas.arrangement.set.frame;
    let unit = frame.momentum_unit * frame.momentum_unit / frame.energy_unit;
    let mut ends: Vec<f64> = Vec::new();
    for arc in &curve.arcs {
        match &arc.shape {
            Shape::Generic(segments) => {
                for segment in segments {
                    ends.extend(segment.distance.map(|d| frame.a[segment.base] + segment.sign * d));
                }
            }
            Shape::Symmetric { family, .. } => ends.push(frame.a[family.axis]),
            Shape::Straight { gamma, j } => {
                if !matches!(curve.branch, Branch::Axis(_)) {
                    return None;
                }
                // μ = a ± r/s with s = 2x/a².
                let side: f64 = gamma.iter().sum();
                ends.extend(arc.x.map(|x| j + side * frame.r_norm * j * j / (2.0 * x)));
            }
        }
    }
    let mut range =
        [ends.iter().copied().fold(f64::INFINITY, f64::min), ends.iter().copied().fold(f64::NEG_INFINITY, f64::max)];
    // A pitchfork lies at a moment, which is known to all its digits, whatever moment the family is measured from.
    let forks = curve.ends.iter().filter_map(|end| match end {
        End::Pitchfork(number) => Some(frame.a[atlas.arrangement.set.pitchforks[*number].axis]),
        _ => None,
    });
    match forks.collect::<Vec<f64>>()[..] {
        [p, q] => range = [p.min(q), p.max(q)],
        [p] => range[usize::from((range[1] - p).abs() < (range[0] - p).abs())] = p,
        _ => {}
    }
    Some(range.map(|mu| mu.is_finite().then_some(mu * unit)))
}

/// J and h0 of h = l²/(2J) + h0 as l → ∞.
fn tail(atlas: &Atlas, curve: &Curve) -> Option<Tail> {
    let frame = &atlas.arrangement.set.frame;
    if curve.x()[1].is_finite() {
        return None;
    }
    let last = &curve.arcs[curve.arcs.len() - 1];
    let (moment, rho) = match &last.shape {
        Shape::Straight { gamma, j } => (*j, (0..3).map(|k| gamma[k] * frame.r[k]).sum()),
        Shape::Generic(segments) => {
            let segment = segments[segments.len() - 1];
            (frame.a[segment.base], segment.sign * frame.r[segment.base])
        }
        Shape::Symmetric { family, .. } => (frame.a[family.axis], 0.0),
    };
    let unit = frame.momentum_unit * frame.momentum_unit / frame.energy_unit;
    // 0 − ρ, so that ρ = 0 gives 0 and not −0.
    Some(Tail { moment: moment * unit, h_offset: atlas.energy(0.0 - rho) })
}
