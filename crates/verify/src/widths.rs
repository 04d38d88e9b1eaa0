//! The largest extent of each region in h at one l: the gap between the curves below and above is reached somewhere and
//! exceeded nowhere. J is monotone along a curve but for one place, so that h is convex or concave in x between two points
//! of a curve, whose chord and tangents bound it; in doubles, with more room than they round. Curves side by side are closer
//! than they are bent: there the gap has other bounds (`beside`).

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument};

use super::Refused;
use super::beside::Beside;
use super::events::Events;
use super::measures::tail;
use super::orders::Orders;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::Slab;

/// A width is what is stated to this share of it and to the room of both curves.
const ACCURACY: f64 = 1e-6;
/// Room for what doubles do to the sums of a few energies.
const FEW: f64 = 8.0 * f64::EPSILON;
/// Stretches of a cell at most.
const STRETCHES: usize = 20_000;
/// Stretches in a row that such a bound does not settle, after which none is asked for, and stretches for which one is.
const MISSES: usize = 10;
const QUESTIONS: usize = 400;
/// Steps by a factor of four towards infinity at most.
const STEPS: usize = 60;

/// The two curves of a cell.
struct Strip<'a> {
    orders: &'a Orders<'a>,
    plane: &'a Plane<'a>,
    curves: [usize; 2],
    end: Reach,
}

/// How far a cell goes in x.
#[derive(Clone, Copy)]
enum Reach {
    To(f64),
    /// To infinity, where h − x/a of both curves has these limits.
    Along {
        limits: [f64; 2],
        a: f64,
    },
}

/// Both curves over one x, the lower one first.
#[derive(Clone, Copy)]
struct Pair {
    x: f64,
    h: [f64; 2],
    j: [f64; 2],
    /// Room for the gap.
    room: f64,
    /// How far the gap may be from that of the curves.
    rounding: f64,
}

/// h = at + slope·(x − x₀) for some x₀.
type Ray = [f64; 2];

/// Checks every width.
pub(super) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    events: &Events,
    orders: &Orders,
    plane: &Plane,
    slabs: &[Slab],
    cells: &[Vec<Cell>],
) -> Result<(), Refused> {
    let middle = |[lo, hi]: &[RBig; 2]| ((lo + hi) / RBig::from(2)).to_f64().value();
    let firsts = certificate.transitions.iter().filter_map(|group| events.x.get(*group.first()?));
    let events: Vec<f64> = firsts.map(middle).collect();
    for (region, cells) in document.regions.iter().zip(cells) {
        let refuse = || Refused::Region { region: region.id.clone(), why: "its width is another" };
        let strip = |&(slab, position): &Cell| {
            let levels = &slabs[slab].levels;
            let curves = [levels[position].curve, levels.get(position + 1)?.curve];
            let end = match events.get(slab) {
                Some(&x) => Reach::To(x),
                None => along_one_axis(orders, curves)?,
            };
            Some((slab, Strip { orders, plane, curves, end }))
        };
        let strips: Option<Vec<(usize, Strip)>> = cells.iter().map(strip).collect();
        let (strips, claim) = match (strips, region.h_width) {
            (None, None) => continue,
            (Some(strips), Some(claim)) => (strips, claim / plane.energy),
            _ => return Err(refuse()),
        };
        let mut reached = false;
        for (slab, strip) in strips {
            let from = slab.checked_sub(1).map_or(0.0, |before| events[before]);
            reached |= strip.within(claim, from).ok_or_else(refuse)?;
        }
        if !reached {
            return Err(refuse());
        }
    }
    Ok(())
}

/// What two curves tend to, where that is one axis.
fn along_one_axis(orders: &Orders, curves: [usize; 2]) -> Option<Reach> {
    let [lower, upper] = curves.map(|curve| tail(orders.spaces, &orders.pieces.list[curve]));
    let ([j, low], [k, high]) = (lower?, upper?);
    // Different moments are told apart by the bits of their sets.
    Some(Reach::Along { limits: [low.to_f64(), high.to_f64()], a: j.meet(&k)?.to_f64() })
}

impl Strip<'_> {
    fn over(&self, x: f64) -> Option<Pair> {
        let [low, high] = self.curves.map(|curve| self.plane.near(curve, x));
        let both = [low?, high?];
        let h = both.each_ref().map(|near| near.h.middle());
        let rounding = both.iter().map(|near| near.h.radius() + FEW * near.h.middle().abs()).sum();
        let room = both.iter().map(|near| near.room).sum();
        Some(Pair { x, h, j: both.map(|near| near.j.middle()), room, rounding })
    }

    /// The gap is at most this between two x, or from one to infinity, where the curves run side by side.
    fn beside(&self, first: f64, last: Option<f64>) -> f64 {
        Beside { orders: self.orders, plane: self.plane, curves: self.curves }.largest_gap(first, last)
    }

    /// Whether the gap reaches the claim; `None` unless it exceeds it nowhere. The room is that of the cell's beginning, as
    /// energies grow with x.
    fn within(&self, claim: f64, from: f64) -> Option<bool> {
        let first = self.over(from)?;
        let (room, most) = (first.room, claim * (1.0 + ACCURACY) + first.room);
        let reaches = |gap: f64| (gap - claim).abs() <= claim * ACCURACY + room;
        let (end, mut reached) = match self.end {
            Reach::To(x) => (x, false),
            Reach::Along { limits, a } => {
                let limit = limits[1] - limits[0];
                if limit > most {
                    return None;
                }
                let soon = 2.0 * from.max(0.5);
                let is_soon = self.beside(soon, None) <= most;
                let end = if is_soon { soon } else { self.beyond(most, from, limits, a)? };
                (end, (limit - claim).abs() <= claim * ACCURACY)
            }
        };
        let last = self.over(end)?;
        reached |= reaches(first.gap()) || reaches(last.gap());
        let mut open = vec![(first, last)];
        let (mut misses, mut asked) = (0, 0);
        for _ in 0..STRETCHES {
            let Some((first, last)) = open.pop() else { return Some(reached) };
            let is_far = last.x > 4.0 * first.x;
            let rounding = first.rounding.max(last.rounding);
            // Far out doubles tell less.
            if !is_far || rounding <= room {
                if self.bound(&first, &last) <= most + rounding {
                    continue;
                }
                if misses < MISSES && asked < QUESTIONS {
                    asked += 1;
                    if self.beside(first.x, Some(last.x)) <= most {
                        misses = 0;
                        continue;
                    }
                    misses += 1;
                }
            }
            // Far ranges by their geometric mean.
            let middle =
                if is_far && first.x > 0.0 { first.x.sqrt() * last.x.sqrt() } else { 0.5 * (first.x + last.x) };
            let at = self.over(middle)?;
            if at.gap() > most + at.rounding {
                return None;
            }
            reached |= reaches(at.gap());
            open.extend([(first, at), (at, last)]);
        }
        None
    }

    /// An x from which on the gap is at most this: h − x/a goes to its limit monotonically on both curves, beyond the place
    /// where dJ/dμ = 0.
    fn beyond(&self, most: f64, from: f64, limits: [f64; 2], a: f64) -> Option<f64> {
        let turn = self.orders.inflection.as_ref().map_or(0.0, |(_, point)| point.x.to_f64());
        let mut x = 4.0 * from.max(1.0);
        for _ in 0..STEPS {
            let pair = self.over(x)?;
            let highest = (pair.h[1] - x / a).max(limits[1]);
            let lowest = (pair.h[0] - x / a).min(limits[0]);
            if x > 2.0 * turn && highest - lowest <= most + pair.rounding {
                return Some(x);
            }
            x *= 4.0;
        }
        None
    }

    /// The gap is at most this between two x.
    fn bound(&self, first: &Pair, last: &Pair) -> f64 {
        let width = last.x - first.x;
        let (uppers, lowers) = (self.rays(first, last, 1), self.rays(first, last, 0));
        let lines: Vec<Ray> = uppers
            .iter()
            .flat_map(|[h, slope]| lowers.iter().map(move |[low, other]| [h - low, slope - other]))
            .collect();
        let least = |x: f64| lines.iter().map(|[at, slope]| at + slope * x).fold(f64::INFINITY, f64::min);
        let corners = lines.iter().enumerate().flat_map(|(k, p)| {
            lines[..k].iter().map(move |q| (q[0] - p[0]) / (p[1] - q[1])).filter(|x| *x > 0.0 && *x < width)
        });
        corners.chain([0.0, width]).map(least).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Lines below the lower curve (`which` 0), or above the upper one, from the first x on.
    fn rays(&self, first: &Pair, last: &Pair, which: usize) -> Vec<Ray> {
        let width = last.x - first.x;
        let slopes = [first, last].map(|pair| 1.0 / pair.j[which]);
        let ends = [first, last].map(|pair| pair.h[which]);
        let turn = self.orders.turn(self.curves[which]).filter(|point| {
            let x = point.x.to_f64();
            first.x <= x * (1.0 + POINT) && last.x >= x * (1.0 - POINT)
        });
        // From each end with a slope that is the least, or the largest, on the way.
        let from_ends = |[left, right]: [f64; 2]| vec![[ends[0], left], [ends[1] - right * width, right]];
        if let Some(point) = turn {
            let slope = 1.0 / point.j.to_f64();
            let [least, most] = [slopes[0].min(slopes[1]).min(slope), slopes[0].max(slopes[1]).max(slope)];
            return from_ends(if which == 0 { [least, most] } else { [most, least] });
        }
        let is_convex = slopes[1] > slopes[0];
        if is_convex == (which == 0) {
            return from_ends(slopes);
        }
        let chord = (ends[1] - ends[0]) / width;
        vec![[ends[0], if width > 0.0 { chord } else { 0.0 }]]
    }
}

impl Pair {
    fn gap(&self) -> f64 {
        self.h[1] - self.h[0]
    }
}
