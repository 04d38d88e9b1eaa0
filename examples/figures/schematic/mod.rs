//! Schematic pictures of what a section is: nothing in them is computed from a body.

use bifdiag_plot::{Picture, PlotError, Theme};

mod cylinder;
mod shapes;
mod sheets;

/// A schematic picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Sheets by the sign of Ṡ overlap in projection; sheets by the sign of Δ do not.
    Sheets,
    /// Orbits near a point of tangency meet one sheet only.
    BothSheetsNeeded,
    /// The sphere without its poles is a cylinder with two polar circles.
    Cylinder,
}

/// Draws a scheme. Equal arguments give equal bytes.
///
/// # Errors
/// A failure of the drawing library.
pub fn draw_scheme(scheme: Scheme, theme: Theme) -> Result<Picture, PlotError> {
    match scheme {
        Scheme::Sheets => sheets::both_divisions(theme),
        Scheme::BothSheetsNeeded => sheets::near_tangency(theme),
        Scheme::Cylinder => cylinder::draw(theme),
    }
}
