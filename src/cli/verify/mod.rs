//! `bifdiag verify`: checks an atlas by other means than those that made it.

mod error;

use std::path::PathBuf;

use bifdiag_verify::verify;
use clap::Args;

use super::export::ExportError;
use super::failure::Failure;
use super::input::read;
use super::terminal::{Report, Timings, print};
use error::VerifyError;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag --body paper --certificate && bifdiag verify bifdiag-out/atlas.json
  bifdiag --body katok:6 --certificate --json | bifdiag verify -

The certificate is checked as a proof, by separate code; the drawing is no part of it. Exit status: 0 verified; 1 refused, with the first thing that \
is wrong, or no certificate; 2 the file is no atlas of this version.";

/// `bifdiag verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The atlas.json to check (-: stdin)
    #[arg(value_name = "ATLAS.json")]
    pub file: PathBuf,
}

pub fn run(arguments: &VerifyArguments, timings: &Timings) -> Result<(), Failure> {
    let path = || arguments.file.clone();
    let text = read(&arguments.file).map_err(|source| VerifyError::File { path: path(), source })?;
    let name = arguments.file.to_string_lossy();
    let document = bifdiag_documents::reading::atlas(&text, &name)
        .map_err(|source| VerifyError::NoAtlas { path: path(), source })?;
    // What a certificate proves is in the bytes: they must be those that bifdiag writes.
    if document.certificate.is_some() {
        let own = bifdiag_documents::layout::text(&document).map_err(ExportError::from)?;
        if own.trim_end() != text.trim_end() {
            return Err(VerifyError::Damaged { path: path() }.into());
        }
    }
    let report = timings.stage("verify", || verify(&document)).map_err(VerifyError::from)?;
    let mut lines = Report::default();
    let (regions, events, pairs) = (document.regions.len(), report.events, report.pairs);
    let drawing = if document.drawing.is_some() { " (drawing not part of the proof)" } else { "" };
    lines.line(format!("verified: {regions} regions, {events} events, {pairs} pairs of curves{drawing}"));
    Ok(print(lines.text())?)
}
