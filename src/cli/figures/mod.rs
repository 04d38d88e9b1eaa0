//! `bifdiag figures`: every figure, made by one command.

mod diagrams;
mod maps;
mod schemes;
mod sections;
mod tradeoff;
mod typical;

use plot::Picture;

use super::arguments::{FiguresArguments, Format};
use super::failure::Failure;
use super::files::FileSet;
use super::output;
use super::report::Report;
use super::timings::Timings;

/// Dots per inch of PNG: enough for a screen, and small enough for the repository.
const PNG_RESOLUTION: f64 = 144.0;

/// How a figure is drawn.
type Draw = dyn Fn(&Timings) -> Result<Picture, Failure>;

/// A figure: the name of its files and how it is drawn.
struct Figure {
    stem: &'static str,
    draw: Box<Draw>,
}

/// Every figure, in the order of the gallery.
fn figures() -> Vec<Figure> {
    diagrams::figures()
        .chain(schemes::figures())
        .chain(sections::figures())
        .chain(maps::figures())
        .chain(tradeoff::figures())
        .collect()
}

pub fn run(arguments: &FiguresArguments, timings: &Timings) -> Result<(), Failure> {
    let mut files = FileSet::new(&arguments.out);
    for figure in figures() {
        let picture = (figure.draw)(timings)?;
        for format in &arguments.format {
            let (extension, bytes) = match format {
                Format::Svg => ("svg", picture.svg.clone().into_bytes()),
                Format::Png => ("png", timings.stage("png", || picture.to_png(PNG_RESOLUTION))?),
                Format::Pdf => ("pdf", timings.stage("pdf", || picture.to_pdf())?),
            };
            files.add(format!("{}.{extension}", figure.stem), bytes);
        }
    }
    Ok(output::print(Report::of_paths(&files.write()?).text().as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GALLERY: &str = include_str!("../../../figures/README.md");

    #[test]
    fn the_gallery_shows_every_figure_and_no_other() {
        let stems: Vec<&str> = figures().iter().map(|figure| figure.stem).collect();
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
