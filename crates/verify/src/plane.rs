//! The (h, l) plane in the units of a document, with the height of every curve over any l.

use std::cell::RefCell;
use std::collections::BTreeMap;

use dashu_ratio::RBig;
use schema::CertificateDocument;

use super::interval::Interval;
use super::orders::Orders;
use super::pieces::{Branch, End};
use super::trace::Traces;
use super::{Refused, number};

/// A point of a picture is one of a curve to this share of the energies there, and of l.
pub(super) const POINT: f64 = 1e-9;

/// What was asked before, by the curve and the bits of l.
type Known = BTreeMap<(usize, u64), Option<[f64; 2]>>;

/// Units of l² and of energy, and the curves.
pub(super) struct Plane<'a> {
    orders: &'a Orders<'a>,
    pub traces: Traces,
    /// The units of l²/2 and of energy.
    pub x: f64,
    pub energy: f64,
    /// |r|.
    pub norm: f64,
    known: RefCell<Known>,
}

/// The tangent of a curve at a point next to some x.
pub(super) struct Near {
    /// There over x itself.
    pub h: Interval,
    pub j: Interval,
    /// How far a double may be from h.
    pub room: f64,
}

impl<'a> Plane<'a> {
    pub fn new(certificate: &CertificateDocument, orders: &'a Orders) -> Result<Self, Refused> {
        let [moment, energy] = [number::read(&certificate.units.moment)?, number::read(&certificate.units.energy)?];
        let x = (moment * &energy * RBig::from(2)).to_f64().value();
        let energy = energy.to_f64().value();
        let norm = orders.spaces.norm.to_f64() * energy;
        let traces = Traces::new(orders.spaces, orders.pieces)?;
        Ok(Self { orders, traces, x, energy, norm, known: RefCell::default() })
    }

    /// l of an x.
    pub fn momentum(&self, x: &RBig) -> f64 {
        (x.to_f64().value() * self.x).sqrt()
    }

    /// The height of a curve over l, and how far a double may be from it; `None` where a curve of a family does not run (a line
    /// goes on beyond its ends).
    pub fn height(&self, id: &str, l: f64) -> Option<[f64; 2]> {
        let curve = match self.orders.pieces.find(id) {
            Ok(curve) => curve,
            Err(_) => self.line_over(id == "P+", l)?,
        };
        *self.known.borrow_mut().entry((curve, l.to_bits())).or_insert_with(|| self.over(curve, l))
    }

    fn over(&self, curve: usize, l: f64) -> Option<[f64; 2]> {
        let near = self.near(curve, l * l / self.x)?;
        Some([near.h.middle() * self.energy, 2.0 * near.room * self.energy])
    }

    /// A curve over x, in the units of the certificate; `None` where doubles do not tell it well.
    pub fn near(&self, curve: usize, x: f64) -> Option<Near> {
        let over = self.traces.over(curve, x)?;
        let aside = Interval::point(x) - over.x;
        let h = over.h + aside * over.j.recip();
        let room = POINT * (h.middle().abs() + self.norm / self.energy) + f64::MIN_POSITIVE;
        let is_near = aside.ends().iter().all(|end| end.abs() <= POINT * x + f64::MIN_POSITIVE);
        (is_near && h.radius() <= room).then_some(Near { h, j: over.j, room })
    }

    /// A pole line that runs on critical lines has the height of any of them.
    fn line_over(&self, plus: bool, l: f64) -> Option<usize> {
        let (spaces, pieces) = (self.orders.spaces, self.orders.pieces);
        let x = l * l / self.x;
        let reach = |curve: usize, side: usize| match pieces.list[curve].ends[side] {
            End::Origin => Some(0.0),
            End::Infinity => Some(f64::INFINITY),
            _ => Some(pieces.end_x(spaces, curve, side).ok()??.to_f64()),
        };
        let mut lines = (0..pieces.list.len()).filter(|&c| pieces.list[c].branch == Branch::Line(plus));
        lines.find(|&c| reach(c, 0).zip(reach(c, 1)).is_some_and(|(from, to)| from <= x && x <= to))
    }
}
