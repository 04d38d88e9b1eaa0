//! `bifdiag figures`: every figure, made by one command.

use bifdiag::atlas::{Atlas, DocumentOptions};
use bifdiag::body::Preset;
use bifdiag::plot::{DiagramOptions, draw};

use super::arguments::FiguresArguments;
use super::atlas::{Curves, add_picture};
use super::failure::Failure;
use super::files::FileSet;
use super::output;
use super::report::Report;
use super::timings::Timings;

/// Bifurcation diagrams: name of the file, name of the body.
const DIAGRAMS: [(&str, &str); 9] = [
    ("bifurcation-kovalevskaya", "kovalevskaya"),
    ("bifurcation-nine-regions", "paper"),
    ("bifurcation-katok-1", "katok:1"),
    ("bifurcation-katok-2", "katok:2"),
    ("bifurcation-katok-3", "katok:3"),
    ("bifurcation-katok-4", "katok:4"),
    ("bifurcation-katok-5", "katok:5"),
    ("bifurcation-katok-6", "katok:6"),
    ("bifurcation-katok-7", "katok:7"),
];

pub fn run(arguments: &FiguresArguments, timings: &Timings) -> Result<(), Failure> {
    let mut files = FileSet::new(&arguments.out);
    let diagrams = DIAGRAMS.iter().filter_map(|(stem, name)| Some((stem, Preset::find(name)?)));
    for (stem, preset) in diagrams {
        let atlas = Atlas::new(&preset.body())?;
        let document = atlas.document(&DocumentOptions::default());
        let picture =
            timings.stage(preset.name(), || draw(&document, Some(&Curves(&atlas)), &DiagramOptions::default()))?;
        add_picture(&mut files, stem, &picture, &arguments.format, timings)?;
    }
    super::scan::figures::add(&mut files, &arguments.format, timings)?;
    Ok(output::print(Report::of_paths(&files.write()?).text().as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_diagram_is_of_a_named_body() {
        for (stem, name) in DIAGRAMS {
            assert!(Preset::find(name).is_some(), "{stem} is to show {name}, which does not exist");
        }
    }
}
