//! Why a figure cannot be drawn.

use dynamics::section::SectionError;
use thiserror::Error;

use crate::cli::failure::CommandError;

/// A figure shows sections that could not be computed.
#[derive(Debug, Error)]
#[error("the sections of a figure could not be computed")]
pub struct FigureSection(#[from] SectionError);

impl CommandError for FigureSection {}
