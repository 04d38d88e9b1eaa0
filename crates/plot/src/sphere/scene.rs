//! What a picture of U on the Poisson sphere shows.

use schema::ComponentDocument;

/// A relative equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereEquilibrium {
    /// The vertical in body coordinates.
    pub gamma: [f64; 3],
    /// Morse index of U_l: 0 minimum, 1 saddle, 2 maximum.
    pub index: u8,
    /// The unit vector about which `gamma` turns, where a whole circle of equilibria is meant.
    pub circle_about: Option<[f64; 3]>,
}

/// The accessible region U_hl = {γ ∈ S²: U_l(γ) ≤ h}.
pub struct SphereScene<'a> {
    /// Printed above: the body.
    pub title: &'a str,
    /// Printed below the title: (h, l) and the region.
    pub caption: &'a str,
    /// U_l(γ) − h at a unit vector.
    pub potential_above: &'a dyn Fn([f64; 3]) -> f64,
    /// r̂; `None` for r = 0.
    pub r_hat: Option<[f64; 3]>,
    /// The components of U_hl in canonical order.
    pub components: &'a [ComponentDocument],
    /// The place in `components` of the component to which an accessible point belongs, where it can be told.
    pub component_of: &'a dyn Fn([f64; 3]) -> Option<usize>,
    /// The relative equilibria at this l.
    pub equilibria: &'a [SphereEquilibrium],
    /// From where the first view is taken; `None`: from beside r̂, a little above.
    pub view: Option<[f64; 3]>,
}
