//! The sections themselves.

use std::path::Path;

use bifdiag_dynamics::poincare::{PoincareError, PoincareSection, SectionSetting};
use bifdiag_dynamics::section::chaos::{ChaosMeasure, ChaosOptions};
use bifdiag_dynamics::section::{Monitor, OrbitSection, SectionError, SweepOptions, TorusPoint};
use bifdiag_schema::{SectionDocument, SkippedDocument};

use super::arguments::VerdictArgument;
use super::error::{SectionFailure, SectionInput, SeedProblem};
use super::seeds::Seed;
use super::settings::{Settings, Starts};
use super::sites::Site;
use super::stream::{self, Journal};

/// A section that was computed.
pub struct Done {
    pub h: f64,
    pub l: f64,
    pub document: SectionDocument,
    pub orbits: Vec<OrbitSection>,
    /// How regular each of them is, if that was asked for.
    pub chaos: Vec<ChaosMeasure>,
    /// What was found, from which the same command goes on.
    pub journal: Option<Journal>,
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

/// One section after the other.
pub fn compute(settings: &Settings, monitor: &Monitor) -> Result<Sections, SectionFailure> {
    let mut sections = Sections { done: Vec::new(), skipped: Vec::new(), complete: true };
    for site in &settings.sites.list {
        if !sections.done.is_empty() && monitor.is_stopped() {
            sections.complete = false;
            break;
        }
        match (section_at(settings, site, monitor), &site.region) {
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
            (Err(SectionFailure::Input(error)), Some(region)) if settings.sites.all => {
                tracing::warn!("no section for {region}: {error}");
                sections.skipped.push(SkippedDocument { region: region.clone(), reason: error.to_string() });
            }
            (Err(failure), _) => return Err(failure),
        }
    }
    Ok(sections)
}

fn section_at(settings: &Settings, site: &Site, monitor: &Monitor) -> Result<Done, SectionFailure> {
    let subject = &settings.sites.subject;
    let setting = SectionSetting::new(&subject.body, &site.h, &site.l)?;
    let (starts, seed) = match &settings.starts {
        Starts::Given { path, seeds } => (accessible(&setting, path, seeds)?, None),
        Starts::Spread { orbits, seed } => (setting.spread_watched(*orbits, *seed, monitor)?, Some(*seed)),
    };
    let options = SweepOptions {
        crossings: settings.crossings,
        max_time: settings.max_time,
        tolerance: settings.tolerance,
        condition: settings.condition,
        ..SweepOptions::default()
    };
    let chaos = chaos_options(&options);
    let (section, journal) = match settings.resumed(site.region.as_deref()) {
        Some((path, discards)) => {
            let streamed = settings.streamed().is_some();
            let judged = (streamed && settings.verdict == VerdictArgument::Only).then_some(&chaos);
            let (mut section, mut journal) =
                stream::follow((&path, discards), &setting, (&starts, seed), &options, judged, monitor)?;
            if !streamed && section.complete() {
                for orbit in &mut section.orbits {
                    orbit.points = journal.points(orbit.orbit)?;
                }
                judge(settings, &setting, &mut section, &chaos, monitor)?;
            }
            (section, Some(journal))
        }
        None if settings.verdict == VerdictArgument::Early => {
            (setting.run_until_decided(&starts, seed, &options, &chaos, monitor)?, None)
        }
        None => {
            let mut section = setting.run(&starts, seed, &options, monitor)?;
            judge(settings, &setting, &mut section, &chaos, monitor)?;
            (section, None)
        }
    };
    let document = bifdiag_documents::section(subject, &section, site.region.as_deref());
    let (h, l) = (setting.h(), setting.l());
    Ok(Done {
        h,
        l,
        document,
        whole_orbits: section.whole_orbits(),
        orbits: section.orbits,
        chaos: section.chaos,
        journal,
    })
}

/// Adds the verdicts, if these are wanted.
fn judge(
    settings: &Settings,
    setting: &SectionSetting,
    section: &mut PoincareSection,
    chaos: &ChaosOptions,
    monitor: &Monitor,
) -> Result<(), PoincareError> {
    match settings.verdict {
        VerdictArgument::Whole => setting.measure(section, chaos, monitor)?,
        VerdictArgument::Only => setting.judge(section, chaos, monitor)?,
        VerdictArgument::Early | VerdictArgument::None => {}
    }
    Ok(())
}

/// The variational equations follow the orbits as these were followed.
fn chaos_options(options: &SweepOptions) -> ChaosOptions {
    ChaosOptions { tolerance: options.tolerance, ..ChaosOptions::default() }
}

/// The seeds of a file, if all of them are accessible.
fn accessible(setting: &SectionSetting, path: &Path, seeds: &[Seed]) -> Result<Vec<TorusPoint>, SectionFailure> {
    let mut points = Vec::with_capacity(seeds.len());
    for seed in seeds {
        match setting.state(seed.point) {
            Ok(_) => points.push(seed.point),
            Err(SectionError::SeedInaccessible { potential, h, .. }) => {
                let problem = SeedProblem::Inaccessible { potential, h };
                return Err(SectionInput::SeedLine { path: path.to_owned(), line: seed.line, problem }.into());
            }
            Err(error) => return Err(PoincareError::from(error).into()),
        }
    }
    Ok(points)
}
