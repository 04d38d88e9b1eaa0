//! The curves of a body.

use super::curve::{Curve, Cusp, Pitchfork};
use super::place::Place;
use bifdiag_equilibria::curves::{CurveId, CuspId, PitchforkId};
use bifdiag_numbers::table::Table;

/// The curves of a body.
#[derive(Clone, Debug)]
pub(crate) struct Curves {
    pub list: Table<CurveId, Curve>,
    pub cusps: Table<CuspId, Cusp>,
    pub pitchforks: Table<PitchforkId, Pitchfork>,
    /// The one place where dJ/dμ = 0 on the generic family.
    pub inflection: Option<(usize, Place)>,
    /// Degenerate points that are no cusp (roots of even multiplicity) or that coincide with a pitchfork.
    pub degenerate: Vec<Place>,
}
