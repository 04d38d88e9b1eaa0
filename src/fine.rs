//! Curves as fine as a picture needs them, for `plot`, which knows documents alone.

use plot::CurveSource;
use top::atlas::Atlas;

/// Polylines as fine as a magnification needs.
pub struct Curves<'a>(
    /// Whose curves.
    pub &'a Atlas,
);

impl CurveSource for Curves<'_> {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }
}
