//! Stretches of equal stability along a branch.

use super::branch::{Branch, Point, Tangent};
use super::report::{Effort, StabilityStretch, Vertex, VertexKind};
use crate::document::Stability;
use crate::stability::Linearisation;

/// The part of the branch between two vertices.
pub(super) struct Segment<'s> {
    pub branch: &'s Branch<'s>,
    pub base: &'s Point,
    pub tangent: &'s Tangent,
    /// Length of the step along the tangent, with its sign.
    pub step: f64,
}

/// Collects stretches vertex by vertex.
///
/// A single degenerate vertex is a point where the stability changes or is touched; two and more in a row are
/// a degenerate stretch (a circle of relative equilibria, or more than rounding can tell).
#[derive(Debug, Default)]
pub(super) struct Stretches {
    done: Vec<StabilityStretch>,
    /// Start of the open stretch.
    from: f64,
    /// Its stability, once a vertex has told it.
    stability: Option<Stability>,
    /// First and last of the degenerate vertices since the last definite one, and their number.
    degenerate: Option<(f64, f64, usize)>,
}

impl Stretches {
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
    pub fn extend(&mut self, segment: &Segment, from: &Vertex, to: &Vertex, effort: &mut Effort) {
        if to.kind != VertexKind::Regular {
            // l turns at a cusp, and the index changes at a pitchfork: the stretch ends there.
            self.settle(None);
            self.close(to.l, None);
            self.degenerate = Some((to.l, to.l, 1));
        } else if to.stability == Stability::Degenerate {
            let (first, _, count) = self.degenerate.unwrap_or((to.l, to.l, 0));
            self.degenerate = Some((first, to.l, count + 1));
        } else if self.degenerate.is_some() {
            self.settle(Some(to.stability));
        } else if from.stability != to.stability {
            self.locate_changes(segment, from, to, effort);
        }
    }

    fn locate_changes(&mut self, segment: &Segment, from: &Vertex, to: &Vertex, effort: &mut Effort) {
        let Segment { branch, base, tangent, step } = *segment;
        let mut low = 0.0;
        let mut current = from.stability;
        while current != to.stability {
            let (mut high, mut next, mut l) = (step, to.stability, to.l);
            let mut inside = low;
            loop {
                let middle = 0.5 * (inside + high);
                if middle == inside || middle == high || (high - inside).abs() <= 1e-14 * step.abs() {
                    break;
                }
                let Some(point) = branch.advance(base, tangent, middle, effort) else { break };
                let here = Linearisation::new(branch.frame, &branch.equilibrium(&point)).stability();
                if here == current {
                    inside = middle;
                } else {
                    high = middle;
                    l = branch.l(&point);
                    // A degenerate point is the boundary itself; what follows it is known already.
                    if here == Stability::Degenerate {
                        inside = middle;
                    } else {
                        next = here;
                    }
                }
            }
            // A landing is known to second order only: nothing may change beyond it.
            let l = if from.l <= to.l { l.min(to.l) } else { l.max(to.l) };
            self.close(l, Some(next));
            current = next;
            low = high;
        }
    }

    pub fn finish(mut self, l: f64) -> Vec<StabilityStretch> {
        let only_degenerate = self.stability.is_none() && self.degenerate.is_some_and(|(_, _, count)| count > 1);
        if only_degenerate {
            self.stability = Some(Stability::Degenerate);
            self.degenerate = None;
        }
        self.settle(None);
        self.close(l, None);
        self.done
    }
}
