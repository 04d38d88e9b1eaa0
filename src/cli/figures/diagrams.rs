//! The bifurcation diagrams.

use documents::DocumentOptions;
use plot::{DiagramOptions, Picture, Theme, draw};
use proof::{Accuracy, atlas_of};
use top::body::Preset;

use super::figure::Figure;
use crate::cli::atlas::{Curves, NoAtlas};
use crate::cli::export::ExportError;
use crate::cli::failure::Failure;
use crate::cli::terminal::Timings;

/// Name of the file, name of the body.
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

pub fn figures() -> impl Iterator<Item = Figure> {
    let diagrams = DIAGRAMS.iter().filter_map(|(stem, name)| Some((*stem, Preset::find(name)?)));
    diagrams
        .map(|(stem, preset)| Figure { stem, draw: Box::new(move |timings, theme| diagram(preset, timings, theme)) })
}

fn diagram(preset: &Preset, timings: &Timings, theme: Theme) -> Result<Picture, Failure> {
    let atlas = atlas_of(&preset.body(), Accuracy::Exact).map_err(NoAtlas::from)?;
    let document = documents::atlas::document(&atlas, &DocumentOptions::default());
    let picture = timings.stage(preset.name(), || {
        draw(&document, Some(&Curves(&atlas)), &DiagramOptions { theme, ..DiagramOptions::default() })
    });
    Ok(picture.map_err(ExportError::from)?)
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
