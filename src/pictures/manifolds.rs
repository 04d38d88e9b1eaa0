//! Manifolds of periodic orbits or equilibria over the portrait of a section.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::poincare::{PoincareError, SectionSetting};
use bifdiag_dynamics::section::{
    Monitor, OrbitSection, Portrait, PortraitOptions, PpTorus, SectionError, StartOptions, SweepOptions, spread_starts,
    sweep,
};
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_periodic::list::OrbitList;
use bifdiag_periodic::manifold::{Manifolds, rest};
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
    /// The drawing.
    #[error(transparent)]
    Plot(#[from] PlotError),
}

/// Orbits behind the curves, and crossings of each.
const ORBITS: usize = 24;
const CROSSINGS: usize = 600;
/// They have the colour of orbits without a verdict.
const GREY: usize = 2;

/// How far beside the energy of an equilibrium the section is drawn, in parts of |h| + |r|: nobody sees it.
const BESIDE: f64 = 1e-9;
/// 1 − |cos ϑ'| at a pole.
const POLE: f64 = 1e-12;

/// What lies behind manifolds in a picture.
#[derive(Clone, Debug)]
pub struct ManifoldBackground {
    torus: PpTorus,
    body: Body,
    h: f64,
    l: f64,
    /// Where orbits start that are spread over the section.
    starts: Vec<State>,
    /// Points of the unstable orbits, or the equilibria.
    orbits: Vec<State>,
    rests: Vec<State>,
}

impl ManifoldBackground {
    /// From the orbits of a list.
    ///
    /// # Errors
    /// Those of [`SectionSetting::spread`].
    pub fn of_orbits(setting: &SectionSetting, list: &OrbitList) -> Result<Self, PoincareError> {
        let unstable = list.orbits.iter().filter(|listed| listed.orbit.stability.is_unstable());
        let mut starts = Vec::with_capacity(ORBITS);
        for start in setting.spread(ORBITS, 0)? {
            starts.push(setting.state(start)?);
        }
        Ok(Self {
            torus: *setting.torus(),
            body: setting.body().clone(),
            h: setting.h(),
            l: setting.l(),
            starts,
            orbits: unstable.map(|listed| listed.orbit.start).collect(),
            rests: Vec::new(),
        })
    }

    /// Of equilibria of one energy.
    ///
    /// # Errors
    /// Those of [`spread_starts`].
    pub fn of_equilibria(body: &Body, equilibria: &[Equilibrium]) -> Result<Self, SectionError> {
        let top = HeavyTop::new(body);
        let torus = PpTorus::new(&top)?;
        let [h, l] = equilibria.first().map_or([0.0; 2], |found| [found.h, found.l]);
        let mut starts = Vec::with_capacity(ORBITS);
        for start in spread_starts(&torus, h, l, &StartOptions { count: ORBITS, ..StartOptions::default() })? {
            starts.push(torus.state(start, h, l)?);
        }
        let rests = equilibria.iter().map(|found| rest(found, &top)).collect();
        Ok(Self { torus, body: body.clone(), h, l, starts, orbits: Vec::new(), rests })
    }
}

/// Draws manifolds, over orbits that are spread over the section.
///
/// # Errors
/// [`ManifoldPictureError`].
pub fn manifolds(
    background: &ManifoldBackground,
    found: &Manifolds,
    theme: Theme,
) -> Result<Picture, ManifoldPictureError> {
    let ManifoldBackground { torus, body, h, l, starts, .. } = background;
    // At the energy of an equilibrium the boundary and the line of tangency are singular there.
    let beside = if background.rests.is_empty() { 0.0 } else { BESIDE * (h.abs() + torus.top().center_norm()) };
    let portrait = Portrait::new(body, h + beside, *l, &PortraitOptions::default())?;
    let options = SweepOptions { crossings: CROSSINGS, ..SweepOptions::default() };
    let orbits: Vec<OrbitSection> = sweep(torus, starts, &options, &Monitor::default())?;
    let place = |state: &State| (state.gamma, torus.point(state).sheet);
    let lines = |kind| {
        let own = found.manifolds.iter().filter(move |manifold| manifold.kind == kind);
        // A point alone is one of a motion, or nothing to see of a curve.
        let pieces = own.flat_map(|manifold| {
            let pieces = manifold.curves.iter().flat_map(|curve| &curve.pieces);
            pieces.filter(|piece| piece.len() > 1 || manifold.are_motions)
        });
        pieces.map(|piece| piece.iter().map(|vertex| place(&found.state(vertex))).collect()).collect()
    };
    let at_pole = |state: &State| torus.top().r_hat().is_some_and(|r| dot(r, state.gamma).abs() > 1.0 - POLE);
    let seen = background.rests.iter().filter(|state| !at_pole(state));
    let curves = SectionCurves {
        unstable: lines(ManifoldKind::Unstable),
        stable: lines(ManifoldKind::Stable),
        orbits: background.orbits.iter().map(place).collect(),
        // On the boundary, where the sheets meet. A pole is no point of the picture but an edge.
        rests: seen.flat_map(|state| [1, -1].map(|sheet| (state.gamma, sheet))).collect(),
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
