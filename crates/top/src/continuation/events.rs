//! What happens between two vertices: cusps, pitchforks, the ends of the branch and of the range of l.

use super::branch::{Kind, Point, Tangent};
use super::corrector::Condition;
use super::location::{Bracket, GOLDEN};
use super::options::AtEvent;
use super::report::{Pitchfork, StopReason, VertexKind};
use super::tracker::{Step, Tracker};
use crate::body::Axis;

/// dl/(J Ω) along the tangent below which a step may hide a pair of cusps.
const FOLD_SUSPECT: f64 = 0.2;
/// Where the slope at the end of a step is felt, as a share of it.
const FOLD_PROBE: f64 = 1.0 / 32.0;
/// Evaluations spent on following a dip down: it is located to a thousandth of the step.
const FOLD_EVALUATIONS: usize = 14;

/// What lies between the base point and the end of a step.
pub(super) enum Event {
    Cusp,
    Pitchfork,
    /// The branch ends or leaves the range of l: land on it.
    Landing(StopReason),
}

impl Tracker<'_> {
    /// Whether two cusps hide between the base and `end`. The turning function has the same sign at both then, and dips
    /// in between; the dip shows at the end where the value is smaller, and is followed down by golden section.
    pub(super) fn hides_a_fold(&mut self, end: &Point, tangent: &Tangent, signed: f64) -> bool {
        if matches!(self.branch.kind, Kind::Pair { .. }) {
            return false;
        }
        let from = self.branch.turning(&self.base, &self.tangent) * self.turning_sign;
        let to = self.branch.turning(end, tangent) * self.turning_sign;
        let small = from.min(to);
        if small > FOLD_SUSPECT || to <= 0.0 {
            return false;
        }
        let [near, far] = if from < to { [0.0, signed] } else { [signed, 0.0] };
        // None where the corrector fails: nothing to be seen there.
        let mut turning = |share: f64| {
            let point =
                self.branch.advance(&self.base, &self.tangent, near + share * (far - near), &mut self.effort)?;
            Some(self.branch.turning(&point, &self.branch.tangent(&point)) * self.turning_sign)
        };
        let Some(probe) = turning(FOLD_PROBE) else { return false };
        if probe <= 0.0 || probe >= small {
            // Rising from here: the smaller end is the minimum. At a cusp itself the value is noise.
            return probe <= 0.0 && small > 0.0;
        }
        let (mut low, mut high) = (0.0, 1.0);
        let (mut left, mut right) = (GOLDEN, 1.0 - GOLDEN);
        let (Some(mut at_left), Some(mut at_right)) = (turning(left), turning(right)) else { return false };
        for _ in 0..FOLD_EVALUATIONS {
            if at_left <= 0.0 || at_right <= 0.0 {
                return true;
            }
            if at_left < at_right {
                high = right;
                (right, at_right) = (left, at_left);
                left = low + GOLDEN * (high - low);
                let Some(value) = turning(left) else { return false };
                at_left = value;
            } else {
                low = left;
                (left, at_left) = (right, at_right);
                right = high - GOLDEN * (high - low);
                let Some(value) = turning(right) else { return false };
                at_right = value;
            }
        }
        false
    }

    /// Everything between the base point and `end`; the one to handle first comes last.
    pub(super) fn events(&self, end: &Point, tangent: &Tangent) -> Vec<Event> {
        let mut events = Vec::new();
        let l = self.branch.l(end);
        if let Kind::Pair { axis } = self.branch.kind
            && end.gamma[axis] <= 0.0
        {
            events.push(Event::Landing(StopReason::Pitchfork));
        } else if end.omega <= 0.0 && self.options.l_min <= 0.0 {
            events.push(Event::Landing(StopReason::Rest));
        } else if l >= self.options.l_max && l > self.last().l {
            events.push(Event::Landing(StopReason::MaximumReached));
        } else if l <= self.options.l_min && l < self.last().l {
            events.push(Event::Landing(StopReason::MinimumReached));
        }
        let gaps = self.branch.gaps(end);
        if (0..3).any(|j| self.branch.frozen[j] && gaps[j] * self.frozen_sign[j] < 0.0) {
            events.push(Event::Pitchfork);
        }
        if self.branch.turning(end, tangent) * self.turning_sign < 0.0 {
            events.push(Event::Cusp);
        }
        events
    }

    pub(super) fn handle(&mut self, event: &Event, end: Point, tangent: &Tangent, signed: f64) -> Step {
        match event {
            Event::Landing(reason) => self.land(*reason, end),
            Event::Cusp => self.cusp(end, tangent, signed),
            Event::Pitchfork => self.pitchfork(end, signed),
        }
    }

    fn cusp(&mut self, end: Point, tangent: &Tangent, signed: f64) -> Step {
        let branch = self.branch;
        let far = branch.turning(&end, tangent);
        let turning = |point: &Point| branch.turning(point, &branch.tangent(point));
        let Some(near) = self.near_end(turning, self.turning_sign, VertexKind::Cusp, signed) else {
            return Step::Rejected { factor: 0.5 };
        };
        let ends = [near, Bracket { step: signed, value: far }];
        let Some(point) = branch.locate(&self.base, &self.tangent, ends, end, turning, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let outcome = self.accept(point, VertexKind::Cusp);
        if matches!(outcome, Step::Accepted) {
            self.turning_sign = -self.turning_sign;
            if self.options.at_cusp == AtEvent::Stop {
                return Step::Stopped(StopReason::Cusp);
            }
        }
        outcome
    }

    fn pitchfork(&mut self, end: Point, signed: f64) -> Step {
        let branch = self.branch;
        let (near, far) = (branch.gaps(&self.base), branch.gaps(&end));
        let frozen_sign = self.frozen_sign;
        let crossed = |j: &Axis| branch.frozen[*j] && far[*j] * frozen_sign[*j] < 0.0;
        // The first one on the way; others at the same point (equal moments) go with it.
        let share = |j: Axis| near[j] / (near[j] - far[j]);
        let Some(axis) = Axis::ALL.into_iter().filter(crossed).min_by(|&i, &j| share(i).total_cmp(&share(j))) else {
            return Step::Rejected { factor: 0.5 };
        };
        let gap = |point: &Point| branch.gaps(point)[axis];
        let Some(near) = self.near_end(gap, self.frozen_sign[axis], VertexKind::Pitchfork, signed) else {
            return Step::Rejected { factor: 0.5 };
        };
        let ends = [near, Bracket { step: signed, value: far[axis] }];
        let Some(point) = branch.locate(&self.base, &self.tangent, ends, end, gap, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let meeting: Vec<Axis> =
            Axis::ALL.into_iter().filter(crossed).filter(|&j| branch.frame.diff[axis][j] == 0.0).collect();
        let outcome = self.accept(point, VertexKind::Pitchfork);
        if matches!(outcome, Step::Accepted) {
            for axis in meeting {
                self.frozen_sign[axis] = -self.frozen_sign[axis];
                self.pitchforks.push(Pitchfork { vertex: self.vertices.len() - 1, axis });
            }
            if self.options.at_pitchfork == AtEvent::Stop {
                return Step::Stopped(StopReason::Pitchfork);
            }
        }
        outcome
    }

    /// The near end of a bracket for a function that has had this `sign` since its last zero. Where the base is that
    /// zero its value there is noise, and a small part of the step away it has to be definite.
    fn near_end(&mut self, value: impl Fn(&Point) -> f64, sign: f64, kind: VertexKind, signed: f64) -> Option<Bracket> {
        let (mut step, mut point) = (0.0, self.base);
        if self.last().kind == kind {
            step = signed / 1024.0;
            point = self.branch.advance(&self.base, &self.tangent, step, &mut self.effort)?;
        }
        let value = value(&point);
        (value * sign > 0.0).then_some(Bracket { step, value })
    }

    fn land(&mut self, reason: StopReason, end: Point) -> Step {
        let condition = match (reason, self.branch.kind) {
            (StopReason::MaximumReached, _) => Condition::Momentum(self.options.l_max),
            (StopReason::MinimumReached, _) => Condition::Momentum(self.options.l_min),
            (StopReason::Pitchfork, Kind::Pair { axis }) => Condition::Symmetric(axis),
            _ => Condition::Rest,
        };
        let scale = self.tangent.omega_scale;
        let Some(point) = self.branch.correct(end, condition, scale, 2.0 * self.step, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let kind = if reason == StopReason::Pitchfork { VertexKind::Pitchfork } else { VertexKind::Regular };
        match self.accept(point, kind) {
            Step::Accepted => {
                let exact = match reason {
                    StopReason::MaximumReached => Some(self.options.l_max),
                    StopReason::MinimumReached => Some(self.options.l_min),
                    _ => None,
                };
                // The condition l = l_max holds to rounding; the vertex carries the very number.
                if let (Some(l), Some(vertex)) = (exact, self.vertices.last_mut()) {
                    vertex.l = l;
                }
                Step::Stopped(reason)
            }
            other => other,
        }
    }

    /// Lands on l = 0 when the step went through it and the corrector could not follow.
    pub(super) fn land_ahead(&mut self, signed: f64) -> Option<Step> {
        let predicted = self.branch.predict(&self.base, &self.tangent, signed)?;
        (predicted.omega <= 0.0 && self.options.l_min <= 0.0).then(|| self.land(StopReason::Rest, predicted))
    }
}
