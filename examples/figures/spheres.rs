//! U on the Poisson sphere, as `bifdiag sphere` draws it.

use std::error::Error;
use std::fs;

use bifdiag_plot::Picture;

use crate::figure::Figure;

/// Name of the file, options of the command.
const SPHERES: [(&str, &str); 3] = [
    ("sphere-two-discs", "--body paper --h 4.45 --l 3.25"),
    ("sphere-annulus", "--A 2,2,1 --r 1,0,0 --h 3.4 --l 2.87"),
    ("sphere-four-circles", "--A 1,1.05,2.02 --r 0.0001,0.0665,1 --h 1.79332 --l 1.7862 --view 0,0,-1"),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    SPHERES.into_iter().map(|(stem, options)| Figure { stem, draw: Box::new(move || sphere(options)) })
}

fn sphere(options: &str) -> Result<Picture, Box<dyn Error>> {
    let place = tempfile::tempdir()?;
    let command = ["bifdiag", "sphere"].into_iter().chain(options.split(' ')).map(Into::into);
    match bifdiag::cli::run(command.chain(["--out".into(), place.path().into()])) {
        0 => Ok(Picture { svg: fs::read_to_string(place.path().join("sphere.svg"))? }),
        status => Err(format!("bifdiag sphere {options} ended with status {status}").into()),
    }
}
