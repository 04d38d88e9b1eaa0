//! Comma-separated values: a heading, then the rows; vectors are several columns numbered from 1.

use std::io::Write;

use super::columns::Column;
use super::error::ExportError;
use super::pieces::Pieces;

/// Writes the whole file.
pub fn write(table: &mut impl Pieces, out: impl Write) -> Result<(), ExportError> {
    let mut writer = csv::Writer::from_writer(out);
    let columns = table.columns();
    let heading = columns
        .iter()
        .flat_map(|column: &Column| column.values.parts().iter().map(|part| format!("{}{part}", column.name)));
    writer.write_record(heading)?;
    let rows = |columns: &[Column]| {
        for row in 0..columns.first().map_or(0, |column| column.values.len()) {
            let cells = columns.iter().map(|column| &column.values);
            writer
                .write_record(cells.flat_map(|values| (0..values.parts().len()).map(move |k| values.text(row, k))))?;
        }
        Ok(())
    };
    table.pieces(&mut { rows }).map_err(csv::Error::from)?;
    writer.flush().map_err(csv::Error::from)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::export::{Columns, Values};

    #[test]
    fn vectors_are_numbered_columns_and_numbers_read_back() {
        let table = Columns {
            columns: vec![
                Column { name: "index", values: Values::Int32(vec![0, 1]) },
                Column {
                    name: "gamma",
                    values: Values::vectors([[0.1, -1e-300, 1e22], [0.0, 1.0 / 3.0, 2.0]].into_iter()),
                },
                Column { name: "q", values: Values::quaternions([[1.0, 0.0, 0.0, 0.0]; 2].into_iter()) },
            ],
            meta: String::new(),
        };
        let expected = "index,gamma1,gamma2,gamma3,q_w,q_x,q_y,q_z\n0,0.1,-1e-300,1e22,1.0,0.0,0.0,0.0\n\
                        1,0.0,0.3333333333333333,2.0,1.0,0.0,0.0,0.0\n";
        let mut out = Vec::new();
        write(&mut &table, &mut out).unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }
}
