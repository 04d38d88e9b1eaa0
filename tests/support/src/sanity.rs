//! What the theorems of `docs/mathematics.md` say of every atlas; called by unit, property and fuzz tests.

use bifdiag_diagram::arrangement::{Arrangement, Change, RegionId, SlabId};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::topology::{Component, accessible_regions, whole_sphere};
use bifdiag_equilibria::curves::{CriticalSet, Curve, CurveId, Orbit, Pole};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::table::{Id, Partition};
use thiserror::Error;

/// Relative rounding of x at the end of a curve, and at the event there.
const SPAN_ROUNDING: f64 = 256.0 * UNIT_ROUNDOFF;

/// A broken invariant.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum InvariantError {
    /// Faces, edges and vertices do not satisfy Euler's formula.
    #[error("Euler's formula fails: {vertices} vertices − {edges} edges + {faces} faces ≠ {components} components")]
    Euler {
        /// Events and ends of curves.
        vertices: usize,
        /// Pieces of curves between vertices, and of the frame.
        edges: usize,
        /// Faces, the forbidden one included.
        faces: usize,
        /// Connected components of the graph.
        components: usize,
    },
    /// Two curves of a slab are in the wrong order at its middle, by more than the error bound.
    #[error("curves {lower:?} and {upper:?} are in the wrong order in {slab:?}")]
    Order {
        /// The slab.
        slab: SlabId,
        /// The curve that should be below.
        lower: CurveId,
        /// The curve that should be above.
        upper: CurveId,
    },
    /// A slab lists a curve that does not live there.
    #[error("{curve:?} does not cover {slab:?}")]
    Span {
        /// The slab.
        slab: SlabId,
        /// The curve.
        curve: CurveId,
    },
    /// The number of minima and maxima minus saddles is not 2.
    #[error("in {slab:?} the indices sum to {sum}, not to 2")]
    IndexSum {
        /// The slab.
        slab: SlabId,
        /// Σ (−1)^index.
        sum: i32,
    },
}

/// Checks Euler's formula, the vertical orders against computed heights (only where nothing was left undecided), and
/// Σ(−1)^index = 2 in each slab.
///
/// # Errors
/// The first [`InvariantError`] found.
pub fn check_arrangement(arrangement: &Arrangement) -> Result<(), InvariantError> {
    if arrangement.slabs.is_empty() {
        return Ok(());
    }
    check_euler(arrangement)?;
    for slab in arrangement.slabs.ids() {
        check_slab(arrangement, slab)?;
    }
    Ok(())
}

/// The half-plane is closed to a disc by a frame on which the ends of curves at l = 0 and ∞ lie.
fn check_euler(arrangement: &Arrangement) -> Result<(), InvariantError> {
    let curves = arrangement.set.curves.len();
    let mut ends = 0;
    let mut pieces = curves;
    for curve in &arrangement.set.curves {
        ends += usize::from(curve.x()[0] == 0.0) + usize::from(curve.x()[1].is_infinite());
    }
    let mut joined = Partition::new(curves + 1);
    for (c, curve) in arrangement.set.curves.pairs() {
        if curve.x()[0] == 0.0 || curve.x()[1].is_infinite() {
            joined.unite(c.index(), curves);
        }
    }
    for event in &arrangement.events {
        if let Change::Swap(_) = event.change {
            pieces += 2;
        }
        let meeting = event.change.curves();
        for pair in meeting.windows(2) {
            joined.unite(pair[0].index(), pair[1].index());
        }
    }
    let components = joined.count();
    let (vertices, edges, faces) = (arrangement.events.len() + ends, pieces + ends, arrangement.region_count + 1);
    if vertices + faces == edges + components {
        Ok(())
    } else {
        Err(InvariantError::Euler { vertices, edges, faces, components })
    }
}

fn check_slab(arrangement: &Arrangement, number: SlabId) -> Result<(), InvariantError> {
    let slab = &arrangement.slabs[number];
    let x = arrangement.middle(number);
    for &curve in &slab.order {
        let [from, to] = arrangement.set.curves[curve].x();
        // The ends of curves and the events are rounded on their own.
        if from > slab.x[0] * (1.0 + SPAN_ROUNDING) || to < slab.x[1] * (1.0 - SPAN_ROUNDING) {
            return Err(InvariantError::Span { slab: number, curve });
        }
    }
    let points: Vec<_> =
        slab.order.iter().map(|&c| arrangement.set.curves[c].point(&arrangement.set.frame, x)).collect();
    for (k, pair) in points.windows(2).enumerate() {
        let slack = pair[0].h_error() + pair[1].h_error();
        if arrangement.undecided.is_empty() && pair[0].h() - pair[1].h() > slack {
            return Err(InvariantError::Order { slab: number, lower: slab.order[k], upper: slab.order[k + 1] });
        }
    }
    let sum: i32 = slab.order.iter().map(|&c| arrangement.set.curves[c].euler_contribution()).sum();
    if sum == 2 { Ok(()) } else { Err(InvariantError::IndexSum { slab: number, sum }) }
}

/// A theorem that an atlas contradicts.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Contradiction {
    /// Euler's formula, an order of curves, or the sum of the indices.
    #[error(transparent)]
    Arrangement(#[from] InvariantError),
    /// No accessible region consists of these components (Theorem 11.1, Propositions 11.8 and 11.9).
    #[error("{region} shows {components:?}, which no body does")]
    Impossible {
        /// The region.
        region: RegionId,
        /// What it shows.
        components: Vec<Component>,
    },
    /// The components do not fit to the critical points below (Propositions 9.1, 9.2 and 9.5) or to the pole lines there.
    #[error("{region} shows {components:?}, but in {slab:?} the curves below and above it tell {expected:?}")]
    Curves {
        /// The region.
        region: RegionId,
        /// The slab of one of its cells.
        slab: SlabId,
        /// What it shows.
        components: Vec<Component>,
        /// What the curves tell.
        expected: Counts,
    },
}

/// What the curves below and above a cell say of U_hl.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// χ(U_hl): the sum of (−1)^index over the critical points below.
    pub euler_characteristic: i32,
    /// Minima below: U_hl has no more components.
    pub minima: u32,
    /// Maxima above: the complement of U_hl has no more components.
    pub maxima: u32,
    /// r̂ is in U_hl.
    pub plus: bool,
    /// −r̂ is in U_hl.
    pub minus: bool,
}

/// Checks what must hold for every body: the invariants of the arrangement; in each region an accessible region that
/// can occur; over each cell the Euler characteristic, the poles, and no more components of U_hl and of its complement
/// than there are minima below and maxima above.
///
/// # Errors
/// The first [`Contradiction`] found.
pub fn check(atlas: &Atlas) -> Result<(), Contradiction> {
    check_arrangement(atlas.arrangement())?;
    let euler = atlas.arrangement().set.frame.is_euler();
    let occurring = if euler { without_weight() } else { accessible_regions() };
    for (region, found) in atlas.regions().pairs() {
        let Ok(components) = &found.components else { continue };
        if !occurring.contains(components) {
            return Err(Contradiction::Impossible { region, components: components.clone() });
        }
    }
    atlas.arrangement().slabs.ids().try_for_each(|slab| check_cells(atlas, slab, !euler))
}

fn check_cells(atlas: &Atlas, slab: SlabId, has_poles: bool) -> Result<(), Contradiction> {
    let (set, strip) = (&atlas.arrangement().set, &atlas.arrangement().slabs[slab]);
    for (position, &region) in strip.region_above.iter().enumerate() {
        let Ok(components) = &atlas.regions()[region].components else { continue };
        let (below, above) = strip.order.split_at(position + 1);
        let expected = Counts::of(set, below, above);
        if !expected.fit(components, has_poles) {
            return Err(Contradiction::Curves { region, slab, components: components.clone(), expected });
        }
    }
    Ok(())
}

impl Counts {
    fn of(set: &CriticalSet, below: &[CurveId], above: &[CurveId]) -> Self {
        let curves = |ids: &[CurveId]| ids.iter().map(|&c| &set.curves[c]).collect::<Vec<&Curve>>();
        let (below, above) = (curves(below), curves(above));
        let enters = |pole: Pole| below.iter().any(|curve| curve.entering_pole() == Some(pole));
        Self {
            euler_characteristic: below.iter().map(|curve| curve.euler_contribution()).sum(),
            minima: below.iter().map(|curve| extrema(curve, true)).sum(),
            maxima: above.iter().map(|curve| extrema(curve, false)).sum(),
            plus: enters(Pole::Plus),
            minus: enters(Pole::Minus),
        }
    }

    fn fit(self, components: &[Component], has_poles: bool) -> bool {
        let circles: u32 = components.iter().map(|component| component.boundary_circles).sum();
        let count = u32::try_from(components.len()).unwrap_or(u32::MAX);
        // The circles are the edges of a tree, the components on both sides of them its vertices (Proposition 9.5).
        let complement = (circles + 1).checked_sub(count);
        let has = |minus: bool| components.iter().filter_map(|c| c.poles).any(|p| if minus { p.minus } else { p.plus });
        let [plus, minus] = if has_poles { [self.plus, self.minus] } else { [false, false] };
        i64::from(self.euler_characteristic) == 2 * i64::from(count) - i64::from(circles)
            && count <= self.minima
            && complement.is_some_and(|circles| circles <= self.maxima && (circles == 0) == (self.maxima == 0))
            && (has(false), has(true)) == (plus, minus)
    }
}

/// Minima or maxima over each point of a curve; a circle of them counts once.
fn extrema(curve: &Curve, minima: bool) -> u32 {
    let index = match (curve.orbit, minima) {
        (Orbit::Pole(_), _) => return 0,
        (Orbit::Sphere, _) => return 1,
        (_, true) => 0,
        // The index across the circle.
        (Orbit::Circle(_), false) => 1,
        (_, false) => 2,
    };
    let points = if matches!(curve.orbit, Orbit::Pair(_)) { 2 } else { 1 };
    if curve.index == Some(index) { points } else { 0 }
}

/// For r = 0 U_hl is where a quadratic form is at least x/h: two caps, the sphere without two caps, or the sphere.
fn without_weight() -> Vec<Vec<Component>> {
    let component = |boundary_circles| Component { boundary_circles, poles: None };
    vec![vec![component(1); 2], vec![component(2)], vec![whole_sphere(false)]]
}
