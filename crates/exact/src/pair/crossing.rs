//! The box of a crossing.

use dashu_ratio::RBig;

use super::node::{Node, POINTS};
use crate::evaluator::Evaluator;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

/// The relative width of a box, if events lie nearer need not be separated.
const WIDTH: f64 = 1e-24;
/// How often a box is made smaller; it is halved in three steps at least.
const STEPS: usize = 240;

impl<E: Enclosure> Evaluator<'_, E> {
    /// A small box around the one crossing between two nodes.
    pub(super) fn crossing(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>, sign: Sign) -> Option<[RBig; 2]> {
        self.boxed(curves, [from.x.upper(), to.x.lower()], [&from.gap, &to.gap], sign, WIDTH)
    }

    /// A box of the crossing inside another one, at whose ends the gap has these signs: as small as these bits make it.
    pub fn narrowed(&self, curves: [CurveId; 2], x: &[RBig; 2]) -> Option<[RBig; 2]> {
        self.allow(POINTS);
        let ends = x.each_ref().map(|x| E::rational(x, self.c.precision));
        let nodes = [self.node(curves, &ends[0])?, self.node(curves, &ends[1])?];
        let [Some(p), Some(q)] = nodes.each_ref().map(|node| node.sign) else { return None };
        let found =
            (p * q == Sign::Negative).then(|| self.boxed(curves, ends, [&nodes[0].gap, &nodes[1].gap], p, 0.0))??;
        (found[0] >= x[0] && found[1] <= x[1]).then_some(found)
    }

    /// A box of at most this relative width, if these bits permit.
    fn boxed(
        &self,
        curves: [CurveId; 2],
        [mut low, mut high]: [E; 2],
        gaps: [&E; 2],
        sign: Sign,
        width: f64,
    ) -> Option<[RBig; 2]> {
        let value = |gap: &E| {
            let [lo, hi] = gap.bounds();
            0.5 * (lo + hi)
        };
        let mut at = gaps.map(value);
        let ends = [low.clone(), high.clone()];
        let size = |low: &E, high: &E| (high.clone() - low.clone()).bounds()[1];
        let (mut moved, mut last, mut room, mut stalled) = ([false; 2], None, size(&low, &high), 0);
        let close = E::double(width.max(4.0 * E::resolution(self.c.precision)), self.c.precision);
        // Illinois' variant of the secant rule: where one end moves twice, the gap at the other is damped.
        for _ in 0..STEPS {
            // A curve cannot be evaluated again at its end: both ends of the box lie inside.
            if moved == [true; 2] && (high.clone() - low.clone()).is_below(&(high.clone() * close.clone())) {
                break;
            }
            let secant = self.secant([&low, &high], at).filter(|_| stalled < 2);
            let x = secant.unwrap_or_else(|| self.halfway([&low, &high], &ends, at));
            let node = self.node(curves, &x)?;
            let end = match node.sign {
                Some(s) if s == sign => 0,
                Some(s) if s == -sign => 1,
                _ => {
                    if let Some(ends) = self.around(curves, &x, [&low, &high], sign) {
                        [low, high] = ends;
                    }
                    break;
                }
            };
            at[end] = value(&node.gap);
            moved[end] = true;
            if last.replace(end) == Some(end) {
                at[1 - end] *= 0.5;
            }
            if end == 0 {
                low = x;
            } else {
                high = x;
            }
            let now = size(&low, &high);
            if 2.0 * now <= room {
                (room, stalled) = (now, 0);
            } else {
                stalled += 1;
            }
        }
        let [at, _] = low.exact_bounds()?;
        let [_, end] = high.exact_bounds()?;
        Some([at, end])
    }

    /// Where the secant through the gaps at both ends vanishes; beside an end twice as far from it, so that it becomes the
    /// other end.
    fn secant(&self, [low, high]: [&E; 2], [p, q]: [f64; 2]) -> Option<E> {
        const BESIDE: f64 = 0.0625;
        let width = |share: f64| (high.clone() - low.clone()) * E::double(share, self.c.precision);
        let [from_low, from_high] = [p / (p - q), q / (q - p)];
        let place = if from_low < BESIDE {
            low.clone() + width(2.0 * from_low)
        } else if from_high < BESIDE {
            high.clone() - width(2.0 * from_high)
        } else {
            low.clone() + width(from_low)
        };
        Some(place.middle()).filter(|x| low.is_below(x) && x.is_below(high))
    }

    /// The middle of a box; of the exponents of the distances from that end of the stretch on whose side the gap is smaller, if
    /// they are far apart: as (x − end)^(3/2) beside a cusp, a gap may all but vanish along most of the box.
    fn halfway(&self, [low, high]: [&E; 2], ends: &[E; 2], at: [f64; 2]) -> E {
        const APART: f64 = 16.0;
        let side = usize::from(at[1].abs() < at[0].abs());
        let reach = [low, high]
            .map(|x| (x.clone() - ends[side].clone()).bounds().map(f64::abs).into_iter().fold(0.0, f64::max));
        let [near, far] = [reach[side], reach[1 - side]];
        if near > 0.0 && far > APART * near {
            let step = E::double(near.sqrt() * far.sqrt(), self.c.precision);
            let x = if side == 0 { ends[0].clone() + step } else { ends[1].clone() - step }.middle();
            if low.is_below(&x) && x.is_below(high) {
                return x;
            }
        }
        low.hull(high).middle()
    }

    /// The sign is hidden at x: sure signs close by, on both sides.
    fn around(&self, curves: [CurveId; 2], x: &E, [low, high]: [&E; 2], sign: Sign) -> Option<[E; 2]> {
        let precision = self.c.precision;
        let sure = |at: &E, wanted: Sign| self.node(curves, at).is_some_and(|node| node.sign == Some(wanted));
        let mut reach = E::resolution(precision);
        for _ in 0..60 {
            let step = x.clone() * E::double(reach, precision);
            let (down, up) = ((x.clone() - step.clone()).lower(), (x.clone() + step).upper());
            let below = if low.is_below(&down) { sure(&down, sign).then_some(down) } else { Some(low.clone()) };
            let above = if up.is_below(high) { sure(&up, -sign).then_some(up) } else { Some(high.clone()) };
            if let (Some(below), Some(above)) = (below, above) {
                return Some([below, above]);
            }
            reach *= 2.0;
        }
        None
    }
}
