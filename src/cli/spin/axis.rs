//! Axes as they are given, and as they are named in answers.

use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::Multiplicity;
use bifdiag_equilibria::permanent::{FOLLOWED, permanent_multiplicity, principal_at};
use bifdiag_schema::NearestAxisDocument;

use crate::cli::failure::Failure;
use crate::cli::input::values::{self, Triple};
use crate::cli::terminal::{significant, told_apart};

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
    let text = text.trim();
    let given = values::triple(match text.strip_prefix('+').unwrap_or(text) {
        "x" => "1,0,0",
        "y" => "0,1,0",
        "z" => "0,0,1",
        "-x" => "-1,0,0",
        "-y" => "0,-1,0",
        "-z" => "0,0,-1",
        _ => text,
    })
    .map_err(|error| Failure::input(format!("{error}; or write x, y or z")))?;
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
}

/// What holds of an axis through the centre of mass that is not principal.
pub fn rests(axis: &str) -> String {
    format!("the body rests with either end up, but rotation about {axis} is steady at no spin")
}

/// A direction of length 1 as it is printed, without what rounding left of a 0.
pub fn listed(axis: [f64; 3]) -> String {
    let component = |x: f64| if x.abs() < 4.0 * f64::EPSILON { 0.0 } else { x };
    format!("({})", axis.map(|x| significant(component(x), 6)).join(", "))
}

/// Names the axes (in principal axes) that are as near as the reported one; `None` if there are none.
pub fn as_near(subject: &Subject, others: &[[f64; 3]]) -> Option<String> {
    let axes: Vec<String> = others.iter().map(|axis| listed(subject.to_given(*axis))).collect();
    (!axes.is_empty()).then(|| format!("equally near: {}", axes.join(", ")))
}

/// Degrees between an axis and the one that it is near to, told apart from those within which it would be followed.
pub fn angle_text(degrees: f64) -> String {
    let [_, angle] = told_apart([FOLLOWED.to_degrees(), degrees], 3);
    angle
}

/// Says which permanent axis is followed instead of the given one.
pub fn followed_text(nearest: &NearestAxisDocument) -> String {
    let angle = angle_text(nearest.angle_deg);
    format!("following the nearest permanent axis, {}, {angle}° from the one given", listed(nearest.axis))
}

/// Says whether a permanent axis is one of a circle or sphere of them.
pub fn one_of(subject: &Subject, axis: [f64; 3]) -> Option<&'static str> {
    match permanent_multiplicity(&subject.body, subject.to_principal(axis))? {
        Multiplicity::Points(_) => None,
        Multiplicity::Circle => Some("it is one of a circle of permanent axes, which are judged as a whole"),
        Multiplicity::Sphere => Some("rotation about every axis is permanent"),
    }
}

/// Without weight: the permanent axes at an angle in degrees from an axis, in the frame of the question.
pub fn principal_near(subject: &Subject, axis: [f64; 3], angle_deg: f64) -> Vec<[f64; 3]> {
    let found = principal_at(&subject.body, subject.to_principal(axis), angle_deg.to_radians());
    found.into_iter().map(|axis| subject.to_given(axis)).collect()
}
