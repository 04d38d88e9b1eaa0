//! Manifolds of unstable periodic orbits, and the orbits that connect them, as a document.

use bifdiag_body::Number;
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_numbers::decimal::counted;
use bifdiag_periodic::list::OrbitList;
use bifdiag_periodic::manifold::{Curve, Manifolds};
use bifdiag_schema::{
    ConnectionDocument, ContactDocument, ManifoldCurveDocument, ManifoldDocument, ManifoldEnd, ManifoldsDocument,
};

use crate::body::{given, head};
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
    let command = command.option("crossings", crossings).option("length", length);
    let top = HeavyTop::new(body);
    let missing = missing(list, found);
    let of_list = why(body, list);
    ManifoldsDocument {
        head: head(command.json()),
        body: given(body),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        crossings,
        length,
        orbits: listed_orbits(body, list),
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
        complete: missing.is_empty() && list.gaps.is_empty(),
        why: if missing.is_empty() {
            format!(
                "computed in doubles, not proved: crossings of these curves outside 10⁻³ of the periodic orbits, but for pairs \
                 between neighbouring points, which are 0.02 apart at most; longer curves have more. Of the orbits: {of_list}"
            )
        } else {
            format!("{}. Of the orbits: {of_list}", missing.join("; "))
        },
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
        gaps: curve.gaps,
        end: curve.end.unwrap_or(ManifoldEnd::Work),
    }
}

/// What was not found of what was asked for.
fn missing(list: &OrbitList, found: &Manifolds) -> Vec<String> {
    let curves = || found.manifolds.iter().flat_map(|manifold| &manifold.curves);
    let short = curves().filter(|curve| curve.end == Some(ManifoldEnd::Work)).count();
    let torn: usize = curves().map(|curve| curve.gaps).sum();
    let mut missing = Vec::new();
    if short > 0 {
        missing.push(format!("{} not followed for the whole length", counted(short, "curve was", "curves were")));
    }
    if torn > 0 {
        missing.push(format!("{} in curves could not be closed", counted(torn, "gap", "gaps")));
    }
    if found.unresolved > 0 {
        let crossings = counted(found.unresolved, "crossing", "crossings");
        missing.push(format!("{crossings} of the polylines could not be refined"));
    }
    if !found.left_out.is_empty() {
        let orbits = counted(found.left_out.len(), "orbit", "orbits");
        let sizes = found.left_out.iter().filter_map(|place| list.orbits.get(*place));
        let sizes: Vec<String> = sizes.map(|listed| format!("{:.6}", listed.orbit.multipliers[0][0])).collect();
        missing.push(format!("the manifolds of {orbits} were not followed, of multiplier {}", sizes.join(", ")));
    }
    missing
}
