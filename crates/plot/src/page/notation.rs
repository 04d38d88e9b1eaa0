//! How mathematics is printed.

use std::fmt::Display;

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
const SUBSCRIPTS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];

fn digits(text: &str, alphabet: [char; 10]) -> String {
    let print = |c: char| match (c, c.to_digit(10)) {
        (_, Some(digit)) => alphabet[digit as usize],
        ('-', _) => '⁻',
        (other, _) => other,
    };
    text.chars().map(print).collect()
}

/// A text with its digits and signs as superscripts.
pub(crate) fn superscript(text: impl Display) -> String {
    digits(&text.to_string(), SUPERSCRIPTS)
}

/// The digits of a text as subscripts.
pub(crate) fn subscript(text: &str) -> String {
    digits(text, SUBSCRIPTS)
}

/// A number as its `Display` gives it, with a true minus sign.
pub(crate) fn number(x: impl Display) -> String {
    x.to_string().replace('-', "−")
}

/// A body by its principal moments and its centre of mass.
pub(crate) fn body(moments: &[impl Display; 3], center: &[impl Display; 3]) -> String {
    let [a1, a2, a3] = moments.each_ref().map(number);
    let [r1, r2, r3] = center.each_ref().map(number);
    format!("A = ({a1}, {a2}, {a3}),  r = ({r1}, {r2}, {r3})")
}

/// A positive number with two significant digits.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.1e}");
    match text.split_once('e').map(|(digits, exponent)| (digits, exponent.parse::<i32>())) {
        Some((_, Ok(exponent))) if (-1..4).contains(&exponent) => {
            if value < 10.0 {
                format!("{value:.1}")
            } else {
                format!("{value:.0}")
            }
        }
        Some((digits, Ok(exponent))) => format!("{digits}·10{}", superscript(exponent)),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(superscript(-12), "⁻¹²");
        assert_eq!([2.34, 142.4, 4.7e5].map(short), ["2.3", "142", "4.7·10⁵"]);
    }
}
