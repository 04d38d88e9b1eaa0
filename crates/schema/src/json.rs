//! Documents as JSON text on one line. Zero has no sign: which one it has in `f64` is an accident of the rounding before it.

use std::io;

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

/// The compact form, without negative zeros.
struct Unsigned;

impl Formatter for Unsigned {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        serde_json::ser::CompactFormatter.write_f64(writer, value + 0.0)
    }
}

/// Writes a document.
///
/// # Errors
/// When it cannot be written as JSON, and those of the writer.
pub fn write_json(out: impl io::Write, document: &impl Serialize) -> Result<(), serde_json::Error> {
    document.serialize(&mut Serializer::with_formatter(out, Unsigned))
}

/// The text of a document.
///
/// # Errors
/// When it cannot be written as JSON.
pub fn json(document: &impl Serialize) -> Result<String, serde_json::Error> {
    let mut out = Vec::new();
    write_json(&mut out, document)?;
    String::from_utf8(out).map_err(serde::ser::Error::custom)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        let document = serde_json::json!({"a": [-0.0, 0.0, -1e-300, -1.5], "b": null, "c": "-0.0", "n": 3});
        assert_eq!(json(&document).unwrap(), r#"{"a":[0.0,0.0,-1e-300,-1.5],"b":null,"c":"-0.0","n":3}"#);
        let raw = serde_json::value::to_raw_value(&[0.5]).unwrap();
        assert_eq!(json(&raw).unwrap(), "[0.5]");
    }
}
