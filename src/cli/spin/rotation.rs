//! The rotation that an axis means.

use documents::Subject;
use numbers::Sign;
use schema::NearestAxisDocument;
use top::body::BodyAxis;
use top::permanent::{AxisRotation, nearest_axis, nearest_permanent, permanent_axes};

use super::direction::{from_principal, second, to_principal};

/// An axis nearer to a principal one than this, in radians, is that axis: directions are given with some digits.
pub const MEANT: f64 = 1e-6;

/// What an axis is.
pub enum Axis {
    /// The principal axis of this number with this sign, permanent at every spin, and how far it is from the one given.
    Permanent { axis: BodyAxis, sign: Sign, nearest: NearestAxisDocument },
    /// None; the nearest one.
    Other { nearest: NearestAxisDocument },
}

impl Axis {
    /// The axis of a direction that points up, in the frame of the question.
    pub fn of(subject: &Subject, up: [f64; 3]) -> Self {
        let part = subject.part.as_ref();
        let direction = to_principal(part, up);
        let (axis, cosine) = nearest_axis(direction);
        let angle = angle_to_axis(direction, axis);
        let sign = if cosine < 0.0 { Sign::Negative } else { Sign::Positive };
        let document = |v: [f64; 3], angle: f64, omega: Option<f64>| NearestAxisDocument {
            axis: from_principal(part, v),
            angle_deg: angle.to_degrees(),
            spin: omega.map(|omega| documents::spin(omega * second(part))),
        };
        let unit = |axis: BodyAxis| BodyAxis::ALL.map(|k| if k == axis { f64::from(sign) } else { 0.0 });
        let permanent = permanent_axes(&subject.body);
        if permanent.contains(&axis) && angle <= MEANT {
            return Self::Permanent { axis, sign, nearest: document(unit(axis), angle, None) };
        }
        if subject.body.flags().euler {
            return Self::Other { nearest: document(unit(axis), angle, None) };
        }
        let found = nearest_permanent(subject.body.moments_f64(), subject.body.center_f64(), direction);
        Self::Other { nearest: document(found.axis, found.angle, found.omega) }
    }
}

/// The rotation about a permanent axis with its end of this sign up.
pub fn rotation(subject: &Subject, axis: BodyAxis, sign: Sign) -> Option<AxisRotation> {
    // γ points down.
    AxisRotation::new(&subject.body, axis, -sign)
}

/// The angle between a direction and an axis, also when it is small.
fn angle_to_axis(direction: [f64; 3], axis: BodyAxis) -> f64 {
    let [i, j] = axis.others();
    let across = (direction[i] * direction[i] + direction[j] * direction[j]).sqrt();
    libm::atan2(across, direction[axis].abs())
}
