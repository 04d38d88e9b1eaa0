//! Motion with proved bounds: sets that hold the exact motion of a heavy rigid body at the times that are asked for.
//!
//! The equations are quadratic ([`field`]). A step takes the Taylor polynomial p of the motion from the middle of the
//! present set, in any arithmetic ([`scalar`]), as a guess; what the guess leaves in the equations, its **defect**
//! d = ṗ − f(p), is bounded with every rounding in it, and the theorem in [`step`] turns that into a bound of the motion
//! of the whole set. The set is the image of the box of the start and a few ellipsoids that hold what was added on the way
//! ([`set`]), in doubles, whatever the precision of its middle. From time to time the [`integrals`] cut off what cannot be
//! there. [`orbit`] puts steps together.
//!
//! Bounds are sums and products of numbers that are not negative, computed in doubles and then enlarged by more than all
//! their roundings ([`bound`]). Nothing depends on the machine.

pub mod bound;
pub mod field;
pub mod integrals;
pub mod orbit;
pub mod return_map;
pub mod scalar;
pub mod set;
pub mod start;
pub mod step;
