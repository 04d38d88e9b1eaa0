//! JSON for people: what fits a line stands on one line.

use serde::Serialize;
use serde_json::Value;

/// Lines are broken when they would become longer.
const WIDTH: usize = 110;

/// The JSON text of a document, as the program writes it everywhere, ending with a newline.
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn text(document: &impl Serialize) -> Result<String, serde_json::Error> {
    let value = serde_json::to_value(document)?;
    let mut out = String::new();
    write(&mut out, &value, 0);
    out.push('\n');
    Ok(out)
}

fn write(out: &mut String, value: &Value, indent: usize) {
    if let Some(line) = on_one_line(value, room(out)) {
        out.push_str(&line);
        return;
    }
    let Some((open, items, close)) = parts(value) else { return out.push_str(&value.to_string()) };
    out.push(open);
    // Numbers, texts and points of an array fill lines; anything else has its own.
    let mut fill = false;
    for (i, (key, item)) in items.into_iter().enumerate() {
        out.push_str(if i > 0 { "," } else { "" });
        let small = key.is_none() && is_small(item);
        if fill && small && on_one_line(item, room(out).saturating_sub(1)).is_some() {
            out.push(' ');
        } else {
            new_line(out, indent + 1);
        }
        fill = small;
        push_key(out, key);
        write(out, item, indent + 1);
    }
    new_line(out, indent);
    out.push(close);
}

/// Items of an array, or of an object with their keys.
type Items<'a> = Vec<(Option<&'a str>, &'a Value)>;

/// The brackets of an array or an object, and what stands between.
fn parts(value: &Value) -> Option<(char, Items<'_>, char)> {
    match value {
        Value::Array(items) => Some(('[', items.iter().map(|item| (None, item)).collect(), ']')),
        Value::Object(items) => Some(('{', items.iter().map(|(key, item)| (Some(key.as_str()), item)).collect(), '}')),
        _ => None,
    }
}

/// A scalar, or a list of scalars.
fn is_small(item: &Value) -> bool {
    let composed = |item: &Value| item.is_array() || item.is_object();
    item.as_array().map_or(!composed(item), |items| !items.iter().any(composed))
}

fn push_key(out: &mut String, key: Option<&str>) {
    if let Some(key) = key {
        out.push_str(&Value::from(key).to_string());
        out.push_str(": ");
    }
}

fn new_line(out: &mut String, indent: usize) {
    out.push('\n');
    out.extend(std::iter::repeat_n("  ", indent));
}

/// What is left of the line.
fn room(out: &str) -> usize {
    WIDTH.saturating_sub(out.len() - out.rfind('\n').map_or(0, |at| at + 1))
}

/// The value on one line, if it is at most `room` wide.
fn on_one_line(value: &Value, room: usize) -> Option<String> {
    let mut out = String::new();
    inline(&mut out, value, room).then_some(out)
}

/// Adds the value; false as soon as the line is longer than `room`.
fn inline(out: &mut String, value: &Value, room: usize) -> bool {
    if let Some((open, items, close)) = parts(value) {
        out.push(open);
        for (i, (key, item)) in items.into_iter().enumerate() {
            out.push_str(if i > 0 { ", " } else { "" });
            push_key(out, key);
            if !inline(out, item, room) {
                return false;
            }
        }
        out.push(close);
    } else {
        out.push_str(&value.to_string());
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
