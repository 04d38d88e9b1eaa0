//! The rotation number of an orbit's crossings.

use thiserror::Error;

use super::averages::weighted_mean;
use super::curve::rotation_along_curve;
use super::curve::{centred, principal_coordinates};
use crate::section::orbit::SectionPoint;

/// Fewest returns from which a rotation number is computed.
pub(super) const FEWEST_RETURNS: usize = 24;
/// Longest chain of islands that is looked for.
const MOST_ISLANDS: usize = 64;
/// Fewest points of each island.
const POINTS_PER_ISLAND: usize = 6;

/// The rotation number of an orbit's return map to the incoming half Ṡ < 0 of the section.
///
/// A regular orbit fills a closed curve there, on which the return map acts as a circle map. Its rotation number is a
/// topological invariant: any angle along the curve gives the same up to whole turns and the sense of turning. It is
/// therefore given in turns per return, in [0, 1/2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotationNumber {
    /// Turns per return, in [0, 1/2].
    pub number: f64,
    /// |number from the first half of the returns − number from the second half|; 0 for a chain of islands.
    pub error: f64,
    /// The angle that was averaged.
    pub angle: RotationAngle,
    /// Number of returns.
    pub returns: usize,
}

/// Which angle turns, and about which centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotationAngle {
    /// ψ': the crossings encircle the axis r̂.
    Axis,
    /// The angle about the mean of the crossings, in the plane of the two largest principal axes of their (γ, l).
    Mean,
    /// Neither of them runs round a circle, but the crossings follow a closed curve of some shape: its own parameter.
    Curve,
    /// There is no such curve, but the crossings visit this many places in the same cyclic order for ever: a chain of
    /// islands or a periodic orbit. The rotation number is that of the chain, p over this number,
    /// exactly.
    Islands(usize),
}

/// Why an orbit has no rotation number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RotationUndefined {
    /// The orbit is too short.
    #[error("{returns} returns are too few, {FEWEST_RETURNS} are needed")]
    TooFewReturns {
        /// Returns to the incoming half.
        returns: usize,
    },
    /// The return map does not keep the cyclic order of the crossings: they lie on several curves that are not
    /// visited in turn, or on no curve (chaos).
    #[error("the crossings do not follow a closed curve in order")]
    NoCircle,
    /// The work was stopped before.
    #[error("interrupted")]
    Interrupted,
}

/// The rotation number of an orbit from its crossings in the order of time.
///
/// # Errors
/// [`RotationUndefined`] says why it is undefined.
pub fn rotation_number(points: &[SectionPoint]) -> Result<RotationNumber, RotationUndefined> {
    let incoming: Vec<&SectionPoint> = points.iter().filter(|point| point.s_dot < 0.0).collect();
    let returns = incoming.len().saturating_sub(1);
    if returns < FEWEST_RETURNS {
        return Err(RotationUndefined::TooFewReturns { returns });
    }
    let axis: Vec<f64> = incoming.iter().map(|point| point.psi / std::f64::consts::TAU).collect();
    let cloud = centred(&incoming);
    let mean: Vec<f64> = principal_coordinates(&cloud).into_iter().map(turns).collect();
    let candidates = [(RotationAngle::Axis, axis), (RotationAngle::Mean, mean)];
    for (angle, turns) in &candidates {
        if keeps_cyclic_order(turns) {
            let advances: Vec<f64> = turns.windows(2).map(|pair| advance(pair[0], pair[1])).collect();
            let (first, second) = advances.split_at(returns / 2);
            let error = (weighted_mean(first) - weighted_mean(second)).abs();
            return Ok(RotationNumber { number: folded(weighted_mean(&advances)), error, angle: *angle, returns });
        }
    }
    if let Some((number, error)) = rotation_along_curve(&cloud) {
        return Ok(RotationNumber { number: folded(number), error, angle: RotationAngle::Curve, returns });
    }
    let chain = candidates.iter().find_map(|(_, turns)| island_chain(turns));
    let (steps, islands) = chain.ok_or(RotationUndefined::NoCircle)?;
    let (number, angle) = (folded(steps as f64 / islands as f64), RotationAngle::Islands(islands));
    Ok(RotationNumber { number, error: 0.0, angle, returns })
}

/// The angle of (x, y) in turns.
fn turns([x, y]: [f64; 2]) -> f64 {
    libm::atan2(y, x) / std::f64::consts::TAU
}

/// From one angle on to the next, in [0, 1) turns. An order-preserving circle map without fixed points never
/// advances by a whole turn, so that this branch is a continuous one.
fn advance(from: f64, to: f64) -> f64 {
    let difference = to - from;
    let advance = difference - difference.floor();
    if advance < 1.0 { advance } else { 0.0 }
}

/// Without the sense of turning.
fn folded(number: f64) -> f64 {
    number.min(1.0 - number)
}

/// True if the images of the angles (the following angles) are in the same cyclic order as the angles themselves.
fn keeps_cyclic_order(turns: &[f64]) -> bool {
    let count = turns.len() - 1;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&i, &j| turns[i].total_cmp(&turns[j]));
    let image = |i: usize| turns[order[i % count] + 1];
    (0..count).filter(|&i| image(i) >= image(i + 1)).count() == 1
}

/// (p, k) if the angles fall into k > 1 disjoint arcs, point n in the arc n mod k, and each arc is p places on from the
/// one before. The least such k is taken.
fn island_chain(turns: &[f64]) -> Option<(usize, usize)> {
    (2..=MOST_ISLANDS.min(turns.len() / POINTS_PER_ISLAND)).find_map(|k| {
        // Arcs as (low, high) with low in [0, 1).
        let arcs: Vec<(f64, f64)> = (0..k)
            .map(|island| {
                let origin = turns[island];
                let (mut low, mut high) = (0.0_f64, 0.0_f64);
                for angle in turns.iter().skip(island).step_by(k) {
                    let offset = advance(origin - 0.5, *angle) - 0.5;
                    (low, high) = (low.min(offset), high.max(offset));
                }
                let begin = advance(0.0, origin + low);
                (begin, begin + (high - low))
            })
            .collect();
        let mut order: Vec<usize> = (0..k).collect();
        order.sort_by(|&i, &j| arcs[i].0.total_cmp(&arcs[j].0));
        let disjoint = (0..k).all(|i| {
            let (this, next) = (arcs[order[i]], arcs[order[(i + 1) % k]]);
            this.1 < if i + 1 < k { next.0 } else { next.0 + 1.0 }
        });
        let mut place = vec![0; k];
        for (position, &island) in order.iter().enumerate() {
            place[island] = position;
        }
        let steps = (place[1] + k - place[0]) % k;
        let cyclic = (0..k).all(|island| (place[(island + 1) % k] + k - place[island]) % k == steps);
        (disjoint && cyclic).then_some((steps, k))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Angles of a circle map conjugate to the rotation by ρ.
    fn distorted(rho: f64, count: u32) -> Vec<f64> {
        (0..count)
            .map(|n| {
                let x = rho * f64::from(n);
                advance(0.0, x + 0.12 * libm::sin(std::f64::consts::TAU * x))
            })
            .collect()
    }

    #[test]
    fn a_circle_map_keeps_its_order_and_its_number() {
        for rho in [0.018_4, 0.381_966_011_25, 0.710_678_118, 0.973_1] {
            let turns = distorted(rho, 500);
            assert!(keeps_cyclic_order(&turns), "{rho}");
            let advances: Vec<f64> = turns.windows(2).map(|pair| advance(pair[0], pair[1])).collect();
            // At ρ = 0.0184 these are nine turns only.
            assert!((weighted_mean(&advances) - rho).abs() < 1e-6, "{rho} {}", weighted_mean(&advances));
        }
    }

    #[test]
    fn angles_seen_from_outside_do_not_keep_their_order() {
        let swinging: Vec<f64> = (0..500).map(|n| 0.3 + 0.2 * libm::sin(2.4 * f64::from(n))).collect();
        assert!(!keeps_cyclic_order(&swinging));
        assert_eq!(island_chain(&swinging), None);
    }

    #[test]
    fn a_chain_of_islands_is_counted() {
        // Five islands, two places on each time, each a curve seen from the side.
        let chain: Vec<f64> =
            (0..300).map(|n| advance(0.0, 0.4 * f64::from(n) + 0.9 + 0.05 * libm::sin(0.77 * f64::from(n)))).collect();
        assert!(!keeps_cyclic_order(&chain));
        assert_eq!(island_chain(&chain), Some((2, 5)));
    }
}
