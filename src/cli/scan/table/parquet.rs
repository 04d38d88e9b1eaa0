//! Parquet, with the writer for single columns: no Arrow.

use std::fmt::Write as _;
use std::fs::File;
use std::io::Write;
use std::sync::Arc;

use parquet::basic::Repetition;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::Field;
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::TypePtr;
use serde_json::{Map, Value};
use survey::scan::{Row, Status};

use super::{RowSink, TableError};

/// Rows that are held back to be written as one group.
const GROUP: usize = 32_768;

/// How a column is taken out of a row. Whole numbers are stored as 64 bits, which every reader knows as integers.
enum Column {
    Whole(fn(&Row) -> Option<u64>),
    Real(fn(&Row) -> Option<f64>),
    Truth(fn(&Row) -> bool),
    Text(fn(&Row) -> Option<&str>),
}

/// The columns, in the order of the fields of [`Row`]; those with `true` are never empty.
const COLUMNS: [(&str, bool, Column); 28] = [
    ("index", true, Column::Whole(|row| Some(row.index))),
    ("A1", true, Column::Real(|row| Some(row.a1))),
    ("A2", true, Column::Real(|row| Some(row.a2))),
    ("A3", true, Column::Real(|row| Some(row.a3))),
    ("r1", true, Column::Real(|row| Some(row.r1))),
    ("r2", true, Column::Real(|row| Some(row.r2))),
    ("r3", true, Column::Real(|row| Some(row.r3))),
    ("status", true, Column::Text(|row| Some(status(row.status)))),
    ("class", false, Column::Text(|row| row.class.as_deref())),
    ("regions", false, Column::Whole(|row| row.regions.map(u64::from))),
    ("cusps", false, Column::Whole(|row| row.cusps.map(u64::from))),
    ("pitchforks", false, Column::Whole(|row| row.pitchforks.map(u64::from))),
    ("crossings", false, Column::Whole(|row| row.crossings.map(u64::from))),
    ("critical_points", false, Column::Whole(|row| row.critical_points.map(u64::from))),
    ("signatures", false, Column::Text(|row| row.signatures.as_deref())),
    ("types", false, Column::Text(|row| row.types.as_deref())),
    ("largest_margin", false, Column::Real(|row| row.largest_margin)),
    ("largest_region", false, Column::Text(|row| row.largest_region.as_deref())),
    ("smallest_margin", false, Column::Real(|row| row.smallest_margin)),
    ("smallest_region", false, Column::Text(|row| row.smallest_region.as_deref())),
    ("unphysical", true, Column::Truth(|row| row.unphysical)),
    ("plate", true, Column::Truth(|row| row.plate)),
    ("symmetric", true, Column::Truth(|row| row.symmetric)),
    ("plane", true, Column::Truth(|row| row.plane)),
    ("axis", true, Column::Truth(|row| row.axis)),
    ("euler", true, Column::Truth(|row| row.euler)),
    ("work", false, Column::Whole(|row| row.work.map(u64::from))),
    ("error", false, Column::Text(|row| row.error.as_deref())),
];

fn status(status: Status) -> &'static str {
    match status {
        Status::Classified => "classified",
        Status::Undecided => "undecided",
        Status::Failed => "failed",
    }
}

fn schema() -> Result<TypePtr, TableError> {
    let mut text = String::from("message bifdiag_scan {\n");
    for (name, always, column) in &COLUMNS {
        let repetition = if *always { Repetition::REQUIRED } else { Repetition::OPTIONAL };
        let kind = match column {
            Column::Whole(_) => "INT64",
            Column::Real(_) => "DOUBLE",
            Column::Truth(_) => "BOOLEAN",
            Column::Text(_) => "BYTE_ARRAY",
        };
        let annotation = if matches!(column, Column::Text(_)) { " (UTF8)" } else { "" };
        // Writing to a String cannot fail.
        let _always = writeln!(text, "{repetition} {kind} {name}{annotation};");
    }
    text.push('}');
    Ok(Arc::new(parse_message_type(&text)?))
}

/// Writes rows in groups.
pub struct Sink<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    held: Vec<Row>,
}

impl<W: Write + Send> Sink<W> {
    pub fn new(out: W) -> Result<Self, TableError> {
        let properties =
            WriterProperties::builder().set_created_by(concat!("bifdiag ", env!("CARGO_PKG_VERSION")).to_owned());
        let writer = SerializedFileWriter::new(out, schema()?, Arc::new(properties.build()))?;
        Ok(Self { writer, held: Vec::with_capacity(GROUP) })
    }

    fn write_group(&mut self) -> Result<(), TableError> {
        if self.held.is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for (name, always, column) in &COLUMNS {
            let rows = &self.held;
            let levels = |empty: &dyn Fn(&Row) -> bool| {
                (!always).then(|| rows.iter().map(|row| i16::from(!empty(row))).collect::<Vec<i16>>())
            };
            match column {
                Column::Whole(of) => {
                    let values: Vec<i64> =
                        rows.iter().filter_map(of).map(|n| i64::try_from(n).unwrap_or(i64::MAX)).collect();
                    write_column::<Int64Type>(&mut group, name, &values, levels(&|row| of(row).is_none()).as_deref())?;
                }
                Column::Real(of) => {
                    let values: Vec<f64> = rows.iter().filter_map(of).collect();
                    write_column::<DoubleType>(&mut group, name, &values, levels(&|row| of(row).is_none()).as_deref())?;
                }
                Column::Truth(of) => {
                    let values: Vec<bool> = rows.iter().map(of).collect();
                    write_column::<BoolType>(&mut group, name, &values, None)?;
                }
                Column::Text(of) => {
                    let values: Vec<ByteArray> = rows.iter().filter_map(of).map(ByteArray::from).collect();
                    write_column::<ByteArrayType>(
                        &mut group,
                        name,
                        &values,
                        levels(&|row| of(row).is_none()).as_deref(),
                    )?;
                }
            }
        }
        group.close()?;
        self.held.clear();
        Ok(())
    }
}

fn write_column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, impl Write + Send>,
    name: &'static str,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), TableError> {
    let mut column = group.next_column()?.ok_or(TableError::Column { column: name })?;
    column.typed::<T>().write_batch(values, levels, None)?;
    Ok(column.close()?)
}

impl<W: Write + Send> RowSink for Sink<W> {
    fn write(&mut self, row: &Row) -> Result<(), TableError> {
        self.held.push(row.clone());
        if self.held.len() == GROUP { self.write_group() } else { Ok(()) }
    }

    fn finish(&mut self) -> Result<(), TableError> {
        self.write_group()?;
        self.writer.finish()?;
        Ok(())
    }
}

/// The rows of a file.
pub fn rows(file: File) -> Result<impl Iterator<Item = Result<Row, TableError>>, TableError> {
    let reader = SerializedFileReader::new(file)?;
    // Only our own columns; what others have added is of no concern.
    let rows = reader.into_iter().zip(1..);
    Ok(rows.map(|(row, number)| {
        let mut fields = Map::new();
        for (name, field) in row?.get_column_iter() {
            fields.insert(name.clone(), value(field));
        }
        serde_json::from_value(Value::Object(fields)).map_err(|source| TableError::ParquetRow { row: number, source })
    }))
}

fn value(field: &Field) -> Value {
    match field {
        Field::Bool(truth) => Value::from(*truth),
        Field::Int(n) => Value::from(*n),
        Field::Long(n) => Value::from(*n),
        Field::Float(x) => Value::from(*x),
        Field::Double(x) => Value::from(*x),
        Field::Str(text) => Value::from(text.as_str()),
        _ => Value::Null,
    }
}
