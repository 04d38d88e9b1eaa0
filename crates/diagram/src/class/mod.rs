//! The class of a bifurcation diagram: the canonical form of its planar map.
//!
//! The half-plane l > 0 is closed by a frame to a disc. Curves between two events are edges, events are vertices, and the
//! regions are faces. Two bodies have one class exactly when their maps are the same: an orientation-preserving
//! homeomorphism of the half-plane that keeps l = 0 in place takes each region to a region of the same type, each curve
//! to a curve of the same kind and each event to an event of the same kind. Stability is left out; so is the direction of l
//! along a curve, and the order in l of events that have nothing to do with each other.
//!
//! A map that is connected and has one directed edge marked (the *root*: the lower edge of the frame, that leaves l = 0)
//! has no symmetry (Proposition 14.2 of docs/algorithms.md). So a walk over it from the root gives each vertex, edge
//! and face a number that depends on the map alone, and the text written with these numbers is the canonical form. The
//! class's name is the beginning of the SHA-256 of that text.
//!
//! Permuted or reflected axes and other units change nothing, since the arrangement is made in the frame of the body.

mod canonical;
mod kinds;
mod name;
mod planar_map;

use crate::atlas::Atlas;

pub use kinds::{EdgeKind, FaceKind, VertexKind};
pub use name::{ClassName, ParseClassNameError};
pub use name::{MapError, Unclassified};
pub use planar_map::PlanarMap;

/// A class of bifurcation diagrams.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Class {
    name: ClassName,
    text: String,
}

impl Class {
    /// The class of an atlas.
    ///
    /// # Errors
    /// [`Unclassified`] when something is undecided; there is never a guess.
    pub fn of(atlas: &Atlas) -> Result<Self, Unclassified> {
        let undecided = atlas.arrangement().undecided.len();
        if undecided > 0 {
            return Err(Unclassified::Undecided { count: undecided });
        }
        Ok(Self::of_map(&PlanarMap::of(atlas)?))
    }

    /// The class of a map.
    #[must_use]
    pub fn of_map(map: &PlanarMap) -> Self {
        let text = canonical::write(map, &canonical::number(map));
        Self { name: ClassName::of_text(&text), text }
    }

    /// How many regions it has, without the forbidden one, R0 of its text.
    #[must_use]
    pub fn regions(&self) -> usize {
        self.text.lines().filter(|line| line.starts_with('R') && !line.starts_with("R0 ")).count()
    }

    /// Its name: the first 12 hexadecimal digits of the SHA-256 of [`Class::text`].
    #[must_use]
    pub fn name(&self) -> &ClassName {
        &self.name
    }

    /// The canonical form: after a line with the version, one line for each region with its boundary.
    ///
    /// A line reads `R2 D2 & D2+: 5 saddle R3 x 7 P+ R4 . l=0 .`, the region and the components of U with their poles,
    /// then, with the region on the left, each edge with its number, its kind and the region beyond it, and behind each
    /// edge the kind of vertex: `x` crossing, `<` cusp, `Y` pitchfork, `.` where a curve meets the frame.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::{Body, Preset};

    fn class(body: &Body) -> Class {
        Class::of(&crate::fast::atlas(body).unwrap()).unwrap()
    }

    #[test]
    fn two_critical_points_give_the_simplest_map() {
        let class = class(&Preset::find("isotropic").unwrap().body());
        let expected = "map 1\n\
            R0 -: 0 h=-oo . 1 minimum=P+ R1 .\n\
            R1 D2+: 1 minimum=P+ R0 . 3 l=oo . 4 maximum=P- R2 . 2 l=0 .\n\
            R2 S2+-: 4 maximum=P- R1 . 5 h=oo .\n";
        assert_eq!(class.text(), expected);
    }

    /// Names of classes are kept in files: they must not change unnoticed.
    #[test]
    fn the_class_of_the_papers_body() {
        let class = class(&Preset::find("paper").unwrap().body());
        assert_eq!((class.name().as_str(), class.regions()), ("4b99dc25201f", 9), "{}", class.text());
        assert!(
            class.text().contains("R6 S2-2D2+: 14 maximum R2 Y 21 saddle-pair R4 x 15 P- R7 x\n"),
            "{}",
            class.text()
        );
    }
}
