//! The rows of a scan as Parquet. The columns are the properties of a row's JSON schema.

use std::fs::File;
use std::io::Write;

use bifdiag_schema::RowDocument;
use parquet::basic::{ConvertedType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::Field;
use parquet::schema::types::Type;
use schemars::schema_for;
use serde_json::{Map, Value};

use crate::cli::export::parquet::{begin, write_column};
use crate::cli::failure::Failure;

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
            // Texts, and words such as the status, whose type is defined elsewhere.
            () => Kind::Text,
        };
        Column { name: name.clone(), kind, always: required.iter().any(|known| known == name) }
    };
    properties.iter().map(column).collect()
}

/// Writes rows in groups.
pub struct Groups<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: Vec<Column>,
    held: Vec<Value>,
}

impl<W: Write + Send> Groups<W> {
    pub fn new(out: W) -> Result<Self, Failure> {
        let columns = columns();
        let field = |Column { name, kind, always }: &Column| {
            let (physical, converted) = match kind {
                Kind::Whole => (Physical::INT64, ConvertedType::NONE),
                Kind::Real => (Physical::DOUBLE, ConvertedType::NONE),
                Kind::Truth => (Physical::BOOLEAN, ConvertedType::NONE),
                Kind::Text => (Physical::BYTE_ARRAY, ConvertedType::UTF8),
            };
            let repetition = if *always { Repetition::REQUIRED } else { Repetition::OPTIONAL };
            let field = Type::primitive_type_builder(name, physical).with_repetition(repetition);
            field.with_converted_type(converted).build()
        };
        let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
        let writer = begin(out, "bifdiag_scan", fields, WriterProperties::builder())?;
        Ok(Self { writer, columns, held: Vec::with_capacity(GROUP) })
    }

    pub fn write(&mut self, row: &RowDocument) -> Result<(), Failure> {
        self.held.push(serde_json::to_value(row)?);
        if self.held.len() == GROUP { Ok(self.write_group()?) } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        if self.held.is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for column in &self.columns {
            let cells: Vec<&Value> = self.held.iter().map(|row| &row[&column.name]).collect();
            match column.kind {
                Kind::Whole => write_cells::<Int64Type>(&mut group, column, &cells, Value::as_i64)?,
                Kind::Real => write_cells::<DoubleType>(&mut group, column, &cells, Value::as_f64)?,
                Kind::Truth => write_cells::<BoolType>(&mut group, column, &cells, Value::as_bool)?,
                Kind::Text => {
                    let text = |cell: &Value| cell.as_str().map(ByteArray::from);
                    write_cells::<ByteArrayType>(&mut group, column, &cells, text)?;
                }
            }
        }
        group.close()?;
        self.held.clear();
        Ok(())
    }

    /// Writes what is still held back.
    pub fn finish(mut self) -> Result<W, Failure> {
        self.write_group()?;
        Ok(self.writer.into_inner()?)
    }
}

fn write_cells<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, impl Write + Send>,
    column: &Column,
    cells: &[&Value],
    value: impl Fn(&Value) -> Option<T::T>,
) -> Result<(), ParquetError> {
    let values: Vec<T::T> = cells.iter().filter_map(|cell| value(cell)).collect();
    let levels: Option<Vec<i16>> =
        (!column.always).then(|| cells.iter().map(|cell| i16::from(!cell.is_null())).collect());
    write_column::<T>(group, &values, levels.as_deref())
}

fn no_parquet(error: ParquetError) -> Failure {
    Failure::input(format!("this is not a Parquet file of a scan: {error}")).because(error)
}

/// The rows of a file.
pub fn rows(file: File) -> Result<impl Iterator<Item = Result<RowDocument, Failure>>, Failure> {
    let reader = SerializedFileReader::new(file).map_err(no_parquet)?;
    // Only our own columns; what others have added is of no concern.
    Ok(reader.into_iter().zip(1_u64..).map(|(row, number)| {
        let row = row.map_err(no_parquet)?;
        let fields: Map<String, Value> =
            row.get_column_iter().map(|(name, field)| (name.clone(), value(field))).collect();
        serde_json::from_value(Value::Object(fields)).map_err(|error| {
            Failure::input(format!(
                "row {number} of the Parquet file is not a row of a scan: \
            {error}"
            ))
        })
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
