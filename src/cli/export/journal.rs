//! The journal beside an output file: what has been computed survives the end of the process.
//!
//! `FILE.partial` begins with a line that identifies its run. Blocks follow, each of them its length, its bytes
//! and their SHA-256. Whatever does not end in a whole block is cut off when the run is taken up again.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::cli::failure::Failure;

/// Bytes of a length, and of a checksum.
const LENGTH: u64 = 8;
const CHECKSUM: usize = 32;

/// An open journal, which no other process works on.
pub struct Journal {
    path: PathBuf,
    file: File,
    end: u64,
    /// Where the bytes of each block lie.
    blocks: Vec<Range<u64>>,
}

/// The path with something added to its name.
pub fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

/// A file of a run in progress that cannot be read or written.
pub fn unusable(path: &Path, error: io::Error) -> Failure {
    Failure::work(format!("cannot use {}: {error}", path.display())).because(error)
}

impl Journal {
    /// Opens the journal beside an output file: resumes an existing one or begins a new one, with `restart` always a
    /// new one. `identity` is a line without its end; if the file has a different one, `other` refuses it or has it
    /// discarded.
    pub fn open(
        out: &Path,
        identity: &[u8],
        restart: bool,
        other: impl FnOnce(&Path, &[u8]) -> Result<(), Failure>,
    ) -> Result<Self, Failure> {
        let path = beside(out, ".partial");
        let failed = |error| unusable(&path, error);
        if let Some(directory) = path.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            fs::create_dir_all(directory).map_err(failed)?;
        }
        let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
        let mut file = file.map_err(failed)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let path = path.display();
                return Err(Failure::input(format!(
                    "{path} is in use by another process; wait for it, or write to another place"
                )));
            }
            Err(TryLockError::Error(error)) => return Err(failed(error)),
        }
        if restart {
            file.set_len(0).map_err(failed)?;
        }
        let mut found = Vec::new();
        BufReader::new(&mut file).read_until(b'\n', &mut found).map_err(failed)?;
        // Without the end of its first line, the process ended while it wrote that.
        let line = found.strip_suffix(b"\n");
        if let Some(line) = line.filter(|line| *line != identity) {
            other(&path, line)?;
        }
        let end = identity.len() as u64 + 1;
        let is_begun = line == Some(identity);
        let mut journal = Self { path: path.clone(), file, end, blocks: Vec::new() };
        if is_begun {
            journal.read_whole_blocks().map_err(failed)?;
            journal.file.set_len(journal.end).map_err(failed)?;
        } else {
            journal.file.set_len(0).map_err(failed)?;
            journal.file.seek(SeekFrom::Start(0)).map_err(failed)?;
            journal.file.write_all(&[identity, b"\n"].concat()).map_err(failed)?;
        }
        Ok(journal)
    }

    fn read_whole_blocks(&mut self) -> io::Result<()> {
        let length = self.file.metadata()?.len();
        let mut reader = BufReader::with_capacity(1 << 20, &self.file);
        reader.seek(SeekFrom::Start(self.end))?;
        let mut room = vec![0; 1 << 16];
        while self.end + LENGTH + CHECKSUM as u64 <= length {
            let mut bytes = [0; size_of::<u64>()];
            reader.read_exact(&mut bytes)?;
            let from = self.end + LENGTH;
            let to = from.checked_add(u64::from_le_bytes(bytes)).filter(|to| *to <= length - CHECKSUM as u64);
            let Some(to) = to else { break };
            let mut digest = Sha256::new();
            let mut left = to - from;
            while left > 0 {
                let part = room.len().min(usize::try_from(left).unwrap_or(usize::MAX));
                reader.read_exact(&mut room[..part])?;
                digest.update(&room[..part]);
                left -= part as u64;
            }
            let mut checksum = [0; CHECKSUM];
            reader.read_exact(&mut checksum)?;
            if checksum[..] != digest.finalize()[..] {
                break;
            }
            self.blocks.push(from..to);
            self.end = to + CHECKSUM as u64;
        }
        Ok(())
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Where the bytes of each block lie.
    pub fn blocks(&self) -> &[Range<u64>] {
        &self.blocks
    }

    /// Adds a block.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let length = bytes.len() as u64;
        let block = [&length.to_le_bytes()[..], bytes, &Sha256::digest(bytes)[..]].concat();
        let written = self.file.seek(SeekFrom::Start(self.end)).and_then(|_| self.file.write_all(&block));
        written.map_err(|error| unusable(&self.path, error))?;
        self.blocks.push(self.end + LENGTH..self.end + LENGTH + length);
        self.end += block.len() as u64;
        Ok(())
    }

    /// Fills `room` with the bytes that lie from a place on.
    pub fn read(&mut self, from: u64, room: &mut [u8]) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(from))?;
        self.file.read_exact(room)
    }
}
