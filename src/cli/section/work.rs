//! The sections themselves.

use std::path::Path;

use bifdiag_dynamics::poincare::{PoincareSection, SectionSetting};
use bifdiag_dynamics::section::chaos::{ChaosMeasure, ChaosOptions};
use bifdiag_dynamics::section::{Monitor, OrbitSection, SectionError, SweepOptions, TorusPoint};
use bifdiag_schema::{SectionDocument, SkippedDocument, VerdictsName};

use super::crossings::Crossings;
use super::plan::{Plan, Starts};
use super::sites::{Seed, Site, poincare_failure, wrong_line};
use super::stream::follow;
use crate::cli::failure::{Exit, Failure};

/// A section that was computed.
pub struct Done {
    pub h: f64,
    pub l: f64,
    pub document: SectionDocument,
    pub orbits: Vec<OrbitSection>,
    /// How regular each of them is, if that was asked for.
    pub chaos: Vec<ChaosMeasure>,
    /// The journal from which the same command resumes.
    pub journal: Option<Crossings>,
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
pub fn compute(plan: &Plan<'_>, monitor: &Monitor) -> Result<Sections, Failure> {
    let mut sections = Sections { done: Vec::new(), skipped: Vec::new(), complete: true };
    for site in &plan.sites.list {
        if !sections.done.is_empty() && monitor.is_stopped() {
            sections.complete = false;
            break;
        }
        match (section_at(plan, site, monitor), &site.region) {
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
            (Err(error), Some(region)) if plan.sites.all && error.exit() == Exit::WrongInput => {
                tracing::warn!("no section for {region}: {error}");
                sections.skipped.push(SkippedDocument { region: region.clone(), reason: error.to_string() });
            }
            (Err(failure), _) => return Err(failure),
        }
    }
    Ok(sections)
}

fn section_at(plan: &Plan<'_>, site: &Site, monitor: &Monitor) -> Result<Done, Failure> {
    let (arguments, subject) = (plan.arguments, &plan.sites.subject);
    let setting = SectionSetting::new(&subject.body, &site.h, &site.l).map_err(poincare_failure)?;
    let (starts, seed) = match &plan.starts {
        Starts::Given { path, seeds } => (accessible(&setting, path, seeds)?, None),
        Starts::Spread { orbits, seed } => {
            (setting.spread_watched(*orbits, *seed, monitor).map_err(poincare_failure)?, Some(*seed))
        }
    };
    let options = SweepOptions {
        crossings: arguments.crossings.get() as usize,
        max_time: arguments.max_time.unwrap_or(f64::INFINITY),
        tolerance: arguments.tol,
        condition: arguments.condition,
        ..SweepOptions::default()
    };
    let chaos = chaos_options(&options);
    let (section, journal) = match plan.resumed(site.region.as_deref()) {
        Some((path, discards)) => {
            let streamed = plan.streamed().is_some();
            let judged = (streamed && plan.verdict == VerdictsName::Only).then_some(&chaos);
            let (mut section, mut journal) =
                follow((&path, discards), (subject, &setting), (&starts, seed), &options, judged, monitor)?;
            if !streamed && section.complete() {
                for orbit in &mut section.orbits {
                    orbit.points = journal.points(orbit.orbit)?;
                }
                judge(plan, &setting, &mut section, &chaos, monitor)?;
            }
            (section, Some(journal))
        }
        None if plan.verdict == VerdictsName::Early => {
            let section = setting.run_until_decided(&starts, seed, &options, &chaos, monitor);
            (section.map_err(poincare_failure)?, None)
        }
        None => {
            let mut section = setting.run(&starts, seed, &options, monitor).map_err(poincare_failure)?;
            judge(plan, &setting, &mut section, &chaos, monitor)?;
            (section, None)
        }
    };
    let document = bifdiag_documents::section(subject, &section, plan.sites.place(site));
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
    plan: &Plan<'_>,
    setting: &SectionSetting,
    section: &mut PoincareSection,
    chaos: &ChaosOptions,
    monitor: &Monitor,
) -> Result<(), Failure> {
    match plan.verdict {
        VerdictsName::Whole => setting.measure(section, chaos, monitor).map_err(|error| poincare_failure(error.into())),
        VerdictsName::Only => setting.judge(section, chaos, monitor).map_err(|error| poincare_failure(error.into())),
        VerdictsName::Early | VerdictsName::None => Ok(()),
    }
}

/// The variational equations follow the orbits as these were followed.
fn chaos_options(options: &SweepOptions) -> ChaosOptions {
    ChaosOptions { tolerance: options.tolerance, ..ChaosOptions::default() }
}

/// The seeds of a file, if all of them are accessible.
fn accessible(setting: &SectionSetting, path: &Path, seeds: &[Seed]) -> Result<Vec<TorusPoint>, Failure> {
    let mut points = Vec::with_capacity(seeds.len());
    for seed in seeds {
        match setting.state(seed.point) {
            Ok(_) => points.push(seed.point),
            Err(SectionError::SeedInaccessible { potential, h, .. }) => {
                let problem = format!("the point is not accessible: U = {potential} there, above h = {h}");
                return Err(wrong_line(path, seed.line, &problem));
            }
            Err(error) => return Err(poincare_failure(error.into())),
        }
    }
    Ok(points)
}
