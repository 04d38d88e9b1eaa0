//! Questions in growing precision until they are answered.

use std::cell::{Cell, OnceCell};

use dashu_ratio::RBig;

use crate::curves::Curves;
use crate::model::Model;
use crate::pair::{Open, PairProof};
use crate::point::{Evaluator, Passage, Point};
use crate::work::{Question, Rung, decided};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::wide::{Interval128, Interval384};

/// Bits of the second and third stage.
pub(crate) const STAGES: [usize; 2] = [128, 384];

/// Runs a question in growing precision until it is answered.
pub(super) struct Stages<'a> {
    model: &'a Model,
    curves: &'a Curves,
    meetings: &'a [Passage],
    narrow: Evaluator<'a, Interval>,
    /// Made when first needed.
    middle: OnceCell<Evaluator<'a, Interval128>>,
    wide: OnceCell<Evaluator<'a, Interval384>>,
    pub used: Cell<usize>,
    /// The most points of a pair of curves at each precision.
    pub points: u32,
}

impl<'a> Stages<'a> {
    pub(super) fn new(model: &'a Model, curves: &'a Curves, meetings: &'a [Passage], points: u32) -> Self {
        let narrow = Evaluator::new(model, curves, meetings, ());
        let (middle, wide, used) = (OnceCell::new(), OnceCell::new(), Cell::new(0));
        Self { model, curves, meetings, narrow, middle, wide, used, points }
    }

    fn middle(&self) -> &Evaluator<'a, Interval128> {
        self.used.set(self.used.get().max(STAGES[0]));
        self.middle.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    fn wide(&self) -> &Evaluator<'a, Interval384> {
        self.used.set(self.used.get().max(STAGES[1]));
        self.wide.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    pub(super) fn pair(&self, a: CurveId, b: CurveId) -> Result<Option<PairProof>, Open> {
        let mut rung = Rung::Double;
        let found = self.narrow.pair(a, b, self.points);
        let found = found.or_else(|_| {
            rung = Rung::Bits(STAGES[0]);
            self.middle().pair(a, b, self.points)
        });
        let found = found.or_else(|_| {
            rung = Rung::Bits(STAGES[1]);
            self.wide().pair(a, b, self.points)
        });
        decided(Question::Pair, if found.is_ok() { rung } else { Rung::Open });
        found
    }

    /// The order of these curves over x, with enclosures of their heights.
    pub(super) fn order(&self, curves: &[CurveId], x: &RBig) -> Option<Ordered> {
        let mut rung = Rung::Double;
        let found = order(&self.narrow, curves, x);
        let found = found.or_else(|| {
            rung = Rung::Bits(STAGES[0]);
            order(self.middle(), curves, x)
        });
        let found = found.or_else(|| {
            rung = Rung::Bits(STAGES[1]);
            order(self.wide(), curves, x)
        });
        decided(Question::Order, if found.is_some() { rung } else { Rung::Open });
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
