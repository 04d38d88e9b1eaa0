//! Events, vertical orders and faces.

use dashu_ratio::RBig;

use super::family::{Point, Side};
use super::fixed::Fixed;
use super::order::Orders;
use super::pieces::{End, Family, Pieces};
use super::sturm::{self, Sturm};
use super::{Meeting, Refused, number};
use schema::{AtlasDocument, CertificateDocument};

/// The events of a certificate.
pub(super) struct Events {
    /// Enclosures of x, as claimed (and found right).
    pub x: Vec<[RBig; 2]>,
    /// The curves that meet at each.
    pub curves: Vec<Vec<usize>>,
    /// (curve, side, other): the other passes exactly through this end.
    pub meetings: Vec<(usize, usize, usize)>,
    /// Curves and claimed x of the crossings of pairs, to be compared with the boxes.
    crossings: Vec<(usize, [usize; 2])>,
    /// The transition of each cusp and pitchfork.
    ends: Vec<(End, usize)>,
}

/// A slab, checked.
pub(super) struct Slab {
    pub x: Fixed,
    /// Curve, its equilibrium, its height; by rising height.
    pub stands: Vec<(usize, Point, Fixed)>,
    /// The face that the certificate names above each curve.
    pub faces: Vec<String>,
}

fn refuse(number: usize, why: &'static str) -> Refused {
    Refused::Event { number, why }
}

/// Reads the events: each cusp, pitchfork and meeting once, with all its curves and a right enclosure; transitions in
/// order. Crossings are compared later, by [`slabs`].
#[allow(clippy::too_many_lines)]
pub(super) fn events(
    certificate: &CertificateDocument,
    orders: &Orders,
    meetings: &[Meeting],
) -> Result<Events, Refused> {
    let (pieces, spaces) = (orders.pieces, orders.spaces);
    let mut seen: Vec<String> = Vec::new();
    let mut found =
        Events { x: Vec::new(), curves: Vec::new(), meetings: Vec::new(), crossings: Vec::new(), ends: Vec::new() };
    for (at, event) in certificate.events.iter().enumerate() {
        let read = |text: &String| number(text).ok_or_else(|| Refused::Number { text: text.clone() });
        let x = [read(&event.x[0])?, read(&event.x[1])?];
        let h = [read(&event.h[0])?, read(&event.h[1])?];
        let claimed = Fixed::between(&x[0], &x[1]);
        let mut curves: Vec<usize> = Vec::new();
        let mut points: Vec<Point> = Vec::new();
        let mut ends: Vec<End> = Vec::new();
        for source in &event.sources {
            let (kind, index) = source.split_once(':').unwrap_or((source, "0"));
            let index: usize = index.parse().map_err(|_not_a_number| refuse(at, "its source cannot be read"))?;
            if kind != "crossing" {
                if seen.contains(source) {
                    return Err(refuse(at, "its source is used twice"));
                }
                seen.push(source.clone());
            }
            let mut add = |list: &[usize]| {
                for &curve in list {
                    if !curves.contains(&curve) {
                        curves.push(curve);
                    }
                }
            };
            match kind {
                "cusp" if index < pieces.cusps.len() => {
                    let list = pieces.at_cusp(index);
                    add(&list);
                    let place = &pieces.cusps[index];
                    points.extend(spaces.point(place.base, place.side, &place.y()));
                    ends.push(End::Cusp(index));
                }
                "pitchfork" if index < pieces.forks.len() => {
                    add(&pieces.forks[index].curves);
                    points.extend(spaces.point(pieces.forks[index].base, Side::Over, &Fixed::whole(0)));
                    ends.push(End::Pitchfork(index));
                }
                "meeting" if index < meetings.len() => {
                    let meeting = &meetings[index];
                    add(&meeting.curves);
                    let point = spaces.point(meeting.place.base, meeting.place.side, &meeting.place.y());
                    let point = point.ok_or_else(|| refuse(at, "its place cannot be enclosed"))?;
                    add(&line(orders, meeting, &point.x, &ends, at)?);
                    if let Some(end) = meeting.end {
                        if !ends.contains(&end) {
                            return Err(refuse(at, "a meeting at a cusp or pitchfork must be one event with it"));
                        }
                    } else if !ends.is_empty() && !through(orders, meeting, &ends) {
                        return Err(refuse(at, "its sources are not proved to be one point"));
                    }
                    points.push(point);
                }
                "crossing" => {
                    let ids: Result<Vec<usize>, Refused> = event.curves.iter().map(|id| pieces.find(id)).collect();
                    let ids = ids?;
                    let [a, b] = ids[..] else { return Err(refuse(at, "a crossing has two curves")) };
                    add(&[a, b]);
                    found.crossings.push((at, [a.min(b), a.max(b)]));
                }
                _ => return Err(refuse(at, "its source does not exist")),
            }
        }
        let several = event.sources.len() > 1;
        let strange = event.sources.iter().any(|s| s == "crossing") || ends.len() != 1;
        if event.sources.is_empty() || (several && strange) {
            return Err(refuse(at, "its sources are not proved to be one point"));
        }
        for point in &points {
            let height = point.x.over(&point.j).map(|h| &h - &point.rho);
            let right =
                point.x.inside(&claimed) && height.is_some_and(|height| height.inside(&Fixed::between(&h[0], &h[1])));
            if !right {
                return Err(refuse(at, "its enclosure does not hold the point"));
            }
        }
        let mut named: Vec<usize> = Vec::new();
        for id in &event.curves {
            named.push(pieces.find(id)?);
        }
        let (mut p, mut q) = (named, curves.clone());
        p.sort_unstable();
        q.sort_unstable();
        if p != q {
            return Err(refuse(at, "other curves meet there"));
        }
        if several {
            for &curve in &curves {
                for side in [0, 1] {
                    if ends.contains(&pieces.list[curve].ends[side]) {
                        found.meetings.extend(curves.iter().filter(|&&c| c != curve).map(|&c| (curve, side, c)));
                    }
                }
            }
        }
        found.ends.extend(ends.into_iter().map(|end| (end, at)));
        found.x.push(x);
        found.curves.push(curves);
    }
    let wanted = pieces.cusps.len() + pieces.forks.len() + meetings.len();
    if seen.len() != wanted {
        return Err(refuse(certificate.events.len(), "an event is missing"));
    }
    Ok(found)
}

/// The pole line of a meeting: when r lies on an axis, the piece of the line over its x.
fn line(orders: &Orders, meeting: &Meeting, x: &Fixed, ends: &[End], at: usize) -> Result<Vec<usize>, Refused> {
    let pieces = orders.pieces;
    let lines = (0..pieces.list.len()).filter(|&c| pieces.list[c].family == Family::Line(meeting.plus));
    let mut found = Vec::new();
    for curve in lines {
        let [low, high] = [pieces.end_x(orders.spaces, curve, 0)?, pieces.end_x(orders.spaces, curve, 1)?];
        let after = low.as_ref().is_none_or(|low| low.below(x));
        let before = high.as_ref().is_none_or(|high| x.below(high));
        if after && before {
            return Ok(vec![curve]);
        }
        if pieces.list[curve].ends.iter().any(|end| ends.contains(end)) {
            found.push(curve);
        }
    }
    if found.is_empty() { Err(refuse(at, "its piece of the pole line is not certain")) } else { Ok(found) }
}

/// r on an axis: the meeting of a pair with the line lies exactly at one of these pitchforks. 4x²v³ = (a v − R̂)⁴ on the
/// pair, 4x² = α⁴r²/d² at the pitchfork.
fn through(orders: &Orders, meeting: &Meeting, ends: &[End]) -> bool {
    let spaces = orders.spaces;
    let ([axis], Side::Over) = (&spaces.active[..], meeting.place.side) else { return false };
    ends.iter().any(|end| {
        let End::Pitchfork(fork) = end else { return false };
        let base = meeting.place.base;
        let (r_sum, p_sum) = spaces.sums(base);
        let alpha = &spaces.list[*axis].a;
        let d = &spaces.list[orders.pieces.forks[*fork].base].a - alpha;
        let x2 = alpha * alpha * alpha * alpha * &spaces.r2 / (&d * &d);
        // In y: v = P̂ + y.
        let j = [spaces.list[base].a.clone() * &p_sum - r_sum, spaces.list[base].a.clone()];
        let v = [p_sum, RBig::ONE];
        let fourth = sturm::times(&sturm::times(&j, &j), &sturm::times(&j, &j));
        let cube = sturm::times(&sturm::times(&v, &v), &v);
        let difference = sturm::plus(&fourth, &cube, &-x2);
        Sturm::common_root(&meeting.polynomial, &difference, &meeting.place.lo, &meeting.place.hi)
    })
}

/// Checks crossings against the events, the order of transitions, and the order of the curves in every slab.
pub(super) fn slabs(
    certificate: &CertificateDocument,
    orders: &Orders,
    events: &Events,
    crossings: &[([usize; 2], [Fixed; 2])],
) -> Result<Vec<Slab>, Refused> {
    compare_crossings(events, crossings)?;
    let mut listed: Vec<usize> = certificate.transitions.iter().flatten().copied().collect();
    listed.sort_unstable();
    if listed != (0..events.x.len()).collect::<Vec<_>>() || certificate.transitions.iter().any(Vec::is_empty) {
        return Err(Refused::Slab { number: 0, why: "the transitions do not hold every event once" });
    }
    if certificate.slabs.len() != certificate.transitions.len() + 1 {
        return Err(Refused::Slab { number: 0, why: "there must be one slab more than transitions" });
    }
    let low = |t: usize| certificate.transitions[t].iter().map(|&e| &events.x[e][0]).min();
    let high = |t: usize| certificate.transitions[t].iter().map(|&e| &events.x[e][1]).max();
    let span = |end: End| {
        let event = events.ends.iter().find(|(known, _)| *known == end).map(|(_, event)| *event)?;
        certificate.transitions.iter().position(|group| group.contains(&event))
    };
    let pieces = orders.pieces;
    let mut slabs = Vec::new();
    for (slab, claim) in certificate.slabs.iter().enumerate() {
        let refuse = |why| Refused::Slab { number: slab, why };
        let x = number(&claim.x).ok_or_else(|| Refused::Number { text: claim.x.clone() })?;
        let after = slab.checked_sub(1).and_then(high).is_none_or(|limit| x > *limit) && x > RBig::ZERO;
        let before = slab >= certificate.transitions.len() || low(slab).is_none_or(|limit| x < *limit);
        if !after || !before {
            return Err(refuse("its abscissa does not lie between the events around it"));
        }
        let alive: Vec<usize> = (0..pieces.list.len())
            .filter(|&c| {
                let [from, to] = pieces.list[c].ends;
                span(from).is_none_or(|t| t < slab) && span(to).is_none_or(|t| t >= slab)
            })
            .collect();
        let x = Fixed::of(&x);
        let mut stands: Vec<(usize, Point, Fixed)> = Vec::new();
        for height in &claim.curves {
            let curve = pieces.find(&height.curve)?;
            if !alive.contains(&curve) || stands.iter().any(|(c, _, _)| *c == curve) {
                return Err(refuse("it lists a curve that does not live there, or one twice"));
            }
            let point = orders.stand(curve, height.place.as_ref(), &x)?.point;
            let h = x.over(&point.j).map(|h| &h - &point.rho).ok_or_else(|| refuse("a height is unbounded"))?;
            stands.push((curve, point, h));
        }
        if stands.len() != alive.len() {
            return Err(refuse("a curve is missing"));
        }
        for pair in stands.windows(2) {
            let structural = pieces.list[pair[0].0].lowest;
            let above = || orders.spaces.gap(&x, &pair[1].1, &pair[0].1).is_some_and(|gap| gap.is_positive());
            if !structural && !above() {
                return Err(refuse("its curves are not in the order that is claimed"));
            }
        }
        if stands.iter().skip(1).any(|(c, _, _)| pieces.list[*c].lowest) {
            return Err(refuse("the global minimum is not lowest"));
        }
        slabs.push(Slab { x, stands, faces: claim.curves.iter().map(|h| h.region.clone()).collect() });
    }
    for t in 1..certificate.transitions.len() {
        if high(t - 1) >= low(t) {
            return Err(Refused::Slab { number: t, why: "the events on its two sides are not in order" });
        }
    }
    glue(certificate, events, &slabs)?;
    Ok(slabs)
}

/// Each crossing of a pair is an event, and each such event a crossing.
fn compare_crossings(events: &Events, crossings: &[([usize; 2], [Fixed; 2])]) -> Result<(), Refused> {
    let mut open: Vec<&([usize; 2], [Fixed; 2])> = crossings.iter().collect();
    for (at, pair) in &events.crossings {
        let claimed = Fixed::between(&events.x[*at][0], &events.x[*at][1]);
        let place = open
            .iter()
            .position(|(curves, [low, high])| curves == pair && low.inside(&claimed) && high.inside(&claimed));
        match place {
            Some(place) => {
                open.remove(place);
            }
            None => return Err(refuse(*at, "the curves do not cross there")),
        }
    }
    if open.is_empty() { Ok(()) } else { Err(refuse(events.x.len(), "a crossing is missing")) }
}

/// The faces named in the slabs are those that gluing gives: cells of neighbouring slabs are one face unless they end or
/// begin inside the run of curves that meet.
fn glue(certificate: &CertificateDocument, events: &Events, slabs: &[Slab]) -> Result<(), Refused> {
    // Number of the first cell of each slab; cell k of a slab lies above its curve k.
    let mut offsets = Vec::new();
    let mut count = 0;
    for slab in slabs {
        offsets.push(count);
        count += slab.stands.len();
    }
    let mut parent: Vec<usize> = (0..count).collect();
    for (t, group) in certificate.transitions.iter().enumerate() {
        let order = |slab: usize| slabs[slab].stands.iter().map(|(c, _, _)| *c).collect::<Vec<_>>();
        let (before, after) = (order(t), order(t + 1));
        let blocks: Vec<&[usize]> = group.iter().map(|&e| events.curves[e].as_slice()).collect();
        for (k, block) in blocks.iter().enumerate() {
            if blocks[..k].iter().any(|other| other.iter().any(|c| block.contains(c))) {
                return Err(refuse(group[k], "another event on its curves is not told from it"));
            }
        }
        let pairs = join(&before, &after, &blocks)
            .ok_or_else(|| refuse(group[0], "the orders on its two sides do not fit it"))?;
        for (p, q) in pairs {
            let (p, q) = (root(&mut parent, offsets[t] + p), root(&mut parent, offsets[t + 1] + q));
            parent[p.max(q)] = p.min(q);
        }
    }
    // Names and classes must correspond one to one.
    let mut names: Vec<(usize, &str)> = Vec::new();
    for (slab, strip) in slabs.iter().enumerate() {
        for (cell, name) in strip.faces.iter().enumerate() {
            let class = root(&mut parent, offsets[slab] + cell);
            let known = names.iter().find(|(c, n)| *c == class || *n == name);
            match known {
                Some((c, n)) if *c == class && *n == name => {}
                Some(_) => {
                    return Err(Refused::Slab {
                        number: slab,
                        why: "a cell is given to another region than it belongs to",
                    });
                }
                None => names.push((class, name)),
            }
        }
    }
    Ok(())
}

fn root(parent: &mut [usize], mut k: usize) -> usize {
    while parent[k] != k {
        k = parent[k];
    }
    k
}

/// Pairs of cells that continue each other across events on disjoint runs of curves. Events are removed one by one from
/// both orders: a run becomes a marker at which the cells below and above are known.
fn join(before: &[usize], after: &[usize], blocks: &[&[usize]]) -> Option<Vec<(usize, usize)>> {
    // An event that is a run on both sides (or stands alone in a cell) is taken out; what is left must fit in turn.
    let sequences = orders_of(blocks.len());
    sequences.into_iter().find_map(|sequence| {
        let mut now: Vec<usize> = before.to_vec();
        // The cells of the beginning that continue into the cell above each curve now; index 0 is below everything.
        let mut sources: Vec<Vec<usize>> = (0..=before.len()).map(|k| vec![k]).collect();
        for number in sequence {
            let block = blocks[number];
            let later: Vec<usize> = after.iter().copied().filter(|c| now.contains(c) || block.contains(c)).collect();
            let mine = |list: &[usize]| -> Option<[usize; 2]> {
                let first = list.iter().position(|c| block.contains(c))?;
                let size = list[first..].iter().take_while(|c| block.contains(c)).count();
                let all = list.iter().filter(|c| block.contains(c)).count();
                (all == size).then_some([first, size])
            };
            let is_there = |list: &[usize]| list.iter().any(|c| block.contains(c));
            let new = if is_there(&later) { mine(&later)? } else { [usize::MAX, 0] };
            let old = if is_there(&now) {
                mine(&now)?
            } else {
                let first = match new[0] {
                    usize::MAX => return None,
                    0 => 0,
                    k => now.iter().position(|&c| c == later[k - 1])? + 1,
                };
                [first, 0]
            };
            let inside: Vec<usize> = if new[1] > 0 { later[new[0]..new[0] + new[1]].to_vec() } else { Vec::new() };
            let below = sources[old[0]].clone();
            let above = sources[old[0] + old[1]].clone();
            let mut middle: Vec<Vec<usize>> = Vec::new();
            if inside.is_empty() {
                middle.push([below, above].concat());
            } else {
                middle.push(below);
                middle.extend((1..inside.len()).map(|_| Vec::new()));
                middle.push(above);
            }
            sources.splice(old[0]..=old[0] + old[1], middle);
            now.splice(old[0]..old[0] + old[1], inside);
        }
        (now == after).then(|| {
            let mut pairs = Vec::new();
            // Cell k lies above curve k: the gap below everything is no cell.
            for (gap, origins) in sources.iter().enumerate().skip(1) {
                pairs.extend(origins.iter().filter(|&&origin| origin > 0).map(|&origin| (origin - 1, gap - 1)));
            }
            pairs
        })
    })
}

fn orders_of(n: usize) -> Vec<Vec<usize>> {
    (0..n.min(6)).fold(vec![Vec::new()], |all, _| {
        all.into_iter()
            .flat_map(|start: Vec<usize>| {
                let free: Vec<usize> = (0..n).filter(|k| !start.contains(k)).collect();
                free.into_iter().map(move |k| [start.clone(), vec![k]].concat())
            })
            .collect()
    })
}

/// Compares the regions of the atlas with the faces: cells, boundaries, neighbours, totals. Returns the cells of each.
pub(super) fn regions(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    pieces: &Pieces,
    slabs: &[Slab],
) -> Result<Vec<Vec<(usize, usize)>>, Refused> {
    let mut names: Vec<&str> = Vec::new();
    for name in slabs.iter().flat_map(|slab| &slab.faces) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let count = |what, claimed, found| {
        if claimed == found { Ok(()) } else { Err(Refused::Summary { what, claimed, found }) }
    };
    count("regions", document.regions.len(), names.len())?;
    count("regions", document.summary.regions, names.len())?;
    let sources: usize = certificate.events.iter().map(|event| event.sources.len()).sum();
    count("events", document.summary.events, sources)?;
    count("events", document.events.len(), sources)?;
    let id = |curve: usize| pieces.list[curve].id.clone();
    let mut all = Vec::new();
    for region in &document.regions {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        let mut cells = Vec::new();
        let (mut boundary, mut neighbours) = (Vec::new(), Vec::new());
        let mut described = Vec::new();
        for (number, slab) in slabs.iter().enumerate() {
            for position in (0..slab.faces.len()).filter(|&k| slab.faces[k] == region.id) {
                cells.push((number, position));
                let lower = slab.stands[position].0;
                let upper = slab.stands.get(position + 1).map(|stand| stand.0);
                described.push((id(lower), upper.map(id)));
                let below = position.checked_sub(1).map(|k| slab.faces[k].clone());
                let mut across = vec![(below, lower)];
                if let Some(upper) = upper {
                    across.push((Some(slab.faces[position + 1].clone()), upper));
                }
                for (face, curve) in across {
                    boundary.push(id(curve));
                    if let (true, Family::Line(plus)) = (pieces.list[curve].critical, pieces.list[curve].family) {
                        boundary.push(if plus { "P+" } else { "P-" }.to_owned());
                    }
                    neighbours.push((face, id(curve)));
                }
            }
        }
        let claimed: Vec<(String, Option<String>)> =
            region.cells.iter().map(|cell| (cell.lower.clone(), cell.upper.clone())).collect();
        if cells.is_empty() || claimed != described {
            return Err(refuse("its cells are not those of the face"));
        }
        let sorted = |mut list: Vec<String>| {
            list.sort();
            list.dedup();
            list
        };
        if sorted(region.boundary.clone()) != sorted(boundary) {
            return Err(refuse("its boundary is another"));
        }
        let mut claimed: Vec<(Option<String>, String)> =
            region.neighbours.iter().map(|n| (n.region.clone(), n.curve.clone())).collect();
        claimed.sort();
        neighbours.sort();
        neighbours.dedup();
        if claimed != neighbours {
            return Err(refuse("its neighbours are others"));
        }
        all.push(cells);
    }
    Ok(all)
}
