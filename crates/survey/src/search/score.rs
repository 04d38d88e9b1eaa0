//! How well a body shows what is sought.

use std::cmp::Ordering;

use super::target::Target;
use crate::design::{BodyFamily, Design};
use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::topology::Component;
use bifdiag_equilibria::curves::Orbit;
use bifdiag_exact::Accuracy;
use bifdiag_numbers::sequence::point;

/// How well a body shows what is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Score {
    /// It does not, and no distance is known.
    Nothing,
    /// It does not; this much is missing. For a component with the right number of circles: the distance in h by which
    /// a pole would have to enter or leave, divided by |r|. For isolated relative equilibria: how many are missing.
    Near(f64),
    /// It does: the distance in h from the boundary of the region, divided by |r| (1 + l²/(2 J_r |r|))², so that large
    /// momenta count for little. For isolated relative equilibria: half the relative width in l² of the range that shows them.
    Shown(f64),
}

impl Score {
    /// Larger is better.
    pub(super) fn value(self) -> f64 {
        match self {
            Self::Nothing => -1e9,
            Self::Near(missing) => -missing,
            Self::Shown(visibility) => 1.0 + visibility,
        }
    }

    /// The better one is greater.
    #[must_use]
    pub fn compare(self, other: Self) -> Ordering {
        self.value().total_cmp(&other.value())
    }
}

/// A score, and where in the (h, l) plane it was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScoredPoint {
    /// The score.
    pub score: Score,
    /// h and l in the body's units.
    pub at: Option<[f64; 2]>,
}

impl ScoredPoint {
    const NOTHING: Self = Self { score: Score::Nothing, at: None };

    fn better(self, other: Self) -> Self {
        if other.score.compare(self.score) == Ordering::Greater { other } else { self }
    }
}

/// Which bodies are tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchDomain {
    /// Only bodies that exist: A_i + A_j > A_k, or equality and r_k = 0.
    pub physical: bool,
    /// The largest moment is at most this many times the smallest.
    pub moment_ratio: f64,
}

impl Default for SearchDomain {
    fn default() -> Self {
        Self { physical: false, moment_ratio: 10.0 }
    }
}

impl SearchDomain {
    /// True for a body of the domain.
    #[must_use]
    pub fn holds(&self, body: &Body) -> bool {
        let moments = body.moments_f64();
        let [smallest, largest] = [f64::min, f64::max].map(|of| moments.into_iter().fold(moments[0], of));
        largest <= self.moment_ratio * smallest && !(self.physical && body.flags().unphysical)
    }
}

/// Looks at a body; `None` for one that is undecided or outside of the domain.
#[must_use]
pub fn look(values: [[f64; 3]; 2], target: &Target, domain: &SearchDomain) -> Option<ScoredPoint> {
    let body = Body::from_f64(values[0], values[1]).ok().filter(|body| domain.holds(body))?;
    let atlas =
        bifdiag_exact::atlas(&body, Accuracy::Fast).ok().filter(|atlas| atlas.arrangement().undecided.is_empty())?;
    Some(match target {
        Target::CriticalPoints(wanted) => critical_points(&atlas, *wanted),
        _ => regions(&atlas, target),
    })
}

fn regions(atlas: &Atlas, target: &Target) -> ScoredPoint {
    let frame = &atlas.arrangement().set.frame;
    let mut best = ScoredPoint::NOTHING;
    for region in atlas.regions() {
        let Ok(components) = &region.components else { continue };
        let sample = &region.sample;
        let at = [sample.h * frame.energy_unit, (2.0 * sample.x).sqrt() * frame.momentum_unit];
        let rotation = 1.0 + sample.x / (frame.j_r * frame.r_norm);
        let visibility = (sample.margin - sample.error) / (frame.r_norm * rotation * rotation);
        let score = if target.accepts_region(components) && visibility > 0.0 {
            Score::Shown(visibility)
        } else {
            missing(atlas, target, components, [sample.x, sample.h, sample.margin])
        };
        best = best.better(ScoredPoint { score, at: Some(at) });
    }
    best
}

/// How far a pole would have to move for a component with the right number of circles to have the right number of poles.
fn missing(atlas: &Atlas, target: &Target, components: &[Component], [x, h, margin]: [f64; 3]) -> Score {
    let frame = &atlas.arrangement().set.frame;
    let Target::Component { circles: Some(circles), poles: Some(wanted) } = target else { return Score::Nothing };
    let mut best = Score::Nothing;
    for component in components.iter().filter(|component| component.boundary_circles == *circles) {
        let Some(poles) = component.poles else { continue };
        let energy = |sign: f64| x / frame.j_r - sign * frame.r_norm;
        let mut distances: Vec<f64> = Vec::new();
        let inside = [(poles.plus, energy(1.0)), (poles.minus, energy(-1.0))];
        if poles.count() > *wanted {
            // A pole that is inside would have to come in no sooner than at the upper end of the region.
            distances.extend(inside.iter().filter(|(inside, _)| *inside).map(|(_, at)| h - margin - at));
        } else {
            distances.extend(inside.iter().filter(|(inside, _)| !*inside).map(|(_, at)| at - (h + margin)));
        }
        distances.sort_by(f64::total_cmp);
        let needed = poles.count().abs_diff(*wanted) as usize;
        if let Some(last) = needed.checked_sub(1).and_then(|last| distances.get(last)) {
            let near = Score::Near((last / frame.r_norm).max(0.0));
            if near.compare(best) == Ordering::Greater {
                best = near;
            }
        }
    }
    best
}

fn critical_points(atlas: &Atlas, wanted: u32) -> ScoredPoint {
    let arrangement = atlas.arrangement();
    let set = &arrangement.set;
    let frame = &set.frame;
    let mut best = ScoredPoint::NOTHING;
    for (number, slab) in arrangement.slabs.pairs() {
        let count: u32 = slab
            .order
            .iter()
            .map(|&c| match set.curves[c].orbit {
                Orbit::Pair(_) => 2,
                Orbit::Point => 1,
                Orbit::Circle(_) | Orbit::Sphere | Orbit::Pole(_) => 0,
            })
            .sum();
        let [from, to] = slab.x;
        let width = if to.is_finite() { (to - from) / (to + from) } else { 1.0 };
        let score = if count >= wanted { Score::Shown(width) } else { Score::Near(f64::from(wanted - count)) };
        let x = if to.is_finite() && from > 0.0 { 0.5 * (from + to) } else { arrangement.middle(number) };
        let heights: Vec<f64> = slab.order.iter().map(|&c| set.curves[c].point(frame, x).h()).collect();
        let widest = heights.windows(2).max_by(|p, q| (p[1] - p[0]).total_cmp(&(q[1] - q[0])));
        let Some(h) = widest.map(|pair| 0.5 * (pair[0] + pair[1])) else { continue };
        let at = [h * frame.energy_unit, (2.0 * x).sqrt() * frame.momentum_unit];
        best = best.better(ScoredPoint { score, at: Some(at) });
    }
    best
}

/// 10^(−4u).
fn tiny(u: f64) -> f64 {
    libm::exp(-4.0 * std::f64::consts::LN_10 * u)
}

/// A and r of body n of the search, from four strata cyclically: the whole family, r near a principal axis, two moments
/// nearly equal, and r in a principal plane or on an axis.
#[must_use]
pub fn sample(n: u64, seed: u64, physical: bool) -> [[f64; 3]; 2] {
    let family = if physical { BodyFamily::General } else { BodyFamily::Positive };
    let design = Design { family, vary: Vec::new(), samples: Some(u64::MAX), seed };
    let (stratum, k) = (n % 4, n / 4);
    let [a, r] = design.values(k);
    let u = point(k, 4, seed.wrapping_add(1 + stratum));
    let axis = usize::try_from(k % 3).unwrap_or_default();
    match stratum {
        0 => [a, r],
        1 => {
            let mut r = [1.0; 3];
            r[(axis + 1) % 3] = tiny(u[2]);
            r[(axis + 2) % 3] = tiny(u[3]);
            [a, r]
        }
        2 => {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let third = if physical { 2.0 } else { 4.0 } * u[1];
            [[1.0, 1.0 + sign * 0.5 * tiny(u[0]), third], r]
        }
        _ => {
            let mut r = r;
            r[axis] = 0.0;
            if k % 4 == 0 {
                r[(axis + 1) % 3] = 0.0;
            }
            [a, r]
        }
    }
}
