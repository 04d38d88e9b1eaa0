//! `bifdiag verify`: checks an atlas by other means than those that made it.

mod error;

use std::path::PathBuf;

use clap::Args;
use schema::{AtlasDocument, BodyDocument, ComponentDocument};
use top::body::Body;
use top::topology::latitude;
use verify::{cross_check, verify};

use super::export::ExportError;
use super::failure::Failure;
use super::input::read;
use super::terminal::{Report, Timings, print};
use error::VerifyError;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag --body paper --accuracy certified && bifdiag verify bifdiag-out/atlas.json
  bifdiag --body katok:6 --accuracy certified --json | bifdiag verify -

A certified atlas is checked as a proof, by separate code; any other is compared with the second topological method,
which is no proof. Exit status: 0 verified; 1 refused, with the first thing that is wrong; 2 the file is no atlas.";

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
    let document: AtlasDocument =
        serde_json::from_str(&text).map_err(|source| VerifyError::NoAtlas { path: path(), source })?;
    // What a certified atlas means is in its bytes: they must be those that bifdiag writes.
    if document.certificate.is_some() {
        let own = documents::layout::text(&document).map_err(ExportError::from)?;
        if own.trim_end() != text.trim_end() {
            return Err(VerifyError::Damaged { path: path() }.into());
        }
    }
    let check = || if document.certificate.is_some() { verify(&document) } else { cross_check(&document, sweep) };
    let report = timings.stage("verify", check).map_err(VerifyError::from)?;
    let mut lines = Report::default();
    lines.line(if report.proof {
        format!(
            "verified: {} regions, {} events, {} pairs of curves",
            document.regions.len(),
            report.events,
            report.pairs
        )
    } else {
        format!("{} regions agree with the sweep over latitudes; this is a cross-check and no proof", report.regions)
    });
    if !report.open.is_empty() {
        lines.line(format!("topology not confirmed: {}", report.open.join(", ")));
    }
    Ok(print(lines.text())?)
}

/// The components of U by the sweep over latitudes: the second method for an atlas without certificate.
fn sweep(body: &BodyDocument, h: f64, l: f64) -> Option<Vec<ComponentDocument>> {
    let frame = Body::parse(&body.moments, &body.center).ok()?.frame();
    let found = latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit).ok()?;
    Some(found.iter().map(documents::component).collect())
}
