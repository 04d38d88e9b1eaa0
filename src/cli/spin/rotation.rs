//! The rotation that an axis means.

use documents::Subject;
use numbers::vector::{cross, dot, norm};
use schema::NearestAxisDocument;
use top::permanent::{NearestAxis, PermanentAxis, nearest_permanent, permanent_axis};

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
        let document = |v: [f64; 3], angle: f64, omega: Option<f64>| NearestAxisDocument {
            axis: from_principal(part, v),
            angle_deg: angle.to_degrees(),
            spin: omega.map(|omega| documents::spin(omega * second(part))),
        };
        if let Some(axis) = permanent_axis(&subject.body, direction) {
            let angle = libm::atan2(norm(cross(axis.direction, direction)), dot(axis.direction, direction));
            if angle <= MEANT {
                return Self::Permanent { axis, nearest: document(axis.direction, angle, None) };
            }
        }
        let Some(axis) = nearest_permanent(&subject.body, direction) else { return Self::Unknown };
        let nearest = document(axis.axis, axis.angle, axis.omega());
        match axis.squared_spin {
            _ if axis.angle.is_nan() => Self::Unknown,
            _ if axis.angle > MEANT => Self::Other { nearest },
            Some(_) => Self::AtOneSpin { axis, nearest },
            None => Self::Principal,
        }
    }
}
