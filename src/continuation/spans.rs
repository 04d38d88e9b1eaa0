//! Stretches of equal stability along a branch.

use super::branch::{Branch, Point, Tangent};
use super::report::{Effort, StabilityStretch, Vertex, VertexKind};
use crate::body::Frame;
use crate::document::Stability;
use crate::stability::Linearisation;

/// Evaluations spent on the search for a change between two vertices with the same stability.
const BUBBLE_EVALUATIONS: usize = 24;
/// A separation of the pairs above this share of its largest value is not followed down.
const BUBBLE_SUSPECT: f64 = 0.3;
/// Golden section.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

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
    fn at(&self, step: f64, effort: &mut Effort) -> Option<(f64, Linearisation)> {
        let point = self.branch.advance(&self.base, &self.tangent, step, effort)?;
        let linearisation = Linearisation::new(self.branch.frame, &self.branch.equilibrium(&point));
        // The length of a step to a landing is known to second order only; nothing lies beyond its end.
        let [from, to] = self.l;
        Some((self.branch.l(&point).clamp(from.min(to), from.max(to)), linearisation))
    }
}

/// (b² − 4c)/(b² + 4|c|): how far apart the two pairs are, negative for a quadruple.
fn separation(linearisation: &Linearisation) -> f64 {
    linearisation.discriminant() / (linearisation.b * linearisation.b + 4.0 * linearisation.c.abs())
}

/// The stability next to an event on the side of even index: c → 0 leaves λ² = −b beside a pair near zero.
fn beside_event(frame: &Frame, event: &Vertex) -> Option<Stability> {
    let Linearisation { b, b_error, .. } = Linearisation::new(frame, &event.equilibrium);
    if b > b_error {
        Some(Stability::Elliptic)
    } else if b < -b_error {
        Some(Stability::Saddle)
    } else {
        None
    }
}

/// Collects stretches vertex by vertex.
///
/// A single degenerate vertex is a point where the stability changes or is touched; two and more in a row are
/// a degenerate stretch (a circle of relative equilibria, or more than rounding can tell).
#[derive(Debug, Default)]
pub(super) struct Stretches<'f> {
    done: Vec<StabilityStretch>,
    /// Start of the open stretch.
    from: f64,
    /// Its stability, once a vertex has told it.
    stability: Option<Stability>,
    /// First and last of the degenerate vertices since the last definite one, and their number.
    degenerate: Option<(f64, f64, usize)>,
    /// The last segment if both its ends are of index 2 and equal stability, with the separations at them.
    last: Option<(Segment<'f>, [f64; 2])>,
}

impl<'f> Stretches<'f> {
    pub fn begin(&mut self, vertex: &Vertex) {
        self.from = vertex.l;
        if vertex.stability == Stability::Degenerate {
            self.degenerate = Some((vertex.l, vertex.l, 1));
        } else {
            self.stability = Some(vertex.stability);
        }
    }

    fn close(&mut self, l: f64, next: Option<Stability>) {
        if let Some(stability) = self.stability
            && self.from != l
        {
            self.done.push(StabilityStretch { l_from: self.from, l_to: l, stability });
        }
        self.from = l;
        self.stability = next;
    }

    /// Ends a row of degenerate vertices at a definite one, or at the end of a stretch.
    fn settle(&mut self, next: Option<Stability>) {
        let Some((first, last, count)) = self.degenerate.take() else { return };
        if count > 1 {
            if self.stability.is_none() {
                self.from = first;
                self.stability = Some(Stability::Degenerate);
            } else {
                self.close(first, Some(Stability::Degenerate));
            }
            self.close(last, next);
        } else if self.stability.is_none() {
            self.stability = next;
        } else if next.is_some() && next != self.stability {
            self.close(first, next);
        }
    }

    /// Goes on along `segment`, from one vertex to the next.
    pub fn extend(&mut self, segment: &Segment<'f>, from: &Vertex, to: &Vertex, effort: &mut Effort) {
        if to.kind != VertexKind::Regular {
            // l turns at a cusp, and the index changes at a pitchfork: the stretch ends there.
            self.arrive(segment, from, to, effort);
        } else if to.stability == Stability::Degenerate {
            let (first, _, count) = self.degenerate.unwrap_or((to.l, to.l, 0));
            self.degenerate = Some((first, to.l, count + 1));
        } else if from.kind != VertexKind::Regular {
            self.depart(segment, from, to, effort);
        } else if self.degenerate.is_some() {
            self.settle(Some(to.stability));
        } else if from.stability != to.stability {
            self.locate_changes(segment, from.stability, (segment.step, to.stability), effort);
        }
        self.look_back(segment, from, to, effort);
    }

    fn arrive(&mut self, segment: &Segment, from: &Vertex, event: &Vertex, effort: &mut Effort) {
        if from.stability != Stability::Degenerate {
            let arriving = if from.stability == Stability::SaddleCentre {
                Some(Stability::SaddleCentre)
            } else {
                beside_event(segment.branch.frame, event)
            };
            if let Some(arriving) = arriving
                && arriving != from.stability
            {
                self.locate_changes(segment, from.stability, (segment.step, arriving), effort);
            }
        } else if self.stability.is_none()
            && self.degenerate.is_some_and(|(_, _, count)| count == 1)
            && let Some((_, middle)) = segment.at(0.5 * segment.step, effort)
            && middle.stability() != Stability::Degenerate
        {
            // Two events in a row: the stability in between is known from neither.
            self.stability = Some(middle.stability());
            self.degenerate = None;
        }
        self.settle(None);
        self.close(event.l, None);
        self.degenerate = Some((event.l, event.l, 1));
    }

    fn depart(&mut self, segment: &Segment, event: &Vertex, to: &Vertex, effort: &mut Effort) {
        let departing = if to.stability == Stability::SaddleCentre {
            to.stability
        } else {
            beside_event(segment.branch.frame, event).unwrap_or(to.stability)
        };
        self.settle(Some(departing));
        if departing != to.stability {
            self.locate_changes(segment, departing, (segment.step, to.stability), effort);
        }
    }

    /// Finds the changes from the stability `current` at the base to `end` = (step, stability) by bisection.
    fn locate_changes(&mut self, segment: &Segment, current: Stability, end: (f64, Stability), effort: &mut Effort) {
        self.locate_changes_from(segment, (0.0, current), end, effort);
    }

    fn locate_changes_from(
        &mut self,
        segment: &Segment,
        (mut low, mut current): (f64, Stability),
        (end, last): (f64, Stability),
        effort: &mut Effort,
    ) {
        while current != last {
            let (mut inside, mut outside, mut next) = (low, end, last);
            let mut l = segment.at(end, effort).map_or(segment.l[1], |(l, _)| l);
            while (outside - inside).abs() > 1e-14 * segment.step.abs() {
                let middle = 0.5 * (inside + outside);
                if middle == inside || middle == outside {
                    break;
                }
                let Some((l_middle, linearisation)) = segment.at(middle, effort) else { break };
                let here = linearisation.stability();
                if here == current {
                    inside = middle;
                    continue;
                }
                (outside, l) = (middle, l_middle);
                if here == Stability::Degenerate {
                    // The boundary itself; what follows it is known already.
                    break;
                }
                next = here;
            }
            self.close(l, Some(next));
            (low, current) = (outside, next);
        }
    }

    /// Two changes between neighbouring vertices leave no trace at the vertices but a dip of the separation of
    /// the pairs. Looks for them in the last segment and this one if the vertex between them is lower than its neighbours.
    fn look_back(&mut self, segment: &Segment<'f>, from: &Vertex, to: &Vertex, effort: &mut Effort) {
        let last = self.last.take();
        let plain = |vertex: &Vertex| vertex.kind == VertexKind::Regular && vertex.index == Some(2);
        if !(plain(from) && plain(to) && from.stability == to.stability && to.stability != Stability::Degenerate) {
            return;
        }
        let at = |vertex: &Vertex| separation(&Linearisation::new(segment.branch.frame, &vertex.equilibrium)).abs();
        let ends = [last.as_ref().map_or_else(|| at(from), |(_, ends)| ends[1]), at(to)];
        if let Some((before, [first, middle])) = &last
            && middle < first
            && *middle <= ends[1]
            && *middle < BUBBLE_SUSPECT
        {
            self.search_bubble(before, from.stability, effort);
            self.search_bubble(segment, from.stability, effort);
        }
        self.last = Some((*segment, ends));
    }

    /// Follows the separation of the pairs down to its minimum inside the segment; if another stability lies there,
    /// inserts it with both its borders.
    fn search_bubble(&mut self, segment: &Segment, outside: Stability, effort: &mut Effort) {
        let probe = |step: f64, effort: &mut Effort| {
            segment.at(step, effort).map(|(_, linearisation)| (linearisation.stability(), separation(&linearisation)))
        };
        let (mut low, mut high) = (0.0, segment.step);
        let mut left = low + GOLDEN * (high - low);
        let mut right = high - GOLDEN * (high - low);
        let (Some(mut at_left), Some(mut at_right)) = (probe(left, effort), probe(right, effort)) else { return };
        for _ in 0..BUBBLE_EVALUATIONS {
            for (step, (stability, _)) in [(left, at_left), (right, at_right)] {
                if stability != outside && stability != Stability::Degenerate {
                    self.locate_changes_from(segment, (0.0, outside), (step, stability), effort);
                    self.locate_changes_from(segment, (step, stability), (segment.step, outside), effort);
                    return;
                }
            }
            // A quadruple away from its borders has a large |separation|: the sign matters.
            if at_left.1 < at_right.1 {
                high = right;
                (right, at_right) = (left, at_left);
                left = low + GOLDEN * (high - low);
                let Some(found) = probe(left, effort) else { return };
                at_left = found;
            } else {
                low = left;
                (left, at_left) = (right, at_right);
                right = high - GOLDEN * (high - low);
                let Some(found) = probe(right, effort) else { return };
                at_right = found;
            }
        }
    }

    pub fn finish(mut self, l: f64) -> Vec<StabilityStretch> {
        self.settle(None);
        self.close(l, None);
        self.done
    }
}
