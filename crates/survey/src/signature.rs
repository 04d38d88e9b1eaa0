//! What regions show, as keys under which they are counted.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use bifdiag_diagram::topology::{Component, ParseSurfaceError, Surface};

/// The surfaces of a region, in the order of its components: those of the section, or those of U where r = 0, so that
/// there is no section.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Signature(Vec<Surface>);

/// A component of U by its numbers k of boundary circles and n of poles; n = 0 where r = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ComponentType {
    /// Boundary circles.
    pub circles: u32,
    /// Poles.
    pub poles: u32,
}

/// A text that is not the type of a component.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is not the type of a component; types are such as k3n1")]
pub struct ParseComponentTypeError(String);

impl Signature {
    /// The signature of a region with these components.
    #[must_use]
    pub fn of(components: &[Component]) -> Self {
        let section: Option<Vec<Surface>> = components.iter().map(Component::section_surface).collect();
        Self(section.unwrap_or_else(|| components.iter().map(Component::surface).collect()))
    }

    /// The surfaces.
    #[must_use]
    pub fn surfaces(&self) -> &[Surface] {
        &self.0
    }
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, surface) in self.0.iter().enumerate() {
            let joint = if place == 0 { "" } else { "+" };
            write!(f, "{joint}{surface}")?;
        }
        Ok(())
    }
}

impl FromStr for Signature {
    type Err = ParseSurfaceError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        // A region without components is forbidden.
        if text.is_empty() {
            return Ok(Self(Vec::new()));
        }
        text.split('+').map(str::parse).collect::<Result<_, _>>().map(Self)
    }
}

impl ComponentType {
    /// The type of a component.
    #[must_use]
    pub fn of(component: &Component) -> Self {
        Self { circles: component.boundary_circles, poles: component.poles.unwrap_or_default().count() }
    }
}

impl fmt::Display for ComponentType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "k{}n{}", self.circles, self.poles)
    }
}

impl FromStr for ComponentType {
    type Err = ParseComponentTypeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || ParseComponentTypeError(text.to_owned());
        let (circles, poles) = text.strip_prefix('k').and_then(|rest| rest.split_once('n')).ok_or_else(wrong)?;
        let number = |digits: &str| digits.parse::<u32>().map_err(|_not_a_count| wrong());
        let found = Self { circles: number(circles)?, poles: number(poles)? };
        if found.poles <= 2 && found.to_string() == text { Ok(found) } else { Err(wrong()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_diagram::topology::Poles;

    #[test]
    fn keys_are_read_back() {
        for text in ["", "S2", "S2+T2", "M3+T2+T2", "D2+S2-2D2"] {
            assert_eq!(text.parse::<Signature>().unwrap().to_string(), text);
        }
        for text in ["k0n2", "k1n0", "k12n1"] {
            assert_eq!(text.parse::<ComponentType>().unwrap().to_string(), text);
        }
        for text in ["", "k1", "n1", "k1n3", "k01n1", "k+1n0", "k-1n0", "K1n0", "k1n0 "] {
            assert_eq!(text.parse::<ComponentType>(), Err(ParseComponentTypeError(text.to_owned())));
        }
        for (text, part) in [("S2+", ""), ("S2,T2", "S2,T2")] {
            assert_eq!(text.parse::<Signature>().map_err(Some), Err(part.parse::<Surface>().err()));
        }
    }

    #[test]
    fn without_a_section_the_accessible_region_is_the_signature() {
        let component = |k, poles| Component { boundary_circles: k, poles };
        let pole = Some(Poles { plus: true, minus: false });
        assert_eq!(Signature::of(&[component(2, pole), component(1, Some(Poles::default()))]).to_string(), "M2+S2");
        assert_eq!(Signature::of(&[component(2, None), component(0, None)]).to_string(), "S2-2D2+S2");
        assert_eq!(ComponentType::of(&component(2, None)), ComponentType { circles: 2, poles: 0 });
    }
}
