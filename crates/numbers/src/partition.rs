//! Partitions of 0 … n − 1 that grow coarser: union-find.

/// Disjoint sets, each named by its smallest member.
#[derive(Clone, Debug)]
pub struct Partition {
    parent: Vec<usize>,
}

impl Partition {
    /// Every number by itself.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count).collect() }
    }

    /// The smallest number in the same set.
    pub fn find(&mut self, mut k: usize) -> usize {
        while self.parent[k] != k {
            self.parent[k] = self.parent[self.parent[k]];
            k = self.parent[k];
        }
        k
    }

    /// Makes one set of two.
    pub fn unite(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// How many sets there are.
    #[must_use]
    pub fn count(&self) -> usize {
        (0..self.parent.len()).filter(|&k| self.parent[k] == k).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_named_by_their_smallest_member() {
        let mut partition = Partition::new(6);
        for (a, b) in [(5, 3), (4, 5), (1, 2), (2, 1)] {
            partition.unite(a, b);
        }
        assert_eq!((0..6).map(|k| partition.find(k)).collect::<Vec<_>>(), [0, 1, 1, 3, 3, 3]);
        assert_eq!(partition.count(), 3);
    }
}
