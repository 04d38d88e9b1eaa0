//! Writes what follows from the JSON Schemas of the documents: the records of Python, the types of the page, and the tables
//! of the pages about formats. A field is described once, by its comment in `crates/schema`.
//!
//! ```text
//! cargo run --release --example records
//! ```

mod model;
mod python;
mod tables;
mod typescript;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use model::Model;

/// Each file that holds generated text, with what it ought to hold.
fn files() -> Result<Vec<(PathBuf, String)>, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let model = Model::of_documents();
    let page = |name: &str, style: tables::Style| -> Result<(PathBuf, String), Box<dyn Error>> {
        let path = root.join(name);
        let text =
            tables::filled(&model, &fs::read_to_string(&path)?, style).map_err(|why| format!("{name}: {why}"))?;
        Ok((path, text))
    };
    Ok(vec![
        (root.join("python/package/bifdiag/records.py"), python::module(&model)),
        (root.join("web/src/bindings/schema.ts"), typescript::module(&model)),
        page("docs/formats.md", tables::MARKDOWN)?,
        page("python/docs/files.rst", tables::RST)?,
    ])
}

fn main() -> Result<(), Box<dyn Error>> {
    for (path, text) in files()? {
        if fs::read_to_string(&path).is_ok_and(|old| old == text) {
            continue;
        }
        fs::write(&path, text)?;
        println!("{}", path.display());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// docs/certified.md describes certificates; the answer of `body` is the shared fields and a part.
    const OWN_PAGE: [&str; 13] = [
        "Certificate",
        "CertificateUnits",
        "CertifiedCusp",
        "CertifiedEvent",
        "CertifiedHeight",
        "CertifiedMeeting",
        "CertifiedNode",
        "CertifiedPair",
        "CertifiedSample",
        "CertifiedSlab",
        "CertifiedStretch",
        "Place",
        "PartAnswer",
    ];

    #[test]
    fn the_committed_files_follow_from_the_schemas() {
        for (path, text) in files().unwrap() {
            let written = fs::read_to_string(&path).unwrap();
            assert!(written == text, "{}: run `cargo run --release --example records`", path.display());
        }
    }

    /// Every type of a document has its table in docs/formats.md, so that no field is left out.
    #[test]
    fn the_tables_are_complete() {
        let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/formats.md")).unwrap();
        let model = Model::of_documents();
        let missing: Vec<&str> = model
            .types
            .iter()
            .filter(|of| matches!(of.form, model::Form::Record(_)) && !OWN_PAGE.contains(&of.name.as_str()))
            .map(|of| of.name.as_str())
            .filter(|name| !page.contains(&format!("fields: {name} ")))
            .collect();
        assert!(missing.is_empty(), "without a table: {missing:?}");
    }
}
