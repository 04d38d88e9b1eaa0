//! The schematic figures of the paper.

use crate::figure::{Figure, THEME};
use crate::schematic::{Scheme, draw_scheme};

/// Name of the file and what is drawn.
const SCHEMES: [(&str, Scheme); 3] = [
    ("scheme-sheets", Scheme::Sheets),
    ("scheme-both-sheets-needed", Scheme::BothSheetsNeeded),
    ("scheme-cylinder", Scheme::Cylinder),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    SCHEMES.into_iter().map(|(stem, scheme)| Figure { stem, draw: Box::new(move || Ok(draw_scheme(scheme, THEME)?)) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reading::picture_texts::{assert_texts_are_apart, texts};

    #[test]
    fn schemes_can_be_read() {
        for (scheme, wanted) in [
            (Scheme::Sheets, "sheets by the sign of Δ: 1:1"),
            (Scheme::BothSheetsNeeded, "outgoing, Ṡ > 0"),
            (Scheme::Cylinder, "ϑ′ = π"),
        ] {
            let picture = draw_scheme(scheme, THEME).unwrap();
            let texts = texts(&picture);
            assert!(texts.iter().any(|(text, _)| text.contains(wanted)), "{wanted}");
            assert_texts_are_apart(&texts);
        }
    }
}
