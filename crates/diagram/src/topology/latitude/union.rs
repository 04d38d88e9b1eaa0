//! Arcs and gaps glued to components, and which components share a boundary circle.

/// Union-find over arcs (accessible) and gaps (not accessible) of all circles of latitude.
#[derive(Clone, Debug, Default)]
pub(super) struct Gluing {
    parent: Vec<usize>,
    accessible: Vec<bool>,
    borders: Vec<(usize, usize)>,
}

impl Gluing {
    /// Number of arcs and gaps so far, which is the number of the next one.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    pub fn add(&mut self, accessible: bool) {
        self.parent.push(self.parent.len());
        self.accessible.push(accessible);
    }

    pub fn root(&mut self, mut arc: usize) -> usize {
        while self.parent[arc] != arc {
            self.parent[arc] = self.parent[self.parent[arc]];
            arc = self.parent[arc];
        }
        arc
    }

    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// Records that an arc and a gap lie on both sides of one piece of ∂U.
    pub fn border(&mut self, arc: usize, gap: usize) {
        self.borders.push((arc, gap));
    }

    /// The roots of the components of U or of its complement, ascending.
    pub fn components(&mut self, accessible: bool) -> Vec<usize> {
        (0..self.len()).filter(|&arc| self.accessible[arc] == accessible && self.parent[arc] == arc).collect()
    }

    /// Boundary circles as pairs (component of U, component of the complement): on the sphere two components
    /// share at most one.
    pub fn boundary_circles(&mut self) -> Vec<(usize, usize)> {
        let borders = std::mem::take(&mut self.borders);
        let mut circles: Vec<_> = borders.into_iter().map(|(arc, gap)| (self.root(arc), self.root(gap))).collect();
        circles.sort_unstable();
        circles.dedup();
        circles
    }
}
