//! The order of two curves over all of their common range.
//!
//! The order of two curves beside a cusp or pitchfork that both share.

use super::node::{Node, Open, PairProof, Proof, Stretch, StretchEnd};
use super::side::{Side, position};
use super::stretch::DEPTH;
use crate::evaluator::Evaluator;
use crate::family::Curvature;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// The order of curves a and b, neither of which is a line or structurally lowest. `None` when they have no common x.
    /// Left open when more than `points` points of the two would be needed.
    pub fn pair(&self, a: CurveId, b: CurveId, points: u32) -> Result<Option<PairProof>, Open> {
        self.allow(points);
        let curves = [a, b];
        let anywhere = Open { x: [0.0, f64::INFINITY] };
        let lower = self.side(curves, 0).ok_or(anywhere)?;
        let upper = self.side(curves, 1).ok_or(anywhere)?;
        let (Some(lower), Some(upper)) = (lower, upper) else { return Ok(None) };
        if let (Some(low), Some(high)) = (position(&lower), position(&upper)) {
            if high.is_below(&low) {
                return Ok(None);
            }
            if !low.is_below(&high) {
                // The range may be empty: one curve ends where the other begins.
                return self
                    .touching(curves)
                    .map_or_else(|| Err(Open { x: [low.bounds()[0], high.bounds()[1]] }), |()| Ok(None));
            }
        }
        if let Some(sign) = self.ordered_on_axis(curves) {
            let stretches = vec![Stretch { x: [StretchEnd::End, StretchEnd::End], sign, proof: Proof::Constant }];
            return Ok(Some(PairProof { curves, stretches }));
        }
        let mut stretches = Vec::new();
        let first = self.leave(curves, &lower, &upper, &mut stretches)?;
        let Some(first) = first else { return Ok(Some(PairProof { curves, stretches })) };
        match upper {
            Side::Infinity => self.to_infinity(curves, first, &mut stretches)?,
            Side::Node(last) => self.between(curves, &first, &last, DEPTH, &mut stretches)?,
            Side::Cusp(_) | Side::Pitchfork(_) => {
                let last = self.approach(curves, &upper, &first, &mut stretches)?;
                let tail = stretches.pop();
                self.between(curves, &first, &last, DEPTH, &mut stretches)?;
                stretches.extend(tail);
            }
            Side::Origin => return Err(anywhere),
        }
        Ok(Some(PairProof { curves, stretches }))
    }
}

impl<E: Enclosure> Evaluator<'_, E> {
    /// The first node with a proved gap, and the stretch before it.
    pub(super) fn leave(
        &self,
        curves: [CurveId; 2],
        lower: &Side<E>,
        upper: &Side<E>,
        stretches: &mut Vec<Stretch>,
    ) -> Result<Option<Node<E>>, Open> {
        match lower {
            Side::Node(node) => Ok(Some((**node).clone())),
            Side::Cusp(x) | Side::Pitchfork(x) => {
                let from = x.upper();
                let to = position(upper).map_or_else(|| from.clone() * self.c.small(2), |x| x.lower());
                let open = Open { x: [from.bounds()[0], to.bounds()[1]] };
                let mut t = if position(upper).is_some() { 0.5 } else { 1.0 };
                for _ in 0..DEPTH {
                    let found = self
                        .node_within(curves, &from, &to, t)
                        .and_then(|node| self.sign_beside(curves, lower, &node, 0).map(|sign| (sign, node)));
                    if let Some((sign, node)) = found {
                        stretches.push(Stretch { x: [StretchEnd::End, node.mark()], sign, proof: Proof::Constant });
                        return Ok(Some(node));
                    }
                    t *= 0.25;
                }
                Err(open)
            }
            Side::Origin | Side::Infinity => Err(Open { x: [0.0, f64::INFINITY] }),
        }
    }

    /// The last node before a common end, and the stretch after it.
    pub(super) fn approach(
        &self,
        curves: [CurveId; 2],
        upper: &Side<E>,
        first: &Node<E>,
        stretches: &mut Vec<Stretch>,
    ) -> Result<Node<E>, Open> {
        let from = first.x.upper();
        let to = position(upper).map(|x| x.lower());
        let open = Open { x: [from.bounds()[0], to.as_ref().map_or(f64::INFINITY, |to| to.bounds()[1])] };
        let to = to.ok_or(open)?;
        let mut t = 0.5;
        for _ in 0..DEPTH {
            let found = self
                .node_within(curves, &to, &from, t)
                .and_then(|node| self.sign_beside(curves, upper, &node, 1).map(|sign| (sign, node)));
            if let Some((sign, node)) = found {
                stretches.push(Stretch { x: [node.mark(), StretchEnd::End], sign, proof: Proof::Constant });
                return Ok(node);
            }
            t *= 0.25;
        }
        Err(open)
    }

    /// The sign of the gap between a common cusp or pitchfork and a node.
    fn sign_beside(&self, curves: [CurveId; 2], end: &Side<E>, node: &Node<E>, side: usize) -> Option<Sign> {
        match end {
            Side::Cusp(_) => {
                if self.bends(curves[0], &node.at[0], &node.at[1])? {
                    return None;
                }
                let slopes = node.at[0].slope(&self.c) - node.at[1].slope(&self.c);
                let sign = slopes.strict_sign()?;
                Some(if side == 0 { sign } else { -sign })
            }
            Side::Pitchfork(_) => {
                let curvature = |which: usize| {
                    let (half, y) = node.at[which].place.clone()?;
                    let end = self.end_point(curves[which], side)?;
                    let (end_half, end_y) = end.place.as_ref()?;
                    if half != *end_half {
                        return None;
                    }
                    Some(Curvature::of(&self.state(half, &y.hull(end_y)), [&end.over, &node.at[which].over]))
                };
                curvature(0)?.minus(&curvature(1)?)
            }
            _ => None,
        }
    }
}
