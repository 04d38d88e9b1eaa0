//! Manifolds of periodic orbits over the portrait of a section.

use bifdiag_dynamics::field::State;
use bifdiag_dynamics::poincare::{PoincareError, SectionSetting};
use bifdiag_dynamics::section::{Monitor, OrbitSection, Portrait, PortraitOptions, SectionError, SweepOptions, sweep};
use bifdiag_periodic::list::OrbitList;
use bifdiag_periodic::manifold::Manifolds;
use bifdiag_plot::{
    OrbitColors, OrbitFamilies, Picture, PlotError, SectionCurves, SectionOptions, SectionScene, Theme, draw_section,
};
use bifdiag_schema::ManifoldKind;
use thiserror::Error;

/// Why there is no picture.
#[derive(Debug, Error)]
pub enum ManifoldPictureError {
    /// The portrait.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// The starts of the orbits behind the curves.
    #[error(transparent)]
    Poincare(#[from] PoincareError),
    /// The drawing.
    #[error(transparent)]
    Plot(#[from] PlotError),
}

/// Orbits behind the curves, and crossings of each.
const ORBITS: usize = 24;
const CROSSINGS: usize = 600;
/// Their colour is that of orbits of which no verdict is known.
const GREY: usize = 2;

/// Draws manifolds, over orbits that are spread over the section.
///
/// # Errors
/// [`ManifoldPictureError`].
pub fn manifolds(
    setting: &SectionSetting,
    list: &OrbitList,
    found: &Manifolds,
    theme: Theme,
) -> Result<Picture, ManifoldPictureError> {
    let torus = setting.torus();
    let portrait = Portrait::new(setting.body(), setting.h(), setting.l(), &PortraitOptions::default())?;
    let mut starts = Vec::with_capacity(ORBITS);
    for start in setting.spread(ORBITS, 0)? {
        starts.push(setting.state(start)?);
    }
    let options = SweepOptions { crossings: CROSSINGS, ..SweepOptions::default() };
    let orbits: Vec<OrbitSection> = sweep(torus, &starts, &options, &Monitor::default())?;
    let place = |state: &State| (state.gamma, torus.point(state).sheet);
    let lines = |kind| {
        let own = found.manifolds.iter().filter(move |manifold| manifold.kind == kind);
        let pieces = own.flat_map(|manifold| &manifold.curves).flat_map(|curve| &curve.pieces);
        pieces.map(|piece| piece.iter().map(|vertex| place(&found.state(setting, vertex))).collect()).collect()
    };
    let unstable = list.orbits.iter().filter(|listed| listed.orbit.stability.is_unstable());
    let curves = SectionCurves {
        unstable: lines(ManifoldKind::Unstable),
        stable: lines(ManifoldKind::Stable),
        orbits: unstable.map(|listed| place(&listed.orbit.start)).collect(),
        connections: found.connections.iter().map(|connection| place(&connection.state)).collect(),
    };
    let of = vec![GREY; orbits.len()];
    let names = ["", "", "other"];
    let scene = SectionScene {
        portrait: &portrait,
        orbits: &orbits,
        values: None,
        families: Some(OrbitFamilies { of: &of, names: &names, colors: OrbitColors::Verdicts }),
        curves: Some(&curves),
        caption: "",
    };
    Ok(draw_section(&scene, &SectionOptions { theme, ..SectionOptions::default() })?)
}
