//! The rows of a scan in its journal, and which scan they belong to. Each block is rows, one JSON object a line.

use std::path::Path;

use bifdiag_schema::{Accuracy, RowDocument, ScanIdentityDocument};
use bifdiag_survey::Design;

use crate::cli::export::{Journal, unusable};
use crate::cli::failure::{Failure, failed};

/// Which scan a journal, or a shard, belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Identity {
    pub program: String,
    pub accuracy: Accuracy,
    pub design: Design,
    pub range: [u64; 2],
}

impl Identity {
    pub fn new(design: Design, range: [u64; 2], accuracy: Accuracy) -> Self {
        Self { program: concat!("bifdiag ", env!("CARGO_PKG_VERSION")).to_owned(), accuracy, design, range }
    }

    pub fn document(&self) -> ScanIdentityDocument {
        ScanIdentityDocument {
            program: self.program.clone(),
            accuracy: self.accuracy,
            design: bifdiag_documents::scan::design(&self.design),
            range: self.range,
        }
    }

    /// That of the first line of a journal; `None` where it is another line.
    fn of_line(line: &[u8]) -> Option<Self> {
        let ScanIdentityDocument { program, accuracy, design, range } = serde_json::from_slice(line).ok()?;
        let design = bifdiag_documents::scan::read_design(&design).ok()?;
        Some(Self { program, accuracy, design, range })
    }

    /// In what two scans differ, apart from their part of the bodies.
    pub fn difference(&self, other: &Self) -> Option<&'static str> {
        if self.design != other.design {
            Some("the choice of bodies")
        } else if self.accuracy != other.accuracy {
            Some("the accuracy")
        } else if self.program != other.program {
            Some("the version of the program")
        } else {
            None
        }
    }
}

/// Rows on disk.
pub struct Rows {
    journal: Journal,
    count: u64,
}

impl Rows {
    /// Opens the journal beside an output file, to resume an existing one or to begin.
    pub fn open(out: &Path, identity: &Identity, restart: bool) -> Result<Self, Failure> {
        let line = serde_json::to_vec(&identity.document())?;
        let journal = Journal::open(out, &line, restart, |path, line| {
            let difference = match Identity::of_line(line) {
                Some(found) => found.difference(identity).unwrap_or("the shard"),
                None => "its first line",
            };
            Err(Failure::input(format!(
                "{} belongs to another unfinished scan ({difference} differs); finish that scan with its own options, \
                choose \
                 another --out, or give --restart to discard it",
                path.display()
            )))
        })?;
        let mut rows = Self { journal, count: 0 };
        let mut count = 0;
        rows.for_each(&mut |_| {
            count += 1;
            Ok(())
        })?;
        rows.count = count;
        Ok(rows)
    }

    /// Number of rows so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Adds a block.
    pub fn append(&mut self, rows: &[RowDocument]) -> Result<(), Failure> {
        let mut block = Vec::with_capacity(512 * rows.len());
        for row in rows {
            bifdiag_schema::write_json(&mut block, row)?;
            block.push(b'\n');
        }
        self.count += rows.len() as u64;
        self.journal.append(&block)
    }

    /// Passes every row on.
    pub fn for_each(&mut self, take: &mut dyn FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure> {
        for block in self.journal.blocks().to_vec() {
            let mut room = vec![0; usize::try_from(block.end - block.start).unwrap_or(usize::MAX)];
            self.journal.read(block.start, &mut room).map_err(|error| unusable(self.journal.path(), error))?;
            for line in room.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
                let unreadable = failed(format!("cannot read {} back", self.journal.path().display()));
                take(serde_json::from_slice(line).map_err(unreadable)?)?;
            }
        }
        Ok(())
    }

    /// The scan is done: the journal goes.
    pub fn remove(self) -> Result<(), Failure> {
        std::fs::remove_file(self.journal.path()).map_err(|error| unusable(self.journal.path(), error))
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use bifdiag_survey::BodyFamily;
    use bifdiag_survey::scan::ScanRow;

    use super::*;
    use crate::cli::export::beside;
    use crate::cli::failure::Exit;

    fn identity(samples: u64) -> Identity {
        let design = Design::new(BodyFamily::General, Vec::new(), Some(samples), 0).unwrap();
        Identity::new(design, [0, samples], Accuracy::Exact)
    }

    fn rows(range: std::ops::Range<u64>) -> Vec<RowDocument> {
        let row = |n| ScanRow::of(n, [[2.0, -1.0, 1.0], [1.0, 0.0, 0.0]], bifdiag_exact::Accuracy::Exact);
        range.map(|n| bifdiag_documents::scan::row(&row(n))).collect()
    }

    #[test]
    fn a_journal_cut_anywhere_keeps_its_whole_blocks() {
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().join("scan.csv");
        let mut journal = Rows::open(&out, &identity(9), false).unwrap();
        for block in [0..3, 3..4, 4..9] {
            journal.append(&rows(block)).unwrap();
        }
        drop(journal);
        let path = beside(&out, ".partial");
        let whole = fs::read(&path).unwrap();
        let mut seen = Vec::new();
        for length in 0..=whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let mut journal = Rows::open(&out, &identity(9), false).unwrap();
            seen.push(journal.count());
            let mut read = 0;
            journal
                .for_each(&mut |row| {
                    assert_eq!(row.index, read);
                    read += 1;
                    Ok(())
                })
                .unwrap();
            assert_eq!(read, journal.count());
        }
        assert!(seen.is_sorted());
        seen.dedup();
        assert_eq!(seen, [0, 3, 4, 9]);
    }

    #[test]
    fn an_altered_block_is_computed_again_and_another_scan_is_refused() {
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().join("scan.csv");
        let mut journal = Rows::open(&out, &identity(9), false).unwrap();
        journal.append(&rows(0..3)).unwrap();
        journal.append(&rows(3..9)).unwrap();
        let refusal = |number| Rows::open(&out, &identity(number), false).err().unwrap();
        assert!(refusal(9).to_string().contains("another process"));
        drop(journal);
        let path = beside(&out, ".partial");
        let mut bytes = fs::read(&path).unwrap();
        let last = bytes.len() - 100;
        bytes[last] ^= 1;
        fs::write(&path, bytes).unwrap();
        assert_eq!(Rows::open(&out, &identity(9), false).unwrap().count(), 3);
        let refused = Rows::open(&out, &identity(8), false).err().unwrap();
        assert_eq!(refused.exit(), Exit::WrongInput);
        assert!(refused.to_string().contains("another unfinished scan"));
        assert_eq!(Rows::open(&out, &identity(8), true).unwrap().count(), 0);
    }
}
