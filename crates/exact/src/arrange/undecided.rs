//! What is not proved.

use bifdiag_equilibria::curves::CurveId;

/// Why nothing more is proved.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Undecided {
    /// Roots that cannot be told apart.
    Roots,
    /// A cusp on a pitchfork, or a degenerate point of the generic family.
    Degenerate,
    /// The order of two curves.
    Pair { curves: [CurveId; 2], x: [f64; 2] },
    /// Two events on a common curve.
    Events { curves: Vec<CurveId>, x: [f64; 2] },
    /// The order over one abscissa.
    Order { x: f64 },
    /// Orders on both sides of an event do not fit it.
    Gluing { x: f64 },
}
