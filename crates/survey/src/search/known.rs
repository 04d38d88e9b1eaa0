//! Points that are known to show something.

use super::score::Domain;
use super::target::Target;
use super::witness::Witness;
use bifdiag_body::Body;
use bifdiag_diagram::topology::Component;
use bifdiag_exact::Accuracy;
use bifdiag_numbers::Number;

/// A body and a point with the components of U_hl there.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownPoint {
    /// The body.
    pub body: Body,
    /// Energy.
    pub h: Number,
    /// Vertical angular momentum.
    pub l: Number,
    /// The components of U_hl.
    pub components: Vec<Component>,
}

/// The first of the known points that shows what is sought, with a body of the domain; confirmed anew.
#[must_use]
pub fn known_witness(known: &[KnownPoint], target: &Target, domain: &Domain, accuracy: Accuracy) -> Option<Witness> {
    let shows = |point: &&KnownPoint| target.accepts_region(&point.components) && domain.holds(&point.body);
    known.iter().filter(shows).find_map(|point| {
        let place = [point.h.clone(), point.l.clone()];
        Witness::confirm(point.body.clone(), place, target, accuracy).ok()
    })
}
