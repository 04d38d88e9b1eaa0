//! A slab between two circles of latitude, tiled by bricks in which ∂U_hl cannot hide anything.
//!
//! Arcs and gaps glued to components, and which components share a boundary circle.

use super::angle::{Longitude, LongitudeRange, Trig, half_angle_reach};
use super::circle::{CUTS, Circle};
use super::error::Effort;
use super::level::{Level, variation};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::table::Partition;

/// Share of the variation of G above which a brick is shortened rather than its slab thinned.
const PARALLEL_SHARE: f64 = 0.7;

/// What is proved of G in a brick, that is for all latitudes of the slab and all longitudes of a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing yet.
    Open,
    /// G has this sign.
    Sign(bool),
    /// ∂G/∂ψ has one sign wherever h + ⟨γ,r⟩ > 0: `true` is positive. (Elsewhere G < 0.)
    Turning(bool),
    /// G is monotone from the pole's side of the slab to the other: `true` is growing.
    Sloping(bool),
}

/// One brick of a slab.
#[derive(Clone, Copy, Debug)]
pub(super) struct Brick {
    pub stretch: LongitudeRange,
    pub kind: Kind,
}

/// Half of the sphere's latitudes, from one pole: ϑ = 2 arctan t, or π − 2 arctan t.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hemisphere {
    Plus,
    Minus,
}

impl Hemisphere {
    pub fn at(self, t: f64) -> Trig {
        self.oriented(Trig::at(t))
    }

    fn over(self, t0: f64, t1: f64) -> Trig {
        self.oriented(Trig::over(t0, t1))
    }

    fn oriented(self, trig: Trig) -> Trig {
        match self {
            Self::Plus => trig,
            Self::Minus => trig.mirrored(),
        }
    }
}

/// The bricks with which a slab starts: nothing known of any quadrant.
pub(super) fn open_bricks() -> Vec<Brick> {
    LongitudeRange::quadrants().map(|stretch| Brick { stretch, kind: Kind::Open }).collect()
}

/// Tiles the slab t0 ≤ t ≤ t1 with bricks that are no wider than needed; bricks already settled stay.
/// Bricks that are still open afterwards want a thinner slab.
pub(super) fn settle(
    level: &Level,
    hemisphere: Hemisphere,
    (t0, t1): (f64, f64),
    bricks: &[Brick],
    effort: &mut Effort,
) -> Option<Vec<Brick>> {
    let middle = 0.5 * (t0 + t1);
    let slab = SlabRange {
        hemisphere,
        theta: hemisphere.over(t0, t1),
        center: hemisphere.at(middle),
        reach: half_angle_reach(t0, middle, t1),
    };
    let mut settled: Vec<Brick> = Vec::with_capacity(bricks.len() + 8);
    let mut push = |brick: Brick| match settled.last_mut() {
        Some(last)
            if last.kind == brick.kind
                && brick.kind != Kind::Open
                && last.stretch.quadrant == brick.stretch.quadrant =>
        {
            last.stretch.t1 = brick.stretch.t1;
        }
        _ => settled.push(brick),
    };
    let mut stack: Vec<Brick> = Vec::new();
    for &brick in bricks {
        stack.push(brick);
        while let Some(Brick { stretch, kind }) = stack.pop() {
            if kind != Kind::Open {
                push(Brick { stretch, kind });
                continue;
            }
            effort.spend()?;
            let (kind, along_parallel) = slab.kind(level, stretch);
            if kind == Kind::Open && along_parallel {
                let t = stretch.t0 + CUTS[0] * (stretch.t1 - stretch.t0);
                let (left, right) = stretch.split(t)?;
                stack.push(Brick { stretch: right, kind });
                stack.push(Brick { stretch: left, kind });
            } else {
                push(Brick { stretch, kind });
            }
        }
    }
    Some(settled)
}

/// A slab's latitudes, evaluated once.
struct SlabRange {
    hemisphere: Hemisphere,
    theta: Trig,
    center: Trig,
    /// Largest distance in ϑ from the centre.
    reach: f64,
}

impl SlabRange {
    /// What can be proved of a brick, and for an open brick whether G varies so much along its parallels that a
    /// shorter stretch, not a thinner slab, is the next thing to try.
    fn kind(&self, level: &Level, stretch: LongitudeRange) -> (Kind, bool) {
        let psi = stretch.trig();
        let patch = level.over(&self.theta, &psi);
        if let Some(sign) = patch.value().is_positive() {
            return (Kind::Sign(sign), false);
        }
        let turning = patch.turning();
        if let Some(sign) = turning.is_positive() {
            return (Kind::Turning(sign), false);
        }
        let meridional = patch.meridional();
        if let Some(sign) = meridional.is_positive() {
            return (Kind::Sloping(sign == (self.hemisphere == Hemisphere::Plus)), false);
        }
        let middle = 0.5 * (stretch.t0 + stretch.t1);
        let center = Longitude::new(stretch.quadrant, middle).trig();
        let meridional = variation(meridional, self.reach);
        let parallel = variation(patch.parallel(turning), half_angle_reach(stretch.t0, middle, stretch.t1));
        let around = |radius: f64| Interval::between(-radius, radius);
        let value = level.value(&self.center, &center) + around(meridional) + around(parallel);
        match value.is_positive() {
            Some(sign) => (Kind::Sign(sign), false),
            None => (Kind::Open, parallel > PARALLEL_SHARE * meridional),
        }
    }
}

/// Glues the arcs of the circle on the pole's side (`near`) to those on the other side (`far`) through a slab
/// all of whose bricks are settled, and returns the Euler characteristic of the part of U_hl in the slab.
///
/// Why nothing is missed: inside a turning brick every point of U moves along its latitude, with G growing,
/// to a brick of another kind (two turning bricks of unequal sense cannot be neighbours); inside the others it
/// moves along its meridian to one of the circles. So every component of U in the slab reaches a circle, and two
/// arcs are connected in the slab exactly when a chain of meridian segments that lie wholly in U connects them:
/// such segments change only at the sides of bricks. The same holds for the complement with −G.
/// `None` when a corner of a brick lies on ∂U_hl within rounding.
pub(super) fn glue(level: &Level, near: &Circle, far: &Circle, bricks: &[Brick], gluing: &mut Gluing) -> Option<i64> {
    let mut euler = 0;
    for (n, brick) in bricks.iter().enumerate() {
        let previous = bricks[(n + bricks.len() - 1) % bricks.len()].kind;
        match brick.kind {
            Kind::Open => return None,
            Kind::Turning(sense) => {
                let next = bricks[(n + 1) % bricks.len()].kind;
                // A run of turning bricks shrinks, with growing G, to its last side (its first if G falls).
                if sense && !matches!(next, Kind::Turning(_)) || !sense && !matches!(previous, Kind::Turning(_)) {
                    let (side, neighbour) =
                        if sense { (brick.stretch.end(), next) } else { (brick.stretch.start(), previous) };
                    euler += i64::from(side_meets(level, near, far, side, neighbour)?);
                }
                if !matches!(previous, Kind::Turning(_)) {
                    euler -= i64::from(side_meets(level, near, far, brick.stretch.start(), previous)?);
                }
            }
            Kind::Sign(sign) => {
                let start = brick.stretch.start();
                gluing.join(near.locate(level, start, Some(sign))?.1, far.locate(level, start, Some(sign))?.1);
                euler += i64::from(sign) - i64::from(side_meets(level, near, far, start, brick.kind)?);
            }
            Kind::Sloping(growing) => {
                let (low, high) = if growing { (near, far) } else { (far, near) };
                let columns = glue_sloping(level, low, high, brick.stretch, gluing)?;
                euler += columns - i64::from(side_meets(level, near, far, brick.stretch.start(), brick.kind)?);
            }
        }
    }
    Some(euler)
}

/// Whether the side of a brick of this kind (not turning) meets U.
fn side_meets(level: &Level, near: &Circle, far: &Circle, psi: Longitude, kind: Kind) -> Option<bool> {
    match kind {
        Kind::Sign(sign) => Some(sign),
        Kind::Sloping(true) => Some(far.locate(level, psi, None)?.0),
        Kind::Sloping(false) => Some(near.locate(level, psi, None)?.0),
        Kind::Open | Kind::Turning(_) => None,
    }
}

/// Glues through a brick in which G grows from the circle `low` to the circle `high`; returns the number of
/// components of U in the brick.
fn glue_sloping(
    level: &Level,
    low: &Circle,
    high: &Circle,
    stretch: LongitudeRange,
    gluing: &mut Gluing,
) -> Option<i64> {
    let mut column = |psi: Longitude| {
        let (low_sign, low_arc) = low.locate(level, psi, None)?;
        let (high_sign, high_arc) = high.locate(level, psi, low_sign.then_some(true))?;
        if low_sign == high_sign {
            gluing.join(low_arc, high_arc);
        } else {
            gluing.border(high_arc, low_arc);
        }
        Some(high_sign)
    };
    let first = column(stretch.start())?;
    let last = column(stretch.end())?;
    let inside = |circle: &Circle| circle.marks.iter().filter(|mark| stretch.contains(mark.psi)).copied().collect();
    let low_marks: Vec<_> = inside(low);
    let high_marks: Vec<_> = inside(high);
    for mark in low_marks.iter().filter(|mark| mark.accessible) {
        gluing.join(mark.arc, high.locate(level, mark.psi, Some(true))?.1);
    }
    for mark in high_marks.iter().filter(|mark| !mark.accessible) {
        gluing.join(mark.arc, low.locate(level, mark.psi, Some(false))?.1);
    }
    let signs = high_marks.iter().map(|mark| mark.accessible).chain([last]);
    let mut before = first;
    let mut columns = i64::from(first);
    for sign in signs {
        columns += i64::from(sign && !before);
        before = sign;
    }
    Some(columns)
}

/// The arcs (accessible) and gaps (not accessible) of all circles of latitude, and which of them are joined.
#[derive(Clone, Debug, Default)]
pub(super) struct Gluing {
    joined: Partition,
    accessible: Vec<bool>,
    borders: Vec<(usize, usize)>,
}

impl Gluing {
    /// Number of arcs and gaps so far, the index of the next one.
    pub fn len(&self) -> usize {
        self.accessible.len()
    }

    pub fn add(&mut self, accessible: bool) {
        self.joined.add();
        self.accessible.push(accessible);
    }

    pub fn root(&mut self, arc: usize) -> usize {
        self.joined.find(arc)
    }

    pub fn join(&mut self, a: usize, b: usize) {
        self.joined.unite(a, b);
    }

    /// Records that an arc and a gap lie on both sides of one piece of ∂U.
    pub fn border(&mut self, arc: usize, gap: usize) {
        self.borders.push((arc, gap));
    }

    /// The roots of the components of U or of its complement, ascending.
    pub fn components(&mut self, accessible: bool) -> Vec<usize> {
        (0..self.len()).filter(|&arc| self.accessible[arc] == accessible && self.root(arc) == arc).collect()
    }

    /// Boundary circles as pairs (component of U, component of the complement): on the sphere two components
    /// share at most one.
    pub fn boundary_circles(&mut self) -> Vec<(usize, usize)> {
        let borders = std::mem::take(&mut self.borders);
        let mut circles: Vec<_> = borders.into_iter().map(|(arc, gap)| (self.root(arc), self.root(gap))).collect();
        circles.sort_unstable();
        circles.dedup();
        circles
    }
}
