//! Texts of documents in messages.

/// Characters of a quoted text that are shown.
const SHOWN: usize = 80;

/// A text as a message may quote it: what could control a terminal is escaped, and a long text is cut.
#[must_use]
pub fn shown(text: &str) -> String {
    let cut: String = text.chars().take(SHOWN).collect();
    let rest = text.len() > cut.len();
    let more = if rest { format!("… ({} characters)", text.chars().count()) } else { String::new() };
    one_line(&cut) + &more
}

/// A text on one line, with every character escaped that could control a terminal or turn the order of what is read.
#[must_use]
pub fn one_line(text: &str) -> String {
    escaped(text, |_| false)
}

/// Likewise a message of several lines.
#[must_use]
pub fn harmless(message: &str) -> String {
    escaped(message, |c| matches!(c, '\n' | '\t'))
}

fn escaped(text: &str, is_kept: impl Fn(char) -> bool) -> String {
    let mut found = String::with_capacity(text.len());
    for c in text.chars() {
        if is_unsafe(c) && !is_kept(c) { found.extend(c.escape_unicode()) } else { found.push(c) }
    }
    found
}

/// Control characters, line and paragraph separators, and what sets the direction of writing.
fn is_unsafe(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_controls_a_terminal_is_escaped() {
        assert_eq!(shown("\x1b[32mverified\u{9b}1m\r\n"), r"\u{1b}[32mverified\u{9b}1m\u{d}\u{a}");
        assert_eq!(shown("a\u{202e}b\u{2066}c"), r"a\u{202e}b\u{2066}c");
        assert_eq!(harmless("γ = 1\n\tnext\x1b[0m"), "γ = 1\n\tnext\\u{1b}[0m");
    }

    #[test]
    fn long_texts_are_cut() {
        let long = "7".repeat(3_000_000);
        assert_eq!(shown(&long), format!("{}… (3000000 characters)", "7".repeat(80)));
        assert_eq!(shown("11/10"), "11/10");
    }
}
