//! Forgeries that are generated: every field and every list of a document.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_documents::seal;
use bifdiag_schema::AtlasDocument;
use bifdiag_verify::verify;
use serde_json::Value;

use crate::made::whole_documents;

/// A document with another value at a place, sealed anew: whether it is refused. What is no document is.
fn is_refused(document: &Value, pointer: &str, forgery: Value) -> bool {
    let mut forged = document.clone();
    *forged.pointer_mut(pointer).unwrap() = forgery;
    let Ok(mut forged) = serde_json::from_value::<AtlasDocument>(forged) else { return true };
    seal(&mut forged).unwrap();
    verify(&forged).is_err()
}

/// The drawing is no part of the proof.
fn is_drawn(field: &str) -> bool {
    field.trim_start_matches('.').starts_with("drawing.")
}

/// Every field of the document, forged once and sealed anew, is refused: a field that is added cannot be forgotten.
#[test]
fn every_field_is_refused_when_it_is_forged() {
    let mut known = BTreeSet::new();
    for document in whole_documents() {
        verify(&document).unwrap();
        let document = serde_json::to_value(document).unwrap();
        let mut fields = BTreeMap::new();
        leaves(&document, "", "", &mut fields);
        // By its form, and what the seal replaces.
        for field in ["version", "certificate.checksum"] {
            fields.remove(field).expect(field);
        }
        fields.retain(|field, _| !is_drawn(field));
        for (field, pointer) in fields.into_iter().filter(|(field, _)| known.insert(field.clone())) {
            for forgery in forgeries(document.pointer(&pointer).unwrap()) {
                assert!(is_refused(&document, &pointer, forgery), "{field} at {pointer}");
            }
        }
    }
}

/// Every list of the document with an entry left out, one repeated or two exchanged, in three places where it first stands,
/// sealed anew, is refused.
#[test]
fn every_list_is_refused_when_it_is_forged() {
    let mut known = BTreeSet::new();
    for document in whole_documents() {
        let document = serde_json::to_value(document).unwrap();
        let mut fields = BTreeMap::new();
        lists(&document, "", "", &mut fields);
        fields.retain(|field, _| !is_drawn(field));
        assert!(fields.len() > 30, "{}", fields.len());
        for (field, pointers) in fields {
            let middle = pointers.len() / 2;
            let chosen = if known.insert(field.clone()) { [0, middle, pointers.len() - 1] } else { [middle; 3] };
            for pointer in BTreeSet::from(chosen).into_iter().map(|number| &pointers[number]) {
                let list = document.pointer(pointer).unwrap().as_array().unwrap();
                for (what, forgery) in forged_lists(list) {
                    assert!(is_refused(&document, pointer, Value::Array(forgery)), "{what}: {field} at {pointer}");
                }
            }
        }
    }
}

/// Names exchanged wherever they stand are not those of their places.
#[test]
fn names_are_those_of_their_places() {
    let true_one = serde_json::to_string(&whole_documents()[0]).unwrap();
    for [p, q] in [["R1", "R2"], ["R3", "R7"], ["G1.1", "G1.2"], ["G0.1", "G3.1"], ["P+", "P-"], ["R9", "R10"]] {
        let quoted = |name: &str| format!("\"{name}\"");
        let exchanged =
            true_one.replace(&quoted(p), "\"?\"").replace(&quoted(q), &quoted(p)).replace("\"?\"", &quoted(q));
        assert_ne!(exchanged, true_one);
        let mut forged: AtlasDocument = serde_json::from_str(&exchanged).unwrap();
        seal(&mut forged).unwrap();
        assert!(verify(&forged).is_err(), "{p} and {q}");
    }
}

/// The first place of each field that has a value.
fn leaves(value: &Value, field: &str, pointer: &str, found: &mut BTreeMap<String, String>) {
    match value {
        Value::Object(entries) => {
            for (name, entry) in entries {
                let field = if field.is_empty() { name.clone() } else { format!("{field}.{name}") };
                leaves(entry, &field, &format!("{pointer}/{name}"), found);
            }
        }
        Value::Array(entries) => {
            for (number, entry) in entries.iter().enumerate() {
                leaves(entry, field, &format!("{pointer}/{number}"), found);
            }
        }
        _ => {
            found.entry(field.to_owned()).or_insert_with(|| pointer.to_owned());
        }
    }
}

/// Where the lists of each field stand that are not empty.
fn lists(value: &Value, field: &str, pointer: &str, found: &mut BTreeMap<String, Vec<String>>) {
    match value {
        Value::Object(entries) => {
            for (name, entry) in entries {
                lists(entry, &format!("{field}.{name}"), &format!("{pointer}/{name}"), found);
            }
        }
        Value::Array(entries) if !entries.is_empty() => {
            found.entry(field.to_owned()).or_default().push(pointer.to_owned());
            for (number, entry) in entries.iter().enumerate() {
                lists(entry, &format!("{field}[]"), &format!("{pointer}/{number}"), found);
            }
        }
        _ => {}
    }
}

/// A list with an entry left out, one repeated, two exchanged.
fn forged_lists(list: &[Value]) -> Vec<(&'static str, Vec<Value>)> {
    let at = list.len() / 2;
    let mut shorter = list.to_vec();
    shorter.remove(at);
    let mut longer = list.to_vec();
    longer.insert(at, list[at].clone());
    let mut exchanged = list.to_vec();
    exchanged.swap(at, (at + 1) % list.len());
    let mut forged = vec![("left out", shorter), ("twice", longer), ("exchanged", exchanged)];
    forged.retain(|(_, forgery)| forgery != list);
    forged
}

/// Other values of the same type; what is none of a list of words is no document.
fn forgeries(value: &Value) -> Vec<Value> {
    match value {
        Value::Bool(b) => vec![Value::Bool(!b)],
        Value::Number(n) => {
            vec![n.as_i64().map_or_else(|| (n.as_f64().unwrap() * 1.001 + 1e-3).into(), |n| (n + 1).into())]
        }
        Value::String(text) => {
            let others =
                ["crossing", "cusp", "elliptic", "saddle", "fast", "generic", "pair", "zero", "real-collision"];
            let words = others.into_iter().filter(|word| word != text).map(Value::from);
            std::iter::once(Value::from(format!("{text}1"))).chain(words).collect()
        }
        Value::Null => vec![1.5.into(), "R1".into(), 1.into()],
        Value::Array(_) | Value::Object(_) => Vec::new(),
    }
}
