//! Stretches of equal stability along a branch.

use super::location::GOLDEN;
use super::report::{Effort, StabilityStretch, Vertex, VertexKind};
use super::samples::{Gap, Sample, Segment, beside_event, shares};
use crate::stability::Stability;

/// Evaluations spent on the search for a change between two samples with the same stability.
const BUBBLE_EVALUATIONS: usize = 24;

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
    /// The last gap between samples, if the branch goes on from there with the same stability.
    last: Option<Gap<'f>>,
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
            self.last = None;
        } else if from.kind != VertexKind::Regular {
            self.depart(segment, from, to, effort);
        } else if self.degenerate.is_some() {
            self.settle(Some(to.stability));
        } else if from.index == Some(2) || from.stability != to.stability {
            self.walk(segment, [from, to], [from.stability, to.stability], effort);
        }
    }

    fn arrive(&mut self, segment: &Segment<'f>, from: &Vertex, event: &Vertex, effort: &mut Effort) {
        if from.index == Some(2) && from.stability != Stability::Degenerate {
            let arriving = beside_event(segment.branch.frame, event).unwrap_or(from.stability);
            self.walk(segment, [from, event], [from.stability, arriving], effort);
        } else if self.stability.is_none()
            && self.degenerate.is_some_and(|(_, _, count)| count == 1)
            && let Some((_, middle)) = segment.at(0.5 * segment.step, effort)
            && middle.stability() != Stability::Degenerate
        {
            // Two events in a row: the stability in between is known from neither.
            self.stability = Some(middle.stability());
            self.degenerate = None;
        }
        self.last = None;
        self.settle(None);
        self.close(event.l, None);
        self.degenerate = Some((event.l, event.l, 1));
    }

    fn depart(&mut self, segment: &Segment<'f>, event: &Vertex, to: &Vertex, effort: &mut Effort) {
        if to.index == Some(2) {
            let departing = beside_event(segment.branch.frame, event).unwrap_or(to.stability);
            self.settle(Some(departing));
            self.walk(segment, [event, to], [departing, to.stability], effort);
        } else {
            self.settle(Some(to.stability));
        }
    }

    /// Looks at the stability in small steps from one end of a segment to the other.
    fn walk(&mut self, segment: &Segment<'f>, ends: [&Vertex; 2], [first, last]: [Stability; 2], effort: &mut Effort) {
        // At the ends the stability is known from the vertices, or from the event there.
        let look = |step: f64, known: Option<Stability>, effort: &mut Effort| {
            let sample = segment.look(step, effort)?;
            Some(Sample { stability: known.unwrap_or(sample.stability), ..sample })
        };
        let Some(mut from) = look(0.0, Some(first), effort) else { return };
        for share in shares(segment, ends[0], ends[1]) {
            let sample = look(segment.step * share, (share == 1.0).then_some(last), effort);
            let Some(to) = sample.filter(|to| to.stability != Stability::Degenerate) else { continue };
            self.pass(&Gap { segment: *segment, from, to, fine: false }, effort);
            from = to;
        }
    }

    /// Goes from one sample to the next.
    ///
    /// Two changes between neighbouring samples leave no trace at them but a dip of the margin, which shows at a sample
    /// that is lower than its neighbours, or next to a change.
    fn pass(&mut self, gap: &Gap<'f>, effort: &mut Effort) {
        let Gap { segment, from, to, fine } = *gap;
        if from.stability != to.stability && !fine {
            self.refine(gap, effort);
            return;
        }
        let last = self.last.take();
        let like = from.stability;
        let falls = last.as_ref().is_none_or(|last| from.margin(like) <= last.from.margin(like));
        let changes = from.stability != to.stability;
        let rises = changes || from.margin(like) <= to.margin(like);
        if falls && rises {
            if let Some(last) = last {
                self.search_bubble(&last, effort);
            }
            if !changes {
                self.search_bubble(gap, effort);
            }
        }
        if changes {
            self.locate_changes(&segment, from, to, effort);
        } else {
            self.last = Some(*gap);
        }
    }

    /// Goes through a gap in which the stability changes in smaller steps: there may be more changes than one.
    fn refine(&mut self, gap: &Gap<'f>, effort: &mut Effort) {
        let Gap { segment, mut from, to, .. } = *gap;
        let start = from.step;
        for share in [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0] {
            let next = if share == 1.0 { Some(to) } else { segment.look(start + share * (to.step - start), effort) };
            let Some(next) = next.filter(|next| next.stability != Stability::Degenerate) else { continue };
            self.pass(&Gap { segment, from, to: next, fine: true }, effort);
            from = next;
        }
    }

    /// Finds the changes of stability between two samples by bisection.
    fn locate_changes(&mut self, segment: &Segment, from: Sample, to: Sample, effort: &mut Effort) {
        let (mut low, mut current) = (from.step, from.stability);
        while current != to.stability {
            let (mut inside, mut outside, mut next) = (low, to.step, to.stability);
            let mut l = segment.at(to.step, effort).map_or(segment.l[1], |(l, _)| l);
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

    /// Follows the margin down to its minimum inside the gap; if another stability lies there,
    /// inserts it with both its borders.
    fn search_bubble(&mut self, gap: &Gap, effort: &mut Effort) {
        let Gap { segment, from, to, .. } = gap;
        let probe = |step: f64, effort: &mut Effort| segment.look(step, effort);
        let (mut low, mut high) = (from.step, to.step);
        let Some(mut left) = probe(low + GOLDEN * (high - low), effort) else { return };
        let Some(mut right) = probe(high - GOLDEN * (high - low), effort) else { return };
        for _ in 0..BUBBLE_EVALUATIONS {
            for sample in [left, right] {
                if sample.stability != from.stability && sample.stability != Stability::Degenerate {
                    self.locate_changes(segment, *from, sample, effort);
                    self.locate_changes(segment, sample, *to, effort);
                    return;
                }
            }
            if left.margin(from.stability) < right.margin(from.stability) {
                high = right.step;
                right = left;
                let Some(found) = probe(low + GOLDEN * (high - low), effort) else { return };
                left = found;
            } else {
                low = left.step;
                left = right;
                let Some(found) = probe(high - GOLDEN * (high - low), effort) else { return };
                right = found;
            }
        }
    }

    pub fn finish(mut self, l: f64) -> Vec<StabilityStretch> {
        self.settle(None);
        self.close(l, None);
        self.done
    }
}
