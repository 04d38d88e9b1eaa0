//! How long the lists of a certificate can be: compared before anything is worked out from them.

use bifdiag_schema::{CertificateDocument, CertifiedPair};

use super::meetings;
use super::pieces::Pieces;
use super::spaces::Spaces;
use crate::Refused;

/// Stretches of a pair of curves at most: the prover visits no more points of curves for one.
const STRETCHES: usize = 4000;

/// A list is not longer than the body allows.
fn is_short(what: &'static str, listed: usize, most: usize) -> Result<(), Refused> {
    if listed <= most { Ok(()) } else { Err(Refused::TooMany { what, listed, most }) }
}

/// Cusps and meetings: no more than the degrees of their polynomials.
pub(crate) fn roots(certificate: &CertificateDocument, spaces: &Spaces) -> Result<(), Refused> {
    let generic = if spaces.active.len() > 1 { spaces.cusp_polynomial().len() } else { 0 };
    is_short("cusps", certificate.cusps.len(), generic + spaces.passive().len())?;
    is_short("meetings", certificate.meetings.len(), meetings::most(spaces))
}

/// What is listed of curves and of the slabs between events.
pub(crate) fn lists(certificate: &CertificateDocument, spaces: &Spaces, pieces: &Pieces) -> Result<(), Refused> {
    let curves = pieces.list.len();
    is_short("pairs", certificate.pairs.len(), curves * curves / 2)?;
    for pair in &certificate.pairs {
        is_short("stretches of a pair", pair.stretches.len(), STRETCHES)?;
    }
    let crossings = |pair: &CertifiedPair| pair.stretches.iter().filter(|stretch| stretch.crossing.is_some()).count();
    let crossings: usize = certificate.pairs.iter().map(crossings).sum();
    let sources = pieces.cusps.len() + pieces.forks.len() + meetings::most(spaces) + crossings;
    is_short("events", certificate.events.len(), sources)?;
    for event in &certificate.events {
        is_short("sources of an event", event.sources.len(), sources)?;
        is_short("curves of an event", event.curves.len(), curves)?;
    }
    is_short("transitions", certificate.transitions.len(), sources)?;
    is_short("events of transitions", certificate.transitions.iter().map(Vec::len).sum(), sources)?;
    is_short("slabs", certificate.slabs.len(), sources + 1)?;
    for slab in &certificate.slabs {
        is_short("curves of a slab", slab.curves.len(), curves)?;
    }
    is_short("samples", certificate.samples.len(), (sources + 1) * curves)
}
