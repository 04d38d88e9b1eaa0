//! Comma-separated values: a heading, then the rows; vectors are several columns numbered from 1.

use super::columns::{Columns, Values};
use super::error::ExportError;

/// Names of the components of a quaternion w + x i + y j + z k.
const QUATERNION: [&str; 4] = ["w", "x", "y", "z"];

/// The whole file.
pub fn table(table: &Columns) -> Result<Vec<u8>, ExportError> {
    let mut out = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut out);
    let names = table.columns.iter().flat_map(|column| match (&column.values, column.values.width()) {
        (_, 1) => vec![column.name.to_owned()],
        (Values::Quaternion(_), _) => QUATERNION.map(|part| format!("{}_{part}", column.name)).into(),
        (_, width) => (1..=width).map(|k| format!("{}{k}", column.name)).collect(),
    });
    writer.write_record(names)?;
    for row in 0..table.rows() {
        let cells = table.columns.iter().map(|column| &column.values);
        writer.write_record(cells.flat_map(|values| (0..values.width()).map(move |k| values.text(row, k))))?;
    }
    writer.flush().map_err(csv::Error::from)?;
    drop(writer);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::export::columns::Column;

    #[test]
    fn vectors_are_numbered_columns_and_numbers_read_back() {
        let table = Columns {
            columns: vec![
                Column { name: "index", values: Values::Int32(vec![0, 1]) },
                Column { name: "gamma", values: Values::Vector(vec![[0.1, -1e-300, 1e22], [0.0, 1.0 / 3.0, 2.0]]) },
                Column { name: "q", values: Values::Quaternion(vec![[1.0, 0.0, 0.0, 0.0]; 2]) },
            ],
            meta: String::new(),
        };
        let expected = "index,gamma1,gamma2,gamma3,q_w,q_x,q_y,q_z\n0,0.1,-1e-300,1e22,1.0,0.0,0.0,0.0\n\
                        1,0.0,0.3333333333333333,2.0,1.0,0.0,0.0,0.0\n";
        assert_eq!(String::from_utf8(super::table(&table).unwrap()).unwrap(), expected);
    }
}
