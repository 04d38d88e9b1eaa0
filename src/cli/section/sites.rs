//! Where sections are wanted: one point of a body, or the samples of an atlas.

use std::path::Path;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_documents::Subject;
use bifdiag_exact::Accuracy;

use super::arguments::SectionArguments;
use super::error::SectionInput;
use crate::cli::input::read;

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
        let point = [("--h", arguments.energy.is_some()), ("--l", arguments.momentum.is_some())];
        let point = || point.into_iter().filter(|(_, given)| *given).map(|(option, _)| option);
        if let Some(path) = &arguments.atlas {
            return match arguments.body.given().chain(point()).next() {
                Some(option) => Err(SectionInput::AtlasAnd { option }),
                None => Self::of_file(path, arguments.region.as_deref().unwrap_or(ALL)),
            };
        }
        let subject = arguments.body.subject()?;
        if let Some(region) = &arguments.region {
            return match point().next() {
                Some(option) => Err(SectionInput::RegionAnd { option }),
                None => Self::of_body(subject, region),
            };
        }
        let missing = |missing, example| SectionInput::NoPoint { missing, example };
        let h = arguments.energy.clone().ok_or(missing("--h", "the energy, such as --h 4.45"))?;
        let l = arguments.momentum.clone().ok_or(missing("--l", "the momentum, such as --l 3.25"))?;
        Ok(Self { subject, list: vec![Site { region: None, h, l }], all: false })
    }

    /// The samples of a body's own atlas.
    fn of_body(subject: Subject, wanted: &str) -> Result<Self, SectionInput> {
        let atlas = bifdiag_exact::atlas(&subject.body, Accuracy::Exact).map_err(SectionInput::NoAtlas)?;
        let samples = atlas.regions().ids().map(|region| {
            let sample = atlas.sample(region);
            (region.to_string(), sample.h, sample.l)
        });
        let list = chosen(samples.collect(), wanted)?;
        Ok(Self { subject, list, all: wanted == ALL })
    }

    /// The samples of an atlas.json.
    fn of_file(path: &Path, wanted: &str) -> Result<Self, SectionInput> {
        let text = read(path).map_err(|source| SectionInput::AtlasFile { path: path.to_owned(), source })?;
        let atlas = bifdiag_documents::reading::atlas(&text, &path.to_string_lossy())
            .map_err(|source| SectionInput::NotAnAtlas { path: path.to_owned(), source })?;
        let body = Body::parse(&atlas.body.given.moments, &atlas.body.given.center)
            .map_err(|source| SectionInput::AtlasBody { path: path.to_owned(), source })?;
        // Names of files are made of them.
        for region in &atlas.regions {
            region
                .id
                .parse::<RegionId>()
                .map_err(|source| SectionInput::AtlasRegion { path: path.to_owned(), source })?;
        }
        let subject = Subject { body, part: atlas.body.part };
        let samples = atlas.regions.into_iter().map(|region| (region.id, region.sample.h, region.sample.l));
        let list = chosen(samples.collect(), wanted)?;
        Ok(Self { subject, list, all: wanted == ALL })
    }
}

/// What `--region` says for every region.
pub const ALL: &str = "all";

/// The wanted ones of regions with their samples.
fn chosen(samples: Vec<(String, f64, f64)>, wanted: &str) -> Result<Vec<Site>, SectionInput> {
    let known: Vec<String> = samples.iter().map(|(id, ..)| id.clone()).collect();
    let chosen = samples.into_iter().filter(|(id, ..)| wanted == ALL || wanted == id);
    // The samples of an atlas are finite.
    let site = |(id, h, l)| {
        let [h, l] = [h, l].map(Number::from_f64);
        Some(Site { region: Some(id), h: h.ok()?, l: l.ok()? })
    };
    let list: Vec<Site> = chosen.filter_map(site).collect();
    if list.is_empty() {
        return Err(SectionInput::UnknownRegion { region: wanted.to_owned(), known });
    }
    Ok(list)
}
