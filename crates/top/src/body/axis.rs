//! Axes by type: the principal axes of the frame, sorted by moment, cannot be taken for those of the body as given.

use std::fmt;
use std::ops::{Index, IndexMut};

/// A principal axis of a [`Frame`](super::Frame), in its order: by rising moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Axis(u8);

impl Axis {
    /// The three axes, by rising moment.
    pub const ALL: [Self; 3] = [Self(0), Self(1), Self(2)];

    /// The axis after this one; the first after the last.
    #[must_use]
    pub fn next(self) -> Self {
        Self((self.0 + 1) % 3)
    }

    /// The other two axes, in cyclic order.
    #[must_use]
    pub fn others(self) -> [Self; 2] {
        [self.next(), self.next().next()]
    }

    /// Its place in the frame, from 0.
    #[must_use]
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

impl<T> Index<Axis> for [T; 3] {
    type Output = T;

    fn index(&self, axis: Axis) -> &T {
        &self[axis.index()]
    }
}

impl<T> IndexMut<Axis> for [T; 3] {
    fn index_mut(&mut self, axis: Axis) -> &mut T {
        &mut self[axis.index()]
    }
}

/// An axis in which the body was given: A1 is the moment about the first. Shown as `1`, `2`, `3`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyAxis(u8);

impl BodyAxis {
    /// The three axes, as they were given.
    pub const ALL: [Self; 3] = [Self(0), Self(1), Self(2)];

    /// The other two axes, in cyclic order.
    #[must_use]
    pub fn others(self) -> [Self; 2] {
        [(self.0 + 1) % 3, (self.0 + 2) % 3].map(Self)
    }

    /// Its place in the body's lists, from 0.
    #[must_use]
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

impl<T> Index<BodyAxis> for [T; 3] {
    type Output = T;

    fn index(&self, axis: BodyAxis) -> &T {
        &self[axis.index()]
    }
}

impl fmt::Display for BodyAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0 + 1)
    }
}
