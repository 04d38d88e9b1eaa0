//! All periodic orbits with few crossings of the section at one point (h, l).

pub mod cell;
pub mod newton;
pub mod search;

mod curves;
mod group;
mod near;
mod stage;

use bifdiag_dynamics::field::HeavyTop;
use bifdiag_dynamics::poincare::{PoincareError, SectionSetting};
use bifdiag_dynamics::section::{Monitor, SectionError};
use thiserror::Error;

use crate::chart::{Cover, Surface, cover};
use crate::orbit::{OrbitError, PeriodicOrbit};
use crate::proof::{OrbitProof, ProofError, prove};
use crate::section_map::SectionMap;
pub use near::NearCurve;
pub use stage::Stage;

use search::{Found, OpenCell, SearchOptions, search};

/// What to look for, and how hard.
#[derive(Clone, Copy, Debug)]
pub struct ListOptions {
    /// The most crossings of P, inward and outward together; an orbit has an even number of them.
    pub crossings: u32,
    /// The most cells to examine.
    pub cells: usize,
}

impl Default for ListOptions {
    fn default() -> Self {
        Self { crossings: 2, cells: 1_000_000 }
    }
}

/// The most crossings that can be asked for.
pub const MOST_CROSSINGS: u32 = 24;

/// An orbit of the list.
#[derive(Clone, Debug)]
pub struct ListedOrbit {
    /// The orbit; it starts where ⟨γ,r⟩ is largest.
    pub orbit: PeriodicOrbit,
    /// The index of its points as fixed points of Rᵐ, m the number of its returns.
    pub index: i32,
    /// The proof that it exists, or why there is none.
    pub proof: Result<OrbitProof, ProofError>,
}

/// What the list may lack.
#[derive(Clone, Debug, PartialEq)]
pub enum Gap {
    /// The cover of P has a rim.
    Cover {
        /// Points at which no chart was possible; if there are none, too many squares would be needed.
        singular: usize,
        /// The curve that bends P there, if one is near.
        near: Option<NearCurve>,
    },
    /// Cells that could not be decided.
    Cells {
        /// How many.
        count: usize,
        /// The search ended because [`ListOptions::cells`] were examined.
        spent: bool,
        /// The direction γ of one of them.
        gamma: [f64; 3],
        /// They all meet the line of tangency.
        at_tangency: bool,
    },
    /// Orbits that were found at some of their points only.
    Points {
        /// How many.
        count: usize,
    },
}

/// All orbits.
#[derive(Clone, Debug)]
pub struct OrbitList {
    /// The isolated orbits, by crossings, then by period.
    pub orbits: Vec<ListedOrbit>,
    /// A member of each continuum of orbits of the same period.
    pub continua: Vec<PeriodicOrbit>,
    /// For m = 1, 2, …: the sum of the indices of all isolated fixed points of Rᵐ.
    pub index_sums: Vec<i32>,
    /// What may be missing; empty if the list is complete.
    pub gaps: Vec<Gap>,
    /// No motion was followed longer than this.
    pub longest: f64,
    /// Motions that had not returned by then.
    pub slow: usize,
    /// Cells examined, and motions followed.
    pub effort: [usize; 2],
}

/// Why there is no list.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ListError {
    /// There is no section.
    #[error(transparent)]
    Setting(#[from] PoincareError),
    /// A motion could not be followed, or the work was stopped.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// An orbit that was found could not be described.
    #[error("an orbit that was found cannot be described")]
    Orbit(#[from] OrbitError),
}

/// How often a cell is cut into four.
const LEVELS: u32 = 14;
/// The most squares of a cover.
pub const CHARTS: usize = 100_000;
/// Points at which the cover starts, in all components together.
const SEEDS: usize = 48;
/// How long a motion is followed, in periods of a slow swing about the lowest position.
const SWINGS: f64 = 100.0;

/// The periodic orbits at a point.
///
/// # Errors
/// [`ListError`].
pub fn list(setting: &SectionSetting, options: &ListOptions, monitor: &Monitor) -> Result<OrbitList, ListError> {
    list_watched(setting, options, monitor, &mut |_| {})
}

/// The same; `watch` is called as the work goes on.
///
/// # Errors
/// [`ListError`].
pub fn list_watched(
    setting: &SectionSetting,
    options: &ListOptions,
    monitor: &Monitor,
    watch: &mut dyn FnMut(Stage),
) -> Result<OrbitList, ListError> {
    let top = setting.torus().top();
    let surface = Surface::new(top, setting.h(), setting.l());
    let mut seeds = Vec::with_capacity(SEEDS);
    for start in setting.spread_watched(SEEDS, 0, monitor)? {
        seeds.push(surface.point(&setting.state(start)?));
    }
    let mut covered = |[squares, checked]: [usize; 2]| watch(Stage::Cover { squares, checked });
    let cover = cover(&surface, &seeds, CHARTS, monitor, &mut covered);
    let longest = longest(top);
    let map = SectionMap::new(&surface, setting.torus(), longest, monitor);
    let turns = (options.crossings.min(MOST_CROSSINGS) / 2) as usize;
    let search_options = SearchOptions { turns, levels: LEVELS, cells: options.cells };
    let found = search(&map, &cover, &search_options, watch)?;
    let mut gaps = gaps(setting, &surface, &cover, &found);
    let grouped = group::orbits(&map, &found.points, turns)?;
    if grouped.incomplete > 0 {
        gaps.push(Gap::Points { count: grouped.incomplete });
    }
    let mut orbits = Vec::with_capacity(grouped.cycles.len());
    for (tried, cycle) in grouped.cycles.iter().enumerate() {
        watch(Stage::Proofs { tried, found: grouped.cycles.len() });
        let state = surface.state(&cycle.start);
        // Of several maxima the description would choose any; the list takes the largest, at which the orbit is proved.
        let orbit = PeriodicOrbit { start: state, ..PeriodicOrbit::new(top, &state, cycle.period)? };
        let ([g1, g2, g3], [w1, w2, w3]) = (state.gamma, top.inverse_inertia(state.l));
        let start = [g1, g2, g3, w1, w2, w3];
        let proof = prove(setting.body(), setting.point(), start, cycle.turns, 2.0 * cycle.period);
        orbits.push(ListedOrbit { orbit, index: cycle.index, proof });
    }
    let mut continua = Vec::new();
    for (start, period) in curves::families(&map, &found.on_curves)? {
        continua.push(PeriodicOrbit::new(top, &surface.state(&start), period)?);
    }
    Ok(OrbitList {
        orbits,
        continua,
        index_sums: grouped.index_sums,
        gaps,
        longest,
        slow: found.slow,
        effort: [found.cells, found.motions],
    })
}

/// The longest time for which a motion is followed: many times 2π√(A_max/|r|).
pub(crate) fn longest(top: &HeavyTop) -> f64 {
    let largest = top.moments().into_iter().fold(0.0, f64::max);
    SWINGS * std::f64::consts::TAU * (largest / top.center_norm()).sqrt()
}

fn gaps(setting: &SectionSetting, surface: &Surface, cover: &Cover, found: &Found) -> Vec<Gap> {
    let mut gaps = Vec::new();
    if !cover.closed {
        let near = NearCurve::of(setting, surface, &cover.singular);
        gaps.push(Gap::Cover { singular: cover.singular.len(), near });
    }
    if let Some(OpenCell { middle, .. }) = found.open.first() {
        let at_tangency = found.open.iter().all(|cell| cell.at_tangency);
        let gamma = [middle[0], middle[1], middle[2]];
        gaps.push(Gap::Cells { count: found.open.len(), spent: found.spent, gamma, at_tangency });
    }
    gaps
}
