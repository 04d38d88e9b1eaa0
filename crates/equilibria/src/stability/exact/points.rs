//! The relative equilibria on a family at one l or at one spin, counted exactly, with the linear type of each.

use super::body::ExactBody;
use super::profile::{Profile, StationKind, compare};
use super::strand::Strand;
use crate::stability::{Constants, LinearType, Reduced, Signs, State};
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::wide::Wide;

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
}

/// The point is the end of two curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// A cusp: a double point.
    Cusp,
    /// The pair over this axis leaves.
    Pitchfork(Axis),
}

/// Bits of the first attempt; four times as many when signs are left open, as often as it takes.
const BITS: usize = 192;

impl ExactPoint {
    /// All equilibria of a family at the roots of a polynomial in its coordinate ([`Strand::at_momentum`],
    /// [`Strand::at_spin`]), by rising number of the piece. `None` when roots are closer than 2^-4000.
    #[must_use]
    pub fn all(body: &ExactBody, strand: &Strand, profile: &Profile, condition: &Polynomial) -> Option<Vec<Self>> {
        let mut cuts: Vec<(Root, StationKind)> =
            profile.stations.iter().filter(|s| s.is_cut()).map(|s| (s.root.clone(), s.kind)).collect();
        let mut points = Vec::new();
        for mut root in strand.roots(condition)? {
            root.refine(BITS);
            let mut below = 0;
            let mut touch = None;
            for (cut, kind) in &mut cuts {
                match compare(&mut root, cut) {
                    std::cmp::Ordering::Less => break,
                    std::cmp::Ordering::Greater => below += 1,
                    std::cmp::Ordering::Equal => {
                        touch = Some(match kind {
                            StationKind::Pitchfork(axis) => Touch::Pitchfork(*axis),
                            _ => Touch::Cusp,
                        });
                        break;
                    }
                }
            }
            let mut piece = 1 + below;
            if strand.is_reversed {
                piece = 1 + cuts.len() - below - usize::from(touch.is_some());
            }
            points.push(Self::at(body, strand, root, piece, touch));
        }
        points.sort_by_key(|point| point.piece);
        Some(points)
    }

    fn at(body: &ExactBody, strand: &Strand, mut root: Root, piece: usize, touch: Option<Touch>) -> Self {
        let mut bits = BITS;
        let mut known = [None; 3];
        loop {
            let c: Constants<Wide> = body.constants(bits + 64);
            let state = strand.state(body, &c, &mut root, bits);
            let mut reduced = Reduced::new(&c, &state);
            let kind = kind(strand, &root, &mut reduced, &mut known);
            if let Some(kind) = kind {
                let index = reduced.index(state.hessian_trace(&c).sign());
                return Self { piece, touch, is_double: !root.odd, state, reduced, kind, index };
            }
            bits *= 4;
        }
    }
}

/// The type, from the signs that the enclosure tells and, for those that it leaves open, from common roots.
fn kind(
    strand: &Strand,
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
    let b = sign(0, &strand.swing);
    let c = sign(1, &strand.zero);
    let discriminant = if c == Some(Sign::Positive) { sign(2, &strand.collision) } else { Some(Sign::Positive) };
    if b == Some(Sign::Zero) {
        *reduced = reduced.clone().without_b();
    }
    if strand.is_circle() {
        return b.map(Signs::transverse_type);
    }
    // Only with c = 0 and c > 0 does b count; b = 0 < c has a negative discriminant.
    Some(Signs { b: b?, c: c?, discriminant: discriminant? }.linear_type())
}
