//! Where U is drawn.

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_exact::Accuracy;

use super::arguments::SphereArguments;
use super::error::SphereError;

/// A point at which U is drawn.
pub struct Site {
    /// The region whose sample it is.
    pub region: Option<String>,
    pub h: Number,
    pub l: Number,
}

impl Site {
    /// The point of the options.
    pub fn new(arguments: &SphereArguments, subject: &Subject) -> Result<Self, SphereError> {
        if let Some(id) = &arguments.region {
            let atlas = bifdiag_exact::atlas(&subject.body, Accuracy::Exact).map_err(SphereError::Atlas)?;
            let ids = || atlas.regions().ids();
            let Some(region) = ids().find(|region| region.to_string() == *id) else {
                return Err(SphereError::UnknownRegion {
                    id: id.clone(),
                    known: ids().map(|id| id.to_string()).collect(),
                });
            };
            let sample = atlas.sample(region);
            return Ok(Self {
                region: Some(id.clone()),
                h: Number::from_f64(sample.h)?,
                l: Number::from_f64(sample.l)?,
            });
        }
        let given = |number: &Option<Number>, missing| number.clone().ok_or(SphereError::NoPoint { missing });
        Ok(Self { region: None, h: given(&arguments.energy, "--h")?, l: given(&arguments.momentum, "--l")? })
    }
}
