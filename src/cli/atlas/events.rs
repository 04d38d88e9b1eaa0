//! The table of an atlas' events.

use bifdiag_schema::{EventDocument, EventKind};

use crate::cli::terminal::{Table, significant};

/// Significant digits.
const DIGITS: usize = 8;

/// Cusps, pitchforks and crossings by rising l; `None` without events.
pub fn table(events: &[EventDocument]) -> Option<String> {
    let mut table = Table::new(&["event", "kind", "l", "h", "curves"]);
    for (place, event) in events.iter().enumerate() {
        let kind = match event.kind {
            EventKind::Cusp => "cusp",
            EventKind::Pitchfork => "pitchfork",
            EventKind::Crossing => "crossing",
        };
        table.row([
            format!("E{}", place + 1),
            kind.to_owned(),
            significant(event.l, DIGITS),
            significant(event.h, DIGITS),
            event.curves.join(", "),
        ]);
    }
    (!events.is_empty()).then(|| table.text())
}
