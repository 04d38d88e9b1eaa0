//! What changes with the spin, as a table.

use bifdiag_schema::SpinChangeDocument;

use crate::cli::terminal::{Table, bound, significant};

/// The changes as a table; `without` is the entry where no change of regions is listed.
pub fn table_of_changes(changes: &[SpinChangeDocument], without: &str) -> String {
    let mut table = Table::new(&["up", "rpm", "rad/s", "below", "above", "regions", "h", "l", "error (rad/s)"]);
    for change in changes {
        table.row([
            change.up.word().to_owned(),
            significant(change.spin.rpm, 8),
            significant(change.spin.rad_per_s, 8),
            change.from.word().to_owned(),
            change.to.word().to_owned(),
            change.event.clone().unwrap_or_else(|| without.to_owned()),
            significant(change.h, 6),
            significant(change.l, 6),
            bound(change.error_bound, 1),
        ]);
    }
    table.text()
}
