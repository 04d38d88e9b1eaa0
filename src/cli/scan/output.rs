//! The two files of a scan or of a shard: the rows and the summary.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use bifdiag_documents::scan::{ScanFile, design, read_design, read_row, scan_summary};
use bifdiag_schema::{RowDocument, ScanSummaryDocument};
use bifdiag_survey::scan::Summary;

use super::error::{ScanFailure, ScanInput};
use super::hashing::{self, HashingWriter};
use super::journal::Identity;
use super::table::{Format, TableError};
use crate::cli::export::beside;
use crate::cli::failure::Failure;
use crate::cli::terminal::interrupt::{unfinished, uninterrupted};

/// Where the summary of a file with rows lies.
pub fn summary_path(rows: &Path) -> PathBuf {
    beside(rows, ".summary.json")
}

/// The format of an output file.
pub fn format_of(out: &Path, format: Option<Format>) -> Result<Format, ScanInput> {
    let Some(format) = format.or_else(|| Format::of(out)) else {
        return Err(ScanInput::NoFormat { path: out.to_owned() });
    };
    let folder = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."));
    fs::metadata(folder).map_err(|source| ScanInput::Out { path: out.to_owned(), source })?;
    if format.is_available() { Ok(format) } else { Err(ScanInput::NoParquet { path: out.to_owned() }) }
}

/// The format of a file with rows that is to be read.
pub fn format_of_input(path: &Path) -> Result<Format, ScanInput> {
    let format = Format::of(path).ok_or_else(|| ScanInput::NoRows { path: path.to_owned() })?;
    if format.is_available() { Ok(format) } else { Err(ScanInput::NoParquet { path: path.to_owned() }) }
}

/// Writes rows and summary under other names and renames both when they are whole.
pub fn write(
    out: &Path,
    format: Format,
    identity: &Identity,
    rows: impl FnOnce(&mut dyn FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure>,
) -> Result<ScanSummaryDocument, Failure> {
    let fresh = beside(out, ".partial.new");
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Failure::from(ScanFailure::Write { path, source })
    };
    let table_failed = |source: TableError| Failure::from(ScanFailure::Table { path: out.to_owned(), source });
    let fresh_summary = beside(out, ".summary.new");
    unfinished().extend([fresh.clone(), fresh_summary.clone()]);
    let file = File::create(&fresh).map_err(failed(&fresh))?;
    let mut writer = HashingWriter::new(BufWriter::with_capacity(1 << 18, file));
    let mut summary = Summary::default();
    {
        let mut sink = format.sink(&mut writer).map_err(table_failed)?;
        rows(&mut |row| {
            let failed = |source| ScanFailure::Row { path: out.to_owned(), body: row.index, source };
            summary.add(&read_row(&row).map_err(failed)?);
            sink.write(&row).map_err(table_failed)
        })?;
        sink.finish().map_err(table_failed)?;
    }
    let (mut writer, sha256) = writer.finish();
    writer.flush().and_then(|()| writer.get_ref().sync_all()).map_err(failed(&fresh))?;
    drop(writer);
    let file = ScanFile {
        program: identity.program.clone(),
        accuracy: identity.accuracy,
        design: design(&identity.design),
        range: identity.range,
        format: format.name().to_owned(),
        sha256,
    };
    let document = scan_summary(&summary, file);
    let text = bifdiag_documents::layout::text(&document).map_err(ScanFailure::from)?;
    let summary_out = summary_path(out);
    fs::write(&fresh_summary, text).map_err(failed(&fresh_summary))?;
    let _guard = uninterrupted();
    fs::rename(&fresh, out).map_err(failed(out))?;
    fs::rename(&fresh_summary, &summary_out).map_err(failed(&summary_out))?;
    unfinished().clear();
    Ok(document)
}

/// The summary beside a file with rows, which are what it describes.
pub fn checked_summary(rows: &Path) -> Result<ScanSummaryDocument, ScanInput> {
    let text = fs::read_to_string(summary_path(rows)).map_err(|error| no_summary(rows, &error))?;
    let summary = bifdiag_documents::reading::scan_summary(&text, &rows.to_string_lossy())
        .map_err(|error| no_summary(rows, &error))?;
    let digest = hashing::of_file(rows).map_err(|source| ScanInput::Shard { path: rows.to_owned(), source })?;
    if digest == summary.sha256 { Ok(summary) } else { Err(ScanInput::Altered { path: rows.to_owned() }) }
}

/// Which scan a file with rows belongs to, by its summary.
pub fn identity(rows: &Path, summary: ScanSummaryDocument) -> Result<Identity, ScanInput> {
    let ScanSummaryDocument { program, accuracy, design, range, .. } = summary;
    let design = read_design(&design).map_err(|error| no_summary(rows, &error))?;
    Ok(Identity { program, accuracy, design, range })
}

fn no_summary(rows: &Path, reason: &impl ToString) -> ScanInput {
    ScanInput::NoSummary { path: rows.to_owned(), summary: summary_path(rows), reason: reason.to_string() }
}
