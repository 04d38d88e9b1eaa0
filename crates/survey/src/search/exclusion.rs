//! What no body shows: theorems instead of a search.

use std::fmt;

use super::target::Target;
use bifdiag_diagram::topology::{CIRCLES_MAX, accessible_regions};

/// The statement by which no body shows something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exclusion {
    /// A component without boundary is the whole sphere.
    Sphere,
    /// Three or more boundary circles, and no pole.
    ThreeCircles,
    /// More boundary circles than there can be.
    Circles,
    /// A section whose genus would need more boundary circles than there can be.
    Genus,
    /// Sections of several components that do not go together.
    Disconnected,
    /// More isolated relative equilibria at one l than there can be.
    RelativeEquilibria,
}

/// The most isolated relative equilibria at one l.
const RELATIVE_EQUILIBRIA_MAX: u32 = 14;

impl Exclusion {
    /// Why no body with r ≠ 0 shows what is sought; `None` where that is not known.
    #[must_use]
    pub fn of(target: &Target) -> Option<Self> {
        if let Target::CriticalPoints(count) = target {
            return (*count > RELATIVE_EQUILIBRIA_MAX).then_some(Self::RelativeEquilibria);
        }
        if accessible_regions().iter().any(|region| target.accepts_region(region)) {
            return None;
        }
        Some(match target {
            Target::Component { circles: Some(0), .. } => Self::Sphere,
            Target::Component { circles: Some(k), .. } if *k <= CIRCLES_MAX => Self::ThreeCircles,
            Target::Component { .. } => Self::Circles,
            Target::Signature(surfaces) if surfaces.len() > 1 => Self::Disconnected,
            _ => Self::Genus,
        })
    }
}

impl fmt::Display for Exclusion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sphere => {
                "a component of U without boundary circles is the whole sphere, which contains both poles (with r = 0 \
                 there are none, and such regions are counted as k0n0: `bifdiag --body euler`)"
            }
            Self::ThreeCircles => {
                "a component of U with three or more boundary circles contains the pole r̂ (Theorem 11.1 of \
                 docs/mathematics.md)"
            }
            Self::Circles => {
                "a component of U has at most five boundary circles (Proposition 11.8 of docs/mathematics.md)"
            }
            Self::Genus => {
                "a component of U has at most five boundary circles (Proposition 11.8 of docs/mathematics.md) and two \
                 poles, so its section has genus 6 at most"
            }
            Self::Disconnected => {
                "where U is not connected, it consists of two to five discs, or of a disc and an annulus (Proposition \
                 11.9 of docs/mathematics.md), and each pole lies in one of them at most"
            }
            Self::RelativeEquilibria => {
                "at one l there are at most 14 isolated relative equilibria (Theorem 4.9 of docs/mathematics.md)"
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn by_type(text: &str) -> Option<Exclusion> {
        Exclusion::of(&Target::of_type(text).unwrap())
    }

    #[test]
    fn what_the_theorems_exclude() {
        for (text, why) in [
            ("k0n0", Exclusion::Sphere),
            ("k0n1", Exclusion::Sphere),
            ("k3n0", Exclusion::ThreeCircles),
            ("k5n0", Exclusion::ThreeCircles),
            ("k6n1", Exclusion::Circles),
            ("k6n0", Exclusion::Circles),
            ("M7", Exclusion::Genus),
        ] {
            assert_eq!(by_type(text), Some(why), "{text}");
        }
        for possible in ["k0n2", "k1n0", "k2n2", "k3n1", "k4n2", "k5n1", "k5n2", "S2", "T2", "M2", "M6"] {
            assert_eq!(by_type(possible), None, "{possible}");
        }
        let circles = |circles, poles| Exclusion::of(&Target::Component { circles, poles });
        assert_eq!((circles(Some(3), None), circles(None, Some(0)), circles(Some(0), None)), (None, None, None));
        assert_eq!(circles(Some(9), None), Some(Exclusion::Circles));
    }

    #[test]
    fn signatures_that_no_body_has() {
        let of = |text: &str| Exclusion::of(&Target::of_signature(text).unwrap());
        // Two annuli; an annulus with both poles beside a disc with one; six discs; three components with a third pole.
        for text in ["M2+M2+S2", "M3+T2", "M4+S2", "S2+S2+S2+S2+S2+S2", "T2+T2+T2", "M2+T2+S2"] {
            assert_eq!(of(text), Some(Exclusion::Disconnected), "{text}");
        }
        assert_eq!(of("M8"), Some(Exclusion::Genus));
        for possible in ["S2", "M6", "S2+S2", "S2+T2", "T2+T2", "M2+S2", "M2+T2", "M3+S2", "S2+S2+T2", "S2+S2+S2+S2+M2"]
        {
            assert_eq!(of(possible), None, "{possible}");
        }
    }

    #[test]
    fn more_than_fourteen_relative_equilibria_are_excluded() {
        let of = |count| Exclusion::of(&Target::CriticalPoints(count));
        assert_eq!((of(14), of(15)), (None, Some(Exclusion::RelativeEquilibria)));
    }
}
