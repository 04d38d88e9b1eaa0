//! The command that a document names: the canonical one of its body and of what it holds.

use bifdiag_schema::AtlasDocument;

/// The command line that makes a document with its certificate, from its body, or the part of which that is, and from what it
/// holds.
pub(crate) fn canonical(document: &AtlasDocument) -> String {
    let given = &document.body.given;
    let mut line = Line("bifdiag atlas".to_owned());
    if let Some(part) = &document.body.part {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = &part.inertia;
        line.option("inertia", &[xx, yy, zz, xy, xz, yz].map(String::as_str).join(","));
        if [xy, xz, yz].iter().any(|product| *product != "0") {
            line.option("products", "tensor");
        }
        line.option("com", &part.com.join(","));
        line.option("mass", &part.mass);
        line.option("units", &part.units);
        line.option("g", &part.g);
        line.flag("unphysical", !part.physical);
    } else {
        line.option("A", &given.moments.join(","));
        line.option("r", &given.center.join(","));
    }
    line.flag("certificate", true);
    line.flag("no-drawing", document.drawing.is_none());
    line.flag("json", true);
    line.0
}

struct Line(String);

impl Line {
    /// `--name value`, as a POSIX shell reads it: a hyphen at the front is joined by `=`, what is not plain is quoted. Told
    /// apart from documents/src/command.rs, which says the same, since this checks it.
    fn option(&mut self, name: &str, value: &str) {
        let joint = if value.starts_with('-') { "=" } else { " " };
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "+-./:=,_".contains(c);
        let value = if !value.is_empty() && value.chars().all(is_plain) {
            value.to_owned()
        } else {
            format!("'{}'", value.replace('\'', r"'\''"))
        };
        self.0.extend([" --", name, joint, &value]);
    }

    fn flag(&mut self, name: &str, is_set: bool) {
        if is_set {
            self.0.extend([" --", name]);
        }
    }
}
