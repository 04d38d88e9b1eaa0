//! Looks at the linearised flow between two vertices.

use super::branch::{Branch, Point, Tangent};
use super::report::{Effort, Vertex, VertexKind};
use crate::body::Frame;
use crate::stability::Linearisation;
use crate::stability::Stability;

/// The stability is looked at this often along a branch of index 2, the only one on which it can change.
const SPACING: f64 = 0.125;

/// The part of the branch between two vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<'f> {
    pub branch: Branch<'f>,
    pub base: Point,
    pub tangent: Tangent,
    /// Length of the step along the tangent, with its sign.
    pub step: f64,
    /// l at both ends.
    pub l: [f64; 2],
}

impl Segment<'_> {
    /// The sample at a step.
    pub fn look(&self, step: f64, effort: &mut Effort) -> Option<Sample> {
        let (_, linearisation) = self.at(step, effort)?;
        Some(Sample { step, stability: linearisation.stability(), separation: separation(&linearisation) })
    }

    pub fn at(&self, step: f64, effort: &mut Effort) -> Option<(f64, Linearisation)> {
        let point = self.branch.advance(&self.base, &self.tangent, step, effort)?;
        let linearisation = Linearisation::new(self.branch.frame, &self.branch.equilibrium(&point));
        // The length of a step to a landing is known to second order only; nothing lies beyond its end.
        let [from, to] = self.l;
        Some((self.branch.l(&point).clamp(from.min(to), from.max(to)), linearisation))
    }
}

/// A look at the linearised flow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub step: f64,
    pub stability: Stability,
    /// [`separation`].
    pub separation: f64,
}

impl Sample {
    /// How far the separation is on this side of zero: negative for another stability than `like`.
    pub fn margin(&self, like: Stability) -> f64 {
        if like == Stability::Complex { -self.separation } else { self.separation }
    }
}

/// Two neighbouring samples on a segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap<'f> {
    pub segment: Segment<'f>,
    pub from: Sample,
    pub to: Sample,
    /// Whether it is part of a larger gap in which the stability changes.
    pub fine: bool,
}

/// How often the looks at a segment halve their distance to this end. Next to l = 0 the scale of changes may be any:
/// a difference of moments as small as you like decides it. Next to an event the stability goes with the square root
/// of the distance in l.
fn halvings(end: &Vertex) -> usize {
    if end.equilibrium.omega == 0.0 {
        20
    } else if end.kind == VertexKind::Regular {
        0
    } else {
        8
    }
}

/// Where to look on a segment, as shares of its step, the end last.
pub(super) fn shares(segment: &Segment, from: &Vertex, to: &Vertex) -> Vec<f64> {
    let count = (segment.step.abs() / SPACING).ceil().clamp(1.0, 64.0);
    let closing_in = |number| std::iter::successors(Some(0.5), |x| Some(0.5 * x)).take(number);
    let mut shares: Vec<f64> = closing_in(halvings(from)).map(|x| x / count).collect();
    shares.reverse();
    let mut number = 1.0;
    while number < count {
        shares.push(number / count);
        number += 1.0;
    }
    shares.extend(closing_in(halvings(to)).map(|x| 1.0 - x / count));
    shares.push(1.0);
    shares
}

/// (b² − 4c)/(b² + 4|c|): how far apart the two pairs are, negative for a quadruple.
fn separation(linearisation: &Linearisation) -> f64 {
    linearisation.discriminant() / (linearisation.b * linearisation.b + 4.0 * linearisation.c.abs())
}

/// The stability next to an event on the side of even index: c → 0 leaves λ² = −b beside a pair near zero.
pub(super) fn beside_event(frame: &Frame, event: &Vertex) -> Option<Stability> {
    let Linearisation { b, b_error, .. } = Linearisation::new(frame, &event.equilibrium);
    if b > b_error {
        Some(Stability::Elliptic)
    } else if b < -b_error {
        Some(Stability::Saddle)
    } else {
        None
    }
}
