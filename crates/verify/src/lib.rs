//! Checks a certified atlas without searching again, by other means than those that made it.
//!
//! - Roots are counted by Sturm's theorem; they were isolated by Descartes' rule. The cusp polynomial is built from
//!   T J + 4V, not from 4Q'P − 3P'Q.
//! - Intervals have integer ends (`fixed`); the proof used `f64` and dashu's floats.
//! - Each stretch of each pair, each slab and each box of a crossing is checked where the certificate names it.
//! - Topology comes from boxes on a cube and from the minima and maxima of the certificate (`sphere`), not from the
//!   sweep over latitudes.
//!
//! Shared with the program that writes: the exact body, the types of the documents, [`Component`].

mod faces;
mod family;
mod fixed;
mod order;
mod pieces;
mod sphere;
mod standard;
mod sturm;
mod topology;

use dashu_ratio::RBig;
use thiserror::Error;

use family::{Place, Side, Spaces};
use fixed::Fixed;
use order::Orders;
use pieces::{End, Family, Pieces};
use schema::{Accuracy, AtlasDocument, CertificateDocument};
use sturm::{Coefficients, Sturm};
use top::body::{Body, Number};
use top::topology::Component;

/// What was checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// A proof (certified), or a cross-check (any other atlas).
    pub proof: bool,
    /// Regions whose topology was confirmed.
    pub regions: usize,
    /// Regions whose topology this check could not decide; on a certified atlas those that the atlas leaves open too.
    pub open: Vec<String>,
    /// Events.
    pub events: usize,
    /// Pairs of curves whose order was checked.
    pub pairs: usize,
}

/// The first thing that is wrong.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Refused {
    /// No certificate in an atlas that says it is certified, or one in another.
    #[error("the accuracy is {accuracy:?} but there is {} certificate", if *present { "a" } else { "no" })]
    Certificate {
        /// What the atlas says.
        accuracy: Accuracy,
        /// Whether a certificate is there.
        present: bool,
    },
    /// The body.
    #[error("the body is no body: {why}")]
    Body {
        /// Why.
        why: String,
    },
    /// The checksum.
    #[error("the checksum does not fit: the file is damaged")]
    Checksum,
    /// A text that should be a number.
    #[error("`{text}` should be a number")]
    Number {
        /// The text.
        text: String,
    },
    /// A place that is no place.
    #[error("{what} number {number} has no proper place")]
    BadPlace {
        /// Cusp or meeting.
        what: &'static str,
        /// Which.
        number: usize,
    },
    /// Cusps are missing or invented.
    #[error("branch {branch} has {counted} cusps but the certificate lists {listed}")]
    CuspCount {
        /// The branch.
        branch: String,
        /// In the certificate.
        listed: i64,
        /// By Sturm's theorem.
        counted: i64,
    },
    /// A range does not hold exactly one root.
    #[error("{what} number {number} is not isolated by its range")]
    NotIsolated {
        /// Cusp or meeting.
        what: &'static str,
        /// Which.
        number: usize,
    },
    /// Meetings with pole lines are missing or invented.
    #[error("branch {branch} meets the pole lines {counted} times but the certificate lists {listed}")]
    MeetingCount {
        /// The branch.
        branch: String,
        /// In the certificate.
        listed: i64,
        /// By Sturm's theorem.
        counted: i64,
    },
    /// A meeting with the wrong pole line or curve.
    #[error("meeting number {number}: {why}")]
    Meeting {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// The place where the slope turns.
    #[error("the inflection of the generic family is not where the certificate says")]
    Inflection,
    /// Ranges overlap.
    #[error("the ranges of {what} overlap")]
    Overlap {
        /// Of what.
        what: String,
    },
    /// Something that should be finite.
    #[error("{what} cannot be enclosed")]
    Unbounded {
        /// What.
        what: String,
    },
    /// A curve that does not exist, or one that is missing.
    #[error("there is no curve {id}, or it is missing")]
    UnknownCurve {
        /// Its id.
        id: String,
    },
    /// A point that is not on its curve.
    #[error("curve {curve} is not where the certificate says at x = {x}")]
    Place {
        /// The curve.
        curve: String,
        /// x = l²/2 in the certificate's units.
        x: f64,
    },
    /// The order of two curves.
    #[error("curves {} and {} near x = {x}: {why}", curves[0], curves[1])]
    Pair {
        /// The curves.
        curves: [String; 2],
        /// x = l²/2 in the certificate's units.
        x: f64,
        /// What is wrong.
        why: &'static str,
    },
    /// An event.
    #[error("event number {number}: {why}")]
    Event {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// A slab.
    #[error("slab number {number}: {why}")]
    Slab {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// A region.
    #[error("region {region}: {why}")]
    Region {
        /// Which.
        region: String,
        /// What is wrong.
        why: &'static str,
    },
    /// The topology of a region.
    #[error("region {region} is said to be {claimed}, but it is {found}")]
    Topology {
        /// Which.
        region: String,
        /// In the atlas.
        claimed: String,
        /// By this check.
        found: String,
    },
    /// The summary.
    #[error("the summary says {claimed} {what}, but there are {found}")]
    Summary {
        /// Regions or events.
        what: &'static str,
        /// In the atlas.
        claimed: usize,
        /// Counted.
        found: usize,
    },
}

/// Reads a number exactly.
/// A component as a document has it.
fn component(component: &Component) -> schema::ComponentDocument {
    let poles = component.poles.map(|poles| {
        let signs = [(poles.plus, "+"), (poles.minus, "-")];
        signs.iter().filter(|(inside, _)| *inside).map(|(_, sign)| (*sign).to_owned()).collect()
    });
    schema::ComponentDocument {
        boundary_circles: component.boundary_circles,
        poles,
        accessible_region: component.accessible_region(),
        energy_surface: component.energy_surface(),
        section: component.section(),
        genus: component.genus(),
    }
}

fn number(text: &str) -> Option<RBig> {
    text.parse::<Number>().ok().map(|number| number.value().clone())
}

/// Checks an atlas: a certified one as a proof, any other by the second topological method.
///
/// # Errors
/// The first thing that is wrong.
pub fn verify(document: &AtlasDocument) -> Result<Report, Refused> {
    let body = Body::parse(&document.body.moments, &document.body.center)
        .map_err(|error| Refused::Body { why: error.to_string() })?;
    match (&document.certificate, document.accuracy) {
        (Some(certificate), Accuracy::Certified) => {
            let sum = schema::checksum(document).map_err(|_unwritable| Refused::Checksum)?;
            if sum != certificate.checksum {
                return Err(Refused::Checksum);
            }
            certified(document, certificate, &body)
        }
        (None, Accuracy::Draft | Accuracy::Standard) => standard::verify(document, &body),
        (certificate, accuracy) => Err(Refused::Certificate { accuracy, present: certificate.is_some() }),
    }
}

fn certified(document: &AtlasDocument, certificate: &CertificateDocument, body: &Body) -> Result<Report, Refused> {
    let unit = |text: &String| {
        number(text).filter(|unit| *unit > RBig::ZERO).ok_or_else(|| Refused::Number { text: text.clone() })
    };
    let (moment, energy) = (unit(&certificate.units.moment)?, unit(&certificate.units.energy)?);
    let spaces = Spaces::new(body, &moment, &energy);
    let cusps = cusps(certificate, &spaces)?;
    let pieces = Pieces::new(&spaces, cusps)?;
    let inflection = inflection(certificate, &spaces)?;
    let meetings = meetings(certificate, &spaces, &pieces)?;
    let plain = Orders { spaces: &spaces, pieces: &pieces, inflection, meetings: Vec::new() };
    let events = faces::events(certificate, &plain, &meetings)?;
    let orders = Orders { meetings: events.meetings.clone(), ..plain };
    let pairs = pairs(certificate, &orders)?;
    let slabs = faces::slabs(certificate, &orders, &events, &pairs)?;
    let cells = faces::regions(document, certificate, &pieces, &slabs)?;
    let open = topology::check(document, certificate, &orders, &slabs, &cells)?;
    Ok(Report {
        proof: true,
        regions: document.regions.len() - open.len(),
        open,
        events: certificate.events.len(),
        pairs: certificate.pairs.len(),
    })
}

/// Both ends of an interval of μ between spaces that carry r.
fn interval(spaces: &Spaces, number: usize) -> [Option<&RBig>; 2] {
    [
        number.checked_sub(1).map(|n| &spaces.list[spaces.active[n]].a),
        spaces.active.get(number).map(|&k| &spaces.list[k].a),
    ]
}

fn lies_in(range: &[RBig; 2], [low, high]: [Option<&RBig>; 2]) -> bool {
    low.is_none_or(|low| range[0] > *low) && high.is_none_or(|high| range[1] < *high)
}

/// Every range holds one root, they are disjoint, and together as many as there are.
fn isolated(sturm: &Sturm, ranges: &[(usize, [RBig; 2])], what: &'static str) -> Result<(), Refused> {
    let mut sorted: Vec<&(usize, [RBig; 2])> = ranges.iter().collect();
    sorted.sort_by(|p, q| p.1[0].cmp(&q.1[0]));
    for (number, [lo, hi]) in ranges {
        if sturm.closed(lo, hi) != 1 {
            return Err(Refused::NotIsolated { what, number: *number });
        }
    }
    for pair in sorted.windows(2) {
        if pair[0].1[1] >= pair[1].1[0] {
            return Err(Refused::NotIsolated { what, number: pair[1].0 });
        }
    }
    Ok(())
}

fn cusps(certificate: &CertificateDocument, spaces: &Spaces) -> Result<Vec<Place>, Refused> {
    let mut places = Vec::new();
    for (number, cusp) in certificate.cusps.iter().enumerate() {
        let place = Place::read(&cusp.place).filter(|place| place.base < spaces.list.len() && place.lo > RBig::ZERO);
        places.push(place.ok_or(Refused::BadPlace { what: "cusp", number })?);
    }
    if spaces.active.len() > 1 {
        let sturm = Sturm::new(&spaces.cusp_polynomial());
        for branch in 0..=spaces.active.len() {
            let ends = interval(spaces, branch);
            let listed: Vec<(usize, [RBig; 2])> = places
                .iter()
                .enumerate()
                .filter(|(_, place)| place.side != Side::Over)
                .map(|(number, place)| (number, place.range(spaces)))
                .filter(|(_, range)| lies_in(range, ends))
                .collect();
            isolated(&sturm, &listed, "cusp")?;
            let counted = sturm.inside(ends[0], ends[1]);
            let listed = i64::try_from(listed.len()).unwrap_or(i64::MAX);
            if counted != listed {
                return Err(Refused::CuspCount { branch: format!("G{branch}"), listed, counted });
            }
        }
        // A root of even multiplicity is no cusp.
        for (number, place) in places.iter().enumerate().filter(|(_, place)| place.side != Side::Over) {
            let [lo, hi] = place.range(spaces);
            if sturm.sign_at(&lo) * sturm.sign_at(&hi) > 0 {
                return Err(Refused::NotIsolated { what: "cusp", number });
            }
        }
    }
    // Those over spaces without r are checked when the pieces are made.
    let strays = places.iter().position(|place| match place.side {
        Side::Over => spaces.active.contains(&place.base),
        Side::Plus | Side::Minus => {
            let range = place.range(spaces);
            spaces.active.len() < 2
                || !(0..=spaces.active.len()).any(|branch| lies_in(&range, interval(spaces, branch)))
        }
    });
    strays.map_or(Ok(places), |number| Err(Refused::BadPlace { what: "cusp", number }))
}

fn inflection(certificate: &CertificateDocument, spaces: &Spaces) -> Result<Option<(usize, family::Point)>, Refused> {
    if spaces.active.len() < 3 {
        return Ok(None);
    }
    let place = certificate.inflection.as_ref().and_then(Place::read).ok_or(Refused::Inflection)?;
    if place.base >= spaces.list.len() || place.side == Side::Over {
        return Err(Refused::Inflection);
    }
    let range = place.range(spaces);
    let sturm = Sturm::new(&spaces.inflection_polynomial());
    let branch = (0..=spaces.active.len()).find(|&branch| lies_in(&range, interval(spaces, branch)));
    let point = spaces.point(place.base, place.side, &place.y());
    match (branch, point) {
        (Some(branch), Some(point)) if sturm.closed(&range[0], &range[1]) == 1 && sturm.roots(None, None) == 1 => {
            Ok(Some((branch, point)))
        }
        _ => Err(Refused::Inflection),
    }
}

/// A meeting with a pole line, checked.
struct Meeting {
    plus: bool,
    place: Place,
    /// The critical curves: two at a cusp or pitchfork.
    curves: Vec<usize>,
    /// The end at which it lies exactly.
    end: Option<End>,
    polynomial: Coefficients,
}

fn meetings(certificate: &CertificateDocument, spaces: &Spaces, pieces: &Pieces) -> Result<Vec<Meeting>, Refused> {
    let mut places = Vec::new();
    for (number, meeting) in certificate.meetings.iter().enumerate() {
        let place = Place::read(&meeting.place).filter(|place| place.base < spaces.list.len() && place.lo > RBig::ZERO);
        places.push(place.ok_or(Refused::BadPlace { what: "meeting", number })?);
    }
    let mut found: Vec<Option<Meeting>> = places.iter().map(|_| None).collect();
    let mut families: Vec<(Family, [Coefficients; 2], [Option<RBig>; 2])> = Vec::new();
    if spaces.active.len() > 1 {
        let polynomials = spaces.pole_polynomials();
        for branch in 0..=spaces.active.len() {
            let ends = interval(spaces, branch).map(Option::<&RBig>::cloned);
            families.push((Family::Generic(branch), polynomials.clone(), ends));
        }
    }
    if !spaces.active.is_empty() {
        for base in spaces.passive() {
            // In y: v = P̂ + y.
            let shift = spaces.sums(base).1;
            let moved = spaces.pole_polynomials_over(base).map(|p| {
                p.iter().rev().fold(Vec::new(), |sum: Coefficients, c| {
                    sturm::plus(&sturm::times(&sum, &[shift.clone(), RBig::ONE]), std::slice::from_ref(c), &RBig::ONE)
                })
            });
            families.push((Family::Over(base), moved, [Some(RBig::ZERO), None]));
        }
    }
    for (family, [side, polynomial], ends) in families {
        let sturm = Sturm::new(&polynomial);
        let bounds = [ends[0].as_ref(), ends[1].as_ref()];
        let listed: Vec<(usize, [RBig; 2])> = places
            .iter()
            .enumerate()
            .filter(|(_, place)| match family {
                Family::Over(base) => place.side == Side::Over && place.base == base,
                _ => place.side != Side::Over,
            })
            .map(|(number, place)| (number, place.range(spaces)))
            .filter(|(_, range)| lies_in(range, bounds))
            .collect();
        isolated(&sturm, &listed, "meeting")?;
        let counted = sturm.inside(bounds[0], bounds[1]);
        if counted != i64::try_from(listed.len()).unwrap_or(i64::MAX) {
            let branch = match family {
                Family::Generic(branch) => format!("G{branch}"),
                _ => "over a moment".to_owned(),
            };
            let listed = i64::try_from(listed.len()).unwrap_or(i64::MAX);
            return Err(Refused::MeetingCount { branch, listed, counted });
        }
        let sides = Sturm::new(&side);
        for (number, range) in listed {
            let refuse = |why| Refused::Meeting { number, why };
            let claim = &certificate.meetings[number];
            let crosses = sturm.sign_at(&range[0]) * sturm.sign_at(&range[1]) < 0;
            if crosses == claim.touch {
                return Err(refuse("whether the curves touch or cross is not as claimed"));
            }
            let sign = sides.sign_at(&range[0]);
            if sides.closed(&range[0], &range[1]) != 0 || sign == 0 {
                return Err(refuse("its range does not tell the pole lines apart"));
            }
            // N < 0 on P+; E > 0 on P+.
            let plus = (sign < 0) == matches!(family, Family::Generic(_));
            if claim.pole != if plus { "+" } else { "-" } {
                return Err(refuse("it lies on the other pole line"));
            }
            let (curves, end) = on_curves(spaces, pieces, family, &range, &polynomial)
                .ok_or_else(|| refuse("its curve is not certain"))?;
            let ids: Vec<&str> = curves.iter().map(|&c| pieces.list[c].id.as_str()).collect();
            if ids != claim.curves {
                return Err(refuse("it lies on another curve"));
            }
            let place = places[number].clone();
            found[number] = Some(Meeting { plus, place, curves, end, polynomial: polynomial.clone() });
        }
    }
    found
        .into_iter()
        .enumerate()
        .map(|(number, meeting)| meeting.ok_or(Refused::BadPlace { what: "meeting", number }))
        .collect()
}

/// The curve of a family on which a range lies; both at a cusp or pitchfork that is proved to be the same point.
fn on_curves(
    spaces: &Spaces,
    pieces: &Pieces,
    family: Family,
    range: &[RBig; 2],
    polynomial: &Coefficients,
) -> Option<(Vec<usize>, Option<End>)> {
    let mine: Vec<usize> = (0..pieces.list.len()).filter(|&c| pieces.list[c].family == family).collect();
    for &curve in &mine {
        let [low, high] = &pieces.list[curve].range;
        let above = low.as_ref().is_none_or(|low| low[1] < range[0]);
        let below = high.as_ref().is_none_or(|high| range[1] < high[0]);
        if above && below {
            return Some((vec![curve], None));
        }
    }
    mine.windows(2).find_map(|pair| {
        let station = pieces.list[pair[0]].range[1].as_ref()?;
        let overlap = station[0] <= range[1] && range[0] <= station[1];
        let end = pieces.list[pair[0]]
            .ends
            .into_iter()
            .find(|end| matches!(end, End::Cusp(_) | End::Pitchfork(_)) && pieces.list[pair[1]].ends.contains(end))?;
        let (lo, hi) = (range[0].clone().max(station[0].clone()), range[1].clone().min(station[1].clone()));
        let same = overlap
            && if station[0] == station[1] {
                Sturm::new(polynomial).sign_at(&station[0]) == 0
            } else {
                Sturm::common_root(polynomial, &spaces.cusp_polynomial(), &lo, &hi)
            };
        same.then(|| (pair.to_vec(), Some(end)))
    })
}

/// Two curves and the box in x of their crossing.
type Crossing = ([usize; 2], [Fixed; 2]);

/// Every pair of critical curves that no structure orders, and the boxes of its crossings.
fn pairs(certificate: &CertificateDocument, orders: &Orders) -> Result<Vec<Crossing>, Refused> {
    let pieces = orders.pieces;
    let compared = |c: usize| {
        let piece = &pieces.list[c];
        matches!(piece.family, Family::Generic(_) | Family::Over(_)) && !piece.lowest
    };
    let mut crossings = Vec::new();
    let mut used = 0;
    for b in (0..pieces.list.len()).filter(|&c| compared(c)) {
        for a in (0..b).filter(|&c| compared(c)) {
            if orders.common_range([a, b])?.is_none() {
                continue;
            }
            let ids = [&pieces.list[a].id, &pieces.list[b].id];
            let claim = certificate.pairs.iter().find(|pair| {
                (pair.curves[0] == *ids[0] && pair.curves[1] == *ids[1])
                    || (pair.curves[0] == *ids[1] && pair.curves[1] == *ids[0])
            });
            let missing = || Refused::Pair {
                curves: ids.map(Clone::clone),
                x: 0.0,
                why: "the certificate does not tell their order",
            };
            let claim = claim.ok_or_else(missing)?;
            let curves = if claim.curves[0] == *ids[0] { [a, b] } else { [b, a] };
            crossings.extend(orders.pair(curves, claim)?.into_iter().map(|x| ([a, b], x)));
            used += 1;
        }
    }
    match certificate.pairs.get(used) {
        Some(stray) if certificate.pairs.len() != used => Err(Refused::Pair {
            curves: stray.curves.clone(),
            x: 0.0,
            why: "the certificate lists more pairs than there are",
        }),
        _ => Ok(crossings),
    }
}

/// Components in words.
fn words(components: &[Component]) -> String {
    let word = |c: &Component| {
        let poles = c
            .poles
            .map_or(String::new(), |p| [(p.plus, "+"), (p.minus, "-")].iter().filter(|p| p.0).map(|p| p.1).collect());
        format!("{}({poles})", c.accessible_region())
    };
    components.iter().map(word).collect::<Vec<_>>().join(" + ")
}
