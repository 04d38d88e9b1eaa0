//! Guesses of the next member: of order four, from the last two members and their derivatives along the family.

use crate::chain::Chain;
use crate::flow::{Phase, Space};
use crate::shooting::{Direction, Ring, Slopes};

/// The member before another one, seen from the latter: it lies at −distance along the direction there.
#[derive(Clone, Debug)]
pub(super) struct Past {
    ring: Ring,
    slopes: Slopes,
    chain: Chain,
    distance: f64,
}

/// A guess farther ahead than this multiple of the distance to the member before is made without that member.
const AHEAD: f64 = 2.5;

/// What guesses use of a member: its orbit, and the derivative along the family.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub ring: &'a Ring,
    pub direction: &'a Direction,
    pub slopes: &'a Slopes,
    pub chain: &'a Chain,
}

impl Past {
    /// From the member `before`, whose nodes correspond to those here; `None` where the two differ in another
    /// direction.
    ///
    /// A family determines orbits, not the phases of their nodes. The nodes before are moved with the flow by one small
    /// time, after which the first node and its slope lie across the flow at the first node here.
    pub fn new(space: &Space, before: Place<'_>, here: Place<'_>) -> Option<Self> {
        if here.ring.nodes.len() != before.ring.nodes.len() {
            return None;
        }
        let (first, flow) = (&here.ring.nodes[0], space.field(&here.ring.nodes[0]));
        let (old, speed) = (&before.ring.nodes[0], space.field(&before.ring.nodes[0]).dot(&flow));
        let late = (first - old).dot(&flow) / speed;
        let slope = |node: &Phase, slope: &Phase| slope + space.linearised(node) * slope * late;
        let rate = -slope(old, &before.slopes.nodes[0]).dot(&flow) / speed;
        let (ring, slopes, chain) = (before.ring.clone(), before.slopes.clone(), before.chain.clone());
        let mut moved = Self { ring, slopes, chain, distance: 0.0 };
        for (node, along) in moved.ring.nodes.iter_mut().zip(&mut moved.slopes.nodes) {
            let field = space.field(node);
            *along = slope(node, along) + field * rate;
            *node += (field + space.linearised(node) * field * (0.5 * late)) * late;
        }
        let period = here.ring.period;
        let turned = moved.slopes.nodes[0].push(moved.slopes.period / period).dot(here.direction);
        moved.distance = (first - moved.ring.nodes[0]).push(1.0 - moved.ring.period / period).dot(here.direction);
        moved.slopes.nodes.iter_mut().for_each(|along| *along /= turned);
        moved.slopes.period /= turned;
        (turned > 0.5 && moved.distance != 0.0).then_some(moved)
    }

    fn reaches(&self, ahead: f64) -> bool {
        ahead.abs() <= AHEAD * self.distance.abs()
    }
}

/// The chain at a distance from a member: extrapolated from both members, or its own.
pub(super) fn chain(here: &Place<'_>, past: Option<&Past>, ahead: f64) -> Chain {
    match past.filter(|past| past.reaches(ahead)) {
        Some(past) => here.chain.beyond(&past.chain, ahead / past.distance),
        None => here.chain.clone(),
    }
}

/// The guess at a distance from a member: by the cubic through both members with their slopes, or by its own tangent.
pub(super) fn guess(here: &Place<'_>, past: Option<&Past>, ahead: f64) -> Ring {
    let Place { ring, slopes, .. } = here;
    let Some(past) = past.filter(|past| past.reaches(ahead)) else {
        let nodes = ring.nodes.iter().zip(&slopes.nodes).map(|(node, slope)| node + slope * ahead);
        return Ring { nodes: nodes.collect(), period: ring.period + slopes.period * ahead };
    };
    let d = past.distance;
    // x + m s + a s² + b s³ is x₀ at −d, with the slope m₀ there.
    let share = |x: &Phase, m: &Phase, x0: &Phase, m0: &Phase| {
        let (e, f) = ((x0 - x + m * d) / (d * d), (m - m0) / d);
        x + (m + ((e * 3.0 - f) + (e * 2.0 - f) * (ahead / d)) * ahead) * ahead
    };
    let nodes = ring.nodes.iter().zip(&slopes.nodes).zip(past.ring.nodes.iter().zip(&past.slopes.nodes));
    let nodes = nodes.map(|((x, m), (x0, m0))| share(x, m, x0, m0)).collect();
    // The period likewise.
    let one = |x: f64| Phase::repeat(x);
    let period = share(&one(ring.period), &one(slopes.period), &one(past.ring.period), &one(past.slopes.period))[0];
    Ring { nodes, period }
}

#[cfg(test)]
mod tests {
    use bifdiag_body::Body;
    use bifdiag_dynamics::field::HeavyTop;

    use super::super::member::{Member, Setting};
    use super::*;
    use crate::flow::Level;
    use crate::orbit::NODES;

    /// A body without symmetry that swings about its lowest position: the defect of a cubic guess is of the fourth
    /// order in the distance from the known orbit, that of a tangent of the second.
    #[test]
    fn guesses_are_of_order_four() {
        let body = Body::parse(&["3", "2.2", "1.7"], &["0.3", "-0.5", "0.8"]).unwrap();
        let space = Space::new(&HeavyTop::new(&body), -0.9);
        let down = space.top.center().map(|r| r / space.top.center_norm());
        let rest = Phase::new(down[0], down[1], down[2], 0.0, 0.0, 0.0);
        let turn = space.linearised(&rest);
        // The faster of the two oscillations dominates under powers of J².
        let mut direction =
            (0..200).fold(Phase::new(0.1, 0.2, -0.3, 0.2, 0.4, 0.1), |v, _| -(turn * turn * v).normalize());
        direction /= direction.norm();
        let frequency = (turn * direction).norm() / direction.norm();
        let frequency = ((turn * turn * direction).norm() / (turn * direction).norm() * frequency).sqrt();
        let setting = Setting { space: &space, level: Level::Momentum(0.0) };
        let node = |k: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / NODES as f64);
            rest + (direction * cos + turn * direction * (sin / frequency)) * 1e-3
        };
        let ring = Ring { nodes: (0..NODES).map(node).collect(), period: std::f64::consts::TAU / frequency };
        let mut member = setting.close(ring, &direction.push(0.0), None).unwrap();
        for _ in 0..30 {
            member = setting.ahead(&member, 0.01).unwrap();
        }
        let missed = |step: f64| {
            let next = setting.ahead(&setting.ahead(&member, step).unwrap(), step).unwrap();
            let missed = |member: &Member| member.guess(step).shoot(&space, setting.level, None).unwrap().residual;
            let mut alone = next.clone();
            alone.past = None;
            [missed(&next), missed(&alone)]
        };
        let [[long, long_line], [short, short_line]] = [0.02, 0.01].map(missed);
        assert!((10.0..26.0).contains(&(long / short)), "{long:e} {short:e}");
        assert!((3.0..5.0).contains(&(long_line / short_line)), "{long_line:e} {short_line:e}");
        assert!(long < 0.1 * long_line, "{long:e} {long_line:e}");
    }
}
