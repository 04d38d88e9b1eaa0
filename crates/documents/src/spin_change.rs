//! Spins, and what changes at them, as documents.

use bifdiag_body::part::Spin;
use bifdiag_diagram::region_changes::RotationChange;
use bifdiag_exact::EndUp;
use bifdiag_schema::{AxisEnd, SpinChangeDocument, SpinDocument};

/// A rate of turning, from rad/s.
#[must_use]
pub fn spin(rad_per_s: f64) -> SpinDocument {
    SpinDocument { rpm: Spin::rpm(rad_per_s), rad_per_s }
}

/// What is said where a body has no atlas.
pub(crate) const NO_REGIONS: &str = "the regions of this body were not found: only changes of stability are listed";

/// A rate of turning as it was asked for.
#[must_use]
pub fn asked_spin(spin: &Spin) -> SpinDocument {
    SpinDocument { rpm: spin.in_rpm(), rad_per_s: spin.rad_per_s() }
}

/// A change of a rotation with this end up; `second` is one second in the body's unit of time.
pub(crate) fn change(up: AxisEnd, found: &RotationChange, second: f64) -> SpinChangeDocument {
    let [from, to] = found.types;
    SpinChangeDocument {
        up,
        spin: spin(found.omega * second),
        l: found.l,
        h: found.h,
        kind: match (&found.stability, found.region) {
            (Some(_), Some(_)) => "stability-and-region",
            (Some(_), None) => "stability",
            _ => "region",
        }
        .to_owned(),
        from,
        to,
        event: found.region.map(|event| event.name().to_owned()),
        error_bound: found.error_bound * second,
    }
}

/// Everything that changes with the spin, for each end that is up.
pub(crate) fn changes(ends: &[EndUp; 2], second: f64) -> Vec<SpinChangeDocument> {
    ends.iter().flat_map(|end| end.changes.iter().map(|found| change(end.end, found, second))).collect()
}
