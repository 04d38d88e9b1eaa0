//! The two files of a scan or of a shard, the rows and the summary, and what the terminal shows of them.

use std::fs::{self, File};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use bifdiag_documents::scan::{read_design, read_row, scan_summary};
use bifdiag_documents::words::counted;
use bifdiag_schema::{RowDocument, ScanSummaryDocument};
use bifdiag_survey::scan::Summary;
use sha2::{Digest, Sha256};

use super::journal::Identity;
use super::table::Format;
use crate::cli::export::beside;
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::interrupt::{unfinished, uninterrupted};
use crate::cli::terminal::{Report, Table};

/// Where the summary of a file with rows lies.
pub fn summary_path(rows: &Path) -> PathBuf {
    beside(rows, ".summary.json")
}

/// The format of an output file.
pub fn format_of(out: &Path, format: Option<Format>) -> Result<Format, Failure> {
    let Some(format) = format.or_else(|| Format::of(out)) else {
        let right = "use .parquet, .csv or .jsonl, or give --format";
        return Err(Failure::input(format!(
            "--out {}: the extension does not give the format; {right}",
            out.display()
        )));
    };
    let folder = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."));
    fs::metadata(folder).map_err(|error| {
        Failure::input(format!("--out {}: {error}; choose a file in an existing folder", out.display()))
    })?;
    available(format, out)
}

/// The format of a file with rows that is to be read.
pub fn format_of_input(path: &Path) -> Result<Format, Failure> {
    let format = Format::of(path).ok_or_else(|| {
        let right = "name a file with the rows of a scan";
        Failure::input(format!("{}: the extension is not .parquet, .csv or .jsonl; {right}", path.display()))
    })?;
    available(format, path)
}

fn available(format: Format, path: &Path) -> Result<Format, Failure> {
    if format.is_available() {
        return Ok(format);
    }
    Err(Failure::input(format!(
        "{}: this bifdiag was built without the feature `parquet`; use .csv or .jsonl, or build it with --features parquet",
        path.display()
    )))
}

/// Writes rows and summary under other names and renames both when they are whole.
pub fn write(
    out: &Path,
    format: Format,
    identity: &Identity,
    rows: impl FnOnce(&mut dyn FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure>,
) -> Result<ScanSummaryDocument, Failure> {
    let fresh = beside(out, ".partial.new");
    let fresh_summary = beside(out, ".summary.new");
    unfinished().extend([fresh.clone(), fresh_summary.clone()]);
    let file = File::create(&fresh).map_err(unwritten(&fresh))?;
    let writer = HashingWriter::new(BufWriter::with_capacity(1 << 18, file));
    let mut summary = Summary::default();
    let mut sink = format.sink(writer).map_err(unwritten(out))?;
    rows(&mut |row| {
        let unreadable = failed(format!("cannot read body {} of {} back", row.index, out.display()));
        summary.add(&read_row(&row).map_err(unreadable)?);
        sink.write(&row).map_err(unwritten(out))
    })?;
    let (mut writer, sha256) = sink.finish().map_err(unwritten(out))?.finish();
    writer.flush().and_then(|()| writer.get_ref().sync_all()).map_err(unwritten(&fresh))?;
    drop(writer);
    let document = scan_summary(&summary, identity.document(), format.name(), sha256);
    let text = bifdiag_documents::layout::text(&document)?;
    let summary_out = summary_path(out);
    fs::write(&fresh_summary, text).map_err(unwritten(&fresh_summary))?;
    let _guard = uninterrupted();
    fs::rename(&fresh, out).map_err(unwritten(out))?;
    fs::rename(&fresh_summary, &summary_out).map_err(unwritten(&summary_out))?;
    unfinished().clear();
    Ok(document)
}

/// The summary beside a file with rows, which are what it describes.
pub fn checked_summary(rows: &Path) -> Result<ScanSummaryDocument, Failure> {
    let text = fs::read_to_string(summary_path(rows)).map_err(|error| no_summary(rows, &error))?;
    let summary = bifdiag_documents::reading::scan_summary(&text, &rows.to_string_lossy())
        .map_err(|error| no_summary(rows, &error))?;
    let digest = digest_of(rows).map_err(|error| no_shard(rows, &error))?;
    if digest == summary.sha256 {
        return Ok(summary);
    }
    let why = "does not match its summary (its SHA-256 differs): it is truncated or altered; compute it again";
    Err(Failure::input(format!("{} {why}", rows.display())))
}

/// Which scan a file with rows belongs to, by its summary.
pub fn identity(rows: &Path, summary: ScanSummaryDocument) -> Result<Identity, Failure> {
    let ScanSummaryDocument { program, accuracy, design, range, .. } = summary;
    let design = read_design(&design).map_err(|error| no_summary(rows, &error))?;
    Ok(Identity { program, accuracy, design, range })
}

/// The summary of a file, if this very scan has finished it; refuses any other file.
pub fn finished(out: &Path, wanted: &Identity) -> Result<ScanSummaryDocument, Failure> {
    let difference = match checked_summary(out).and_then(|document| Ok((document.clone(), identity(out, document)?))) {
        Ok((document, found)) if found == *wanted => return Ok(document),
        Ok((_, found)) => found.difference(wanted).unwrap_or("the shard"),
        Err(_no_scan) => {
            return Err(Failure::input(format!(
                "{} exists and is not a finished scan; choose another --out, or leave out --keep to replace it",
                out.display()
            )));
        }
    };
    Err(Failure::input(format!(
        "{} holds another finished scan ({difference} differs); choose another --out, or leave out --keep to replace it",
        out.display()
    )))
}

fn no_summary(rows: &Path, reason: &impl ToString) -> Failure {
    let (path, summary, reason) = (rows.display(), summary_path(rows), reason.to_string());
    let summary = summary.display();
    Failure::input(format!(
        "{path}: its summary {summary} cannot be read ({reason}); a shard consists of a file with rows and its summary"
    ))
}

/// A scan without a place for its rows.
pub fn no_out() -> Failure {
    Failure::input("--out is missing; give a file such as --out scan.parquet (or .csv, .jsonl), or --out - for stdout")
}

/// A shard that is not there.
pub fn no_shard(path: &Path, error: &io::Error) -> Failure {
    Failure::input(format!("{}: {error}; name the shards to be merged", path.display()))
}

fn unwritten<E: std::error::Error + Send + Sync + 'static>(path: &Path) -> impl FnOnce(E) -> Failure {
    failed(format!("cannot write {}", path.display()))
}

/// The most frequent classes that are listed.
const LISTED: usize = 12;

/// What the terminal shows of a scan.
pub fn report(document: &ScanSummaryDocument, out: &Path) -> String {
    let mut report = Report::default();
    report.line(format!(
        "{}: {} classified, {} undecided, {} failed",
        counted(document.rows, "body", "bodies"),
        document.classified,
        document.undecided,
        document.failed
    ));
    let single = document.classes.iter().filter(|class| class.bodies == 1).count();
    let classes = counted(document.classes.len(), "class", "classes");
    report.line(match (document.classes.len(), single) {
        (0, _) => "no class was found".to_owned(),
        (1, 1) => format!("{classes}, met once"),
        (1, _) => format!("{classes}, met {} times", document.classified),
        (all, single) if all == single => format!("{classes}, each met once"),
        _ => format!("{classes}, {single} of them met once"),
    });
    if let Some((most, record)) = document.critical_points.last_key_value() {
        report.line(format!(
            "at most {} at one l (body {}; a circle or sphere of them counted once)",
            counted(*most, "relative equilibrium", "relative equilibria"),
            record.first.index
        ));
    }
    let mut table = Table::new(&["class", "bodies", "share", "regions", "cusps", "pitchforks", "crossings", "first"]);
    for class in document.classes.iter().take(LISTED) {
        let [cusps, pitchforks, crossings] = class.events;
        table.row([
            class.class.clone(),
            class.bodies.to_string(),
            format!("{:.2}%", 100.0 * class.bodies as f64 / document.rows.max(1) as f64),
            class.regions.to_string(),
            cusps.to_string(),
            pitchforks.to_string(),
            crossings.to_string(),
            class.first.index.to_string(),
        ]);
    }
    if !document.classes.is_empty() {
        report.line("");
        report.line(table.text());
    }
    if document.classes.len() > LISTED {
        report.line(format!("and {} more in the summary", document.classes.len() - LISTED));
    }
    report.line("");
    report.line(format!("written: {}", out.display()));
    report.line(format!("written: {}", summary_path(out).display()));
    report.text()
}

/// A finished digest in 64 hexadecimal digits.
pub fn hexadecimal(digest: Sha256) -> String {
    base16ct::lower::encode_string(&digest.finalize())
}

/// Passes everything on and keeps its digest.
struct HashingWriter<W> {
    inner: W,
    digest: Sha256,
}

impl<W: Write> HashingWriter<W> {
    fn new(inner: W) -> Self {
        Self { inner, digest: Sha256::new() }
    }

    /// The writer below and the digest.
    fn finish(self) -> (W, String) {
        (self.inner, hexadecimal(self.digest))
    }
}

impl<W: Write> Write for HashingWriter<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.inner.write(bytes)?;
        self.digest.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

/// The digest of a file.
fn digest_of(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let mut digest = Sha256::new();
    let mut buffer = vec![0; 1 << 18];
    loop {
        match file.read(&mut buffer)? {
            0 => return Ok(hexadecimal(digest)),
            count => digest.update(&buffer[..count]),
        }
    }
}
