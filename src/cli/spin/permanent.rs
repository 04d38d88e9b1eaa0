//! What changes with the spin of a permanent axis.

use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::Multiplicity;
use bifdiag_equilibria::permanent::{AxisRotation, PermanentAxis, SpinType, permanent_axis};
use bifdiag_numbers::Sign;
use bifdiag_schema::SpinChangeDocument;
use dashu_ratio::RBig;

use crate::cli::terminal::{Table, significant};

/// What changes with the spin of a permanent axis.
pub struct AxisChanges {
    /// By the end that is up, then by rising spin.
    pub of_type_and_region: Vec<SpinChangeDocument>,
    /// The type at the slowest spins, with either end up.
    pub slow: Option<[String; 2]>,
    /// The rotations themselves, each with the end that is up.
    pub rotations: Vec<(&'static str, AxisRotation)>,
}

/// The changes of stability and, with an atlas, of the regions.
pub fn changes_about(subject: &Subject, axis: PermanentAxis, atlas: Option<&Atlas>) -> AxisChanges {
    let (mut changes, mut slow, mut rotations) = (Vec::new(), Vec::new(), Vec::new());
    // γ points down.
    for (up, gamma) in [("+axis", Sign::Negative), ("-axis", Sign::Positive)] {
        let Some(rotation) = AxisRotation::about(&subject.body, axis, gamma) else { continue };
        changes.extend(bifdiag_documents::spin_changes(&rotation, up, atlas, subject.second()));
        slow.push(bifdiag_documents::type_name(&rotation, at_slow_spins(&rotation)).to_owned());
        rotations.push((up, rotation));
    }
    AxisChanges { of_type_and_region: changes, slow: slow.try_into().ok(), rotations }
}

/// The type at the slowest spins.
fn at_slow_spins(rotation: &AxisRotation) -> SpinType {
    let changes = rotation.changes();
    let any = || rotation.type_at_spin(&RBig::ONE).unwrap_or(SpinType::Elliptic);
    changes.first().map_or_else(any, |first| first.from)
}

/// That an axis which is permanent at every spin is one of a circle or sphere of them.
pub fn one_of(subject: &Subject, axis: [f64; 3]) -> Option<&'static str> {
    let axis = permanent_axis(&subject.body, subject.to_principal(axis))?;
    match AxisRotation::about(&subject.body, axis, Sign::Negative)?.multiplicity() {
        Multiplicity::Points(_) => None,
        Multiplicity::Circle => Some("it is one of a circle of permanent axes, which are judged as a whole"),
        Multiplicity::Sphere => Some("rotation about every axis is permanent"),
    }
}

/// The changes as a table; `without` stands where no change of regions is listed.
pub fn table_of_changes(changes: &[SpinChangeDocument], without: &str) -> String {
    let mut table = Table::new(&["up", "rpm", "rad/s", "below", "above", "regions", "h", "l", "error (rad/s)"]);
    for change in changes {
        table.row([
            change.up.clone(),
            significant(change.spin.rpm, 8),
            significant(change.spin.rad_per_s, 8),
            change.from.clone(),
            change.to.clone(),
            change.event.clone().unwrap_or_else(|| without.to_owned()),
            significant(change.h, 6),
            significant(change.l, 6),
            significant(change.error_bound, 1),
        ]);
    }
    table.text()
}
