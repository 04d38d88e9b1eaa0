//! The cut of Staude's curve with three active moments in intervals, where they decide it.
//!
//! From a moment half the way to the next all μ − a_k are linear forms in u and 1 − u, and on the way to infinity after
//! multiplication by 1 − u; so are polynomials in μ forms, and beside the moment nothing cancels.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::form::EnclosedForm;
use bifdiag_numbers::interval::Interval;
use dashu_ratio::RBig;

use super::strand::Cut;
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

/// The ranges of μ by rising μ: from a moment half the way to another one, or to infinity.
pub(super) const RANGES: [(usize, Option<usize>, Sign); 6] = [
    (0, None, Sign::Negative),
    (0, Some(1), Sign::Positive),
    (1, Some(0), Sign::Negative),
    (1, Some(2), Sign::Positive),
    (2, Some(1), Sign::Negative),
    (2, None, Sign::Positive),
];

/// A range of μ on which u goes from 0 to 1, with forms, each up to a positive factor.
pub(super) struct Range<E> {
    /// μ rises with u.
    pub rises: bool,
    pub p: EnclosedForm<E>,
    pub rho: EnclosedForm<E>,
    /// xp − hq.
    pub excess: EnclosedForm<E>,
    /// p (xp − hq)² − ρ²q²: U = h on either sign of the curve where it vanishes.
    pub level: EnclosedForm<E>,
    /// Σ q_i q_j (a_i − a_j)² (μ − a_k)³, which rises through 0 at the fold.
    pub fold: EnclosedForm<E>,
}

/// The ranges in intervals of `f64`.
pub(super) fn ranges(model: &Model, x: &RBig, h: &RBig) -> Option<[Range<Interval>; 6]> {
    let numbers = Numbers::new(model, x, h)?;
    Some(RANGES.map(|(base, other, sign)| range(&numbers, base, other, sign)))
}

fn range(n: &Numbers, base: usize, other: Option<usize>, sign: Sign) -> Range<Interval> {
    let at_end = |k: usize| match other {
        Some(other) => n.diff[base][k] + n.diff[other][base] * Interval::point(0.5),
        // Times 1 − u.
        None => sign.orient(Interval::ONE),
    };
    let tau = [0, 1, 2].map(|k| EnclosedForm::linear(n.diff[base][k], at_end(k)));
    let triples = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
    let sum = |terms: [EnclosedForm<Interval>; 3]| terms[0].plus(&terms[1]).plus(&terms[2]);
    let rest = triples.map(|(_, i, j)| tau[i].times(&tau[j]));
    let squared = rest.each_ref().map(|rest| rest.times(rest));
    let p = sum([0, 1, 2].map(|k| squared[k].scaled(&n.q[k])));
    let q = sum([0, 1, 2].map(|k| squared[k].scaled(&(n.q[k] * n.a[k]))));
    let rho = sum([0, 1, 2].map(|k| rest[k].scaled(&n.q[k])));
    let fold = sum(triples
        .map(|(k, i, j)| tau[k].times(&tau[k]).times(&tau[k]).scaled(&(n.q[i] * n.q[j] * n.diff[i][j].square()))));
    let excess = p.scaled(&n.x).plus(&q.scaled(&-n.h));
    let pull = rho.times(&q);
    let level = p.times(&excess.times(&excess)).plus(&pull.times(&pull).scaled(&-Interval::ONE));
    Range { rises: sign == Sign::Positive, p, rho, excess, level, fold }
}

impl<E: Enclosure<Precision = ()>> Range<E> {
    /// ω on the positive sign of the curve.
    fn latitude(&self, u: &E) -> E {
        self.rho.at(u) / self.p.at(u).sqrt()
    }

    /// U < h on both signs of the curve, that is (xp − hq)√p < ± ρq: the side with the larger square decides, and q > 0.
    fn is_below(&self, u: &E) -> Option<[bool; 2]> {
        Some(if self.level.at(u).strict_sign()? == Sign::Positive {
            [self.excess.at(u).strict_sign()? == Sign::Negative; 2]
        } else {
            let pull = self.rho.at(u).strict_sign()?;
            Sign::BOTH.map(|sign| pull == sign)
        })
    }
}

/// A root of the level, or the fold.
struct Mark<'a, E> {
    range: &'a Range<E>,
    u: E,
    is_fold: bool,
}

impl<E: Enclosure<Precision = ()>> Mark<'_, E> {
    /// A place beyond it, or before it, with no other mark of its range between.
    fn beside(&self, beyond: bool) -> E {
        if self.range.rises == beyond { between(&self.u, &E::small(1, ())) } else { between(&E::small(0, ()), &self.u) }
    }
}

/// A place between two ranges of u.
fn between<E: Enclosure>(low: &E, high: &E) -> E {
    low.upper().hull(&high.lower()).middle()
}

/// `None`: these intervals do not decide.
pub(super) fn cut<E: Enclosure<Precision = ()>>(ranges: &[Range<E>; 6]) -> Option<Cut<E>> {
    let mut marks = Vec::new();
    for range in ranges {
        marks.extend(marks_in(range)?);
    }
    let mut folds = (0..marks.len()).filter(|&k| marks[k].is_fold);
    let (valley_roots, None) = (folds.next()?, folds.next()) else { return None };
    let gaps = (0..=marks.len()).map(|gap| match (gap.checked_sub(1).map(|k| &marks[k]), marks.get(gap)) {
        (Some(p), Some(q)) if std::ptr::eq(p.range, q.range) => {
            let [low, high] = if p.range.rises { [p, q] } else { [q, p] };
            p.range.is_below(&between(&low.u, &high.u))
        }
        (Some(p), _) => p.range.is_below(&p.beside(true)),
        (None, Some(q)) => q.range.is_below(&q.beside(false)),
        (None, None) => None,
    });
    let below: Vec<[bool; 2]> = gaps.collect::<Option<_>>()?;
    let inside = [0, 1].map(|sign| below.iter().map(|below| below[sign]).collect());
    let mut roots: Vec<E> = marks.iter().map(|mark| mark.range.latitude(&mark.u)).collect();
    let fold = roots.remove(valley_roots);
    Some(Cut { roots, valley_roots, fold, inside })
}

/// The marks in a range by rising μ.
fn marks_in<E: Enclosure<Precision = ()>>(range: &Range<E>) -> Option<Vec<Mark<'_, E>>> {
    let mut marks: Vec<Mark<'_, E>> = Vec::new();
    for (form, is_fold) in [(&range.level, false), (&range.fold, true)] {
        marks.extend(form.simple_roots()?.into_iter().map(|u| Mark { range, u, is_fold }));
    }
    // The fold is the last of them: one exchange after the other brings it to its place.
    for k in (1..marks.len()).rev() {
        if !marks[k - 1].u.is_below(&marks[k].u) {
            marks.swap(k - 1, k);
        }
    }
    let apart = marks.windows(2).all(|pair| pair[0].u.is_below(&pair[1].u));
    if !range.rises {
        marks.reverse();
    }
    apart.then_some(marks)
}
