//! The sweep itself: circles and slabs from both poles to a common circle.

use super::angle::Trig;
use super::circle::{CUTS, Circle};
use super::error::{Effort, Obstacle, SweepError};
use super::level::Level;
use super::slab::{self, Brick, Gluing, Hemisphere, Kind};
use crate::topology::component::{Component, Poles, sort_components};

/// tan(ϑ/2) of the circle where both hemispheres meet, exact with its reciprocal; the next is tried when ∂U_hl is
/// tangent to the first.
const SEAMS: [f64; 5] = [0.5, 2.0, 0.25, 4.0, 1.0];
/// Thinnings of a slab before a singularity is assumed.
const DEPTH: u32 = 120;

struct Sweep<'a> {
    level: &'a Level,
    gluing: Gluing,
    euler: i64,
    effort: Effort,
}

/// Components of U_hl for l ≠ 0.
pub(super) fn components(level: &Level, euler_body: bool) -> Result<Vec<Component>, SweepError> {
    let mut sweep = Sweep { level, gluing: Gluing::default(), euler: 0, effort: Effort::new() };
    let plus = sweep.pole(Hemisphere::Plus)?;
    let minus = sweep.pole(Hemisphere::Minus)?;
    let (t, seam) = SEAMS
        .iter()
        .find_map(|&t| sweep.circle(Trig::at(t)).map(|circle| (t, circle)))
        .ok_or_else(|| sweep.undecided(0.0, Obstacle::Singularity))?;
    let bricks = slab::open_bricks();
    sweep.slab(Hemisphere::Plus, (0.0, t), (&plus, &seam), &bricks, DEPTH)?;
    sweep.slab(Hemisphere::Minus, (0.0, t.recip()), (&minus, &seam), &bricks, DEPTH)?;
    sweep.assemble([&plus, &minus], euler_body)
}

impl Sweep<'_> {
    fn undecided(&self, cosine: f64, obstacle: Obstacle) -> SweepError {
        SweepError::Undecided { cosine, obstacle, effort: self.effort.spent() }
    }

    fn register(&mut self, circle: &Circle) {
        for accessible in circle.arcs() {
            self.gluing.add(accessible);
        }
        for (arc, gap) in circle.neighbours() {
            self.gluing.border(arc, gap);
        }
    }

    fn pole(&mut self, hemisphere: Hemisphere) -> Result<Circle, SweepError> {
        let theta = hemisphere.at(0.0);
        let pole = Circle::pole(self.level, theta, self.gluing.len())
            .ok_or_else(|| self.undecided(theta.cos.lo, Obstacle::Pole))?;
        self.register(&pole);
        self.euler += i64::from(pole.marks[0].accessible);
        Ok(pole)
    }

    fn circle(&mut self, theta: Trig) -> Option<Circle> {
        let circle = Circle::new(self.level, theta, self.gluing.len(), &mut self.effort)?;
        self.register(&circle);
        if circle.arc_count > 1 {
            self.euler -= circle.arcs().map(i64::from).sum::<i64>();
        }
        Some(circle)
    }

    /// Works through the slab t0 ≤ t ≤ t1, `near` being the circle at t0.
    fn slab(
        &mut self,
        hemisphere: Hemisphere,
        (t0, t1): (f64, f64),
        (near, far): (&Circle, &Circle),
        bricks: &[Brick],
        depth: u32,
    ) -> Result<(), SweepError> {
        let stuck = |sweep: &Self| sweep.undecided(hemisphere.at(t0).cos.lo, Obstacle::Singularity);
        let bricks =
            slab::settle(self.level, hemisphere, (t0, t1), bricks, &mut self.effort).ok_or_else(|| stuck(self))?;
        if bricks.iter().all(|brick| brick.kind != Kind::Open) {
            let euler = slab::glue(self.level, near, far, &bricks, &mut self.gluing).ok_or_else(|| stuck(self))?;
            self.euler += euler;
            return Ok(());
        }
        let depth = depth.checked_sub(1).ok_or_else(|| stuck(self))?;
        let (t, cut) = CUTS
            .iter()
            .map(|fraction| t0 + fraction * (t1 - t0))
            .filter(|&t| t0 < t && t < t1)
            .find_map(|t| self.circle(hemisphere.at(t)).map(|circle| (t, circle)))
            .ok_or_else(|| stuck(self))?;
        self.slab(hemisphere, (t0, t), (near, &cut), &bricks, depth)?;
        self.slab(hemisphere, (t, t1), (&cut, far), &bricks, depth)
    }

    fn assemble(mut self, [plus, minus]: [&Circle; 2], euler_body: bool) -> Result<Vec<Component>, SweepError> {
        let circles = self.gluing.boundary_circles();
        let plus = self.gluing.root(plus.first_arc);
        let minus = self.gluing.root(minus.first_arc);
        let mut components: Vec<Component> = self
            .gluing
            .components(true)
            .into_iter()
            .map(|root| Component {
                boundary_circles: circles.iter().filter(|&&(arc, _)| arc == root).map(|_| 1).sum(),
                poles: (!euler_body).then_some(Poles { plus: plus == root, minus: minus == root }),
            })
            .collect();
        let by_components = components.iter().map(|component| 2 - i64::from(component.boundary_circles)).sum();
        let complement = self.gluing.components(false).len();
        // On the sphere the components of U and of its complement, joined where they share a circle, form a tree.
        if self.euler != by_components || circles.len() + 1 != components.len() + complement {
            return Err(SweepError::Inconsistent { cells: self.euler, components: by_components });
        }
        sort_components(&mut components);
        Ok(components)
    }
}
