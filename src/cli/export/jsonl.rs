//! JSON Lines: one object a row.

use std::io::Write;

use serde_json::Value;

use super::columns::{Column, Values};
use super::error::ExportError;
use super::pieces::Pieces;

/// Writes the whole file. Numbers that JSON does not have (NaN) are null.
pub fn write(table: &mut impl Pieces, mut out: impl Write) -> Result<(), ExportError> {
    table.pieces(&mut |columns| out.write_all(lines(columns).as_bytes())).map_err(ExportError::Table)?;
    out.flush().map_err(ExportError::Table)?;
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
    use crate::cli::export::columns::Columns;

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
