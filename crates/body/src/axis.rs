//! Axes by type: the principal axes of the frame, sorted by moment, cannot be taken for those of the body as given.

use std::fmt;
use std::ops::{Index, IndexMut};

/// Declares kinds of axes: each numbers lists of three, and no other kind's.
macro_rules! axes {
    ($($(#[$doc:meta])* $name:ident;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(u8);

        impl $name {
            /// The three axes, in order.
            pub const ALL: [Self; 3] = [Self(0), Self(1), Self(2)];

            /// The axis after this one; the first after the last.
            #[must_use]
            #[inline]
            pub fn next(self) -> Self {
                Self((self.0 + 1) % 3)
            }

            /// The other two axes, in cyclic order.
            #[must_use]
            #[inline]
            pub fn others(self) -> [Self; 2] {
                [self.next(), self.next().next()]
            }

            /// Its place in the order, from 0.
            #[must_use]
            #[inline]
            pub fn index(self) -> usize {
                usize::from(self.0)
            }
        }

        impl<T> Index<$name> for [T; 3] {
            type Output = T;

            #[inline]
            fn index(&self, axis: $name) -> &T {
                &self[axis.index()]
            }
        }

        impl<T> IndexMut<$name> for [T; 3] {
            #[inline]
            fn index_mut(&mut self, axis: $name) -> &mut T {
                &mut self[axis.index()]
            }
        }
    )+};
}

axes! {
    /// A principal axis of a [`Frame`](super::Frame), in its order: by rising moment.
    Axis;
    /// An axis in which the body was given: A1 is the moment about the first. Shown as `1`, `2`, `3`.
    BodyAxis;
}

impl fmt::Display for BodyAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0 + 1)
    }
}
