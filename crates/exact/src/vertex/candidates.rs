//! The cells beside a point on curves, and their classes.

use bifdiag_diagram::topology::Components;
use bifdiag_numbers::enclosure::Enclosure;
use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::fan::Vertex;
use super::{fan, strip};
use crate::critical_values::{CriticalSource, CriticalValues};
use crate::plane::{Gap, Open, Plane};

/// A cell over one x.
pub(crate) struct Cell {
    pub x: RBig,
    pub gap: Gap,
}

/// Each class that meets at the point, once, in the order of [`cells`].
pub(crate) fn candidates(vertex: &Vertex<'_>) -> Result<Vec<Components>, Open> {
    let mut found: Vec<Components> = Vec::new();
    for Cell { x, gap } in cells(vertex)? {
        let components = vertex.plane.class(&x, &gap)?;
        if !found.contains(&components) {
            found.push(components);
        }
    }
    Ok(found)
}

/// The cells that meet at the point: from below upwards, over x, x − δ and x + δ.
pub(crate) fn cells(vertex: &Vertex<'_>) -> Result<Vec<Cell>, Open> {
    /// How often δ is made smaller. No curves touch at the point but at a common cusp or pitchfork, so a small enough one does
    /// (Theorem 4.12); the last is 2^-55 of the first.
    const ATTEMPTS: usize = 12;
    let Vertex { plane, heights, h, levels } = *vertex;
    let gap = Gap::around(levels);
    let x = &heights.x;
    let below = Gap { low: gap.low.clone(), high: Some(h.clone()) };
    let above = Gap { low: Some(h.clone()), high: gap.high.clone() };
    let mut found: Vec<Cell> = [below, above].map(|gap| Cell { x: x.clone(), gap }).into();
    let room = room(plane, x, h, &gap);
    let widest = power_below(&(strip::reach(plane, heights, &room)? / power(16)));
    for before in [true, false] {
        let mut step = widest.clone();
        let mut attempts = 0;
        let (beside, cells) = loop {
            let beside = if before { x - &step } else { x + &step };
            let Beside { sources, cells, near } = beside_point(plane, beside.clone(), h, &room)?;
            if fan::is_ordered(vertex, &sources, &near) {
                break (beside, cells);
            }
            attempts += 1;
            if attempts == ATTEMPTS {
                return Err(Open::Beside);
            }
            step /= power(32);
        };
        found.extend(cells.into_iter().map(|gap| Cell { x: beside.clone(), gap }));
    }
    Ok(found)
}

/// A quarter of the distance from h to the next height on either side.
pub(crate) fn room(plane: &Plane<'_>, x: &RBig, h: &RBig, gap: &Gap) -> RBig {
    let below = gap.low.as_ref().map(|low| h - low);
    let above = gap.high.as_ref().map(|high| high - h);
    let room = below.into_iter().chain(above).min();
    room.unwrap_or_else(|| x / plane.model.a(plane.model.groups.len() - 1)) / RBig::from(4)
}

fn power(bits: usize) -> RBig {
    RBig::from(IBig::ONE << bits)
}

/// A power of two below a positive number, and more than a quarter of it.
fn power_below(limit: &RBig) -> RBig {
    let (up, down) = (limit.numerator().bit_len(), limit.denominator().bit_len() + 1);
    if up < down { RBig::ONE / power(down - up) } else { power(up - down) }
}

/// The curves at an x next to the point.
struct Beside {
    sources: Vec<CriticalSource>,
    /// The cells between the curves that pass near h, with those below and above.
    cells: Vec<Gap>,
    /// Those curves, by their numbers among the sources.
    near: Vec<usize>,
}

/// The curves over x that pass within `room` of h, with the cells around them.
fn beside_point(plane: &Plane<'_>, x: RBig, h: &RBig, room: &RBig) -> Result<Beside, Open> {
    let mut heights = CriticalValues::new(plane.model, x);
    let [floor, ceiling] = [h - room, h + room];
    for stage in 1..CriticalValues::stages() {
        let all = heights.enclosed(stage).map_err(|_none| Open::Roots)?;
        let bounds = all.iter().map(|(_, height)| height.exact_bounds());
        let Some(bounds) = bounds.collect::<Option<Vec<[RBig; 2]>>>() else { continue };
        let mut bounds: Vec<([RBig; 2], usize)> = bounds.into_iter().zip(0..).collect();
        bounds.sort();
        if bounds.windows(2).any(|pair| pair[0].0[1] >= pair[1].0[0]) {
            continue;
        }
        let sources = all.into_iter().map(|(source, _)| source).collect();
        let is_near = |bound: &[RBig; 2]| floor < bound[1] && bound[0] < ceiling;
        let near: Vec<usize> = (0..bounds.len()).filter(|&k| is_near(&bounds[k].0)).collect();
        let Some(&first) = near.first() else { return Ok(Beside { sources, cells: Vec::new(), near }) };
        let height = |number: Option<usize>, end: usize| number.and_then(|k| bounds.get(k)).map(|b| b.0[end].clone());
        let cell = |k: usize| Gap { low: height(k.checked_sub(1), 1), high: height(Some(k), 0) };
        let cells = (first..=first + near.len()).map(cell).collect();
        return Ok(Beside { sources, cells, near: near.into_iter().map(|k| bounds[k].1).collect() });
    }
    Err(Open::Beside)
}
