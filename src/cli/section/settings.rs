//! What the options ask for.

use std::path::{Path, PathBuf};

use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_dynamics::section::SectionCondition;
use bifdiag_plot::{Projection, Theme, Width};

use super::arguments::{ColorArgument, SectionArguments, VerdictArgument};
use super::error::{SectionFailure, SectionInput};
use super::seeds::{self, Seed};
use super::sites::{ALL, Sites};
use crate::cli::export::{DataFormat, DataTarget, PictureFormat, directory};
use crate::cli::failure::Failure;

/// Orbits of a section if nothing else is said.
const ORBITS: u32 = 24;

pub struct Settings<'a> {
    pub sites: Sites,
    pub starts: Starts<'a>,
    /// Of each orbit.
    pub crossings: usize,
    pub max_time: f64,
    pub verdict: VerdictArgument,
    pub condition: SectionCondition,
    /// Of a step of the integrator.
    pub tolerance: f64,
    pub color: ColorArgument,
    pub projection: Projection,
    pub outputs: Outputs<'a>,
}

/// Where the orbits start.
pub enum Starts<'a> {
    /// So many, spread evenly.
    Spread { orbits: usize, seed: u64 },
    /// At the points of a file.
    Given { path: &'a Path, seeds: Vec<Seed> },
}

impl Starts<'_> {
    /// Their number.
    pub fn count(&self) -> usize {
        match self {
            Self::Spread { orbits, .. } => *orbits,
            Self::Given { seeds, .. } => seeds.len(),
        }
    }
}

/// Where the results go.
pub struct Outputs<'a> {
    pub data: Option<&'a DataTarget>,
    /// For everything but the data of `--data`.
    pub directory: Option<PathBuf>,
    /// Of the pictures.
    pub formats: &'a [PictureFormat],
    pub theme: Theme,
    pub width: Width,
    pub json: bool,
    /// The sites come from an atlas, or are all regions: JSON is a list.
    pub list: bool,
}

impl Settings<'_> {
    /// The file into which crossings go as they are found: where nothing else needs them.
    pub fn streamed(&self) -> Option<(&Path, DataFormat)> {
        match self.outputs.data {
            Some(DataTarget::File { path, format })
                if self.outputs.directory.is_none()
                    && matches!(self.verdict, VerdictArgument::Only | VerdictArgument::None) =>
            {
                Some((path, *format))
            }
            _ => None,
        }
    }

    /// The data file of a site beside which its crossings are kept as they are found, and whether those of another section go.
    /// There is none where orbits end with their verdicts: these cannot be taken up again.
    pub fn resumed(&self, region: Option<&str>) -> Option<(PathBuf, bool)> {
        match (self.outputs.data, &self.outputs.directory) {
            _ if self.verdict == VerdictArgument::Early => None,
            (Some(DataTarget::File { path, .. }), _) => Some((self.file_of(path, region), false)),
            (None, Some(directory)) => Some((directory.join(format!("{}.npz", stem(region))), true)),
            _ => None,
        }
    }

    /// The data file of a site: `FILE`, or with several regions FILE-R4.npz for the region R4 of FILE.npz.
    pub fn file_of(&self, path: &Path, region: Option<&str>) -> PathBuf {
        let Some(region) = region.filter(|_| self.sites.list.len() > 1) else { return path.to_owned() };
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        path.with_file_name(format!("{stem}-{region}.{extension}"))
    }
}

/// How the names of a site's files in a directory begin.
pub fn stem(region: Option<&str>) -> String {
    region.map_or_else(|| "section".to_owned(), |region| format!("section-{region}"))
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a SectionArguments) -> Result<Self, Failure> {
        let sites = Sites::new(arguments)?;
        if sites.subject.body.flags().euler {
            return Err(SectionFailure::from(PoincareError::WeightlessBody).into());
        }
        Ok(Self {
            outputs: outputs(arguments, sites.list.len())?,
            sites,
            starts: starts(arguments)?,
            crossings: arguments.crossings.get(),
            max_time: arguments.max_time.unwrap_or(f64::INFINITY),
            verdict: verdict(arguments)?,
            condition: arguments.condition,
            tolerance: arguments.tol.unwrap_or(DEFAULT_TOLERANCE),
            color: arguments.color,
            projection: arguments.projection,
        })
    }
}

/// Who wants nothing but data wants them fast.
fn verdict(arguments: &SectionArguments) -> Result<VerdictArgument, SectionInput> {
    let color = match arguments.color {
        ColorArgument::Orbit => None,
        ColorArgument::Lyapunov => Some("lyapunov"),
        ColorArgument::Rotation => Some("rotation"),
    };
    let data_alone = arguments.data.is_some() && arguments.no_plot && !arguments.json;
    match (arguments.verdict, color) {
        (Some(verdict @ (VerdictArgument::Only | VerdictArgument::None)), Some(color)) => {
            let verdict = if verdict == VerdictArgument::None { "none" } else { "only" };
            Err(SectionInput::ColorWithoutMeasure { verdict, color })
        }
        (Some(verdict), _) => Ok(verdict),
        (None, None) if data_alone => Ok(VerdictArgument::None),
        (None, _) => Ok(VerdictArgument::Whole),
    }
}

/// Refuses what cannot be written before anything is computed.
fn outputs(arguments: &SectionArguments, sites: usize) -> Result<Outputs<'_>, Failure> {
    let (data, json) = (arguments.data.as_ref(), arguments.json);
    let to_stdout = data == Some(&DataTarget::Stdout);
    if to_stdout && json {
        return Err(SectionInput::TwoOnStdout.into());
    }
    if to_stdout && sites > 1 {
        return Err(SectionInput::ManyOnStdout.into());
    }
    let data_alone = data.is_some() && arguments.no_plot;
    let wanted = !(json || to_stdout || data_alone);
    Ok(Outputs {
        data,
        directory: directory(arguments.out.as_deref(), wanted)?,
        formats: if arguments.no_plot { &[] } else { &arguments.picture.format },
        theme: arguments.picture.theme,
        width: arguments.width.width(),
        json,
        list: arguments.atlas.is_some() || arguments.region.as_deref() == Some(ALL),
    })
}

fn starts(arguments: &SectionArguments) -> Result<Starts<'_>, SectionInput> {
    let Some(path) = &arguments.starts else {
        let orbits = arguments.orbits.map_or(ORBITS, std::num::NonZeroU32::get) as usize;
        return Ok(Starts::Spread { orbits, seed: arguments.seed.unwrap_or_default() });
    };
    let spread = [("orbits", arguments.orbits.is_some()), ("seed", arguments.seed.is_some())];
    match spread.into_iter().find(|(_, given)| *given) {
        Some((given, _)) => Err(SectionInput::SpreadWithSeeds { given }),
        None => Ok(Starts::Given { path, seeds: seeds::load(path)? }),
    }
}
