//! What the options say: values, bodies, points, accuracy, files that are read.

mod accuracy;
mod body;
mod file;
mod part;
pub mod values;

pub use accuracy::accuracy;
pub use body::{BodyArguments, BodyInput, head};
pub use file::{read, stdin};
pub use part::{GivenPart, PartArguments, PartInput, shown};
