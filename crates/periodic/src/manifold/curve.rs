//! The beginning of a manifold, and the curve that grows from it.

use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::ManifoldEnd;

use super::ring::Ring;
use super::world::{Course, World};
use crate::chart::{Chart, RADIUS, Surface};
use crate::flow::Phase;

/// How far from the orbit a manifold is replaced by its tangent: the error there, some 10⁻⁸, shrinks by the multiplier
/// with each return.
const BEGIN: f64 = 1e-4;

/// One side of the unstable direction of an orbit, or all motions that leave an equilibrium.
pub struct Branch {
    /// The number of the orbit in the list, or of the equilibrium.
    pub orbit: usize,
    /// It lies in the reversed world.
    pub is_stable: bool,
    /// The multiplier over a period.
    pub multiplier: Option<f64>,
    /// The number of returns after which the branch is mapped to itself.
    pub returns: usize,
    /// The number of returns in a period.
    pub turns: usize,
    /// The point of the orbit, or the equilibrium.
    pub start: Phase,
    begin: Begin,
}

enum Begin {
    /// A line out of a point of P⁻.
    Line {
        side: f64,
        chart: Box<Chart>,
        /// Of length 1, in the chart.
        direction: [f64; 2],
        /// The logarithm of the factor by which `returns` stretch it.
        growth: f64,
    },
    Ring(Box<Ring>),
}

/// Where a seed is mapped.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// To a point.
    On(Phase),
    /// Nowhere yet: the level lies before the start of the motion.
    Before,
    /// To an equilibrium, which the motion approaches first.
    Rest,
    /// Unknown: the motion does not return in the longest time.
    Lost,
}

impl Place {
    /// The point.
    pub fn point(self) -> Option<Phase> {
        if let Self::On(point) = self { Some(point) } else { None }
    }

    /// The place of a motion at a return.
    pub fn of(course: &Course, number: usize) -> Self {
        match course.images.get(number - 1) {
            Some(image) => Self::On(image.point),
            None if course.came => Self::Rest,
            None => Self::Lost,
        }
    }
}

impl Branch {
    /// Both sides; where the multiplier is negative, only one, since a period maps it to the other. Empty at a singular
    /// point.
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
            multiplier: Some(multiplier),
            returns,
            turns,
            start,
            begin: Begin::Line { side: *side, chart: Box::new(chart.clone()), direction, growth },
        };
        sides.iter().map(with).collect()
    }

    /// All motions that leave an equilibrium.
    pub fn of_rest(world: &World<'_>, place: usize, ring: Ring) -> Self {
        let returns = ring.winding.max(1);
        let (start, begin) = (ring.center(), Begin::Ring(Box::new(ring)));
        Self { orbit: place, is_stable: world.is_reversed, multiplier: None, returns, turns: returns, start, begin }
    }

    /// Whether each return adds a curve of its own, closed except for breaks.
    pub fn is_closed(&self) -> bool {
        matches!(&self.begin, Begin::Ring(ring) if ring.winding == 0)
    }

    /// Whether it begins at an equilibrium.
    pub fn is_of_rest(&self) -> bool {
        matches!(&self.begin, Begin::Ring(_))
    }

    /// Seeds at which curves begin.
    pub fn places(&self) -> Vec<f64> {
        if let Begin::Ring(ring) = &self.begin { ring.places().collect() } else { Vec::new() }
    }

    /// The starting point for s: from s = 0 to s = 1 these form the piece that one return of the branch to itself adds.
    pub fn seed(&self, surface: &Surface, s: f64) -> Option<Phase> {
        match &self.begin {
            Begin::Line { side, chart, direction, growth } => {
                let distance = side * BEGIN * libm::exp(growth * (s - 1.0));
                chart.place(surface, direction.map(|x| x * distance))
            }
            Begin::Ring(ring) => Some(ring.start(s)),
        }
    }

    /// How many returns take a seed to the curve of a level.
    pub fn returns_to(&self, level: usize, s: f64) -> Option<usize> {
        if let Begin::Ring(ring) = &self.begin { ring.number(level, s) } else { Some(level) }
    }

    /// The places of seeds s at levels k, for pairs (k, s).
    pub fn at(&self, world: &World<'_>, places: &[(usize, f64)]) -> Result<Vec<Place>, SectionError> {
        let seeds: Vec<Option<Phase>> = places.iter().map(|(_, s)| self.seed(world.surface(), *s)).collect();
        let numbers: Vec<Option<usize>> = places.iter().map(|(k, s)| self.returns_to(*k, *s)).collect();
        let starts: Vec<Phase> = seeds.iter().copied().flatten().collect();
        let most = numbers.iter().copied().flatten().max().unwrap_or(0);
        let courses = if most == 0 { Vec::new() } else { world.courses(&starts, most)? };
        let mut courses = courses.iter();
        let place = |(number, seed): (Option<usize>, Option<Phase>)| {
            let Some(seed) = seed else { return Place::Lost };
            let course = courses.next();
            match (number, course) {
                (None, _) => Place::Before,
                (Some(0), _) => Place::On(seed),
                (Some(number), Some(course)) => Place::of(course, number),
                (Some(_), None) => Place::Lost,
            }
        };
        Ok(numbers.into_iter().zip(seeds).map(place).collect())
    }

    /// The side of its point on which the curve of the k-th return lies.
    pub fn side_of(&self, k: usize) -> i8 {
        let side = if matches!(&self.begin, Begin::Line { side, .. } if *side < 0.0) { -1 } else { 1 };
        if k % self.returns < self.turns { side } else { -side }
    }
}

impl Curve {
    /// A curve that has not been followed yet.
    pub(super) fn new((point, side): (usize, i8), pieces: Vec<Vec<Vertex>>, branch: usize) -> Self {
        let (length, tangencies, rests, gaps) = (0.0, 0, 0, 0);
        Self { point, side, pieces, length, tangencies, rests, gaps, nearest: None, end: None, branch }
    }
}

/// A point of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// The point, in (γ, l/L).
    pub point: Phase,
    /// It is the image under Rᵏ, k the level, …
    pub(super) level: usize,
    /// … of the seed at s.
    pub(super) s: f64,
}

/// One of the two curves of a manifold at a point of an orbit; or a curve of the manifold of an equilibrium, or the
/// points of the motion on one side of it.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The number of its point among the points p, Rp, R²p, … of the orbit.
    pub point: usize,
    /// 1 or −1: the two curves at one point, or the two motions.
    pub side: i8,
    /// Polylines, between which the curve is broken.
    pub pieces: Vec<Vec<Vertex>>,
    /// Their total length.
    pub length: f64,
    /// Breaks where a motion touches the line of tangency.
    pub tangencies: usize,
    /// Breaks at a motion that approaches an equilibrium.
    pub rests: usize,
    /// Other breaks.
    pub gaps: usize,
    /// For a motion: the smallest distance of its points from those of the motions of the other kind.
    pub nearest: Option<f64>,
    /// Why it ends.
    pub end: Option<ManifoldEnd>,
    /// The number of its branch.
    pub(super) branch: usize,
}
