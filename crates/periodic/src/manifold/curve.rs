//! How a manifold begins, and the curve that it becomes.

use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::ManifoldEnd;

use super::world::World;
use crate::chart::{Chart, RADIUS, Surface};
use crate::flow::Phase;

/// How far from the orbit a manifold is taken for its tangent: what it is off there, some 10⁻⁸, shrinks by the multiplier with each return.
const BEGIN: f64 = 1e-4;

/// One of the two ways out of an orbit along its unstable direction.
pub struct Branch {
    /// The orbit's place in the list.
    pub orbit: usize,
    /// In the reversed world.
    pub is_stable: bool,
    /// That of a period.
    pub multiplier: f64,
    /// Returns after which the branch comes to itself, and how many of them are a period.
    pub returns: usize,
    /// See `returns`.
    pub turns: usize,
    /// The point of the orbit.
    pub start: Phase,
    side: f64,
    chart: Chart,
    /// Of length 1, in the chart.
    direction: [f64; 2],
    /// ln of the factor by which it is stretched in its `returns`.
    growth: f64,
}

impl Branch {
    /// Both ways out; where the multiplier is negative, one, which is the other one after a period. Nothing at a singular point.
    pub fn pair(
        world: &World<'_>,
        orbit: usize,
        turns: usize,
        start: Phase,
        multiplier: f64,
        across: &Phase,
    ) -> Vec<Self> {
        let surface = world.surface();
        let Some(chart) = Chart::new(surface, start, RADIUS) else { return Vec::new() };
        let [x, y] = chart.coordinates(&(start + surface.along_the_section(&start, across)));
        let (is_stable, flips) = (world.is_reversed, multiplier < 0.0);
        let size = (x * x + y * y).sqrt();
        let direction = [x / size, y / size];
        let returns = if flips { 2 * turns } else { turns };
        let growth = libm::log(multiplier.abs()) * if flips { 2.0 } else { 1.0 };
        let sides = if flips { &[1.0][..] } else { &[1.0, -1.0] };
        let with = |side: &f64| Self {
            orbit,
            is_stable,
            multiplier,
            returns,
            turns,
            start,
            side: *side,
            chart: chart.clone(),
            direction,
            growth,
        };
        sides.iter().map(with).collect()
    }

    /// The beginning of the branch at s: from s = 0 to s = 1 it is what one return of the branch to itself adds.
    pub fn seed(&self, surface: &Surface, s: f64) -> Option<Phase> {
        let distance = self.side * BEGIN * libm::exp(self.growth * (s - 1.0));
        self.chart.place(surface, self.direction.map(|x| x * distance))
    }

    /// Where Rᵏ takes seeds: (k, s) for each.
    pub fn at(&self, world: &World<'_>, places: &[(usize, f64)]) -> Result<Vec<Option<Phase>>, SectionError> {
        let seeds: Vec<Option<Phase>> = places.iter().map(|(_, s)| self.seed(world.surface(), *s)).collect();
        let starts: Vec<Phase> = seeds.iter().copied().flatten().collect();
        let most = places.iter().map(|(k, _)| *k).max().unwrap_or(0);
        if most == 0 {
            return Ok(seeds);
        }
        let images = world.map.distant_images(&starts, most)?;
        let mut images = images.iter();
        let place = |((k, _), seed): (&(usize, f64), Option<Phase>)| {
            let seed = seed?;
            let images = images.next()?;
            if *k == 0 { Some(seed) } else { images.get(k - 1).map(|image| image.point) }
        };
        Ok(places.iter().zip(seeds).map(place).collect())
    }

    /// Which of the ways out at its point the curve of the k-th returns is.
    pub fn side_of(&self, k: usize) -> i8 {
        let side = if self.side > 0.0 { 1 } else { -1 };
        if k % self.returns < self.turns { side } else { -side }
    }
}

/// A point of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// The point, in (γ, l/L).
    pub point: Phase,
    /// It is the image under Rᵏ …
    pub(super) level: usize,
    /// … of the seed at s.
    pub(super) s: f64,
}

/// One of the two curves of a manifold at a point of an orbit.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The point: of orbit points p, Rp, R²p, … the number.
    pub point: usize,
    /// 1 or −1: the two curves at one point.
    pub side: i8,
    /// Polylines; between two of them the curve is broken.
    pub pieces: Vec<Vec<Vertex>>,
    /// The length of all of them.
    pub length: f64,
    /// Breaks where a motion touches the line of tangency.
    pub tangencies: usize,
    /// Other breaks.
    pub gaps: usize,
    /// Why it ends.
    pub end: Option<ManifoldEnd>,
    /// The branch whose curve it is.
    pub(super) branch: usize,
}
