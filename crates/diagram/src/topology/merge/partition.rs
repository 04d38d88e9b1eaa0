//! To which component of U_hl a point belongs.

use super::descent::{Floor, descend};
use super::{Tree, off_critical};
use crate::topology::component::{Component, sort_by_component};
use crate::topology::potential::Potential;
use bifdiag_body::Frame;

/// The components of U_hl with the minima over which they lie.
#[derive(Clone, Debug)]
pub struct Partition<'a> {
    potential: Potential<'a>,
    minima: Vec<Floor>,
    /// Number of the component of each minimum.
    home: Vec<usize>,
    components: Vec<Component>,
}

impl<'a> Partition<'a> {
    /// From a finished tree and the components by the minimum that represents each.
    pub(super) fn new(mut tree: Tree<'a>, mut found: Vec<(usize, Component)>) -> Self {
        sort_by_component(&mut found);
        let mut number = |m: usize| {
            let home = tree.joined.find(m);
            found.iter().position(|(root, _)| *root == home).unwrap_or_default()
        };
        Self {
            home: (0..tree.minima.len()).map(&mut number).collect(),
            components: found.iter().map(|(_, component)| *component).collect(),
            potential: tree.potential,
            minima: tree.minima,
        }
    }

    /// The components in canonical order.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// The components in canonical order.
    #[must_use]
    pub fn into_components(self) -> Vec<Component> {
        self.components
    }

    /// The frame in which points are given.
    #[must_use]
    pub fn frame(&self) -> &'a Frame {
        self.potential.frame
    }

    /// The number in [`components`](Self::components) of the component of a point with U(γ) ≤ h, γ in the frame:
    /// that of the minimum to which a path with U ≤ U(γ) leads, proved. `None` if no path could be proved.
    #[must_use]
    pub fn component_of(&self, gamma: [f64; 3]) -> Option<usize> {
        if self.components.len() == 1 {
            return Some(0);
        }
        let start = off_critical(&self.potential, gamma)?;
        descend(&self.potential, start, &self.minima).map(|m| self.home[m])
    }

    /// Whether one of the minima that the partition was made of lies in a component.
    #[must_use]
    pub fn has_minimum(&self, component: usize, gamma: [f64; 3]) -> bool {
        self.minima.iter().zip(&self.home).any(|(minimum, home)| minimum.gamma == gamma && *home == component)
    }

    /// A minimum of U, in the frame, that lies in a component.
    #[must_use]
    pub fn minimum_of(&self, component: usize) -> Option<[f64; 3]> {
        let number = self.home.iter().position(|home| *home == component)?;
        Some(self.minima[number].gamma)
    }
}
