//! The manifolds of a symmetric pair of unstable orbits.

use std::error::Error;

use bifdiag::pictures::{self, ManifoldBackground};
use bifdiag_body::Preset;
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_periodic::list::{ListOptions, list};
use bifdiag_periodic::manifold::{ManifoldOptions, manifolds};
use bifdiag_plot::Picture;

use crate::figure::{Figure, THEME};

/// The paper's body, and (h, l).
const POINT: [&str; 2] = ["5.3", "3.25"];
const LENGTH: f64 = 8.0;

pub fn figures() -> impl Iterator<Item = Figure> {
    std::iter::once(Figure { stem: "section-manifolds", draw: Box::new(draw) })
}

fn draw() -> Result<Picture, Box<dyn Error>> {
    let body = Preset::find("paper").map(Preset::body).ok_or("the paper's body is a preset")?;
    let [h, l] = POINT.map(str::parse);
    let setting = SectionSetting::new(&body, &h?, &l?)?;
    let monitor = Monitor::default();
    let listed = list(&setting, &ListOptions::default(), &monitor)?;
    let found = manifolds(&setting, &listed, &ManifoldOptions { length: LENGTH }, &monitor)?;
    Ok(pictures::manifolds(&ManifoldBackground::of_orbits(&setting, &listed)?, &found, THEME)?)
}
