//! Axes of questions, and the rotations that they mean.

use bifdiag_body::Body;
use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::{Multiplicity, Place, SteadyFamily, SteadyStretch};
use bifdiag_equilibria::permanent::{NearestAxis, PermanentAxis, angle_between, nearest_permanent, permanent_axis};
use bifdiag_numbers::vector::{dot, norm, normalised};
use bifdiag_schema::NearestAxisDocument;
use dashu_ratio::RBig;

use crate::cli::failure::Failure;
use crate::cli::input::values::{self, Triple};
use crate::cli::terminal::significant;

/// An axis nearer to a permanent one than this, in radians, is that axis: directions are given with some digits.
pub const MEANT: f64 = 1e-6;

/// Half a degree, in radians: an axis that misses a permanent one by less stands for it where changes over the spin are asked
/// for, since only a permanent axis has them.
const FOLLOWED: f64 = std::f64::consts::PI / 360.0;

/// x, y, z or three coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisArgument {
    /// Of length 1.
    pub direction: [f64; 3],
    /// As it was given.
    pub given: Triple,
}

/// Reads a direction; its length does not matter.
pub fn axis(text: &str) -> Result<AxisArgument, Failure> {
    let given = values::triple(match text.strip_prefix('+').unwrap_or(text) {
        "x" => "1,0,0",
        "y" => "0,1,0",
        "z" => "0,0,1",
        "-x" => "-1,0,0",
        "-y" => "0,-1,0",
        "-z" => "0,0,-1",
        _ => text,
    })?;
    Ok(AxisArgument { direction: values::to_direction(given.rounded())?, given })
}

impl AxisArgument {
    /// The axis through the centre of mass.
    pub fn of_the_centre_of_mass(subject: &Subject) -> Result<Self, Failure> {
        let center = match &subject.part {
            Some(part) => part.com.join(","),
            None => subject.body.center().each_ref().map(bifdiag_body::Number::text).join(","),
        };
        axis(&center)
    }

    /// The direction in principal axes; exact without a part.
    pub fn in_principal_axes(&self, subject: &Subject) -> [RBig; 3] {
        if subject.part.is_none() {
            return self.given.values();
        }
        subject.to_principal(self.given.rounded()).map(|x| RBig::try_from(x).unwrap_or_default())
    }
}

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
        let direction = subject.to_principal(up);
        if let Some(found) = Self::permanent(subject, direction, MEANT) {
            return found;
        }
        let Some(axis) = nearest_permanent(&subject.body, direction) else { return Self::Unknown };
        let nearest = near(subject, axis.axis, axis.angle, axis.squared_spin);
        match axis.squared_spin {
            Some(s) if !s.is_finite() => Self::Unknown,
            _ if axis.angle.is_nan() => Self::Unknown,
            _ if axis.angle > MEANT => Self::Other { nearest },
            Some(_) => Self::AtOneSpin { axis, nearest },
            None => Self::Principal,
        }
    }

    /// The same, where a permanent axis within half a degree is followed in place of the one given.
    pub fn followed(subject: &Subject, up: [f64; 3]) -> Self {
        Self::permanent(subject, subject.to_principal(up), FOLLOWED).unwrap_or_else(|| Self::of(subject, up))
    }

    /// The axis that is permanent at every spin, if one is as near as `within` to a direction in principal axes.
    fn permanent(subject: &Subject, direction: [f64; 3], within: f64) -> Option<Self> {
        let axis = permanent_axis(&subject.body, direction)?;
        let angle = angle_between(axis.direction, direction);
        let nearest = near(subject, axis.direction, angle, None);
        (angle <= within).then_some(Self::Permanent { axis, nearest })
    }
}

/// An axis near the one of the question.
fn near(subject: &Subject, axis: [f64; 3], angle: f64, squared_spin: Option<f64>) -> NearestAxisDocument {
    NearestAxisDocument {
        axis: subject.to_given(axis),
        angle_deg: angle.to_degrees(),
        spin: squared_spin.map(|s| bifdiag_documents::spin(s.abs().sqrt() * subject.second())),
        up: squared_spin.filter(|s| *s != 0.0).map(|s| end_up(s).to_owned()),
    }
}

/// The end of an axis of Staude's cone that is up, by ±Ω².
pub fn end_up(squared_spin: f64) -> &'static str {
    if squared_spin < 0.0 { "-axis" } else { "+axis" }
}

/// The axes of families at fast spins, in the frame of the question, as a list.
pub fn fast_axes(subject: &Subject, families: &[SteadyFamily]) -> String {
    let axis = |family: &SteadyFamily| listed(subject.to_given(family.fast.map(|x| 0.0 - x)));
    families.iter().map(axis).collect::<Vec<_>>().join(" and ")
}

/// A direction as it is printed.
pub fn listed(axis: [f64; 3]) -> String {
    format!("({})", axis.map(|x| significant(x, 6)).join(", "))
}

/// What is said of a permanent axis that is followed in place of the given one.
pub fn followed_text(nearest: &NearestAxisDocument) -> String {
    let angle = significant(nearest.angle_deg, 3);
    format!("the nearest permanent axis, {}, {angle}° from the one given, is followed", listed(nearest.axis))
}

/// Without weight: the permanent axes at an angle in degrees from a direction, of each circle of them the one nearest to it.
pub fn principal_at(subject: &Subject, given: [f64; 3], angle_deg: f64) -> Vec<[f64; 3]> {
    /// Angles that differ by less, in degrees, are the same.
    const TIE: f64 = 1e-9;
    let (direction, moments) = (subject.to_principal(given), subject.body.moments());
    let firsts = (0..3).filter(|&i| moments.iter().position(|moment| moment == &moments[i]) == Some(i));
    let nearest = firsts.filter_map(|i| {
        let part: [f64; 3] = std::array::from_fn(|k| if moments[k] == moments[i] { direction[k] } else { 0.0 });
        let length = norm(part);
        (length > 0.0).then(|| subject.to_given(part.map(|x| x / length)))
    });
    let angle = |axis: &[f64; 3]| {
        let angle = angle_between(*axis, given).to_degrees();
        angle.min(180.0 - angle)
    };
    nearest.filter(|axis| (angle(axis) - angle_deg).abs() < TIE).collect()
}

/// The families whose axes are nearest to a direction that points up, at fast spins: several if they are equally near, none if
/// all of them lie across it. Of a symmetric pair the one on that side, of a circle the nearest.
pub fn fastest_along(body: &Body, families: &[SteadyFamily], up: [f64; 3]) -> Vec<SteadyFamily> {
    /// Cosines that differ by less are the same.
    const TIE: f64 = 1e-9;
    // γ points down; a pair has both ends, a circle all directions of its plane.
    let along = |family: &SteadyFamily| match family.axes {
        Multiplicity::Circle | Multiplicity::Sphere => norm(in_plane_of(body, family, up)),
        Multiplicity::Points(1) => -dot(family.fast, up),
        Multiplicity::Points(_) => dot(family.fast, up).abs(),
    };
    let most = families.iter().map(along).fold(0.0, f64::max);
    let nearest = families.iter().filter(|family| most > TIE && along(family) > most - TIE).cloned();
    let on_that_side = |family: SteadyFamily| match family.axes {
        Multiplicity::Circle => {
            let down = normalised(in_plane_of(body, &family, up)).map(|x| 0.0 - x);
            let from = family.fast;
            moved(family, |gamma| {
                let share = dot(gamma, from);
                std::array::from_fn(|k| gamma[k] + share * (down[k] - from[k]))
            })
        }
        Multiplicity::Points(2) if dot(family.fast, up) > 0.0 => mirrored(family),
        _ => family,
    };
    nearest.map(on_that_side).collect()
}

/// The share of a direction in the plane of the moments that are equal to that of a family at fast spins.
fn in_plane_of(body: &Body, family: &SteadyFamily, up: [f64; 3]) -> [f64; 3] {
    let moments = body.moments().each_ref().map(bifdiag_body::Number::value);
    let own = largest(family.fast);
    std::array::from_fn(|k| if moments[k] == moments[own] { up[k] } else { 0.0 })
}

fn largest(v: [f64; 3]) -> usize {
    v.iter().enumerate().max_by(|p, q| p.1.abs().total_cmp(&q.1.abs())).map_or(0, |(k, _)| k)
}

/// The other one of a symmetric pair, reflected in the principal plane from which both come: across it both are farthest apart
/// at fast spins, where they tend to the two ends of a principal axis.
fn mirrored(family: SteadyFamily) -> SteadyFamily {
    let across = largest(family.fast);
    moved(family, |mut gamma| {
        gamma[across] = 0.0 - gamma[across];
        gamma
    })
}

/// The family with every γ moved.
fn moved(family: SteadyFamily, by: impl Fn([f64; 3]) -> [f64; 3]) -> SteadyFamily {
    let place = |place: Place| Place { gamma: by(place.gamma), ..place };
    let stretch = |stretch: SteadyStretch| SteadyStretch { from: stretch.from.map(place), ..stretch };
    SteadyFamily {
        slow: family.slow.map(&by),
        fast: by(family.fast),
        stretches: family.stretches.into_iter().map(stretch).collect(),
        ..family
    }
}
