//! Parquet, with the writer for single columns: no Arrow. The columns are the properties of a row's JSON schema.

use std::fmt::Write as _;
use std::fs::File;
use std::io::Write;
use std::sync::Arc;

use bifdiag_schema::RowDocument;
use parquet::basic::Repetition;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::Field;
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::TypePtr;
use schemars::schema_for;
use serde_json::{Map, Value};

use super::sink::{RowSink, TableError};

/// Rows that are held back to be written as one group.
const GROUP: usize = 32_768;

/// What a column holds. Whole numbers are stored as 64 bits, which every reader knows as integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Whole,
    Real,
    Truth,
    Text,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Column {
    name: String,
    kind: Kind,
    /// It is never empty.
    always: bool,
}

/// The columns, in the order of the fields of [`RowDocument`].
fn columns() -> Vec<Column> {
    let schema = schema_for!(RowDocument);
    let (Some(Value::Object(properties)), Some(Value::Array(required))) =
        (schema.get("properties"), schema.get("required"))
    else {
        return Vec::new();
    };
    let column = |(name, property): (&String, &Value)| {
        let kind = &property["type"];
        let is =
            |wanted: &str| kind == wanted || kind.as_array().is_some_and(|kinds| kinds.iter().any(|k| k == wanted));
        let kind = match () {
            () if is("integer") => Kind::Whole,
            () if is("number") => Kind::Real,
            () if is("boolean") => Kind::Truth,
            // Texts, and words such as the status, whose type stands elsewhere.
            () => Kind::Text,
        };
        Column { name: name.clone(), kind, always: required.iter().any(|known| known == name) }
    };
    properties.iter().map(column).collect()
}

fn schema(columns: &[Column]) -> Result<TypePtr, TableError> {
    let mut text = String::from("message bifdiag_scan {\n");
    for Column { name, kind, always } in columns {
        let repetition = if *always { Repetition::REQUIRED } else { Repetition::OPTIONAL };
        let (kind, annotation) = match kind {
            Kind::Whole => ("INT64", ""),
            Kind::Real => ("DOUBLE", ""),
            Kind::Truth => ("BOOLEAN", ""),
            Kind::Text => ("BYTE_ARRAY", " (UTF8)"),
        };
        // Writing to a String cannot fail.
        let _always = writeln!(text, "{repetition} {kind} {name}{annotation};");
    }
    text.push('}');
    Ok(Arc::new(parse_message_type(&text)?))
}

/// Writes rows in groups.
pub struct Sink<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: Vec<Column>,
    held: Vec<Value>,
}

impl<W: Write + Send> Sink<W> {
    pub fn new(out: W) -> Result<Self, TableError> {
        let properties =
            WriterProperties::builder().set_created_by(concat!("bifdiag ", env!("CARGO_PKG_VERSION")).to_owned());
        let columns = columns();
        let writer = SerializedFileWriter::new(out, schema(&columns)?, Arc::new(properties.build()))?;
        Ok(Self { writer, columns, held: Vec::with_capacity(GROUP) })
    }

    fn write_group(&mut self) -> Result<(), TableError> {
        if self.held.is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for column in &self.columns {
            let cells: Vec<&Value> = self.held.iter().map(|row| &row[&column.name]).collect();
            match column.kind {
                Kind::Whole => write_column::<Int64Type>(&mut group, column, &cells, Value::as_i64)?,
                Kind::Real => write_column::<DoubleType>(&mut group, column, &cells, Value::as_f64)?,
                Kind::Truth => write_column::<BoolType>(&mut group, column, &cells, Value::as_bool)?,
                Kind::Text => {
                    let text = |cell: &Value| cell.as_str().map(ByteArray::from);
                    write_column::<ByteArrayType>(&mut group, column, &cells, text)?;
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
    column: &Column,
    cells: &[&Value],
    value: impl Fn(&Value) -> Option<T::T>,
) -> Result<(), TableError> {
    let values: Vec<T::T> = cells.iter().filter_map(|cell| value(cell)).collect();
    let levels: Option<Vec<i16>> =
        (!column.always).then(|| cells.iter().map(|cell| i16::from(!cell.is_null())).collect());
    let mut writer = group.next_column()?.ok_or_else(|| TableError::Column { column: column.name.clone() })?;
    writer.typed::<T>().write_batch(&values, levels.as_deref(), None)?;
    Ok(writer.close()?)
}

impl<W: Write + Send> RowSink for Sink<W> {
    fn write(&mut self, row: &RowDocument) -> Result<(), TableError> {
        self.held.push(serde_json::to_value(row).map_err(TableError::JsonWrite)?);
        if self.held.len() == GROUP { self.write_group() } else { Ok(()) }
    }

    fn finish(&mut self) -> Result<(), TableError> {
        self.write_group()?;
        self.writer.finish()?;
        Ok(())
    }
}

/// The rows of a file.
pub fn rows(file: File) -> Result<impl Iterator<Item = Result<RowDocument, TableError>>, TableError> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_the_fields_of_a_row() {
        let columns = columns();
        let of_kind = |kind| columns.iter().filter(|column| column.kind == kind).count();
        assert_eq!([Kind::Whole, Kind::Real, Kind::Truth, Kind::Text].map(of_kind), [7, 8, 6, 7]);
        assert_eq!(columns.iter().filter(|column| column.always).count(), 14);
        let status = columns.iter().find(|column| column.name == "status").unwrap();
        assert_eq!((status.kind, status.always, columns[0].name.as_str()), (Kind::Text, true, "index"));
    }
}
