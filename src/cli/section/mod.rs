//! `bifdiag section`: Poincaré sections, their data and their pictures.

mod arguments;
mod error;
mod outputs;
mod picture;
mod progress;
mod report;
mod seeds;
mod sites;
mod table;

pub use arguments::{EXAMPLES, SectionArguments};
pub use error::SectionInputError;

use std::sync::Arc;
use std::sync::atomic::Ordering;

use dynamics::integrator::Method;
use dynamics::poincare::{PoincareError, Setting};
use dynamics::section::chaos::ChaosOptions;
use dynamics::section::{Monitor, OrbitSection, SectionError, SweepOptions, TorusPoint};
use schema::{SectionDocument, SkippedDocument};

use super::failure::Failure;
use super::interrupt;
use super::timings::Timings;
use arguments::ColorArgument;
use error::SeedProblem;
use outputs::Outputs;
use seeds::Seed;
use sites::{Site, Sites};

/// Orbits of a section if nothing else is said.
const ORBITS: u32 = 24;

/// A section that was computed.
pub struct Done {
    pub h: f64,
    pub l: f64,
    pub document: SectionDocument,
    pub orbits: Vec<OrbitSection>,
    /// Orbits that were not cut short by an interrupt.
    pub whole_orbits: usize,
}

/// The sections of a run.
pub struct Sections {
    pub done: Vec<Done>,
    pub skipped: Vec<SkippedDocument>,
    /// Every site had its turn, and no orbit was cut short.
    pub complete: bool,
}

pub fn run(arguments: &SectionArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let sites = Sites::new(arguments)?;
    if sites.subject.body.flags().euler {
        return Err(PoincareError::WeightlessBody.into());
    }
    let outputs = Outputs::new(arguments, sites.list.len())?;
    let seeds = load_seeds(arguments)?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let work = interrupt::stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let orbits = seeds.as_ref().map_or(orbit_count(arguments), Vec::len);
    let expected = (sites.list.len() * orbits) as u64 * arguments.crossings.get() as u64;
    let sections = progress::shown(&monitor, expected, quiet, || {
        timings.stage("orbits", || compute(arguments, &sites, seeds.as_deref(), &monitor))
    })?;
    outputs.write(&sites, &sections, timings)?;
    drop(work);
    if sections.complete {
        return Ok(());
    }
    let finished = sections.done.iter().map(|section| section.whole_orbits).sum();
    Err(Failure::Interrupted { finished, wanted: sites.list.len() * orbits })
}

fn orbit_count(arguments: &SectionArguments) -> usize {
    arguments.orbits.map_or(ORBITS, std::num::NonZeroU32::get) as usize
}

fn load_seeds(arguments: &SectionArguments) -> Result<Option<Vec<Seed>>, SectionInputError> {
    let Some(path) = &arguments.seeds else { return Ok(None) };
    let spread = [("orbits", arguments.orbits.is_some()), ("rng-seed", arguments.rng_seed.is_some())];
    match spread.into_iter().find(|(_, given)| *given) {
        Some((given, _)) => Err(SectionInputError::SpreadWithSeeds { given }),
        None => seeds::load(path).map(Some),
    }
}

/// One section after the other.
fn compute(
    arguments: &SectionArguments,
    sites: &Sites,
    seeds: Option<&[Seed]>,
    monitor: &Monitor,
) -> Result<Sections, Failure> {
    let mut sections = Sections { done: Vec::new(), skipped: Vec::new(), complete: true };
    for site in &sites.list {
        if !sections.done.is_empty() && monitor.is_stopped() {
            sections.complete = false;
            break;
        }
        match (section_at(arguments, sites, site, seeds, monitor), &site.region) {
            (Ok(section), _) => {
                sections.complete &= section.document.complete;
                sections.done.push(section);
            }
            // Stopped before its orbits had their starts; those before it are kept.
            (Err(_), _) if !sections.done.is_empty() && monitor.is_stopped() => {
                sections.complete = false;
                break;
            }
            // One region that is too thin must not cost the others.
            (Err(Failure::Input(error)), Some(region)) if sites.all => {
                tracing::warn!("no section for {region}: {error}");
                sections.skipped.push(SkippedDocument { region: region.clone(), reason: error.to_string() });
            }
            (Err(failure), _) => return Err(failure),
        }
    }
    Ok(sections)
}

fn section_at(
    arguments: &SectionArguments,
    sites: &Sites,
    site: &Site,
    seeds: Option<&[Seed]>,
    monitor: &Monitor,
) -> Result<Done, Failure> {
    let setting = Setting::new(&sites.subject.body, &site.h, &site.l)?;
    let rng_seed = arguments.rng_seed.unwrap_or_default();
    let (starts, rng_seed) = match seeds {
        Some(seeds) => (checked(arguments, &setting, seeds)?, None),
        None => (setting.spread_watched(orbit_count(arguments), rng_seed, monitor)?, Some(rng_seed)),
    };
    let options = SweepOptions {
        crossings: arguments.crossings.get(),
        max_time: arguments.max_time.unwrap_or(f64::INFINITY),
        method: arguments.integrator.method(setting.torus().top(), setting.h())?,
        condition: arguments.condition.into(),
        ..SweepOptions::default()
    };
    let mut section = setting.run(&starts, rng_seed, &options, monitor)?;
    if arguments.color != ColorArgument::Orbit {
        let mut chaos = ChaosOptions::default();
        if let Method::Taylor { tolerance } = options.method {
            chaos.tolerance = tolerance;
        }
        setting.measure(&mut section, &chaos, monitor).map_err(PoincareError::from)?;
    }
    let mut document = documents::section(&section);
    document.region.clone_from(&site.region);
    document.inertia.clone_from(&sites.subject.inertia);
    let (h, l) = (setting.h(), setting.l());
    Ok(Done { h, l, document, whole_orbits: section.whole_orbits(), orbits: section.orbits })
}

/// The seeds, if all of them are accessible.
fn checked(arguments: &SectionArguments, setting: &Setting, seeds: &[Seed]) -> Result<Vec<TorusPoint>, Failure> {
    let mut points = Vec::with_capacity(seeds.len());
    for seed in seeds {
        match setting.state(seed.point) {
            Ok(_) => points.push(seed.point),
            Err(SectionError::SeedInaccessible { potential, h, .. }) => {
                let path = arguments.seeds.clone().unwrap_or_default();
                let problem = SeedProblem::Inaccessible { potential, h };
                return Err(SectionInputError::SeedLine { path, line: seed.line, problem }.into());
            }
            Err(error) => return Err(PoincareError::from(error).into()),
        }
    }
    Ok(points)
}
