//! Manifolds of unstable periodic orbits or equilibria, and the orbits that connect them, as a document.

use bifdiag_body::Number;
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_numbers::decimal::counted;
use bifdiag_periodic::list::OrbitList;
use bifdiag_periodic::manifold::{Curve, Manifolds};
use bifdiag_schema::{
    CommandLine, ConnectionDocument, ContactDocument, ManifoldCurveDocument, ManifoldDocument, ManifoldEnd,
    ManifoldsDocument,
};

use crate::body::{given, head};
use crate::critical::equilibrium;
use crate::orbit_list::{listed_orbits, why};
use crate::subject::Subject;

/// The manifolds of the unstable orbits of a list, of curves of a length that was asked for.
#[must_use]
pub fn manifolds(
    subject: &Subject,
    [h, l]: [&Number; 2],
    (crossings, length): (u32, f64),
    list: &OrbitList,
    found: &Manifolds,
) -> ManifoldsDocument {
    let body = &subject.body;
    let command = subject.command("periodic manifolds").option("h", h.text()).option("l", l.text());
    let mut missing = missing(found);
    if !found.left_out.is_empty() {
        let orbits = counted(found.left_out.len(), "orbit", "orbits");
        let sizes = found.left_out.iter().filter_map(|place| list.orbits.get(*place));
        let sizes: Vec<String> = sizes.map(|listed| format!("{:.6}", listed.orbit.multipliers[0][0])).collect();
        let multipliers = if sizes.len() == 1 { "multiplier" } else { "multipliers" };
        missing.push(format!("the manifolds of {orbits} were not followed ({multipliers} {})", sizes.join(", ")));
    }
    let of_list = why(body, list);
    ManifoldsDocument {
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        crossings,
        orbits: listed_orbits(body, list),
        complete: missing.is_empty() && list.gaps.is_empty(),
        why: if missing.is_empty() {
            format!(
                "computed in doubles, not proved: crossings of these curves outside 10⁻³ of the periodic orbits, but for pairs \
                 between neighbouring points, which are 0.02 apart at most; longer curves have more. Of the orbits: {of_list}"
            )
        } else {
            format!("{}. Of the orbits: {of_list}", missing.join("; "))
        },
        ..document(subject, command.option("crossings", crossings), length, found)
    }
}

/// The manifolds of the equilibria of a curve at an l.
#[must_use]
pub fn equilibrium_manifolds(
    subject: &Subject,
    (curve, l): (&str, &Number),
    length: f64,
    equilibria: &[Equilibrium],
    found: &Manifolds,
) -> ManifoldsDocument {
    let command = subject.command("periodic manifolds").option("from", curve).option("l", l.text());
    let missing = missing(found);
    let what = if found.manifolds.iter().all(|manifold| manifold.are_motions) {
        "motions that agree at all points to 10⁻¹⁰ are the same, or differ by less, as they may where the body is not integrable \
         and turns many times while it leaves"
    } else {
        "crossings of these curves outside 10⁻³ of the equilibria, but for pairs between neighbouring points, which are 0.02 apart \
         at most; longer curves have more"
    };
    ManifoldsDocument {
        h: equilibria.first().map_or_else(String::new, |found| format!("{:?}", found.h)),
        l: l.text().to_owned(),
        equilibria: equilibria.iter().map(equilibrium).collect(),
        complete: missing.is_empty(),
        why: if missing.is_empty() { format!("computed in doubles, not proved: {what}") } else { missing.join("; ") },
        ..document(subject, command, length, found)
    }
}

/// What both have in common.
fn document(subject: &Subject, command: CommandLine, length: f64, found: &Manifolds) -> ManifoldsDocument {
    let top = HeavyTop::new(&subject.body);
    ManifoldsDocument {
        head: head(command.option("length", length).json()),
        body: given(&subject.body),
        h: String::new(),
        l: String::new(),
        crossings: 0,
        length,
        equilibria: Vec::new(),
        orbits: Vec::new(),
        manifolds: found
            .manifolds
            .iter()
            .map(|manifold| ManifoldDocument {
                orbit: manifold.orbit,
                kind: manifold.kind,
                multiplier: manifold.multiplier,
                curves: manifold.curves.iter().map(curve).collect(),
            })
            .collect(),
        connections: found
            .connections
            .iter()
            .map(|connection| ConnectionDocument {
                from: connection.from,
                to: connection.to,
                gamma: connection.state.gamma,
                omega: top.inverse_inertia(connection.state.l),
                angle: connection.angle,
                residual: connection.residual,
                points: connection.points,
            })
            .collect(),
        contacts: found.contacts.iter().map(|contact| ContactDocument { from: contact.from, to: contact.to }).collect(),
        complete: false,
        why: String::new(),
        part: subject.part.clone(),
    }
}

fn curve(curve: &Curve) -> ManifoldCurveDocument {
    ManifoldCurveDocument {
        point: curve.point,
        side: curve.side,
        length: curve.length,
        points: curve.pieces.iter().map(Vec::len).sum(),
        tangencies: curve.tangencies,
        rests: curve.rests,
        gaps: curve.gaps,
        nearest: curve.nearest,
        end: curve.end.unwrap_or(ManifoldEnd::Work),
    }
}

/// What was not found of what was asked for.
fn missing(found: &Manifolds) -> Vec<String> {
    let curves = |are_motions: bool, end: ManifoldEnd| {
        let own = found.manifolds.iter().filter(move |manifold| manifold.are_motions == are_motions);
        own.flat_map(|manifold| &manifold.curves).filter(move |curve| curve.end == Some(end))
    };
    let short = curves(false, ManifoldEnd::Work).count();
    let long: Vec<&Curve> = curves(true, ManifoldEnd::Work).collect();
    let inaccurate = curves(true, ManifoldEnd::Accuracy).count();
    let torn: usize = found.manifolds.iter().flat_map(|manifold| &manifold.curves).map(|curve| curve.gaps).sum();
    let mut missing = Vec::new();
    if short > 0 {
        missing.push(format!("{} not followed for the whole length", counted(short, "curve was", "curves were")));
    }
    if let Some(motion) = long.first() {
        let points: usize = motion.pieces.iter().map(Vec::len).sum();
        missing.push(format!("{} followed for {points} points", counted(long.len(), "motion was", "motions were")));
    }
    if inaccurate > 0 {
        let motions = counted(inaccurate, "motion was", "motions were");
        missing.push(format!("{motions} followed no further than they can be computed to 10⁻⁸"));
    }
    if torn > 0 {
        missing.push(format!("{} in curves could not be closed", counted(torn, "gap", "gaps")));
    }
    if found.unresolved > 0 {
        let crossings = counted(found.unresolved, "crossing", "crossings");
        missing.push(format!("{crossings} of the polylines could not be refined"));
    }
    missing
}
