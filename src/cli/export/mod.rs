//! Results given out: documents, tables and pictures, each in the formats that know how to write it.

mod columns;
mod csv;
mod error;
mod exporter;
mod files;
mod json;
mod jsonl;
mod npz;
#[cfg(feature = "parquet")]
mod parquet;
mod partial;
mod picture;
mod pieces;
mod target;

pub use columns::{Column, Columns, Values};
pub use error::ExportError;
pub use exporter::Exporter;
pub use files::FileSet;
pub use json::{Json, answer};
pub use npz::Archive;
pub use partial::{beside, journal_path, open_alone};
pub use picture::{PictureArguments, PictureFormat, RESOLUTION, WidthArgument};
pub use pieces::Pieces;
pub use target::{DataFormat, DataTarget, directory};
