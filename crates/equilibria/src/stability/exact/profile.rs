//! The linear type along a whole family: the points where it changes, in order, and the type between them; and the relative
//! equilibria on it at one l or spin, counted exactly, with the type of each.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use super::body::ExactBody;
use super::family_chart::FamilyChart;
use crate::stability::{Constants, LinearType, Reduced, Signs, State};
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::wide::Wide;

/// What happens at a point of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StationKind {
    /// c changes its sign, and l and h turn.
    Cusp,
    /// c changes its sign, and the pair over this axis (or the circle: then c only vanishes) leaves.
    Pitchfork(Axis),
    /// c vanishes without a cusp.
    Touch,
    /// b² − 4c changes its sign (`true`) or only vanishes.
    Collision(bool),
    /// On a circle of equilibria: b changes its sign or vanishes.
    Swing,
}

/// A point of a family.
#[derive(Clone, Debug)]
pub struct Station {
    /// Its coordinate t.
    pub root: Root,
    /// What happens.
    pub kind: StationKind,
}

impl Station {
    /// A curve ends here and another begins.
    #[must_use]
    pub fn is_cut(&self) -> bool {
        matches!(self.kind, StationKind::Cusp | StationKind::Pitchfork(_))
    }
}

/// The stations of a family by rising t, and the types before, between and after them.
#[derive(Clone, Debug)]
pub struct Profile {
    /// Where the type changes or a curve ends, by rising t.
    pub stations: Vec<Station>,
    /// One more than stations.
    pub types: Vec<LinearType>,
    /// A rational t in each of these stretches.
    pub samples: Vec<RBig>,
}

/// Bits to which roots are narrowed before they are compared by other means.
const FIRST_BITS: usize = 64;

/// The order of two algebraic numbers.
pub(crate) fn compare(one: &mut Root, other: &mut Root) -> Ordering {
    let mut bits = FIRST_BITS;
    let mut is_shared = None;
    loop {
        if one.hi < other.lo || (one.hi == other.lo && !(one.is_exact() && other.is_exact())) {
            return Ordering::Less;
        }
        if other.hi < one.lo || (other.hi == one.lo && !(one.is_exact() && other.is_exact())) {
            return Ordering::Greater;
        }
        if other.is_exact() {
            if one.is_exact() {
                return one.lo.cmp(&other.lo);
            }
            if one.polynomial().sign_at(&other.lo) == Sign::Zero {
                return Ordering::Equal;
            }
        } else if *is_shared.get_or_insert_with(|| one.is_root_of(other.polynomial()))
            && other.lo < one.lo
            && one.hi < other.hi
        {
            // The only root of the other's polynomial in its range.
            return Ordering::Equal;
        }
        bits *= 2;
        one.refine(bits);
        if is_shared != Some(true) {
            other.refine(bits);
        }
    }
}

impl Profile {
    /// The whole family. `None` when roots are closer than 2^-4000.
    #[must_use]
    pub fn new(chart: &FamilyChart) -> Option<Self> {
        let mut stations = Vec::new();
        if chart.is_circle() {
            stations.extend(found(chart, &chart.swing, |_| StationKind::Swing)?);
            stations.extend(found(chart, &chart.cusp, |_| StationKind::Cusp)?);
        } else {
            for (axis, root) in &chart.pitchforks {
                stations.push(Station { root: root.clone(), kind: StationKind::Pitchfork(*axis) });
            }
            let of_cusp = |odd| if odd { StationKind::Cusp } else { StationKind::Touch };
            stations.extend(found(chart, &chart.cusp, of_cusp)?);
            stations.extend(found(chart, &chart.resonances[0], StationKind::Collision)?);
        }
        for station in &mut stations {
            station.root.refine(FIRST_BITS);
        }
        let ordered = ordered(stations);
        let samples = samples(chart, &ordered);
        let types = samples.iter().map(|t| type_at(chart, t)).collect();
        Some(Self { stations: ordered, types, samples })
    }

    /// For each piece of the branch, in the order of their numbers, the range of its indices into [`types`](Self::types); its
    /// stations lie between them.
    #[must_use]
    pub fn pieces(&self, is_reversed: bool) -> Vec<std::ops::RangeInclusive<usize>> {
        let cuts = (0..self.stations.len()).filter(|&k| self.stations[k].is_cut());
        let mut pieces = Vec::new();
        let mut first = 0;
        for cut in cuts {
            pieces.push(first..=cut);
            first = cut + 1;
        }
        pieces.push(first..=self.stations.len());
        if is_reversed {
            pieces.reverse();
        }
        pieces
    }
}

fn found(chart: &FamilyChart, polynomial: &Polynomial, kind: impl Fn(bool) -> StationKind) -> Option<Vec<Station>> {
    let roots = chart.roots(polynomial)?;
    Some(roots.into_iter().map(|root| Station { kind: kind(root.odd), root }).collect())
}

/// Sorts by t. Of several stations at one point the first one given (a cut before a collision) stays.
fn ordered(stations: Vec<Station>) -> Vec<Station> {
    let mut list: Vec<Station> = Vec::with_capacity(stations.len());
    'next: for mut station in stations {
        for at in 0..list.len() {
            match compare(&mut station.root, &mut list[at].root) {
                Ordering::Greater => {}
                Ordering::Equal => continue 'next,
                Ordering::Less => {
                    list.insert(at, station);
                    continue 'next;
                }
            }
        }
        list.push(station);
    }
    list
}

/// A rational t in each stretch.
fn samples(chart: &FamilyChart, stations: &[Station]) -> Vec<RBig> {
    let half = RBig::ONE / RBig::from(2);
    let mut samples = Vec::with_capacity(stations.len() + 1);
    let mut from = RBig::ZERO;
    for station in stations {
        samples.push((&from + &station.root.lo) * &half);
        from.clone_from(&station.root.hi);
    }
    samples.push(if chart.is_bounded() { (from + RBig::ONE) * half } else { from * RBig::from(2) + RBig::ONE });
    samples
}

/// The type at a rational t that is no station.
fn type_at(chart: &FamilyChart, t: &RBig) -> LinearType {
    let b = chart.swing.sign_at(t);
    if chart.is_circle() {
        return Signs::transverse_type(b);
    }
    Signs { b, c: chart.zero.sign_at(t), discriminant: chart.resonances[0].sign_at(t) }.linear_type()
}

/// A relative equilibrium at the exact l or spin.
#[derive(Clone, Debug)]
pub struct ExactPoint {
    /// Number of its piece of the branch, from 1: the lower one where two meet.
    pub piece: usize,
    /// Where curves meet there.
    pub touch: Option<Touch>,
    /// A double root of the condition: at one l a cusp, at one spin two steady axes that meet.
    pub is_double: bool,
    /// The equilibrium, enclosed.
    pub state: State<Wide>,
    /// The linearised flow.
    pub reduced: Reduced<Wide>,
    /// Its type.
    pub kind: LinearType,
    /// Morse index of U_l; `None` where the Hessian is degenerate.
    pub index: Option<u8>,
    /// Its coordinate on the family.
    root: Root,
}

/// The point is the end of two curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// A cusp: a double point.
    Cusp,
    /// The pair over this axis leaves.
    Pitchfork(Axis),
    /// A pair leaves where c has another zero, so that the Hessian vanishes: at a cusp, where c changes its sign once more, or
    /// where it touches 0.
    Both {
        /// It is a cusp.
        is_cusp: bool,
    },
}

/// Bits of the first attempt; they are multiplied by four until every sign is decided.
const BITS: usize = 192;

impl ExactPoint {
    /// All equilibria of a family at the roots of a polynomial in its coordinate (`FamilyChart::at_momentum`,
    /// `FamilyChart::at_spin`), by rising number of the piece. `None` when roots are closer than 2^-4000.
    #[must_use]
    pub fn all(body: &ExactBody, chart: &FamilyChart, profile: &Profile, condition: &Polynomial) -> Option<Vec<Self>> {
        let mut cuts: Vec<(Root, StationKind)> =
            profile.stations.iter().filter(|s| s.is_cut()).map(|s| (s.root.clone(), s.kind)).collect();
        let mut points = Vec::new();
        for mut root in chart.roots(condition)? {
            root.refine(BITS);
            let mut below = 0;
            let mut touch = None;
            for (cut, kind) in &mut cuts {
                match compare(&mut root, cut) {
                    Ordering::Less => break,
                    Ordering::Greater => below += 1,
                    Ordering::Equal => {
                        touch = Some(match kind {
                            StationKind::Pitchfork(axis) => pitchfork(chart, &mut root, *axis)?,
                            _ => Touch::Cusp,
                        });
                        break;
                    }
                }
            }
            let mut piece = 1 + below;
            if chart.is_reversed {
                piece = 1 + cuts.len() - below - usize::from(touch.is_some());
            }
            points.push(Self::at(body, chart, root, piece, touch));
        }
        points.sort_by_key(|point| point.piece);
        Some(points)
    }

    fn at(body: &ExactBody, chart: &FamilyChart, mut root: Root, piece: usize, touch: Option<Touch>) -> Self {
        let mut bits = BITS;
        let mut known = [None; 3];
        loop {
            let c: Constants<Wide> = body.constants(bits + 64);
            let state = chart.state(body, &c, &mut root, bits);
            let mut reduced = Reduced::new(&c, &state);
            let kind = kind(chart, &root, &mut reduced, &mut known);
            if let Some(kind) = kind {
                let index = reduced.index(state.hessian_trace(&c).sign());
                return Self { piece, touch, is_double: !root.odd, state, reduced, kind, index, root };
            }
            bits *= 4;
        }
    }
    /// The point again, enclosed with this many bits.
    #[must_use]
    pub(super) fn refined<E: Enclosure>(
        &self,
        body: &ExactBody,
        chart: &FamilyChart,
        (precision, bits): (E::Precision, usize),
    ) -> (Constants<E>, State<E>) {
        let c = body.constants(precision);
        let state = chart.state(body, &c, &mut self.root.clone(), bits);
        (c, state)
    }

    /// The coordinate is a root of a polynomial.
    pub(super) fn is_root_of(&self, polynomial: &Polynomial) -> bool {
        polynomial.is_zero() || self.root.is_root_of(polynomial)
    }
}

/// A pitchfork, and whether the curve that is left is degenerate itself there.
fn pitchfork(chart: &FamilyChart, root: &mut Root, axis: Axis) -> Option<Touch> {
    for mut other in chart.roots(&chart.cusp)? {
        if compare(root, &mut other) == Ordering::Equal {
            return Some(Touch::Both { is_cusp: other.odd });
        }
    }
    Some(Touch::Pitchfork(axis))
}

/// The type, from the signs that the enclosure decides and, for those that it leaves open, from common roots.
fn kind(
    chart: &FamilyChart,
    root: &Root,
    reduced: &mut Reduced<Wide>,
    known: &mut [Option<bool>; 3],
) -> Option<LinearType> {
    let signs = reduced.signs();
    let mut sign = |n: usize, polynomial: &Polynomial| {
        signs[n].or_else(|| {
            let is_root = known[n].get_or_insert_with(|| polynomial.is_zero() || root.is_root_of(polynomial));
            is_root.then_some(Sign::Zero)
        })
    };
    let b = sign(0, &chart.swing);
    let c = sign(1, &chart.zero);
    let discriminant = if c == Some(Sign::Positive) { sign(2, &chart.resonances[0]) } else { Some(Sign::Positive) };
    if b == Some(Sign::Zero) {
        *reduced = reduced.clone().without_b();
    }
    if chart.is_circle() {
        return b.map(Signs::transverse_type);
    }
    // Only with c = 0 and c > 0 does b count; b = 0 < c has a negative discriminant.
    Some(Signs { b: b?, c: c?, discriminant: discriminant? }.linear_type())
}
