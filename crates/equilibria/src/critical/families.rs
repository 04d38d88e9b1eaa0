//! All steady axes by rising spin: the families of relative equilibria, each from the spin at which it begins.

use std::sync::Arc;

use dashu_ratio::RBig;

use super::found::{abscissa_of, middle};
use super::{Equilibrium, Multiplicity, RelativeEquilibria};
use crate::curves::{Branch, BranchName, CurveName, Orbit};
use crate::nonlinear::{Setting, VerdictChange, Verdicts};
use crate::stability::exact::Strand;
use crate::stability::{Constants, LinearType, StabilityChangeKind, State};
use bifdiag_body::{Axis, Body};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::vector::dot;
use bifdiag_numbers::wide::Wide;
use bifdiag_schema::{NonlinearVerdict, Reason, SteadyStart};

/// Steady axes that move with the spin without ever meeting others, from one spin to infinity.
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyFamily {
    /// The branch on which it lies; several families may lie on one.
    pub branch: BranchName,
    /// The branch in words.
    pub branch_name: Arc<str>,
    /// How it begins.
    pub start: SteadyStart,
    /// How many axes: one, a symmetric pair (2), a circle, or all (a sphere).
    pub axes: Multiplicity,
    /// The axis is the same at every spin.
    pub is_permanent: bool,
    /// γ at rest, in principal axes; `None` for a family that begins later.
    pub slow: Option<[f64; 3]>,
    /// γ in the limit of fast spins, of a pair one of the two, of a circle one of all.
    pub fast: [f64; 3],
    /// By rising spin, from the start to infinity.
    pub stretches: Vec<SteadyStretch>,
}

/// A range of spins in which a family has one type.
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyStretch {
    /// Where it begins; `None`: at rest.
    pub from: Option<FamilyPoint>,
    /// Which eigenvalues meet there; `None` where the family itself begins.
    pub change: Option<StabilityChangeKind>,
    /// The linear type.
    pub kind: LinearType,
    /// What eigenvalues, energy and integrals say of the stability; `None` at two imaginary pairs that are left to the normal
    /// form, which differs from spin to spin.
    pub verdict: Option<(NonlinearVerdict, Reason)>,
}

/// A point of a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FamilyPoint {
    /// Ω.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// l.
    pub l: f64,
    /// h.
    pub h: f64,
    /// γ in principal axes; of a pair one of the two.
    pub gamma: [f64; 3],
}

impl SteadyFamily {
    /// The spin at which it begins.
    #[must_use]
    pub fn slowest(&self) -> f64 {
        self.stretches.first().and_then(|first| first.from).map_or(0.0, |place| place.omega)
    }

    /// For each stretch the rotations among `exceptions` of the body that lie inside it and that the normal form would decide, by
    /// rising spin.
    #[must_use]
    pub fn isolated<'a>(
        &self,
        body: &Body,
        exceptions: &'a [(BranchName, VerdictChange)],
    ) -> Vec<Vec<&'a VerdictChange>> {
        let own = exceptions.iter().filter(|(branch, change)| self.has(body, *branch, change.mu));
        let mut own: Vec<&VerdictChange> = own.map(|(_, change)| change).collect();
        own.sort_by(|p, q| p.omega.total_cmp(&q.omega));
        let start = |number: usize| self.stretches.get(number).map(|one| one.from.map_or(0.0, |place| place.omega));
        let inside = |(number, stretch): (usize, &SteadyStretch)| {
            let [from, to] = [number, number + 1].map(|number| start(number).unwrap_or(f64::INFINITY));
            let is_inside = |omega: f64| stretch.verdict.is_none() && from < omega && omega < to;
            own.iter().copied().filter(|change| is_inside(change.omega)).collect()
        };
        self.stretches.iter().enumerate().map(inside).collect()
    }

    /// Whether a steady axis of the body belongs to the family.
    #[must_use]
    pub fn holds(&self, body: &Body, axis: &Equilibrium) -> bool {
        let Some(CurveName::Piece { branch, .. }) = axis.curve else { return false };
        self.has(body, branch, multiplier(body, axis.gamma, axis.omega))
    }

    /// Whether the family has the point of a branch at μ. Of two that begin in a fold each keeps its side of it: along a branch
    /// μ = J + ⟨γ, r⟩/s is monotone, and at fast spins it is the moment about the axis.
    fn has(&self, body: &Body, branch: BranchName, mu: f64) -> bool {
        let fold = self.stretches.first().and_then(|first| first.from).filter(|_| self.start == SteadyStart::Fold);
        branch == self.branch
            && fold.is_none_or(|fold| {
                let middle = multiplier(body, fold.gamma, fold.omega);
                (mu < middle) == (moment(body, self.fast) < middle)
            })
    }
}

impl SteadyStretch {
    /// The verdict, by Arnold's theorem where the normal form decides and all exceptions to it `are_known`.
    #[must_use]
    pub fn verdict_with(&self, are_known: bool) -> Option<(NonlinearVerdict, Reason)> {
        self.verdict.or_else(|| are_known.then_some((NonlinearVerdict::Stable, Reason::Arnold)))
    }
}

/// ⟨γ, Aγ⟩.
fn moment(body: &Body, gamma: [f64; 3]) -> f64 {
    let a = body.moments_f64();
    (0..3).map(|k| a[k] * gamma[k] * gamma[k]).sum()
}

/// μ = J + ⟨γ, r⟩/Ω².
fn multiplier(body: &Body, gamma: [f64; 3], omega: f64) -> f64 {
    moment(body, gamma) + dot(gamma, body.center_f64()) / (omega * omega)
}

/// How many steady axes there are from one spin on, to the next count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisCount {
    /// That spin Ω; `None`: from rest.
    pub from: Option<f64>,
    /// Axes by the end that is up, those of circles apart.
    pub axes: u32,
    /// Circles of axes.
    pub circles: u32,
}

/// How many steady axes there are by rising spin; starts closer than their error bounds are one.
#[must_use]
pub fn axis_counts(families: &[SteadyFamily]) -> Vec<AxisCount> {
    let mut starts: Vec<(Option<FamilyPoint>, Multiplicity)> =
        families.iter().map(|family| (family.stretches.first().and_then(|first| first.from), family.axes)).collect();
    let omega = |place: &Option<FamilyPoint>| place.map_or(0.0, |place| place.omega);
    starts.sort_by(|(p, _), (q, _)| omega(p).total_cmp(&omega(q)));
    let mut counts: Vec<AxisCount> = Vec::new();
    let mut reached = f64::NEG_INFINITY;
    for (from, axes) in starts {
        let error = from.map_or(0.0, |place| place.error_bound);
        if omega(&from) - error > reached {
            let [axes, circles] = counts.last().map_or([0, 0], |last| [last.axes, last.circles]);
            counts.push(AxisCount { from: from.map(|place| place.omega), axes, circles });
        }
        reached = omega(&from) + error;
        let Some(last) = counts.last_mut() else { continue };
        match axes {
            Multiplicity::Points(count) => last.axes += count,
            Multiplicity::Circle | Multiplicity::Sphere => last.circles += 1,
        }
    }
    counts
}

/// Bits of the numbers of a place.
const BITS: usize = 224;

impl RelativeEquilibria<'_> {
    /// Every family of steady axes, each with the exact order of its changes: the spins at which axes appear are the starts of
    /// families. `None` where roots are closer than 2^-4000.
    #[must_use]
    pub fn families(&self) -> Option<Vec<SteadyFamily>> {
        if self.set.frame.is_euler() {
            return self.families_without_weight();
        }
        let c = self.profile()?.constants(BITS);
        let family = |strand: &Strand| self.family(&c, strand);
        Some(self.profile()?.strands()?.iter().map(family).collect())
    }

    fn family(&self, c: &Constants<Wide>, strand: &Strand) -> SteadyFamily {
        let frame = &self.set.frame;
        let orbit = self.set.curves.iter().find(|curve| curve.branch == strand.branch).map(|curve| curve.orbit);
        let is_circle = matches!(orbit, Some(Orbit::Circle(_)));
        let on_axis = matches!(strand.branch, Branch::Axis(_));
        let integral = is_circle || (on_axis && self.set.is_lagrange());
        let stretch = |found: &crate::stability::exact::StrandStretch| SteadyStretch {
            from: found.from.as_ref().map(|state| self.place(c, state)),
            change: found.change,
            kind: found.kind,
            verdict: Setting { index: found.index, minimum: None, integral }.verdict(found.kind),
        };
        let (axis, side) = strand.fast;
        let unit = |axis: Axis, side: f64| Axis::ALL.map(|k| if k == axis { side } else { 0.0 });
        let fast = frame.vector_to_body(unit(axis, if side == Sign::Negative { -1.0 } else { 1.0 }));
        let slow = (strand.start == SteadyStart::Rest).then(|| {
            // Hanging at rest μ is large and positive, standing negative.
            let side = if side == Sign::Negative { -1.0 } else { 1.0 };
            frame.vector_to_body(frame.r_hat().map(|x| side * x))
        });
        SteadyFamily {
            branch: BranchName::of(frame, strand.branch),
            branch_name: self.words(strand.branch),
            start: strand.start,
            axes: match orbit {
                Some(Orbit::Circle(_)) => Multiplicity::Circle,
                Some(Orbit::Pair(_)) => Multiplicity::Points(2),
                _ => Multiplicity::Points(1),
            },
            is_permanent: on_axis,
            slow,
            fast,
            stretches: strand.stretches.iter().map(stretch).collect(),
        }
    }

    fn place(&self, c: &Constants<Wide>, state: &State<Wide>) -> FamilyPoint {
        let frame = &self.set.frame;
        let [(l, _), (h, _)] = state.place(c, frame);
        let omega = middle(&state.s.sqrt()) * frame.frequency_unit;
        let gamma = frame.vector_to_body(self.point(state, abscissa_of(state)).gamma);
        FamilyPoint { omega, error_bound: 4.0 * f64::EPSILON * omega, l, h, gamma }
    }

    /// Without weight the axes of the eigenspaces are steady, at every spin of one type.
    fn families_without_weight(&self) -> Option<Vec<SteadyFamily>> {
        let mut families: Vec<SteadyFamily> = Vec::new();
        for Equilibrium { gamma, multiplicity, stability, nonlinear, curve, branch_name, .. } in
            self.at_spin(&RBig::ONE).ok()?.list
        {
            let verdict = Some((nonlinear.verdict, nonlinear.why));
            let Some(CurveName::Piece { branch, .. }) = curve else { continue };
            if families.iter().any(|family| family.branch == branch) {
                continue;
            }
            families.push(SteadyFamily {
                branch,
                branch_name,
                start: SteadyStart::Rest,
                axes: if multiplicity == Multiplicity::Points(1) { Multiplicity::Points(2) } else { multiplicity },
                is_permanent: true,
                slow: Some(gamma),
                fast: gamma,
                stretches: vec![SteadyStretch { from: None, change: None, kind: stability, verdict }],
            });
        }
        Some(families)
    }

    /// The isolated relative equilibria at which a hypothesis of Arnold's theorem fails between others to which it applies,
    /// each with its branch, by rising l; `None` where not all were found. Elsewhere that theorem decides wherever
    /// eigenvalues, energy and integrals do not.
    #[must_use]
    pub fn exceptions(&self) -> Option<Vec<(BranchName, VerdictChange)>> {
        let verdicts = Verdicts::new(self.body, &self.set);
        let branch = |change: &VerdictChange| BranchName::of(&self.set.frame, self.set.curves[change.curve].branch);
        let inside = || verdicts.changes().iter().filter(|change| !change.changes);
        verdicts.is_complete().then(|| inside().map(|change| (branch(change), *change)).collect())
    }
}
