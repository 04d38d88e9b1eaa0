//! `bifdiag verify`: checks an atlas by other means than those that made it.

use std::io::Read;
use std::path::Path;

use schema::AtlasDocument;
use verify::verify;

use super::arguments::VerifyArguments;
use super::failure::{Failure, InputError};
use super::report::Report;
use super::timings::Timings;
use super::{layout, output};

pub fn run(arguments: &VerifyArguments, timings: &Timings) -> Result<(), Failure> {
    let text = read(&arguments.file)?;
    let wrong = |source| InputError::NoAtlas { path: arguments.file.clone(), source };
    let document: AtlasDocument = serde_json::from_str(&text).map_err(wrong)?;
    // What a certified atlas means is in its bytes: they must be those that bifdiag writes.
    if document.certificate.is_some() && layout::text(&document)?.trim_end() != text.trim_end() {
        return Err(Failure::Damaged { path: arguments.file.clone() });
    }
    let report = timings.stage("verify", || verify(&document))?;
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
    Ok(output::print(lines.text().as_bytes())?)
}

fn read(path: &Path) -> Result<String, InputError> {
    let unreadable = |source| InputError::AtlasFile { path: path.to_owned(), source };
    if path == Path::new("-") {
        let mut text = String::new();
        std::io::stdin().read_to_string(&mut text).map_err(unreadable)?;
        return Ok(text);
    }
    std::fs::read_to_string(path).map_err(unreadable)
}
