//! Regions: a sample in each and the topology there, by the certified latitude sweep.

use dashu_ratio::RBig;

use super::arrange::Arrangement;
use top::body::Frame;
use top::diagram::{Cell, RegionId};
use top::table::Table;
use top::topology::latitude::{self, SweepError};
use top::topology::{Component, Poles};

/// A point of a region: proved to lie between the curves around it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sample {
    pub cell: Cell,
    /// Energy; a double.
    pub h: f64,
    /// Distances to the proved heights around, rounded down.
    pub margin: f64,
}

/// A region.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// By rising slab.
    pub cells: Vec<Cell>,
    /// `None`: the region is thinner than doubles.
    pub sample: Option<Sample>,
    /// The components of U_hl, or why they are not proved.
    pub components: Result<Vec<Component>, Unproved>,
}

/// Why a region's topology is not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unproved {
    /// No double lies inside.
    Thin,
    /// The sweep ended without an answer.
    Sweep(SweepError),
}

/// How many samples are tried.
const ATTEMPTS: usize = 3;

pub(super) fn regions(arrangement: &Arrangement, frame: &Frame) -> Table<RegionId, Region> {
    let mut cells = Table::<RegionId, Vec<Cell>>::filled(Vec::new(), arrangement.region_count);
    for (slab, strip) in arrangement.slabs.pairs() {
        for (position, &region) in strip.region_above.iter().enumerate() {
            cells[region].push(Cell { slab, position });
        }
    }
    cells.into_iter().map(|cells| region(arrangement, frame, cells)).collect()
}

fn region(arrangement: &Arrangement, frame: &Frame, cells: Vec<Cell>) -> Region {
    let mut samples: Vec<(f64, Sample)> = cells.iter().filter_map(|&cell| sample(arrangement, cell)).collect();
    samples.sort_by(|p, q| q.0.total_cmp(&p.0));
    let mut components = Err(Unproved::Thin);
    let mut chosen = samples.first().map(|(_, sample)| sample.clone());
    for (_, sample) in samples.into_iter().take(ATTEMPTS) {
        let strip = &arrangement.slabs[sample.cell.slab];
        if sample.cell.position + 1 == strip.order.len() {
            // Above the maximum of U.
            components = Ok(vec![Component {
                boundary_circles: 0,
                poles: (!frame.is_euler()).then_some(Poles { plus: true, minus: true }),
            }]);
        } else if let Some(l) = strip.l {
            components = latitude::components(frame, sample.h, l).map_err(Unproved::Sweep);
        }
        if components.is_ok() {
            chosen = Some(sample);
            break;
        }
    }
    Region { cells, sample: chosen, components }
}

/// A sample of a cell and how well it lies: its distance to the curves relative to the energies there.
fn sample(arrangement: &Arrangement, cell: Cell) -> Option<(f64, Sample)> {
    let Cell { slab, position } = cell;
    let strip = &arrangement.slabs[slab];
    strip.l?;
    let x = strip.x.to_f64().value();
    let low = strip.heights[position];
    let scale = low[1].abs() + x + 1.0;
    let (h, margin) = match strip.heights.get(position + 1) {
        Some(high) => {
            let h = low[1] + 0.5 * (high[0] - low[1]);
            (h, (h - low[1]).min(high[0] - h))
        }
        None => (low[1] + 0.25 * scale, 0.25 * scale),
    };
    // Few bits, where that stays well inside.
    let grid = f64::from_bits(((0.2 * margin).to_bits() >> 52) << 52);
    let rounded = (h / grid).round() * grid;
    let h = if (rounded - h).abs() <= 0.25 * margin { rounded } else { h };
    let inside = low[1] < h && strip.heights.get(position + 1).is_none_or(|high| h < high[0]);
    inside.then(|| {
        let margin = (h - low[1]).min(strip.heights.get(position + 1).map_or(f64::INFINITY, |high| high[0] - h));
        (margin / scale, Sample { cell, h, margin })
    })
}

/// The double as an exact number.
pub(super) fn exact(x: f64) -> RBig {
    RBig::try_from(x).unwrap_or(RBig::ZERO)
}
