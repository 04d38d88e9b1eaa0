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

impl Answer {
    /// A region with these components may be that of the point, or meet there.
    #[must_use]
    pub fn allows(&self, components: &[Component]) -> bool {
        match self {
            Self::Regular(known) => known == components,
            Self::Forbidden => components.is_empty(),
            Self::Critical(classes) | Self::Undecided(classes) => classes.iter().any(|class| class == components),
        }
    }
}
