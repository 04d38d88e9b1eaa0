//! What is sought.

use std::fmt;

use thiserror::Error;

use crate::signature::ComponentType;
use bifdiag_diagram::topology::{Component, Poles, Surface};

/// What a region, or a body, must show.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A component of U with these numbers of boundary circles and poles; `None`: any number.
    Component {
        /// Boundary circles.
        circles: Option<u32>,
        /// Poles.
        poles: Option<u32>,
    },
    /// A component whose section is this surface.
    Section(Surface),
    /// A region whose components have exactly these sections, by rising genus.
    Signature(Vec<Surface>),
    /// This many isolated relative equilibria at one l, or more.
    CriticalPoints(u32),
}

/// Why a text is not a target.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ParseTargetError {
    /// Not a type.
    #[error("`{text}` is no type; write a section such as M4, or boundary circles and poles such as k3n1")]
    Type {
        /// What was written.
        text: String,
    },
    /// Not a signature.
    #[error("`{text}` is no section; a signature is the names of sections joined by +, such as S2+T2")]
    Signature {
        /// The part that is no section.
        text: String,
    },
}

/// The closed surface of this name.
fn section(text: &str) -> Option<Surface> {
    text.parse().ok().filter(|surface: &Surface| surface.boundary_circles == 0)
}

/// By rising genus, in which regions mostly list their components.
fn sort(surfaces: &mut [Surface]) {
    surfaces.sort_by_key(|surface| surface.genus);
}

impl Target {
    /// `M4`, `T2`, `k3n1`.
    ///
    /// # Errors
    /// [`ParseTargetError::Type`].
    pub fn of_type(text: &str) -> Result<Self, ParseTargetError> {
        let text = text.trim();
        if let Some(surface) = section(text) {
            return Ok(Self::Section(surface));
        }
        let kind: ComponentType =
            text.parse().map_err(|_no_component| ParseTargetError::Type { text: text.to_owned() })?;
        Ok(Self::Component { circles: Some(kind.circles), poles: Some(kind.poles) })
    }

    /// `S2+T2`, in any order.
    ///
    /// # Errors
    /// [`ParseTargetError::Signature`].
    pub fn of_signature(text: &str) -> Result<Self, ParseTargetError> {
        let read = |name: &str| section(name).ok_or_else(|| ParseTargetError::Signature { text: name.to_owned() });
        let mut surfaces: Vec<Surface> = text.split('+').map(|name| read(name.trim())).collect::<Result<_, _>>()?;
        sort(&mut surfaces);
        Ok(Self::Signature(surfaces))
    }

    /// True for a component that is sought for itself.
    fn accepts(&self, component: &Component) -> bool {
        match self {
            Self::Component { circles, poles } => {
                circles.is_none_or(|k| k == component.boundary_circles)
                    && poles.is_none_or(|n| Some(n) == component.poles.map(Poles::count))
            }
            Self::Section(surface) => component.section_surface() == Some(*surface),
            Self::Signature(_) | Self::CriticalPoints(_) => false,
        }
    }

    /// True for a region with these components.
    #[must_use]
    pub fn accepts_region(&self, components: &[Component]) -> bool {
        match self {
            Self::Signature(wanted) => {
                let surfaces: Option<Vec<Surface>> = components.iter().map(Component::section_surface).collect();
                surfaces.is_some_and(|mut surfaces| {
                    sort(&mut surfaces);
                    surfaces == *wanted
                })
            }
            _ => components.iter().any(|component| self.accepts(component)),
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Component { circles, poles } => {
                if let Some(k) = circles {
                    write!(f, "k{k}")?;
                }
                if let Some(n) = poles {
                    write!(f, "n{n}")?;
                }
                Ok(())
            }
            Self::Section(surface) => write!(f, "{surface}"),
            Self::Signature(surfaces) => {
                let names: Vec<String> = surfaces.iter().map(Surface::to_string).collect();
                f.write_str(&names.join("+"))
            }
            Self::CriticalPoints(1) => f.write_str("at least 1 isolated relative equilibrium"),
            Self::CriticalPoints(count) => write!(f, "at least {count} isolated relative equilibria"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_and_signatures_are_read_in_any_order() {
        assert_eq!(Target::of_type("k3n0"), Ok(Target::Component { circles: Some(3), poles: Some(0) }));
        assert_eq!(Target::of_type("M4"), Ok(Target::Section(Surface::closed(4))));
        assert_eq!(Target::of_signature("T2+S2"), Target::of_signature("S2 + T2"));
        assert_eq!(Target::of_signature("T2+S2+M2").unwrap().to_string(), "S2+T2+M2");
        for wrong in ["", "k3", "n1", "k3n3", "M1", "M", "K3", "k-1n0", "k+1n0", "S3", "M02", "D2", "S2-2D2"] {
            assert_eq!(Target::of_type(wrong), Err(ParseTargetError::Type { text: wrong.to_owned() }));
        }
        for (wrong, part) in [("S2+", ""), ("S2,T2", "S2,T2"), ("S2+D2", "D2")] {
            assert_eq!(Target::of_signature(wrong), Err(ParseTargetError::Signature { text: part.to_owned() }));
        }
    }
}
