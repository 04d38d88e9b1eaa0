//! What pictures need of several layers at once; `plot` knows finished documents alone.

#[cfg(feature = "parallel")]
mod events;
#[cfg(feature = "parallel")]
mod existence;
mod manifolds;
#[cfg(feature = "parallel")]
mod map;
#[cfg(feature = "parallel")]
mod shown;

use bifdiag_body::Number;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::critical::critical;
use bifdiag_plot::CurveSource;
use bifdiag_schema::RelativeEquilibriumDocument;

#[cfg(feature = "parallel")]
pub use events::{EventScene, events, momenta};
pub use manifolds::{ManifoldBackground, ManifoldPictureError, manifolds};
#[cfg(feature = "parallel")]
pub use map::map;
#[cfg(feature = "parallel")]
pub use shown::{Seen, Shown, Shows};

/// Polylines as fine as a magnification needs.
pub struct Curves<'a>(
    /// Whose curves.
    pub &'a Atlas,
);

impl CurveSource for Curves<'_> {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline_to_draw(curve.parse().ok()?, l, tolerance)
    }

    fn equilibria(&self, l: f64) -> Vec<RelativeEquilibriumDocument> {
        let found = Number::from_f64(l).ok().and_then(|l| critical(self.0.body(), &l).ok());
        found.map_or_else(Vec::new, |found| bifdiag_documents::equilibria(&found))
    }
}
