//! Numbers of what only a proved atlas has.

use bifdiag_diagram::arrangement::SlabId;
use bifdiag_numbers::table::{Id, ids};

ids! {
    /// A meeting of a pole line with a critical curve.
    MeetingId;
    /// All events between two slabs, by rising x.
    TransitionId;
}

impl TransitionId {
    /// The slab that ends here.
    pub fn before(self) -> SlabId {
        SlabId::at(self.index())
    }

    /// The slab that begins here.
    pub fn after(self) -> SlabId {
        SlabId::at(self.index() + 1)
    }

    /// The transition at which a slab begins; `None`: at l = 0.
    pub fn at_start(slab: SlabId) -> Option<Self> {
        slab.index().checked_sub(1).map(Self::at)
    }

    /// The transition at which a slab ends; no transition has this number for the last slab.
    pub fn at_end(slab: SlabId) -> Self {
        Self::at(slab.index())
    }
}
