//! JSON for people: what fits a line stands on one line.

use serde::Serialize;
use serde_json::Value;

/// Lines are broken when they would become longer.
const WIDTH: usize = 110;

/// The JSON text of a document, ending with a newline.
///
/// # Errors
/// When a value of the document cannot be written as JSON.
pub fn text(document: &impl Serialize) -> Result<String, serde_json::Error> {
    let value = serde_json::to_value(document)?;
    let mut out = String::new();
    write(&mut out, &value, 0)?;
    out.push('\n');
    Ok(out)
}

fn write(out: &mut String, value: &Value, indent: usize) -> Result<(), serde_json::Error> {
    let column = out.len() - out.rfind('\n').map_or(0, |at| at + 1);
    if let Some(line) = on_one_line(value, WIDTH.saturating_sub(column)) {
        out.push_str(&line);
        return Ok(());
    }
    let inner = indent + 1;
    match value {
        Value::Array(items) => {
            out.push('[');
            let mut fill = false;
            for (i, item) in items.iter().enumerate() {
                separate(out, item, i, inner, &mut fill);
                write(out, item, inner)?;
            }
            new_line(out, indent);
            out.push(']');
        }
        Value::Object(entries) => {
            out.push('{');
            for (i, (key, item)) in entries.iter().enumerate() {
                if i > 0 {
                    out.push(',');
                }
                new_line(out, inner);
                out.push_str(&serde_json::to_string(key)?);
                out.push_str(": ");
                write(out, item, inner)?;
            }
            new_line(out, indent);
            out.push('}');
        }
        scalar => out.push_str(&scalar.to_string()),
    }
    Ok(())
}

/// Between items of an array: numbers, texts and points fill lines, anything else has its own.
fn separate(out: &mut String, item: &Value, i: usize, indent: usize, fill: &mut bool) {
    if i > 0 {
        out.push(',');
    }
    let small = match item {
        Value::Array(items) => items.iter().all(|item| !item.is_array() && !item.is_object()),
        Value::Object(_) => false,
        _ => true,
    };
    let column = out.len() - out.rfind('\n').map_or(0, |at| at + 1);
    let fits = *fill && small && on_one_line(item, WIDTH.saturating_sub(column + 1)).is_some();
    if fits {
        out.push(' ');
    } else {
        new_line(out, indent);
    }
    *fill = small;
}

fn new_line(out: &mut String, indent: usize) {
    out.push('\n');
    for _ in 0..indent {
        out.push_str("  ");
    }
}

/// The value on one line, if it is at most `room` wide.
fn on_one_line(value: &Value, room: usize) -> Option<String> {
    let mut out = String::new();
    inline(&mut out, value, room).then_some(out)
}

fn inline(out: &mut String, value: &Value, room: usize) -> bool {
    match value {
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                if i > 0 {
                    out.push_str(", ");
                }
                if !inline(out, item, room) {
                    return false;
                }
            }
            out.push(']');
        }
        Value::Object(entries) => {
            out.push('{');
            for (i, (key, item)) in entries.iter().enumerate() {
                if i > 0 {
                    out.push_str(", ");
                }
                out.push_str(&Value::from(key.as_str()).to_string());
                out.push_str(": ");
                if !inline(out, item, room) {
                    return false;
                }
            }
            out.push('}');
        }
        scalar => out.push_str(&scalar.to_string()),
    }
    out.len() <= room
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::json;

    use super::*;

    #[test]
    fn short_documents_stand_on_one_line() {
        assert_eq!(text(&json!({"a": [1, 2.5], "b": null})).unwrap(), "{\"a\": [1, 2.5], \"b\": null}\n");
        assert_eq!(text(&json!("x")).unwrap(), "\"x\"\n");
    }

    #[test]
    fn long_documents_break_and_mean_the_same() {
        let points: Vec<[f64; 2]> = (0..100).map(|i| [f64::from(i) / 7.0, -1e-300 * f64::from(i)]).collect();
        let value = json!({"points": points, "long \"key\"": "é".repeat(200), "empty": [], "more": [{"a": points}]});
        let laid_out = text(&value).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&laid_out).unwrap(), value);
        assert!(laid_out.lines().filter(|line| line.contains("e-")).all(|line| line.len() <= WIDTH + 2));
        assert!(laid_out.lines().count() < 120);
    }

    fn documents() -> impl Strategy<Value = Value> {
        let scalar = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::from),
            any::<i64>().prop_map(Value::from),
            prop::num::f64::NORMAL.prop_map(Value::from),
            ".{0,60}".prop_map(Value::from),
        ];
        scalar.prop_recursive(4, 200, 12, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..12).prop_map(Value::from),
                prop::collection::btree_map(".{0,20}", inner, 0..8)
                    .prop_map(|map| Value::Object(map.into_iter().collect())),
            ]
        })
    }

    proptest! {
        #[test]
        fn the_layout_changes_no_value(document in documents()) {
            let text = text(&document).unwrap();
            prop_assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), document);
            prop_assert!(text.ends_with('\n'));
        }
    }
}
