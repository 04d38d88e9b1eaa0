//! The section P at one (h, l) as a surface in ℝ⁶: charts by its tangent planes, and a cover by them.
//!
//! Coordinates are y = (γ, l/L), where no |l| on the energy surface exceeds the unit L. P is where |γ| = 1, ⟨γ,l⟩ = l,
//! H = h and S = 0. At regular (h, l) the four gradients are independent (Theorem 10.6 of docs/mathematics.md), so that
//! P is locally a graph over each of its tangent planes, on the boundary of the accessible region and over the poles as
//! anywhere else.

use std::collections::HashMap;

use bifdiag_dynamics::field::{Dimension, HeavyTop, State, cross, dot};
use bifdiag_dynamics::section::{Monitor, SectionCondition};
use nalgebra::{Matrix4, SMatrix, Vector4};

use crate::flow::{Phase as Point, Space};

/// The section at one (h, l).
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    space: Space,
    top: HeavyTop,
    /// In units of the reduced top, as all below.
    h: f64,
    l: f64,
    /// The unit of S.
    section: f64,
}

impl Surface {
    /// For a top with weight, at an accessible (h, l) on no curve.
    #[must_use]
    pub fn new(top: &HeavyTop, h: f64, l: f64) -> Self {
        let units = top.units();
        let (h, l) = (units.reduce(h, Dimension::ENERGY), units.reduce(l, Dimension::MOMENTUM));
        let space = Space::new(top, h);
        Self { space, top: *top, h, l, section: SectionCondition::Height.scale(&space.top, h) }
    }

    /// The top as given.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        &self.top
    }

    /// The section at −l, where motions run backward.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { l: -self.l, ..*self }
    }

    /// Its points and their flow.
    #[must_use]
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// A lower bound for the period of any motion here, in the top's own time: 2π/Λ, Λ a Lipschitz constant of the
    /// field (J. A. Yorke, Proc. Amer. Math. Soc. 22 (1969) 509–512). With |γ| ≤ 1, |l| ≤ L and ½⟨ω,Aω⟩ ≤ h + |r| it is
    /// at most |ω| + 2L/A_min + |r|/L.
    #[must_use]
    pub fn shortest_period(&self) -> f64 {
        let least = self.space.top.moments().into_iter().fold(f64::INFINITY, f64::min);
        let (fastest, unit) = ((2.0 * self.energy_unit() / least).sqrt(), self.space.unit);
        let shortest = std::f64::consts::TAU / (fastest + 2.0 * unit / least + self.space.top.center_norm() / unit);
        self.top.units().restore(shortest, Dimension::TIME)
    }

    /// S and Ṡ, in the units of the reduced top.
    #[must_use]
    pub fn height(&self, y: &Point) -> [f64; 2] {
        let (state, top) = (self.space.state(y), &self.space.top);
        [SectionCondition::Height.value(top, &state), SectionCondition::Height.rate(top, &state)]
    }

    /// A state as a point.
    #[must_use]
    pub fn point(&self, state: &State) -> Point {
        self.space.point(&state.reduced(self.top.units()))
    }

    /// A point as a state.
    #[must_use]
    pub fn state(&self, y: &Point) -> State {
        self.space.state(y).restored(self.top.units())
    }

    /// The residuals of the four equations, each in its own unit.
    fn residual(&self, y: &Point) -> Vector4<f64> {
        let (state, top) = (self.space.state(y), &self.space.top);
        Vector4::new(
            0.5 * (dot(state.gamma, state.gamma) - 1.0),
            (dot(state.gamma, state.l) - self.l) / self.space.unit,
            (top.energy(&state) - self.h) / self.energy_unit(),
            SectionCondition::Height.value(top, &state) / self.section,
        )
    }

    fn energy_unit(&self) -> f64 {
        self.h + self.space.top.center_norm()
    }

    /// Their gradients, as columns.
    fn gradients(&self, y: &Point) -> SMatrix<f64, 6, 4> {
        let (State { gamma, l }, top) = (self.space.state(y), &self.space.top);
        let [of_length, of_momentum, of_energy] = self.space.gradients(y);
        let turned = cross(top.angular_velocity(l), top.center());
        let across = top.angular_velocity(cross(top.center(), gamma));
        let of_section = Point::from_fn(|i, _| if i < 3 { turned[i] } else { self.space.unit * across[i - 3] });
        SMatrix::from_columns(&[
            of_length,
            of_momentum / self.space.unit,
            of_energy / self.energy_unit(),
            of_section / self.section,
        ])
    }

    /// Ṡ, in units of |∇S| |f|: the sine of the angle at which the motion crosses P.
    #[must_use]
    pub fn slope(&self, y: &Point) -> f64 {
        let (normal, field) = (self.gradients(y).column(3).into_owned(), self.space.field(y));
        normal.dot(&field) / (normal.norm() * field.norm()).max(f64::MIN_POSITIVE)
    }

    /// A direction at a point of P, projected along the motion into P; of length 1.
    #[must_use]
    pub fn along_the_section(&self, y: &Point, direction: &Point) -> Point {
        let (normal, field) = (self.gradients(y).column(3).into_owned(), self.space.field(y));
        (direction - field * (normal.dot(direction) / normal.dot(&field))).normalize()
    }

    /// An orthonormal basis: four vectors normal to P, then two tangent to it; `None` at a singular point.
    fn basis(&self, y: &Point) -> Option<[Point; 6]> {
        let gradients = self.gradients(y);
        let mut basis: Vec<Point> = Vec::with_capacity(6);
        for k in 0..4 {
            let direction = orthogonal_to(&basis, gradients.column(k).normalize())?;
            basis.push(direction);
        }
        while basis.len() < 6 {
            let unit = (0..6)
                .filter_map(|i| orthogonal_to(&basis, Point::ith(i, 1.0)).map(|v| (i, v)))
                .max_by(|(i, _), (j, _)| left(&basis, *i).total_cmp(&left(&basis, *j)));
            basis.push(unit?.1);
        }
        basis.try_into().ok()
    }

    /// An orthonormal basis of the tangent plane; `None` at a singular point.
    #[must_use]
    pub fn tangent_plane(&self, y: &Point) -> Option<[Point; 2]> {
        self.basis(y).map(|[.., u, v]| [u, v])
    }
}

/// A square [−radius, radius]² of the tangent plane at a point, over which P is a graph.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The point.
    pub center: Point,
    /// An orthonormal basis of the tangent plane.
    pub across: [Point; 2],
    /// An orthonormal basis of the normal space.
    normal: SMatrix<f64, 6, 4>,
    /// Half a side of the square.
    pub radius: f64,
}

/// Steps of Newton's method onto the surface.
const STEPS: usize = 12;
/// How far P may be from the tangent plane over a square, in units of half its side.
const BEND: f64 = 0.3;
/// The samples of cells reach beyond the square, up to this multiple of it.
pub const BEYOND: f64 = 1.125;
/// How often a square is halved before its centre counts as singular.
const HALVINGS: usize = 12;

impl Chart {
    /// About a point of P; `radius` is halved until P is a nearly flat graph over the square. `None` near a singular
    /// point.
    #[must_use]
    pub fn new(surface: &Surface, center: Point, radius: f64) -> Option<Self> {
        let basis = surface.basis(&center)?;
        let normal = SMatrix::from_columns(&basis[..4]);
        let mut chart = Self { center, across: [basis[4], basis[5]], normal, radius };
        for _ in 0..HALVINGS {
            if chart.is_flat(surface) {
                return Some(chart);
            }
            chart.radius *= 0.5;
        }
        None
    }

    fn is_flat(&self, surface: &Surface) -> bool {
        self.rim(BEYOND).all(|at| self.place(surface, at).is_some_and(|y| self.height(&y) < BEND * self.radius))
    }

    /// Points along the rim of this square, scaled by `part`.
    fn rim(&self, part: f64) -> impl Iterator<Item = [f64; 2]> {
        let side = part * self.radius;
        (-RIM..RIM).flat_map(move |k| {
            let along = side * f64::from(k) / f64::from(RIM);
            [[along, -side], [side, along], [-along, side], [-side, -along]]
        })
    }

    /// Coordinates of a point in the tangent plane.
    #[must_use]
    pub fn coordinates(&self, y: &Point) -> [f64; 2] {
        let beside = y - self.center;
        self.across.map(|e| e.dot(&beside))
    }

    /// The distance of a point from the tangent plane.
    #[must_use]
    pub fn height(&self, y: &Point) -> f64 {
        (self.normal.transpose() * (y - self.center)).norm()
    }

    /// The point of P over a point of the tangent plane.
    #[must_use]
    pub fn place(&self, surface: &Surface, at: [f64; 2]) -> Option<Point> {
        let flat = self.center + self.across[0] * at[0] + self.across[1] * at[1];
        let mut y = flat;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let matrix: Matrix4<f64> = surface.gradients(&y).transpose() * self.normal;
            let step = self.normal * matrix.lu().solve(&surface.residual(&y))?;
            y -= step;
            let size = step.norm();
            if size < 1e-15 || (size < 1e-12 && size >= 0.5 * last) {
                return Some(y);
            }
            if (y - flat).norm() > 2.0 * self.radius {
                return None;
            }
            last = size;
        }
        None
    }

    /// Whether a point of P lies over the square scaled by `part`.
    #[must_use]
    pub fn holds(&self, y: &Point, part: f64) -> bool {
        let [u, v] = self.coordinates(y);
        u.abs().max(v.abs()) <= part * self.radius && self.height(y) <= self.radius
    }
}

/// The squared length of the part of the i-th unit vector that is orthogonal to a basis.
fn left(basis: &[Point], i: usize) -> f64 {
    1.0 - basis.iter().map(|e| e[i] * e[i]).sum::<f64>()
}

/// The part of a unit vector that is orthogonal to a basis, scaled to length 1.
fn orthogonal_to(basis: &[Point], mut v: Point) -> Option<Point> {
    for _ in 0..2 {
        for e in basis {
            v -= e * e.dot(&v);
        }
        let length = v.norm();
        if length < 1e-9 {
            return None;
        }
        v /= length;
    }
    Some(v)
}

/// The largest half side of a square.
pub const RADIUS: f64 = 0.12;
/// Half the number of points on each side of a square that must lie in others.
const RIM: i32 = 4;
/// The inner part of a square in which they must lie.
const INNER: f64 = 0.9;

/// A cover of P.
#[derive(Clone, Debug)]
pub struct Cover {
    /// The charts.
    pub charts: Vec<Chart>,
    /// Every point tested on the rim of a square lies well within another square: together the squares have no rim, and
    /// cover every component that has a seed.
    pub closed: bool,
    /// Where no square is small enough. If there is no such place and the cover is not closed, it would need too many
    /// squares.
    pub singular: Vec<Point>,
}

/// Covers the components of P in which the seeds lie, from chart to chart, with at most `most` charts; stops early when
/// the monitor says so. `watch` is called with the charts so far and how many of their rims have been checked.
#[must_use]
pub fn cover(
    surface: &Surface,
    seeds: &[Point],
    most: usize,
    monitor: &Monitor,
    watch: &mut dyn FnMut([usize; 2]),
) -> Cover {
    let mut cover = Cover { charts: Vec::new(), closed: true, singular: Vec::new() };
    let mut grid = Grid::default();
    for seed in seeds {
        cover.add(surface, &mut grid, *seed);
    }
    let mut next = 0;
    while next < cover.charts.len() {
        if cover.charts.len() > most || monitor.is_stopped() {
            cover.closed = false;
            break;
        }
        let chart = cover.charts[next].clone();
        let rim: Vec<Option<Point>> = chart.rim(1.0).map(|at| chart.place(surface, at)).collect();
        if rim.contains(&None) {
            cover.closed = false;
            cover.singular.push(chart.center);
        }
        for y in rim.into_iter().flatten() {
            cover.add(surface, &mut grid, y);
        }
        next += 1;
        watch([cover.charts.len(), next]);
    }
    cover
}

/// Finds charts by place and size: near a singular point there are many small ones, but few of each size.
#[derive(Default)]
struct Grid {
    /// For each half side RADIUS/2ⁿ, the squares by place.
    sizes: Vec<HashMap<[i32; 3], Vec<usize>>>,
}

impl Grid {
    #[expect(clippy::cast_possible_truncation, reason = "γ is a unit vector, and no square is very small")]
    fn place(y: &Point, radius: f64) -> [i32; 3] {
        [0, 1, 2].map(|i| (y[i] / (1.5 * radius)).floor() as i32)
    }

    fn insert(&mut self, chart: &Chart, number: usize) {
        let mut size = 0;
        let mut radius = RADIUS;
        while radius > chart.radius {
            size += 1;
            radius *= 0.5;
        }
        if self.sizes.len() <= size {
            self.sizes.resize_with(size + 1, HashMap::new);
        }
        self.sizes[size].entry(Self::place(&chart.center, chart.radius)).or_default().push(number);
    }

    /// The charts that may contain a point.
    fn near(&self, y: &Point) -> impl Iterator<Item = usize> {
        let mut radius = 2.0 * RADIUS;
        self.sizes.iter().flat_map(move |charts| {
            radius *= 0.5;
            let place = Self::place(y, radius);
            let places = (0..27).map(move |k| [place[0] + k / 9 - 1, place[1] + k / 3 % 3 - 1, place[2] + k % 3 - 1]);
            places.filter_map(|place| charts.get(&place)).flatten().copied()
        })
    }
}

impl Cover {
    /// Adds a chart about a point, unless one contains it already.
    fn add(&mut self, surface: &Surface, grid: &mut Grid, y: Point) {
        if grid.near(&y).any(|chart| self.charts[chart].holds(&y, INNER)) {
            return;
        }
        if let Some(chart) = Chart::new(surface, y, RADIUS) {
            grid.insert(&chart, self.charts.len());
            self.charts.push(chart);
        } else {
            self.closed = false;
            self.singular.push(y);
        }
    }
}
