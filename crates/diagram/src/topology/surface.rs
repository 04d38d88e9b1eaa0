//! Compact orientable surfaces and their names.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

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
