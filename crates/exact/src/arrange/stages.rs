//! Questions in growing precision until they are answered.
//!
//! The order of each pair of curves that needs one.

use std::cell::Cell;

use super::event::{Event, Undecided, crossing_event};
use crate::curves::{Curves, Shape};
use crate::evaluator::{Evaluator, Evaluators, Passage, Point};
use crate::model::Model;
use crate::pair::{Open, POINTS, PairProof, Proof};
use crate::statistics::{Precision, Question, count};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::wide::{Interval128, Interval384};
use dashu_ratio::RBig;

/// Bits of the second and third stage.
pub(crate) const STAGES: [usize; 2] = [128, 384];

/// Runs a question in growing precision until it is answered.
pub(super) struct Stages<'a> {
    evaluators: Evaluators<'a>,
    pub used: Cell<usize>,
    /// The most points of a pair of curves at each precision.
    pub points: u32,
}

impl<'a> Stages<'a> {
    pub(super) fn new(model: &'a Model, curves: &'a Curves, meetings: &'a [Passage], points: u32) -> Self {
        Self { evaluators: Evaluators::new(model, curves, meetings), used: Cell::new(0), points }
    }

    fn middle(&self) -> &Evaluator<'a, Interval128> {
        self.used.set(self.used.get().max(STAGES[0]));
        self.evaluators.middle()
    }

    fn wide(&self) -> &Evaluator<'a, Interval384> {
        self.used.set(self.used.get().max(STAGES[1]));
        self.evaluators.wide()
    }

    pub(super) fn pair(&self, a: CurveId, b: CurveId) -> Result<Option<PairProof>, Open> {
        let mut precision = Precision::Double;
        let found = self.evaluators.narrow().pair(a, b, self.points);
        let found = found.or_else(|_| {
            precision = Precision::Bits(STAGES[0]);
            self.middle().pair(a, b, self.points)
        });
        let found = found.or_else(|_| {
            precision = Precision::Bits(STAGES[1]);
            self.wide().pair(a, b, self.points)
        });
        count(Question::Pair, if found.is_ok() { precision } else { Precision::Open });
        found
    }

    /// The order of these curves over x, with enclosures of their heights.
    pub(super) fn order(&self, curves: &[CurveId], x: &RBig) -> Option<Ordered> {
        let mut precision = Precision::Double;
        let found = order(self.evaluators.narrow(), curves, x);
        let found = found.or_else(|| {
            precision = Precision::Bits(STAGES[0]);
            order(self.middle(), curves, x)
        });
        let found = found.or_else(|| {
            precision = Precision::Bits(STAGES[1]);
            order(self.wide(), curves, x)
        });
        count(Question::Order, if found.is_some() { precision } else { Precision::Open });
        found
    }
}

/// Curves by rising height, with enclosures of their heights.
pub(super) struct Ordered {
    pub curves: Vec<CurveId>,
    pub heights: Vec<[f64; 2]>,
}

/// The proved order of curves over x.
fn order<E: Enclosure>(evaluator: &Evaluator<'_, E>, curves: &[CurveId], x: &RBig) -> Option<Ordered> {
    let set = E::rational(x, evaluator.c.precision);
    let mut points: Vec<(CurveId, Point<E>, [f64; 2])> = Vec::with_capacity(curves.len());
    for &curve in curves {
        let point = evaluator.point(curve, &set)?;
        let bounds = point.h().bounds();
        points.push((curve, point, bounds));
    }
    let list = &evaluator.curves.list;
    let key = |bounds: &[f64; 2]| bounds[0] + bounds[1];
    points.sort_by(|p, q| list[q.0].lowest.cmp(&list[p.0].lowest).then(key(&p.2).total_cmp(&key(&q.2))));
    // Neighbours whose rounded heights mislead are exchanged by the sign of their gap.
    for _ in 0..points.len() {
        let mut changed = false;
        for k in 1..points.len() {
            if !list[points[k - 1].0].lowest
                && evaluator.gap(&points[k].1, &points[k - 1].1).sign() == Some(Sign::Negative)
            {
                points.swap(k - 1, k);
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    let proved = points
        .windows(2)
        .all(|pair| list[pair[0].0].lowest || evaluator.gap(&pair[1].1, &pair[0].1).sign() == Some(Sign::Positive));
    proved.then(|| Ordered {
        curves: points.iter().map(|p| p.0).collect(),
        heights: points.iter().map(|p| p.2).collect(),
    })
}

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
