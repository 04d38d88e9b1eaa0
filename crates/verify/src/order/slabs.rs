//! Slabs: the order of the curves between two transitions.

use bifdiag_schema::{CertificateDocument, CertifiedSlab};
use dashu_ratio::RBig;

use super::events::Events;
use super::orders::Orders;
use super::pairs::Crossing;
use crate::Refused;
use crate::equilibria::pieces::{End, Pieces};
use crate::equilibria::places::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;

/// A curve over the abscissa of a slab.
pub(crate) struct Level {
    pub curve: usize,
    pub point: Point,
    pub height: Fixed,
}

/// A slab, checked.
pub(crate) struct Slab {
    pub x: RBig,
    /// By rising height.
    pub levels: Vec<Level>,
    /// The face that the certificate names above each curve.
    pub faces: Vec<String>,
}

/// The groups of events that the certificate does not order among themselves, by rising x.
struct Transitions<'a> {
    groups: &'a [Vec<usize>],
    events: &'a Events,
}

/// Checks crossings against the events, the order of transitions, and the order of the curves in every slab.
pub(crate) fn slabs(
    certificate: &CertificateDocument,
    orders: &Orders,
    events: &Events,
    crossings: &[Crossing],
) -> Result<Vec<Slab>, Refused> {
    events.compare_crossings(crossings)?;
    let transitions = Transitions::read(certificate, events)?;
    if certificate.slabs.len() != transitions.groups.len() + 1 {
        return Err(Refused::entry("slab", 0, "there must be one slab more than transitions"));
    }
    let read = |(number, claim)| slab(number, claim, orders, &transitions);
    certificate.slabs.iter().enumerate().map(read).collect()
}

/// The curves over another abscissa of a slab, which has the same order and faces.
pub(crate) fn level(
    certificate: &CertificateDocument,
    orders: &Orders,
    events: &Events,
    (number, claim): (usize, &CertifiedSlab),
) -> Result<Slab, Refused> {
    let transitions = Transitions::read(certificate, events)?;
    let listed = certificate.slabs.get(number).ok_or(Refused::Field { field: "slab" })?;
    let names = |slab: &CertifiedSlab| -> Vec<[String; 2]> {
        slab.curves.iter().map(|height| [height.curve.clone(), height.region.clone()]).collect()
    };
    if names(listed) != names(claim) {
        return Err(Refused::Field { field: "level" });
    }
    slab(number, claim, orders, &transitions)
}

impl<'a> Transitions<'a> {
    /// Groups that hold every event once, each wholly before the next.
    fn read(certificate: &'a CertificateDocument, events: &'a Events) -> Result<Self, Refused> {
        let refuse = |number, why| Err(Refused::entry("slab", number, why));
        let groups = &certificate.transitions;
        let listed = groups.iter().flatten().copied();
        if !listed.eq(0..events.x.len()) || groups.iter().any(Vec::is_empty) {
            return refuse(0, "the transitions do not hold every event once, by their numbers");
        }
        let transitions = Self { groups, events };
        if let Some(t) = (0..groups.len()).find(|&t| !transitions.is_one(t)) {
            return refuse(t, "events that are apart are in one transition");
        }
        match (1..groups.len()).find(|&t| transitions.high(t - 1) >= transitions.low(t)) {
            Some(t) => refuse(t, "the events on its two sides are not in order"),
            None => Ok(transitions),
        }
    }

    /// The enclosures of a transition overlap one after the other.
    fn is_one(&self, transition: usize) -> bool {
        let mut ranges: Vec<&[RBig; 2]> = self.groups[transition].iter().map(|&event| &self.events.x[event]).collect();
        ranges.sort();
        let mut reached = &ranges[0][1];
        ranges.iter().all(|range| {
            let joined = range[0] <= *reached;
            reached = reached.max(&range[1]);
            joined
        })
    }

    fn low(&self, transition: usize) -> Option<&RBig> {
        self.groups.get(transition)?.iter().map(|&event| &self.events.x[event][0]).min()
    }

    fn high(&self, transition: usize) -> Option<&RBig> {
        self.groups.get(transition)?.iter().map(|&event| &self.events.x[event][1]).max()
    }

    /// x lies between the transitions around a slab.
    fn hold(&self, slab: usize, x: &RBig) -> bool {
        let after = slab.checked_sub(1).and_then(|t| self.high(t));
        *x > RBig::ZERO && after.is_none_or(|limit| x > limit) && self.low(slab).is_none_or(|limit| x < limit)
    }

    /// The curves that live in a slab.
    fn alive(&self, pieces: &Pieces, slab: usize) -> Vec<usize> {
        let at = |end: End| {
            let event = self.events.of(end)?;
            self.groups.iter().position(|group| group.contains(&event))
        };
        let lives = |&curve: &usize| {
            let [from, to] = pieces.list[curve].ends;
            at(from).is_none_or(|t| t < slab) && at(to).is_none_or(|t| t >= slab)
        };
        (0..pieces.list.len()).filter(lives).collect()
    }
}

/// Every curve that lives in a slab, once, in the right order over its abscissa.
fn slab(number: usize, claim: &CertifiedSlab, orders: &Orders, transitions: &Transitions) -> Result<Slab, Refused> {
    let refuse = |why| Refused::entry("slab", number, why);
    let pieces = orders.pieces;
    let x = number::read(&claim.x)?;
    if !transitions.hold(number, &x) {
        return Err(refuse("its abscissa does not lie between the events around it"));
    }
    let alive = transitions.alive(pieces, number);
    let x_set = orders.spaces.set(&x);
    let mut levels: Vec<Level> = Vec::new();
    for height in &claim.curves {
        let curve = pieces.find(&height.curve)?;
        if !alive.contains(&curve) || levels.iter().any(|level| level.curve == curve) {
            return Err(refuse("it lists a curve that does not live there, or one twice"));
        }
        let point = orders.stand(curve, height.place.as_ref(), &x_set)?.point;
        let height = Spaces::height(&x_set, &point).ok_or_else(|| refuse("a height is unbounded"))?;
        levels.push(Level { curve, point, height });
    }
    if levels.len() != alive.len() {
        return Err(refuse("a curve is missing"));
    }
    for pair in levels.windows(2) {
        // The global minimum lies below every other curve (Proposition 4.3).
        let structural = pieces.list[pair[0].curve].lowest;
        let above = || orders.spaces.gap(&x_set, &pair[1].point, &pair[0].point).is_some_and(|gap| gap.is_positive());
        if !structural && !above() {
            return Err(refuse("its curves are not in the order that is claimed"));
        }
    }
    if levels.iter().skip(1).any(|level| pieces.list[level.curve].lowest) {
        return Err(refuse("the global minimum is not lowest"));
    }
    Ok(Slab { x, levels, faces: claim.curves.iter().map(|height| height.region.clone()).collect() })
}
