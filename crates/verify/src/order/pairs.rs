//! The order of two critical curves over all their common range, stretch by stretch.

use bifdiag_schema::{CertificateDocument, CertifiedPair, CertifiedStretch};

use super::mirror;
use super::node::{self, Node};
use super::orders::Orders;
use super::rules;
use crate::Refused;
use crate::equilibria::pieces::{Branch, End};
use crate::numbers::fixed::Fixed;

/// Two curves and the box in x of their crossing.
pub(crate) type Crossing = ([usize; 2], [Fixed; 2]);

/// Checks every pair of critical curves that no structure orders; the boxes of their crossings.
///
/// The global minimum lies below every other curve (Proposition 4.3), and straight lines meet only at pitchforks.
pub(crate) fn pairs(certificate: &CertificateDocument, orders: &Orders) -> Result<Vec<Crossing>, Refused> {
    let list = &orders.pieces.list;
    let compared = |&c: &usize| matches!(list[c].branch, Branch::Generic(_) | Branch::Over(_)) && !list[c].lowest;
    let compared: Vec<usize> = (0..list.len()).filter(compared).collect();
    let mut crossings = Vec::new();
    let mut used = 0;
    for (n, &b) in compared.iter().enumerate() {
        for &a in &compared[..n] {
            if node::common_range(orders, [a, b]).is_none() {
                continue;
            }
            let is_listed = |pair: &&CertifiedPair| [a, b].map(|c| &list[c].id) == pair.curves.each_ref();
            let claim = certificate.pairs.get(used).filter(is_listed);
            let missing = || orders.refused([a, b], 0.0, "the certificate does not state their order at its place");
            let claim = claim.ok_or_else(missing)?;
            crossings.extend(pair(orders, [a, b], claim)?.into_iter().map(|x| ([a, b], x)));
            used += 1;
        }
    }
    match certificate.pairs.get(used) {
        Some(stray) => Err(Refused::Pair {
            curves: stray.curves.clone(),
            x: 0.0,
            why: "the certificate lists more pairs than there are",
        }),
        None => Ok(crossings),
    }
}

/// Stretches from one end of the common range to the other, without gaps; the boxes of the crossings.
fn pair(orders: &Orders, curves: [usize; 2], pair: &CertifiedPair) -> Result<Vec<[Fixed; 2]>, Refused> {
    let refuse = |why| orders.refused(curves, 0.0, why);
    let mut crossings = Vec::new();
    let last = pair.stretches.len().checked_sub(1).ok_or_else(|| refuse("nothing is claimed of it"))?;
    let mut sign_before: Option<i8> = None;
    let mut reached: Option<Node> = None;
    for (number, claim) in pair.stretches.iter().enumerate() {
        let joined = number == 0 || pair.stretches[number - 1].to == claim.from;
        // Only the ends of the common range have no x.
        let ends = claim.from.x.is_none() == (number == 0) && claim.to.x.is_none() == (number == last);
        if !joined || !ends {
            return Err(refuse("its stretches leave a gap"));
        }
        if !matches!(claim.sign, -1 | 1) || sign_before.is_some_and(|sign| sign != claim.sign) {
            return Err(refuse("its signs contradict each other"));
        }
        // A stretch begins at the node at which the one before it ends.
        let from = match reached.take() {
            Some(node) => Some(node),
            None => node::read(orders, curves, &claim.from, 0)?,
        };
        let to = node::read(orders, curves, &claim.to, 1)?;
        crossings.extend(stretch(orders, curves, claim, [from.as_ref(), to.as_ref()])?);
        reached = to;
        sign_before = Some(if claim.crossing.is_some() { -claim.sign } else { claim.sign });
    }
    Ok(crossings)
}

/// A stretch: the rule that fits its ends must give the order that is claimed. The box of its crossing, if it has one.
fn stretch(
    orders: &Orders,
    curves: [usize; 2],
    stretch: &CertifiedStretch,
    [from, to]: [Option<&Node>; 2],
) -> Result<Option<[Fixed; 2]>, Refused> {
    let refuse = |why| orders.refused(curves, from.or(to).map_or(0.0, |node| node.x.to_f64()), why);
    if let (Some(from), Some(to)) = (from, to)
        && !from.x.below(&to.x)
    {
        return Err(refuse("a stretch runs backwards"));
    }
    let sign = stretch.sign;
    if let Some([first, last]) = &stretch.crossing {
        let box_of = [node::read(orders, curves, first, 0)?, node::read(orders, curves, last, 1)?];
        let (Some(from), Some(to), [Some(low), Some(high)]) = (from, to, box_of) else {
            return Err(refuse("a crossing has no box"));
        };
        return if rules::crosses_once(orders, curves, [from, &low, &high, to], sign) {
            Ok(Some([low.x, high.x]))
        } else {
            Err(refuse("a crossing is not where the certificate says, or not the only one there"))
        };
    }
    let holds = rules::ordered_on_axis(orders, curves) == Some(sign)
        || match (from, to) {
            (Some(from), Some(to)) => {
                rules::keeps_order(orders, curves, [from, to], sign)
                    || mirror::orders_branches(orders, curves, from, Some(to), sign)
            }
            (Some(from), None) => beyond(orders, curves, from, 1, sign),
            (None, Some(to)) => beyond(orders, curves, to, 0, sign),
            (None, None) => false,
        };
    if holds { Ok(None) } else { Err(refuse("the order that is claimed does not follow")) }
}

/// The order between a node and an end that both curves share.
fn beyond(orders: &Orders, curves: [usize; 2], node: &Node, side: usize, sign: i8) -> bool {
    match orders.pieces.list[curves[0]].ends[side] {
        End::Infinity => {
            rules::parts_for_ever(orders, curves, node, sign)
                || rules::tends_to_one_axis(orders, curves, node, sign)
                || mirror::orders_branches(orders, curves, node, None, sign)
        }
        End::Cusp(_) => rules::leaves_cusp(orders, curves, node, side, sign),
        End::Pitchfork(_) => rules::leaves_pitchfork(orders, curves, node, side, sign),
        End::Origin => false,
    }
}
