//! Newton continuation of relative equilibria, the second way to them: slower than the closed form and without its bounds,
//! but it knows nothing of it beyond the point it starts from.
//!
//! A predictor–corrector method in pseudo-arclength follows the solutions of B_j γ_j = r_j (j = 1, 2, 3), |γ|² = 1, with the
//! gaps B_j = λ − sA_j and s = Ω². That is sAγ + r = λγ: γ is a critical point of U_l on S², l = ΩJ.
//!
//! Unknowns are γ, Ω and the smallest gap b = B_i; the others are b + s(A_i − A_j), without cancellation. Distance along a
//! branch is measured by dγ, dΩ/Ω and dB_j/B_j. In that measure cusps, where dl = dh = 0, and the end l = 0 are ordinary
//! points, l → ∞ is as many steps away as ln l, and the sharp turn beside a pitchfork unfolded by a small r_j is a smooth
//! stretch of length ln r_j. As B_j γ_j = r_j, the signs of γ cannot change along a branch, and two branches of one body
//! differ in a sign: no step lands on another branch unseen.

mod branch;
mod follow;
mod newton;

pub use follow::{Start, follow};
