//! Where sections are wanted: one point of a body, or the samples of an atlas.

use std::path::Path;

use schema::AtlasDocument;
use top::body::{Body, Number};

use super::arguments::SectionArguments;
use super::error::SectionInputError;
use crate::cli::failure::InputError;
use crate::cli::files::read;
use crate::cli::subject::Subject;

/// A point at which a section is wanted.
#[derive(Clone, Debug)]
pub struct Site {
    /// The region of the atlas that has it as its sample.
    pub region: Option<String>,
    pub h: Number,
    pub l: Number,
}

/// A body and its points.
#[derive(Clone, Debug)]
pub struct Sites {
    pub subject: Subject,
    pub list: Vec<Site>,
    /// All regions were asked for: those without a section are passed over.
    pub all: bool,
}

impl Sites {
    /// Of the options.
    pub fn new(arguments: &SectionArguments) -> Result<Self, InputError> {
        if let Some(path) = &arguments.atlas {
            return Ok(Self::of_atlas(arguments, path)?);
        }
        if arguments.region.is_some() {
            return Err(SectionInputError::RegionWithoutAtlas.into());
        }
        let subject = arguments.body.subject()?;
        let missing = |missing, example| SectionInputError::NoPoint { missing, example };
        let h = arguments.energy.clone().ok_or(missing("--h", "the energy, such as --h 4.45"))?;
        let l = arguments.momentum.clone().ok_or(missing("--l", "the momentum, such as --l 3.25"))?;
        Ok(Self { subject, list: vec![Site { region: None, h, l }], all: false })
    }

    fn of_atlas(arguments: &SectionArguments, path: &Path) -> Result<Self, SectionInputError> {
        let body = &arguments.body;
        let given = [
            ("--A", body.moments.is_some()),
            ("--r", body.center.is_some()),
            ("--body", body.body.is_some()),
            ("--inertia", body.inertia.is_some()),
            ("--com", body.com.is_some()),
            ("--mass", body.mass.is_some()),
            ("--g", body.gravity.is_some()),
            ("--h", arguments.energy.is_some()),
            ("--l", arguments.momentum.is_some()),
        ];
        if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
            return Err(SectionInputError::AtlasAnd { option });
        }
        let text = read(path).map_err(|source| SectionInputError::AtlasFile { path: path.to_owned(), source })?;
        let atlas: AtlasDocument = serde_json::from_str(&text)
            .map_err(|source| SectionInputError::NotAnAtlas { path: path.to_owned(), source })?;
        let moments = Body::parse(&atlas.body.moments, &atlas.body.center)
            .map_err(|source| SectionInputError::AtlasBody { path: path.to_owned(), source })?;
        let subject = Subject { body: moments, inertia: atlas.body.inertia };
        let wanted = arguments.region.as_deref().filter(|region| *region != "all");
        let known: Vec<String> = atlas.regions.iter().map(|region| region.id.clone()).collect();
        let mut list = Vec::new();
        for region in atlas.regions {
            if wanted.is_none_or(|wanted| wanted == region.id) {
                // The samples of an atlas are finite.
                if let (Ok(h), Ok(l)) = (Number::from_f64(region.sample.h), Number::from_f64(region.sample.l)) {
                    list.push(Site { region: Some(region.id), h, l });
                }
            }
        }
        match wanted {
            Some(region) if list.is_empty() => {
                Err(SectionInputError::UnknownRegion { region: region.to_owned(), known })
            }
            _ => Ok(Self { subject, list, all: wanted.is_none() }),
        }
    }
}
