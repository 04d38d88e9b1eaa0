//! All short periodic orbits at one point, as a document.

use bifdiag_body::{Body, IntegrableCase, Number};
use bifdiag_numbers::decimal::{self, counted, significant};
use bifdiag_periodic::list::{CHARTS, Gap, NearCurve, OrbitList};
use bifdiag_periodic::proof::OrbitProof;
use bifdiag_schema::{Ends, OrbitEnclosureDocument, PeriodicDocument, PeriodicOrbitDocument};
use dashu_ratio::RBig;

use crate::body::{given, head};
use crate::periodic::periodic_orbit;
use crate::subject::Subject;

/// The periodic orbits at a point with a limited number of crossings.
#[must_use]
pub fn periodic(subject: &Subject, [h, l]: [&Number; 2], crossings: u32, list: &OrbitList) -> PeriodicDocument {
    let body = &subject.body;
    let command = subject.command("periodic").option("h", h.text()).option("l", l.text());
    let command = command.option("crossings", crossings);
    PeriodicDocument {
        head: head(command.json()),
        body: given(body),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        crossings,
        orbits: listed_orbits(body, list),
        continua: list.continua.iter().map(|orbit| periodic_orbit(body, orbit)).collect(),
        index_sums: list.index_sums.clone(),
        complete: list.gaps.is_empty(),
        why: why(body, list),
        part: subject.part.clone(),
    }
}

/// The isolated orbits, proved or not.
pub(crate) fn listed_orbits(body: &Body, list: &OrbitList) -> Vec<PeriodicOrbitDocument> {
    let orbits = list.orbits.iter().map(|listed| {
        let document = periodic_orbit(body, &listed.orbit);
        match &listed.proof {
            Ok(proof) => PeriodicOrbitDocument { proved: true, enclosure: Some(enclosure(proof)), ..document },
            Err(_) => document,
        }
    });
    orbits.collect()
}

/// Digits of ends.
const DIGITS: usize = 17;

fn enclosure(proof: &OrbitProof) -> OrbitEnclosureDocument {
    let [g1, g2, g3, w1, w2, w3] = proof.state.map(ends);
    OrbitEnclosureDocument {
        gamma: [g1, g2, g3],
        omega: [w1, w2, w3],
        period: ends(proof.period),
        trace: ends(proof.trace),
    }
}

fn ends(bounds: [f64; 2]) -> Ends {
    // Bounds of what was proved are finite.
    decimal::outward(&bounds.map(|x| RBig::try_from(x).unwrap_or_default()), DIGITS)
}

/// What completeness rests on, or what may be missing.
pub(crate) fn why(body: &Body, list: &OrbitList) -> String {
    // Regular precessions: S vanishes along them.
    let lagrange = IntegrableCase::of(body).iter().any(|case| matches!(case, IntegrableCase::Lagrange(_)));
    let in_section =
        if lagrange { "; regular precessions lie in P, do not cross it, and were not looked for" } else { "" };
    found_or_missing(list) + in_section + "; `bifdiag verify` does not check this list"
}

/// The curve that bends P.
fn beside(near: &NearCurve) -> String {
    let NearCurve { curve, margin, within } = near;
    format!(
        ", within {} of where P is singular on the curve {curve}, which is {} away in h (choose h farther away)",
        // Rounded to two digits it is still a bound.
        significant(1.05 * within, 2),
        significant(*margin, 3)
    )
}

fn found_or_missing(list: &OrbitList) -> String {
    if list.gaps.is_empty() {
        let within = if list.slow == 0 {
            String::new()
        } else {
            format!("; orbits of a longer period than {:.3e} were not looked for", list.longest)
        };
        return format!(
            "evidence, not a proof: on each of {} cells of P, from nine samples each, the return has no fixed point, or one \
             whose index is the winding number round the cell; an orbit is missed if all its points lie in strips \
             between lines of tangency, narrower than the samples are apart{within}",
            list.effort[0]
        );
    }
    let gaps = list.gaps.iter().map(|gap| match gap {
        Gap::Cover { singular: 0, .. } => format!("P is not covered: more than {CHARTS} squares would be needed"),
        Gap::Cover { singular, near } => {
            let places = counted(*singular, "place is", "places are");
            format!("P is not covered: {places} too sharply bent{}", near.as_ref().map_or_else(String::new, beside))
        }
        Gap::Cells { count, spent, gamma: [x, y, z], at_tangency } => {
            let kind = if *at_tangency { " on the line of tangency" } else { "" };
            let fate = if *spent {
                let open = counted(*count, "cell was", "cells were");
                format!("{open} still open{kind} when the search ended after {} cells", list.effort[0])
            } else {
                format!("{}{kind} could not be decided", counted(*count, "cell", "cells"))
            };
            format!("{fate}, one of them at gamma = {x:.6},{y:.6},{z:.6}")
        }
        Gap::Points { count } => {
            format!("{} found at some of the crossings only", counted(*count, "orbit was", "orbits were"))
        }
    });
    gaps.collect::<Vec<_>>().join("; ")
}
