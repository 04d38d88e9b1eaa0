//! Answers at one point or one momentum.

use bifdiag::{Answer, top};
use pyo3::prelude::*;

/// One connected component of the accessible region, with the energy surface and the section over it.
#[pyclass(frozen, eq, get_all, module = "bifdiag")]
#[derive(Clone, PartialEq)]
pub struct Component {
    boundary_circles: u32,
    poles: Option<Vec<&'static str>>,
    accessible_region: String,
    energy_surface: String,
    section: Option<String>,
    genus: Option<u32>,
}

impl Component {
    pub fn list(components: &[top::topology::Component]) -> Vec<Self> {
        components.iter().map(Self::of).collect()
    }

    fn of(component: &top::topology::Component) -> Self {
        let poles = component.poles.map(|poles| {
            [(poles.plus, "+"), (poles.minus, "-")]
                .into_iter()
                .filter(|(there, _)| *there)
                .map(|(_, sign)| sign)
                .collect()
        });
        Self {
            boundary_circles: component.boundary_circles,
            poles,
            accessible_region: component.accessible_region(),
            energy_surface: component.energy_surface(),
            section: component.section(),
            genus: component.genus(),
        }
    }
}

#[pymethods]
impl Component {
    fn __repr__(&self) -> String {
        format!(
            "Component(U={}, E={}, P={})",
            self.accessible_region,
            self.energy_surface,
            self.section.as_deref().unwrap_or("-")
        )
    }
}

/// What is known of a point: `status` is "regular", "forbidden", "critical" or "undecided".
#[pyclass(frozen, get_all, module = "bifdiag")]
pub struct Classification {
    status: &'static str,
    components: Option<Vec<Component>>,
    candidates: Vec<Vec<Component>>,
    signature: Option<String>,
    /// |h − h_c| to the nearest curve, that curve, and the bound on the error of the distance.
    margin: (f64, Option<String>, f64),
}

impl Classification {
    pub fn of(found: &bifdiag::Classification) -> Self {
        let status = match found.answer {
            Answer::Regular(_) => "regular",
            Answer::Forbidden => "forbidden",
            Answer::Critical(_) => "critical",
            Answer::Undecided(_) => "undecided",
        };
        let margin = &found.margin;
        Self {
            status,
            components: found.components().map(Component::list),
            candidates: found.candidates().iter().map(|class| Component::list(class)).collect(),
            signature: found.components().filter(|class| !class.is_empty()).and_then(top::topology::signature),
            margin: (margin.h, margin.nearest.map(|curve| curve.to_string()), margin.error_bound),
        }
    }
}

#[pymethods]
impl Classification {
    fn __repr__(&self) -> String {
        format!("Classification({}, {})", self.status, self.signature.as_deref().unwrap_or("-"))
    }
}

/// A relative equilibrium.
#[pyclass(frozen, get_all, module = "bifdiag")]
pub struct Equilibrium {
    h: f64,
    gamma: [f64; 3],
    omega: f64,
    index: u8,
    branch: Option<String>,
}

impl Equilibrium {
    pub fn of(found: &top::critical::Equilibrium) -> Self {
        let branch = found.curve.map(|curve| curve.to_string());
        Self { h: found.h, gamma: found.gamma, omega: found.omega, index: found.index, branch }
    }
}

#[pymethods]
impl Equilibrium {
    fn __repr__(&self) -> String {
        format!("Equilibrium(h={}, gamma={:?}, index={})", self.h, self.gamma, self.index)
    }
}
