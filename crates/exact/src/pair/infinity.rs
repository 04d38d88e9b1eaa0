//! The order of two curves towards x → ∞.

use super::node::{Node, Open, Proof, Stretch, StretchEnd, few_bits};
use super::stretch::DEPTH;
use crate::evaluator::Evaluator;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

/// How often x is multiplied by 8 on the way to infinity.
const FAR: u32 = 90;

impl<E: Enclosure> Evaluator<'_, E> {
    pub(super) fn to_infinity(
        &self,
        curves: [CurveId; 2],
        first: Node<E>,
        stretches: &mut Vec<Stretch>,
    ) -> Result<(), Open> {
        let mut node = first;
        for _ in 0..FAR {
            if let Some(sign) = self.far_sign(curves, &node) {
                stretches.push(Stretch { x: [node.mark(), StretchEnd::End], sign, proof: Proof::Constant });
                return Ok(());
            }
            let from = node.x.bounds()[1];
            let next = [8.0, 7.0, 10.0]
                .into_iter()
                .find_map(|factor| {
                    self.node(curves, &E::double(few_bits(factor * from), self.c.precision))
                        .filter(|node| node.sign.is_some_and(|sign| sign != Sign::Zero))
                })
                .ok_or(Open { x: [from, f64::INFINITY] })?;
            self.between(curves, &node, &next, DEPTH, stretches)?;
            node = next;
        }
        Err(Open { x: [node.x.bounds()[0], f64::INFINITY] })
    }

    /// The sign all the way to infinity.
    fn far_sign(&self, curves: [CurveId; 2], node: &Node<E>) -> Option<Sign> {
        if let Some(sign) = self.mirrored_sign(curves, (&node.x, &node.at), None) {
            return Some(sign);
        }
        let gap = node.sign?.strict()?;
        if self.slopes(curves, node, None).and_then(|slopes| slopes.strict_sign()) == Some(gap) {
            return Some(gap);
        }
        let limits = curves.map(|c| self.curves.list[c].limit);
        let [Some(p), Some(q)] = limits else { return None };
        if p.group != q.group {
            return None;
        }
        let phi = |which: usize| {
            let limit = limits[which]?;
            let point = &node.at[which];
            // J is monotone towards a: no inflection ahead, so that h − x/a is monotone.
            let a = self.c.a[limit.group].clone();
            let now = point.h_above(&self.c, limit.group, &a);
            let root = self.c.root_q[limit.group].clone();
            let end = match limit.side {
                Sign::Positive => -root,
                Sign::Negative => root,
                Sign::Zero => self.c.small(0),
            };
            self.straight(curves[which], point).then(|| now.hull(&end))
        };
        let (p, q) = (phi(0)?, phi(1)?);
        (p - q).strict_sign().filter(|sign| *sign == gap)
    }
}
