//! A member of a family that is being followed.

use bifdiag_dynamics::field::dot;

use super::guess::{Past, Place, chain, guess};
use crate::flow::{Level, Space};
use crate::orbit::spread;
use crate::shooting::{Direction, Expected, Keep, Ring, ShootingError, Shot, Slopes};

/// A closed orbit, with the direction in which its family continues.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub shot: Shot,
    pub direction: Direction,
    /// The derivatives of its nodes in this direction.
    slopes: Slopes,
    /// The member before, if its nodes correspond to these.
    pub(super) past: Option<Past>,
    /// Its nodes are the corrected ones of the guess.
    same_nodes: bool,
    /// The sum of its multipliers.
    pub trace: f64,
    /// The cosine of the angle between its direction and that of the guess.
    pub straight: f64,
}

/// The space and the level on which members are closed.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub space: &'a Space,
    pub level: Level,
}

/// If the first node moves more slowly than this share of the fastest one, the ring is rotated to start there.
const SLOW: f64 = 0.3;

impl Setting<'_> {
    /// Closes a guess made along a direction.
    pub fn close(
        &self,
        guess: Ring,
        before: &Direction,
        expected: Option<Expected<'_>>,
    ) -> Result<Member, ShootingError> {
        let closed = guess.close(self.space, self.level, Keep::Place(*before), expected)?;
        let (count, missed) = (closed.ring.nodes.len(), closed.missed);
        let mut shot = spread(self.space, closed)?;
        shot.missed = missed;
        let mut same_nodes = shot.ring.nodes.len() == count;
        let mut direction = shot.direction(before).ok_or(ShootingError::Singular)?;
        let straight = direction.dot(before) / before.norm();
        let speed = |k: usize| shot.frames[k].speed;
        let fastest = (0..shot.frames.len()).max_by(|&i, &j| speed(i).total_cmp(&speed(j))).unwrap_or(0);
        if speed(0) < SLOW * speed(fastest) {
            same_nodes = false;
            (shot, direction) = shot.turned(fastest, &direction);
        }
        let slopes = shot.slopes(&direction);
        let trace = shot.reduced().trace();
        Ok(Member { shot, direction, slopes, past: None, same_nodes, trace, straight })
    }

    /// The member at a distance from another.
    pub fn ahead(&self, member: &Member, distance: f64) -> Result<Member, ShootingError> {
        let place = member.place();
        let chain = chain(&place, member.past.as_ref(), distance);
        let expected = Expected { frames: &member.shot.frames, chain };
        let mut found = self.close(member.guess(distance), &member.direction, Some(expected))?;
        if found.same_nodes {
            found.past = Past::new(self.space, place, found.place());
        }
        Ok(found)
    }
}

impl Member {
    fn place(&self) -> Place<'_> {
        Place { ring: &self.shot.ring, direction: &self.direction, slopes: &self.slopes, chain: self.shot.chain() }
    }

    /// The orbit at a distance, before it is closed.
    pub fn guess(&self, distance: f64) -> Ring {
        guess(&self.place(), self.past.as_ref(), distance)
    }

    /// The size of the orbit: the radius of the circle with its period and the speed of its first node.
    pub fn size(&self) -> f64 {
        self.shot.frames[0].speed * self.shot.ring.period / std::f64::consts::TAU
    }

    /// How far it is from repeating after half its period. (The number of nodes is even.)
    pub fn distance_from_half(&self) -> f64 {
        let nodes = &self.shot.ring.nodes;
        (nodes[nodes.len() / 2] - nodes[0]).norm()
    }

    /// The same for its farthest nodes; of a small ellipse around an equilibrium about twice its size.
    pub fn largest_distance_from_half(&self) -> f64 {
        let (first, second) = self.shot.ring.nodes.split_at(self.shot.ring.nodes.len() / 2);
        first.iter().zip(second).map(|(p, q)| (q - p).norm()).fold(0.0, f64::max)
    }

    /// How far it is from repeating after a third of its period. (Rings at a tripling have a multiple of three nodes.)
    pub fn distance_from_third(&self) -> f64 {
        let nodes = &self.shot.ring.nodes;
        (nodes[nodes.len() / 3] - nodes[0]).norm()
    }

    /// Whether an orbit of half the period, or an equilibrium, lies between it and the member before, whose nodes
    /// correspond: two nodes half a period apart have then changed places.
    pub fn is_beyond_an_end(&self, before: &Self) -> bool {
        let apart = |member: &Self| {
            let nodes = &member.shot.ring.nodes;
            nodes[nodes.len() / 2] - nodes[0]
        };
        self.past.is_some() && apart(self).dot(&apart(before)) < 0.0
    }

    /// The integral that is not held.
    pub fn parameter(&self, space: &Space, level: Level) -> f64 {
        let state = space.state(&self.shot.ring.nodes[0]);
        if matches!(level, Level::Energy(_)) { dot(state.gamma, state.l) } else { space.top.energy(&state) }
    }

    /// Its derivative along the family.
    pub fn rate(&self, space: &Space, level: Level) -> f64 {
        let [_, of_l, of_h] = space.gradients(&self.shot.ring.nodes[0]);
        let gradient = if matches!(level, Level::Energy(_)) { of_l } else { of_h };
        gradient.dot(&self.direction.fixed_rows::<6>(0))
    }
}
