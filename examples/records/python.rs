//! The records of the Python package.

use std::fmt::Write;

use serde_json::Value;

use crate::model::{Field, Form, Kind, Model, Type};

/// Columns of a line.
const WIDTH: usize = 124;

/// Records that users meet, each after those that it holds.
const RECORDS: [&str; 20] = [
    "Component",
    "Margin",
    "Candidate",
    "Classification",
    "Sample",
    "Neighbour",
    "Cell",
    "Region",
    "Enclosure",
    "Event",
    "StabilityChange",
    "VerdictChange",
    "Resonances",
    "Nonlinear",
    "Friction",
    "StabilitySpan",
    "Tail",
    "Curve",
    "ChaosShare",
    "ChaosPoint",
];

/// Records that do more than hold their fields: `behaviour` says what, and it prints them if the flag is set.
const BEHAVING: [(&str, bool); 4] = [("Classification", true), ("Curve", true), ("Region", true), ("Sample", false)];

/// Records that also hold what was drawn of them.
const DRAWN: [&str; 2] = ["Curve", "Region"];

/// What the body of a classification says already.
const LEFT_OUT: [&str; 6] = ["schema_version", "version", "command", "A", "r", "part"];

/// Ends of a range that may be infinite, as pairs are.
const INFINITE_END: &str = "l_to";

const HEAD: &str = r#""""What the documents of the program hold, as records: read-only, comparable, picklable, with all their fields printed.

Written by ``cargo run --release --example records`` from the JSON Schemas of the documents.
"""

from dataclasses import dataclass
from typing import Any

from . import behaviour
from .behaviour import Document, infinite, maybe, span
"#;

pub fn module(model: &Model) -> String {
    let mut text = HEAD.to_owned();
    for name in RECORDS {
        if let Some((of, Form::Record(fields))) = model.find(name).map(|of| (of, &of.form)) {
            let fields: Vec<&Field> = fields.iter().filter(|field| !LEFT_OUT.contains(&field.name.as_str())).collect();
            text += &record(model, of, &fields);
        }
    }
    text
}

fn record(model: &Model, of: &Type, fields: &[&Field]) -> String {
    let name = &of.name;
    let behaving = BEHAVING.iter().find(|(known, _)| known == name);
    let base = if behaving.is_some() { format!("(behaviour.{name})") } else { String::new() };
    let repr = if behaving.is_some_and(|(_, prints)| *prints) { ", repr=False" } else { "" };
    let mut text = format!("\n\n@dataclass(frozen=True, slots=True{repr})\nclass {name}{base}:\n");
    text += &wrapped(&format!("\"\"\"{}", code(&of.about)), 4);
    text += "\n    Attributes\n    ----------\n";
    let mut listed = Vec::new();
    for field in fields {
        let _ = writeln!(text, "    {} : {}", attribute(field), in_words(field));
        text += &wrapped(&meaning(model, field, &mut listed), 8);
    }
    text += "    \"\"\"\n\n";
    for field in fields {
        let _ = writeln!(text, "    {}: {}", attribute(field), annotation(field));
    }
    let drawn = DRAWN.contains(&name.as_str());
    let parameters = if drawn { "document: Document, drawn: Any" } else { "document: Document" };
    let made = if drawn { "made = cls(" } else { "return cls(" };
    let _ = write!(text, "\n    @classmethod\n    def _of(cls, {parameters}) -> \"{name}\":\n        {made}\n");
    for field in fields {
        let _ = writeln!(text, "            {},", value(field));
    }
    text += "        )\n";
    if drawn {
        text += "        return made._with(drawn)\n";
    }
    text
}

/// Text in lines, each indented.
fn wrapped(text: &str, indent: usize) -> String {
    let mut lines = String::new();
    let mut line = " ".repeat(indent);
    for word in text.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDTH && line.trim() != "" {
            lines += line.trim_end();
            lines.push('\n');
            line = " ".repeat(indent);
        }
        if line.trim() != "" {
            line.push(' ');
        }
        line += word;
    }
    lines + line.trim_end() + "\n"
}

/// Code as docstrings mark it, and null as Python says it.
fn code(text: &str) -> String {
    without(text).replace("`null`", "null").replace("null", "None").replace('`', "``")
}

/// What a document lacks is None.
fn without(text: &str) -> String {
    text.replace("Absent ", "None ").replace("; absent ", "; None ")
}

fn is_range(kind: &Kind) -> bool {
    matches!(kind, Kind::Several(inner, 2) if matches!(**inner, Kind::OrNull(_)))
}

/// The name of a field, which may be a word of the language or none.
fn attribute(field: &Field) -> &str {
    match field.name.as_str() {
        "from" => "from_",
        "1:1" => "one_to_one",
        "1:2" => "one_to_two",
        "1:3" => "one_to_three",
        name => name,
    }
}

/// What a field means; of constants each, where they are named for the first time.
fn meaning<'a>(model: &Model, field: &'a Field, listed: &mut Vec<&'a str>) -> String {
    let about = if is_range(&field.kind) {
        without(&field.about).replace("null", "``inf`` (the lower one ``-inf``)")
    } else if field.name == INFINITE_END {
        field.about.replace("null", "``inf``")
    } else {
        code(&field.about)
    };
    let word = |(word, about): &(Value, String)| format!("``{word}``: {}", code(about));
    match (&field.kind, model.words(&field.kind)) {
        (Kind::Of(name), Some(words)) if !about.starts_with('`') && !listed.contains(&name.as_str()) => {
            listed.push(name);
            let words: Vec<String> = words.iter().map(word).collect();
            format!("{about} {}", words.join(" "))
        }
        _ => about,
    }
}

/// The type of a field, as annotations have it.
fn annotation(field: &Field) -> String {
    let found = if field.name == INFINITE_END { "float".to_owned() } else { kind(&field.kind) };
    if is_absent_none(field) { format!("{found} | None") } else { found }
}

/// The type of a field, as docstrings have it.
fn in_words(field: &Field) -> String {
    annotation(field).replace(" | ", " or ")
}

/// Where it may be absent, a list is then empty and a flag not set; anything else is None.
fn is_absent_none(field: &Field) -> bool {
    field.optional && !matches!(field.kind, Kind::Boolean | Kind::List(_))
}

fn kind(of: &Kind) -> String {
    match of {
        Kind::Number => "float".to_owned(),
        Kind::Integer => "int".to_owned(),
        Kind::Boolean => "bool".to_owned(),
        Kind::Of(name) if RECORDS.contains(&name.as_str()) => name.clone(),
        Kind::List(inner) => format!("tuple[{}, ...]", kind(inner)),
        range if is_range(range) => "tuple[float, float]".to_owned(),
        Kind::Several(inner, count) => {
            format!("tuple[{}]", vec![kind(inner); usize::try_from(*count).unwrap_or(0)].join(", "))
        }
        Kind::Tuple(kinds) => format!("tuple[{}]", kinds.iter().map(kind).collect::<Vec<_>>().join(", ")),
        Kind::Map(inner) => format!("dict[str, {}]", kind(inner)),
        Kind::OrNull(inner) => format!("{} | None", kind(inner)),
        Kind::Text | Kind::Of(_) | Kind::Constant(_) | Kind::Either(_) => "str".to_owned(),
    }
}

/// The value of a field, from its document.
fn value(field: &Field) -> String {
    let name = format!("\"{}\"", field.name);
    let place = match field.kind {
        _ if !field.optional => format!("document[{name}]"),
        Kind::Boolean => format!("document.get({name}, False)"),
        Kind::List(_) => format!("document.get({name}, ())"),
        _ => format!("document.get({name})"),
    };
    if field.name == INFINITE_END {
        return format!("infinite({place})");
    }
    match (made(&field.kind), &field.kind) {
        (None, _) => place,
        (Some(make), Kind::OrNull(_)) => format!("maybe({make}, {place})"),
        (Some(make), _) if is_absent_none(field) => format!("maybe({make}, {place})"),
        (Some(make), _) => match make.strip_prefix("lambda found: ") {
            Some(body) => body.replace("found", &place),
            None => format!("{make}({place})"),
        },
    }
}

/// The function that makes a value of what a document holds, if it is not the same.
fn made(of: &Kind) -> Option<String> {
    match of {
        Kind::Of(name) if RECORDS.contains(&name.as_str()) => Some(format!("{name}._of")),
        Kind::OrNull(inner) => made(inner),
        range if is_range(range) => Some("span".to_owned()),
        Kind::List(inner) if matches!(**inner, Kind::Tuple(_)) => {
            let Kind::Tuple(kinds) = &**inner else { return None };
            let at = |(place, kind)| match made(kind) {
                Some(make) => format!("{make}(pair[{place}])"),
                None => format!("pair[{place}]"),
            };
            let all: Vec<String> = kinds.iter().enumerate().map(at).collect();
            Some(format!("lambda found: tuple(({}) for pair in found)", all.join(", ")))
        }
        Kind::List(inner) | Kind::Several(inner, _) => Some(match made(inner) {
            Some(make) => format!("lambda found: tuple(map({make}, found))"),
            None => "tuple".to_owned(),
        }),
        _ => None,
    }
}
