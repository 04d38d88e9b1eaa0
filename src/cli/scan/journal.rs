//! The journal of a scan in progress: what has been computed survives the end of the process.
//!
//! `FILE.partial` begins with a line that tells which scan it belongs to. Blocks of rows follow, one JSON object a line,
//! each block closed by a line with its number of rows and the SHA-256 of its lines. Whatever does not end in a whole
//! block is cut off when the scan is taken up again.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use bifdiag_schema::{Accuracy, RowDocument, ScanIdentityDocument};
use bifdiag_survey::Design;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::error::{ScanFailure, ScanInput};
use super::hashing::hexadecimal;
use crate::cli::export::{journal_path, open_alone};
use crate::cli::failure::Failure;

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

    fn document(&self) -> ScanIdentityDocument {
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

    /// What tells two scans apart, but for the part of the bodies.
    pub fn difference(&self, other: &Self) -> Option<&'static str> {
        if self.design != other.design {
            Some("which bodies it looks at")
        } else if self.accuracy != other.accuracy {
            Some("the accuracy")
        } else if self.program != other.program {
            Some("the version of the program")
        } else {
            None
        }
    }
}

/// The end of a block.
#[derive(Serialize, Deserialize)]
struct Seal {
    rows: u64,
    sha256: String,
}

/// How the line at the end of a block begins; those of rows begin with their index.
const SEAL: &[u8] = b"{\"rows\":";

/// An open journal.
pub struct Journal {
    path: PathBuf,
    file: File,
    rows: u64,
}

impl Journal {
    /// Opens the journal beside an output file: takes up what is there, or begins.
    pub fn open(out: &Path, identity: &Identity, restart: bool) -> Result<Self, Failure> {
        let path = journal_path(out);
        let failed = |source: io::Error| ScanFailure::Write { path: path.clone(), source };
        let file = open_alone(&path).map_err(failed)?.ok_or_else(|| ScanInput::Busy { journal: path.clone() })?;
        if restart {
            file.set_len(0).map_err(failed)?;
        }
        let mut journal = Self { path: path.clone(), file, rows: 0 };
        let end = journal.read_whole_blocks(identity)?;
        journal.file.set_len(end).map_err(failed)?;
        journal.file.seek(SeekFrom::End(0)).map_err(failed)?;
        if end == 0 {
            let mut line = serde_json::to_vec(&identity.document()).map_err(ScanFailure::from)?;
            line.push(b'\n');
            journal.file.write_all(&line).map_err(failed)?;
        }
        Ok(journal)
    }

    /// Number of rows so far.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Counts the rows of whole blocks; gives the place where they end.
    fn read_whole_blocks(&mut self, identity: &Identity) -> Result<u64, Failure> {
        let failed = |source| ScanFailure::Journal { path: self.path.clone(), source };
        let mut reader = BufReader::new(&self.file);
        let mut line = Vec::new();
        let mut place = read_line(&mut reader, &mut line).map_err(failed)?;
        if !line.ends_with(b"\n") {
            // Nothing, or the process ended while it wrote the first line.
            return Ok(0);
        }
        let found = Identity::of_line(&line);
        if found.as_ref() != Some(identity) {
            let difference = match found {
                Some(found) => found.difference(identity).unwrap_or("the shard"),
                None => "its first line",
            };
            return Err(ScanInput::OtherJournal { journal: self.path.clone(), difference }.into());
        }
        let mut end = place;
        let (mut pending, mut digest) = (0_u64, Sha256::new());
        loop {
            let length = read_line(&mut reader, &mut line).map_err(failed)?;
            place += length;
            if !line.ends_with(b"\n") {
                return Ok(end);
            }
            if !line.starts_with(SEAL) {
                digest.update(&line);
                pending += 1;
                continue;
            }
            let found = hexadecimal(std::mem::replace(&mut digest, Sha256::new()));
            match serde_json::from_slice::<Seal>(&line) {
                Ok(seal) if seal.rows == pending && seal.sha256 == found => {
                    self.rows += pending;
                    pending = 0;
                    end = place;
                }
                _ => return Ok(end),
            }
        }
    }

    /// Adds a block.
    pub fn append(&mut self, rows: &[RowDocument]) -> Result<(), Failure> {
        let mut block = Vec::with_capacity(512 * rows.len());
        for row in rows {
            serde_json::to_writer(&mut block, row).map_err(ScanFailure::from)?;
            block.push(b'\n');
        }
        let mut digest = Sha256::new();
        digest.update(&block);
        let seal = Seal { rows: rows.len() as u64, sha256: hexadecimal(digest) };
        serde_json::to_writer(&mut block, &seal).map_err(ScanFailure::from)?;
        block.push(b'\n');
        self.file.write_all(&block).map_err(|source| ScanFailure::Write { path: self.path.clone(), source })?;
        self.rows += rows.len() as u64;
        Ok(())
    }

    /// Passes every row on.
    pub fn for_each(&mut self, mut take: impl FnMut(RowDocument) -> Result<(), Failure>) -> Result<(), Failure> {
        let failed = |source| ScanFailure::Journal { path: self.path.clone(), source };
        self.file.seek(SeekFrom::Start(0)).map_err(failed)?;
        let mut reader = BufReader::with_capacity(1 << 18, &self.file);
        let mut line = Vec::new();
        read_line(&mut reader, &mut line).map_err(failed)?;
        loop {
            if read_line(&mut reader, &mut line).map_err(failed)? == 0 {
                return Ok(());
            }
            if line.starts_with(SEAL) {
                continue;
            }
            let row = serde_json::from_slice(&line)
                .map_err(|source| ScanFailure::JournalRow { path: self.path.clone(), source })?;
            take(row)?;
        }
    }

    /// The scan is done: the journal goes.
    pub fn remove(self) -> Result<(), Failure> {
        std::fs::remove_file(&self.path).map_err(|source| ScanFailure::Write { path: self.path.clone(), source }.into())
    }
}

fn read_line(reader: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<u64> {
    line.clear();
    Ok(reader.read_until(b'\n', line)? as u64)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use bifdiag_survey::BodyFamily;
    use bifdiag_survey::scan::ScanRow;

    use super::*;
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
        let mut journal = Journal::open(&out, &identity(9), false).unwrap();
        for block in [0..3, 3..4, 4..9] {
            journal.append(&rows(block)).unwrap();
        }
        drop(journal);
        let path = journal_path(&out);
        let whole = fs::read(&path).unwrap();
        let mut seen = Vec::new();
        for length in 0..=whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let mut journal = Journal::open(&out, &identity(9), false).unwrap();
            seen.push(journal.rows());
            let mut read = 0;
            journal
                .for_each(|row| {
                    assert_eq!(row.index, read);
                    read += 1;
                    Ok(())
                })
                .unwrap();
            assert_eq!(read, journal.rows());
        }
        assert!(seen.is_sorted());
        seen.dedup();
        assert_eq!(seen, [0, 3, 4, 9]);
    }

    #[test]
    fn an_altered_block_is_computed_again_and_another_scan_is_refused() {
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().join("scan.csv");
        let mut journal = Journal::open(&out, &identity(9), false).unwrap();
        journal.append(&rows(0..3)).unwrap();
        journal.append(&rows(3..9)).unwrap();
        let refusal = |number| Journal::open(&out, &identity(number), false).err().unwrap();
        assert!(refusal(9).to_string().contains("another process"));
        drop(journal);
        let path = journal_path(&out);
        let text = fs::read_to_string(&path).unwrap();
        let place = text.rfind("\"A1\":2.0").unwrap();
        let altered = format!("{}\"A1\":3.0{}", &text[..place], &text[place + 8..]);
        fs::write(&path, altered).unwrap();
        assert_eq!(Journal::open(&out, &identity(9), false).unwrap().rows(), 3);
        let refused = Journal::open(&out, &identity(8), false).err().unwrap();
        assert_eq!(refused.exit(), Exit::WrongInput);
        assert!(refused.to_string().contains("another scan"));
        assert_eq!(Journal::open(&out, &identity(8), true).unwrap().rows(), 0);
    }
}
