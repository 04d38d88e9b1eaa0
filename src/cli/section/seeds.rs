//! Starting points that the user gives: CSV with the heading theta,psi,sheet.

use std::f64::consts::PI;
use std::path::Path;

use bifdiag_dynamics::section::TorusPoint;

use super::error::{SectionInput, SeedProblem};
use crate::cli::input::{read, values};

/// A starting point and the line of the file on which it stands, from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seed {
    pub point: TorusPoint,
    pub line: usize,
}

const HEADING: [&str; 3] = ["theta", "psi", "sheet"];

/// The seeds of a file.
pub fn load(path: &Path) -> Result<Vec<Seed>, SectionInput> {
    let text = read(path).map_err(|source| SectionInput::SeedsFile { path: path.to_owned(), source })?;
    let seeds =
        parse(&text).map_err(|(line, problem)| SectionInput::SeedLine { path: path.to_owned(), line, problem })?;
    if seeds.is_empty() {
        return Err(SectionInput::NoSeeds { path: path.to_owned() });
    }
    Ok(seeds)
}

/// Columns in any order, others ignored; empty lines and lines that start with # are passed over.
fn parse(text: &str) -> Result<Vec<Seed>, (usize, SeedProblem)> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((number, heading)) = lines.next() else { return Ok(Vec::new()) };
    let names: Vec<&str> = heading.split(',').map(str::trim).collect();
    let mut places = [0; 3];
    for (place, name) in places.iter_mut().zip(HEADING) {
        let found = names.iter().position(|found| *found == name);
        *place = found.ok_or_else(|| (number, SeedProblem::Heading(heading.to_owned(), name)))?;
    }
    lines
        .map(|(line, text)| Ok(Seed { point: seed(text, names.len(), places).map_err(|p| (line, p))?, line }))
        .collect()
}

fn seed(text: &str, wanted: usize, places: [usize; 3]) -> Result<TorusPoint, SeedProblem> {
    let values: Vec<&str> = text.split(',').map(str::trim).collect();
    if values.len() != wanted {
        return Err(SeedProblem::Count { found: values.len(), wanted });
    }
    let [theta, psi, sheet] = places.map(|place| values[place]);
    let angle = |name, value: &str| {
        values::angle(value).map_err(|_not_an_angle| SeedProblem::NotAnAngle { name, value: value.to_owned() })
    };
    let (polar, psi) = (angle("theta", theta)?, angle("psi", psi)?);
    if !(0.0..=PI).contains(&polar) {
        return Err(SeedProblem::Theta { value: theta.to_owned() });
    }
    let sheet = values::sheet(sheet).map_err(|_neither| SeedProblem::Sheet { value: sheet.to_owned() })?;
    Ok(TorusPoint { theta: polar, psi, sheet })
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
        let wrong = |text: &str| parse(text).unwrap_err();
        assert!(matches!(wrong("theta,psi\n"), (1, SeedProblem::Heading(_, "sheet"))));
        assert!(matches!(wrong("theta,psi,sheet\n1,2\n"), (2, SeedProblem::Count { found: 2, wanted: 3 })));
        assert!(matches!(wrong("theta,psi,sheet\n\nx,2,1\n"), (3, SeedProblem::NotAnAngle { name: "theta", .. })));
        assert!(matches!(wrong("theta,psi,sheet\n1,nan,1\n"), (2, SeedProblem::NotAnAngle { name: "psi", .. })));
        assert!(matches!(wrong("theta,psi,sheet\n-0.1,2,1\n"), (2, SeedProblem::Theta { .. })));
        assert!(matches!(wrong("theta,psi,sheet\n0.1,2,0\n"), (2, SeedProblem::Sheet { .. })));
    }
}
