//! The borders in a cell: which changes on the way round it they join.

use super::lattice::{Place, Stop, distance, inward, mean};

/// How far a strip that ends reaches into a cell of the finest lattice.
const TIP: f64 = 0.4;

/// The most changes round a cell that are paired.
pub(super) const PAIRED_MAX: usize = 8;

/// For each change on the way round a cell the one at the other end of its border, so that no two borders cross: of all ways
/// the one on which fewest borders return to the side from which they come, of those one with what is shown in the middle,
/// and of those the shortest. None where there is no way, as where three things meet.
pub(super) fn partners<L: PartialEq>(round: &[Stop<L>], changes: &[usize], middle: Option<&L>) -> Option<Vec<usize>> {
    if !changes.len().is_multiple_of(2) || changes.len() > PAIRED_MAX {
        return None;
    }
    let after = |change: usize| &round[changes[change]].after;
    let before = |change: usize| after((change + changes.len() - 1) % changes.len());
    let agree = |one: usize, other: usize| before(one) == after(other) && after(one) == before(other);
    let cost = |pairs: &Vec<[usize; 2]>| {
        let stops = |pair: &[usize; 2]| pair.map(|change| &round[changes[change]]);
        let returns = pairs.iter().filter(|pair| stops(pair)[0].side == stops(pair)[1].side).count();
        // Of four changes all lie at the part in the middle.
        let shown = after(usize::from(pairs[0][1] == 1));
        let is_other = changes.len() == 4 && middle.is_some_and(|middle| shown.as_ref() != Some(middle));
        ((returns, is_other), pairs.iter().map(|pair| distance(stops(pair)[0].at, stops(pair)[1].at)).sum::<f64>())
    };
    let all = pairings(&(0..changes.len()).collect::<Vec<_>>(), &agree);
    let best = all.into_iter().min_by(|p, q| {
        let (p, q) = (cost(p), cost(q));
        p.0.cmp(&q.0).then(p.1.total_cmp(&q.1))
    })?;
    let mut partners = vec![0; changes.len()];
    for [one, other] in best {
        (partners[one], partners[other]) = (other, one);
    }
    Some(partners)
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

/// The line from one change to another: straight, or round a tip where both lie on one side.
pub(super) fn chord<L>(from: &Stop<L>, to: &Stop<L>) -> Vec<Place> {
    let mut line = vec![from.at, to.at];
    if from.side == to.side {
        let ([x, y], [dx, dy]) = (mean([from.at, to.at].into_iter()), inward(from.side));
        line.insert(1, [x + TIP * dx, y + TIP * dy]);
    }
    line
}
