//! The loop: predict, correct, judge, accept.

use super::branch::{Branch, Kind, Point, Tangent};
use super::chord::{ChordEnd, chord_distance};
use super::corrector::Condition;
use super::options::{Direction, Start, TrackOptions};
use super::report::{Effort, Pitchfork, StopReason, TrackError, TrackReport, Vertex, VertexKind};
use crate::body::Frame;
use crate::stability::Hessian;

/// Below this a step is lost in the rounding of the point that it starts from.
const SMALLEST_STEP: f64 = 1e-11;
/// Steps at which events that fall into one step are no longer told apart.
const EVENT_STEP: f64 = 1e-7;
/// Cosine of the largest angle between successive tangents.
const LARGEST_TURN: f64 = 0.8;
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

/// What came of one attempt of a step.
pub(super) enum Step {
    Accepted,
    Rejected { factor: f64 },
    Stopped(StopReason),
}

/// The state of a track.
pub(super) struct Tracker<'a> {
    pub(super) branch: Branch<'a>,
    pub(super) options: &'a TrackOptions,
    /// +1 along the orientation of the branch, −1 against it.
    pub(super) way: f64,
    pub(super) base: Point,
    pub(super) tangent: Tangent,
    pub(super) step: f64,
    /// Sign of [`Branch::turning`] since the last cusp.
    pub(super) turning_sign: f64,
    /// Signs of the gaps of frozen axes since the last pitchfork; 0 where not yet known.
    pub(super) frozen_sign: [f64; 3],
    pub(super) vertices: Vec<Vertex>,
    pub(super) pitchforks: Vec<Pitchfork>,
    pub(super) effort: Effort,
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

fn check(options: &TrackOptions) -> Result<(), TrackError> {
    let positive = [
        ("chord_tolerance", options.chord_tolerance),
        ("h_scale", options.h_scale),
        ("l_scale", options.l_scale),
        ("max_step", options.max_step),
    ];
    match positive.into_iter().find(|(_, value)| value.is_nan() || *value <= 0.0) {
        Some((option, value)) => Err(TrackError::OptionNotPositive { option, value }),
        None => Ok(()),
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
        check(options)?;
        let branch = Branch::new(frame, start);
        let mut effort = Effort::default();
        let guess = branch.point(start);
        let leaves_pitchfork = matches!(branch.kind, Kind::Pair { axis } if guess.gamma[axis] == 0.0);
        let refused = TrackError::StartNotOnBranch { gamma: start.equilibrium.gamma, omega: start.equilibrium.omega };
        let tangent = branch.tangent(&guess);
        let condition = match branch.kind {
            Kind::Pair { axis } if leaves_pitchfork => Condition::Symmetric(axis),
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
            effort,
        };
        let kind = if leaves_pitchfork { VertexKind::Pitchfork } else { VertexKind::Regular };
        let vertex = tracker.vertex(&base, kind);
        tracker.vertices.push(vertex);
        Ok(tracker)
    }

    fn vertex(&self, point: &Point, kind: VertexKind) -> Vertex {
        let equilibrium = self.branch.equilibrium(point);
        let (l, h) = (self.branch.l(point), self.branch.h(point));
        let is_regular = kind == VertexKind::Regular;
        let index = is_regular.then(|| Hessian::new(self.branch.frame, &equilibrium).index()).flatten();
        Vertex { l, h, equilibrium, index, kind }
    }

    pub(super) fn last(&self) -> &Vertex {
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
        TrackReport { vertices: self.vertices, pitchforks: self.pitchforks, stop, effort: self.effort }
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
            (None, _) => self.accept(end, VertexKind::Regular),
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

    /// Accepts `point` as the next vertex if the chord to it is close enough to the curve.
    pub(super) fn accept(&mut self, point: Point, kind: VertexKind) -> Step {
        let vertex = self.vertex(&point, kind);
        let base = self.branch.reanchored(point);
        let tangent = self.branch.tangent(&base);
        let share = chord_distance(&chord_end(self.last(), &self.tangent), &chord_end(&vertex, &tangent), self.options)
            / self.options.chord_tolerance;
        if share > LIMIT {
            return Step::Rejected { factor: (AIM / share).sqrt().clamp(0.2, 0.9) };
        }
        self.effort.steps += 1;
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
