//! Periodic orbits as documents.

use bifdiag_body::Body;
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_periodic::family::{Family, Held, OrbitEvent, Stretch};
use bifdiag_periodic::orbit::PeriodicOrbit;
use bifdiag_schema::{
    CommandLine, FamilyEndingDocument, OrbitEventDocument, PeriodicBranchDocument, PeriodicFamiliesDocument,
    PeriodicFamilyDocument, PeriodicOrbitDocument,
};

use crate::body::{given, head};
use crate::subject::Subject;

/// An orbit whose existence is not proved.
#[must_use]
pub fn periodic_orbit(body: &Body, orbit: &PeriodicOrbit) -> PeriodicOrbitDocument {
    PeriodicOrbitDocument {
        h: orbit.h,
        l: orbit.l,
        gamma: orbit.start.gamma,
        omega: HeavyTop::new(body).inverse_inertia(orbit.start.l),
        crossings: orbit.crossings,
        period: orbit.period,
        multipliers: orbit.multipliers,
        stability: orbit.stability,
        action: orbit.action,
        symmetric: orbit.symmetric,
        proved: false,
        enclosure: None,
    }
}

/// The families of the given equilibria.
#[must_use]
pub fn periodic_families(
    subject: &Subject,
    command: CommandLine,
    (held, given_value): (Held, &str),
    found: &[(Equilibrium, Vec<Family>)],
) -> PeriodicFamiliesDocument {
    let body = &subject.body;
    let families = found.iter().flat_map(|(equilibrium, families)| {
        families.iter().map(move |family| PeriodicFamilyDocument {
            curve: equilibrium.curve.map(|curve| curve.to_string()),
            gamma: equilibrium.gamma,
            h: equilibrium.h,
            l: equilibrium.l,
            frequency: family.frequency,
            period: std::f64::consts::TAU / family.frequency,
            members: members(body, &family.stretch),
            events: family.stretch.events.iter().map(|event| of_event(body, event)).collect(),
            end: end(&family.stretch),
        })
    });
    let fixed = |kind| (held == kind).then(|| given_value.to_owned());
    PeriodicFamiliesDocument {
        head: head(command.json()),
        body: given(body),
        fixed_l: fixed(Held::Momentum),
        fixed_h: fixed(Held::Energy),
        families: families.collect(),
        part: subject.part.clone(),
    }
}

fn members(body: &Body, stretch: &Stretch) -> Vec<PeriodicOrbitDocument> {
    stretch.members.iter().map(|orbit| periodic_orbit(body, orbit)).collect()
}

fn of_event(body: &Body, event: &OrbitEvent) -> OrbitEventDocument {
    let branch = |branch: &Stretch| PeriodicBranchDocument { members: members(body, branch), end: end(branch) };
    OrbitEventDocument {
        kind: event.kind,
        after: event.after,
        h: event.orbit.h,
        l: event.orbit.l,
        period: event.orbit.period,
        error: event.error,
        branches: event.branches.iter().map(branch).collect(),
    }
}

/// The end of a family or a branch.
pub(crate) fn end(stretch: &Stretch) -> FamilyEndingDocument {
    let last = stretch.members.last();
    FamilyEndingDocument {
        kind: stretch.end.kind,
        curves: stretch.end.curves.clone(),
        h: last.map(|orbit| orbit.h),
        l: last.map(|orbit| orbit.l),
        period: last.map(|orbit| orbit.period),
    }
}
