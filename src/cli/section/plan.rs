//! What a run is to do: checked before anything is computed.

use std::path::{Path, PathBuf};

use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_schema::VerdictsName;

use super::arguments::{ColorArgument, SectionArguments};
use super::sites::{Seed, Sites, load, poincare_failure};
use crate::cli::export::{DataFormat, DataTarget, directory};
use crate::cli::failure::Failure;

/// Orbits of a section if nothing else is said.
const ORBITS: u32 = 24;

/// The options with what follows from them.
pub struct Plan<'a> {
    pub arguments: &'a SectionArguments,
    pub sites: Sites,
    pub starts: Starts<'a>,
    pub verdict: VerdictsName,
    /// For everything but the data of `--data`.
    pub directory: Option<PathBuf>,
}

/// Where the orbits start.
pub enum Starts<'a> {
    /// Spread evenly.
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

impl<'a> Plan<'a> {
    pub fn new(arguments: &'a SectionArguments) -> Result<Self, Failure> {
        let sites = Sites::new(arguments)?;
        if sites.subject.body.flags().euler {
            return Err(poincare_failure(PoincareError::WeightlessBody));
        }
        let (data, json) = (arguments.data.as_ref(), arguments.json);
        let to_stdout = data == Some(&DataTarget::Stdout);
        if to_stdout && json {
            return Err(Failure::input("--data - and --json both want stdout; give --data FILE.npz"));
        }
        if to_stdout && sites.list.len() > 1 {
            return Err(Failure::input(
                "--data -: several sections do not fit one table; give --data FILE.npz, or one --region",
            ));
        }
        let data_alone = data.is_some() && arguments.no_plot;
        let directory = directory(arguments.out.as_deref(), !(json || to_stdout || data_alone))?;
        Ok(Self { arguments, sites, starts: starts(arguments)?, verdict: verdict(arguments)?, directory })
    }

    /// True where the sites come from an atlas, or several regions were asked for: JSON is a list.
    pub fn is_list(&self) -> bool {
        self.arguments.atlas.is_some() || self.sites.all || self.sites.is_listed()
    }

    /// The file into which crossings go as they are found: where nothing else needs them.
    pub fn streamed(&self) -> Option<(&Path, DataFormat)> {
        match &self.arguments.data {
            Some(DataTarget::File { path, format })
                if self.directory.is_none() && matches!(self.verdict, VerdictsName::Only | VerdictsName::None) =>
            {
                Some((path, *format))
            }
            _ => None,
        }
    }

    /// The data file of a site beside which its crossings are kept as they are found, and whether those of another
    /// section are discarded. `None` where orbits end with their verdicts: these cannot be resumed.
    pub fn resumed(&self, region: Option<&str>) -> Option<(PathBuf, bool)> {
        match (&self.arguments.data, &self.directory) {
            _ if self.verdict == VerdictsName::Early => None,
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

/// Who wants nothing but data wants them fast.
fn verdict(arguments: &SectionArguments) -> Result<VerdictsName, Failure> {
    let color = match arguments.color {
        None | Some(ColorArgument::Orbit | ColorArgument::Side) => None,
        Some(ColorArgument::Verdict) if arguments.verdict != Some(VerdictsName::None) => None,
        Some(ColorArgument::Verdict) => Some("verdict"),
        Some(ColorArgument::Lyapunov) => Some("lyapunov"),
        Some(ColorArgument::Rotation) => Some("rotation"),
    };
    let data_alone = arguments.data.is_some() && arguments.no_plot && !arguments.json;
    match (arguments.verdict, color) {
        (Some(verdict @ (VerdictsName::Only | VerdictsName::None)), Some(color)) => {
            let verdict = if verdict == VerdictsName::None { "none" } else { "only" };
            Err(Failure::input(format!(
                "--verdict {verdict} and --color {color} contradict each other: what the colour shows is not measured \
                then; leave out one of them"
            )))
        }
        (Some(verdict), _) => Ok(verdict),
        (None, None) if data_alone => Ok(VerdictsName::None),
        (None, _) => Ok(VerdictsName::Whole),
    }
}

fn starts(arguments: &SectionArguments) -> Result<Starts<'_>, Failure> {
    let Some(path) = &arguments.starts else {
        let orbits = arguments.orbits.map_or(ORBITS, std::num::NonZeroU32::get) as usize;
        return Ok(Starts::Spread { orbits, seed: arguments.seed.unwrap_or_default() });
    };
    let spread = [("orbits", arguments.orbits.is_some()), ("seed", arguments.seed.is_some())];
    match spread.into_iter().find(|(_, given)| *given) {
        Some((given, _)) => Err(Failure::input(format!(
            "--{given} cannot be used with --starts: the file says where the orbits start; leave out one of them"
        ))),
        None => Ok(Starts::Given { path, seeds: load(path)? }),
    }
}
