//! Checks an atlas with its certificate without searching again, by other means than those that made it.
//!
//! - Roots are counted in exact integers, by Descartes' rule of signs, of the squarefree part where a root may be multiple.
//!   The cusp polynomial is built from T J + 4V, not from 4Q'P − 3P'Q.
//! - Intervals have integer ends (`fixed`), ends that move outward (`interval`, for paths on the sphere), or a middle and a
//!   bound on the distance from it (`ball`, for normal forms).
//! - Each stretch of each pair, each slab and each box of a crossing is checked where the certificate names it.
//! - Topology comes from the minima, saddles and maxima of the certificate and from paths down from them (`merging`), not
//!   from the ridges over the latitudes.
//!
//! Nothing is shared with the program that writes but the types of the documents. Propositions, lemmas and theorems are
//! those of docs/mathematics.md.
//!
//! ```text
//! numbers      exact and enclosed numbers, isolated roots
//! equilibria   the body's curves of relative equilibria, and that none is missing
//! order        which curve lies above which over every l, where they meet, the faces
//! topology     the topology of U and of P in each region
//! stability    linear types along the curves, verdicts, and where Arnold's theorem fails
//! document     what a document says beside its certificate
//! ```

mod document;
mod equilibria;
mod numbers;
mod order;
mod refused;
mod stability;
mod topology;

use bifdiag_schema::{Accuracy, AtlasDocument, PointProofDocument, checksum};

use document::{curves, listing, point_claim, samples, totals};
use equilibria::pieces::Pieces;
use equilibria::spaces::{Body, Spaces};
use equilibria::{meetings, roots};
use numbers::number;
use order::events::Events;
use order::orders::Orders;
use order::{gluing, pairs, regions, slabs};

pub use refused::Refused;

/// Fractional bits with which a certificate is checked, until it is confirmed. The first are enough for most proofs in doubles.
const BITS: [usize; 4] = [176, 256, 512, 1024];

/// The bits with which proofs are made.
const PROOFS: [usize; 3] = [53, 128, 384];

/// What was checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// Regions whose topology was confirmed.
    pub regions: usize,
    /// Events that the atlas lists.
    pub events: usize,
    /// Pairs of curves whose order was checked.
    pub pairs: usize,
    /// Curves with a verdict on their stability that is not checked, and says so.
    pub unproved: Vec<String>,
}

/// Checks an atlas against its certificate: every field but `drawing`, which is no part of the proof.
///
/// # Errors
/// The first error; [`Refused::NoCertificate`] if there is nothing to check.
pub fn verify(document: &AtlasDocument) -> Result<Report, Refused> {
    checked(document, None)
}

/// Checks where a point lies: the atlas of its document as [`verify`] does, and the point in it.
///
/// # Errors
/// As [`verify`].
pub fn verify_point(point: &PointProofDocument) -> Result<Report, Refused> {
    checked(&point.atlas, Some(point))
}

fn checked(document: &AtlasDocument, point: Option<&PointProofDocument>) -> Result<Report, Refused> {
    let body = Body::read(&document.body)?;
    let certificate = document.certificate.as_ref().ok_or(Refused::NoCertificate)?;
    if checksum(document).map_err(|_unwritable| Refused::Checksum)? != certificate.checksum {
        return Err(Refused::Checksum);
    }
    if document.accuracy != Accuracy::Exact {
        return Err(Refused::Accuracy);
    }
    if !PROOFS.contains(&certificate.bits) {
        return Err(Refused::Field { field: "certificate.bits" });
    }
    totals::frame(document, &body)?;
    let check = |bits| certified(document, point, &body, bits);
    let first = usize::from(certificate.bits > PROOFS[0]);
    BITS[first + 1..].iter().fold(check(BITS[first]), |found, &bits| match found {
        Err(refused) if refused != stability::VERDICTS => check(bits),
        found => found,
    })
}

/// What one precision confirms is true, whatever a lower one left open.
fn certified(
    document: &AtlasDocument,
    point: Option<&PointProofDocument>,
    body: &Body,
    bits: usize,
) -> Result<Report, Refused> {
    let certificate = document.certificate.as_ref().ok_or(Refused::NoCertificate)?;
    let spaces =
        Spaces::new(body, [number::unit(&certificate.units.moment)?, number::unit(&certificate.units.energy)?], bits)?;
    meetings::count_roots(certificate, &spaces)?;
    let cusps = roots::cusps(certificate, &spaces)?;
    let pieces = Pieces::new(&spaces, cusps)?;
    meetings::count_lists(certificate, &spaces, &pieces)?;
    let inflection = roots::inflection(certificate, &spaces)?;
    let meetings = meetings::meetings(certificate, &spaces, &pieces)?;
    let mut orders = Orders { spaces: &spaces, pieces: &pieces, inflection, meetings: Vec::new() };
    let events = Events::read(certificate, &orders, &meetings)?;
    orders.meetings.clone_from(&events.meetings);
    let crossings = pairs::pairs(certificate, &orders)?;
    let slabs = slabs::slabs(certificate, &orders, &events, &crossings)?;
    gluing::check(&certificate.transitions, &events, &slabs)?;
    let cells = regions::regions(document, certificate, &pieces, &slabs)?;
    curves::check(document, certificate, &orders, &slabs)?;
    listing::events(document, certificate, (&events, &meetings), &orders)?;
    listing::ranges(document, certificate, &cells)?;
    let (along, mut unproved) = stability::check(document, &orders)?;
    let samples = regions::samples(document, certificate, &orders, &slabs, &cells)?;
    topology::check(document, &orders, &slabs, &samples)?;
    samples::check(document, &orders, &slabs, &samples)?;
    totals::totals(document, &orders, &slabs)?;
    if let Some(claim) = point {
        point_claim::check(claim, &orders, &events)?;
    }
    // It takes longest.
    stability::exceptions(document, &orders, &along, &mut unproved)?;
    Ok(Report {
        regions: document.regions.len(),
        events: document.events.len(),
        pairs: certificate.pairs.len(),
        unproved,
    })
}
