//! The loop: predict, correct, judge, accept.

use super::branch::{Branch, Family, Point, Tangent};
use super::chord::{ChordEnd, chord_distance};
use super::corrector::Condition;
use super::location::Bracket;
use super::options::{AtEvent, Direction, Start, TrackOptions};
use super::report::{Effort, Pitchfork, StopReason, TrackError, TrackReport, Vertex, VertexKind};
use super::spans::{Segment, Stretches};
use crate::body::Frame;
use crate::document::Stability;
use crate::stability::Linearisation;

/// Below this a step is lost in the rounding of the point that it starts from.
const SMALLEST_STEP: f64 = 1e-11;
/// Steps at which events that fall into one step are no longer told apart.
const EVENT_STEP: f64 = 1e-7;
/// Cosine of the largest angle between successive tangents.
const LARGEST_TURN: f64 = 0.8;
/// dl/(J Ω) along the tangent below which a step may hide a pair of cusps.
const FOLD_SUSPECT: f64 = 0.2;
/// Where the slope at the end of a step is felt, as a share of it.
const FOLD_PROBE: f64 = 1.0 / 32.0;
/// Evaluations spent on following a dip down: it is located to a thousandth of the step.
const FOLD_EVALUATIONS: usize = 14;
/// Golden section.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
/// Share of the chord tolerance that is accepted. The estimate was not seen to fall short on fine samples.
const LIMIT: f64 = 0.98;
/// Share of the chord tolerance that is aimed at.
const AIM: f64 = 0.87;

/// Follows the branch through `start` until something of `options` stops it.
///
/// The polyline meets `options.chord_tolerance`; every cusp and pitchfork on it is a vertex, located to rounding.
/// `direction` is ignored for a start that leaves a pitchfork: the only way is along the pair.
///
/// # Errors
/// [`TrackError`] when there is nothing to follow. A branch that could not be finished is not an error: the report
/// holds what was found and says why it stopped.
pub fn track(
    frame: &Frame,
    start: &Start,
    direction: Direction,
    options: &TrackOptions,
) -> Result<TrackReport, TrackError> {
    let mut tracker = Tracker::new(frame, start, direction, options)?;
    let stop = loop {
        match tracker.step() {
            Step::Accepted => {}
            Step::Rejected { factor } => tracker.shrink(factor),
            Step::Stopped(reason) => break reason,
        }
        if let Some(reason) = tracker.exhausted() {
            break reason;
        }
    };
    Ok(tracker.finish(stop))
}

enum Step {
    Accepted,
    Rejected { factor: f64 },
    Stopped(StopReason),
}

/// What lies between the base point and the end of a step.
enum Event {
    Cusp,
    Pitchfork,
    /// The branch ends or leaves the range of l: land on it.
    Landing(StopReason),
}

struct Tracker<'a> {
    branch: Branch<'a>,
    options: &'a TrackOptions,
    /// +1 along the orientation of the branch, −1 against it.
    way: f64,
    base: Point,
    tangent: Tangent,
    step: f64,
    /// Sign of [`Branch::turning`] since the last cusp.
    turning_sign: f64,
    /// Signs of the gaps of frozen axes since the last pitchfork; 0 where not yet known.
    frozen_sign: [f64; 3],
    vertices: Vec<Vertex>,
    pitchforks: Vec<Pitchfork>,
    stretches: Stretches<'a>,
    effort: Effort,
}

fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

fn chord_end(vertex: &Vertex, tangent: &Tangent) -> ChordEnd {
    ChordEnd {
        l: vertex.l,
        h: vertex.h,
        slope: vertex.equilibrium.omega,
        curvature: tangent.omega * tangent.omega_scale / tangent.l,
    }
}

impl<'a> Tracker<'a> {
    fn new(
        frame: &'a Frame,
        start: &Start,
        direction: Direction,
        options: &'a TrackOptions,
    ) -> Result<Self, TrackError> {
        let positive = [
            ("chord_tolerance", options.chord_tolerance),
            ("h_scale", options.h_scale),
            ("l_scale", options.l_scale),
            ("max_step", options.max_step),
        ];
        for (option, value) in positive {
            if value.is_nan() || value <= 0.0 {
                return Err(TrackError::OptionNotPositive { option, value });
            }
        }
        let branch = Branch::new(frame, start);
        let mut effort = Effort::default();
        let guess = branch.point(start);
        let leaves_pitchfork = matches!(branch.family, Family::Pair { axis } if guess.gamma[axis] == 0.0);
        let refused = TrackError::StartNotOnBranch { gamma: start.equilibrium.gamma, omega: start.equilibrium.omega };
        let tangent = branch.tangent(&guess);
        let condition = match branch.family {
            Family::Pair { axis } if leaves_pitchfork => Condition::Symmetric(axis),
            _ if guess.omega == 0.0 => Condition::Rest,
            _ => Condition::Plane(&tangent),
        };
        let base = branch.correct(guess, condition, tangent.omega_scale, 1e-3, &mut effort).ok_or(refused)?;
        let base = branch.reanchored(base);
        let tangent = branch.tangent(&base);
        let l = branch.l(&base);
        let slack = 1e-12 * l;
        if !(l >= options.l_min - slack && l <= options.l_max + slack) {
            return Err(TrackError::StartOutsideRange { l, l_min: options.l_min, l_max: options.l_max });
        }
        let wanted = if direction == Direction::Rising { 1.0 } else { -1.0 };
        let way = if leaves_pitchfork || tangent.l == 0.0 { 1.0 } else { wanted * sign(tangent.l) };
        let gaps = branch.gaps(&base);
        // At a pitchfork the gap of the frozen axis is zero or noise; its sign is learnt from the first step.
        let noise = |j: usize| {
            let difference = frame.diff[base.anchor][j];
            gaps[j].abs() <= 8.0 * f64::EPSILON * (base.gap.abs() + base.omega * base.omega * difference.abs())
        };
        let frozen_sign = std::array::from_fn(|j| if branch.frozen[j] && !noise(j) { sign(gaps[j]) } else { 0.0 });
        let mut tracker = Self {
            turning_sign: sign(branch.turning(&base, &tangent)),
            branch,
            options,
            way,
            base,
            tangent,
            step: 0.1f64.min(options.max_step),
            frozen_sign,
            vertices: Vec::with_capacity(64),
            pitchforks: Vec::new(),
            stretches: Stretches::default(),
            effort,
        };
        let kind = if leaves_pitchfork { VertexKind::Pitchfork } else { VertexKind::Regular };
        let vertex = tracker.vertex(&base, kind);
        tracker.stretches.begin(&vertex);
        tracker.vertices.push(vertex);
        Ok(tracker)
    }

    fn vertex(&self, point: &Point, kind: VertexKind) -> Vertex {
        let equilibrium = self.branch.equilibrium(point);
        let (l, h) = (self.branch.l(point), self.branch.h(point));
        if kind == VertexKind::Regular {
            let linearisation = Linearisation::new(self.branch.frame, &equilibrium);
            let (index, stability) = (linearisation.index(), linearisation.stability());
            Vertex { l, h, equilibrium, index, stability, kind }
        } else {
            Vertex { l, h, equilibrium, index: None, stability: Stability::Degenerate, kind }
        }
    }

    fn last(&self) -> &Vertex {
        &self.vertices[self.vertices.len() - 1]
    }

    fn shrink(&mut self, factor: f64) {
        self.effort.rejected += 1;
        self.step *= factor;
    }

    fn exhausted(&self) -> Option<StopReason> {
        if self.step < SMALLEST_STEP {
            Some(StopReason::StepUnderflow)
        } else if self.effort.steps + self.effort.rejected >= self.options.max_steps {
            Some(StopReason::StepLimit)
        } else {
            None
        }
    }

    fn finish(self, stop: StopReason) -> TrackReport {
        let l = self.last().l;
        let stability = self.stretches.finish(l);
        TrackReport { vertices: self.vertices, pitchforks: self.pitchforks, stability, stop, effort: self.effort }
    }

    /// One attempt of a step.
    fn step(&mut self) -> Step {
        if let Some(reason) = self.already_there() {
            return Step::Stopped(reason);
        }
        let signed = self.way * self.step;
        let Some(end) = self.branch.advance(&self.base, &self.tangent, signed, &mut self.effort) else {
            // The predictor may have crossed the end of the branch.
            return self.land_ahead(signed).unwrap_or(Step::Rejected { factor: 0.5 });
        };
        let tangent = self.branch.tangent(&end);
        if tangent.dot(&self.tangent) < LARGEST_TURN || self.hides_a_fold(&end, &tangent, signed) {
            return Step::Rejected { factor: 0.5 };
        }
        let mut events = self.events(&end, &tangent);
        match (events.pop(), events.is_empty()) {
            (None, _) => self.accept(end, signed, VertexKind::Regular),
            (Some(event), true) => self.handle(&event, end, &tangent, signed),
            (Some(event), false) if self.step < EVENT_STEP => self.handle(&event, end, &tangent, signed),
            (Some(_), false) => Step::Rejected { factor: 0.5 },
        }
    }

    /// The way out of the range of l starts at its very end.
    fn already_there(&self) -> Option<StopReason> {
        if self.effort.steps > 0 {
            return None;
        }
        let falling = self.way * self.tangent.l < 0.0;
        let rising = self.way * self.tangent.l > 0.0;
        let vertex = self.last();
        if falling && vertex.equilibrium.omega == 0.0 {
            Some(StopReason::Rest)
        } else if falling && vertex.l <= self.options.l_min {
            Some(StopReason::MinimumReached)
        } else if rising && vertex.l >= self.options.l_max {
            Some(StopReason::MaximumReached)
        } else {
            None
        }
    }

    /// Whether two cusps hide between the base and `end`. [`Branch::turning`] has the same sign at both then, and dips
    /// in between; the dip shows at the end where the value is smaller, and is followed down by golden section.
    fn hides_a_fold(&mut self, end: &Point, tangent: &Tangent, signed: f64) -> bool {
        if matches!(self.branch.family, Family::Pair { .. }) {
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
    fn events(&self, end: &Point, tangent: &Tangent) -> Vec<Event> {
        let mut events = Vec::new();
        let l = self.branch.l(end);
        if let Family::Pair { axis } = self.branch.family
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

    fn handle(&mut self, event: &Event, end: Point, tangent: &Tangent, signed: f64) -> Step {
        match event {
            Event::Landing(reason) => self.land(*reason, end, signed),
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
        let Some((step, point)) = branch.locate(&self.base, &self.tangent, ends, end, turning, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let outcome = self.accept(point, step, VertexKind::Cusp);
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
        let crossed = |j: &usize| branch.frozen[*j] && far[*j] * frozen_sign[*j] < 0.0;
        // The first one on the way; others at the same point (equal moments) go with it.
        let share = |j: usize| near[j] / (near[j] - far[j]);
        let Some(axis) = (0..3).filter(crossed).min_by(|&i, &j| share(i).total_cmp(&share(j))) else {
            return Step::Rejected { factor: 0.5 };
        };
        let gap = |point: &Point| branch.gaps(point)[axis];
        let Some(near) = self.near_end(gap, self.frozen_sign[axis], VertexKind::Pitchfork, signed) else {
            return Step::Rejected { factor: 0.5 };
        };
        let ends = [near, Bracket { step: signed, value: far[axis] }];
        let Some((step, point)) = branch.locate(&self.base, &self.tangent, ends, end, gap, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let meeting: Vec<usize> = (0..3).filter(crossed).filter(|&j| branch.frame.diff[axis][j] == 0.0).collect();
        let outcome = self.accept(point, step, VertexKind::Pitchfork);
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

    fn land(&mut self, reason: StopReason, end: Point, signed: f64) -> Step {
        let condition = match (reason, self.branch.family) {
            (StopReason::MaximumReached, _) => Condition::Momentum(self.options.l_max),
            (StopReason::MinimumReached, _) => Condition::Momentum(self.options.l_min),
            (StopReason::Pitchfork, Family::Pair { axis }) => Condition::Symmetric(axis),
            _ => Condition::Rest,
        };
        let scale = self.tangent.omega_scale;
        let Some(point) = self.branch.correct(end, condition, scale, 2.0 * self.step, &mut self.effort) else {
            return Step::Rejected { factor: 0.5 };
        };
        let kind = if reason == StopReason::Pitchfork { VertexKind::Pitchfork } else { VertexKind::Regular };
        // Only where the stability can change does it matter where in the step the landing lies.
        let landed =
            if self.last().index == Some(2) { self.landed_step(condition, &point, &end, signed) } else { signed };
        match self.accept(point, landed, kind) {
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

    /// The step at which the landing lies, for the search for changes of stability before it.
    fn landed_step(&mut self, condition: Condition, point: &Point, end: &Point, signed: f64) -> f64 {
        let branch = self.branch;
        let beyond = |point: &Point| match condition {
            Condition::Momentum(l) => branch.l(point) - l,
            Condition::Symmetric(axis) => point.gamma[axis],
            Condition::Rest | Condition::Plane(_) => point.omega,
        };
        let ends = [Bracket { step: 0.0, value: beyond(&self.base) }, Bracket { step: signed, value: beyond(end) }];
        branch
            .locate(&self.base, &self.tangent, ends, *end, beyond, &mut self.effort)
            .map_or_else(|| branch.progress(&self.base, &self.tangent, point), |(step, _)| step)
    }

    /// Lands on l = 0 when the step went through it and the corrector could not follow.
    fn land_ahead(&mut self, signed: f64) -> Option<Step> {
        let predicted = self.branch.predict(&self.base, &self.tangent, signed)?;
        (predicted.omega <= 0.0 && self.options.l_min <= 0.0).then(|| self.land(StopReason::Rest, predicted, signed))
    }

    /// Accepts `point` as the next vertex if the chord to it is close enough to the curve.
    fn accept(&mut self, point: Point, signed: f64, kind: VertexKind) -> Step {
        let vertex = self.vertex(&point, kind);
        let base = self.branch.reanchored(point);
        let tangent = self.branch.tangent(&base);
        let share = chord_distance(&chord_end(self.last(), &self.tangent), &chord_end(&vertex, &tangent), self.options)
            / self.options.chord_tolerance;
        if share > LIMIT {
            return Step::Rejected { factor: (AIM / share).sqrt().clamp(0.2, 0.9) };
        }
        self.effort.steps += 1;
        let from = *self.last();
        let segment = Segment {
            branch: self.branch,
            base: self.base,
            tangent: self.tangent,
            step: signed,
            l: [from.l, vertex.l],
        };
        self.stretches.extend(&segment, &from, &vertex, &mut self.effort);
        self.vertices.push(vertex);
        self.base = base;
        self.tangent = tangent;
        let gaps = self.branch.gaps(&self.base);
        for j in 0..3 {
            if self.branch.frozen[j] && self.frozen_sign[j] == 0.0 {
                self.frozen_sign[j] = sign(gaps[j]);
            }
        }
        let growth = if share > 0.0 { (AIM / share).sqrt().min(2.0) } else { 2.0 };
        // A step cut short by an event says nothing against the length that was tried.
        self.step = if kind == VertexKind::Regular { self.step * growth } else { self.step };
        self.step = self.step.min(self.options.max_step);
        if vertex.h > self.options.h_max {
            return Step::Stopped(StopReason::LeftWindow);
        }
        Step::Accepted
    }
}
