//! Union-find over numbers.

/// Disjoint classes of 0 … n − 1, each named by its least member.
pub(crate) struct Classes {
    parent: Vec<usize>,
}

impl Classes {
    pub fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    pub fn root(&mut self, mut k: usize) -> usize {
        while self.parent[k] != k {
            self.parent[k] = self.parent[self.parent[k]];
            k = self.parent[k];
        }
        k
    }

    pub fn join(&mut self, p: usize, q: usize) {
        let (p, q) = (self.root(p), self.root(q));
        self.parent[p.max(q)] = p.min(q);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_named_by_their_least_member() {
        let mut classes = Classes::new(6);
        for (p, q) in [(4, 2), (5, 4), (1, 3)] {
            classes.join(p, q);
        }
        assert_eq!((0..6).map(|k| classes.root(k)).collect::<Vec<_>>(), [0, 1, 2, 1, 2, 2]);
    }
}
