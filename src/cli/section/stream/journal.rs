//! The journal of a section: the crossings that were found survive the end of the process.
//!
//! `FILE.partial` begins with a line that tells which section it belongs to. Blocks follow: an orbit's next crossings,
//! what the orbit was like until then, and where it goes on, closed by their SHA-256. What does not end in a whole block
//! is cut off when the section is taken up again.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use bifdiag_dynamics::field::Integrals;
use bifdiag_dynamics::section::{OrbitCheckpoint, OrbitEnd, OrbitReport, OrbitSection, SectionPoint};
use sha2::{Digest, Sha256};

use super::super::error::{SectionFailure, SectionInput};
use crate::cli::export::{Column, Pieces, Values, journal_path, open_alone};
use crate::cli::section::table;

/// Words before the rows of a block: orbit, end and number of rows; the report; the halt.
const HEAD: usize = 3 + REPORT + OrbitCheckpoint::WORDS;
/// Words of a report.
const REPORT: usize = 8;
/// Bytes after the rows.
const SEAL: usize = 32;

/// How far an orbit has come.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    pub report: OrbitReport,
    /// Where it goes on; `None` where it has ended.
    pub halt: Option<OrbitCheckpoint>,
}

/// Crossings of one orbit in the journal.
#[derive(Clone, Copy, Debug)]
struct Block {
    orbit: u32,
    rows: usize,
    /// Where the rows begin.
    offset: u64,
}

/// The first crossing of an orbit.
#[derive(Clone, Copy, Debug, Default)]
pub struct First {
    pub index: u32,
    pub time: f64,
    pub gamma: [f64; 3],
    pub l: [f64; 3],
}

/// An open journal.
pub struct Journal {
    path: PathBuf,
    file: File,
    end: u64,
    blocks: Vec<Block>,
    standings: Vec<Option<Standing>>,
    /// The columns without rows, the last of them for this program alone: what the times leave out.
    columns: Vec<Column>,
    /// The parameters of the run.
    pub meta: String,
}

impl Journal {
    /// Opens the journal beside an output file for so many orbits: takes up what is there, or begins. `identity` is a text
    /// on one line. The journal of another section is refused, or discarded if `discards` is set.
    pub fn open(out: &Path, identity: &str, orbits: usize, discards: bool) -> Result<Self, SectionFailure> {
        let path = journal_path(out);
        let failed = |source: io::Error| SectionFailure::Journal { path: path.clone(), source };
        if let Some(directory) = path.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            std::fs::create_dir_all(directory).map_err(failed)?;
        }
        let file = open_alone(&path).map_err(failed)?.ok_or_else(|| SectionInput::Busy { journal: path.clone() })?;
        let columns = table::columns(&[]);
        let columns = columns.into_iter().chain([("time_low", time_low(&[]))]);
        let columns = columns.map(|(name, values)| Column { name, values }).collect();
        let (blocks, standings) = (Vec::new(), vec![None; orbits]);
        let mut journal = Self { path: path.clone(), file, end: 0, blocks, standings, columns, meta: String::new() };
        let line = format!("{identity}\n").into_bytes();
        let mut found = Vec::new();
        Read::by_ref(&mut journal.file).take(line.len() as u64).read_to_end(&mut found).map_err(failed)?;
        journal.end = line.len() as u64;
        if found != line {
            // Without the end of its first line, the process ended while it wrote that.
            let unbegun = found.len() < line.len() && !found.contains(&b'\n');
            if !unbegun && !discards {
                return Err(SectionInput::OtherJournal { journal: path }.into());
            }
            if !unbegun {
                tracing::warn!("{} held the beginning of another section; it begins anew", path.display());
            }
            journal.file.set_len(0).map_err(failed)?;
            journal.file.seek(SeekFrom::Start(0)).map_err(failed)?;
            journal.file.write_all(&line).map_err(failed)?;
            return Ok(journal);
        }
        journal.read_whole_blocks().map_err(failed)?;
        journal.file.set_len(journal.end).map_err(failed)?;
        journal.file.seek(SeekFrom::End(0)).map_err(failed)?;
        Ok(journal)
    }

    /// How far each orbit has come; `None` where it was not begun.
    pub fn standings(&self) -> &[Option<Standing>] {
        &self.standings
    }

    /// Bytes of a row.
    fn width(&self) -> usize {
        self.bytes_of(&(0..self.columns.len()))
    }

    fn read_whole_blocks(&mut self) -> io::Result<()> {
        let width = self.width();
        let length = self.file.metadata()?.len();
        let mut reader = BufReader::with_capacity(1 << 20, self.file.try_clone()?);
        let mut head = [0; 8 * HEAD];
        let mut room = vec![0; 1 << 16];
        loop {
            if self.end + ((8 * HEAD + SEAL) as u64) > length {
                return Ok(());
            }
            reader.read_exact(&mut head)?;
            let words = words(&head);
            let (Ok(orbit), Ok(rows)) = (u32::try_from(words[0]), usize::try_from(words[2])) else { return Ok(()) };
            let bytes = words[2].checked_mul(width as u64).filter(|bytes| *bytes <= length);
            let fits = bytes.filter(|bytes| self.end + ((8 * HEAD + SEAL) as u64) + bytes <= length);
            let (Some(bytes), true) = (fits, (orbit as usize) < self.standings.len()) else { return Ok(()) };
            let mut digest = Sha256::new();
            digest.update(head);
            let mut left = bytes;
            while left > 0 {
                let part = room.len().min(usize::try_from(left).unwrap_or(usize::MAX));
                reader.read_exact(&mut room[..part])?;
                digest.update(&room[..part]);
                left -= part as u64;
            }
            let mut seal = [0; SEAL];
            reader.read_exact(&mut seal)?;
            if seal[..] != digest.finalize()[..] {
                return Ok(());
            }
            self.take(&words, orbit, rows);
            self.end += (8 * HEAD + SEAL) as u64 + bytes;
        }
    }

    /// Notes a block that begins at the end.
    fn take(&mut self, words: &[u64; HEAD], orbit: u32, rows: usize) {
        // An orbit that failed is followed once more, so that the reason is told.
        if let Some(standing) = standing(words) {
            self.standings[orbit as usize] = Some(standing);
            let offset = self.end + (8 * HEAD) as u64;
            self.blocks.push(Block { orbit, rows, offset });
        }
    }

    /// Adds an orbit's next crossings.
    pub fn append(&mut self, orbit: &OrbitSection, halt: Option<OrbitCheckpoint>) -> Result<(), SectionFailure> {
        let mut words = [0; HEAD];
        words[..3].copy_from_slice(&[
            u64::from(orbit.orbit),
            end_code(orbit.report.end, halt),
            orbit.points.len() as u64,
        ]);
        words[3..3 + REPORT].copy_from_slice(&report_words(&orbit.report));
        words[3 + REPORT..].copy_from_slice(&halt.unwrap_or_default().words());
        let mut block: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let points: Vec<_> = orbit.points.iter().collect();
        for (_, values) in table::columns(&points) {
            block.extend(values.bytes());
        }
        block.extend(time_low(&points).bytes());
        let seal = Sha256::digest(&block);
        block.extend_from_slice(&seal);
        self.file.write_all(&block).map_err(|source| SectionFailure::Journal { path: self.path.clone(), source })?;
        let offset = self.end + (8 * HEAD) as u64;
        self.blocks.push(Block { orbit: orbit.orbit, rows: orbit.points.len(), offset });
        self.standings[orbit.orbit as usize] = Some(Standing { report: orbit.report, halt });
        self.end += block.len() as u64;
        Ok(())
    }

    /// Puts the blocks into the order of the orbits.
    pub fn sort(&mut self) {
        self.blocks.sort_by_key(|block| block.orbit);
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The blocks of an orbit that are not empty, after [`sort`](Self::sort).
    fn blocks_of(&self, orbit: u32) -> Vec<Block> {
        let from = self.blocks.partition_point(|block| block.orbit < orbit);
        let own = self.blocks[from..].iter().take_while(|block| block.orbit == orbit);
        own.filter(|block| block.rows > 0).copied().collect()
    }

    /// The first crossing of an orbit, after [`sort`](Self::sort).
    pub fn first(&mut self, orbit: u32) -> io::Result<Option<First>> {
        let Some(&block) = self.blocks_of(orbit).first() else { return Ok(None) };
        let mut room = Vec::new();
        let mut first = First::default();
        for number in 0..self.columns.len() {
            let name = self.columns[number].name;
            self.read_rows(block, number, 1, &mut room)?;
            let floats: Vec<f64> = room.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
            match (name, floats[..].first_chunk()) {
                ("index", _) => first.index = room.first_chunk().map_or(0, |bytes| u32::from_le_bytes(*bytes)),
                ("time", _) => first.time = floats[0],
                ("gamma", Some(gamma)) => first.gamma = *gamma,
                ("l", Some(l)) => first.l = *l,
                _ => {}
            }
        }
        Ok(Some(first))
    }

    /// The times of an orbit's crossings in their order, as long as `take` wants more; after [`sort`](Self::sort).
    pub fn times(&mut self, orbit: u32, take: &mut dyn FnMut(f64) -> bool) -> io::Result<()> {
        let number = self.columns.iter().position(|column| column.name == "time").unwrap_or_default();
        let mut room = Vec::new();
        for block in self.blocks_of(orbit) {
            self.read(block, number..number + 1, &mut room)?;
            if !room.as_chunks().0.iter().all(|bytes| take(f64::from_le_bytes(*bytes))) {
                break;
            }
        }
        Ok(())
    }

    /// The crossings of an orbit, after [`sort`](Self::sort).
    pub fn points(&mut self, orbit: u32) -> Result<Vec<SectionPoint>, SectionFailure> {
        let path = self.path.clone();
        let mut room = Vec::new();
        let mut points = Vec::new();
        for block in self.blocks_of(orbit) {
            let columns = self.rows_of(block, self.columns.len(), &mut room);
            let columns = columns.map_err(|source| SectionFailure::Journal { path: path.clone(), source })?;
            if let Some((time_low, columns)) = columns.split_last() {
                points.extend(table::points(columns, &time_low.values));
            }
        }
        Ok(points)
    }

    /// The rows of a block in the first columns.
    fn rows_of(&mut self, block: Block, columns: usize, room: &mut Vec<u8>) -> io::Result<Vec<Column>> {
        self.read(block, 0..columns, room)?;
        let mut rest = &room[..];
        let mut rows = self.columns[..columns].to_vec();
        for column in &mut rows {
            let (bytes, after) = rest.split_at(block.rows * column.values.row_bytes());
            column.values.extend_from_bytes(bytes);
            rest = after;
        }
        Ok(rows)
    }

    /// The bytes of some columns of a block.
    fn read(&mut self, block: Block, columns: std::ops::Range<usize>, room: &mut Vec<u8>) -> io::Result<()> {
        let within = self.bytes_of(&columns);
        self.read_at(block, columns.start, block.rows * within, room)
    }

    /// The bytes of a column in the first rows of a block.
    fn read_rows(&mut self, block: Block, column: usize, rows: usize, room: &mut Vec<u8>) -> io::Result<()> {
        let within = self.bytes_of(&(column..column + 1));
        self.read_at(block, column, rows * within, room)
    }

    /// So many bytes from where a column of a block begins.
    fn read_at(&mut self, block: Block, column: usize, bytes: usize, room: &mut Vec<u8>) -> io::Result<()> {
        let before = self.bytes_of(&(0..column));
        room.resize(bytes, 0);
        self.file.seek(SeekFrom::Start(block.offset + (block.rows * before) as u64))?;
        self.file.read_exact(room)
    }

    /// Bytes of a row in some columns.
    fn bytes_of(&self, columns: &std::ops::Range<usize>) -> usize {
        self.columns[columns.clone()].iter().map(|column| column.values.row_bytes()).sum()
    }
}

impl Pieces for Journal {
    fn columns(&self) -> Vec<Column> {
        self.columns[..self.columns.len() - 1].to_vec()
    }

    fn rows(&self) -> usize {
        self.blocks.iter().map(|block| block.rows).sum()
    }

    fn meta(&self) -> &str {
        &self.meta
    }

    fn column(&mut self, number: usize, take: &mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        let mut room = Vec::new();
        for k in 0..self.blocks.len() {
            self.read(self.blocks[k], number..number + 1, &mut room)?;
            take(&room)?;
        }
        Ok(())
    }

    fn pieces(&mut self, take: &mut dyn FnMut(&[Column]) -> io::Result<()>) -> io::Result<()> {
        let mut room = Vec::new();
        for k in 0..self.blocks.len() {
            take(&self.rows_of(self.blocks[k], self.columns.len() - 1, &mut room)?)?;
        }
        Ok(())
    }
}

/// What the times leave out.
fn time_low(points: &[&SectionPoint]) -> Values {
    Values::floats(points.iter().map(|point| point.time_low))
}

fn words(bytes: &[u8; 8 * HEAD]) -> [u64; HEAD] {
    let mut words = [0; HEAD];
    for (word, bytes) in words.iter_mut().zip(bytes.as_chunks::<8>().0) {
        *word = u64::from_le_bytes(*bytes);
    }
    words
}

/// The ends that are kept.
const ENDS: [OrbitEnd; 3] = [OrbitEnd::Crossings, OrbitEnd::Time, OrbitEnd::StaysOnSection];
/// An orbit that goes on, and one that failed.
const GOES_ON: u64 = 100;
const FAILED: u64 = 101;

fn end_code(end: OrbitEnd, halt: Option<OrbitCheckpoint>) -> u64 {
    match (halt, ENDS.iter().position(|one| *one == end)) {
        (Some(_), _) => GOES_ON,
        (None, Some(place)) => place as u64,
        (None, None) => FAILED,
    }
}

fn report_words(report: &OrbitReport) -> [u64; REPORT] {
    let Integrals { energy, vertical_momentum, gamma_squared } = report.drift;
    let floats = [report.time, energy, vertical_momentum, gamma_squared, report.residual].map(f64::to_bits);
    let [a, b, c, d, e] = floats;
    [u64::from(report.crossings), report.steps, u64::from(report.tangencies), a, b, c, d, e]
}

/// How far the orbit of a block has come; `None` where it failed.
fn standing(words: &[u64; HEAD]) -> Option<Standing> {
    let mut halt = [0; OrbitCheckpoint::WORDS];
    halt.copy_from_slice(&words[3 + REPORT..]);
    let (halt, end) = match words[1] {
        GOES_ON => (Some(OrbitCheckpoint::from_words(halt)), OrbitEnd::Interrupted),
        code => (None, *ENDS.get(usize::try_from(code).ok()?)?),
    };
    let word = |k: usize| words[3 + k];
    let float = |k: usize| f64::from_bits(word(k));
    let drift = Integrals { energy: float(4), vertical_momentum: float(5), gamma_squared: float(6) };
    let report = OrbitReport {
        end,
        crossings: u32::try_from(word(0)).ok()?,
        steps: word(1),
        time: float(3),
        tangencies: u32::try_from(word(2)).ok()?,
        drift,
        residual: float(7),
    };
    Some(Standing { report, halt })
}
