//! The boundary ∂U of the accessible region: how many circles it has, and a point on each of them. Nothing else here
//! takes anything of the topology.

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

use super::equations::Zero;
use super::linear::PhaseVector;
use super::seeds::{Field, bisect};
use super::trace::{Traced, Tracer};
use crate::field::{State, dot, scale};
use crate::section::error::{SectionError, check_stop};
use bifdiag_body::Body;
use bifdiag_diagram::topology::latitude::{Arcs, Latitudes, components};

/// The most circles of latitude on which ∂U is looked for.
const MOST_ROWS: usize = 4096;

/// ∂U of a body at (h, l) as given: from its arcs on `rows` circles of latitude, and on more as long as circles are
/// missing. With the number of its circles, if the certified sweep decided it.
pub(super) fn traced_boundary(
    body: &Body,
    (h, l): (f64, f64),
    field: Field<'_>,
    rows: usize,
    tracer: Tracer<'_>,
) -> Result<(Vec<Traced>, Option<usize>), SectionError> {
    let frame = body.frame();
    let (h, l) = (h / frame.energy_unit, l / frame.momentum_unit);
    let parts = components(&frame, h, l).ok();
    let certified_circles = parts.map(|parts| parts.iter().map(|part| part.boundary_circles as usize).sum());
    let mut lines = Vec::new();
    if let Ok(latitudes) = Latitudes::new(&frame, h, l) {
        let mut rows = rows;
        loop {
            let seeds = on_latitudes(field, &latitudes, rows, tracer.stop)?;
            tracer.extend(&mut lines, seeds)?;
            rows *= 2;
            let complete = certified_circles.is_none_or(|circles| lines.len() >= circles);
            if complete || rows > MOST_ROWS {
                break;
            }
        }
    }
    Ok((lines, certified_circles))
}

/// Points of ∂U on `rows` circles of latitude.
///
/// Where one circle lies in U and the next does not, a point between the two.
fn on_latitudes(
    field: Field<'_>,
    latitudes: &Latitudes,
    rows: usize,
    stop: Option<&AtomicBool>,
) -> Result<Vec<PhaseVector>, SectionError> {
    let mut seeds = Vec::new();
    let mut before: Option<(f64, bool)> = None;
    for row in 0..=rows {
        check_stop(stop)?;
        let theta = PI * row as f64 / rows as f64;
        // A circle that touches ∂U within rounding is undecided; its neighbours are not.
        let Some((theta, arcs)) = [0.0, 1e-3, -1e-3].into_iter().find_map(|shift| {
            let theta = (theta + shift * PI / rows as f64).clamp(0.0, PI);
            latitudes.arcs_at(libm::cos(theta)).ok().map(|arcs| (theta, arcs))
        }) else {
            continue;
        };
        match arcs {
            Arcs::Part(arcs) => {
                before = None;
                for arc in arcs {
                    seeds.extend([arc.start, arc.end].map(|[cos, sin]| on_boundary(field, [cos, sin], theta)));
                }
            }
            whole => {
                let accessible = whole == Arcs::Everything;
                if let Some((above, _)) = before.filter(|(_, last)| *last != accessible) {
                    let change = bisect(|t| {
                        let place = [0.0, above + t * (theta - above)];
                        field.states(place).is_some() == accessible
                    });
                    seeds.push(on_boundary(field, [1.0, 0.0], above + change * (theta - above)));
                }
                before = Some((theta, accessible));
            }
        }
    }
    Ok(seeds.into_iter().filter_map(|guess| field.equations.polish(Zero::Sheets, &guess)).collect())
}

/// The state l = l Aγ/J over a point of ∂U.
fn on_boundary(field: Field<'_>, [cos, sin]: [f64; 2], theta: f64) -> PhaseVector {
    let gamma = field.torus.gamma(theta, libm::atan2(sin, cos));
    let moment = field.torus.top().inertia(gamma);
    field.equations.vector(&State { gamma, l: scale(field.equations.l / dot(gamma, moment), moment) })
}
