//! Reading documents: those of this version are read, older ones refused with the command that remakes them.

use bifdiag_numbers::Number;
use bifdiag_schema::{
    AtlasDocument, CommandLine, DesignDocument, PointProofDocument, SCHEMA_VERSION, ScanSummaryDocument,
    WindowDocument, is_plain, one_line, quoted, shown,
};
use serde::Deserialize;
use thiserror::Error;

/// Why a text is no document of this version.
#[derive(Debug, Error)]
pub enum ReadError {
    /// It is one of another version.
    #[error("it is a document of version {version}, not {SCHEMA_VERSION}; make it anew with\n  {command}")]
    Superseded {
        /// Its version.
        version: String,
        /// The command that remakes the file.
        command: String,
    },
    /// It is not a document at all.
    #[error(transparent)]
    Malformed(#[from] serde_json::Error),
}

/// The version, which every document says.
#[derive(Deserialize)]
struct Stamp {
    schema_version: String,
}

/// What made an atlas of version 2.
#[derive(Deserialize)]
struct SecondAtlas {
    command: String,
}

/// What made an atlas of version 1.
#[derive(Deserialize)]
struct OldAtlas {
    #[serde(default)]
    accuracy: String,
    body: OldBody,
    window: Option<WindowDocument>,
}

#[derive(Deserialize)]
struct OldBody {
    #[serde(rename = "A")]
    moments: [String; 3],
    #[serde(rename = "r")]
    center: [String; 3],
    inertia: Option<OldPart>,
}

#[derive(Deserialize)]
struct OldPart {
    tensor: [String; 6],
    com: [String; 3],
    mass: String,
    g: String,
}

/// What made a scan of version 1.
#[derive(Deserialize)]
struct OldScan {
    design: DesignDocument,
    range: [u64; 2],
}

/// What can be verified.
#[derive(Debug)]
pub enum Claim {
    /// An atlas.
    Atlas(Box<AtlasDocument>),
    /// A point, with the atlas in which it lies.
    Point(Box<PointProofDocument>),
}

/// The key that the proof of a point has, and an atlas has not.
#[derive(Deserialize)]
struct Inner {
    atlas: Option<serde::de::IgnoredAny>,
}

/// Reads an atlas or the proof of a point; `file` is its name, for the command.
///
/// # Errors
/// [`ReadError`].
pub fn claim(text: &str, file: &str) -> Result<Claim, ReadError> {
    match serde_json::from_str(text) {
        Ok(Inner { atlas: Some(_) }) if superseded(text)?.is_none() => Ok(Claim::Point(serde_json::from_str(text)?)),
        Ok(Inner { .. }) | Err(_) => atlas(text, file).map(|atlas| Claim::Atlas(Box::new(atlas))),
    }
}

/// Reads an atlas; `file` is its name, for the command.
///
/// # Errors
/// [`ReadError`].
pub fn atlas(text: &str, file: &str) -> Result<AtlasDocument, ReadError> {
    match superseded(text)? {
        None => Ok(serde_json::from_str(text)?),
        Some(version) => {
            let command = if version == "1" {
                atlas_command(&serde_json::from_str(text)?)
            } else {
                let SecondAtlas { command } = serde_json::from_str(text)?;
                command.replace("--no-polygons", "--no-drawing")
            };
            let command = own(command) + &redirection(file);
            Err(ReadError::Superseded { version: shown(&version), command: one_line(&command) })
        }
    }
}

/// Reads the summary of a scan; `rows` is the name of the file with its rows, for the command.
///
/// # Errors
/// [`ReadError`].
pub fn scan_summary(text: &str, rows: &str) -> Result<ScanSummaryDocument, ReadError> {
    match superseded(text)? {
        None => Ok(serde_json::from_str(text)?),
        Some(version) => {
            let old: OldScan = serde_json::from_str(text)?;
            Err(ReadError::Superseded { version: shown(&version), command: one_line(&scan_command(&old, rows)) })
        }
    }
}

/// The version of a document of another version.
fn superseded(text: &str) -> Result<Option<String>, serde_json::Error> {
    let Stamp { schema_version } = serde_json::from_str(text)?;
    Ok((schema_version != SCHEMA_VERSION).then_some(schema_version))
}

/// The document goes to a file.
fn redirection(file: &str) -> String {
    if file == "-" { String::new() } else { format!(" > {}", quoted(file)) }
}

/// A command that a file names, if it is one of this program and a shell takes it for nothing more.
fn own(command: String) -> String {
    if makes_an_atlas(&command) { command } else { "bifdiag atlas".to_owned() }
}

/// Whether a command of a file makes an atlas, and a shell takes it for nothing more.
#[must_use]
pub fn makes_an_atlas(command: &str) -> bool {
    command.starts_with("bifdiag atlas ") && command.bytes().all(|c| c == b' ' || is_plain(c))
}

fn atlas_command(OldAtlas { accuracy, body, window }: &OldAtlas) -> String {
    let line = CommandLine::new("atlas");
    let line = match &body.inertia {
        None => line.option("A", body.moments.join(",")).option("r", body.center.join(",")),
        Some(OldPart { tensor, com, mass, g }) => {
            let is_nought = |text: &String| text.parse::<Number>().is_ok_and(|number| number.value().is_zero());
            let products = (!tensor[3..].iter().all(is_nought)).then_some("tensor");
            let line = line.option("inertia", tensor.join(",")).option_if("products", products);
            line.option("com", com.join(",")).option("mass", mass).option("g", g)
        }
    };
    let window = window
        .map(|WindowDocument { h: [h_min, h_max], l: [l_min, l_max] }| format!("{h_min}:{h_max},{l_min}:{l_max}"));
    line.option_if("window", window).flag("certificate", accuracy == "certified").json()
}

fn scan_command(OldScan { design, range }: &OldScan, rows: &str) -> String {
    crate::scan::command(design, *range).option("out", rows).text()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_atlas_of_version_1_names_the_command_that_makes_it_anew() {
        let old = r#"{"schema_version": "1", "accuracy": "certified", "body": {"A": ["2", "11/10", "1"],
            "r": ["-1", "0", "0"]}, "window": null, "curves": []}"#;
        let error = atlas(old, "my atlas.json").unwrap_err();
        let ReadError::Superseded { version, command } = error else { panic!("{error}") };
        assert_eq!(version, "1");
        assert_eq!(command, "bifdiag atlas --A 2,11/10,1 --r=-1,0,0 --certificate --json > 'my atlas.json'");
    }

    #[test]
    fn an_atlas_of_version_2_names_its_own_command() {
        let old = r#"{"schema_version": "2", "command": "bifdiag atlas --A 2,1.1,1 --r 1,0,0 --no-polygons --json"}"#;
        let error = atlas(old, "old.json").unwrap_err();
        let ReadError::Superseded { version, command } = error else { panic!("{error}") };
        assert_eq!(version, "2");
        assert_eq!(command, "bifdiag atlas --A 2,1.1,1 --r 1,0,0 --no-drawing --json > old.json");
    }

    #[test]
    fn no_other_command_of_a_file_is_named() {
        for command in ["rm -rf ~", "bifdiag atlas --body paper; rm -rf x", r"bifdiag atlas --body paper\n"] {
            let old = format!(r#"{{"schema_version": "4", "command": "{command}"}}"#);
            let ReadError::Superseded { command, .. } = atlas(&old, "-").unwrap_err() else { panic!() };
            assert_eq!(command, "bifdiag atlas");
        }
    }

    #[test]
    fn an_atlas_of_a_part_is_made_anew_from_its_tensor() {
        let old = r#"{"schema_version": "1", "accuracy": "draft", "body": {"A": ["2", "1", "1"], "r": ["1", "0", "0"],
            "inertia": {"tensor": ["3", "2", "1", "0.1", "0", "0.0"], "com": ["0", "-1", "0"], "mass": "2", "g": "9.8"}},
            "window": {"h": [0.0, 4.0], "l": [0.5, 3.0]}}"#;
        let ReadError::Superseded { command, .. } = atlas(old, "-").unwrap_err() else { panic!() };
        assert_eq!(
            command,
            "bifdiag atlas --inertia 3,2,1,0.1,0,0.0 --products tensor --com 0,-1,0 --mass 2 --g 9.8 \
             --window 0:4,0.5:3 --json"
        );
    }

    #[test]
    fn a_shard_of_version_1_names_the_command_that_makes_it_anew() {
        let old = r#"{"schema_version": "1", "accuracy": "standard", "range": [3, 6], "design": {"bodies":
            {"family": "body", "A": ["2", "1", "1"], "r": ["1", "0", "0"]}, "samples": 10, "seed": 5,
            "vary": [{"parameter": "r2", "from": "-1", "to": "1"}]}}"#;
        let ReadError::Superseded { command, .. } = scan_summary(old, "part.csv").unwrap_err() else { panic!() };
        assert_eq!(
            command,
            "bifdiag scan --A 2,1,1 --r 1,0,0 --vary r2=-1:1 --samples 10 --seed 5 --shard 2/3 --out part.csv"
        );
    }

    #[test]
    fn what_is_no_document_is_malformed() {
        assert!(matches!(atlas("{}", "-"), Err(ReadError::Malformed(_))));
        assert!(matches!(scan_summary("[", "-"), Err(ReadError::Malformed(_))));
    }
}
