//! The borders in a cell: which changes on the way round it they join.

use super::lattice::{Place, Stop, distance, inward, mean};

/// How far a strip that ends reaches into a cell of the finest lattice.
const TIP: f64 = 0.4;

/// The most changes round a cell that are paired.
pub(super) const PAIRED_MAX: usize = 8;

/// The ways to join the changes on the way round a cell by borders that do not cross, as the other end of each: those on which
/// fewest borders return to the side from which they come, the shortest first. None where there is no way, as where three
/// things meet.
pub(super) fn joinings<L: PartialEq>(round: &[Stop<L>], changes: &[usize]) -> Vec<Vec<usize>> {
    if !changes.len().is_multiple_of(2) || changes.len() > PAIRED_MAX {
        return Vec::new();
    }
    let after = |change: usize| &round[changes[change]].after;
    let before = |change: usize| after((change + changes.len() - 1) % changes.len());
    let agree = |one: usize, other: usize| before(one) == after(other) && after(one) == before(other);
    let cost = |pairs: &Vec<[usize; 2]>| {
        let stops = |pair: &[usize; 2]| pair.map(|change| &round[changes[change]]);
        let returns = pairs.iter().filter(|pair| stops(pair)[0].side == stops(pair)[1].side).count();
        (returns, pairs.iter().map(|pair| distance(stops(pair)[0].at, stops(pair)[1].at)).sum::<f64>())
    };
    let all = pairings(&(0..changes.len()).collect::<Vec<_>>(), &agree);
    let mut all: Vec<_> = all.into_iter().map(|pairs| (cost(&pairs), pairs)).collect();
    all.sort_by(|(p, _), (q, _)| p.0.cmp(&q.0).then(p.1.total_cmp(&q.1)));
    let fewest = all.first().map_or(0, |(cost, _)| cost.0);
    let partners = |pairs: Vec<[usize; 2]>| {
        let mut partners = vec![0; changes.len()];
        for [one, other] in pairs {
            (partners[one], partners[other]) = (other, one);
        }
        partners
    };
    all.into_iter().filter(|(cost, _)| cost.0 == fewest).map(|(_, pairs)| partners(pairs)).collect()
}

/// All ways to pair points on a circle by chords that do not cross.
pub(super) fn pairings(points: &[usize], agree: &impl Fn(usize, usize) -> bool) -> Vec<Vec<[usize; 2]>> {
    let Some((first, rest)) = points.split_first() else { return vec![Vec::new()] };
    let mut all = Vec::new();
    for (place, other) in rest.iter().enumerate().step_by(2).filter(|(_, other)| agree(*first, **other)) {
        for within in pairings(&rest[..place], agree) {
            for beyond in pairings(&rest[place + 1..], agree) {
                all.push([vec![[*first, *other]], within.clone(), beyond].concat());
            }
        }
    }
    all
}

/// The line from one change to another: straight, over a bend, or round a tip where both lie on one side.
pub(super) fn chord<L>(from: &Stop<L>, to: &Stop<L>, bend: Option<Place>) -> Vec<Place> {
    let mut line = vec![from.at, to.at];
    if let Some(bend) = bend {
        line.insert(1, bend);
    } else if from.side == to.side {
        let ([x, y], [dx, dy]) = (mean([from.at, to.at].into_iter()), inward(from.side));
        line.insert(1, [x + TIP * dx, y + TIP * dy]);
    }
    line
}
