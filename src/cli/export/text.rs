//! Tables as text.

use std::io::Write;

use serde_json::Value;

use super::columns::{Column, Pieces, Values};
use crate::cli::failure::{Failure, failed};

/// Comma-separated values: a heading, then the rows; vectors are several columns numbered from 1.
pub fn csv(table: &mut impl Pieces, out: impl Write) -> Result<(), Failure> {
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

/// JSON Lines: one object a row. Numbers that JSON does not have (NaN) are null.
pub fn json_lines(table: &mut impl Pieces, mut out: impl Write) -> Result<(), Failure> {
    table
        .pieces(&mut |columns| out.write_all(lines(columns).as_bytes()))
        .map_err(failed("the table could not be written"))?;
    out.flush().map_err(failed("the table could not be written"))?;
    Ok(())
}

fn lines(columns: &[Column]) -> String {
    let mut out = String::new();
    for row in 0..columns.first().map_or(0, |column| column.values.len()) {
        out.push('{');
        for (i, column) in columns.iter().enumerate() {
            if i > 0 {
                out.push_str(", ");
            }
            let entries: Vec<String> =
                (0..column.values.parts().len()).map(|k| entry(&column.values, row, k)).collect();
            let value = if entries.len() == 1 { entries.concat() } else { format!("[{}]", entries.join(", ")) };
            out.extend(["\"", column.name, "\": ", &value]);
        }
        out.push_str("}\n");
    }
    out
}

fn entry(values: &Values, row: usize, k: usize) -> String {
    let text = values.text(row, k);
    match values {
        Values::Words { words, .. } if words.iter().any(|word| word.as_str() == Some(&text)) => {
            Value::from(text).to_string()
        }
        Values::Float { .. } if text.contains(['N', 'i']) => "null".to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::export::Columns;

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
        csv(&mut &table, &mut out).unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }

    #[test]
    fn each_row_is_an_object() {
        let table = Columns {
            columns: vec![
                Column { name: "time", values: Values::floats([0.5, f64::NAN].into_iter()) },
                Column { name: "gamma", values: Values::vectors([[1.0, 0.0, -1e-9]; 2].into_iter()) },
            ],
            meta: String::new(),
        };
        let text = lines(&table.columns);
        let rows: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(rows[0], serde_json::json!({"time": 0.5, "gamma": [1.0, 0.0, -1e-9]}));
        assert!(rows[1]["time"].is_null());
    }
}
