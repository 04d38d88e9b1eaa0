//! How mathematics is printed.

use std::fmt::Display;

use super::text::text_width;

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
pub fn superscript(text: impl Display) -> String {
    digits(&text.to_string(), SUPERSCRIPTS)
}

/// The digits of a text as subscripts.
pub fn subscript(text: &str) -> String {
    digits(text, SUBSCRIPTS)
}

/// The sections of a signature as the paper prints them: `S2+T2` is S²+T², `M3` (genus 3) is M²₃.
#[must_use]
pub fn section_type(signature: &str) -> String {
    let section = |name: &str| match name.strip_prefix('M') {
        Some(genus) => format!("M²{}", subscript(genus)),
        None => superscript(name),
    };
    signature.split('+').map(section).collect::<Vec<_>>().join("+")
}

/// A number as its `Display` gives it, with a true minus sign.
pub fn number(x: impl Display) -> String {
    x.to_string().replace('-', "−")
}

/// A body by its principal moments and its centre of mass, in a line of at most `width` pixels at this font size: its
/// numbers rounded where that is needed, with ≈ then.
#[must_use]
pub fn body_line(moments: &[impl Display; 3], center: &[impl Display; 3], width: f64, size: f64) -> String {
    /// Significant digits, best first.
    const DIGITS: [usize; 6] = [6, 5, 4, 3, 2, 1];
    let triple = |name: &str, texts: [String; 3], digits: usize| {
        let sign = if texts.iter().all(|text| is_exact(text, digits)) { "=" } else { "≈" };
        format!("{name} {sign} ({})", texts.each_ref().map(|text| shortened(text, digits)).join(", "))
    };
    let rounded = |digits: usize| {
        let [moments, center] =
            [("A", moments.each_ref().map(ToString::to_string)), ("r", center.each_ref().map(ToString::to_string))]
                .map(|(name, texts)| triple(name, texts, digits));
        format!("{moments},  {center}")
    };
    let fits = |line: &String| text_width(line, size) <= width;
    DIGITS.into_iter().map(rounded).find(fits).unwrap_or_else(|| rounded(1))
}

/// A quantity with its value: its text if that is short, else rounded to this many significant digits and marked with
/// ≈.
#[must_use]
pub fn value_text(name: &str, text: &str, digits: usize) -> String {
    format!("{name} {} {}", if is_exact(text, digits) { "=" } else { "≈" }, shortened(text, digits))
}

/// True where that many digits are all that a number has.
fn is_exact(text: &str, digits: usize) -> bool {
    let written = || {
        if let Some((p, q)) = text.trim_start_matches('-').split_once('/') {
            return decimal_digits(p.parse().ok()?, q.parse().ok()?);
        }
        let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
        Some(mantissa.replace(['-', '+', '.'], ""))
    };
    let has_no_more = |written: String| written.trim_matches('0').len() <= digits;
    shortened(text, digits) == number(text) || written().is_some_and(has_no_more)
}

/// The decimal digits of p/q; none where it has infinitely many, or too many for these integers.
fn decimal_digits(p: u128, q: u128) -> Option<String> {
    let mut scaled = Some(p);
    while let Some(p) = scaled.filter(|_| q > 0) {
        if p % q == 0 {
            return Some((p / q).to_string());
        }
        scaled = p.checked_mul(10);
    }
    None
}

/// The text of a number if it is short, else rounded to this many significant digits.
fn shortened(text: &str, digits: usize) -> String {
    if text.chars().count() <= digits + 2 {
        return number(text);
    }
    let value = |text: &str| text.trim().parse::<f64>().ok();
    let quotient = || text.split_once('/').and_then(|(p, q)| Some(value(p)? / value(q)?));
    value(text).or_else(quotient).map_or_else(|| number(text), |value| short_number(value, digits))
}

/// A time in a table.
#[must_use]
pub fn short_time(value: f64) -> String {
    if value.is_finite() { short_number(value, 4) } else { "∞".to_owned() }
}

/// A number with at most this many significant digits.
#[must_use]
pub fn short_number(value: f64, digits: usize) -> String {
    // Rust prints exponents of ten beyond these as many zeros.
    const PLAIN: std::ops::Range<i32> = -4..6;
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match exponent.parse::<i32>() {
        Ok(e) if PLAIN.contains(&e) || value == 0.0 => number(text.parse::<f64>().unwrap_or(value)),
        Ok(e) => {
            let mantissa: f64 = mantissa.parse().unwrap_or(value);
            format!("{}·10{}", number(mantissa), superscript(e))
        }
        Err(_) => number(value),
    }
}

/// A positive number with two significant digits.
#[must_use]
pub fn short(value: f64) -> String {
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
    fn sections_are_printed_as_in_the_paper() {
        assert_eq!(section_type("T2+T2"), "T²+T²");
        assert_eq!(section_type("M3"), "M²₃");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(value_text("h", "-0.2600090312791064", 6), "h ≈ −0.260009");
        assert_eq!([value_text("l", "3.25", 6), value_text("l", "-1/3", 6)], ["l = 3.25", "l = −1/3"]);
        assert_eq!(superscript(-12), "⁻¹²");
        assert_eq!([1.0 / 3.0, 2e-9, 0.0, -1234.567].map(|x| short_number(x, 4)), ["0.3333", "2·10⁻⁹", "0", "−1235"]);
        assert_eq!([2.34, 142.4, 4.7e5].map(short), ["2.3", "142", "4.7·10⁵"]);
    }
}
