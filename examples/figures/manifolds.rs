//! The manifolds of a symmetric pair of unstable orbits, and of an unstable equilibrium.

use std::error::Error;

use bifdiag::pictures::{self, ManifoldBackground};
use bifdiag_body::{Body, Preset};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::{Equilibrium, critical};
use bifdiag_periodic::list::{ListOptions, list};
use bifdiag_periodic::manifold::{ManifoldOptions, manifolds, manifolds_of_equilibria};
use bifdiag_plot::Picture;

use crate::figure::{Figure, THEME};

/// The paper's body, and (h, l).
const POINT: [&str; 2] = ["5.3", "3.25"];
const LENGTH: f64 = 8.0;

/// A body without symmetry whose equilibrium with the center of mass on top has complex eigenvalues at this l.
const COMPLEX: ([&str; 3], [&str; 3], &str) = (["2", "1.5", "1.2"], ["0.3", "0.5", "0.8"], "1.5");
const LONGER: f64 = 10.0;

pub fn figures() -> impl Iterator<Item = Figure> {
    [
        Figure { stem: "section-manifolds", draw: Box::new(draw) },
        Figure { stem: "section-equilibrium", draw: Box::new(equilibrium) },
    ]
    .into_iter()
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

fn equilibrium() -> Result<Picture, Box<dyn Error>> {
    let (moments, center, l) = COMPLEX;
    let body = Body::parse(&moments, &center)?;
    let mut unstable = critical(&body, &l.parse()?)?.list;
    unstable.retain(|found: &Equilibrium| found.stability.is_unstable());
    let options = ManifoldOptions { length: LONGER };
    let found = manifolds_of_equilibria(&body, &unstable, &options, &Monitor::default())?;
    Ok(pictures::manifolds(&ManifoldBackground::of_equilibria(&body, &unstable)?, &found, THEME)?)
}
