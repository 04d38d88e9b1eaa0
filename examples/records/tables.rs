//! Tables of the fields, between the marks of a page: a comment `fields: NAME ` opens one, a comment `end` closes it.

use std::fmt::Write;

use serde_json::Value;

use crate::model::{Field, Form, Kind, Model, Type};

/// What every document begins with, or has where a part was given: described once.
const SHARED: [(&str, &str); 6] = [
    ("schema_version", "Head"),
    ("version", "Head"),
    ("command", "Head"),
    ("A", "GivenBody"),
    ("r", "GivenBody"),
    ("part", "ChaosMap"),
];

/// How a page is written.
#[derive(Clone, Copy)]
pub struct Style {
    open: &'static str,
    close: &'static str,
    end: &'static str,
    caption: fn(&Type) -> String,
    table: fn(&Page, &[&Field]) -> String,
}

pub const MARKDOWN: Style = Style {
    open: "<!-- fields: ",
    close: " -->",
    end: "<!-- end -->",
    caption: |of| format!("**{}.** {}\n\n", of.name, of.about),
    table: markdown,
};

pub const RST: Style = Style { open: ".. fields: ", close: "", end: ".. end", caption: |_| String::new(), table: rst };

/// A page, with the heading under which each type is described.
struct Page<'a> {
    model: &'a Model,
    headings: Vec<(&'a str, &'a str)>,
}

/// The page with its tables as they ought to be.
pub fn filled(model: &Model, text: &str, style: Style) -> Result<String, String> {
    let opened = |line: &str| -> Option<String> {
        Some(line.strip_prefix(style.open)?.strip_suffix(style.close)?.trim().to_owned())
    };
    let mut headings = Vec::new();
    let mut heading = "";
    for line in text.lines() {
        heading = line.strip_prefix('#').map_or(heading, |rest| rest.trim_start_matches('#').trim());
        if let Some(name) = line.strip_prefix(style.open).and_then(|rest| rest.strip_suffix(style.close)) {
            headings.push((name.trim(), heading));
        }
    }
    let page = Page { model, headings };
    let mut found = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        found += line;
        found.push('\n');
        let Some(name) = opened(line) else { continue };
        let of = model.find(&name).ok_or_else(|| format!("there is no type {name}"))?;
        found += &(style.caption)(of);
        found += &page.table(of, style)?;
        lines.by_ref().find(|line| *line == style.end).ok_or_else(|| format!("the table of {name} has no end"))?;
        found += style.end;
        found.push('\n');
    }
    Ok(found)
}

impl Page<'_> {
    fn table(&self, of: &Type, style: Style) -> Result<String, String> {
        // A field of the same name and another meaning, such as the body on a border, is its own.
        let described = |home: &str, field: &Field| match self.model.find(home).map(|home| &home.form) {
            Some(Form::Record(fields)) => fields.iter().any(|shared| shared.about == field.about),
            _ => true,
        };
        let is_shared = |field: &Field, (name, home): &(&str, &str)| {
            *name == field.name && *home != of.name && described(home, field)
        };
        let own = |field: &&Field| !SHARED.iter().any(|shared| is_shared(field, shared));
        match &of.form {
            Form::Record(fields) => Ok((style.table)(self, &fields.iter().filter(own).collect::<Vec<_>>())),
            Form::Words(words) => {
                let fields: Vec<Field> = words.iter().map(|(word, about)| as_field(word, about)).collect();
                Ok((style.table)(self, &fields.iter().collect::<Vec<_>>()))
            }
            Form::Other(_) => Err(format!("{} has no fields", of.name)),
        }
    }

    fn link(&self, name: &str) -> Option<String> {
        let (_, heading) = self.headings.iter().find(|(known, _)| *known == name)?;
        let keep = |c: char| c.is_alphanumeric() || c == '-' || c == '_' || c == ' ';
        let slug: String = heading.to_lowercase().chars().filter(|c| keep(*c)).collect();
        Some(format!("[{name}](#{})", slug.replace(' ', "-")))
    }

    /// What a field holds, in words.
    fn kind(&self, of: &Kind) -> String {
        match of {
            Kind::Text => "string".to_owned(),
            Kind::Number => "number".to_owned(),
            Kind::Integer => "integer".to_owned(),
            Kind::Boolean => "boolean".to_owned(),
            Kind::Constant(value) => format!("`{value}`"),
            Kind::Of(name) => match self.model.find(name).map(|of| &of.form) {
                _ if self.link(name).is_some() => self.link(name).unwrap_or_default(),
                Some(Form::Words(_)) => "string".to_owned(),
                Some(Form::Other(kind)) => self.kind(kind),
                _ => name.clone(),
            },
            Kind::List(inner) => format!("list of {}", self.kind(inner)),
            Kind::Several(inner, count) => format!("{count} × {}", self.kind(inner)),
            Kind::Tuple(kinds) => {
                format!("[{}]", kinds.iter().map(|kind| self.kind(kind)).collect::<Vec<_>>().join(", "))
            }
            Kind::Map(inner) => format!("by name: {}", self.kind(inner)),
            Kind::OrNull(inner) => format!("{} or null", self.kind(inner)),
            Kind::Either(kinds) => {
                let mut kinds: Vec<String> = kinds.iter().map(|kind| self.kind(kind)).collect();
                kinds.dedup();
                kinds.join(", ")
            }
        }
    }

    /// What a field means; of constants that have no table, each.
    fn meaning(&self, field: &Field) -> Vec<String> {
        let mut lines = vec![field.about.clone()];
        let mut named = false;
        if let Kind::Of(name) = &field.kind {
            named = self.link(name).is_some();
        }
        if let (false, Some(words)) = (named, self.model.words(&field.kind)) {
            lines.extend(words.iter().map(|(word, about)| format!("`{}`: {about}", bare(word))));
        }
        lines
    }
}

fn bare(word: &Value) -> String {
    word.as_str().map_or_else(|| word.to_string(), str::to_owned)
}

fn as_field(word: &Value, about: &str) -> Field {
    Field { name: bare(word), about: about.to_owned(), kind: Kind::Constant(word.clone()), optional: false }
}

fn optional(field: &Field) -> &'static str {
    if field.optional { ", optional" } else { "" }
}

fn markdown(page: &Page, fields: &[&Field]) -> String {
    let are_words = fields.iter().all(|field| matches!(field.kind, Kind::Constant(_)));
    let head = if are_words {
        "| value | meaning |\n| --- | --- |"
    } else {
        "| field | type | meaning |\n| --- | --- | --- |"
    };
    let mut text = format!("{head}\n");
    for field in fields {
        let kind = if are_words { String::new() } else { format!(" {}{} |", page.kind(&field.kind), optional(field)) };
        let meaning = page.meaning(field).join("<br>").replace('|', "\\|");
        let _ = writeln!(text, "| `{}` |{kind} {meaning} |", field.name);
    }
    text
}

fn rst(page: &Page, fields: &[&Field]) -> String {
    let code = |text: &str| text.replace('`', "``").replace('|', "\\|").replace('*', "\\*");
    let mut text = "\n.. list-table::\n   :widths: 20 20 60\n\n".to_owned();
    for field in fields {
        let _ =
            writeln!(text, "   * - ``{}``\n     - {}{}", field.name, code(&page.kind(&field.kind)), optional(field));
        for (number, line) in page.meaning(field).iter().enumerate() {
            let start = if number == 0 { "     - " } else { "\n       " };
            let _ = writeln!(text, "{start}{}", code(line));
        }
    }
    text.push('\n');
    text
}
