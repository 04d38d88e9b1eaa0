//! Connected components of the accessible region and Table 1 of Schmidt, Dullin and Richter (2008).
//!
//! Compact orientable surfaces and their names.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// Which of the poles ±r̂ lie in a component of U_hl.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Poles {
    /// +r̂, the centre of mass hanging down (γ points down).
    pub plus: bool,
    /// −r̂.
    pub minus: bool,
}

impl Poles {
    /// How many poles lie in the component.
    #[must_use]
    pub fn count(self) -> u32 {
        u32::from(self.plus) + u32::from(self.minus)
    }
}

/// One connected component of U_hl, up to homeomorphism of (U_hl, poles).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Component {
    /// Number k of boundary circles: the component is S² minus k discs.
    pub boundary_circles: u32,
    /// The poles inside; `None` when r = 0, where no poles exist.
    pub poles: Option<Poles>,
}

impl Component {
    /// Genus of the component of the Poincaré section P_hl over this component of U_hl:
    /// g = k + n − 1 with k boundary circles and n poles, since P_hl is the double of the component
    /// minus n discs (Theorem 10.6 of docs/mathematics.md). `None` where the section does not exist (r = 0).
    ///
    /// The formula needs k + n ≥ 1; S² without poles does not occur, since U_hl = S² contains both.
    #[must_use]
    pub fn genus(&self) -> Option<u32> {
        self.poles.map(|poles| (self.boundary_circles + poles.count()).saturating_sub(1))
    }

    /// The component of U_hl itself.
    #[must_use]
    pub fn surface(&self) -> Surface {
        Surface::sphere_without_discs(self.boundary_circles)
    }

    /// The component of the section P_hl over it; `None` when r = 0.
    #[must_use]
    pub fn section_surface(&self) -> Option<Surface> {
        self.genus().map(Surface::closed)
    }

    /// Name of the component of U_hl: `S2`, `D2`, `S2-2D2`, `S2-3D2`, …
    #[must_use]
    pub fn accessible_region(&self) -> String {
        self.surface().to_string()
    }

    /// Name of the component of the energy surface E_hl over this component:
    /// `RP3`, `S3`, `S1xS2`, and connected sums of S¹×S²: `(S1xS2)#(S1xS2)`, `#3(S1xS2)`, …
    #[must_use]
    pub fn energy_surface(&self) -> String {
        match self.boundary_circles {
            0 => "RP3".to_owned(),
            1 => "S3".to_owned(),
            2 => "S1xS2".to_owned(),
            3 => "(S1xS2)#(S1xS2)".to_owned(),
            k => format!("#{}(S1xS2)", k - 1),
        }
    }

    /// Name of the component of the section P_hl: `S2`, `T2`, `M2`, `M3`, `M4`; `None` when r = 0.
    #[must_use]
    pub fn section(&self) -> Option<String> {
        self.section_surface().map(|surface| surface.to_string())
    }

    /// Sort key: boundary circles, number of poles, "+" before "-".
    pub(super) fn key(&self) -> (u32, u32, bool) {
        let poles = self.poles.unwrap_or_default();
        (self.boundary_circles, poles.count(), poles.minus)
    }
}

/// The whole sphere with both poles (none when r = 0): U_hl above the highest critical value.
#[must_use]
pub fn whole_sphere(has_poles: bool) -> Component {
    Component { boundary_circles: 0, poles: has_poles.then_some(Poles { plus: true, minus: true }) }
}

/// Brings components into the canonical order: by boundary circles, number of poles, "+" before "-".
pub fn sort_components(components: &mut [Component]) {
    components.sort_by_key(Component::key);
}

/// The same for components that carry something with them.
pub(super) fn sort_by_component<T>(components: &mut [(T, Component)]) {
    components.sort_by_key(|(_, component)| component.key());
}

/// The sections' names joined by "+" in canonical order, such as `S2+T2`; `None` when r = 0.
#[must_use]
pub fn signature(components: &[Component]) -> Option<String> {
    let names: Option<Vec<String>> = components.iter().map(Component::section).collect();
    names.map(|names| names.join("+"))
}

/// A compact, connected, orientable surface, up to homeomorphism.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Surface {
    /// Its genus.
    pub genus: u32,
    /// Number of its boundary circles.
    pub boundary_circles: u32,
}

/// A text that names no surface.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` does not name a surface; names are such as S2, T2, M2, D2, S2-2D2")]
pub struct ParseSurfaceError(String);

impl Surface {
    /// The closed surface of a genus: S², T², M²₂, …
    #[must_use]
    pub fn closed(genus: u32) -> Self {
        Self { genus, boundary_circles: 0 }
    }

    /// The sphere without k open discs with disjoint closures.
    #[must_use]
    pub fn sphere_without_discs(boundary_circles: u32) -> Self {
        Self { genus: 0, boundary_circles }
    }
}

impl fmt::Display for Surface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::sphere_without_discs(1) {
            return f.write_str("D2");
        }
        match self.genus {
            0 => f.write_str("S2")?,
            1 => f.write_str("T2")?,
            genus => write!(f, "M{genus}")?,
        }
        match self.boundary_circles {
            0 => Ok(()),
            circles => write!(f, "-{circles}D2"),
        }
    }
}

impl FromStr for Surface {
    type Err = ParseSurfaceError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || ParseSurfaceError(text.to_owned());
        let number = |digits: &str| digits.parse::<u32>().map_err(|_not_a_count| wrong());
        let (closed, discs) = text.split_once('-').unwrap_or((text, "0D2"));
        let boundary_circles = number(discs.strip_suffix("D2").ok_or_else(wrong)?)?;
        let surface = match closed {
            "D2" => Self::sphere_without_discs(1),
            "S2" => Self { genus: 0, boundary_circles },
            "T2" => Self { genus: 1, boundary_circles },
            _ => Self { genus: number(closed.strip_prefix('M').ok_or_else(wrong)?)?, boundary_circles },
        };
        // Each surface has one name.
        if surface.to_string() == text { Ok(surface) } else { Err(wrong()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn component(k: u32, plus: bool, minus: bool) -> Component {
        Component { boundary_circles: k, poles: Some(Poles { plus, minus }) }
    }

    #[test]
    fn table_1_of_the_paper() {
        let cases = [
            (1, false, false, "S2"),
            (2, false, false, "T2"),
            (3, false, false, "M2"),
            (1, true, false, "T2"),
            (2, false, true, "M2"),
            (3, true, false, "M3"),
            (0, true, true, "T2"),
            (1, true, true, "M2"),
            (2, true, true, "M3"),
            (3, true, true, "M4"),
        ];
        for (k, plus, minus, section) in cases {
            assert_eq!(component(k, plus, minus).section().as_deref(), Some(section));
        }
        assert_eq!(component(3, true, true).energy_surface(), "(S1xS2)#(S1xS2)");
        assert_eq!(
            (component(4, true, false).accessible_region(), component(5, true, true).energy_surface()),
            ("S2-4D2".to_owned(), "#4(S1xS2)".to_owned())
        );
    }

    #[test]
    fn components_are_sorted_by_circles_poles_and_sign() {
        let mut all = [
            component(1, false, true),
            component(2, false, false),
            component(1, true, false),
            component(1, false, false),
        ];
        sort_components(&mut all);
        assert_eq!(signature(&all).as_deref(), Some("S2+T2+T2+T2"));
        assert_eq!(all[1], component(1, true, false));
    }

    #[test]
    fn without_a_centre_of_mass_there_is_no_section() {
        let euler = Component { boundary_circles: 2, poles: None };
        assert_eq!((euler.genus(), euler.section()), (None, None));
        assert_eq!(signature(&[euler]), None);
    }

    #[test]
    fn names_are_read_back() {
        for text in ["S2", "T2", "M2", "M17", "D2", "S2-2D2", "S2-5D2", "T2-1D2"] {
            assert_eq!(text.parse::<Surface>().unwrap().to_string(), text);
        }
        for text in ["", "S", "M0", "M1", "M", "M02", "S2-1D2", "S2-0D2", "S2-D2", "D2-2D2", "S3", "M+2", "s2", " S2"] {
            assert_eq!(text.parse::<Surface>(), Err(ParseSurfaceError(text.to_owned())));
        }
    }
}
