//! The body, its curves of relative equilibria, and that the certificate lacks none of them.

pub(crate) mod meetings;
pub(crate) mod pieces;
pub(crate) mod places;
pub(crate) mod roots;
pub(crate) mod spaces;
