//! The events that a document lists, and the ranges of l of its cells, against the events of the certificate.

use bifdiag_schema::{AtlasDocument, CertificateDocument, EventDocument, EventKind, RegionDocument};
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::meetings::Meeting;
use crate::equilibria::pieces::{Branch, Pieces};
use crate::numbers::bounds::{around, holds, holds_root, is_at_most, roundings};
use crate::numbers::number;
use crate::order::events::{Events, Source};
use crate::order::orders::Orders;
use crate::order::regions::Cell;

/// An event of a document, with its claims.
struct Listed<'a> {
    document: &'a EventDocument,
    /// The event of the certificate, and which of its sources this is.
    number: usize,
    source: Source,
}

/// Largest stated error beyond the width of the enclosure, in roundings.
const ROUNDINGS: u32 = 4;

/// Checks every event: its kind, its curves, and that l and h are within their errors and enclosures.
pub(crate) fn events(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    (events, meetings): (&Events, &[Meeting]),
    orders: &Orders,
) -> Result<(), Refused> {
    let pieces = orders.pieces;
    if !document.events.is_sorted_by(|p, q| p.l <= q.l) {
        return Err(Refused::Field { field: "events: by rising l" });
    }
    let (energy, l2) = (&orders.spaces.energy, orders.spaces.square_of_momentum());
    let momentum = RBig::try_from(l2.to_f64().value().sqrt())
        .map_err(|_infinite| Refused::Field { field: "certificate.units" })?;
    let norm = &orders.spaces.norm.ends()[1] * energy;
    for listed in listed(document, certificate) {
        let refuse = |why| Refused::entry("event", listed.number, why);
        let claim = &certificate.events[listed.number];
        listed.is_of_its_kind(pieces, meetings, &events.curves[listed.number]).map_err(refuse)?;
        let squares = claim.x.each_ref().map(|x| number::read(x).map(|x| x * &l2));
        let heights = claim.h.each_ref().map(|h| number::read(h).map(|h| h * energy));
        let ([low, high], [h_low, h_high]) = (squares, heights);
        let (squares, heights) = ([low?, high?], [h_low?, h_high?]);
        let l = around(listed.document.l, listed.document.l_error).ok_or_else(|| refuse("its l is no number"))?;
        let h = around(listed.document.h, listed.document.h_error).ok_or_else(|| refuse("its h is no number"))?;
        if !holds_root(&l, &squares) || !holds(&h, &heights) {
            return Err(refuse("its l or h in the list is further away than its error"));
        }
        let energies = heights[1].clone().max(-&heights[0]) + &norm;
        // dl = d(l²)/2l.
        let squared = &squares[1] - &squares[0] + roundings(ROUNDINGS, &squares[1]);
        let twice = RBig::try_from(2.0 * listed.document.l).unwrap_or(RBig::ZERO);
        let most = &heights[1] - &heights[0] + roundings(ROUNDINGS, &energies);
        if twice <= RBig::ZERO
            || !is_at_most(listed.document.l_error, &(&squared / twice))
            || !is_at_most(listed.document.h_error, &most)
        {
            return Err(refuse("its error in the list is larger than its enclosure"));
        }
        let enclosure = listed.document.enclosure.as_ref().ok_or_else(|| refuse("it has no enclosure"))?;
        let [l_low, l_high] = enclosure.l.each_ref().map(|text| number::in_units(text, &momentum));
        let [h_low, h_high] = enclosure.h.each_ref().map(|text| number::in_units(text, energy));
        let (claimed_l, claimed_h) = ([l_low?, l_high?], [h_low?, h_high?]);
        if !holds_root(&claimed_l, &squares) || !holds(&claimed_h, &heights) {
            return Err(refuse("its enclosure in the list does not hold it"));
        }
        let [low, high] = &claimed_l;
        if *low < RBig::ZERO || high * high - low * low > squared || &claimed_h[1] - &claimed_h[0] > most {
            return Err(refuse("its enclosure in the list is wider than that of its certificate"));
        }
    }
    Ok(())
}

/// Checks the ranges of l of every cell and region, which are those of the events, and what is bounded.
pub(crate) fn ranges(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    cells: &[Vec<Cell>],
) -> Result<(), Refused> {
    let listed = listed(document, certificate);
    let momentum = |transition: usize| {
        let first = certificate.transitions.get(transition)?.first()?;
        listed.iter().find(|listed| listed.number == *first).map(|listed| listed.document.l)
    };
    let last = certificate.transitions.len();
    let start = |slab: usize| slab.checked_sub(1).map_or(Some(0.0), momentum);
    let end = |slab: usize| if slab == last { None } else { momentum(slab) };
    for (region, cells) in document.regions.iter().zip(cells) {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let right =
            region.cells.iter().zip(cells).all(|(cell, &(slab, _))| same_ends(cell.l_range, [start(slab), end(slab)]));
        let slabs = || cells.iter().map(|(slab, _)| *slab);
        let whole = [slabs().min().and_then(start), slabs().max().and_then(end)];
        if !right || !same_ends(region.l_range, whole) {
            return Err(refuse("its range of l is not that of its events"));
        }
        if region.bounded != is_bounded(region) {
            return Err(refuse("it is not as bounded as it says"));
        }
    }
    Ok(())
}

/// The same doubles: 0 has no sign.
fn same_ends(claim: [Option<f64>; 2], found: [Option<f64>; 2]) -> bool {
    claim.map(|l| l.map(f64::to_bits)) == found.map(|l| l.map(f64::to_bits))
}

/// Between two values of l, and below a curve everywhere.
fn is_bounded(region: &RegionDocument) -> bool {
    region.l_range[1].is_some() && region.cells.iter().all(|cell| cell.upper.is_some())
}

/// The events of the document, which come by transition, each source one.
fn listed<'a>(document: &'a AtlasDocument, certificate: &CertificateDocument) -> Vec<Listed<'a>> {
    let sources = certificate.transitions.iter().flatten().flat_map(|&number| {
        let sources = certificate.events.get(number).map(|event| &event.sources).into_iter().flatten();
        sources.filter_map(move |text| Some((number, Source::read(text)?)))
    });
    document
        .events
        .iter()
        .zip(sources)
        .map(|(document, (number, source))| Listed { document, number, source })
        .collect()
}

impl Listed<'_> {
    fn is_of_its_kind(&self, pieces: &Pieces, meetings: &[Meeting], together: &[usize]) -> Result<(), &'static str> {
        let (kind, curves) = match self.source {
            Source::Cusp(cusp) => (EventKind::Cusp, pieces.at_cusp(cusp)),
            Source::Pitchfork(fork) => (EventKind::Pitchfork, pieces.at_fork(fork)),
            // A meeting at a cusp or pitchfork names the first curve that crosses the line there, and the line.
            Source::Meeting(number) if together.len() > 2 => {
                let is_line = |curve: &&usize| matches!(pieces.list[**curve].branch, Branch::Line(_));
                let crossing = meetings.get(number).and_then(|meeting| meeting.curves.first());
                let named: Vec<usize> =
                    [crossing, together.iter().find(is_line)].into_iter().flatten().copied().collect();
                (EventKind::Crossing, in_order(&named))
            }
            Source::Meeting(_) | Source::Crossing => (EventKind::Crossing, in_order(together)),
        };
        if self.document.kind != kind {
            return Err("it is of another kind");
        }
        let named: Result<Vec<usize>, _> = self.document.curves.iter().map(|id| pieces.find(id)).collect();
        match named {
            Ok(named) if named == curves => Ok(()),
            Ok(_) => Err("it names other curves"),
            Err(_unknown) => Err("it names a curve that does not exist"),
        }
    }
}

/// Two curves that cross, in the order of the list of curves.
fn in_order(together: &[usize]) -> Vec<usize> {
    let mut curves = together.to_vec();
    curves.sort_unstable();
    curves
}
