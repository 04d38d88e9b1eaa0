//! Which regions of an atlas a classified point lies in, or meets.

use super::locate::{Place, abscissa};
use super::{Atlas, Component};
use crate::body::Number;
use crate::diagram::RegionId;
use crate::topology::Answer;

/// Where curves start: below this x = l²/2 every curve from l = 0 is at its limit to the last bit.
const AT_REST: f64 = 1e-60;

impl Atlas {
    /// The regions at a point of known type, each once; `None` in the list is the forbidden region. A regular or forbidden
    /// point has one; a point on a curve each that meets there. `None` where this atlas cannot tell: what it knows of the
    /// regions near the point does not fit the answer, or fits it twice.
    #[must_use]
    pub fn places(&self, h: &Number, l: &Number, answer: &Answer) -> Option<Vec<Option<RegionId>>> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l.to_f64()).ok()?.max(AT_REST);
        let near = match self.locate_scaled(h.to_f64() / frame.energy_unit, x).place {
            Place::Region(region) => vec![Some(region)],
            Place::Forbidden => vec![None],
            Place::Undecided(places) => places,
        };
        let class = |place: &Option<RegionId>| match place {
            Some(region) => self.components(*region).ok(),
            None => Some([].as_slice()),
        };
        let of_class = |known: &[Component]| near.iter().copied().filter(|place| class(place) == Some(known)).collect();
        match answer {
            Answer::Regular(components) => only(of_class(components)),
            Answer::Forbidden => only(of_class(&[])),
            // At l = 0 regions end that no class of l = 0 itself shows.
            Answer::Critical(_) | Answer::Undecided(_) if l.value().is_zero() => Some(near),
            Answer::Critical(classes) | Answer::Undecided(classes) => {
                let known =
                    |place: &Option<RegionId>| class(place).is_some_and(|class| classes.iter().any(|c| c == class));
                let there: Vec<_> = near.iter().copied().filter(known).collect();
                let found = |c: &Vec<Component>| there.iter().any(|place| class(place) == Some(c));
                classes.iter().all(found).then_some(there)
            }
        }
    }
}

/// The list if it has one entry.
fn only(places: Vec<Option<RegionId>>) -> Option<Vec<Option<RegionId>>> {
    (places.len() == 1).then_some(places)
}
