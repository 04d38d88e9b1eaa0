//! Typed ids, tables that only their own ids index (the id of a curve cannot be taken for that of an event), and partitions
//! of indices.

use std::fmt::Debug;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// The number of a row in a [`Table`].
pub trait Id: Copy + Eq + Ord + Debug {
    /// The id of row `index`.
    fn at(index: usize) -> Self;

    /// The row, from 0.
    fn index(self) -> usize;
}

/// Declares ids: numbers that are of one kind of row only.
#[macro_export]
macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(usize);

        impl $crate::table::Id for $name {
            #[inline]
            fn at(index: usize) -> Self {
                Self(index)
            }

            #[inline]
            fn index(self) -> usize {
                self.0
            }
        }
    )+};
}
pub use crate::ids;

/// Rows numbered by `I`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table<I, T> {
    rows: Vec<T>,
    id: PhantomData<I>,
}

impl<I: Id, T> Table<I, T> {
    /// An empty table.
    #[must_use]
    pub fn new() -> Self {
        Self::from(Vec::new())
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True without rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The id that the next row will have.
    #[must_use]
    pub fn next_id(&self) -> I {
        I::at(self.rows.len())
    }

    /// Adds a row and returns its id.
    pub fn push(&mut self, row: T) -> I {
        let id = self.next_id();
        self.rows.push(row);
        id
    }

    /// The row, if there is one with this id.
    #[must_use]
    pub fn get(&self, id: I) -> Option<&T> {
        self.rows.get(id.index())
    }

    /// The first row.
    #[must_use]
    pub fn first(&self) -> Option<&T> {
        self.rows.first()
    }

    /// The last row.
    #[must_use]
    pub fn last(&self) -> Option<&T> {
        self.rows.last()
    }

    /// The ids in order.
    #[must_use]
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + Clone + use<I, T> {
        (0..self.rows.len()).map(I::at)
    }

    /// The rows in order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.rows.iter()
    }

    /// The rows in order.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.rows.iter_mut()
    }

    /// The rows in order, with their ids.
    #[must_use]
    pub fn pairs(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator + Clone {
        self.rows.iter().enumerate().map(|(index, row)| (I::at(index), row))
    }

    /// A table of the same ids with what `make` gives for each row.
    pub fn map<U>(&self, make: impl FnMut(&T) -> U) -> Table<I, U> {
        Table::from(self.rows.iter().map(make).collect::<Vec<_>>())
    }

    /// The rows.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        &self.rows
    }
}

impl<I: Id, T: Clone> Table<I, T> {
    /// One copy of `row` for each of `len` ids.
    #[must_use]
    pub fn filled(row: T, len: usize) -> Self {
        Self::from(vec![row; len])
    }
}

impl<I: Id, T> Default for Table<I, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<I: Id, T> Index<I> for Table<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        &self.rows[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for Table<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.rows[id.index()]
    }
}

impl<I, T> From<Vec<T>> for Table<I, T> {
    fn from(rows: Vec<T>) -> Self {
        Self { rows, id: PhantomData }
    }
}

impl<I, T> FromIterator<T> for Table<I, T> {
    fn from_iter<R: IntoIterator<Item = T>>(rows: R) -> Self {
        Self::from(Vec::from_iter(rows))
    }
}

impl<I: Id, T> Extend<T> for Table<I, T> {
    fn extend<R: IntoIterator<Item = T>>(&mut self, rows: R) {
        self.rows.extend(rows);
    }
}

impl<'a, I, T> IntoIterator for &'a Table<I, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.iter()
    }
}

impl<'a, I, T> IntoIterator for &'a mut Table<I, T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.iter_mut()
    }
}

impl<I, T> IntoIterator for Table<I, T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.rows.into_iter()
    }
}

/// Disjoint sets, each named by its smallest member.
#[derive(Clone, Debug, Default)]
pub struct Partition {
    parent: Vec<usize>,
}

impl Partition {
    /// Every number separately.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count).collect() }
    }

    /// Adds the next number, separately.
    pub fn add(&mut self) {
        self.parent.push(self.parent.len());
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
