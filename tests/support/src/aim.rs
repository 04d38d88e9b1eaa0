//! Points (h, l) that shrink: anywhere, or planted beside the curves and events of a body.

use bifdiag_body::Number;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_numbers::table::Id;
use dashu_ratio::RBig;
use proptest::prelude::*;

use crate::strata::{ten_to, tiny};

/// Where to aim at in the (h, l) half-plane of a body. The atlas tells only where its curves and events are.
#[derive(Clone, Debug)]
pub struct Aim {
    /// Of √(|r| A_max), for l that is beside no event.
    momentum: RBig,
    /// Number of an event (modulo their number), and at which relative distance from its l.
    event: Option<(usize, RBig)>,
    /// Number of a curve over l, likewise.
    curve: usize,
    /// Relative distance from this curve; `None`: in the middle of the interval above it.
    beside: Option<RBig>,
}

/// Half of the points have l beside an event's, most have h beside a curve's.
pub fn aims() -> impl Strategy<Value = Aim> {
    let momentum = (1..=99_u32, -2..=0_isize).prop_map(|(m, k)| RBig::from(m) * ten_to(k));
    let distance = || (tiny(), any::<bool>()).prop_map(|(x, minus)| if minus { -x } else { x });
    let event = prop::option::of((0..64_usize, distance()));
    let beside = prop::option::weighted(0.75, distance());
    (momentum, event, 0..16_usize, beside).prop_map(|(momentum, event, curve, beside)| Aim {
        momentum,
        event,
        curve,
        beside,
    })
}

impl Aim {
    /// (h, l) in the body's units.
    #[must_use]
    pub fn at(&self, atlas: &Atlas) -> (f64, f64) {
        let arrangement = atlas.arrangement();
        let (set, events) = (&arrangement.set, &arrangement.events);
        let nearest = |x: RBig| x.to_f64().value();
        let l = nearest(match &self.event {
            Some((number, distance)) if !events.is_empty() => {
                let event = &events[Id::at(number % events.len())];
                exact(atlas.momentum(event.x)) * (RBig::ONE + distance)
            }
            _ => {
                let frame = &set.frame;
                let scale = (frame.a[2] * if frame.is_euler() { 1.0 } else { frame.r_norm }).sqrt();
                exact(scale * frame.momentum_unit) * &self.momentum
            }
        });
        let scaled = l / set.frame.momentum_unit;
        let x = 0.5 * scaled * scaled;
        let mut heights: Vec<f64> =
            set.curves_over(x).0.iter().map(|&c| atlas.energy(set.curves[c].point(&set.frame, x).h())).collect();
        heights.sort_by(f64::total_cmp);
        let curve = self.curve % heights.len();
        let scale = exact(atlas.energy(x / set.frame.a[2] + set.frame.r_norm));
        let h = match &self.beside {
            Some(distance) => exact(heights[curve]) + scale * distance,
            None => match heights.get(curve + 1) {
                Some(next) => exact(heights[curve].midpoint(*next)),
                None => exact(heights[curve]) + scale,
            },
        };
        (nearest(h), l)
    }
}

fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("finite")
}

/// A double as a number, exactly; `Number::from_f64` would read its shortest decimal.
///
/// # Panics
/// For NaN and infinities.
#[must_use]
pub fn number(x: f64) -> Number {
    Number::from_rational(exact(x))
}
