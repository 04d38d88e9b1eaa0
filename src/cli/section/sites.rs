//! Where sections are wanted, at one point of a body or at the samples of an atlas, and where the user lets orbits start.

use std::f64::consts::PI;
use std::fmt::Display;
use std::path::Path;

use bifdiag_body::part::UnitsError;
use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::fast::FastError;
use bifdiag_documents::reading::makes_an_atlas;
use bifdiag_documents::{SectionPlace, Subject};
use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_dynamics::section::TorusPoint;
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_numbers::decimal::counted;
use bifdiag_schema::SCHEMA_VERSION;

use super::arguments::SectionArguments;
use crate::cli::atlas::stray_sample;
use crate::cli::failure::Failure;
use crate::cli::input::{read, values};

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
    /// All regions were requested: those without a section are skipped.
    pub all: bool,
    /// The command that prints the atlas whose samples these are, where it came from a file.
    pub atlas: Option<String>,
}

impl Sites {
    /// What the document says of a site.
    pub fn place<'a>(&self, site: &'a Site) -> SectionPlace<'a> {
        match (&site.region, &self.atlas) {
            (None, _) => SectionPlace::Point,
            (Some(region), None) => SectionPlace::OwnSample(region),
            (Some(region), Some(_)) => SectionPlace::OtherSample(region),
        }
    }

    /// Whether the user named several regions, for comparison.
    pub fn is_listed(&self) -> bool {
        !self.all && self.list.len() > 1
    }

    /// The regions as `--region` names them.
    pub fn wanted(&self) -> String {
        if self.all {
            return "all".to_owned();
        }
        self.list.iter().filter_map(|site| site.region.as_deref()).collect::<Vec<_>>().join(",")
    }

    /// Of the options.
    pub fn new(arguments: &SectionArguments) -> Result<Self, Failure> {
        let point = [("--h", arguments.point.energy.is_some()), ("--l", arguments.point.momentum.is_some())];
        let point = || point.into_iter().filter(|(_, given)| *given).map(|(option, _)| option);
        if let Some(path) = &arguments.atlas {
            return match arguments.body.given().chain(point()).next() {
                Some(option) => Err(Failure::input(format!(
                    "--atlas and {option} both say what to integrate; leave out {option}, or leave out --atlas"
                ))),
                None => Self::of_file(path, &arguments.region),
            };
        }
        let subject = arguments.body.subject()?;
        if !arguments.region.is_empty() {
            return match point().next() {
                Some(option) => {
                    Err(Failure::input(format!("--region and {option} both give the point; leave out one of them")))
                }
                None => Self::of_body(subject, &arguments.region),
            };
        }
        let missing = |missing, example| {
            let message = format!("{missing} is missing; give {example}, or --region R4 for the sample of a region");
            move || Failure::input(message)
        };
        let h = arguments.point.energy.clone().ok_or_else(missing("--h", "the energy, such as --h 4.45"))?;
        let l = arguments.point.momentum.clone().ok_or_else(missing("--l", "the momentum, such as --l 3.25"))?;
        Ok(Self { subject, list: vec![Site { region: None, h, l }], all: false, atlas: None })
    }

    /// The samples of a body's own atlas.
    fn of_body(subject: Subject, wanted: &[String]) -> Result<Self, Failure> {
        let atlas = bifdiag_exact::atlas(&subject.body, Accuracy::Exact).map_err(Failure::input)?;
        let samples = atlas.regions().ids().map(|region| {
            let sample = atlas.sample(region);
            (region.to_string(), sample.h, sample.l)
        });
        let samples = samples.collect();
        Self::of_samples(subject, samples, wanted, Some(&Solver::of(atlas, Accuracy::Exact)))
    }

    /// The samples of the wanted regions, each of which must lie in its own, where a solver knows the same regions.
    fn of_samples(
        subject: Subject,
        samples: Vec<(String, f64, f64)>,
        wanted: &[String],
        solver: Option<&Solver>,
    ) -> Result<Self, Failure> {
        let list = chosen(samples, wanted)?;
        let stray = solver.and_then(|solver| {
            list.iter().find_map(|site| {
                let id = site.region.as_deref()?;
                let is_outside = solver.is_outside(id.parse().ok()?, [site.h.to_f64(), site.l.to_f64()]);
                is_outside.then(|| stray_sample(id))
            })
        });
        stray.map_or_else(|| Ok(Self { subject, list, all: is_all(wanted), atlas: None }), Err)
    }

    /// The samples of an atlas.json.
    fn of_file(path: &Path, wanted: &[String]) -> Result<Self, Failure> {
        let file = path.display();
        let wrong = |error: &dyn Display| Failure::input(format!("--atlas {file}: {error}"));
        let text = read(path)
            .map_err(|error| wrong(&format!("{error}; give an atlas.json that can be read, or - for stdin")))?;
        let atlas = bifdiag_documents::reading::atlas(&text, &path.to_string_lossy()).map_err(|error| {
            let version = format!("version {SCHEMA_VERSION} (bifdiag atlas --json writes one)");
            Failure::input(format!("--atlas {file} is not an atlas of {version}: {error}")).because(error)
        })?;
        let body = Body::parse(&atlas.body.given.moments, &atlas.body.given.center)
            .map_err(|error| wrong(&format!("its body is invalid: {error}")))?;
        // Names of files are made of them.
        for region in &atlas.regions {
            region.id.parse::<RegionId>().map_err(|error| wrong(&error))?;
        }
        let units = atlas.body.part.as_ref().map(|part| part.units.parse()).transpose();
        let units = units.map_err(|error: UnitsError| wrong(&format!("the units of its part: {error}")))?;
        let subject = Subject { body, part: atlas.body.part, units };
        let samples = atlas.regions.into_iter().map(|region| (region.id, region.sample.h, region.sample.l));
        let solver = (atlas.accuracy == Accuracy::Exact).then(|| Solver::new(subject.body.clone(), Accuracy::Exact));
        let command =
            if makes_an_atlas(&atlas.head.command) { atlas.head.command } else { subject.command("atlas").json() };
        let sites = Self::of_samples(subject, samples.collect(), wanted, solver.as_ref())?;
        Ok(Self { atlas: Some(command), ..sites })
    }
}

/// Whether `--region` asks for every region; an atlas without it is asked for all.
fn is_all(wanted: &[String]) -> bool {
    wanted.is_empty() || wanted.iter().any(|id| id == "all")
}

/// The wanted ones of regions with their samples, in the order in which they were named.
fn chosen(samples: Vec<(String, f64, f64)>, wanted: &[String]) -> Result<Vec<Site>, Failure> {
    let known: Vec<&str> = samples.iter().map(|(id, ..)| id.as_str()).collect();
    let unknown = wanted.iter().find(|id| !is_all(wanted) && !known.contains(&id.as_str()));
    if unknown.is_some() || known.is_empty() {
        let known = match &known[..] {
            [] => "there is none".to_owned(),
            known => format!("it has {}, or give all", known.join(", ")),
        };
        let wanted = unknown.map_or("all", |id| if id.is_empty() { "(without a name)" } else { id });
        return Err(Failure::input(format!("--region {wanted}: the body has no such region; {known}")));
    }
    let place = |(id, ..): &(String, f64, f64)| wanted.iter().position(|wanted| wanted == id);
    let mut chosen: Vec<(String, f64, f64)> =
        samples.into_iter().filter(|sample| is_all(wanted) || place(sample).is_some()).collect();
    chosen.sort_by_key(place);
    // The samples of an atlas are finite.
    let site = |(id, h, l)| {
        let [h, l] = [h, l].map(Number::from_f64);
        Some(Site { region: Some(id), h: h.ok()?, l: l.ok()? })
    };
    Ok(chosen.into_iter().filter_map(site).collect())
}

/// A starting point and its line in the file, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seed {
    pub point: TorusPoint,
    pub line: usize,
}

const HEADING: [&str; 3] = ["theta", "psi", "sheet"];

/// The seeds of a file.
pub fn load(path: &Path) -> Result<Vec<Seed>, Failure> {
    let file = path.display();
    let text = read(path).map_err(|error| {
        Failure::input(format!("--starts {file}: {error}; give a file that can be read, or - for stdin"))
    })?;
    let seeds = parse(&text).map_err(|(line, problem)| wrong_line(path, line, &problem))?;
    if seeds.is_empty() {
        let right = "write the header theta,psi,sheet and one start on each line";
        return Err(Failure::input(format!("--starts {file} holds no start; {right}")));
    }
    Ok(seeds)
}

/// A line that is no start, or none that can be used.
pub fn wrong_line(path: &Path, line: usize, problem: &str) -> Failure {
    Failure::input(format!("--starts {}, line {line}: {problem}", path.display()))
}

/// Columns in any order, others ignored; empty lines and lines that start with # are skipped.
fn parse(text: &str) -> Result<Vec<Seed>, (usize, String)> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((number, heading)) = lines.next() else { return Ok(Vec::new()) };
    let names: Vec<&str> = heading.split(',').map(str::trim).collect();
    let mut places = [0; 3];
    for (place, name) in places.iter_mut().zip(HEADING) {
        let found = names.iter().position(|found| *found == name);
        let lacks = || (number, format!("the header `{heading}` lacks {name}; write theta,psi,sheet"));
        *place = found.ok_or_else(lacks)?;
    }
    lines
        .map(|(line, text)| Ok(Seed { point: seed(text, names.len(), places).map_err(|p| (line, p))?, line }))
        .collect()
}

fn seed(text: &str, wanted: usize, places: [usize; 3]) -> Result<TorusPoint, String> {
    let values: Vec<&str> = text.split(',').map(str::trim).collect();
    if values.len() != wanted {
        return Err(format!("{}, but the header has {wanted}", counted(values.len(), "value", "values")));
    }
    let [theta, psi, sheet] = places.map(|place| values[place]);
    let angle = |name: &str, value: &str| {
        let right = "give an angle in radians, such as 1.57 or pi/2";
        values::angle(value).map_err(|_not_an_angle| format!("{name} = `{value}` is not a number; {right}"))
    };
    let (polar, psi) = (angle("theta", theta)?, angle("psi", psi)?);
    if !(0.0..=PI).contains(&polar) {
        return Err(format!("theta = {theta} is not between 0 and pi; it is the angle between gamma and r"));
    }
    let sheet = values::sheet(sheet).map_err(|_neither| format!("sheet = `{sheet}` is neither 1 (T+) nor -1 (T-)"))?;
    Ok(TorusPoint { theta: polar, psi, sheet })
}

/// A section that is not there, or could not be computed.
pub fn poincare_failure(error: PoincareError) -> Failure {
    match error {
        PoincareError::Classify(FastError::Momentum(error)) => Failure::input(format!("--l: {error}")),
        PoincareError::WeightlessBody
        | PoincareError::Forbidden { .. }
        | PoincareError::OnCurve { .. }
        | PoincareError::Undecided { .. } => Failure::input(error),
        error => Failure::work("the section could not be computed").because(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_may_stand_in_any_order() {
        let seeds = parse("# mine\n\npsi, sheet, theta, colour\n0.5,-1,pi/2,red\n\n1,+,0.25,blue\n").unwrap();
        assert_eq!(seeds[0], Seed { point: TorusPoint { theta: PI / 2.0, psi: 0.5, sheet: -1 }, line: 4 });
        assert_eq!(seeds[1], Seed { point: TorusPoint { theta: 0.25, psi: 1.0, sheet: 1 }, line: 6 });
    }

    #[test]
    fn wrong_lines_are_numbered() {
        let wrong = |text: &str, line: usize, problem: &str| {
            let found = parse(text).unwrap_err();
            assert!(found.0 == line && found.1.starts_with(problem), "{found:?}");
        };
        wrong("theta,psi\n", 1, "the header `theta,psi` lacks sheet");
        wrong("theta,psi,sheet\n1,2\n", 2, "2 values, but the header has 3");
        wrong("theta,psi,sheet\n\nx,2,1\n", 3, "theta = `x` is not a number");
        wrong("theta,psi,sheet\n1,nan,1\n", 2, "psi = `nan` is not a number");
        wrong("theta,psi,sheet\n-0.1,2,1\n", 2, "theta = -0.1 is not between 0 and pi");
        wrong("theta,psi,sheet\n0.1,2,0\n", 2, "sheet = `0` is neither");
    }
}
