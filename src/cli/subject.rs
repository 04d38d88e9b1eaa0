//! The body that the options describe.

use schema::InertiaDocument;
use top::body::{Body, MassProperties, Number, Preset};

use super::arguments::BodyArguments;
use super::failure::InputError;
use super::report::Report;

/// A body, and the part from which it was computed.
#[derive(Clone, Debug)]
pub struct Subject {
    pub body: Body,
    pub inertia: Option<InertiaDocument>,
}

impl BodyArguments {
    /// The body of the options.
    pub fn subject(&self) -> Result<Subject, InputError> {
        self.optional_subject()?.ok_or(InputError::NoBody)
    }

    /// The body of the options, or `None` if none of them was given.
    pub fn optional_subject(&self) -> Result<Option<Subject>, InputError> {
        let part = [
            ("--inertia", self.inertia.is_some()),
            ("--com", self.com.is_some()),
            ("--mass", self.mass.is_some()),
            ("--g", self.gravity.is_some()),
        ];
        let ways = [
            [("--A", self.moments.is_some()), ("--r", self.center.is_some())].into_iter().find(|(_, given)| *given),
            [("--body", self.body.is_some())].into_iter().find(|(_, given)| *given),
            part.into_iter().find(|(_, given)| *given),
        ];
        let mut given = ways.into_iter().flatten().map(|(name, _)| name);
        if let (Some(first), Some(second)) = (given.next(), given.next()) {
            return Err(InputError::TwoBodies { first, second });
        }
        let subject = match (&self.moments, &self.center, &self.body) {
            (Some(_), None, _) => return Err(InputError::NoCenter),
            (None, Some(_), _) => return Err(InputError::NoMoments),
            (Some(moments), Some(center), _) => {
                // Both were validated when they were read; a body of valid halves is valid.
                Body::new(moments.0.clone(), center.0.clone()).ok().map(|body| Subject { body, inertia: None })
            }
            (None, None, Some(name)) => Preset::find(name).map(|preset| Subject { body: preset.body(), inertia: None }),
            (None, None, None) => self.part()?,
        };
        if let Some(subject) = &subject {
            subject.warn();
        }
        Ok(subject)
    }

    /// The body of a full inertia tensor.
    fn part(&self) -> Result<Option<Subject>, InputError> {
        let examples = [
            ("--inertia", "--inertia 0.30,0.21,0.17,0.01,0,-0.02 (kg m²)"),
            ("--com", "--com 0,0.02,0.15 (m)"),
            ("--mass", "--mass 2.5 (kg)"),
            ("--g", "--g 9.80665 (m/s²)"),
        ];
        let (tensor, com, mass, gravity) = match (&self.inertia, &self.com, &self.mass, &self.gravity) {
            (None, None, None, None) => return Ok(None),
            (Some(tensor), Some(com), Some(mass), Some(gravity)) => (tensor, com, mass, gravity),
            (tensor, com, mass, gravity) => {
                let there = [tensor.is_some(), com.is_some(), mass.is_some(), gravity.is_some()];
                let missing = there.iter().position(|there| !there).unwrap_or_default();
                let given = there.iter().position(|there| *there).unwrap_or_default();
                return Err(InputError::PartIncomplete {
                    given: examples[given].0,
                    missing: examples[missing].0,
                    example: examples[missing].1,
                });
            }
        };
        let part = MassProperties {
            tensor: tensor.0.clone(),
            center_of_mass: com.0.clone(),
            mass: mass.clone(),
            gravity: gravity.clone(),
        };
        let principal = part
            .to_principal_axes()
            .map_err(|source| InputError::Inertia { value: tensor.0.each_ref().map(Number::text).join(","), source })?;
        let inertia = documents::part(&part, &principal);
        Ok(Some(Subject { body: principal.body().clone(), inertia: Some(inertia) }))
    }
}

impl Subject {
    /// A and r, and how they came about.
    pub fn head(&self, report: &mut Report) {
        let join = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(", ");
        report.line(format!("A = ({})", join(self.body.moments())));
        report.line(format!("r = ({})", join(self.body.center())));
        if let Some(inertia) = &self.inertia {
            report.line("A in kg m², r in N m, h in J, l in kg m²/s; the principal axes are the columns of");
            for [x, y, z] in inertia.rotation {
                report.line(format!("  ({x:>9.6}, {y:>9.6}, {z:>9.6})"));
            }
        }
    }

    /// Warns of what is accepted but strange.
    fn warn(&self) {
        let unphysical = self.inertia.as_ref().map_or(self.body.flags().unphysical, |inertia| inertia.unphysical);
        if unphysical {
            tracing::warn!(
                "A violates the triangle inequality Ai + Aj >= Ak: no distribution of mass has these moments; \
                 the answer is that of the equations"
            );
        } else if self.inertia.as_ref().is_some_and(|inertia| !inertia.parallel_axes) {
            tracing::warn!(
                "this mass at this centre of mass alone needs larger moments than --inertia says; the tensor must be \
                 about the fixed point, not about the centre of mass"
            );
        }
    }
}
