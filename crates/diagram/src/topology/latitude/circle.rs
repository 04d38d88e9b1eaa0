//! One circle of latitude: its accessible arcs, certified.

use super::angle::{Longitude, LongitudeRange, Trig, half_angle_reach};
use super::error::Effort;
use super::level::{Level, variation};
use bifdiag_numbers::interval::Interval;

/// Where a stretch is cut; another place is tried when the sign of G at the first is not certain.
pub(super) const CUTS: [f64; 4] = [0.493_1, 0.538_7, 0.446_3, 0.571_9];
/// Halvings of a stretch of longitude before a tangency is assumed.
const DEPTH: u32 = 60;

/// A longitude at which the sign of G is certain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub psi: Longitude,
    pub accessible: bool,
    /// The arc to which the mark belongs.
    pub arc: usize,
}

/// A circle of latitude as a cyclic sequence of marks. Between neighbouring marks of equal sign G has no zero,
/// between marks of unequal sign exactly one, so that every arc and every gap owns at least one mark.
/// A pole is a circle with a single mark.
#[derive(Clone, Debug)]
pub(super) struct Circle {
    theta: Trig,
    pub marks: Vec<Mark>,
    /// Arcs and gaps have the numbers `first_arc .. first_arc + arc_count`.
    pub first_arc: usize,
    pub arc_count: usize,
}

impl Circle {
    /// A pole, if the sign of G there is certain.
    pub fn pole(level: &Level, theta: Trig, first_arc: usize) -> Option<Self> {
        let psi = Longitude::START;
        let accessible = level.value(&theta, &psi.trig()).is_positive()?;
        Some(Self { theta, marks: vec![Mark { psi, accessible, arc: first_arc }], first_arc, arc_count: 1 })
    }

    /// The circle of latitude ϑ; `None` when it is tangent to ∂U_hl within rounding, or nearly so at a mark.
    pub fn new(level: &Level, theta: Trig, first_arc: usize, effort: &mut Effort) -> Option<Self> {
        let mut signs = Vec::new();
        if level.height(&theta).hi <= 0.0 {
            signs.push((Longitude::START, false));
        } else {
            for stretch in LongitudeRange::quadrants() {
                let accessible = level.value(&theta, &stretch.start().trig()).is_positive()?;
                signs.push((stretch.start(), accessible));
                refine(level, &theta, stretch, DEPTH, &mut signs, effort)?;
            }
        }
        Some(Self::from_signs(theta, &signs, first_arc))
    }

    fn from_signs(theta: Trig, signs: &[(Longitude, bool)], first_arc: usize) -> Self {
        let mut arc = first_arc;
        let mut marks: Vec<Mark> = Vec::with_capacity(signs.len());
        for &(psi, accessible) in signs {
            if marks.last().is_some_and(|last| last.accessible != accessible) {
                arc += 1;
            }
            marks.push(Mark { psi, accessible, arc });
        }
        // The last run of marks continues into the first.
        if arc > first_arc && marks[0].accessible == marks[marks.len() - 1].accessible {
            for mark in marks.iter_mut().rev().take_while(|mark| mark.arc == arc) {
                mark.arc = first_arc;
            }
            arc -= 1;
        }
        Self { theta, marks, first_arc, arc_count: arc - first_arc + 1 }
    }

    /// For each arc or gap in order: whether it is accessible.
    pub fn arcs(&self) -> impl Iterator<Item = bool> {
        (0..self.arc_count).map(|n| self.marks[0].accessible == (n % 2 == 0))
    }

    /// Pairs of an arc and a gap that share an end on this circle.
    pub fn neighbours(&self) -> impl Iterator<Item = (usize, usize)> {
        let count = self.marks.len();
        (0..count).filter_map(move |n| {
            let (here, next) = (self.marks[n], self.marks[(n + 1) % count]);
            match (here.accessible, next.accessible) {
                (true, false) => Some((here.arc, next.arc)),
                (false, true) => Some((next.arc, here.arc)),
                _ => None,
            }
        })
    }

    /// Pairs of neighbouring marks of unequal sign.
    pub fn roots(&self) -> impl Iterator<Item = (Mark, Mark)> {
        let count = self.marks.len();
        (0..count)
            .map(move |n| (self.marks[n], self.marks[(n + 1) % count]))
            .filter(|(here, next)| here.accessible != next.accessible)
    }

    /// The sign at ψ and the arc that holds ψ; `known` is the sign if it follows from elsewhere.
    pub fn locate(&self, level: &Level, psi: Longitude, known: Option<bool>) -> Option<(bool, usize)> {
        let count = self.marks.len();
        let after = self.marks.partition_point(|mark| mark.psi.order(&psi).is_le());
        let before = self.marks[(after + count - 1) % count];
        let next = self.marks[after % count];
        if before.accessible == next.accessible || before.psi == psi {
            return Some((before.accessible, before.arc));
        }
        let accessible = known.or_else(|| level.value(&self.theta, &psi.trig()).is_positive())?;
        Some((accessible, if before.accessible == accessible { before.arc } else { next.arc }))
    }
}

/// Adds marks inside the stretch until each part has no zero of G or is monotone.
fn refine(
    level: &Level,
    theta: &Trig,
    stretch: LongitudeRange,
    depth: u32,
    signs: &mut Vec<(Longitude, bool)>,
    effort: &mut Effort,
) -> Option<()> {
    effort.spend()?;
    let psi = stretch.trig();
    let patch = level.over(theta, &psi);
    if patch.value().is_positive().is_some() {
        return Some(());
    }
    let turning = patch.turning();
    if turning.is_positive().is_some() && patch.height().lo > 0.0 {
        return Some(());
    }
    let parallel = patch.parallel(turning);
    let depth = depth.checked_sub(1)?;
    for fraction in CUTS {
        let t = stretch.t0 + fraction * (stretch.t1 - stretch.t0);
        let (left, right) = stretch.split(t)?;
        let middle = right.start().trig();
        let reach = half_angle_reach(stretch.t0, t, stretch.t1);
        let around = variation(parallel, reach);
        let value = level.value(theta, &middle);
        if (value + Interval::between(-around, around)).is_positive().is_some() {
            return Some(());
        }
        if let Some(accessible) = value.is_positive() {
            refine(level, theta, left, depth, signs, effort)?;
            signs.push((right.start(), accessible));
            return refine(level, theta, right, depth, signs, effort);
        }
    }
    None
}

/// A zero of G on a latitude between two marks of unequal sign, to the last bit that the signs allow.
pub(super) fn root_between(level: &Level, theta: &Trig, here: Mark, next: Mark) -> Longitude {
    let t_end = if next.psi.quadrant == here.psi.quadrant && next.psi.t > here.psi.t { next.psi.t } else { 1.0 };
    let (mut t0, mut t1) = (here.psi.t, t_end);
    loop {
        let middle = 0.5 * (t0 + t1);
        if !(t0 < middle && middle < t1) {
            return Longitude::new(here.psi.quadrant, middle);
        }
        match level.value(theta, &Longitude::new(here.psi.quadrant, middle).trig()).is_positive() {
            Some(accessible) if accessible == here.accessible => t0 = middle,
            Some(_) => t1 = middle,
            None => return Longitude::new(here.psi.quadrant, middle),
        }
    }
}
