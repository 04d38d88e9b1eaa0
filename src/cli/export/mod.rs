//! Results given out: documents, tables and pictures, each in the formats that know how to write it.

mod columns;
mod files;
mod journal;
mod npz;
#[cfg(feature = "parquet")]
pub mod parquet;
mod picture;
mod target;
mod text;

pub use columns::{Column, Columns, Pieces, Values};
pub use files::FileSet;
pub use journal::{Journal, beside, unusable};
pub use npz::Archive;
pub use picture::{DiagramArguments, PictureArguments, PictureFormat, WidthArgument};
pub use target::{DataFormat, DataTarget, answer, directory};
