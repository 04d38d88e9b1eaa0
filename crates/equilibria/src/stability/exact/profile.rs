//! The linear type along a whole family: the points where it changes, in order, and the type between them.

use dashu_ratio::RBig;

use super::strand::Strand;
use crate::stability::{LinearType, Signs};
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::polynomial::{Polynomial, Root};

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
    /// Points.
    pub stations: Vec<Station>,
    /// One more than stations.
    pub types: Vec<LinearType>,
    /// A coordinate in each of these stretches.
    pub samples: Vec<RBig>,
}

/// Bits to which roots are narrowed before they are compared by other means.
const FIRST_BITS: usize = 64;

/// Where one algebraic number stands to another.
pub(super) fn compare(one: &mut Root, other: &mut Root) -> std::cmp::Ordering {
    use std::cmp::Ordering;
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
    pub fn new(strand: &Strand) -> Option<Self> {
        let mut stations = Vec::new();
        if strand.is_circle() {
            stations.extend(found(strand, &strand.swing, |_| StationKind::Swing)?);
            stations.extend(found(strand, &strand.cusp, |_| StationKind::Cusp)?);
        } else {
            for (axis, t) in &strand.pitchforks {
                let root = Root::exact(&Polynomial::from_rationals(&[-t, RBig::ONE]), t.clone());
                stations.push(Station { root, kind: StationKind::Pitchfork(*axis) });
            }
            let of_cusp = |odd| if odd { StationKind::Cusp } else { StationKind::Touch };
            stations.extend(found(strand, &strand.cusp, of_cusp)?);
            stations.extend(found(strand, &strand.collision, StationKind::Collision)?);
        }
        for station in &mut stations {
            station.root.refine(FIRST_BITS);
        }
        let ordered = ordered(stations);
        let samples = samples(strand, &ordered);
        let types = samples.iter().map(|t| type_at(strand, t)).collect();
        Some(Self { stations: ordered, types, samples })
    }

    /// The stretches and stations of each curve, in the numbering of its pieces: the types along it, in that order,
    /// and what lies between them.
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

fn found(strand: &Strand, polynomial: &Polynomial, kind: impl Fn(bool) -> StationKind) -> Option<Vec<Station>> {
    let roots = strand.roots(polynomial)?;
    Some(roots.into_iter().map(|root| Station { kind: kind(root.odd), root }).collect())
}

/// By rising t; of stations at one point the first given (a cut before a collision) stays.
fn ordered(stations: Vec<Station>) -> Vec<Station> {
    let mut list: Vec<Station> = Vec::with_capacity(stations.len());
    'next: for mut station in stations {
        for at in 0..list.len() {
            match compare(&mut station.root, &mut list[at].root) {
                std::cmp::Ordering::Greater => {}
                std::cmp::Ordering::Equal => continue 'next,
                std::cmp::Ordering::Less => {
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
fn samples(strand: &Strand, stations: &[Station]) -> Vec<RBig> {
    let half = RBig::ONE / RBig::from(2);
    let mut samples = Vec::with_capacity(stations.len() + 1);
    let mut from = RBig::ZERO;
    for station in stations {
        samples.push((&from + &station.root.lo) * &half);
        from.clone_from(&station.root.hi);
    }
    samples.push(if strand.is_bounded() { (from + RBig::ONE) * half } else { from * RBig::from(2) + RBig::ONE });
    samples
}

/// The type at a rational t that is no station.
fn type_at(strand: &Strand, t: &RBig) -> LinearType {
    let b = strand.swing.sign_at(t);
    if strand.is_circle() {
        return Signs::transverse_type(b);
    }
    Signs { b, c: strand.zero.sign_at(t), discriminant: strand.collision.sign_at(t) }.linear_type()
}
