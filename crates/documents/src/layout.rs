//! JSON for people: whatever fits goes on one line. Not a `Formatter` of serde_json, which sees a value only while it
//! is written: its length must be known in advance.

use std::ops::Range;

use serde::Serialize;

/// Lines are broken when they would become longer.
const WIDTH: usize = 110;

/// The JSON text of a document, as the program writes it everywhere, ending with a newline.
///
/// # Errors
/// When the document cannot be written as JSON.
pub fn text(document: &impl Serialize) -> Result<String, serde_json::Error> {
    let compact = bifdiag_schema::json(document)?;
    let mut outline = Outline { text: &compact, at: 0, nodes: Vec::with_capacity(compact.len() / 8) };
    outline.value(0..0);
    let mut page = Page {
        text: &compact,
        nodes: &outline.nodes,
        out: String::with_capacity(compact.len() + compact.len() / 4),
        line: 0,
    };
    page.write(0, 0);
    page.out.push('\n');
    Ok(page.out)
}

/// A value in the compact text.
struct Node {
    text: Range<usize>,
    /// Its key in an object, colon included.
    key: Range<usize>,
    kind: Kind,
    /// On one line.
    width: usize,
    /// A scalar, or a list of scalars.
    is_small: bool,
    /// The number of the node that follows what is inside.
    next: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Scalar,
    Array,
    Object,
}

/// The values of a compact text in order, each before what is inside.
struct Outline<'a> {
    text: &'a str,
    at: usize,
    nodes: Vec<Node>,
}

impl Outline<'_> {
    fn byte(&self) -> u8 {
        self.text.as_bytes()[self.at]
    }

    /// Passes a string.
    fn string(&mut self) {
        self.at += 1;
        while self.byte() != b'"' {
            self.at += if self.byte() == b'\\' { 2 } else { 1 };
        }
        self.at += 1;
    }

    /// Enters the value that begins here; the number of its node.
    fn value(&mut self, key: Range<usize>) -> usize {
        let (number, from) = (self.nodes.len(), self.at);
        let kind = match self.byte() {
            b'[' => Kind::Array,
            b'{' => Kind::Object,
            _ => Kind::Scalar,
        };
        self.nodes.push(Node { text: from..from, key, kind, width: 0, is_small: kind != Kind::Object, next: 0 });
        match self.byte() {
            b'[' | b'{' => self.inside(number),
            b'"' => self.string(),
            _ => {
                let rest = &self.text.as_bytes()[from..];
                self.at += rest.iter().position(|byte| b",]}".contains(byte)).unwrap_or(rest.len());
            }
        }
        let next = self.nodes.len();
        let node = &mut self.nodes[number];
        (node.text, node.next) = (from..self.at, next);
        if kind == Kind::Scalar {
            node.width = node.text.len();
        }
        number
    }

    /// Enters what is inside the brackets that begin here.
    fn inside(&mut self, number: usize) {
        let is_object = self.nodes[number].kind == Kind::Object;
        let (mut width, mut is_small) = (2, !is_object);
        self.at += 1;
        while !b"]}".contains(&self.byte()) {
            if self.byte() == b',' {
                self.at += 1;
                width += 2;
            }
            let from = self.at;
            if is_object {
                self.string();
                // The colon; a blank will follow it.
                self.at += 1;
                width += self.at - from + 1;
            }
            let inner = self.value(from..self.at);
            width += self.nodes[inner].width;
            is_small &= self.nodes[inner].kind == Kind::Scalar;
        }
        self.at += 1;
        (self.nodes[number].width, self.nodes[number].is_small) = (width, is_small);
    }
}

/// The text laid out so far.
struct Page<'a> {
    text: &'a str,
    nodes: &'a [Node],
    out: String,
    /// Where the last line begins.
    line: usize,
}

impl Page<'_> {
    fn write(&mut self, number: usize, indent: usize) {
        let node = &self.nodes[number];
        if node.kind == Kind::Scalar || node.width <= self.room() {
            return self.inline(number);
        }
        self.bracket(node.text.start);
        // Numbers, texts and points of an array fill lines; anything else has its own.
        let mut fill = false;
        let mut inner = number + 1;
        while inner < node.next {
            let item = &self.nodes[inner];
            if inner > number + 1 {
                self.out.push(',');
            }
            let small = node.kind == Kind::Array && item.is_small;
            if fill && small && item.width < self.room() {
                self.out.push(' ');
            } else {
                self.new_line(indent + 1);
            }
            fill = small;
            self.key(inner);
            self.write(inner, indent + 1);
            inner = item.next;
        }
        self.new_line(indent);
        self.bracket(node.text.end - 1);
    }

    fn inline(&mut self, number: usize) {
        let node = &self.nodes[number];
        if node.kind == Kind::Scalar {
            return self.out.push_str(&self.text[node.text.clone()]);
        }
        self.bracket(node.text.start);
        let mut inner = number + 1;
        while inner < node.next {
            if inner > number + 1 {
                self.out.push_str(", ");
            }
            self.key(inner);
            self.inline(inner);
            inner = self.nodes[inner].next;
        }
        self.bracket(node.text.end - 1);
    }

    fn bracket(&mut self, at: usize) {
        self.out.push_str(&self.text[at..=at]);
    }

    fn key(&mut self, number: usize) {
        let key = self.nodes[number].key.clone();
        if !key.is_empty() {
            self.out.push_str(&self.text[key]);
            self.out.push(' ');
        }
    }

    fn new_line(&mut self, indent: usize) {
        self.out.push('\n');
        self.line = self.out.len();
        self.out.extend(std::iter::repeat_n("  ", indent));
    }

    /// What is left of the line.
    fn room(&self) -> usize {
        WIDTH.saturating_sub(self.out.len() - self.line)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::{Value, json};

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
