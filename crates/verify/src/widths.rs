//! The largest extent of each region in h at one l: the gap between the curves below and above is reached somewhere and
//! exceeded nowhere. J is monotone along a curve but for one place, so that h is convex or concave in x between two points
//! of a curve, whose chord and tangents bound it; in doubles where they round little of what is claimed, and else with all
//! bits (`heights`), both curves measured from a tangent. Curves side by side are closer than they are bent: there the gap
//! has other bounds (`beside`).

use std::cell::OnceCell;
use std::rc::Rc;

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument};

use super::Refused;
use super::beside::Beside;
use super::events::Events;
use super::fixed::Fixed;
use super::heights::{Exact, Heights};
use super::measures::tail;
use super::orders::Orders;
use super::plane::{POINT, Plane};
use super::regions::Cell;
use super::slabs::Slab;

/// A width is what is stated to this share of it, and to this share of |r|: curves side by side are bent, and below that no chord of
/// a feasible length tells their gap.
const ACCURACY: f64 = 1e-6;
const SHARE_OF_R: f64 = 4e-9;
/// Room for what doubles do to the sums of a few energies.
const FEW: f64 = 8.0 * f64::EPSILON;
/// Doubles serve where they round less than this share of the room.
const SHARE: f64 = 0.25;
/// Stretches of a cell at most.
const STRETCHES: usize = 20_000;
/// Stretches in a row that such a bound does not settle, after which none is asked for over stretches as wide, and stretches for
/// which one is.
const MISSES: usize = 10;
const QUESTIONS: usize = 400;
/// Stretches over more than such a factor in x are far, or wide.
const FAR: f64 = 4.0;
const WIDE: f64 = 1.125;
/// Steps by a factor of four towards infinity at most.
const STEPS: usize = 60;

/// The two curves of a cell.
struct Strip<'a> {
    orders: &'a Orders<'a>,
    plane: &'a Plane<'a>,
    curves: [usize; 2],
    end: Reach,
    /// For where doubles tell too little.
    heights: OnceCell<Heights<'a>>,
}

/// How far a cell goes in x.
enum Reach {
    To(f64),
    /// To infinity, where h − x/a of both curves has these limits.
    Along {
        limits: [Fixed; 2],
        a: Fixed,
    },
}

/// What is claimed, and how far a gap may be from it.
#[derive(Clone, Copy)]
struct Claim {
    width: f64,
    room: f64,
}

/// Both curves over one x, the lower one first.
#[derive(Clone)]
struct Pair {
    x: f64,
    h: [f64; 2],
    j: [f64; 2],
    /// How far the gap of these may be from that of the curves.
    rounding: f64,
    /// With all bits, once asked for.
    exact: Rc<OnceCell<Option<Exact>>>,
}

/// A stretch between two x: what both curves do at its ends, above a straight line.
struct Stretch {
    length: f64,
    /// For each curve at both ends.
    heights: [[f64; 2]; 2],
    slopes: [[f64; 2]; 2],
    /// The slope of the line.
    line: Fixed,
    rounding: f64,
}

/// h = at + slope·(x − x₀) for some x₀.
type Ray = [f64; 2];

impl Claim {
    fn most(self) -> f64 {
        self.width + self.room
    }

    /// Doubles with so much rounding serve.
    fn admits(self, rounding: f64) -> bool {
        rounding <= SHARE * self.room
    }

    fn is_met(self, [gap, rounding]: [f64; 2]) -> bool {
        (gap - self.width).abs() + rounding <= self.room
    }
}

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
            Some((slab, Strip { orders, plane, curves, end, heights: OnceCell::new() }))
        };
        let strips: Option<Vec<(usize, Strip)>> = cells.iter().map(strip).collect();
        let (strips, claim) = match (strips, region.h_width) {
            (None, None) => continue,
            (Some(strips), Some(width)) => {
                let width = width / plane.energy;
                let norm = plane.norm / plane.energy;
                (strips, Claim { width, room: width * ACCURACY + SHARE_OF_R * norm })
            }
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
    Some(Reach::Along { limits: [low, high], a: j.meet(&k)? })
}

impl Strip<'_> {
    fn over(&self, x: f64) -> Option<Pair> {
        let [low, high] = self.curves.map(|curve| self.plane.near(curve, x));
        let both = [low?, high?];
        let h = both.each_ref().map(|near| near.h.middle());
        let rounding = both.iter().map(|near| near.h.radius() + FEW * near.h.middle().abs()).sum();
        Some(Pair { x, h, j: both.map(|near| near.j.middle()), rounding, exact: Rc::default() })
    }

    fn exact<'b>(&self, pair: &'b Pair) -> Option<&'b Exact> {
        let heights = self.heights.get_or_init(|| Heights::new(self.orders, self.plane, self.curves));
        pair.exact.get_or_init(|| heights.over(pair.x)).as_ref()
    }

    /// The gap, and how far it may be from that of the curves.
    fn gap(&self, pair: &Pair, claim: Claim) -> Option<[f64; 2]> {
        if claim.admits(pair.rounding) {
            return Some([pair.h[1] - pair.h[0], pair.rounding]);
        }
        let exact = self.exact(pair)?;
        Some([exact.gap(), exact.rounding()])
    }

    /// The gap is at most this between two x, or from one to infinity, where the curves run side by side.
    fn beside(&self, first: f64, last: Option<f64>) -> f64 {
        Beside { orders: self.orders, plane: self.plane, curves: self.curves }.largest_gap(first, last)
    }

    /// Whether the gap reaches the claim; `None` unless it exceeds it nowhere.
    fn within(&self, claim: Claim, from: f64) -> Option<bool> {
        let first = self.over(from)?;
        let (end, mut reached) = match &self.end {
            Reach::To(x) => (*x, false),
            Reach::Along { limits, a } => {
                let limit = (&limits[1] - &limits[0]).to_f64();
                let found = [limit, FEW * limit.abs()];
                if limit > claim.most() {
                    return None;
                }
                let soon = 2.0 * from.max(0.5);
                let is_soon = self.beside(soon, None) <= claim.most();
                (if is_soon { soon } else { self.beyond(claim, from, limits, a)? }, claim.is_met(found))
            }
        };
        let last = self.over(end)?;
        for pair in [&first, &last] {
            reached |= claim.is_met(self.gap(pair, claim)?);
        }
        Some(self.between(claim, first, last)? || reached)
    }

    /// Whether the gap reaches the claim between two x; `None` unless it exceeds it nowhere there.
    fn between(&self, claim: Claim, first: Pair, last: Pair) -> Option<bool> {
        let mut reached = false;
        let mut open = vec![(first, last)];
        let (mut misses, mut asked) = ([0; 3], 0);
        for _ in 0..STRETCHES {
            let Some((first, last)) = open.pop() else { return Some(reached) };
            let is_far = last.x > FAR * first.x;
            if self.bound(&first, &last, claim).is_some_and(|bound| bound <= claim.most()) {
                continue;
            }
            let width = usize::from(is_far) + usize::from(last.x > WIDE * first.x);
            if misses[width] < MISSES && asked < QUESTIONS {
                asked += 1;
                if self.beside(first.x, Some(last.x)) <= claim.most() {
                    misses = [0; 3];
                    continue;
                }
                misses[width] += 1;
            }
            // Far ranges by their geometric mean.
            let middle =
                if is_far && first.x > 0.0 { first.x.sqrt() * last.x.sqrt() } else { 0.5 * (first.x + last.x) };
            let at = self.over(middle)?;
            let [gap, rounding] = self.gap(&at, claim)?;
            if gap > claim.most() + rounding {
                return None;
            }
            reached |= claim.is_met([gap, rounding]);
            open.extend([(first, at.clone()), (at, last)]);
        }
        None
    }

    /// An x from which on the gap is at most this: h − x/a goes to its limit monotonically on both curves, beyond the place
    /// where dJ/dμ = 0.
    fn beyond(&self, claim: Claim, from: f64, limits: &[Fixed; 2], a: &Fixed) -> Option<f64> {
        let turn = self.orders.inflection.as_ref().map_or(0.0, |(_, point)| point.x.to_f64());
        let limits = limits.each_ref().map(Fixed::to_f64);
        let mut x = 4.0 * from.max(1.0);
        for _ in 0..STEPS {
            let pair = self.over(x)?;
            let (rest, rounding) = if claim.admits(pair.rounding) {
                (pair.h.map(|h| h - x / a.to_f64()), pair.rounding)
            } else {
                let exact = self.exact(&pair)?;
                (exact.above_axis(a)?, exact.rounding() + FEW * limits[0].abs().max(limits[1].abs()))
            };
            let gap = rest[1].max(limits[1]) - rest[0].min(limits[0]);
            if x > 2.0 * turn && gap + rounding <= claim.most() {
                return Some(x);
            }
            x *= 4.0;
        }
        None
    }

    /// Both curves between two x, in doubles where they serve.
    fn stretch(&self, first: &Pair, last: &Pair, claim: Claim) -> Option<Stretch> {
        let rounding = first.rounding.max(last.rounding);
        if claim.admits(rounding) {
            let ends = |of: fn(&Pair, usize) -> f64| [0, 1].map(|which| [of(first, which), of(last, which)]);
            return Some(Stretch {
                length: last.x - first.x,
                heights: ends(|pair, which| pair.h[which]),
                slopes: ends(|pair, which| 1.0 / pair.j[which]),
                line: Fixed::whole(0),
                rounding,
            });
        }
        let (first, last) = (self.exact(first)?, self.exact(last)?);
        let ends = |of: fn(&Exact, &Exact) -> [f64; 2]| {
            let (at_first, at_last) = (of(first, first), of(last, first));
            [0, 1].map(|which| [at_first[which], at_last[which]])
        };
        Some(Stretch {
            length: (&last.x - &first.x).to_f64(),
            heights: ends(Exact::above),
            slopes: ends(Exact::steeper),
            line: first.slopes[0].clone(),
            rounding: first.rounding() + last.rounding(),
        })
    }

    /// The gap is at most this between two x.
    fn bound(&self, first: &Pair, last: &Pair, claim: Claim) -> Option<f64> {
        let stretch = self.stretch(first, last, claim)?;
        let rays = |which: usize| {
            let turn = self.orders.turn(self.curves[which]).filter(|point| {
                let x = point.x.to_f64();
                first.x <= x * (1.0 + POINT) && last.x >= x * (1.0 - POINT)
            });
            let slope = match turn {
                Some(point) => Some((&Fixed::whole(1).over(&point.j)? - &stretch.line).to_f64()),
                None => None,
            };
            Some(stretch.rays(which, slope))
        };
        Some(stretch.bound(&rays(0)?, &rays(1)?))
    }
}

impl Stretch {
    /// The largest gap between lines below and lines above, with what doubles round on the way.
    fn bound(&self, lowers: &[Ray], uppers: &[Ray]) -> f64 {
        let lines: Vec<Ray> = uppers
            .iter()
            .flat_map(|[h, slope]| lowers.iter().map(move |[low, other]| [h - low, slope - other]))
            .collect();
        let least = |x: f64| lines.iter().map(|[at, slope]| at + slope * x).fold(f64::INFINITY, f64::min);
        let corners = lines.iter().enumerate().flat_map(|(k, p)| {
            lines[..k].iter().map(move |q| (q[0] - p[0]) / (p[1] - q[1])).filter(|x| *x > 0.0 && *x < self.length)
        });
        let largest = corners.chain([0.0, self.length]).map(least).fold(f64::NEG_INFINITY, f64::max);
        let scale = |ends: &[[f64; 2]; 2]| ends.iter().flatten().fold(0.0_f64, |most, at| most.max(at.abs()));
        largest + self.rounding + FEW * (scale(&self.heights) + self.length * scale(&self.slopes))
    }

    /// Lines below the lower curve (`which` 0), or above the upper one, from the first x on; J is monotone but for the place
    /// with the slope `turn`.
    fn rays(&self, which: usize, turn: Option<f64>) -> Vec<Ray> {
        let (slopes, ends) = (self.slopes[which], self.heights[which]);
        // From each end with a slope that is the least, or the largest, on the way.
        let from_ends = |[left, right]: [f64; 2]| vec![[ends[0], left], [ends[1] - right * self.length, right]];
        if let Some(slope) = turn {
            let [least, most] = [slopes[0].min(slopes[1]).min(slope), slopes[0].max(slopes[1]).max(slope)];
            return from_ends(if which == 0 { [least, most] } else { [most, least] });
        }
        let is_convex = slopes[1] > slopes[0];
        if is_convex == (which == 0) {
            return from_ends(slopes);
        }
        let chord = (ends[1] - ends[0]) / self.length;
        vec![[ends[0], if self.length > 0.0 { chord } else { 0.0 }]]
    }
}
