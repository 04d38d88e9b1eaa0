//! `bifdiag verify`: checks an atlas by other means than those that made it.

use std::path::PathBuf;

use bifdiag_documents::reading::Claim;
use bifdiag_schema::SCHEMA_VERSION;
use bifdiag_verify::{verify, verify_point};
use clap::Args;

use super::failure::{Failure, failed};
use super::input::read;
use super::terminal::{Report, Timings, counted, print};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag --body paper --certificate && bifdiag verify bifdiag-out/atlas.json
  bifdiag --body katok:6 --certificate --json | bifdiag verify -
  bifdiag classify --body paper --h 3.8 --l 3.25 --certificate > p.json

The certificate is checked as a proof, by separate code; the drawing is not part of it. Exit status: 0 verified; 1 \
refused, with the first error found, or no certificate; 2 the file is neither an atlas nor the proof of a point of this version.";

/// `bifdiag verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The atlas.json to check, or the proof of a point by `classify --certificate` (-: stdin)
    #[arg(value_name = "ATLAS.json")]
    pub file: PathBuf,
}

pub fn run(arguments: &VerifyArguments, timings: &Timings) -> Result<(), Failure> {
    let path = arguments.file.display();
    let text = read(&arguments.file).map_err(|error| {
        Failure::input(format!(
            "{path}: {error}; give an atlas.json or the proof of a point that can be read, or - for stdin"
        ))
    })?;
    let claim = bifdiag_documents::reading::claim(&text, &arguments.file.to_string_lossy()).map_err(|error| {
        let what = "neither an atlas nor the proof of a point (classify --certificate)";
        Failure::input(format!("{path} is {what} of version {SCHEMA_VERSION}: {error}")).because(error)
    })?;
    let (document, canonical) = match &claim {
        Claim::Atlas(atlas) => (&**atlas, bifdiag_documents::layout::text(atlas)?),
        Claim::Point(point) => (&point.atlas, bifdiag_documents::layout::text(point)?),
    };
    // What a certificate proves is in the bytes: they must be those that bifdiag writes.
    if document.certificate.is_some() && canonical.trim_end() != text.trim_end() {
        let why = "its bytes are not those that bifdiag writes for an atlas with a certificate";
        return Err(Failure::work(format!("{path} is refused: {why}")));
    }
    let what = if matches!(claim, Claim::Atlas(_)) { "the atlas" } else { "the point" };
    let verify = || match &claim {
        Claim::Atlas(atlas) => verify(atlas),
        Claim::Point(point) => verify_point(point),
    };
    let report = timings.stage("verify", verify).map_err(failed(format!("{what} is refused")))?;
    let mut lines = Report::default();
    let (regions, events, pairs) = (document.regions.len(), report.events, report.pairs);
    let drawing = if document.drawing.is_some() { " (drawing not part of the proof)" } else { "" };
    if let Claim::Point(point) = &claim {
        let place = point.region.as_ref().map_or("is forbidden".to_owned(), |region| format!("lies in {region}"));
        lines.line(format!("verified: (h, l) = ({}, {}) {place}", point.h, point.l));
    }
    lines.line(format!(
        "verified: {}, {}, {}{drawing}",
        counted(regions, "region", "regions"),
        counted(events, "event", "events"),
        counted(pairs, "pair of curves", "pairs of curves")
    ));
    if !report.unproved.is_empty() {
        lines.line(format!(
            "not checked (\"proved\": false): verdicts by Arnold's theorem on {}",
            report.unproved.join(", ")
        ));
    }
    print(lines.text())
}
