//! How far the sample of a region is from the curves around it.

use std::cell::OnceCell;

use bifdiag_diagram::arrangement::Cell;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::wide::{Interval128, Interval384};
use dashu_base::Abs;
use dashu_ratio::RBig;

use super::arrange::{Arrangement, Slab};
use super::point::Evaluator;

/// The distance in h to the nearest curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Margin {
    /// Bounds.
    pub distance: [f64; 2],
    pub nearest: CurveId,
}

/// Enclosures beyond doubles, made when first needed.
pub(super) struct Evaluators<'a> {
    arrangement: &'a Arrangement,
    middle: OnceCell<Evaluator<'a, Interval128>>,
    wide: OnceCell<Evaluator<'a, Interval384>>,
}

impl<'a> Evaluators<'a> {
    pub fn new(arrangement: &'a Arrangement) -> Self {
        Self { arrangement, middle: OnceCell::new(), wide: OnceCell::new() }
    }

    pub fn middle(&self) -> &Evaluator<'a, Interval128> {
        let Arrangement { model, curves, .. } = self.arrangement;
        self.middle.get_or_init(|| Evaluator::new(model, curves, &[], ()))
    }

    pub fn wide(&self) -> &Evaluator<'a, Interval384> {
        let Arrangement { model, curves, .. } = self.arrangement;
        self.wide.get_or_init(|| Evaluator::new(model, curves, &[], ()))
    }

    /// The distance of h from the two curves around a cell over the slab's abscissa: no other curve is as near. Where the
    /// largest precision does not tell which of the two is nearer, it is the lower one.
    pub fn margin(&self, cell: Cell, h: &RBig) -> Margin {
        let strip = &self.arrangement.slabs[cell.slab];
        let clear = |(margin, is_clear): (Margin, bool)| is_clear.then_some(margin);
        among(self.middle(), strip, cell.position, h)
            .and_then(clear)
            .or_else(|| among(self.wide(), strip, cell.position, h).map(|(margin, _)| margin))
            .unwrap_or_else(|| of_doubles(strip, cell.position, h))
    }
}

/// The margin among the curves on both sides, and whether these bits tell which is nearer and how far it is.
fn among<E: Enclosure<Precision = ()>>(
    evaluator: &Evaluator<'_, E>,
    strip: &Slab,
    position: usize,
    h: &RBig,
) -> Option<(Margin, bool)> {
    /// A distance is known to this relative accuracy.
    const ACCURACY: f64 = 1e-12;
    let (x, at) = (E::rational(&strip.x, ()), E::rational(h, ()));
    let height = |curve: CurveId| Some(evaluator.point(curve, &x)?.h());
    let lower = strip.order[position];
    let below = at.clone() - height(lower)?;
    let (nearest, distance, is_told) = match strip.order.get(position + 1) {
        None => (lower, size(&below), true),
        Some(&upper) => {
            let above = height(upper)? - at;
            match (below.clone() - above.clone()).strict_sign() {
                Some(Sign::Positive) => (upper, size(&above), true),
                Some(_) => (lower, size(&below), true),
                None => (lower, size(&below), false),
            }
        }
    };
    let is_sharp = distance[1] - distance[0] <= ACCURACY * distance[0];
    Some((Margin { distance, nearest }, is_told && is_sharp))
}

/// Bounds of the absolute value.
fn size<E: Enclosure>(difference: &E) -> [f64; 2] {
    let [lo, hi] = difference.bounds();
    [lo.max(-hi).max(0.0), hi.max(-lo)]
}

/// The same from the heights in doubles by which the order was proved.
fn of_doubles(strip: &Slab, position: usize, h: &RBig) -> Margin {
    let bounds = |place: usize| {
        let height = strip.heights.get(place)?.map(|height| RBig::try_from(height).ok());
        let [Some(lo), Some(hi)] = height else { return None };
        let [least, most] = if place == position { [h - hi, h - lo] } else { [lo - h, hi - h] };
        let down = least.max(RBig::ZERO).to_f64().value().next_down().max(0.0);
        Some(Margin { distance: [down, most.to_f64().value().next_up()], nearest: strip.order[place] })
    };
    let around = [position, position + 1].into_iter().filter_map(bounds);
    let nearest = around.min_by(|p, q| p.distance[1].total_cmp(&q.distance[1]));
    nearest.unwrap_or(Margin { distance: [0.0, f64::INFINITY], nearest: strip.order[position] })
}

/// How far the distance D of a sample (x, h) may move when both are rounded to doubles, and these to the decimals that are
/// written (Lemma 8.7): Δh + (max(|h|, |h′|) + D + |r|) Δx / min(x, x′) with x′ = l²/2, where a decimal adds 2⁻⁵³|h′| to |h′ − h| and
/// 2⁻⁵²x′ to |x′ − x|.
pub(super) fn rounding([x, h]: [&RBig; 2], [l, rounded_h]: [f64; 2], distance: f64, norm: f64) -> f64 {
    let decimal = exact(0.5 * f64::EPSILON);
    let (l, other) = (exact(l), exact(rounded_h));
    let rounded_x = &l * &l / RBig::from(2);
    let across = (&other - h).abs() + other.clone().abs() * &decimal;
    let along = (&rounded_x - x).abs() + &rounded_x * decimal * RBig::from(2);
    let energies = h.clone().abs().max(other.abs()) + exact(distance) + exact(norm);
    let moved = across + energies * along / x.clone().min(rounded_x);
    // More than the roundings of |r| and of this number.
    moved.to_f64().value() * (1.0 + 16.0 * f64::EPSILON)
}

/// The double as an exact number.
pub(super) fn exact(x: f64) -> RBig {
    RBig::try_from(x).unwrap_or(RBig::ZERO)
}
