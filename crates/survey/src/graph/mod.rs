//! The graph of classes: what lies beside what in the space of bodies.
//!
//! Up to units, and the order and the signs of its axes, a body is a [`Place`] of four parameters: A1 ≤ A2 ≤ A3 with the
//! sum 2, and r̂ with r_i ≥ 0. The second moments of mass are m_i = 1 − A_i with the sum 1, so bodies that exist are those
//! with m_i ≥ 0. The metric is |dA|² + |dr̂|², and *measure* is the area of the simplex of A times that of the octant of
//! r̂. A [`Line`] is straight in A and a great circle in r̂.
//!
//! A [`Walk`] stays in one class: each of its steps draws a line through its body, notes every [`Wall`] on the whole of
//! the line (where the class changes, and by which event), and goes to a body of its class on it. A [`ClassGraph`] joins
//! what walks have met. A walk from a special body stays in its [`Stratum`]. [`nearest`] finds the borders around a body,
//! [`deepen`] a body far from all of them.

mod chart;
mod chord;
mod classes;
mod deepen;
mod line;
mod nearest;
mod place;
mod stratum;
mod unseen;
mod walk;

pub use chart::Chart;
pub use chord::{Chord, Stretch, Wall, chord};
pub use classes::{ClassGraph, Edge, Node};
pub use deepen::{centre, deepen, plain};
pub use line::Line;
pub use nearest::{Nearest, NearestOptions, nearest};
pub use place::{Domain, Place};
pub use stratum::{STRATA, Stratum};
pub use unseen::Unseen;
pub use walk::{Step, Walk};
