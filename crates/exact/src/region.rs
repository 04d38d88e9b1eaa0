//! Regions: a sample in each and the topology there, from the ridges over one exact point.
//!
//! How far the sample of a region is from the curves around it.

use super::arrange::{Arrangement, Slab};
use super::evaluator::{Evaluator, Evaluators};
use super::plane::{Gap, Open, Plane, rounded};
use bifdiag_body::Frame;
use bifdiag_diagram::arrangement::{Cell, RegionId};
use bifdiag_diagram::topology::Component;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::Table;
use dashu_base::Abs;
use dashu_ratio::RBig;

/// A point of a region: proved to lie between the curves around it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sample {
    pub cell: Cell,
    /// Energy: a double, unless the region is thinner than doubles are apart.
    pub h: RBig,
    /// Its distance to the curves around.
    pub margin: Margin,
}

/// A region.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// By rising slab.
    pub cells: Vec<Cell>,
    /// `None`: the heights around it are not separated.
    pub sample: Option<Sample>,
    /// The components of U_hl, or why they are not proved.
    pub components: Result<Vec<Component>, Open>,
}

pub(super) fn regions(arrangement: &Arrangement, frame: &Frame) -> Table<RegionId, Region> {
    let mut cells = Table::<RegionId, Vec<Cell>>::filled(Vec::new(), arrangement.region_count);
    for (slab, strip) in arrangement.slabs.pairs() {
        for (position, &region) in strip.region_above.iter().enumerate() {
            cells[region].push(Cell { slab, position });
        }
    }
    let plane = Plane::new(&arrangement.model, frame);
    let evaluators = Evaluators::new(&arrangement.model, &arrangement.curves, &[]);
    cells.into_iter().map(|cells| region(arrangement, &evaluators, &plane, cells)).collect()
}

fn region(arrangement: &Arrangement, evaluators: &Evaluators<'_>, plane: &Plane<'_>, cells: Vec<Cell>) -> Region {
    let samples = cells.iter().filter_map(|&cell| sample(arrangement, cell).map(|(room, h)| (room, cell, h)));
    let best = samples.max_by(|p, q| p.0.total_cmp(&q.0)).map(|(_, cell, h)| (cell, h));
    let cell = best.as_ref().map_or(cells[0], |(cell, _)| *cell);
    let strip = &arrangement.slabs[cell.slab];
    let found = gap(evaluators, strip, cell.position);
    let thin = || {
        let Ok(Gap { low: Some(low), high: Some(high) }) = &found else { return None };
        let half = (high - low) / RBig::from(2);
        Some((cell, rounded(low + &half, &half)))
    };
    let sample = best.or_else(thin);
    let sample = sample.map(|(cell, h)| Sample {
        cell,
        margin: margin(evaluators, &arrangement.slabs[cell.slab], cell.position, &h),
        h,
    });
    let components = found.and_then(|gap| plane.class(&strip.x, &gap));
    Region { cells, sample, components }
}

/// The bounds of a cell, with as many bits as part them.
fn gap(evaluators: &Evaluators<'_>, strip: &Slab, position: usize) -> Result<Gap, Open> {
    let [low, high] = [position, position + 1].map(|place| strip.heights.get(place));
    let narrow = |low: &[f64; 2], high: Option<&[f64; 2]>| {
        let apart = high.is_none_or(|high| low[1] < high[0] && high[0].is_finite());
        let at = |h: f64| RBig::try_from(h).ok();
        (apart && low[1].is_finite()).then(|| Gap { low: at(low[1]), high: high.and_then(|high| at(high[0])) })
    };
    if let Some(gap) = low.and_then(|low| narrow(low, high)) {
        return Ok(gap);
    }
    wide_gap(evaluators.middle(), strip, position)
        .or_else(|| wide_gap(evaluators.wide(), strip, position))
        .ok_or(Open::Beside)
}

fn wide_gap<E: Enclosure<Precision = ()>>(evaluator: &Evaluator<'_, E>, strip: &Slab, position: usize) -> Option<Gap> {
    let x = E::rational(&strip.x, ());
    let height = |place: usize| evaluator.point(*strip.order.get(place)?, &x)?.h().exact_bounds();
    let ([_, low], high) = (height(position)?, height(position + 1));
    let high = match high {
        None if position + 1 < strip.order.len() => return None,
        high => high.map(|[high, _]| high),
    };
    high.as_ref().is_none_or(|high| low < *high).then_some(Gap { low: Some(low), high })
}

/// h of a sample of a cell, and how well it lies: its distance to the curves relative to the energies there.
fn sample(arrangement: &Arrangement, cell: Cell) -> Option<(f64, RBig)> {
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
        (margin / scale, exact(h))
    })
}

/// The distance in h to the nearest curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Margin {
    /// Bounds.
    pub distance: [f64; 2],
    pub nearest: CurveId,
}

/// The distance of h from the two curves around a cell over the slab's abscissa: no other curve is as near. Where the
/// largest precision does not decide which of the two is nearer, it is the lower one.
fn margin(evaluators: &Evaluators<'_>, strip: &Slab, position: usize, h: &RBig) -> Margin {
    let clear = |(margin, is_clear): (Margin, bool)| is_clear.then_some(margin);
    among(evaluators.middle(), strip, position, h)
        .and_then(clear)
        .or_else(|| among(evaluators.wide(), strip, position, h).map(|(margin, _)| margin))
        .unwrap_or_else(|| of_doubles(strip, position, h))
}

/// The margin among the curves on both sides, and whether these bits decide which is nearer and how far it is.
fn among<E: Enclosure<Precision = ()>>(
    evaluator: &Evaluator<'_, E>,
    strip: &Slab,
    position: usize,
    h: &RBig,
) -> Option<(Margin, bool)> {
    /// A distance is known to this relative accuracy.
    const ACCURACY: f64 = 1e-12;
    let (x, at) = (E::rational(&strip.x, ()), E::rational(h, ()));
    let height = |curve: CurveId| Some(evaluator.point(curve, &x)?.h());
    let lower = strip.order[position];
    let below = at.clone() - height(lower)?;
    let (nearest, distance, is_told) = match strip.order.get(position + 1) {
        None => (lower, size(&below), true),
        Some(&upper) => {
            let above = height(upper)? - at;
            match (below.clone() - above.clone()).strict_sign() {
                Some(Sign::Positive) => (upper, size(&above), true),
                Some(_) => (lower, size(&below), true),
                None => (lower, size(&below), false),
            }
        }
    };
    let is_sharp = distance[1] - distance[0] <= ACCURACY * distance[0];
    Some((Margin { distance, nearest }, is_told && is_sharp))
}

/// Bounds of the absolute value.
fn size<E: Enclosure>(difference: &E) -> [f64; 2] {
    let [lo, hi] = difference.bounds();
    [lo.max(-hi).max(0.0), hi.max(-lo)]
}

/// The same from the heights in doubles by which the order was proved.
fn of_doubles(strip: &Slab, position: usize, h: &RBig) -> Margin {
    let bounds = |place: usize| {
        let height = strip.heights.get(place)?.map(|height| RBig::try_from(height).ok());
        let [Some(lo), Some(hi)] = height else { return None };
        let [least, most] = if place == position { [h - hi, h - lo] } else { [lo - h, hi - h] };
        let down = least.max(RBig::ZERO).to_f64().value().next_down().max(0.0);
        Some(Margin { distance: [down, most.to_f64().value().next_up()], nearest: strip.order[place] })
    };
    let around = [position, position + 1].into_iter().filter_map(bounds);
    let nearest = around.min_by(|p, q| p.distance[1].total_cmp(&q.distance[1]));
    nearest.unwrap_or(Margin { distance: [0.0, f64::INFINITY], nearest: strip.order[position] })
}

/// How far the distance D of a sample (x, h) may move when both are rounded to doubles, and these to the decimals that are
/// written (Lemma 8.7): Δh + (max(|h|, |h′|) + D + |r|) Δx / min(x, x′) with x′ = l²/2, where a decimal adds 2⁻⁵³|h′| to |h′ − h| and
/// 2⁻⁵²x′ to |x′ − x|.
pub(super) fn rounding([x, h]: [&RBig; 2], [l, rounded_h]: [f64; 2], distance: f64, norm: f64) -> f64 {
    let decimal = exact(0.5 * f64::EPSILON);
    let (l, other) = (exact(l), exact(rounded_h));
    let rounded_x = &l * &l / RBig::from(2);
    let across = (&other - h).abs() + other.clone().abs() * &decimal;
    let along = (&rounded_x - x).abs() + &rounded_x * decimal * RBig::from(2);
    let energies = h.clone().abs().max(other.abs()) + exact(distance) + exact(norm);
    let moved = across + energies * along / x.clone().min(rounded_x);
    // More than the roundings of |r| and of this number.
    moved.to_f64().value() * (1.0 + 16.0 * f64::EPSILON)
}

/// The double as an exact number.
pub(super) fn exact(x: f64) -> RBig {
    RBig::try_from(x).unwrap_or(RBig::ZERO)
}
