//! How far from a point on curves no other curve comes near it: to the next cusp or pitchfork, and by the bounds of slopes.

use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::wide::Wide;
use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::critical_values::{CriticalValues, refined};
use crate::curves::{IsolationError, Place, roots_in_interval};
use crate::family::State;
use crate::model::{Constants, Model};
use crate::plane::{Open, Plane};

/// Bits in which a cusp is separated from the x of the point; before the third it is asked whether they are equal.
const STAGES: [usize; 6] = [64, 160, 400, 1000, 2500, 6000];

/// Bits of the rounding of a tensor's moments: what is nearer than that is not separated.
const ROUNDING: usize = 400;

/// No cusp or pitchfork has its x at less than this distance from that of the point, but at the point's x itself; and over
/// this distance no height moves by more than `room`, as slopes are at most 1/a₁ (Proposition 3.6).
pub(crate) fn reach(plane: &Plane<'_>, heights: &CriticalValues<'_>, room: &RBig) -> Result<RBig, Open> {
    let (model, x) = (plane.model, &heights.x);
    let mut reach = (room * model.a(0)).min(x.clone());
    if model.active.is_empty() {
        return Ok(reach);
    }
    for &group in &model.passive {
        for square in squares_over(plane, group) {
            if let Some(distance) = distance_of_square(x, &square) {
                if model.rounded && &distance * RBig::from(IBig::ONE << ROUNDING) < *x {
                    return Err(Open::Beside);
                }
                reach = reach.min(distance);
            }
        }
    }
    for place in cusps(model, &model.known_cusp_polynomial())? {
        if let Some(distance) = distance_of_cusp(plane, heights, place)? {
            reach = reach.min(distance);
        }
    }
    Ok(reach)
}

/// The places of the generic family at which a polynomial in μ is 0.
fn cusps(model: &Model, polynomial: &Polynomial) -> Result<Vec<Place>, Open> {
    let mut found = Vec::new();
    for number in 0..=model.active.len() {
        let roots = roots_in_interval(model, polynomial, number, STAGES[0]).map_err(|IsolationError| Open::Cusps)?;
        found.extend(roots.into_iter().map(|(place, _)| place));
    }
    Ok(found)
}

/// x² = vJ⁴/4 of the pitchfork over a group without r, v = P̂, and of its cusp, v = −3R̂/a (Proposition 3.7).
fn squares_over(plane: &Plane<'_>, group: usize) -> Vec<RBig> {
    let (r_sum, p_sum) = plane.model.known_sums(group);
    let a = plane.model.a(group);
    let turn = &r_sum * RBig::from(-3) / a;
    let cusp = (turn > p_sum).then_some(turn);
    let square = |v: RBig| {
        let j = a - &r_sum / &v;
        let j2 = &j * &j;
        v * &j2 * j2 / RBig::from(4)
    };
    [Some(p_sum), cusp].into_iter().flatten().map(square).collect()
}

/// A lower bound of the distance from x > 0 to the root of a square, or x; `None` when it is 0.
fn distance_of_square(x: &RBig, square: &RBig) -> Option<RBig> {
    let own = x * x;
    if *square == own {
        return None;
    }
    let difference = if *square < own { &own - square } else { square - &own };
    // Up to 2x the sum of both is at most 3x.
    Some((difference / (x * RBig::from(3))).min(x.clone()))
}

/// A lower bound of the distance from x to that of a cusp of the generic family; `None` when it is 0.
fn distance_of_cusp(plane: &Plane<'_>, heights: &CriticalValues<'_>, mut place: Place) -> Result<Option<RBig>, Open> {
    let (model, x) = (plane.model, &heights.x);
    for (stage, bits) in STAGES.into_iter().enumerate() {
        if model.rounded && bits > ROUNDING {
            break;
        }
        if stage == 2 && heights.stands_over(&place) {
            return Ok(None);
        }
        place = refined(&place, bits);
        let c = Constants::<Wide>::new(model, bits);
        let [lo, hi] = [&place.lo, &place.hi].map(|y| Wide::rational(y, bits));
        let Some([lo, hi]) = State::x_at(model, &c, place.half, &lo.hull(&hi)).exact_bounds() else { continue };
        if *x < lo {
            return Ok(Some(lo - x));
        }
        if hi < *x {
            return Ok(Some(x - hi));
        }
    }
    Err(Open::Beside)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;
    use bifdiag_numbers::polynomial::rational;

    /// (μ − a₁ − 1/3)² − 4^−bits.
    fn close_pair(model: &Model, bits: usize) -> Polynomial {
        let centre = model.a(0) + RBig::from_parts(1.into(), 3u8.into());
        let factor = [-centre, RBig::ONE];
        let gap = RBig::ONE / RBig::from(IBig::ONE << (2 * bits));
        Polynomial::from_rationals(&rational::sub(&rational::mul(&factor, &factor), &[gap]))
    }

    #[test]
    fn cusps_that_cannot_be_isolated_are_refused() {
        let body = Body::parse(&["1", "2", "5/2"], &["1/3", "1/2", "1"]).unwrap();
        let model = Model::new(&body, &body.frame());
        assert_eq!(cusps(&model, &close_pair(&model, 1000)).map(|found| found.len()), Ok(2));
        let refused = cusps(&model, &close_pair(&model, 4500)).map(|found| found.len());
        assert_eq!(refused, Err(Open::Cusps));
        assert!(Open::Cusps.to_string().contains("4(q'D - 2qD')p - 3(p'D - 2pD')q"));
    }
}
