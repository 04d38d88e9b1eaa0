//! The straight way from one body to another.

use dashu_ratio::RBig;

use bifdiag_body::{Body, Number};

/// The bodies A(t) = (1 − t) A(0) + t A(1), r likewise, with exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BodySegment {
    from: Body,
    to: Body,
}

impl BodySegment {
    /// The way between two bodies.
    #[must_use]
    pub fn new(from: Body, to: Body) -> Self {
        Self { from, to }
    }

    /// The exact value of coordinate `place` of (A1, A2, A3, r1, r2, r3) at t.
    #[must_use]
    pub fn coordinate(&self, place: usize, t: f64) -> RBig {
        // Every finite double is a fraction.
        self.exactly(place, &RBig::try_from(t).unwrap_or(RBig::ZERO))
    }

    /// The same at a fraction.
    pub(super) fn exactly(&self, place: usize, t: &RBig) -> RBig {
        let of = |body: &Body| match place {
            0..3 => body.moments()[place].value().clone(),
            _ => body.center()[place - 3].value().clone(),
        };
        let (from, to) = (of(&self.from), of(&self.to));
        &from + (to - &from) * t
    }

    /// The value of coordinate `place` at t as a double.
    #[must_use]
    pub fn value(&self, place: usize, t: f64) -> f64 {
        self.coordinate(place, t).to_f64().value()
    }

    /// The body at t between 0 and 1.
    #[must_use]
    pub fn body(&self, t: f64) -> Body {
        let number = |place| Number::from_rational(self.coordinate(place, t));
        // Between two positive moments lie positive moments only.
        Body::new([0, 1, 2].map(number), [3, 4, 5].map(number)).unwrap_or_else(|_positive| self.from.clone())
    }

    /// The largest change of a coordinate from t = 0 to t = 1.
    #[must_use]
    pub fn length(&self) -> f64 {
        let change = |place| (self.coordinate(place, 1.0) - self.coordinate(place, 0.0)).to_f64().value().abs();
        (0..6).map(change).fold(0.0, f64::max)
    }
}
