//! The box of a crossing.

use dashu_ratio::RBig;

use super::node::Node;
use super::proof::POINTS;
use crate::point::Evaluator;
use numbers::Sign;
use numbers::enclosure::Enclosure;
use top::curves::CurveId;

impl<E: Enclosure> Evaluator<'_, E> {
    /// A small box around the one crossing between two nodes.
    pub(super) fn crossing(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>, sign: Sign) -> Option<[RBig; 2]> {
        self.boxed(curves, [from.x.upper(), to.x.lower()], [&from.gap, &to.gap], sign)
    }

    /// A box of the crossing inside another one, at whose ends the gap has these signs: as small as these bits make it.
    pub fn narrowed(&self, curves: [CurveId; 2], x: &[RBig; 2]) -> Option<[RBig; 2]> {
        self.allow(POINTS);
        let ends = x.each_ref().map(|x| E::rational(x, self.c.precision));
        let nodes = [self.node(curves, &ends[0])?, self.node(curves, &ends[1])?];
        let [Some(p), Some(q)] = nodes.each_ref().map(|node| node.sign) else { return None };
        let found =
            (p * q == Sign::Negative).then(|| self.boxed(curves, ends, [&nodes[0].gap, &nodes[1].gap], p))??;
        (found[0] >= x[0] && found[1] <= x[1]).then_some(found)
    }

    fn boxed(&self, curves: [CurveId; 2], [mut low, mut high]: [E; 2], gaps: [&E; 2], sign: Sign) -> Option<[RBig; 2]> {
        let value = |gap: &E| {
            let [lo, hi] = gap.bounds();
            0.5 * (lo + hi)
        };
        let [mut at_low, mut at_high] = gaps.map(value);
        let close = self.c.small(4) * E::double(E::resolution(self.c.precision), self.c.precision);
        // Illinois' variant of the secant rule: the sign of an end that stays is damped.
        for _ in 0..80 {
            if (high.clone() - low.clone()).is_below(&(high.clone() * close.clone())) {
                break;
            }
            let secant = at_low / (at_low - at_high);
            let share = if secant > 1e-12 && secant < 1.0 { secant } else { 0.5 };
            let between = (low.clone() + (high.clone() - low.clone()) * E::double(share, self.c.precision)).middle();
            let inside = low.is_below(&between) && between.is_below(&high);
            let x = if inside { between } else { low.hull(&high).middle() };
            let node = self.node(curves, &x)?;
            match node.sign {
                Some(s) if s == sign => {
                    low = x;
                    at_low = value(&node.gap);
                    at_high *= 0.5;
                }
                Some(s) if s == -sign => {
                    high = x;
                    at_high = value(&node.gap);
                    at_low *= 0.5;
                }
                _ => {
                    let around = self.around(curves, &x, [&low, &high], sign);
                    if let Some(ends) = around {
                        [low, high] = ends;
                    }
                    break;
                }
            }
        }
        let [at, _] = low.exact_bounds()?;
        let [_, end] = high.exact_bounds()?;
        Some([at, end])
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
