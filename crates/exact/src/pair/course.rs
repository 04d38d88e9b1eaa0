//! The order of two curves over all of their common range.

use super::proof::{Mark, Open, PairProof, Proof, Stretch};
use super::side::{Side, position};
use super::stretch::DEPTH;
use crate::point::Evaluator;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::enclosure::Enclosure;

impl<E: Enclosure> Evaluator<'_, E> {
    /// The order of curves a and b, neither of which is a line or structurally lowest. `None` when they have no common x.
    /// Left open when more than so many `points` of the two would be needed.
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
            let stretches = vec![Stretch { x: [Mark::End, Mark::End], sign, proof: Proof::Constant }];
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
