//! Two arcs over a common range of x, evaluated.

use super::node::{GapAt, Node};
use super::pole;
use bifdiag_body::Frame;
use bifdiag_equilibria::curves::{Arc, Asymptote, Gap, Mu, Point, Shape};
use bifdiag_numbers::UNIT_ROUNDOFF;

/// Two arcs over a common range of x.
#[derive(Clone, Copy)]
pub(super) struct ArcPair<'a> {
    pub frame: &'a Frame,
    pub a: &'a Arc,
    pub b: &'a Arc,
    /// A common end of the two arcs: a cusp or a pitchfork.
    pub joint: Option<f64>,
}

impl ArcPair<'_> {
    /// The node at x, which may be 0 or ∞.
    pub fn node(&self, x: f64) -> Node {
        if x == 0.0 {
            return Node {
                x,
                gap: self.gap_at_origin(),
                slope: [self.a.slope[0], self.b.slope[0]],
                slope_gap: None,
                proved: None,
            };
        }
        if x.is_infinite() {
            let slope = [self.a.slope[1], self.b.slope[1]];
            return Node { x, gap: self.gap_at_infinity(), slope, slope_gap: self.final_slope_gap(), proved: None };
        }
        let at = [self.a, self.b].map(|arc| arc.point_and_mu(self.frame, x));
        let [(p, _), (q, _)] = at;
        let end_slope = |arc: &Arc, point: &Point| {
            // At a common end both arcs take the slope of the end itself.
            if x == arc.x[0] {
                arc.slope[0]
            } else if x == arc.x[1] {
                arc.slope[1]
            } else {
                point.slope()
            }
        };
        let refined = pole_gaps(self.frame, [self.a, self.b], &at);
        let plain = Gap::between(self.frame, &p, &q);
        let gap = match refined {
            _ if self.joint == Some(x) => GapAt::Joined,
            Some([gap, _]) if gap.error < plain.error => GapAt::Value(gap),
            _ => GapAt::Value(plain),
        };
        let slope = [end_slope(self.a, &p), end_slope(self.b, &q)];
        Node { x, gap, slope, slope_gap: refined.map(|[_, slope]| slope), proved: None }
    }

    /// At l = 0 a curve starts at h = −⟨γ, r⟩ with γ = ±r̂, or at 0 when r = 0.
    fn gap_at_origin(&self) -> GapAt {
        let height = |arc: &Arc| match &arc.shape {
            Shape::Straight { gamma, .. } => -(0..3).map(|k| gamma[k] * self.frame.r[k]).sum::<f64>(),
            Shape::Generic(segments) => -segments[0].sign * self.frame.r_norm,
            Shape::Symmetric { .. } => 0.0,
        };
        let (p, q) = (height(self.a), height(self.b));
        if (p > 0.0) == (q > 0.0) && (p < 0.0) == (q < 0.0) {
            return GapAt::Joined;
        }
        let error = 8.0 * UNIT_ROUNDOFF * (p.abs() + q.abs());
        GapAt::Value(Gap { value: p - q, error })
    }

    /// As l → ∞, h = x/J∞ − ρ∞ + O(1/x) (Proposition 6.2).
    fn gap_at_infinity(&self) -> GapAt {
        let (p, q) = (self.limit(self.a), self.limit(self.b));
        let moment_gap = p.moment_gap(self.frame, &q);
        if moment_gap != 0.0 {
            return GapAt::Infinite(moment_gap.total_cmp(&0.0));
        }
        let error = 8.0 * UNIT_ROUNDOFF * (p.rho.abs() + q.rho.abs());
        GapAt::Limit(Gap { value: q.rho - p.rho, error })
    }

    /// The limit of the difference of slopes of a pole line and a curve: 1/J_r − 1/a = (a − J_r)/(a J_r).
    fn final_slope_gap(&self) -> Option<Gap> {
        let frame = self.frame;
        let (axis, sign) = match (self.limit(self.a).axis, self.limit(self.b).axis) {
            (None, Some(axis)) => (axis, 1.0),
            (Some(axis), None) => (axis, -1.0),
            _ => return None,
        };
        let value = sign * frame.offset[axis] / (frame.a[axis] * frame.j_r);
        Some(Gap { value, error: 8.0 * UNIT_ROUNDOFF * value.abs() })
    }

    pub fn limit(&self, arc: &Arc) -> Asymptote {
        arc.asymptote(self.frame)
    }

    /// How far h − x/J∞ is from its limit −ρ∞; it approaches monotonically.
    pub fn deviation(&self, arc: &Arc, x: f64) -> f64 {
        let limit = self.limit(arc);
        let Some(axis) = limit.axis else { return 0.0 };
        let mut gamma = [0.0; 3];
        gamma[axis] = if limit.rho < 0.0 { -1.0 } else { 1.0 };
        let mut asymptote = Point::over(self.frame, x, gamma, self.frame.a[axis]);
        asymptote.rho = limit.rho;
        let gap = Gap::between(self.frame, &arc.point(self.frame, x), &asymptote);
        gap.value.abs() + gap.error
    }
}

/// Gap and difference of slopes of a pole line and an arc of a critical curve near it.
pub(super) fn pole_gaps(
    frame: &Frame,
    [a, b]: [&Arc; 2],
    [(p, p_mu), (q, q_mu)]: &[(Point, Option<Mu>); 2],
) -> Option<[Gap; 2]> {
    let is_line = |arc: &Arc| matches!(arc.shape, Shape::Straight { .. });
    match (is_line(a), is_line(b)) {
        (true, false) => pole::gaps(frame, p, q, (*q_mu)?),
        (false, true) => {
            let gaps = pole::gaps(frame, q, p, (*p_mu)?)?;
            Some(gaps.map(|gap| Gap { value: -gap.value, ..gap }))
        }
        _ => None,
    }
}
