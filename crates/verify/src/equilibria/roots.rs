//! Isolated roots: cusps and the inflection of the generic family.

use bifdiag_schema::CertificateDocument;
use dashu_ratio::RBig;

use super::places::{Place, Point, Side};
use super::spaces::Spaces;
use crate::Refused;
use crate::numbers::polynomial::Polynomial;

/// Places of the entries of a list, each at a positive distance from its space.
pub(crate) fn places<'a>(
    documents: impl Iterator<Item = &'a bifdiag_schema::PlaceDocument>,
    spaces: &Spaces,
    what: &'static str,
) -> Result<Vec<Place>, Refused> {
    let place = |(number, document)| {
        let place = Place::read(document, spaces).filter(|place| place.lo > RBig::ZERO);
        place.ok_or(Refused::misplaced(what, number))
    };
    documents.enumerate().map(place).collect()
}

/// The places of one branch inside an interval, with their numbers in the certificate's list.
pub(crate) fn listed(
    places: &[Place],
    spaces: &Spaces,
    on_branch: impl Fn(&Place) -> bool,
    ends: [Option<&RBig>; 2],
) -> Vec<(usize, [RBig; 2])> {
    let ranges =
        places.iter().enumerate().filter(|(_, place)| on_branch(place)).map(|(n, place)| (n, place.range(spaces)));
    ranges.filter(|(_, range)| lies_in(range, ends)).collect()
}

fn lies_in(range: &[RBig; 2], [low, high]: [Option<&RBig>; 2]) -> bool {
    low.is_none_or(|low| range[0] > *low) && high.is_none_or(|high| range[1] < *high)
}

/// Every range holds one root: they are disjoint, hold a root each, and are as many as the roots between the ends. `names` are
/// those of one root and of several, `branch` is that of the branch.
pub(crate) fn isolated(
    polynomial: &Polynomial,
    ranges: &[(usize, [RBig; 2])],
    ends: [Option<&RBig>; 2],
    [what, several]: [&'static str; 2],
    branch: impl Fn() -> String,
) -> Result<(), Refused> {
    for (number, [lo, hi]) in ranges {
        let changes_sign = polynomial.sign_at(lo) * polynomial.sign_at(hi) <= 0;
        if !changes_sign && polynomial.closed([lo, hi]).is_none_or(|roots| roots == 0) {
            return Err(Refused::not_isolated(what, *number));
        }
    }
    let mut sorted: Vec<&(usize, [RBig; 2])> = ranges.iter().collect();
    sorted.sort_by(|p, q| p.1[0].cmp(&q.1[0]));
    if let Some(pair) = sorted.windows(2).find(|pair| pair[0].1[1] >= pair[1].1[0]) {
        return Err(Refused::not_isolated(what, pair[1].0));
    }
    match (ranges.len(), polynomial.inside(ends)) {
        (listed, Some(counted)) if listed == counted => Ok(()),
        (listed, Some(counted)) => Err(Refused::Count { what: several, branch: branch(), listed, counted }),
        (_, None) => {
            Err(Refused::Uncertain { what: format!("the {several} of {} are too close to be counted", branch()) })
        }
    }
}

/// The cusps of a certificate: those of the generic family are as many as the sign changes of the cusp polynomial, each
/// isolated. Those over spaces without r are compared with their closed form when the curves are cut.
pub(crate) fn cusps(certificate: &CertificateDocument, spaces: &Spaces) -> Result<Vec<Place>, Refused> {
    let cusps = places(certificate.cusps.iter().map(|cusp| &cusp.place), spaces, "cusp")?;
    let mut known = vec![false; cusps.len()];
    for (number, place) in cusps.iter().enumerate() {
        known[number] = place.side == Side::Over && !spaces.active.contains(&place.base);
    }
    if spaces.active.len() > 1 {
        let polynomial = spaces.cusp_polynomial();
        for branch in 0..=spaces.active.len() {
            let ends = spaces.interval(branch);
            let ranges = listed(&cusps, spaces, |place| place.side != Side::Over, ends);
            isolated(&polynomial, &ranges, ends, ["cusp", "cusps"], || format!("G{branch}"))?;
            for (number, [lo, hi]) in ranges {
                // A root of even multiplicity is no cusp.
                if polynomial.sign_at(&lo) * polynomial.sign_at(&hi) > 0 {
                    return Err(Refused::not_isolated("cusp", number));
                }
                known[number] = true;
            }
        }
    }
    match known.iter().position(|known| !known) {
        Some(number) => Err(Refused::misplaced("cusp", number)),
        None => Ok(cusps),
    }
}

/// The one place of the generic family where dJ/dμ = 0, with its branch; `None` unless three spaces carry r.
pub(crate) fn inflection(
    certificate: &CertificateDocument,
    spaces: &Spaces,
) -> Result<Option<(usize, Point)>, Refused> {
    let refused = Refused::Field { field: "certificate.inflection" };
    let [i, j, k] = spaces.active[..] else {
        return if certificate.inflection.is_none() { Ok(None) } else { Err(refused) };
    };
    let polynomial = spaces.inflection_polynomial([i, j, k]);
    let is_only_root = || polynomial.inside([None, None]) == Some(1);
    let Some(place) = &certificate.inflection else {
        // The one root is a moment itself, which lies on no branch.
        let is_at_a_moment = spaces.active.iter().any(|&k| polynomial.sign_at(&spaces.list[k].a) == 0);
        return if is_at_a_moment && is_only_root() { Ok(None) } else { Err(refused) };
    };
    let Some(place) = Place::read(place, spaces).filter(|place| place.side != Side::Over) else {
        return Err(refused);
    };
    let range = place.range(spaces);
    let branch = (0..=spaces.active.len()).find(|&branch| lies_in(&range, spaces.interval(branch)));
    let point = spaces.point(place.base, place.side, &place.y(spaces));
    match branch.zip(point) {
        Some(found) if polynomial.closed(range.each_ref()) == Some(1) && is_only_root() => Ok(Some(found)),
        _ => Err(refused),
    }
}
