//! The order of two curves between two nodes.

use super::node::{Node, Open, Proof, Stretch};
use crate::evaluator::Evaluator;
use crate::family::State;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

/// How deep a stretch is halved: beside a cusp as deep as the cusp's neighbourhood is small.
pub(super) const DEPTH: u32 = 128;

/// What the slopes imply on a stretch.
#[derive(Clone, Copy, Debug)]
enum GapSign {
    /// One sign.
    Constant(Sign),
    /// From this sign to the opposite one, once.
    Crossing(Sign),
}

impl<E: Enclosure> Evaluator<'_, E> {
    /// The order between two nodes: settled at once, or on both sides of a node between them.
    pub(super) fn between(
        &self,
        curves: [CurveId; 2],
        from: &Node<E>,
        to: &Node<E>,
        depth: u32,
        stretches: &mut Vec<Stretch>,
    ) -> Result<(), Open> {
        let open = Open { x: [from.x.bounds()[0], to.x.bounds()[1]] };
        if let Some((sign, proof)) = self.settled(curves, from, to).ok_or(open)? {
            stretches.push(Stretch { x: [from.mark(), to.mark()], sign, proof });
            return Ok(());
        }
        let depth = depth.checked_sub(1).ok_or(open)?;
        let middle = self.middle(curves, from, to).ok_or(open)?;
        self.between(curves, from, &middle, depth, stretches)?;
        self.between(curves, &middle, to, depth, stretches)
    }

    /// The order between two nodes without another one; `Some(None)` when that does not show it, `None` when the box of
    /// a crossing cannot be found.
    #[allow(clippy::option_option)]
    fn settled(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>) -> Option<Option<(Sign, Proof)>> {
        if let Some(found) = self.slopes(curves, from, Some(to)).and_then(|slopes| self.by_slopes(from, to, &slopes)) {
            return self.resolved(curves, from, to, found).map(Some);
        }
        let states = self.states_between(from, to);
        let constant = |sign| Some(Some((sign, Proof::Constant)));
        if let Some(sign) = states.as_ref().and_then(|[a, b]| self.range_sign(a, b)) {
            return constant(sign);
        }
        let edges = [from, to].map(|node| (&node.x, &node.at));
        if let Some(sign) = self.mirrored_sign(curves, edges[0], Some(edges[1])) {
            return constant(sign);
        }
        let Some([a, b]) = states else { return Some(None) };
        let moment = self.moments_at_equal_momentum(&a, &b);
        if let Some(sign) = self.range_sign_with(&a, &b, &moment) {
            return constant(sign);
        }
        let found = self.by_slopes(from, to, &-(moment / (a.j * b.j)));
        found.map_or(Some(None), |found| self.resolved(curves, from, to, found).map(Some))
    }

    /// The course of the gap between two nodes with the range of the difference of slopes.
    fn by_slopes(&self, from: &Node<E>, to: &Node<E>, slopes: &E) -> Option<GapSign> {
        let reach = (to.x.clone() - from.x.clone()).hull(&self.c.small(0));
        // The gap at the lower end, then at the upper end.
        let ends = [from.gap.clone() + slopes.clone() * reach.clone(), to.gap.clone() - slopes.clone() * reach];
        if let Some(sign) = ends.iter().find_map(Enclosure::strict_sign) {
            return Some(GapSign::Constant(sign));
        }
        slopes.strict_sign()?;
        match (from.sign?, to.sign?) {
            (p, q) if p == q && p != Sign::Zero => Some(GapSign::Constant(p)),
            // They meet at one end, which is proved elsewhere.
            (Sign::Zero, q) | (q, Sign::Zero) if q != Sign::Zero => Some(GapSign::Constant(q)),
            (p, q) if p * q == Sign::Negative => Some(GapSign::Crossing(p)),
            _ => None,
        }
    }

    /// What the slopes imply, with the box of the crossing; `None` when that cannot be found.
    fn resolved(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>, found: GapSign) -> Option<(Sign, Proof)> {
        match found {
            GapSign::Constant(sign) => Some((sign, Proof::Constant)),
            GapSign::Crossing(sign) => Some((sign, Proof::Crossing(self.crossing(curves, from, to, sign)?))),
        }
    }

    /// A node between two others: at the first of several places that gives a sure sign.
    fn middle(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>) -> Option<Node<E>> {
        let (low, high) = (from.x.upper(), to.x.lower());
        let (near, far) = (low.bounds()[1], high.bounds()[0]);
        // Far apart, halve the logarithm.
        let share =
            if far > 4.0 * near && near > 0.0 { ((near / far).sqrt() - near / far) / (1.0 - near / far) } else { 0.5 };
        [1.0, 0.8, 1.22].into_iter().find_map(|t| {
            self.node_within(curves, &low, &high, share * t)
                .filter(|node| node.sign.is_some_and(|sign| sign != Sign::Zero))
        })
    }

    /// All states of both curves between two nodes; `None` when a curve runs on two halves there.
    fn states_between(&self, from: &Node<E>, to: &Node<E>) -> Option<[State<E>; 2]> {
        let state = |which: usize| {
            let (p, y) = from.at[which].place.as_ref()?;
            let (q, z) = to.at[which].place.as_ref()?;
            (p == q).then(|| self.state(*p, &y.hull(z)))
        };
        Some([state(0)?, state(1)?])
    }
}
