//! The file of a map: a table in pieces, or a document.

use std::io;
use std::path::{Path, PathBuf};

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_numbers::table::Id;
use bifdiag_schema::{ChaosCellDocument, ChaosMapDocument};

use crate::cli::export::{Column, DataFormat, DataTarget, FileSet, Journal, Pieces, Values};
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, print};

/// What a map is written as.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MapFormat {
    Document,
    Table(DataFormat),
}

/// The format of an output file.
pub fn format_of(out: Option<&Path>) -> Result<(&Path, MapFormat), Failure> {
    let out = out.ok_or_else(|| Failure::input("--out is missing; give a file such as --out chaos.npz for the map"))?;
    if out.extension().is_some_and(|ending| ending == "json") {
        return Ok((out, MapFormat::Document));
    }
    match DataTarget::parse(&out.to_string_lossy()) {
        Ok(DataTarget::File { format, .. }) => Ok((out, MapFormat::Table(format))),
        _ => Err(Failure::input(format!(
            "--out {}: a map goes to FILE.npz, FILE.parquet, FILE.csv, FILE.jsonl or FILE.json",
            out.display()
        ))),
    }
}

/// Rows that can be read again and again, some at a time.
pub trait Rows {
    /// Passes every piece on.
    fn for_each(&mut self, take: &mut dyn FnMut(Vec<ChaosCellDocument>) -> io::Result<()>) -> io::Result<()>;
}

/// The rows of shards.
impl Rows for Vec<ChaosMapDocument> {
    fn for_each(&mut self, take: &mut dyn FnMut(Vec<ChaosCellDocument>) -> io::Result<()>) -> io::Result<()> {
        self.iter().try_for_each(|shard| take(shard.rows.clone()))
    }
}

/// The rows of a journal, one JSON object a line.
impl Rows for Journal {
    fn for_each(&mut self, take: &mut dyn FnMut(Vec<ChaosCellDocument>) -> io::Result<()>) -> io::Result<()> {
        for block in self.blocks().to_vec() {
            let mut room = vec![0; usize::try_from(block.end - block.start).unwrap_or(usize::MAX)];
            self.read(block.start, &mut room)?;
            let lines = room.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
            take(lines.map(serde_json::from_slice).collect::<Result<_, _>>()?)?;
        }
        Ok(())
    }
}

/// The table of a map.
struct Table<R> {
    rows: R,
    count: usize,
    meta: String,
    /// Ids of the regions, in their order: a number in the table is that of the region, from 0.
    regions: Vec<String>,
}

impl<R: Rows> Table<R> {
    fn new(mut rows: R, map: &ChaosMapDocument) -> Result<Self, Failure> {
        let (mut count, mut last) = (0, None);
        rows.for_each(&mut |piece| {
            count += piece.len();
            last = last.max(piece.iter().filter_map(|row| row.region.parse::<RegionId>().ok()).max());
            Ok(())
        })
        .map_err(unreadable)?;
        let regions = (0..last.map_or(0, |last| last.index() + 1)).map(|number| RegionId::at(number).to_string());
        let regions = regions.collect();
        Ok(Self { rows, count, meta: bifdiag_schema::json(map)?, regions })
    }

    fn of(&self, rows: &[ChaosCellDocument]) -> Vec<Column> {
        let whole = |value: fn(&ChaosCellDocument) -> u64| {
            Values::Int32(rows.iter().map(|row| i32::try_from(value(row)).unwrap_or(i32::MAX)).collect())
        };
        let real = |value: fn(&ChaosCellDocument) -> f64| Values::floats(rows.iter().map(value));
        let place = |row: &ChaosCellDocument| self.regions.iter().position(|region| *region == row.region);
        let places = rows.iter().map(|row| place(row).and_then(|place| i32::try_from(place).ok()).unwrap_or(-1));
        let words = self.regions.iter().map(|region| region.as_str().into()).collect();
        let region = Values::Words { words, places: Box::new(Values::Int32(places.collect())) };
        [
            ("i", whole(|row| row.cell[0])),
            ("j", whole(|row| row.cell[1])),
            ("h", real(|row| row.h)),
            ("l", real(|row| row.l)),
            ("region", region),
            ("component", whole(|row| row.component.into())),
            ("part", real(|row| row.part)),
            ("block", whole(|row| row.block.into())),
            ("fraction", real(|row| row.fraction.unwrap_or(f64::NAN))),
            ("error", real(|row| row.error.unwrap_or(f64::NAN))),
            ("open", real(|row| row.open)),
            ("orbits", whole(|row| row.orbits)),
            ("crossings", whole(|row| row.crossings)),
        ]
        .into_iter()
        .map(|(name, values)| Column { name, values })
        .collect()
    }
}

impl<R: Rows> Pieces for Table<R> {
    fn columns(&self) -> Vec<Column> {
        self.of(&[])
    }

    fn rows(&self) -> usize {
        self.count
    }

    fn meta(&self) -> &str {
        &self.meta
    }

    fn column(&mut self, number: usize, take: &mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        self.pieces(&mut |columns| take(&columns[number].values.bytes()))
    }

    fn pieces(&mut self, take: &mut dyn FnMut(&[Column]) -> io::Result<()>) -> io::Result<()> {
        let Self { regions, meta, count, .. } = self;
        let names = Self::naming(regions.clone(), meta.clone(), *count);
        self.rows.for_each(&mut |piece| take(&names.of(&piece)))
    }
}

impl<R: Rows> Table<R> {
    /// What turns rows into columns, without the rows.
    fn naming(regions: Vec<String>, meta: String, count: usize) -> Table<Vec<ChaosMapDocument>> {
        Table { rows: Vec::new(), count, meta, regions }
    }
}

/// Writes a map with these rows and says so.
pub fn write(
    (out, format): (&Path, MapFormat),
    mut map: ChaosMapDocument,
    mut rows: impl Rows + 'static,
) -> Result<(), Failure> {
    let mut files = FileSet::new(out.parent().unwrap_or(Path::new(".")));
    let mut count = 0;
    match format {
        MapFormat::Document => {
            rows.for_each(&mut |piece| {
                map.rows.extend(piece);
                Ok(())
            })
            .map_err(unreadable)?;
            count += map.rows.len();
            files.add_at(out, bifdiag_documents::layout::text(&map)?);
        }
        MapFormat::Table(format) => {
            let mut table = Table::new(rows, &map)?;
            count += table.count;
            files.add_written(out, move |file| Ok(format.write(&mut table, file)?));
        }
    }
    let written: Vec<PathBuf> = files.write()?;
    let mut report = Report::default();
    let [n, m] = map.cells;
    report.line(format!("{n} x {m} cells: {}", bifdiag_documents::words::counted(count, "row", "rows")));
    report.written(&written);
    print(report.text())
}

fn unreadable(error: io::Error) -> Failure {
    Failure::work("the rows cannot be read back").because(error)
}
