//! What changes with the spin, as a table.

use bifdiag_schema::SpinChangeDocument;

use crate::cli::terminal::{Table, all_apart, bound};

/// The changes as a table; `without` is the entry where no change of regions is listed.
pub fn table_of_changes(changes: &[SpinChangeDocument], without: &str) -> String {
    let mut table = Table::new(&["up", "rpm", "rad/s", "below", "above", "regions", "h", "l", "error (rad/s)"]);
    // Of the two ends of an axis nothing is compared.
    let apart = |value: fn(&SpinChangeDocument) -> f64, digits: usize| -> Vec<String> {
        let ends = changes.chunk_by(|one, next| one.up == next.up);
        ends.flat_map(|end| all_apart(&end.iter().map(value).collect::<Vec<_>>(), digits)).collect()
    };
    let (rpm, rad_per_s) = (apart(|change| change.spin.rpm, 8), apart(|change| change.spin.rad_per_s, 8));
    let (h, l) = (apart(|change| change.h, 6), apart(|change| change.l, 6));
    for (k, change) in changes.iter().enumerate() {
        table.row([
            change.up.word().to_owned(),
            rpm[k].clone(),
            rad_per_s[k].clone(),
            change.from.word().to_owned(),
            change.to.word().to_owned(),
            change.event.clone().unwrap_or_else(|| without.to_owned()),
            h[k].clone(),
            l[k].clone(),
            bound(change.error_bound, 1),
        ]);
    }
    table.text()
}
