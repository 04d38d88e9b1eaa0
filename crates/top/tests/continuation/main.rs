//! The tracker against the closed form of the relative equilibria.

mod branches;
mod closed_form;
mod pieces;
mod pitchforks;
mod special;
