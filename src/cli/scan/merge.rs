//! `bifdiag scan merge`: the shards of a scan in one file.

use std::path::{Path, PathBuf};

use bifdiag_schema::RowDocument;

use super::arguments::MergeArguments;
use super::journal::Identity;
use super::output;
use super::table::Format;
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::terminal::counted;

/// A shard that is what its summary says.
struct Part {
    path: PathBuf,
    format: Format,
    identity: Identity,
}

pub fn run(arguments: &MergeArguments) -> Result<(), Failure> {
    let out = arguments.out.as_deref().ok_or_else(output::no_out)?;
    let format = output::format_of(out, Some(output::format_of_input(out)?))?;
    let parts = parts(&arguments.shards, out)?;
    let Some(first) = parts.first() else {
        return Err(Failure::input("merge needs shards; name their files, such as shard-*.parquet"));
    };
    let identity = Identity { range: [0, first.identity.design.count()], ..first.identity.clone() };
    let document = output::write(out, format, &identity, |take| {
        for part in &parts {
            pass_rows(part, take)?;
        }
        Ok(())
    })?;
    answer(arguments.json, &document, || output::report(&document, out))
}

/// The shards in the order of their bodies, once they are known to be whole, of one scan, and to leave nothing out.
fn parts(shards: &[PathBuf], out: &Path) -> Result<Vec<Part>, Failure> {
    let mut parts = shards.iter().map(|path| part(path, out)).collect::<Result<Vec<_>, _>>()?;
    if let Some((first, others)) = parts.split_first() {
        for part in others {
            if let Some(difference) = part.identity.difference(&first.identity) {
                let (path, first) = (part.path.display(), first.path.display());
                return Err(Failure::input(format!(
                    "{path} belongs to another scan than {first}: {difference} differs"
                )));
            }
        }
    }
    parts.sort_by_key(|part| part.identity.range);
    // A shard without bodies comes between its neighbours and covers nothing.
    parts.retain(|part| part.identity.range[0] < part.identity.range[1] || part.identity.design.count() == 0);
    check_cover(&parts)?;
    Ok(parts)
}

/// A shard that is what its summary says.
fn part(path: &Path, out: &Path) -> Result<Part, Failure> {
    let same = |a: &Path, b: &Path| a == b || matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if same(path, out) {
        let path = path.display();
        return Err(Failure::input(format!("{path}: the output is one of the shards; choose another --out")));
    }
    std::fs::metadata(path).map_err(|error| output::no_shard(path, &error))?;
    let summary = output::checked_summary(path)?;
    let known = [Format::Parquet, Format::Csv, Format::Jsonl].into_iter().find(|f| f.name() == summary.format);
    let format = match known {
        Some(format) if format.is_available() => format,
        _ => output::format_of_input(path)?,
    };
    let identity = output::identity(path, summary)?;
    Ok(Part { path: path.to_owned(), format, identity })
}

/// Each body is in exactly one of the parts, which are in the order of their bodies.
fn check_cover(parts: &[Part]) -> Result<(), Failure> {
    let Some(first) = parts.first() else { return Ok(()) };
    let count = first.identity.design.count();
    let mut next = 0;
    let mut before: Option<&Part> = None;
    for part in parts {
        let [from, to] = part.identity.range;
        if from < next {
            let first = before.map_or_else(String::new, |before| before.path.display().to_string());
            return Err(Failure::input(format!(
                "{} overlaps {first}: both hold body {from}; name each shard once",
                part.path.display()
            )));
        }
        if from > next {
            let place = match before {
                Some(before) => format!("between {} and {}", before.path.display(), part.path.display()),
                None => format!("before {}", part.path.display()),
            };
            return Err(missing([next, from], count, &place));
        }
        next = to;
        before = Some(part);
    }
    if next < count {
        let place = before.map_or_else(String::new, |before| format!("after {}", before.path.display()));
        return Err(missing([next, count], count, &place));
    }
    Ok(())
}

fn missing([from, to]: [u64; 2], count: u64, place: &str) -> Failure {
    let what = match to - 1 {
        last if last == from => format!("body {from} of {count}, numbered from 0, is"),
        last => format!("bodies {from} to {last} of {count}, numbered from 0, are"),
    };
    Failure::input(format!("{what} missing ({place}); compute that shard too and name it"))
}

/// Passes the rows of a shard on, each in its place.
fn pass_rows(part: &Part, take: &mut dyn FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure> {
    let [from, to] = part.identity.range;
    let path = part.path.display();
    let table = |error: Failure| Failure::input(format!("{path}: {error}"));
    let mut found = 0;
    for row in part.format.rows(&part.path).map_err(table)? {
        let row = row.map_err(table)?;
        let wanted = from + found;
        found += 1;
        if row.index != wanted || wanted >= to {
            let index = row.index;
            return Err(Failure::input(format!(
                "{path}: row {found} has number {index} where {wanted} is expected; compute this shard again"
            )));
        }
        take(row)?;
    }
    let wanted = to - from;
    if found == wanted {
        return Ok(());
    }
    let rows = counted(found, "row", "rows");
    Err(Failure::input(format!("{path} has {rows} where its summary says {wanted}; compute this shard again")))
}
