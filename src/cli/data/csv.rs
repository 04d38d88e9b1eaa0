//! Comma-separated values: a heading, then the rows; vectors are several columns numbered from 1.

use super::{DataTable, Values};

/// Names of the components of a quaternion w + x i + y j + z k.
const QUATERNION: [&str; 4] = ["w", "x", "y", "z"];

/// The whole file.
pub fn text(table: &DataTable) -> String {
    let mut heading = Vec::new();
    for column in &table.columns {
        match (&column.values, column.values.width()) {
            (_, 1) => heading.push(column.name.to_owned()),
            (Values::Quaternion(_), _) => heading.extend(QUATERNION.map(|part| format!("{}_{part}", column.name))),
            (_, width) => heading.extend((1..=width).map(|k| format!("{}{k}", column.name))),
        }
    }
    let mut out = heading.join(",");
    out.push('\n');
    for row in 0..table.rows() {
        for (i, column) in table.columns.iter().enumerate() {
            for k in 0..column.values.width() {
                if i + k > 0 {
                    out.push(',');
                }
                out.push_str(&column.values.text(row, k));
            }
        }
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::data::Column;

    #[test]
    fn vectors_are_numbered_columns_and_numbers_read_back() {
        let table = DataTable {
            columns: vec![
                Column { name: "index", values: Values::Int32(vec![0, 1]) },
                Column { name: "gamma", values: Values::Vector(vec![[0.1, -1e-300, 1e22], [0.0, 1.0 / 3.0, 2.0]]) },
                Column { name: "q", values: Values::Quaternion(vec![[1.0, 0.0, 0.0, 0.0]; 2]) },
            ],
            meta: String::new(),
        };
        let expected = "index,gamma1,gamma2,gamma3,q_w,q_x,q_y,q_z\n0,0.1,-1e-300,1e22,1.0,0.0,0.0,0.0\n\
                        1,0.0,0.3333333333333333,2.0,1.0,0.0,0.0,0.0\n";
        assert_eq!(text(&table), expected);
    }
}
