//! Makes every figure of the paper and of the documentation, as SVG.
//!
//! ```text
//! cargo run --release --example figures -- [--charts] [--only NAME] [DIR]
//! ```
//!
//! DIR is `figures` unless another is given; `--charts` adds the charts of measured errors and times of `data/tradeoff`.

mod chart;
mod diagrams;
mod figure;
mod manifolds;
mod maps;
mod proved;
mod schematic;
mod schemes;
mod sections;
mod spheres;
mod theorems;
mod tradeoff;
mod typical;

/// How the tests of `plot` read a picture.
#[path = "../../crates/plot/tests"]
#[cfg(test)]
mod reading {
    pub mod picture_letters;
    mod picture_svg;
    pub mod picture_texts;
}

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;

use figure::Figure;

/// Make every figure of the paper and of the documentation
#[derive(Debug, Parser)]
struct Arguments {
    /// Write the figures to DIR
    #[arg(value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Draw the charts of measured errors and times too
    #[arg(long)]
    charts: bool,
    /// Draw this figure only
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
}

/// Every figure, in the order of the gallery.
fn figures(charts: bool) -> impl Iterator<Item = Figure> {
    diagrams::figures()
        .chain(schemes::figures())
        .chain(spheres::figures())
        .chain(theorems::figures())
        .chain(sections::figures())
        .chain(manifolds::figures())
        .chain(maps::figures())
        .chain(proved::figures())
        .chain(tradeoff::figures().filter(move |_| charts))
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    fs::create_dir_all(&arguments.out)?;
    let is_wanted = |figure: &Figure| arguments.only.as_ref().is_none_or(|only| figure.stem == only);
    for figure in figures(arguments.charts).filter(is_wanted) {
        let path = Path::new(&arguments.out).join(figure.stem).with_extension("svg");
        fs::write(&path, (figure.draw)()?.svg)?;
        println!("{}", path.display());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const GALLERY: &str = include_str!("../../figures/README.md");

    #[test]
    fn the_gallery_shows_every_figure_and_no_other() {
        let stems: Vec<&str> = figures(true).map(|figure| figure.stem).collect();
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
