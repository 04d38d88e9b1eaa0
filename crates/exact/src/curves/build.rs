//! Every curve of a body, once.

use super::list::Curves;
use super::place::{NotIsolated, ROOT_BITS};
use crate::model::Model;
use bifdiag_numbers::table::Table;

impl Curves {
    /// The curves of a body, with the bits of a proof.
    pub fn of(model: &Model) -> Result<Self, NotIsolated> {
        Self::new(model, ROOT_BITS)
    }

    /// Isolates all cusps (to `bits` bits) and cuts the families.
    pub fn new(model: &Model, bits: usize) -> Result<Self, NotIsolated> {
        let mut curves = Self {
            list: Table::new(),
            cusps: Table::new(),
            pitchforks: Table::new(),
            inflection: None,
            degenerate: Vec::new(),
        };
        match model.active.len() {
            0 => curves.add_euler(model),
            1 => curves.add_lines(model),
            _ => curves.add_generic(model, bits)?,
        }
        curves.add_pairs(model);
        if model.active.len() > 1 {
            curves.add_pole_lines();
        }
        Ok(curves)
    }
}
