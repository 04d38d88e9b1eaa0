//! Types of the documents for the page.

use std::fmt::Write;

use crate::model::{Form, Kind, Model};

/// The documents that the page reads.
const READ: [&str; 5] = ["Atlas", "Classification", "Critical", "Orbit", "Part"];

pub fn module(model: &Model) -> String {
    let mut text =
        "/** The documents of the command line. Written by `cargo run --release --example records`. */\n".to_owned();
    for of in model.needed(&READ) {
        // A name of the language.
        if of.name == "Number" {
            continue;
        }
        let _ = write!(text, "\n/** {} */\n", of.about);
        match &of.form {
            Form::Record(fields) => {
                let _ = writeln!(text, "export interface {} {{", of.name);
                for field in fields {
                    let mark = if field.optional { "?" } else { "" };
                    let is_name = field.name.chars().all(|c| c.is_alphanumeric() || c == '_');
                    let name = if is_name { field.name.clone() } else { format!("\"{}\"", field.name) };
                    let _ = writeln!(text, "  /** {} */\n  {name}{mark}: {};", field.about, kind(&field.kind));
                }
                text += "}\n";
            }
            Form::Words(words) => {
                let words: Vec<String> = words.iter().map(|(word, _)| word.to_string()).collect();
                let _ = writeln!(text, "export type {} = {};", of.name, words.join(" | "));
            }
            Form::Other(other) => {
                let _ = writeln!(text, "export type {} = {};", of.name, kind(other));
            }
        }
    }
    text
}

fn kind(of: &Kind) -> String {
    match of {
        Kind::Text => "string".to_owned(),
        Kind::Number | Kind::Integer => "number".to_owned(),
        Kind::Boolean => "boolean".to_owned(),
        Kind::Constant(value) => value.to_string(),
        Kind::Of(name) if name == "Number" => "string".to_owned(),
        Kind::Of(name) => name.clone(),
        Kind::List(inner) => match kind(inner) {
            simple if simple.contains(' ') && !simple.starts_with('[') => format!("({simple})[]"),
            simple => format!("{simple}[]"),
        },
        Kind::Several(inner, count) => {
            format!("[{}]", vec![kind(inner); usize::try_from(*count).unwrap_or(0)].join(", "))
        }
        Kind::Tuple(kinds) => format!("[{}]", kinds.iter().map(kind).collect::<Vec<_>>().join(", ")),
        Kind::Map(inner) => format!("Record<string, {}>", kind(inner)),
        Kind::OrNull(inner) => format!("{} | null", kind(inner)),
        Kind::Either(kinds) => kinds.iter().map(kind).collect::<Vec<_>>().join(" | "),
    }
}
