//! A member while its family is followed.

use crate::flow::{Phase, Space};
use crate::orbit::{About, PeriodicOrbit, spread};
use crate::reversor::Reversor;
use crate::shooting::{Direction, Keep, Ring, ShootingError, Shot};

/// A closed orbit, with the direction in which its family goes on.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub shot: Shot,
    pub direction: Direction,
    pub orbit: PeriodicOrbit,
    /// How near it comes to the places of equilibria.
    pub nearest: Vec<f64>,
    /// Corrections that closed it.
    pub corrections: u32,
    /// The cosine of the angle between its direction and that in which it was looked for.
    pub straight: f64,
}

/// What a member is closed and described with.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub space: &'a Space,
    pub held: Keep,
    pub reversors: &'a [Reversor],
    pub places: &'a [Phase],
}

/// Nodes may move so much more slowly than the fastest one before the ring is begun there.
const SLOW: f64 = 0.3;
/// More stretching than this from node to node costs digits.
const STRETCH: f64 = 100.0;

impl Setting<'_> {
    /// Closes a guess that was made along a direction.
    pub fn close(&self, guess: Ring, before: &Direction) -> Result<Member, ShootingError> {
        let mut shot = guess.close(self.space, [self.held, Keep::Place(*before)])?;
        let corrections = shot.corrections;
        if shot.stretch() > STRETCH {
            shot = spread(self.space, &shot.ring)?.shoot(self.space)?;
        }
        let mut direction = shot.direction(self.space, self.held, before).ok_or(ShootingError::Singular)?;
        let straight = direction.dot(before) / before.norm();
        let about = About { space: self.space, reversors: self.reversors, places: self.places };
        let (orbit, nearest) = about.describe(&shot)?;
        let speed = |k: usize| shot.frames[k].speed;
        let fastest = (0..shot.frames.len()).max_by(|&i, &j| speed(i).total_cmp(&speed(j))).unwrap_or(0);
        if speed(0) < SLOW * speed(fastest) {
            (shot, direction) = shot.turned(self.space, fastest, &direction);
        }
        Ok(Member { shot, direction, orbit, nearest, corrections, straight })
    }

    /// The member at a distance from another one.
    pub fn ahead(&self, member: &Member, distance: f64) -> Result<Member, ShootingError> {
        self.close(member.shot.ahead(self.space, &member.direction, distance), &member.direction)
    }
}

impl Member {
    /// The size of the orbit, from its speed: the radius if it were a circle run through evenly.
    pub fn size(&self) -> f64 {
        self.shot.frames[0].speed * self.shot.ring.period / std::f64::consts::TAU
    }

    /// How far it is from having half its period. (The number of nodes is even.)
    pub fn distance_from_half(&self) -> f64 {
        let nodes = &self.shot.ring.nodes;
        (nodes[nodes.len() / 2] - nodes[0]).norm()
    }

    /// How fast what is not held changes along the family.
    pub fn rate(&self, space: &Space, held: Keep) -> f64 {
        let [_, of_l, of_h] = space.gradients(&self.shot.ring.nodes[0]);
        let gradient = if matches!(held, Keep::Energy(_)) { of_l } else { of_h };
        gradient.dot(&self.direction.fixed_rows::<6>(0))
    }
}
