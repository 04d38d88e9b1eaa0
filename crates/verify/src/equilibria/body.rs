//! The body of a document, exact.

use dashu_ratio::RBig;

use crate::Refused;
use crate::numbers::number;
use bifdiag_schema::BodyDocument;

/// A and r as the document writes them.
pub(crate) struct Body {
    pub moments: [RBig; 3],
    pub center: [RBig; 3],
}

impl Body {
    pub fn read(document: &BodyDocument) -> Result<Self, Refused> {
        let [a1, a2, a3] = document.given.moments.each_ref().map(|text| number::given(text));
        let [r1, r2, r3] = document.given.center.each_ref().map(|text| number::given(text));
        let body = Self { moments: [a1?, a2?, a3?], center: [r1?, r2?, r3?] };
        match body.moments.iter().position(|moment| *moment <= RBig::ZERO) {
            Some(axis) => Err(Refused::Body { axis: axis + 1, value: document.given.moments[axis].clone() }),
            None => Ok(body),
        }
    }
}
