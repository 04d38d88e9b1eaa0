//! What a picture of sections shows.

use bifdiag_dynamics::section::{OrbitSection, Portrait};
use bifdiag_page::{Theme, Width};

/// A number for each orbit, by which it is coloured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitValues<'a> {
    /// What it is, such as `Lyapunov exponent`; printed at the colour bar.
    pub label: &'a str,
    /// One for each orbit of the scene, in the same order; NaN for an orbit without a value, drawn grey.
    pub values: &'a [f64],
}

/// The meaning of the colours of orbits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OrbitColors {
    /// The family by the hue, the orbits of a family by shades.
    #[default]
    Orbits,
    /// The family alone.
    Families,
    /// The families are verdicts: regular (in shades, to distinguish tori), chaotic, open.
    Verdicts,
}

/// Families of orbits, each with a hue of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrbitFamilies<'a> {
    /// The family of each orbit of the scene, in the same order: a place in `names`.
    pub of: &'a [usize],
    /// What the legend says of each; the same for all scenes of a picture.
    pub names: &'a [&'a str],
    /// Further meanings of the colours.
    pub colors: OrbitColors,
}

/// What is drawn over the orbits of a section: manifolds of periodic orbits or equilibria, and points on them. A point is γ and its
/// sheet; a polyline of one point is drawn as a dot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionCurves {
    /// Polylines of motions that leave the periodic orbits or equilibria.
    pub unstable: Vec<Vec<([f64; 3], i8)>>,
    /// Polylines of motions that come to them.
    pub stable: Vec<Vec<([f64; 3], i8)>>,
    /// Points of the periodic orbits.
    pub orbits: Vec<([f64; 3], i8)>,
    /// Unstable equilibria, on both sheets.
    pub rests: Vec<([f64; 3], i8)>,
    /// Points of orbits that connect them.
    pub connections: Vec<([f64; 3], i8)>,
}

/// A section and the orbits on it.
#[derive(Clone, Copy, Debug)]
pub struct SectionScene<'a> {
    /// The section.
    pub portrait: &'a Portrait,
    /// Its orbits.
    pub orbits: &'a [OrbitSection],
    /// What colours the orbits; `None`: their families.
    pub values: Option<OrbitValues<'a>>,
    /// The families of the orbits; `None`: one.
    pub families: Option<OrbitFamilies<'a>>,
    /// What is drawn over the orbits.
    pub curves: Option<&'a SectionCurves>,
    /// What is printed beside (h, l), such as the section's type.
    pub caption: &'a str,
}

/// On what the sections are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Projection {
    /// T⁻ and T⁺, the halves of the PP-torus, with (ψ', ϑ').
    #[default]
    Torus,
    /// S⁻ and S⁺, two copies of the Poisson sphere, with (ψ, ϑ).
    Sphere,
    /// Both, the sphere above the torus.
    Both,
}

/// How sections are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionOptions {
    /// On what.
    pub projection: Projection,
    /// Diameter of a point in pixels; `None`: by the number of points.
    pub point_size: Option<f64>,
    /// With more crossings than this on the page they are drawn as images, which bound the size of the file.
    pub raster_above: usize,
    /// The title; `None`: the body.
    pub title: Option<String>,
    /// Colours.
    pub theme: Theme,
    /// For what width the panels are laid out.
    pub width: Width,
}

impl Default for SectionOptions {
    fn default() -> Self {
        Self {
            projection: Projection::Torus,
            point_size: None,
            raster_above: 20_000,
            title: None,
            theme: Theme::Light,
            width: Width::PAGE,
        }
    }
}
