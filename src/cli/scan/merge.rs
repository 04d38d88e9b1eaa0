//! `bifdiag scan merge`: the shards of a scan in one file.

use std::path::{Path, PathBuf};

use bifdiag_schema::RowDocument;

use super::arguments::MergeArguments;
use super::error::ScanInput;
use super::journal::Identity;
use super::table::Format;
use super::{output, report};
use crate::cli::export::answer;
use crate::cli::failure::Failure;

/// A shard that is what its summary says.
struct Part {
    path: PathBuf,
    format: Format,
    identity: Identity,
}

pub fn run(arguments: &MergeArguments) -> Result<(), Failure> {
    let out = arguments.out.as_deref().ok_or(ScanInput::NoOut)?;
    let format = output::format_of(out, arguments.format)?;
    let parts = parts(&arguments.shards, out)?;
    let Some(first) = parts.first() else { return Err(ScanInput::NoShards.into()) };
    let identity = Identity { range: [0, first.identity.design.count()], ..first.identity.clone() };
    let document = output::write(out, format, &identity, |take| {
        for part in &parts {
            pass_rows(part, take)?;
        }
        Ok(())
    })?;
    Ok(answer(arguments.json, &document, || report::text(&document, out))?)
}

/// The shards in the order of their bodies, once they are known to be whole, of one scan, and to leave nothing out.
fn parts(shards: &[PathBuf], out: &Path) -> Result<Vec<Part>, ScanInput> {
    let mut parts = shards.iter().map(|path| part(path, out)).collect::<Result<Vec<_>, _>>()?;
    if let Some((first, others)) = parts.split_first() {
        for part in others {
            if let Some(difference) = part.identity.difference(&first.identity) {
                return Err(ScanInput::Foreign { path: part.path.clone(), first: first.path.clone(), difference });
            }
        }
    }
    parts.sort_by_key(|part| part.identity.range);
    // A shard of no bodies stands between its neighbours and covers nothing.
    parts.retain(|part| part.identity.range[0] < part.identity.range[1] || part.identity.design.count() == 0);
    check_cover(&parts)?;
    Ok(parts)
}

/// A shard that is what its summary says.
fn part(path: &Path, out: &Path) -> Result<Part, ScanInput> {
    let same = |a: &Path, b: &Path| a == b || matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if same(path, out) {
        return Err(ScanInput::OutIsShard { path: path.to_owned() });
    }
    if let Err(source) = std::fs::metadata(path) {
        return Err(ScanInput::Shard { path: path.to_owned(), source });
    }
    let summary = output::checked_summary(path)?;
    let known = [Format::Parquet, Format::Csv, Format::Jsonl].into_iter().find(|f| f.name() == summary.format);
    let format = match known {
        Some(format) if format.is_available() => format,
        _ => output::format_of_input(path)?,
    };
    let identity = output::identity(path, summary)?;
    Ok(Part { path: path.to_owned(), format, identity })
}

/// Each body is in one of the parts, which stand in the order of their bodies.
fn check_cover(parts: &[Part]) -> Result<(), ScanInput> {
    let Some(first) = parts.first() else { return Ok(()) };
    let count = first.identity.design.count();
    let mut next = 0;
    let mut before: Option<&Part> = None;
    for part in parts {
        let [from, to] = part.identity.range;
        if from < next {
            let first = before.map_or_else(PathBuf::new, |before| before.path.clone());
            return Err(ScanInput::Overlap { first, second: part.path.clone(), body: from });
        }
        if from > next {
            let place = match before {
                Some(before) => format!("between {} and {}", before.path.display(), part.path.display()),
                None => format!("before {}", part.path.display()),
            };
            return Err(ScanInput::Missing { from: next, to: from, count, place });
        }
        next = to;
        before = Some(part);
    }
    if next < count {
        let place = before.map_or_else(String::new, |before| format!("after {}", before.path.display()));
        return Err(ScanInput::Missing { from: next, to: count, count, place });
    }
    Ok(())
}

/// Passes the rows of a shard on, each in its place.
fn pass_rows(part: &Part, take: &mut dyn FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure> {
    let [from, to] = part.identity.range;
    let table = |source| ScanInput::Table { path: part.path.clone(), source };
    let mut found = 0;
    for row in part.format.rows(&part.path).map_err(table)? {
        let row = row.map_err(table)?;
        let wanted = from + found;
        found += 1;
        if row.index != wanted || wanted >= to {
            let wrong = ScanInput::WrongRow { path: part.path.clone(), row: found, found: row.index, wanted };
            return Err(wrong.into());
        }
        take(row)?;
    }
    if found == to - from {
        Ok(())
    } else {
        Err(ScanInput::WrongCount { path: part.path.clone(), found, wanted: to - from }.into())
    }
}
