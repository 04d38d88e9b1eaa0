//! The cut of Staude's curve with three active moments in intervals of `f64`: what they do not tell is left to
//! [`exact`](super::exact).
//!
//! From a moment half the way to the next all μ − a_k are linear forms in u and 1 − u, and on the way to infinity after
//! multiplication by 1 − u; so are polynomials in μ forms, and beside the moment nothing cancels.

use dashu_ratio::RBig;
use numbers::Sign;
use numbers::enclosure::{Arithmetic, Enclosure};
use numbers::form::EnclosedForm;
use numbers::interval::Interval;

use super::cut::Cut;
use crate::model::Model;

/// Numbers of the body and the point.
struct Numbers {
    /// The moments, their weights, and their differences `diff[i][k]` = a_i − a_k.
    a: [Interval; 3],
    q: [Interval; 3],
    diff: [[Interval; 3]; 3],
    x: Interval,
    h: Interval,
}

impl Numbers {
    fn new(model: &Model, x: &RBig, h: &RBig) -> Option<Self> {
        let active: [usize; 3] = model.active[..].try_into().ok()?;
        let number = |value: &RBig| Interval::rational(value, ());
        let group = active.map(|k| &model.groups[k]);
        let mut diff = [[Interval::ZERO; 3]; 3];
        for (i, k) in [(1, 0), (2, 0), (2, 1)] {
            diff[i][k] = number(&model.difference(active[i], active[k]));
            diff[k][i] = -diff[i][k];
        }
        Some(Self { a: group.map(|g| number(&g.a)), q: group.map(|g| number(&g.q)), diff, x: number(x), h: number(h) })
    }
}

/// A range of μ on which u goes from 0 to 1, with forms.
struct Range {
    /// μ rises with u.
    rises: bool,
    p: EnclosedForm,
    rho: EnclosedForm,
    /// xp − hq and ρq: U = h on the curve's positive sign where the first times √p is the second.
    excess: EnclosedForm,
    pull: EnclosedForm,
    /// Σ q_i q_j (a_i − a_j)² (μ − a_k)³, which rises through 0 at the fold.
    fold: EnclosedForm,
}

impl Range {
    /// From a moment half the way to another one, or to infinity.
    fn new(n: &Numbers, base: usize, other: Option<usize>, sign: Sign) -> Self {
        let at_end = |k: usize| match other {
            Some(other) => n.diff[base][k] + n.diff[other][base] * Interval::point(0.5),
            // Times 1 − u.
            None => sign.orient(Interval::ONE),
        };
        let tau = [0, 1, 2].map(|k| EnclosedForm::linear(n.diff[base][k], at_end(k)));
        let triples = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
        let sum = |terms: [EnclosedForm; 3]| terms[0].plus(&terms[1]).plus(&terms[2]);
        let rest = triples.map(|(_, i, j)| tau[i].times(&tau[j]));
        let squared = rest.each_ref().map(|rest| rest.times(rest));
        let p = sum([0, 1, 2].map(|k| squared[k].scaled(n.q[k])));
        let q = sum([0, 1, 2].map(|k| squared[k].scaled(n.q[k] * n.a[k])));
        let rho = sum([0, 1, 2].map(|k| rest[k].scaled(n.q[k])));
        let fold = sum(triples
            .map(|(k, i, j)| tau[k].times(&tau[k]).times(&tau[k]).scaled(n.q[i] * n.q[j] * n.diff[i][j].square())));
        let excess = p.scaled(n.x).plus(&q.scaled(-n.h));
        let pull = rho.times(&q);
        Self { rises: sign == Sign::Positive, p, rho, excess, pull, fold }
    }

    /// Where U = h on either sign of the curve.
    fn level(&self) -> EnclosedForm {
        let square = self.p.times(&self.excess.times(&self.excess));
        square.plus(&self.pull.times(&self.pull).scaled(-Interval::ONE))
    }

    /// ω on the positive sign of the curve.
    fn latitude(&self, u: Interval) -> Interval {
        self.rho.at(u) / self.p.at(u).sqrt()
    }

    /// U < h on both signs of the curve.
    fn is_below(&self, u: f64) -> Option<[bool; 2]> {
        let u = Interval::point(u);
        let (kinetic, pull) = (self.excess.at(u) * self.p.at(u).sqrt(), self.pull.at(u));
        let [plus, minus] = Sign::BOTH.map(|sign| (kinetic - sign.orient(pull)).strict_sign());
        Some([plus? == Sign::Negative, minus? == Sign::Negative])
    }
}

/// A root of the level, or the fold.
struct Mark<'a> {
    range: &'a Range,
    u: Interval,
    is_fold: bool,
}

impl Mark<'_> {
    /// A place beyond it, or before it, with no other mark of its range between.
    fn beside(&self, beyond: bool) -> f64 {
        if self.range.rises == beyond { 0.5 * self.u.hi + 0.5 } else { 0.5 * self.u.lo }
    }
}

/// `None`: intervals of `f64` do not tell, or there are not three active moments.
pub(super) fn cut(model: &Model, x: &RBig, h: &RBig) -> Option<Cut<Interval>> {
    let numbers = Numbers::new(model, x, h)?;
    let ranges = ranges(&numbers);
    let mut marks = Vec::new();
    for range in &ranges {
        marks.extend(marks_in(range)?);
    }
    let mut folds = (0..marks.len()).filter(|&k| marks[k].is_fold);
    let (valley_roots, None) = (folds.next()?, folds.next()) else { return None };
    let gaps = (0..=marks.len()).map(|gap| match (gap.checked_sub(1).map(|k| &marks[k]), marks.get(gap)) {
        (Some(p), Some(q)) if std::ptr::eq(p.range, q.range) => {
            let [low, high] = if p.range.rises { [p, q] } else { [q, p] };
            p.range.is_below(0.5 * low.u.hi + 0.5 * high.u.lo)
        }
        (Some(p), _) => p.range.is_below(p.beside(true)),
        (None, Some(q)) => q.range.is_below(q.beside(false)),
        (None, None) => None,
    });
    let below: Vec<[bool; 2]> = gaps.collect::<Option<_>>()?;
    let inside = [0, 1].map(|sign| below.iter().map(|below| below[sign]).collect());
    let mut roots: Vec<Interval> = marks.iter().map(|mark| mark.range.latitude(mark.u)).collect();
    let fold = roots.remove(valley_roots);
    Some(Cut { roots, valley_roots, fold, inside })
}

/// The ranges by rising μ.
fn ranges(n: &Numbers) -> [Range; 6] {
    let negative = |base, other| Range::new(n, base, other, Sign::Negative);
    let positive = |base, other| Range::new(n, base, other, Sign::Positive);
    [
        negative(0, None),
        positive(0, Some(1)),
        negative(1, Some(0)),
        positive(1, Some(2)),
        negative(2, Some(1)),
        positive(2, None),
    ]
}

/// The marks in a range by rising μ.
fn marks_in(range: &Range) -> Option<Vec<Mark<'_>>> {
    let mark = |is_fold| move |u| Mark { range, u, is_fold };
    let roots = range.level().simple_roots()?.into_iter().map(mark(false));
    let mut marks: Vec<Mark<'_>> = roots.chain(range.fold.simple_roots()?.into_iter().map(mark(true))).collect();
    marks.sort_by(|p, q| p.u.lo.total_cmp(&q.u.lo));
    let apart = marks.windows(2).all(|pair| pair[0].u.hi <= pair[1].u.lo);
    if !range.rises {
        marks.reverse();
    }
    apart.then_some(marks)
}
