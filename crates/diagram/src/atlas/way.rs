//! The curves that a straight way through the (h, l) plane goes over.

use super::Atlas;
use super::locate::Place;
use crate::arrangement::RegionId;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_equilibria::curves::MomentumError;

/// One curve that a way goes over; `None` is the forbidden region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Passage {
    /// The nearest curve where the regions change: in general position, the one between them.
    pub curve: CurveId,
    /// The region before it.
    pub from: Option<RegionId>,
    /// The region behind it.
    pub to: Option<RegionId>,
}

/// The place at t ∈ [0, 1] of the path; the outer `None` where `f64` does not decide.
type Stop = (f64, Option<Option<RegionId>>);

/// The path is sampled in this many equal parts, so that a region that it enters and leaves on the same side is seen
/// unless it contains less than one such part.
const PARTS: u32 = 64;

/// Halvings of a part: what changes within 2^−24 of it changes at once.
const HALVINGS: u32 = 24;

impl Atlas {
    /// The curves between (h, l) = `from` and `to`, in their order on the straight way. Where regions change closer together
    /// than 10^−9 of the way, one passage leads from the first to the last.
    ///
    /// # Errors
    /// [`MomentumError`] when |l| is out of range at an end.
    pub fn passages(&self, from: [f64; 2], to: [f64; 2]) -> Result<Vec<Passage>, MomentumError> {
        let walk = Walk { atlas: self, from, to };
        let mut passages = Vec::new();
        let mut last = walk.stop(0.0)?;
        for part in 1..=PARTS {
            let next = walk.stop(f64::from(part) / f64::from(PARTS))?;
            if last.1.is_none() {
                last = next;
            } else if next.1.is_some() {
                walk.between(last, next, HALVINGS, &mut passages)?;
                last = next;
            }
        }
        Ok(passages)
    }
}

struct Walk<'a> {
    atlas: &'a Atlas,
    from: [f64; 2],
    to: [f64; 2],
}

impl Walk<'_> {
    fn at(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + t * (self.to[k] - self.from[k]))
    }

    fn stop(&self, t: f64) -> Result<Stop, MomentumError> {
        let [h, l] = self.at(t);
        Ok((
            t,
            match self.atlas.locate(h, l)?.place {
                Place::Region(region) => Some(Some(region)),
                Place::Forbidden => Some(None),
                Place::Undecided(_) => None,
            },
        ))
    }

    /// The passages between two stops whose regions are known.
    fn between(&self, one: Stop, two: Stop, halvings: u32, found: &mut Vec<Passage>) -> Result<(), MomentumError> {
        let (Some(from), Some(to)) = (one.1, two.1) else { return Ok(()) };
        if from == to {
            return Ok(());
        }
        let middle = 0.5 * (one.0 + two.0);
        let stop = self.stop(middle)?;
        if halvings == 0 || stop.1.is_none() {
            let [h, l] = self.at(middle);
            found.push(Passage { curve: self.atlas.locate(h, l)?.nearest, from, to });
            return Ok(());
        }
        self.between(one, stop, halvings - 1, found)?;
        self.between(stop, two, halvings - 1, found)
    }
}
