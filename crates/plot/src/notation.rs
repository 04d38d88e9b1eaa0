//! How mathematics is printed.

use std::fmt::Display;

use schema::RegionDocument;

/// The energy.
pub(super) const H: &str = "h";
/// The vertical angular momentum.
pub(super) const L: &str = "l";

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

/// An integer as a superscript.
pub(super) fn superscript(exponent: i32) -> String {
    digits(&exponent.to_string(), SUPERSCRIPTS)
}

/// A section's name as the paper prints it: `S2` is S², `T2` is T², `M3` (genus 3) is M²₃.
fn section(name: &str) -> String {
    match name.strip_prefix('M') {
        Some(genus) => format!("M²{}", digits(genus, SUBSCRIPTS)),
        None => digits(name, SUPERSCRIPTS),
    }
}

/// A component of the accessible region: `D2` is D², `S2-3D2` is S²∖3D².
fn accessible_region(name: &str) -> String {
    match name.split_once('-') {
        Some((sphere, discs)) => {
            let count = discs.trim_end_matches("D2");
            format!("{}∖{count}D²", digits(sphere, SUPERSCRIPTS))
        }
        None => digits(name, SUPERSCRIPTS),
    }
}

/// The accessible region of a region of the diagram.
pub(super) fn accessible_regions(region: &RegionDocument) -> String {
    let parts: Vec<String> =
        region.components.iter().map(|component| accessible_region(&component.accessible_region)).collect();
    parts.join("+")
}

/// The type printed in a region: that of its section, or of its accessible region where no section exists.
pub(super) fn region_type(region: &RegionDocument) -> String {
    if let Some(signature) = &region.signature {
        return signature.split('+').map(section).collect::<Vec<_>>().join("+");
    }
    if region.components.is_empty() {
        return "undecided".to_owned();
    }
    format!("U: {}", accessible_regions(region))
}

/// A number as its `Display` gives it, with a true minus sign.
pub(super) fn number(x: impl Display) -> String {
    x.to_string().replace('-', "−")
}

/// A body by its principal moments and its centre of mass.
pub(super) fn body(moments: &[impl Display; 3], center: &[impl Display; 3]) -> String {
    let [a1, a2, a3] = moments.each_ref().map(number);
    let [r1, r2, r3] = center.each_ref().map(number);
    format!("A = ({a1}, {a2}, {a3}),  r = ({r1}, {r2}, {r3})")
}

/// A positive number with two significant digits.
pub(super) fn short(value: f64) -> String {
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
    fn names_are_printed_as_in_the_paper() {
        assert_eq!(section("T2"), "T²");
        assert_eq!(section("M3"), "M²₃");
        assert_eq!(accessible_region("S2-3D2"), "S²∖3D²");
        assert_eq!(superscript(-12), "⁻¹²");
        assert_eq!([2.34, 142.4, 4.7e5].map(short), ["2.3", "142", "4.7·10⁵"]);
    }
}
