//! The bifurcation diagrams.

use std::error::Error;

use bifdiag::Curves;
use bifdiag_body::Preset;
use bifdiag_documents::DocumentOptions;
use bifdiag_exact::Accuracy;
use bifdiag_plot::{DiagramOptions, DiagramView, MarkedPoints, Picture, draw};

use crate::figure::{Figure, THEME};

/// Name of the file, name of the body.
const DIAGRAMS: [(&str, &str); 11] = [
    ("bifurcation-kovalevskaya", "kovalevskaya"),
    ("bifurcation-nine-regions", "paper"),
    ("bifurcation-katok-1", "katok:1"),
    ("bifurcation-katok-2", "katok:2"),
    ("bifurcation-katok-3", "katok:3"),
    ("bifurcation-katok-4", "katok:4"),
    ("bifurcation-katok-5", "katok:5"),
    ("bifurcation-katok-6", "katok:6"),
    ("bifurcation-katok-7", "katok:7"),
    ("bifurcation-straightened-nine", "paper"),
    ("bifurcation-straightened-ten", "ten"),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    let diagrams = DIAGRAMS.iter().filter_map(|(stem, name)| Some((*stem, Preset::find(name)?)));
    diagrams.map(|(stem, preset)| Figure { stem, draw: Box::new(move || diagram(stem, preset)) })
}

/// The paper's examples of the nine regions.
const DOTS: [[f64; 2]; 9] = [
    [1.8, 3.25],
    [2.6, 3.25],
    [3.8, 3.25],
    [4.45, 3.25],
    [4.675, 3.25],
    [5.3, 3.25],
    [6.5, 3.25],
    [3.1486, 2.72],
    [14.0, 7.2],
];

fn diagram(stem: &str, preset: &Preset) -> Result<Picture, Box<dyn Error>> {
    let atlas = bifdiag_exact::atlas(&preset.body(), Accuracy::Exact)?;
    let document = bifdiag_documents::atlas::document(&atlas, &DocumentOptions::default());
    let dots =
        MarkedPoints { points: DOTS.to_vec(), text: "the paper's example of a region".to_owned(), way: Vec::new() };
    let is_straight = stem.starts_with("bifurcation-straightened");
    let points = (preset.name() == "paper" && !is_straight).then_some(dots);
    let view = if is_straight { DiagramView::Straight } else { DiagramView::Plane };
    let options = DiagramOptions { points, view, theme: THEME, ..DiagramOptions::default() };
    Ok(draw(&document, Some(&Curves(&atlas)), &options)?)
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
