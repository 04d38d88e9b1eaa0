//! What a picture of sections shows.

use crate::page::Theme;
use dynamics::section::{OrbitSection, Portrait};

/// A number for each orbit, by which it is coloured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitValues<'a> {
    /// What it is, such as `Lyapunov exponent`; printed at the colour bar.
    pub label: &'a str,
    /// One for each orbit of the scene, in the same order; NaN for an orbit without a value, drawn grey.
    pub values: &'a [f64],
}

/// A section and the orbits on it.
#[derive(Clone, Copy, Debug)]
pub struct SectionScene<'a> {
    /// The section.
    pub portrait: &'a Portrait,
    /// Its orbits.
    pub orbits: &'a [OrbitSection],
    /// What colours the orbits; `None`: each has a colour of its own, by its number.
    pub values: Option<OrbitValues<'a>>,
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
}

impl Default for SectionOptions {
    fn default() -> Self {
        Self { projection: Projection::Torus, point_size: None, raster_above: 20_000, title: None, theme: Theme::Light }
    }
}
