//! The rotation that an axis means.

use bifdiag_documents::Subject;
use bifdiag_equilibria::permanent::{NearestAxis, PermanentAxis, angle_between, nearest_permanent, permanent_axis};
use bifdiag_schema::NearestAxisDocument;

use super::direction::{from_principal, second, to_principal};

/// An axis nearer to a permanent one than this, in radians, is that axis: directions are given with some digits.
pub const MEANT: f64 = 1e-6;

/// What an axis is.
pub enum Axis {
    /// Permanent at every spin, and how far it is from the one given.
    Permanent { axis: PermanentAxis, nearest: NearestAxisDocument },
    /// Permanent at one spin, or with the other end up.
    AtOneSpin { axis: NearestAxis, nearest: NearestAxisDocument },
    /// Principal, but the centre of mass lies beside it: permanent at no spin.
    Principal,
    /// Permanent at no spin; the nearest one that is.
    Other { nearest: NearestAxisDocument },
    /// Not found within the range of `f64`.
    Unknown,
}

impl Axis {
    /// The axis of a direction that points up, in the frame of the question.
    pub fn of(subject: &Subject, up: [f64; 3]) -> Self {
        let part = subject.part.as_ref();
        let direction = to_principal(part, up);
        let document = |v: [f64; 3], angle: f64, squared_spin: Option<f64>| NearestAxisDocument {
            axis: from_principal(part, v),
            angle_deg: angle.to_degrees(),
            spin: squared_spin.map(|s| bifdiag_documents::spin(s.abs().sqrt() * second(part))),
            up: squared_spin.filter(|s| *s != 0.0).map(|s| end_up(s).to_owned()),
        };
        if let Some(axis) = permanent_axis(&subject.body, direction) {
            let angle = angle_between(axis.direction, direction);
            if angle <= MEANT {
                return Self::Permanent { axis, nearest: document(axis.direction, angle, None) };
            }
        }
        let Some(axis) = nearest_permanent(&subject.body, direction) else { return Self::Unknown };
        let nearest = document(axis.axis, axis.angle, axis.squared_spin);
        match axis.squared_spin {
            Some(s) if !s.is_finite() => Self::Unknown,
            _ if axis.angle.is_nan() => Self::Unknown,
            _ if axis.angle > MEANT => Self::Other { nearest },
            Some(_) => Self::AtOneSpin { axis, nearest },
            None => Self::Principal,
        }
    }
}

/// The end of an axis of Staude's cone that is up, by ±Ω².
pub fn end_up(squared_spin: f64) -> &'static str {
    if squared_spin < 0.0 { "-axis" } else { "+axis" }
}
