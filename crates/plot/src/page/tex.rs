//! The texts of pictures as LaTeX writes them.

/// A text for LaTeX: mathematics in dollars, and nothing that has a meaning of its own there.
pub(crate) fn tex(text: &str) -> String {
    let mut out = String::new();
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let raised = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺".chars().position(|other| other == c);
        let lowered = |c: char| "₀₁₂₃₄₅₆₇₈₉".chars().position(|other| other == c);
        let digit = |place: usize| b"0123456789-+".get(place).map_or(' ', |byte| char::from(*byte));
        if let Some(first) = raised(character) {
            // Lower than an exponent stands in a formula: in a picture as high as the capitals beside it.
            out.push_str("\\raisebox{.3em}{$\\scriptstyle ");
            out.push(digit(first));
            while let Some(next) = characters.peek().copied().and_then(raised) {
                out.push(digit(next));
                characters.next();
            }
            out.push_str("$}");
        } else if let Some(first) = lowered(character) {
            out.push_str("$_{");
            out.push(digit(first));
            while let Some(next) = characters.peek().copied().and_then(lowered) {
                out.push(digit(next));
                characters.next();
            }
            out.push_str("}$");
        } else if characters.peek() == Some(&'\u{302}') {
            characters.next();
            out.push_str("$\\hat{");
            out.push(character);
            out.push_str("}$");
        } else if let Some((_, command)) = SYMBOLS.iter().find(|(symbol, _)| *symbol == character) {
            out.extend(["$", command, "$"]);
        } else {
            match character {
                '\\' => out.push_str("\\textbackslash{}"),
                '~' => out.push_str("\\textasciitilde{}"),
                '^' => out.push_str("\\textasciicircum{}"),
                '#' | '$' | '%' | '&' | '_' | '{' | '}' => out.extend(['\\', character]),
                other => out.push(other),
            }
        }
    }
    // Neighbouring formulas are one.
    out.replace("$$", "")
}

/// What pictures hold beyond letters, and the commands for it.
const SYMBOLS: [(char, &str); 32] = [
    ('−', "-"),
    ('×', "\\times "),
    ('·', "\\cdot "),
    ('≈', "\\approx "),
    ('≤', "\\le "),
    ('≥', "\\ge "),
    ('<', "<"),
    ('>', ">"),
    ('|', "|"),
    ('∖', "\\setminus "),
    ('∂', "\\partial "),
    ('√', "\\surd "),
    ('′', "'"),
    ('⟨', "\\langle "),
    ('⟩', "\\rangle "),
    ('∞', "\\infty "),
    ('→', "\\to "),
    ('±', "\\pm "),
    ('¾', "\\frac34"),
    ('½', "\\frac12"),
    ('α', "\\alpha "),
    ('γ', "\\gamma "),
    ('Δ', "\\Delta "),
    ('η', "\\eta "),
    ('θ', "\\theta "),
    ('ϑ', "\\vartheta "),
    ('λ', "\\lambda "),
    ('μ', "\\mu "),
    ('π', "\\pi "),
    ('ψ', "\\psi "),
    ('ω', "\\omega "),
    ('Ṡ', "\\dot S"),
];

#[cfg(test)]
mod tests {
    use super::tex;

    #[test]
    fn texts_become_formulas() {
        assert_eq!(tex("M²₃"), "M\\raisebox{.3em}{$\\scriptstyle 2$}$_{3}$");
        assert_eq!(tex("S²∖2D"), "S\\raisebox{.3em}{$\\scriptstyle 2$}$\\setminus $2D");
        assert_eq!(tex("pole +r̂ enters U"), "pole +$\\hat{r}$ enters U");
        assert_eq!(tex("100 % of a_b"), "100 \\% of a\\_b");
        assert_eq!(tex("10⁻¹²"), "10\\raisebox{.3em}{$\\scriptstyle -12$}");
    }
}
