//! What is sought.

use std::fmt;

use thiserror::Error;

use top::topology::Component;

/// What a region, or a body, must show.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// A component of U with so many boundary circles and poles; `None`: any number.
    Component {
        /// Boundary circles.
        circles: Option<u32>,
        /// Poles.
        poles: Option<u32>,
    },
    /// A component whose section is this surface.
    Section(String),
    /// A region whose components have exactly these sections, in sorted order.
    Signature(Vec<String>),
    /// So many relative equilibria at one l, or more.
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

fn is_section(text: &str) -> bool {
    let genus = |digits: &str| digits.parse::<u32>().is_ok_and(|genus| genus >= 2) && !digits.starts_with('+');
    matches!(text, "S2" | "T2") || text.strip_prefix('M').is_some_and(genus)
}

impl Target {
    /// `M4`, `T2`, `k3n1`.
    ///
    /// # Errors
    /// [`ParseTargetError::Type`].
    pub fn of_type(text: &str) -> Result<Self, ParseTargetError> {
        let text = text.trim();
        if is_section(text) {
            return Ok(Self::Section(text.to_owned()));
        }
        let wrong = || ParseTargetError::Type { text: text.to_owned() };
        let (circles, poles) = text.strip_prefix('k').and_then(|rest| rest.split_once('n')).ok_or_else(wrong)?;
        let number = |digits: &str| digits.parse::<u32>().ok().filter(|_| !digits.starts_with('+')).ok_or_else(wrong);
        let (circles, poles) = (number(circles)?, number(poles)?);
        if poles > 2 {
            return Err(wrong());
        }
        Ok(Self::Component { circles: Some(circles), poles: Some(poles) })
    }

    /// `S2+T2`, in any order.
    ///
    /// # Errors
    /// [`ParseTargetError::Signature`].
    pub fn of_signature(text: &str) -> Result<Self, ParseTargetError> {
        let mut names: Vec<String> = text.split('+').map(|name| name.trim().to_owned()).collect();
        if let Some(wrong) = names.iter().find(|name| !is_section(name)) {
            return Err(ParseTargetError::Signature { text: wrong.clone() });
        }
        names.sort();
        Ok(Self::Signature(names))
    }

    /// True for a component that is sought for itself.
    pub(super) fn accepts(&self, component: &Component) -> bool {
        match self {
            Self::Component { circles, poles } => {
                circles.is_none_or(|k| k == component.boundary_circles)
                    && poles.is_none_or(|n| Some(n) == component.poles.map(top::topology::Poles::count))
            }
            Self::Section(name) => component.section().as_ref() == Some(name),
            Self::Signature(_) | Self::CriticalPoints(_) => false,
        }
    }

    /// True for a region with these components.
    #[must_use]
    pub fn accepts_region(&self, components: &[Component]) -> bool {
        match self {
            Self::Signature(wanted) => {
                let names: Option<Vec<String>> = components.iter().map(Component::section).collect();
                names.is_some_and(|mut names| {
                    names.sort();
                    names == *wanted
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
            Self::Section(name) => f.write_str(name),
            Self::Signature(names) => f.write_str(&names.join("+")),
            Self::CriticalPoints(count) => write!(f, "{count} relative equilibria"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_and_signatures_are_read_in_any_order() {
        assert_eq!(Target::of_type("k3n0"), Ok(Target::Component { circles: Some(3), poles: Some(0) }));
        assert_eq!(Target::of_type("M4"), Ok(Target::Section("M4".into())));
        assert_eq!(Target::of_signature("T2+S2"), Target::of_signature("S2 + T2"));
        for wrong in ["", "k3", "n1", "k3n3", "M1", "M", "K3", "k-1n0", "k+1n0", "S3"] {
            assert!(Target::of_type(wrong).is_err(), "{wrong}");
        }
        assert!(Target::of_signature("S2+").is_err() && Target::of_signature("S2,T2").is_err());
    }
}
