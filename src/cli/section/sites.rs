//! Where sections are wanted: one point of a body, or the samples of an atlas.

use std::path::Path;

use schema::AtlasDocument;
use top::body::{Body, Number};

use super::arguments::SectionArguments;
use super::error::SectionInput;
use crate::cli::input::{Subject, read};

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
    pub fn new(arguments: &SectionArguments) -> Result<Self, SectionInput> {
        if let Some(path) = &arguments.atlas {
            return Self::of_atlas(arguments, path);
        }
        if arguments.region.is_some() {
            return Err(SectionInput::RegionWithoutAtlas);
        }
        let subject = arguments.body.subject()?;
        let missing = |missing, example| SectionInput::NoPoint { missing, example };
        let h = arguments.energy.clone().ok_or(missing("--h", "the energy, such as --h 4.45"))?;
        let l = arguments.momentum.clone().ok_or(missing("--l", "the momentum, such as --l 3.25"))?;
        Ok(Self { subject, list: vec![Site { region: None, h, l }], all: false })
    }

    fn of_atlas(arguments: &SectionArguments, path: &Path) -> Result<Self, SectionInput> {
        let point = [("--h", arguments.energy.is_some()), ("--l", arguments.momentum.is_some())];
        let point = point.into_iter().filter(|(_, given)| *given).map(|(option, _)| option);
        if let Some(option) = arguments.body.given().chain(point).next() {
            return Err(SectionInput::AtlasAnd { option });
        }
        let text = read(path).map_err(|source| SectionInput::AtlasFile { path: path.to_owned(), source })?;
        let atlas: AtlasDocument =
            serde_json::from_str(&text).map_err(|source| SectionInput::NotAnAtlas { path: path.to_owned(), source })?;
        let moments = Body::parse(&atlas.body.moments, &atlas.body.center)
            .map_err(|source| SectionInput::AtlasBody { path: path.to_owned(), source })?;
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
            Some(region) if list.is_empty() => Err(SectionInput::UnknownRegion { region: region.to_owned(), known }),
            _ => Ok(Self { subject, list, all: wanted.is_none() }),
        }
    }
}
