//! The order of each pair of curves that needs one.

use super::event::{Event, crossing_event};
use super::stages::Stages;
use super::undecided::Undecided;
use crate::curves::{Curves, Shape};
use crate::pair::{POINTS, PairProof, Proof};
use crate::point::Evaluator;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::wide::Interval384;

/// The proofs of all pairs, and their crossings. With fewer than [`POINTS`] points of each pair the first one that is left
/// open ends it.
pub(super) fn pairs(
    plain: &Evaluator<'_, Interval384>,
    stages: &Stages<'_>,
) -> Result<(Vec<PairProof>, Vec<Event>), Vec<Undecided>> {
    let curves = plain.curves;
    let (mut pairs, mut crossings, mut undecided) = (Vec::new(), Vec::new(), Vec::new());
    for b in curves.list.ids().filter(|&b| needs_order(curves, b)) {
        for a in curves.list.ids().take_while(|a| *a < b).filter(|&a| needs_order(curves, a)) {
            match stages.pair(a, b) {
                Ok(None) => {}
                Ok(Some(proof)) => {
                    for stretch in &proof.stretches {
                        if let Proof::Crossing(x) = &stretch.proof {
                            crossings.push(crossing_event(plain, [a, b], x));
                        }
                    }
                    pairs.push(proof);
                }
                Err(open) => {
                    undecided.push(Undecided::Pair { curves: [a, b], x: open.x });
                    if stages.points < POINTS {
                        return Err(undecided);
                    }
                }
            }
        }
    }
    if undecided.is_empty() { Ok((pairs, crossings)) } else { Err(undecided) }
}

/// Where lines cross others is known from isolated roots, and nothing crosses the lowest curve.
fn needs_order(curves: &Curves, curve: CurveId) -> bool {
    matches!(curves.list[curve].shape, Shape::Family(_)) && !curves.list[curve].lowest
}
