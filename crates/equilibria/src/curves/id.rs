//! Numbers of curves and of the points where they end.

use bifdiag_numbers::table::ids;

ids! {
    /// A curve of a [`CriticalSet`](super::CriticalSet).
    CurveId;
    /// A cusp.
    CuspId;
    /// A pitchfork.
    PitchforkId;
    /// A cluster of cusps that f64 does not count.
    ClusterId;
    /// An interval of μ between moments with r_k ≠ 0, numbered from μ = −∞: a branch of the generic family.
    IntervalId;
}
