//! What pictures need of several layers at once; `plot` knows finished documents alone.

mod curves;
#[cfg(feature = "parallel")]
mod map;
#[cfg(feature = "parallel")]
mod shown;

pub use curves::Curves;
#[cfg(feature = "parallel")]
pub use map::map;
#[cfg(feature = "parallel")]
pub use shown::{Seen, Shown, Shows};
