//! The (h, l) plane in the units of a document, with the height of every curve over any l.

use std::cell::RefCell;
use std::collections::BTreeMap;

use dashu_ratio::RBig;
use schema::{AtlasDocument, CertificateDocument};

use super::interval::Interval;
use super::orders::Orders;
use super::pieces::Branch;
use super::trace::Traces;
use super::{Refused, number};

/// A point of a picture is one of a curve to this share of the energies there, and of l.
pub(super) const POINT: f64 = 1e-9;

/// Energies below this are none: without r they begin at 0, which a double may miss.
const LEAST: f64 = 1e-50;

/// What was asked before, by the curve and the bits of l.
type Known = BTreeMap<(usize, u64), Option<Near>>;

/// Units of l² and of energy, and the curves.
pub(super) struct Plane<'a> {
    orders: &'a Orders<'a>,
    pub traces: Traces,
    /// The units of l and of energy.
    momentum: f64,
    pub energy: f64,
    /// |r|.
    pub norm: f64,
    /// The largest moment, in the units of the certificate.
    largest: f64,
    /// The pieces of the pole lines, and the x from which to which they run.
    lines: Vec<(usize, bool, [f64; 2])>,
    known: RefCell<Known>,
}

/// The tangent of a curve at a point next to some x.
#[derive(Clone, Copy)]
pub(super) struct Near {
    /// There over x itself.
    pub h: Interval,
    pub j: Interval,
    /// How far a double may be from h.
    pub room: f64,
}

impl<'a> Plane<'a> {
    pub fn new(certificate: &CertificateDocument, orders: &'a Orders) -> Result<Self, Refused> {
        let [moment, energy] = [number::unit(&certificate.units.moment)?, number::unit(&certificate.units.energy)?];
        let momentum = (moment * &energy).to_f64().value().sqrt();
        let energy = energy.to_f64().value();
        let norm = orders.spaces.norm.to_f64() * energy;
        let traces = Traces::new(orders.spaces, orders.pieces)?;
        let largest = orders.spaces.list.last().map_or(1.0, |space| space.a_set.to_f64());
        let lines = lines(orders)?;
        Ok(Self { orders, traces, momentum, energy, norm, largest, lines, known: RefCell::default() })
    }

    /// [h, l] up to which curves are drawn: 1.6 times the l of the last event, but at least thrice √(r a), at which kinetic and
    /// potential energy are alike; h = l²/2A + |r| at most where μ is largest, and |r| below 0.
    pub fn extent(&self, document: &AtlasDocument) -> [f64; 2] {
        let natural = 3.0 * self.momentum * (self.orders.spaces.norm.to_f64().max(1.0) * self.largest).sqrt();
        let l = natural.max(1.6 * document.events.last().map_or(0.0, |event| event.l));
        [self.abscissa(l) / self.largest * self.energy + 2.0 * self.norm, l]
    }

    /// l of an x.
    pub fn momentum(&self, x: &RBig) -> f64 {
        (2.0 * x.to_f64().value()).sqrt() * self.momentum
    }

    /// x = l²/2 in the units of the certificate: the square of l itself may leave the range of doubles.
    pub fn abscissa(&self, l: f64) -> f64 {
        let l = l / self.momentum;
        0.5 * l * l
    }

    /// The curve of an id that runs over l, in whose list it is; of a pole line on critical lines the one over l.
    pub fn curve(&self, id: &str, l: f64) -> Option<usize> {
        match self.orders.pieces.find(id) {
            Ok(curve) => Some(curve),
            Err(_) => self.line_over(id == "P+", l),
        }
    }

    /// The height of a curve over l, and how far a double may be from it; `None` where a curve of a family does not run (a line
    /// goes on beyond its ends).
    pub fn height(&self, id: &str, l: f64) -> Option<[f64; 2]> {
        let near = self.over(self.curve(id, l)?, l)?;
        Some([near.h.middle() * self.energy, 2.0 * near.room * self.energy])
    }

    /// A curve over l, in the units of the certificate.
    pub fn over(&self, curve: usize, l: f64) -> Option<Near> {
        *self.known.borrow_mut().entry((curve, l.to_bits())).or_insert_with(|| self.near(curve, self.abscissa(l)))
    }

    /// A curve over x, in the units of the certificate; `None` where doubles do not tell it well.
    pub fn near(&self, curve: usize, x: f64) -> Option<Near> {
        let over = self.traces.over(curve, x)?;
        let aside = Interval::point(x) - over.x;
        let h = over.h + aside * over.j.recip();
        let room = POINT * (h.middle().abs() + self.norm / self.energy) + LEAST;
        let is_near = aside.ends().iter().all(|end| end.abs() <= POINT * x + f64::MIN_POSITIVE);
        (is_near && h.radius() <= room).then_some(Near { h, j: over.j, room })
    }

    /// A pole line that runs on critical lines has the height of any of them.
    fn line_over(&self, plus: bool, l: f64) -> Option<usize> {
        let x = self.abscissa(l);
        let over = |(_, side, [from, to]): &&(usize, bool, [f64; 2])| *side == plus && *from <= x && x <= *to;
        self.lines.iter().find(over).map(|(curve, ..)| *curve)
    }
}

fn lines(orders: &Orders) -> Result<Vec<(usize, bool, [f64; 2])>, Refused> {
    let pieces = orders.pieces;
    let mut lines = Vec::new();
    for (curve, piece) in pieces.list.iter().enumerate() {
        if let Branch::Line(plus) = piece.branch {
            let [from, to] = [pieces.end_x(orders.spaces, curve, 0)?, pieces.end_x(orders.spaces, curve, 1)?];
            lines.push((curve, plus, [from.map_or(0.0, |x| x.to_f64()), to.map_or(f64::INFINITY, |x| x.to_f64())]));
        }
    }
    Ok(lines)
}
