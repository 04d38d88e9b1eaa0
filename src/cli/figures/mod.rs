//! `bifdiag figures`: every figure, made by one command.

mod arguments;
mod diagrams;
mod error;
mod figure;
mod maps;
mod schemes;
mod sections;
mod spheres;
mod tradeoff;
mod typical;

use super::export::FileSet;
use super::failure::Failure;
use super::terminal::{Report, Timings, print};
use figure::Figure;

pub use arguments::{EXAMPLES, FiguresArguments};

/// Dots per inch of PNG: enough for a screen, and small enough for the repository.
const RESOLUTION: f64 = 144.0;

/// Every figure, in the order of the gallery; the charts of measured errors and times only if they are wanted.
fn figures(charts: bool) -> Vec<Figure> {
    diagrams::figures()
        .chain(schemes::figures())
        .chain(spheres::figures())
        .chain(sections::figures())
        .chain(maps::figures())
        .chain(tradeoff::figures().filter(|_| charts))
        .collect()
}

pub fn run(arguments: &FiguresArguments, timings: &Timings) -> Result<(), Failure> {
    let mut files = FileSet::new(&arguments.out);
    for figure in figures(arguments.charts) {
        let picture = (figure.draw)(timings, arguments.picture.theme)?;
        files.pictures(figure.stem, &picture, &arguments.picture.format, RESOLUTION, timings)?;
    }
    Ok(print(Report::of_written(&files.write()?).text())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GALLERY: &str = include_str!("../../../figures/README.md");

    #[test]
    fn the_gallery_shows_every_figure_and_no_other() {
        let stems: Vec<&str> = figures(true).iter().map(|figure| figure.stem).collect();
        for stem in &stems {
            assert!(GALLERY.contains(&format!("]({stem}.svg)")), "figures/README.md does not show {stem}");
            assert_eq!(stems.iter().filter(|other| *other == stem).count(), 1, "{stem} is there twice");
        }
        for (at, _) in GALLERY.match_indices(".svg)") {
            let stem = GALLERY[..at].rsplit(['(', '/']).next().unwrap_or_default();
            assert!(stems.contains(&stem), "figures/README.md shows {stem}, which no command makes");
        }
    }
}
