//! Regions with a sample and their topology.

use crate::arrangement::{Arrangement, Cell, RegionId, SlabId};
use crate::topology::merge::{self, CriticalPoint, Extent, MergeError};
use crate::topology::{Component, Poles, is_excluded, whole_sphere};
use bifdiag_equilibria::curves::{CriticalSet, CurveId, Gap, Orbit, Point, Pole};
use bifdiag_numbers::table::Table;

/// A well-placed point of a region, in the frame's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// x = l²/2.
    pub x: f64,
    /// Energy.
    pub h: f64,
    /// Distance in h to the boundary, at this x.
    pub margin: f64,
    /// Bound on the error of `margin`.
    pub error: f64,
    /// The curve that is nearest.
    pub nearest: CurveId,
}

/// A region of the (h, l) half-plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Its cells.
    pub cells: Vec<Cell>,
    /// A point inside.
    pub sample: Sample,
    /// The components of U_hl, or why they are not known.
    pub components: Result<Vec<Component>, MergeError>,
}

/// A place in a cell where a region could be sampled.
#[derive(Clone, Copy)]
struct Candidate<'a> {
    cell: Cell,
    row: &'a SlabRow,
    sample: Sample,
    /// Margin less its error bound, relative to the energy scale x/J + r.
    quality: f64,
}

/// Samples every region and finds its topology from the merge tree there.
pub(crate) fn regions(arrangement: &Arrangement) -> Table<RegionId, Region> {
    let mut cells = Table::<RegionId, Vec<Cell>>::filled(Vec::new(), arrangement.region_count);
    for (slab, strip) in arrangement.slabs.pairs() {
        for (position, &region) in strip.region_above.iter().enumerate() {
            cells[region].push(Cell { slab, position });
        }
    }
    let rows: Table<SlabId, Vec<SlabRow>> = arrangement.slabs.ids().map(|slab| rows(arrangement, slab)).collect();
    cells.into_iter().map(|cells| region(arrangement, &rows, cells)).collect()
}

/// The points of all curves of a slab at one abscissa.
struct SlabRow {
    x: f64,
    points: Vec<Point>,
}

/// Rows at a few abscissae of a slab.
fn rows(arrangement: &Arrangement, slab: SlabId) -> Vec<SlabRow> {
    let [from, to] = arrangement.slabs[slab].x;
    let middle = arrangement.middle(slab);
    // In the last slab near its lower end: there the sample is still inside the default picture.
    let abscissae = match (from > 0.0, to.is_finite()) {
        (_, true) => [0.5 * (from + middle), middle, 0.5 * (middle + to)],
        (true, false) => [1.2 * from, 1.35 * from, 1.5 * from],
        (false, false) => [0.5 * middle, middle, 2.0 * middle],
    };
    let inside = |x: &f64| *x > from && *x < to;
    let set = &arrangement.set;
    abscissae
        .into_iter()
        .filter(inside)
        .map(|x| {
            let points = arrangement.slabs[slab].order.iter().map(|&c| set.curves[c].point(&set.frame, x)).collect();
            SlabRow { x, points }
        })
        .collect()
}

fn region(arrangement: &Arrangement, rows: &Table<SlabId, Vec<SlabRow>>, cells: Vec<Cell>) -> Region {
    // Should rounding hide a join at the best place, as next to a pitchfork, the next ones may still show it.
    const ATTEMPTS: usize = 32;
    let mut candidates: Vec<Candidate<'_>> = cells
        .iter()
        .flat_map(|&cell| rows[cell.slab].iter().map(move |row| candidate(arrangement, cell, row)))
        .collect();
    candidates.sort_by(|p, q| q.quality.total_cmp(&p.quality));
    let Some(&best) = candidates.first() else {
        // A face that only lives between events at the same x has no inside that f64 can name.
        return Region { sample: corner(arrangement, cells[0]), cells, components: Err(MergeError::UnknownOrder) };
    };
    let tried = candidates.iter().take(ATTEMPTS).map(|candidate| (candidate.sample, topology(arrangement, candidate)));
    // The sample is a point at which the topology was found, if there is one.
    let mut refused = None;
    for (sample, components) in tried {
        match components {
            // Where f64 leaves an order open, it may name what cannot be.
            Ok(components) if components.iter().any(is_excluded) => refused = Some(MergeError::UnknownOrder),
            Ok(components) => return Region { cells, sample, components: Ok(components) },
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    let components = Err(refused.unwrap_or(MergeError::LostPath));
    Region { cells, sample: best.sample, components }
}

/// The lower left corner of a cell, with no margin.
fn corner(arrangement: &Arrangement, Cell { slab, position }: Cell) -> Sample {
    let strip = &arrangement.slabs[slab];
    let curve = strip.order[position];
    let point = arrangement.set.curves[curve].point(&arrangement.set.frame, strip.x[0]);
    Sample { x: point.x, h: point.h(), margin: 0.0, error: point.h_error(), nearest: curve }
}

fn candidate<'a>(arrangement: &Arrangement, cell: Cell, row: &'a SlabRow) -> Candidate<'a> {
    let Cell { slab, position } = cell;
    let order = &arrangement.slabs[slab].order;
    let lower = &row.points[position];
    let scale = row.x / lower.j + arrangement.set.frame.r_norm;
    let (margin, error) = if let Some(upper) = row.points.get(position + 1) {
        let gap = Gap::between(&arrangement.set.frame, upper, lower);
        (0.5 * gap.value, gap.error + upper.h_error())
    } else {
        (scale.min(lower.h().abs() + arrangement.set.frame.r_norm).max(0.5 * scale), lower.h_error())
    };
    let sample = Sample { x: row.x, h: lower.h() + margin, margin, error, nearest: order[position] };
    Candidate { cell, row, sample, quality: (margin - error) / scale }
}

/// The components of U_hl at a sample.
fn topology(arrangement: &Arrangement, candidate: &Candidate<'_>) -> Result<Vec<Component>, MergeError> {
    let set = &arrangement.set;
    let order = &arrangement.slabs[candidate.cell.slab].order;
    if candidate.cell.position + 1 == order.len() {
        return Ok(vec![whole_sphere(!set.frame.is_euler())]);
    }
    // In a region thinner than rounding no downhill path can be trusted; with one minimum none is needed.
    let too_thin = candidate.quality <= 0.0 && minima(set, &order[..=candidate.cell.position]) > 1;
    if too_thin || !is_ordered(&candidate.row.points) {
        return Err(MergeError::UnknownOrder);
    }
    let below = order[..=candidate.cell.position].iter().zip(&candidate.row.points);
    components_below(set, candidate.row.x, below.map(|(&c, point)| (c, point)))
}

/// Number of minima on these curves.
fn minima(set: &CriticalSet, curves: &[CurveId]) -> usize {
    let count = |c: &CurveId| match (set.curves[*c].index, set.curves[*c].orbit) {
        (Some(0), Orbit::Pair(_)) => 2,
        (Some(0), _) => 1,
        _ => 0,
    };
    curves.iter().map(count).sum()
}

/// True when no two heights contradict the order in which the points are given.
pub(super) fn is_ordered(points: &[Point]) -> bool {
    let mut highest = f64::NEG_INFINITY;
    for point in points {
        if point.h() + point.h_error() < highest {
            return false;
        }
        highest = highest.max(point.h() - point.h_error());
    }
    true
}

/// The components of the sublevel set above exactly these curves at x.
///
/// # Errors
/// [`MergeError`] when rounding leaves a join open.
pub(crate) fn components_below<'a>(
    set: &CriticalSet,
    x: f64,
    below: impl ExactSizeIterator<Item = (CurveId, &'a Point)>,
) -> Result<Vec<Component>, MergeError> {
    partition_below(set, x, below).map(merge::Partition::into_components)
}

/// [`components_below`], and the means to find the one in which a point lies.
///
/// # Errors
/// As [`components_below`].
pub(crate) fn partition_below<'a, 's>(
    set: &'s CriticalSet,
    x: f64,
    below: impl ExactSizeIterator<Item = (CurveId, &'a Point)>,
) -> Result<merge::Partition<'s>, MergeError> {
    let mut critical = Vec::with_capacity(below.len() + 2);
    let mut poles = Poles::default();
    for (c, point) in below {
        let curve = &set.curves[c];
        match curve.entering_pole() {
            Some(Pole::Plus) => poles.plus = true,
            Some(Pole::Minus) => poles.minus = true,
            None => {}
        }
        let Some(index) = curve.index else { continue };
        let extent = match curve.orbit {
            Orbit::Circle(axis) => Extent::Circle(axis),
            Orbit::Sphere => Extent::Sphere,
            _ => Extent::Point,
        };
        critical.push(CriticalPoint { gamma: point.gamma, index, extent });
        if let Orbit::Pair(axis) = curve.orbit {
            let mut mirrored = point.gamma;
            mirrored[axis] = -mirrored[axis];
            critical.push(CriticalPoint { gamma: mirrored, index, extent });
        }
    }
    let poles = (!set.frame.is_euler()).then_some(poles);
    merge::partition(&set.frame, x, &critical, poles)
}
