//! The section and its return map, forward and backward in time.

use crate::chart::Surface;
use crate::flow::Phase;
use crate::section_map::SectionMap;

/// The section and its map, at l or, reversed, at −l.
pub struct World<'a> {
    /// Of the section there.
    pub map: SectionMap<'a>,
    /// At −l.
    pub is_reversed: bool,
}

impl World<'_> {
    /// The section.
    pub fn surface(&self) -> &Surface {
        self.map.surface()
    }

    /// A point of this world in the other one: the way back is the same.
    pub fn seen(&self, y: &Phase) -> Phase {
        if self.is_reversed { reversed(y) } else { *y }
    }
}

fn reversed(y: &Phase) -> Phase {
    Phase::new(y[0], y[1], y[2], -y[3], -y[4], -y[5])
}
