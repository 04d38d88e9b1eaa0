//! Pieces of ridges, put together.

use bifdiag_diagram::topology::{Component, Poles, sort_components};
use bifdiag_numbers::table::Partition;

/// Components of U_hl while they are put together: pieces of ridges, joined.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    /// Of each: Euler's characteristic and the poles in it.
    nodes: Vec<(i32, [bool; 2])>,
    links: Vec<[usize; 2]>,
}

impl Pieces {
    pub fn add(&mut self, characteristic: i32, poles: [bool; 2]) -> usize {
        self.nodes.push((characteristic, poles));
        self.nodes.len() - 1
    }

    pub fn join(&mut self, p: usize, q: usize) {
        self.links.push([p, q]);
    }

    /// The components, in canonical order; `None` if one is no part of a sphere.
    pub fn components(&self) -> Option<Vec<Component>> {
        let mut classes = Partition::new(self.nodes.len());
        for &[p, q] in &self.links {
            classes.unite(p, q);
        }
        let mut sums = vec![(0, [false; 2]); self.nodes.len()];
        let mut roots = Vec::new();
        for (node, (characteristic, poles)) in self.nodes.iter().enumerate() {
            let root = classes.find(node);
            if !roots.contains(&root) {
                roots.push(root);
            }
            sums[root].0 += characteristic;
            sums[root].1 = [sums[root].1[0] || poles[0], sums[root].1[1] || poles[1]];
        }
        let components = roots.into_iter().map(|root| {
            let (characteristic, [plus, minus]) = sums[root];
            let boundary_circles = u32::try_from(2 - characteristic).ok()?;
            Some(Component { boundary_circles, poles: Some(Poles { plus, minus }) })
        });
        let mut components: Vec<Component> = components.collect::<Option<_>>()?;
        sort_components(&mut components);
        Some(components)
    }
}
