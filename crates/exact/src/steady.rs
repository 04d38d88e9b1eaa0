//! The steady rotation at one spin that is nearest to a direction, with the changes over the spin and the regions beside it.

use std::cmp::Ordering;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Spot;
use bifdiag_diagram::region_changes::{RotationChange, rotation_changes};
use bifdiag_diagram::topology::{Answer, Margin};
use bifdiag_equilibria::critical::{ExactSpin, Multiplicity};
use bifdiag_equilibria::curves::CurveName;
use bifdiag_equilibria::permanent::{
    AxisKind, AxisRotation, Judged, PermanentAxis, SteadyRotation, angle_between, nearest_steady, permanent_axis,
};
use bifdiag_numbers::Sign;
use bifdiag_numbers::vector::norm;
use dashu_ratio::RBig;

use crate::solver::Solver;

/// Distances in h at which the regions beside a curve are looked up, relative to the size of the energies.
const STEPS: [f64; 6] = [1e-9, 1e-12, 1e-15, 1e-18, 1e-26, 1e-40];

/// The same for a point that is exactly on its curve, far below the digits that are kept of a root.
const CLOSEST: f64 = 1e-80;

/// How many of them are above the rounding of a point that is not exactly on the curve.
const ROUNDED: usize = 2;

/// Directions nearer than this, in radians, are one: the rest is rounding.
const SAME: f64 = 1e-12;

/// Which steady rotation is asked for, in principal axes and the body's units.
#[derive(Clone, Debug, PartialEq)]
pub struct SpinQuestion {
    /// The axis that points up.
    pub up: [f64; 3],
    /// The same, exact, of any length, in the axes in which the body was given.
    pub exact_up: [RBig; 3],
    /// Ω ≥ 0, with a rational square.
    pub spin: ExactSpin,
}

/// A steady rotation.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Its axis, pointing up, in principal axes.
    pub axis: [f64; 3],
    /// The angle to the axis of the question in radians; 0 where only rounding is left of it.
    pub angle: f64,
    /// The axes of the other steady rotations that are as near.
    pub as_near: Vec<[f64; 3]>,
    /// h and l.
    pub place: [f64; 2],
    /// The circle or sphere that it belongs to.
    pub multiplicity: Multiplicity,
    /// Its stability.
    pub judged: Judged,
    /// |Im λ| of both pairs by size, per unit of time.
    pub frequencies: [f64; 2],
    /// The largest Re λ, if it is positive.
    pub growth: Option<f64>,
    /// For an axis that is permanent at every spin: the changes at the next smaller spin, at this one and at the next
    /// larger one.
    pub changes: [Option<RotationChange>; 3],
    /// What lies just below and just above in h; `None` where it is not known.
    pub beside: Option<[Spot; 2]>,
}

impl Steady {
    /// The steady rotation whose axis is nearest to that of the question.
    #[must_use]
    pub fn nearest(solver: &Solver, question: &SpinQuestion) -> Option<Self> {
        let SpinQuestion { up, exact_up, spin } = question;
        let body = solver.body();
        if let AxisKind::Permanent { axis, .. } = AxisKind::of(body, *up, exact_up) {
            return Self::about(solver, question, axis, angle_between(axis.direction, *up));
        }
        let found = nearest_steady(body, spin, *up, Some(exact_up))?;
        let up = found.gamma.map(|x| 0.0 - x);
        match permanent_axis(body, up).filter(|axis| angle_between(axis.direction, up) <= SAME) {
            Some(axis) => Some(Self { as_near: found.as_near, ..Self::about(solver, question, axis, found.angle)? }),
            None => Some(Self::beyond(solver, &spin.omega, found)),
        }
    }

    /// Rotation about an axis that is permanent at every spin, at an angle to that of the question: exact, along its curve.
    fn about(solver: &Solver, question: &SpinQuestion, axis: PermanentAxis, angle: f64) -> Option<Self> {
        let (body, spin) = (solver.body(), &question.spin);
        let ExactSpin { omega, squared, .. } = spin;
        // γ points down.
        let rotation = AxisRotation::about(body, axis, Sign::Negative)?;
        let changes = changes_beside(&rotation_changes(&rotation, solver.atlas()), squared);
        let Some(judged) = rotation.stability_at(squared) else {
            let exact = Some(&question.exact_up);
            let found = SteadyRotation { angle, ..nearest_steady(body, spin, axis.direction, exact)? };
            return Some(Self { changes, ..Self::beyond(solver, omega, found) });
        };
        let (frequencies, growth) = rotation.frequencies_and_growth(squared);
        let (h, l) = rotation.point(omega, squared);
        Some(Self {
            axis: axis.direction,
            angle: resolved(angle),
            as_near: Vec::new(),
            place: [h.to_f64(), l.to_f64()],
            multiplicity: rotation.multiplicity(),
            judged,
            frequencies: by_size(frequencies),
            growth: judged.kind.is_unstable().then_some(growth),
            changes,
            beside: beside(solver, [&h, &l], size(body, &l, omega), true),
        })
    }

    /// Rotation about another axis, which is permanent at this spin.
    fn beyond(solver: &Solver, omega: &RBig, found: SteadyRotation) -> Self {
        let SteadyRotation { gamma, angle, place: [h, l], is_exact, equilibrium, as_near } = found;
        let (multiplicity, curve) = (equilibrium.multiplicity, equilibrium.curve);
        let judged = Judged::from(equilibrium);
        let pairs = judged.eigenvalues.pairs;
        Self {
            axis: gamma.map(|x| 0.0 - x),
            angle: resolved(angle),
            as_near,
            place: [h.to_f64(), l.to_f64()],
            multiplicity,
            judged,
            frequencies: by_size(pairs.map(|pair| pair[1])),
            growth: Some(pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max)).filter(|growth| *growth > 0.0),
            changes: [None, None, None],
            beside: along(solver, curve, l.to_f64())
                .or_else(|| beside(solver, [&h, &l], size(solver.body(), &l, omega), is_exact)),
        }
    }
}

/// The regions beside a curve at l > 0, from the order of the curves.
fn along(solver: &Solver, curve: Option<CurveName>, l: f64) -> Option<[Spot; 2]> {
    let atlas = solver.atlas().filter(|_| l > 0.0)?;
    let regions = atlas.beside(curve?, l)?;
    Some(regions.map(|region| region.map_or(Spot::Forbidden, Spot::Region)))
}

/// 0 where the angle is one of rounding.
fn resolved(angle: f64) -> f64 {
    if angle <= SAME { 0.0 } else { angle }
}

fn by_size([p, q]: [f64; 2]) -> [f64; 2] {
    [p.min(q), p.max(q)]
}

/// The size of the energies.
fn size(body: &Body, l: &Number, omega: &RBig) -> f64 {
    let size = norm(body.center_f64()) + 0.5 * l.to_f64() * omega.to_f64().value();
    // At rest without weight there is no other energy to compare with.
    if size > 0.0 { size } else { 1.0 }
}

/// The changes at the next smaller spin than that with this square, at itself, and at the next larger one.
fn changes_beside(changes: &[RotationChange], squared: &RBig) -> [Option<RotationChange>; 3] {
    let at = |place: Ordering| changes.iter().filter(move |change| change.place_of(squared) == place);
    [at(Ordering::Greater).next_back(), at(Ordering::Equal).next(), at(Ordering::Less).next()].map(Option::<&_>::cloned)
}

/// The regions just below and just above a point of a curve. Of a point exactly on it they are found a tiny step away, where the
/// nearest curve is as far away as the step, to a thousandth of it: none lies between that is farther from the point than this.
/// Else that curve is still the nearest one there, so no other lies between, to a rounding; where the point cannot be classified, as
/// where the body's numbers are roots known to finitely many digits, no curve is its own, and the distance decides again.
fn beside(solver: &Solver, [h, l]: [&Number; 2], size: f64, is_exact: bool) -> Option<[Spot; 2]> {
    /// By how much of the step a point may miss its curve, and by how much of the size.
    const MISSED: f64 = 1e-3;
    const ROUNDING: f64 = 1e-14;
    let here = solver.classify(h, l).ok();
    let is_on_curve = here.as_ref().is_some_and(|found| matches!(found.answer, Answer::Critical(_)));
    let curve = here.and_then(|found| found.margin.nearest);
    let near = |step: RBig, curve: Option<&CurveName>| {
        let distance = step.to_f64().value().abs();
        let h = Number::from_rational(h.value() + step);
        let is_beside = |margin: &Margin| match curve {
            Some(curve) => margin.nearest.as_ref() == Some(curve),
            None => (margin.h - distance).abs() <= (MISSED * distance).min(ROUNDING * size),
        };
        let found = solver.classify(&h, l).ok().filter(|found| is_beside(&found.margin))?;
        Some(solver.spot(&h, l, &found.answer)).filter(|spot| matches!(spot, Spot::Region(_) | Spot::Forbidden))
    };
    // A point whose h or l is a root misses its curve by the rounding of that.
    if is_on_curve {
        let closest = |side: f64| near(RBig::try_from(side * CLOSEST * size).ok()?, None);
        if let (Some(below), Some(above)) = (closest(-1.0), closest(1.0)) {
            return Some([below, above]);
        }
    }
    let steps = if is_exact { &STEPS[..] } else { &STEPS[..ROUNDED] };
    let region = |side: f64| {
        let steps = || steps.iter().filter_map(move |step| RBig::try_from(side * step * size).ok());
        let of_its_curve = steps().find_map(|step| near(step, curve.as_ref()));
        // Where curves meet at an irrational l, which of them is the nearest depends on the last digit that is kept.
        of_its_curve.or_else(|| steps().rev().find_map(|step| near(step, None)))
    };
    let both = [region(-1.0)?, region(1.0)?];
    // Across one curve the topology changes: these are beyond another curve, nearer than the rounding of the point.
    (both[0] != both[1] || is_on_curve).then_some(both)
}
