//! The table of an atlas' changes of stability.

use bifdiag_schema::StabilityChangeDocument;

use crate::cli::terminal::{Table, significant};

/// Significant digits.
const DIGITS: usize = 8;

/// Where the linear type changes along a branch; `None` without changes.
pub fn table(changes: &[StabilityChangeDocument]) -> Option<String> {
    let mut table = Table::new(&["l", "h", "change of stability", "curve", "from", "to"]);
    for change in changes {
        table.row([
            significant(change.l, DIGITS),
            significant(change.h, DIGITS),
            change.kind.word().to_owned(),
            change.onto.as_ref().map_or(change.curve.clone(), |onto| format!("{}, {onto}", change.curve)),
            change.from.word().to_owned(),
            change.to.word().to_owned(),
        ]);
    }
    (!changes.is_empty()).then(|| table.text())
}
