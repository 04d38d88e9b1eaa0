//! Apache Parquet: a column for each number of a row, groups of rows of one size, `meta` among the file's key-value metadata.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{WriterProperties, WriterPropertiesBuilder};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use super::columns::{Column, Pieces, Values};
use crate::cli::failure::{Failure, failed};

/// Rows of a group: of this size whatever pieces the table comes in, so that its bytes depend on nothing else.
const GROUP: usize = 1 << 17;

/// Writes the whole file. Numbers are not packed: the low bits of chaotic motion are random.
pub fn write(table: &mut impl Pieces, out: impl Write + Send) -> Result<(), Failure> {
    let mut held = table.columns();
    let meta = KeyValue { key: "meta".to_owned(), value: Some(table.meta().to_owned()) };
    let properties = WriterProperties::builder().set_dictionary_enabled(false).set_key_value_metadata(Some(vec![meta]));
    let mut writer = begin(out, "bifdiag", fields(&held)?, properties)?;
    table
        .pieces(&mut |piece| {
            let rows = piece.first().map_or(0, |column| column.values.len());
            let mut taken = 0;
            while taken < rows {
                let room = GROUP - held[0].values.len();
                let next = rows.min(taken + room);
                for (held, column) in held.iter_mut().zip(piece) {
                    held.values.extend_from(&column.values, taken..next);
                }
                taken = next;
                if held[0].values.len() == GROUP {
                    write_group(&mut writer, &held).map_err(std::io::Error::other)?;
                    held = held.iter().map(Column::without_rows).collect();
                }
            }
            Ok(())
        })
        .map_err(failed("the table could not be written"))?;
    if held.first().is_some_and(|column| column.values.len() > 0) {
        write_group(&mut writer, &held)?;
    }
    writer.close()?;
    Ok(())
}

/// The names and types of the columns.
fn fields(columns: &[Column]) -> Result<Vec<Type>, ParquetError> {
    let mut fields = Vec::new();
    for column in columns {
        let (physical, logical) = match column.values {
            Values::Int8(_) => (Physical::INT32, Some(LogicalType::integer(8, true))),
            Values::Int32(_) => (Physical::INT32, None),
            Values::Words { .. } => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            Values::Float { .. } => (Physical::DOUBLE, None),
        };
        for part in column.values.parts() {
            let name = format!("{}{part}", column.name);
            let field = Type::primitive_type_builder(&name, physical)
                .with_repetition(Repetition::REQUIRED)
                .with_logical_type(logical.clone());
            fields.push(field.build()?);
        }
    }
    Ok(fields)
}

fn write_group<W: Write + Send>(writer: &mut SerializedFileWriter<W>, columns: &[Column]) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for column in columns {
        let rows = 0..column.values.len();
        match &column.values {
            Values::Int8(values) => {
                write_column::<Int32Type>(&mut group, &values.iter().map(|x| i32::from(*x)).collect::<Vec<_>>(), None)?;
            }
            Values::Int32(values) => write_column::<Int32Type>(&mut group, values, None)?,
            Values::Words { .. } => {
                let texts: Vec<ByteArray> =
                    rows.map(|row| ByteArray::from(column.values.text(row, 0).into_bytes())).collect();
                write_column::<ByteArrayType>(&mut group, &texts, None)?;
            }
            Values::Float { parts, values } => {
                for part in 0..parts.len() {
                    let values: Vec<f64> = values.iter().skip(part).step_by(parts.len()).copied().collect();
                    write_column::<DoubleType>(&mut group, &values, None)?;
                }
            }
        }
    }
    group.close()?;
    Ok(())
}

/// Begins a file with these columns.
pub fn begin<W: Write + Send>(
    out: W,
    name: &str,
    fields: Vec<Type>,
    properties: WriterPropertiesBuilder,
) -> Result<SerializedFileWriter<W>, ParquetError> {
    let message = Type::group_type_builder(name).with_fields(fields.into_iter().map(Arc::new).collect()).build()?;
    let properties = properties.set_created_by(concat!("bifdiag ", env!("CARGO_PKG_VERSION")).to_owned()).build();
    SerializedFileWriter::new(out, Arc::new(message), Arc::new(properties))
}

/// Writes the next column of a group; `levels` are 0 where a value is missing.
pub fn write_column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, impl Write + Send>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let mut column = group.next_column()?.ok_or_else(|| ParquetError::General("a column too many".to_owned()))?;
    column.typed::<T>().write_batch(values, levels, None)?;
    column.close()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::export::Columns;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use std::fs::File;

    /// A table that comes in pieces of some size.
    struct Cut(Columns, usize);

    impl Pieces for Cut {
        fn columns(&self) -> Vec<Column> {
            (&&self.0).columns()
        }

        fn rows(&self) -> usize {
            self.0.rows()
        }

        fn meta(&self) -> &str {
            &self.0.meta
        }

        fn column(&mut self, _: usize, _: &mut dyn FnMut(&[u8]) -> std::io::Result<()>) -> std::io::Result<()> {
            unreachable!("Parquet is written by rows")
        }

        fn pieces(&mut self, take: &mut dyn FnMut(&[Column]) -> std::io::Result<()>) -> std::io::Result<()> {
            for from in (0..self.0.rows()).step_by(self.1) {
                let mut piece = self.columns();
                for (piece, whole) in piece.iter_mut().zip(&self.0.columns) {
                    piece.values.extend_from(&whole.values, from..self.0.rows().min(from + self.1));
                }
                take(&piece)?;
            }
            Ok(())
        }
    }

    fn table(rows: i32) -> Columns {
        let float = |k: i32| f64::from(k) * 0.1;
        Columns {
            columns: vec![
                Column { name: "orbit", values: Values::Int32((0..rows).collect()) },
                Column { name: "gamma", values: Values::vectors((0..rows).map(|k| [float(k), float(-k), 1.0])) },
                Column {
                    name: "sheet",
                    values: Values::Int8((0..rows).map(|k| if k % 2 == 0 { 1 } else { -1 }).collect()),
                },
                Column {
                    name: "kind",
                    values: Values::words(
                        &["saddle", "elliptic"],
                        Values::Int8((0..rows).map(|k| i8::from(k > 2)).collect()),
                    )
                    .unwrap(),
                },
            ],
            meta: "{\"h\": 1}".to_owned(),
        }
    }

    fn written(table: Columns, piece: usize) -> (Vec<u8>, SerializedFileReader<File>) {
        let mut out = Vec::new();
        write(&mut Cut(table, piece), &mut out).unwrap();
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(&out).unwrap();
        (out, SerializedFileReader::new(file).unwrap())
    }

    #[test]
    fn rows_come_back_whatever_pieces_they_came_in() {
        let rows = i32::try_from(GROUP).unwrap() + 100;
        let (whole, reader) = written(table(rows), GROUP + 100);
        assert!(whole == written(table(rows), 1 << 12).0);
        let metadata = reader.metadata();
        assert_eq!(metadata.num_row_groups(), 2);
        let kept = metadata.file_metadata().key_value_metadata().unwrap();
        assert_eq!((kept[0].key.as_str(), kept[0].value.as_deref()), ("meta", Some("{\"h\": 1}")));
        let row = reader.into_iter().nth(GROUP + 7).unwrap().unwrap();
        let fields: Vec<(String, Field)> = row.into_columns();
        let number = i32::try_from(GROUP).unwrap() + 7;
        assert_eq!(fields[0], ("orbit".to_owned(), Field::Int(number)));
        assert_eq!(fields[2], ("gamma2".to_owned(), Field::Double(f64::from(-number) * 0.1)));
        assert_eq!(fields[4], ("sheet".to_owned(), Field::Byte(-1)));
        assert_eq!(fields[5], ("kind".to_owned(), Field::Str("elliptic".to_owned())));
    }

    #[test]
    fn a_table_without_rows_has_its_columns() {
        let (_, reader) = written(table(0), 1);
        assert_eq!(reader.metadata().file_metadata().schema_descr().num_columns(), 6);
        assert_eq!(reader.into_iter().count(), 0);
    }
}
