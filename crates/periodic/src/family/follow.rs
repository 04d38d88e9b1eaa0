//! Pseudo-arclength continuation (Keller) until a family ends.

use std::sync::atomic::Ordering;

use bifdiag_dynamics::field::{Dimension, HeavyTop, State, TopUnits};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, RelativeEquilibria};
use bifdiag_schema::{FamilyEnd, OrbitEventKind};

use super::event::{events, is_turn_explained};
use super::member::{Member, Setting};
use super::model::{End, FamilyError, FamilyOptions, Held, OrbitEvent, Stretch, number};
use crate::flow::{Level, Phase, Space};
use crate::orbit::{About, PeriodicOrbit};
use crate::reversor::{Reversor, reversors};
use crate::walk::nearest;

/// What stays the same while a family is followed.
pub(super) struct Course<'a> {
    pub space: Space,
    pub units: TopUnits,
    /// The moments of the top as given.
    pub moments: [f64; 3],
    level: Level,
    reversors: Vec<Reversor>,
    known: &'a RelativeEquilibria<'a>,
    /// The equilibria at l, where l is held.
    places: Places,
    options: &'a FamilyOptions<'a>,
}

/// Equilibria as points of phase space.
#[derive(Clone, Default)]
struct Places {
    points: Vec<Phase>,
    curves: Vec<Option<String>>,
    /// Whether each is one of a circle of equilibria.
    on_circle: Vec<bool>,
}

/// A member of the family, with its description.
struct Accepted {
    member: Member,
    orbit: PeriodicOrbit,
}

/// Bounds for steps along a family, measured in γ, l in its unit, and the logarithm of the period.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-7;
/// The cosine of the angle by which a family may turn in a step.
const STRAIGHT: f64 = 0.97;
/// The trace may change by less than this in a step between −3 and 3, where special orbits have theirs, and by a factor
/// of four beyond, so that changes of sign are seen one by one; but steps are not made shorter than `FINE` for this.
const TURN: f64 = 1.0;
const FINE: f64 = 1e-3;
/// Where the free parameter turns back, the trace passes or touches 2; steps are shortened until that is seen, down to
/// this.
const FINEST: f64 = 1e-5;
/// Where another family crosses or comes close, a long step could jump to it. The distance of the trace from 2
/// therefore changes by no more than this factor in a step; closer than `MEET` the families do meet.
const NEARING: f64 = 3.0;
const MEET: f64 = 1e-3;
/// A step near an end is at most this share of the remaining distance.
const SHARE: f64 = 0.4;
/// A smaller orbit has shrunk to an equilibrium.
const SHRUNK: f64 = 2e-3;
/// An orbit that comes this close to an equilibrium has reached its separatrix, if its period has grown by the factor
/// `GROWN` …
const NEAR: f64 = 1e-3;
const GROWN: f64 = 2.0;
/// … or its trace is this large: with a fast pair of eigenvalues the period hardly grows.
const STEEP: f64 = 1e8;
/// An orbit that comes this close to a circle of equilibria ends there if its period grows as fast as the distance
/// shrinks, to within a tenth: it runs along the circle, at a speed that vanishes with the distance. At a separatrix
/// the period grows like the logarithm.
const BESIDE: f64 = 0.05;
const ALIKE: f64 = 0.1;
/// Equilibria up to this many times as far as the nearest one belong to the same separatrix.
const TOGETHER: f64 = 10.0;

impl<'a> Course<'a> {
    pub fn new(
        top: &HeavyTop,
        known: &'a RelativeEquilibria<'a>,
        equilibrium: &Equilibrium,
        options: &'a FamilyOptions<'a>,
    ) -> Result<Self, FamilyError> {
        let units = top.units();
        let h = units.reduce(equilibrium.h, Dimension::ENERGY);
        let space = Space::new(top, h);
        let (level, at) = match options.held {
            Held::Momentum => {
                let l = units.reduce(equilibrium.l, Dimension::MOMENTUM);
                (Level::Momentum(l / space.unit), equilibrium.l)
            }
            Held::Energy => (Level::Energy(h), f64::NAN),
        };
        let mut course = Self {
            space,
            units,
            moments: top.moments(),
            level,
            reversors: reversors(&space.top, at),
            known,
            places: Places::default(),
            options,
        };
        course.places = course.places_at(at)?;
        Ok(course)
    }

    pub fn setting(&self) -> Setting<'_> {
        Setting { space: &self.space, level: self.level }
    }

    /// The equilibria at an l in the units of the top as given; none where l is NaN.
    fn places_at(&self, l: f64) -> Result<Places, FamilyError> {
        let Some(l) = number(l).filter(|_| l.is_finite()) else { return Ok(Places::default()) };
        let mut places = Places::default();
        for equilibrium in self.known.at(&l)?.list {
            let state = steady_state(&equilibrium, self.moments);
            places.points.push(self.space.point(&state.reduced(self.units)));
            places.curves.push(equilibrium.curve.map(|curve| curve.to_string()));
            places.on_circle.push(equilibrium.multiplicity == Multiplicity::Circle);
        }
        Ok(places)
    }

    /// Follows a family from its first member; branches of branches are not followed, as there may be infinitely many.
    pub fn follow(&self, first: Member, mut step: f64, is_branch: bool) -> Result<Stretch, FamilyError> {
        let setting = self.setting();
        let mut last = self.accept(first);
        let period = last.orbit.period;
        let mut found = Stretch {
            members: vec![last.orbit.clone()],
            events: Vec::new(),
            end: End { kind: FamilyEnd::Members, curves: Vec::new() },
        };
        while found.members.len() < self.options.members && !self.options.monitor.is_stopped() {
            let before = &last.member;
            let is_fine = |next: &Member| {
                let seen = turn(before, next) < TURN && nearing(before, next) < NEARING;
                let explained = is_turn_explained(&setting, before, next) || step < FINEST;
                next.straight > STRAIGHT && !next.is_beyond_an_end(before) && (seen || step < FINE) && explained
            };
            let Some(next) = setting.ahead(before, step).ok().filter(is_fine) else {
                step *= 0.5;
                if step < SHORTEST {
                    found.end.kind = FamilyEnd::Lost;
                    break;
                }
                continue;
            };
            let mut joins = false;
            for located in events(&setting, before, &next, step) {
                let Accepted { member, orbit } = self.accept(located.member);
                // Beyond it the family continues with the mirror images of its orbits so far.
                joins |= located.kind == OrbitEventKind::Branch && orbit.symmetric && !last.orbit.symmetric;
                let mut branches = Vec::new();
                if self.options.branches && !is_branch {
                    branches = self.beside(&member, orbit.symmetric, located.kind)?;
                }
                let (kind, after, error) = (located.kind, found.members.len() - 1, located.error);
                found.events.push(OrbitEvent { kind, after, orbit, error, branches });
            }
            if joins {
                found.end.kind = FamilyEnd::Joined;
                break;
            }
            let next = self.accept(next);
            found.members.push(next.orbit.clone());
            self.options.monitor.orbits.fetch_add(1, Ordering::Relaxed);
            if let Some(end) = self.end(&last, &next, period)? {
                found.end = end;
                break;
            }
            let (from, to) = (&last.member, &next.member);
            let pace = pace(to.shot.missed).min(0.7 * TURN / turn(from, to)).min(towards_two(from, to));
            step = (step * pace).min(LONGEST).min(longest_step(from, to));
            last = next;
        }
        Ok(found)
    }

    /// The description of a member.
    pub fn describe(&self, member: &Member) -> PeriodicOrbit {
        About { space: &self.space, reversors: &self.reversors }.describe(&member.shot)
    }

    fn accept(&self, member: Member) -> Accepted {
        Accepted { orbit: self.describe(&member), member }
    }

    /// The equilibria at the momentum of a member, and how near it comes to each.
    fn nearest(&self, accepted: &Accepted) -> Result<(Places, Vec<f64>), FamilyError> {
        let places = match self.options.held {
            Held::Momentum => self.places.clone(),
            Held::Energy => self.places_at(self.units.restore(accepted.orbit.l, Dimension::MOMENTUM))?,
        };
        let nearest = nearest(&self.space, &accepted.member.shot, &places.points);
        Ok((places, nearest))
    }

    /// The end of the family, if a member has reached it.
    fn end(&self, before: &Accepted, last: &Accepted, period: f64) -> Result<Option<End>, FamilyError> {
        let shrinks = last.member.size() < SHRUNK && last.member.size() < before.member.size();
        let [was, is] = [before, last].map(|accepted| accepted.member.largest_distance_from_half());
        if !shrinks && is < SHRUNK && is < was && is < last.member.size() {
            return Ok(Some(End { kind: FamilyEnd::Joined, curves: Vec::new() }));
        }
        if !shrinks && last.orbit.period < GROWN * period && last.orbit.trace.abs() < STEEP {
            return Ok(None);
        }
        let (places, nearest) = self.nearest(last)?;
        if let Some(circle) = (0..nearest.len()).find(|&k| places.on_circle[k] && nearest[k] < BESIDE) {
            let (others, earlier) = self.nearest(before)?;
            let same = (0..earlier.len()).find(|&k| others.on_circle[k] && others.curves[k] == places.curves[circle]);
            let shrunk = same.map_or(0.0, |k| libm::log(earlier[k] / nearest[circle]));
            let grown = libm::log(last.orbit.period / before.orbit.period);
            if shrunk > 0.0 && (shrunk / grown - 1.0).abs() < ALIKE {
                let curves = places.curves[circle].clone().into_iter().collect();
                return Ok(Some(End { kind: FamilyEnd::Circle, curves }));
            }
        }
        let least = nearest.iter().copied().fold(f64::INFINITY, f64::min);
        let bound = if shrinks { 4.0 * SHRUNK } else { NEAR };
        if least > bound {
            return Ok(None);
        }
        let are_near = places.curves.into_iter().zip(&nearest).filter(|(_, distance)| **distance <= TOGETHER * least);
        let mut curves: Vec<String> = are_near.filter_map(|(curve, _)| curve).collect();
        curves.dedup();
        let kind = if shrinks { FamilyEnd::Equilibrium } else { FamilyEnd::Separatrix };
        Ok(Some(End { kind, curves }))
    }
}

/// (γ, l) of a steady rotation of a body with these moments, l = (ΩA)γ, rounded as where families begin.
pub(super) fn steady_state(equilibrium: &Equilibrium, moments: [f64; 3]) -> State {
    let gamma = equilibrium.gamma;
    State { gamma, l: std::array::from_fn(|i| equilibrium.omega * moments[i] * gamma[i]) }
}

/// How far the trace moves: by its logarithm beyond ±3, and not at all beyond ±192.
fn turn(before: &Member, member: &Member) -> f64 {
    let place = |trace: f64| {
        let beyond = libm::log(trace.abs().max(3.0) / 3.0) / libm::log(4.0);
        trace.clamp(-3.0, 3.0) + beyond.min(3.0).copysign(trace)
    };
    (place(member.trace) - place(before.trace)).abs()
}

/// How far the trace is from 2.
fn from_two(member: &Member) -> f64 {
    (member.trace - 2.0).abs().clamp(MEET, 3.0)
}

/// The factor by which the trace has approached 2 or moved away from it.
fn nearing(before: &Member, member: &Member) -> f64 {
    let [was, is] = [before, member].map(from_two);
    (was / is).max(is / was)
}

/// The factor by which the next step may be longer without the trace coming too close to 2.
fn towards_two(before: &Member, member: &Member) -> f64 {
    let [was, is] = [before, member].map(from_two);
    if is < was && is > MEET { 0.5 * is / (was - is) } else { f64::INFINITY }
}

/// The factor by which the next step may be longer, from the error of the guess: where Newton's method would need two
/// corrections, three, four, or more.
fn pace(missed: f64) -> f64 {
    match missed {
        ..5e-5 => 1.7,
        ..2e-3 => 1.3,
        ..1.5e-2 => 1.0,
        _ => 0.6,
    }
}

/// The longest step that does not pass over a near end.
fn longest_step(before: &Member, member: &Member) -> f64 {
    let towards = |now: f64, before: f64| if now < before { SHARE * now } else { LONGEST };
    towards(member.size(), before.size()).min(towards(member.distance_from_half(), before.distance_from_half()))
}
