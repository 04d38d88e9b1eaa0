//! A member while its family is followed.

use bifdiag_dynamics::field::dot;

use super::guess::{Past, Place, chain, guess};
use crate::flow::{Level, Space};
use crate::orbit::spread;
use crate::shooting::{Direction, Expected, Keep, Ring, ShootingError, Shot, Slopes};

/// A closed orbit, with the direction in which its family goes on.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub shot: Shot,
    pub direction: Direction,
    /// How its nodes change in this direction.
    slopes: Slopes,
    /// The member before, if it has the same nodes.
    pub(super) past: Option<Past>,
    /// Its nodes are those of the guess, corrected.
    same_nodes: bool,
    /// The sum of its multipliers.
    pub trace: f64,
    /// The cosine of the angle between its direction and that in which it was looked for.
    pub straight: f64,
}

/// What a member is closed with.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub space: &'a Space,
    pub level: Level,
}

/// Nodes may move so much more slowly than the fastest one before the ring is begun there.
const SLOW: f64 = 0.3;

impl Setting<'_> {
    /// Closes a guess that was made along a direction.
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

    /// The member at a distance from another one.
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

    /// The size of the orbit, from its speed: the radius if it were a circle run through evenly.
    pub fn size(&self) -> f64 {
        self.shot.frames[0].speed * self.shot.ring.period / std::f64::consts::TAU
    }

    /// How far it is from having half its period. (The number of nodes is even.)
    pub fn distance_from_half(&self) -> f64 {
        let nodes = &self.shot.ring.nodes;
        (nodes[nodes.len() / 2] - nodes[0]).norm()
    }

    /// How far it is from having a third of its period. (At a tripling it is begun with a multiple of three nodes.)
    pub fn distance_from_third(&self) -> f64 {
        let nodes = &self.shot.ring.nodes;
        (nodes[nodes.len() / 3] - nodes[0]).norm()
    }

    /// Between it and the member before, with the same nodes, lies an orbit of half the period, or an equilibrium: the two nodes
    /// that are half a period apart have changed places.
    pub fn is_beyond_an_end(&self, before: &Self) -> bool {
        let apart = |member: &Self| {
            let nodes = &member.shot.ring.nodes;
            nodes[nodes.len() / 2] - nodes[0]
        };
        self.past.is_some() && apart(self).dot(&apart(before)) < 0.0
    }

    /// What is not held.
    pub fn parameter(&self, space: &Space, level: Level) -> f64 {
        let state = space.state(&self.shot.ring.nodes[0]);
        if matches!(level, Level::Energy(_)) { dot(state.gamma, state.l) } else { space.top.energy(&state) }
    }

    /// How fast it changes along the family.
    pub fn rate(&self, space: &Space, level: Level) -> f64 {
        let [_, of_l, of_h] = space.gradients(&self.shot.ring.nodes[0]);
        let gradient = if matches!(level, Level::Energy(_)) { of_l } else { of_h };
        gradient.dot(&self.direction.fixed_rows::<6>(0))
    }
}
