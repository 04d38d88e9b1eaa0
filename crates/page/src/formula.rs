//! Which parts of a text are mathematics. Texts are plain: `M²₃ at h = 2`; what is drawn, measured or written for TeX finds
//! symbols in them here.

/// Latin letters that are symbols on their own. Others, such as the A of a sentence, need an index or a value.
const ALONE: &str = "DEOPSTUhklnrxyz";
const SYMBOLS: &str = "ADEJMOPSTUehjklnrtxyzαγηθλμπφψωϑΔ∂Ṡ";
/// Raised and lowered characters, and marks.
const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺";
const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉ⱼₖ";
const MARKS: &str = "′\u{302}";

/// A part of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    pub text: String,
    /// Symbols with their exponents and indices.
    pub is_formula: bool,
}

/// The letters that connect a mark with its description: a, b, … without those of quantities such as h, then aa, ab, …
#[must_use]
pub fn letter(index: usize) -> String {
    const LETTERS: &[u8] = b"abcdefgijmopqsuvw";
    let own = char::from(LETTERS[index % LETTERS.len()]);
    match index / LETTERS.len() {
        0 => own.to_string(),
        round => format!("{}{own}", letter(round - 1)),
    }
}

/// True for an exponent's character.
pub fn is_raised(c: char) -> bool {
    RAISED.contains(c)
}

/// True for an index's character.
pub fn is_lowered(c: char) -> bool {
    LOWERED.contains(c)
}

/// Where an exponent ends above which an index begins: one is above the other.
pub fn stacked(formula: &str) -> Option<[&str; 3]> {
    let raised = formula.find(is_raised)?;
    let lowered = raised + formula[raised..].find(|c| !is_raised(c))?;
    let is_stack = formula[lowered..].starts_with(is_lowered);
    is_stack.then(|| [&formula[..raised], &formula[raised..lowered], &formula[lowered..]])
}

/// The parts of a text, formulas and what is between them.
pub fn parts(text: &str) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut add = |text: String, is_formula: bool| match parts.last_mut() {
        // Each symbol with scripts is a part of its own, so that there is one stack in each at most.
        Some(last) if !(last.is_formula || is_formula) => last.text.push_str(&text),
        _ => parts.push(Part { text, is_formula }),
    };
    let characters: Vec<char> = text.chars().collect();
    let mut at = 0;
    while at < characters.len() {
        let end = word_end(&characters, at);
        let own: String = characters[at..end.max(at + 1)].iter().collect();
        if let Some((formula, end)) = symbols(&characters, at, end) {
            add(formula, true);
            at = end;
        } else {
            at += own.chars().count();
            add(own, false);
        }
    }
    parts
}

fn is_script(c: char) -> bool {
    is_raised(c) || is_lowered(c) || MARKS.contains(c)
}

fn is_letter(c: char) -> bool {
    (c.is_alphabetic() || c == '∂') && !is_script(c)
}

/// The end of the letters that begin at `at`.
fn word_end(characters: &[char], at: usize) -> usize {
    at + characters[at..].iter().take_while(|c| is_letter(**c)).count()
}

/// The formula that a word is, with its scripts, and where it ends.
fn symbols(characters: &[char], at: usize, end: usize) -> Option<(String, usize)> {
    let word = &characters[at..end];
    let before = at.checked_sub(1).map(|before| characters[before]);
    // Not the t of don't, the l of --l, what follows an exponent's digits, or a file's ending.
    if word.is_empty() || before.is_some_and(|c| "'’-._".contains(c)) || !word.iter().all(|c| SYMBOLS.contains(*c)) {
        return None;
    }
    let scripts = end + characters[end..].iter().take_while(|c| is_script(**c)).count();
    let rest: String = characters[scripts..].iter().take(2).collect();
    let mut formula: String = characters[at..scripts].iter().collect();
    let is_greek = word.iter().any(|c| !c.is_ascii());
    // A2 and r3 of a body are symbols with an index, as R2 and S2.1 are no symbols.
    if let ([letter @ ('A' | 'r')], [digit @ '1'..='3', after @ ..]) = (word, &characters[scripts..])
        && scripts == end
        && !after.first().is_some_and(|c| c.is_alphanumeric() || *c == '.')
    {
        let index = ['₁', '₂', '₃'][*digit as usize - '1' as usize];
        return Some((format!("{letter}{index}"), scripts + 1));
    }
    let next = rest.chars().next();
    let goes_on = next.is_some_and(|c| c.is_ascii_digit() || c == '_')
        || (scripts == end && next.is_some_and(|c| "+-−'".contains(c)))
        || (next == Some('.') && rest.chars().nth(1).is_some_and(char::is_alphanumeric));
    let is_symbol = match word {
        _ if goes_on => false,
        _ if scripts > end || is_greek => true,
        ['A'] => [" =", " ≈"].contains(&rest.as_str()),
        [letter] => ALONE.contains(*letter),
        _ => false,
    };
    is_symbol.then(|| (std::mem::take(&mut formula), scripts))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formulas(text: &str) -> Vec<String> {
        parts(text).into_iter().filter(|part| part.is_formula).map(|part| part.text).collect()
    }

    #[test]
    fn symbols_are_found_in_texts() {
        assert_eq!(formulas("R4: M²₃, U = S²∖2D²"), ["M²₃", "U", "S²", "D²"]);
        assert_eq!(formulas("A = (2, 1.1, 1),  r = (1, 0, r3)"), ["A", "r", "r₃"]);
        assert_eq!(formulas("(h − 3.147)·10⁵ at l = ⟨γ, Aω⟩, 2π"), ["h", "l", "γ", "Aω", "π"]);
        assert_eq!(formulas("pole +r̂ enters U, Ṡ < 0, A2/A1, e₁, ψ′"), ["r̂", "U", "Ṡ", "A₂", "A₁", "e₁", "ψ′"]);
        assert_eq!(formulas("#3(S¹×S²), T²+T²"), ["S¹", "S²", "T²", "T²"]);
    }

    #[test]
    fn names_and_words_are_no_symbols() {
        for text in ["S2.1, R2, L+, P−, P+", "A: tensor", "Katok's, don't, --l, x.json", "G0.1 in kg·m²/s²", "10⁻⁶"]
        {
            assert_eq!(formulas(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn the_font_has_every_symbol() {
        use crate::text::{FORMULAS, register, width_in};
        register().unwrap();
        let width = |c: char| width_in(FORMULAS, &c.to_string(), 10.0);
        let missing = width('!');
        for c in SYMBOLS.chars().chain(RAISED.chars()).chain(LOWERED.chars()).chain(MARKS.chars()) {
            assert!((width(c) - missing).abs() > 0.01, "{c}");
        }
    }

    #[test]
    fn an_index_stands_below_an_exponent() {
        assert_eq!(stacked("M²₃"), Some(["M", "²", "₃"]));
        assert_eq!([stacked("S²"), stacked("A₃"), stacked("ψ′")], [None; 3]);
    }
}
