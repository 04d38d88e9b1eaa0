//! The crossings of a section in its journal. Each block has an orbit's next crossings, its report so far, and the
//! state from which it continues.

use std::io;
use std::path::Path;

use bifdiag_dynamics::field::Integrals;
use bifdiag_dynamics::section::{OrbitCheckpoint, OrbitEnd, OrbitReport, OrbitSection, SectionPoint};

use super::table;
use crate::cli::export::{Column, Journal, Pieces, Values, unusable};
use crate::cli::failure::Failure;

/// Words before the rows of a block: orbit, end and number of rows; the report; the halt.
const HEAD: usize = 3 + REPORT + OrbitCheckpoint::WORDS;
/// Words of a report.
const REPORT: usize = 8;

/// How far an orbit has come.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    pub report: OrbitReport,
    /// The state from which it continues; `None` if it has ended.
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

/// Crossings on disk.
pub struct Crossings {
    journal: Journal,
    blocks: Vec<Block>,
    standings: Vec<Option<Standing>>,
    /// The columns without rows, the last of them for this program alone: what the times leave out.
    columns: Vec<Column>,
    /// The parameters of the run.
    pub meta: String,
}

impl Crossings {
    /// Opens the journal beside an output file. The journal of another section is refused, or discarded
    /// if `discards` is set.
    pub fn open(out: &Path, identity: &[u8], orbits: usize, discards: bool) -> Result<Self, Failure> {
        let journal = Journal::open(out, identity, false, |path, _| {
            let path = path.display();
            if !discards {
                let right = "finish that, take the file away, or give another FILE";
                return Err(Failure::input(format!("--data: {path} belongs to another unfinished section; {right}")));
            }
            tracing::warn!("{path} belonged to another unfinished section; it is started over");
            Ok(())
        })?;
        let columns = table::columns(&[]).into_iter().chain([("time_low", time_low(&[]))]);
        let columns = columns.map(|(name, values)| Column { name, values }).collect();
        let (blocks, standings) = (Vec::new(), vec![None; orbits]);
        let mut crossings = Self { journal, blocks, standings, columns, meta: String::new() };
        for block in crossings.journal.blocks().to_vec() {
            let mut head = [0; 8 * HEAD];
            crossings.read(block.start, &mut head)?;
            crossings.take(&words(&head), block.start);
        }
        Ok(crossings)
    }

    fn read(&mut self, from: u64, room: &mut [u8]) -> Result<(), Failure> {
        self.journal.read(from, room).map_err(|error| unusable(self.path(), error))
    }

    /// How far each orbit has come; `None` where it was not begun.
    pub fn standings(&self) -> &[Option<Standing>] {
        &self.standings
    }

    /// Notes a block that begins at a place.
    fn take(&mut self, words: &[u64; HEAD], from: u64) {
        // An orbit that failed is followed once more, so that the reason is reported.
        if let (Some(standing), Ok(orbit), Ok(rows)) =
            (standing(words), u32::try_from(words[0]), usize::try_from(words[2]))
        {
            self.standings[orbit as usize] = Some(standing);
            self.blocks.push(Block { orbit, rows, offset: from + (8 * HEAD) as u64 });
        }
    }

    /// Adds an orbit's next crossings.
    pub fn append(&mut self, orbit: &OrbitSection, halt: Option<OrbitCheckpoint>) -> Result<(), Failure> {
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
        self.journal.append(&block)?;
        let from = self.journal.blocks().last().map_or(0, |block| block.start);
        self.blocks.push(Block { orbit: orbit.orbit, rows: orbit.points.len(), offset: from + (8 * HEAD) as u64 });
        self.standings[orbit.orbit as usize] = Some(Standing { report: orbit.report, halt });
        Ok(())
    }

    /// Puts the blocks into the order of the orbits.
    pub fn sort(&mut self) {
        self.blocks.sort_by_key(|block| block.orbit);
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        self.journal.path()
    }

    /// The blocks of an orbit that are not empty, after [`sort`](Self::sort).
    fn blocks_of(&self, orbit: u32) -> Vec<Block> {
        let from = self.blocks.partition_point(|block| block.orbit < orbit);
        let own = self.blocks[from..].iter().take_while(|block| block.orbit == orbit);
        own.filter(|block| block.rows > 0).copied().collect()
    }

    /// The first crossing of an orbit, after [`sort`](Self::sort).
    pub fn first(&mut self, orbit: u32) -> Result<Option<First>, Failure> {
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
    pub fn times(&mut self, orbit: u32, take: &mut dyn FnMut(f64) -> bool) -> Result<(), Failure> {
        let number = self.columns.iter().position(|column| column.name == "time").unwrap_or_default();
        let mut room = Vec::new();
        for block in self.blocks_of(orbit) {
            self.read_columns(block, number..number + 1, &mut room)?;
            if !room.as_chunks().0.iter().all(|bytes| take(f64::from_le_bytes(*bytes))) {
                break;
            }
        }
        Ok(())
    }

    /// The crossings of an orbit, after [`sort`](Self::sort).
    pub fn points(&mut self, orbit: u32) -> Result<Vec<SectionPoint>, Failure> {
        let mut room = Vec::new();
        let mut points = Vec::new();
        for block in self.blocks_of(orbit) {
            let columns = self.rows_of(block, self.columns.len(), &mut room)?;
            if let Some((time_low, columns)) = columns.split_last() {
                points.extend(table::points(columns, &time_low.values));
            }
        }
        Ok(points)
    }

    /// The rows of a block in the first columns.
    fn rows_of(&mut self, block: Block, columns: usize, room: &mut Vec<u8>) -> Result<Vec<Column>, Failure> {
        self.read_columns(block, 0..columns, room)?;
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
    fn read_columns(
        &mut self,
        block: Block,
        columns: std::ops::Range<usize>,
        room: &mut Vec<u8>,
    ) -> Result<(), Failure> {
        let within = self.bytes_of(&columns);
        self.read_at(block, columns.start, block.rows * within, room)
    }

    /// The bytes of a column in the first rows of a block.
    fn read_rows(&mut self, block: Block, column: usize, rows: usize, room: &mut Vec<u8>) -> Result<(), Failure> {
        let within = self.bytes_of(&(column..column + 1));
        self.read_at(block, column, rows * within, room)
    }

    /// Bytes from where a column of a block begins.
    fn read_at(&mut self, block: Block, column: usize, bytes: usize, room: &mut Vec<u8>) -> Result<(), Failure> {
        let before = self.bytes_of(&(0..column));
        room.resize(bytes, 0);
        self.read(block.offset + (block.rows * before) as u64, room)
    }

    /// Bytes of a row in some columns.
    fn bytes_of(&self, columns: &std::ops::Range<usize>) -> usize {
        self.columns[columns.clone()].iter().map(|column| column.values.row_bytes()).sum()
    }
}

impl Pieces for Crossings {
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
            self.read_columns(self.blocks[k], number..number + 1, &mut room)?;
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
/// An orbit that continues, and one that failed.
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
