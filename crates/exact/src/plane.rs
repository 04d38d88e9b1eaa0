//! The (h, l) plane of a body: its curves by name, its cells with their classes.

use bifdiag_body::Frame;
use bifdiag_diagram::topology::Components;
use bifdiag_diagram::topology::whole_sphere;
use bifdiag_equilibria::curves::{Branch, BranchName, CurveName, IntervalId, Pole};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::Id;
use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::critical_values::{CriticalSource, CriticalValue, CriticalValueError, CriticalValues, refined};
use super::curves::{Place, order, passive_place, roots_in_interval};
use super::model::Model;
use super::ridges::Ridges;

/// Bits in which a place is separated from a cusp or pitchfork: what agrees to the last of them is the cusp itself.
const CUT_BITS: [usize; 3] = [64, 128, 320];

/// Why a point has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Open {
    /// The critical points over l cannot be isolated.
    #[error("the roots of q^4 - 4x^2 p^3 D^2, the critical points at this l, are not isolated")]
    Roots,
    /// The cusps cannot be isolated.
    #[error("the roots of 4(q'D - 2qD')p - 3(p'D - 2pD')q, the cusps, are not isolated")]
    Cusps,
    /// The sign of h against a height.
    #[error("the sign of h - h_c on the curve {curve} is not decided with {bits} bits")]
    Sign {
        /// The curve.
        curve: CurveName,
        /// The most with which it was tried; fewer where a part's principal form is rounded.
        bits: usize,
    },
    /// The latitudes on which the components between two heights begin and end.
    #[error("the order of the latitudes on which the components of U end is not decided with 4096 bits")]
    Latitudes,
    /// The curves on both sides of a point on curves.
    #[error("the order of the curves beside the point is not decided with the bits of the proof")]
    Beside,
}

/// A point of the (h, l) plane in the frame's units.
pub(super) struct Plane<'a> {
    pub model: &'a Model,
    pub frame: &'a Frame,
    ridges: Ridges<'a>,
}

/// Bounds of the cell around an energy: from the highest height below it to the lowest above it.
#[derive(Clone, Debug)]
pub(super) struct Gap {
    pub low: Option<RBig>,
    pub high: Option<RBig>,
}

impl Gap {
    pub fn around(levels: &[CriticalValue]) -> Self {
        let bounds = |sign: Sign| {
            levels.iter().filter(move |level| level.sign == sign).filter_map(|level| level.height.exact_bounds())
        };
        Self {
            low: bounds(Sign::Positive).map(|[_, hi]| hi).max(),
            high: bounds(Sign::Negative).map(|[lo, _]| lo).min(),
        }
    }
}

impl<'a> Plane<'a> {
    pub fn new(model: &'a Model, frame: &'a Frame) -> Self {
        Self { model, frame, ridges: Ridges::of(model) }
    }

    /// The components of U_hl in a cell over x.
    pub fn class(&self, x: &RBig, gap: &Gap) -> Result<Components, Open> {
        // Places in the cell: should two latitudes agree at one of them, they do not at the next.
        const PLACES: [[u8; 2]; 4] = [[1, 2], [3, 8], [5, 9], [7, 11]];
        let (low, high) = match (&gap.low, &gap.high) {
            (None, _) => return Ok(Vec::new()),
            (_, None) => return Ok(vec![whole_sphere(!self.model.active.is_empty())]),
            (Some(low), Some(high)) => (low, high),
        };
        let width = high - low;
        let at = |[p, q]: [u8; 2]| rounded(low + &width * RBig::from_parts(p.into(), q.into()), &width);
        PLACES.into_iter().find_map(|place| self.ridges.components(x, &at(place))).ok_or(Open::Latitudes)
    }

    /// Why a point has no answer, with the name of the curve.
    pub fn open(&self, none: CriticalValueError, x: &RBig) -> Open {
        match none {
            CriticalValueError::Roots => Open::Roots,
            CriticalValueError::Sign(source) => {
                Open::Sign { curve: self.name(&source, x), bits: CriticalValues::most_bits(self.model) }
            }
        }
    }

    /// The name of the curve through something at x.
    pub fn name(&self, source: &CriticalSource, x: &RBig) -> CurveName {
        let on = |branch, piece| CurveName::on(BranchName::of(self.frame, branch), piece);
        match source {
            CriticalSource::Generic { number, place } => {
                on(Branch::Generic(IntervalId::at(*number)), 1 + self.cuts_before(*number, place))
            }
            CriticalSource::Over { group, place } => {
                let (r_sum, p_sum) = self.model.known_sums(*group);
                let turn = r_sum * RBig::from(-3) / self.model.a(*group) - p_sum;
                let beyond = turn > RBig::ZERO && self.is_before(&Place::exact(place.half, turn), place);
                on(Branch::Symmetric(self.model.axis[*group]), 1 + usize::from(beyond))
            }
            CriticalSource::Line(pole) if self.model.active.len() == 1 => {
                on(Branch::Axis(*pole), 1 + self.forks_before(*pole, x))
            }
            CriticalSource::Line(pole) => CurveName::Pole(*pole),
            CriticalSource::Euler { group } => on(Branch::Symmetric(self.model.axis[*group]), 1),
        }
    }

    /// Cusps and pitchforks before a place on an interval of the generic family.
    fn cuts_before(&self, number: usize, place: &Place) -> usize {
        let cusps =
            roots_in_interval(self.model, &self.model.known_cusp_polynomial(), number, CUT_BITS[0]).unwrap_or_default();
        let cusps = cusps.into_iter().filter(|(_, odd)| *odd).map(|(place, _)| place);
        let forks = self.model.passive.iter().filter_map(|&group| passive_place(self.model, number, group));
        cusps.chain(forks).filter(|cut| self.is_before(cut, place)).count()
    }

    /// A cusp or pitchfork is passed before a place of its family.
    fn is_before(&self, cut: &Place, place: &Place) -> bool {
        let order = |bits| order(self.model, &refined(cut, bits), &refined(place, bits));
        CUT_BITS.into_iter().find_map(order) == Some(std::cmp::Ordering::Less)
    }

    /// Pitchforks of the line γ = ±r̂ below x: x = a²r/(2|a_k − a|) there.
    fn forks_before(&self, pole: Pole, x: &RBig) -> usize {
        let axis = self.model.active[0];
        let a = self.model.a(axis);
        let square = a * a * a * a * &self.model.r2;
        let passed = |&&group: &&usize| {
            let d = self.model.difference(group, axis) * RBig::from(2) * x;
            (group > axis) == (pole == Pole::Plus) && square < &d * &d
        };
        self.model.passive.iter().filter(passed).count()
    }
}

/// A number with few bits, less than a sixteenth of `room` from this one.
pub(super) fn rounded(value: RBig, room: &RBig) -> RBig {
    // A power of two, at most a sixteenth of the room and more than a 64th.
    let up = room.denominator().bit_len() + 5;
    let down = room.numerator().bit_len();
    let power = |bits: usize| RBig::from(IBig::ONE << bits);
    let grid = if up > down { RBig::ONE / power(up - down) } else { power(down - up) };
    let steps: IBig = (value / &grid).round();
    RBig::from(steps) * grid
}
