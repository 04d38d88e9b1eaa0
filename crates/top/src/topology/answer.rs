//! What is said of a point (h, l).

use super::component::Component;

/// The components of U_hl in canonical order; none below the lowest critical value.
pub type Components = Vec<Component>;

/// What is known of a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Inside a region, with these components.
    Regular(Components),
    /// Below the lowest critical value: U_hl is empty.
    Forbidden,
    /// Exactly on a curve (proved); each class that meets there, once.
    Critical(Vec<Components>),
    /// Closer to a curve than the error bound; each possible class, once.
    Undecided(Vec<Components>),
}
