//! Exact numbers as decimals.

use std::fmt::Display;

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// The exact decimal of a number whose denominator is a power of two; `p/q` for any other.
#[must_use]
pub fn exact(x: &RBig) -> String {
    let denominator = x.denominator();
    let power = denominator.trailing_zeros().unwrap_or(0);
    if *denominator != UBig::ONE << power {
        return x.to_string();
    }
    let digits = x.numerator() * IBig::from(5).pow(power);
    if power == 0 { digits.to_string() } else { format!("{digits}e-{power}") }
}

/// A decimal of `digits` digits or one fewer, not above the number (`up`: not below).
#[must_use]
pub fn rounded(x: &RBig, digits: usize, up: bool) -> String {
    if x.is_zero() {
        return "0".to_owned();
    }
    to_place(x, i64::try_from(digits).unwrap_or(0) - 1 - about_exponent(x), up)
}

/// A decimal of `digits` digits (one more where a negative number carries), not above the number. Its length does not depend
/// on that of numerator and denominator.
#[must_use]
pub fn of_length(x: &RBig, digits: usize) -> String {
    if x.is_zero() {
        return "0".to_owned();
    }
    let about = about_exponent(x);
    let exponent = if times_ten_to(&RBig::ONE, about) > x.clone().max(-x.clone()) { about - 1 } else { about };
    to_place(x, i64::try_from(digits).unwrap_or(0) - 1 - exponent, false)
}

/// e with 10^(e−1) < |x| < 10^(e+1), x ≠ 0.
fn about_exponent(x: &RBig) -> i64 {
    let size = |n: &UBig| i64::try_from(n.to_string().len()).unwrap_or(i64::MAX);
    size(&x.numerator().clone().into_parts().1) - size(x.denominator())
}

/// x 10^power.
fn times_ten_to(x: &RBig, power: i64) -> RBig {
    let ten = RBig::from(IBig::from(10).pow(usize::try_from(power.unsigned_abs()).unwrap_or(0)));
    if power >= 0 { x * ten } else { x / ten }
}

/// The decimal with `places` places after the point (negative: zeros before it), rounded down or up.
fn to_place(x: &RBig, places: i64, up: bool) -> String {
    let scaled = times_ten_to(x, places);
    let whole = if up { scaled.ceil() } else { scaled.floor() };
    if places == 0 { whole.to_string() } else { format!("{whole}e{}", -places) }
}

/// Decimals of both ends of an interval, rounded outward.
#[must_use]
pub fn outward([lo, hi]: &[RBig; 2], digits: usize) -> [String; 2] {
    [rounded(lo, digits, false), rounded(hi, digits, true)]
}

/// The exact decimal without exponent where it has at most 200 places, else `p/q`; where p or q would leave the range of a
/// [`crate::Number`], a quotient of decimals, the second one below 1.
#[must_use]
pub fn short(x: &RBig) -> String {
    const MAX_PLACES: usize = 200;
    const MAX_DIGITS: usize = 150;
    let mut rest = x.denominator().clone();
    let [twos, fives] = [2u8, 5].map(|prime| {
        let mut count = 0;
        while (&rest % prime) == 0 {
            rest /= prime;
            count += 1;
        }
        count
    });
    let places = twos.max(fives);
    if rest == UBig::ONE && places <= MAX_PLACES {
        return with_places(x, places);
    }
    let text = x.to_string();
    if text.trim_start_matches('-').split('/').all(|part| part.len() <= MAX_DIGITS) {
        return text;
    }
    let divisor = if rest == UBig::ONE { 0 } else { rest.to_string().len() };
    let scaled = RBig::from_parts(IBig::from(rest), UBig::from(10u8).pow(divisor));
    let decimal = with_places(&(x * &scaled), places + divisor);
    if divisor == 0 { decimal } else { format!("{decimal}/{}", with_places(&scaled, divisor)) }
}

/// A decimal that has at most so many places.
fn with_places(x: &RBig, places: usize) -> String {
    let shifted = x * RBig::from(IBig::from(10).pow(places));
    let digits = shifted.numerator().to_string();
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits.as_str()), |rest| ("-", rest));
    if places == 0 {
        return format!("{sign}{digits}");
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    format!("{sign}{whole}.{fraction}")
}

/// A number with `places` decimal places; one that rounds to zero has no sign.
#[must_use]
pub fn fixed(x: f64, places: usize) -> String {
    let text = format!("{x:.places$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        _ => text,
    }
}

/// A number with `digits` significant digits: plain between 1e-4 and 1e7, else with an exponent.
#[must_use]
pub fn significant(x: f64, digits: usize) -> String {
    if !x.is_finite() || x == 0.0 {
        return if x == 0.0 { "0".to_owned() } else { x.to_string() };
    }
    let scientific = format!("{:.*e}", digits.saturating_sub(1), x);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let places = i32::try_from(digits).unwrap_or(i32::MAX) - 1 - exponent;
    if (-4..=6).contains(&exponent) {
        let plain = format!("{:.*}", usize::try_from(places).unwrap_or_default(), x);
        return trim_zeros(&plain);
    }
    format!("{}e{exponent}", trim_zeros(mantissa))
}

/// The ends of a range with `digits` significant digits, or with as many more as needed to tell them apart.
#[must_use]
pub fn told_apart(ends: [f64; 2], digits: usize) -> [String; 2] {
    let written = |digits| ends.map(|x| significant(x, digits));
    (digits..=17).map(written).find(|[from, to]| from != to).unwrap_or_else(|| written(digits))
}

/// Numbers with `digits` significant digits, each with as many more as needed to tell it from all others that differ.
#[must_use]
pub fn all_apart(numbers: &[f64], digits: usize) -> Vec<String> {
    let written = |&x: &f64| {
        let from_others = numbers.iter().map(|&other| told_apart([x, other], digits)[0].clone());
        from_others.max_by_key(String::len).unwrap_or_else(|| significant(x, digits))
    };
    let mut texts: Vec<String> = numbers.iter().map(written).collect();
    // Two that differ with few digits may round to one text with more.
    for digits in digits..=17 {
        let places = 0..numbers.len();
        let is_alike = |&x: &usize| places.clone().any(|y| texts[x] == texts[y] && numbers[x] != numbers[y]);
        for place in places.clone().filter(is_alike).collect::<Vec<_>>() {
            texts[place] = significant(numbers[place], digits);
        }
    }
    texts
}

/// A number with the word for one of them or for several.
pub fn counted<N: Copy + Display + PartialEq + From<u8>>(number: N, one: &str, several: &str) -> String {
    let word = if number == N::from(1) { one } else { several };
    format!("{number} {word}")
}

/// Names as a list in a sentence, such as r1, r2 and r3.
#[must_use]
pub fn enumerated(names: &[String]) -> String {
    match names {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => names.concat(),
    }
}

/// A bound x ≥ 0 as [`significant`] writes it, but rounded up.
#[must_use]
pub fn bound(x: f64, digits: usize) -> String {
    on_side(x, digits, true)
}

/// A bound x ≥ 0 as [`significant`] writes it, but rounded down.
#[must_use]
pub fn bound_below(x: f64, digits: usize) -> String {
    on_side(x, digits, false)
}

/// A number x ≥ 0 as [`significant`] writes it, not below it (`up`), or not above it, as it is read back.
fn on_side(x: f64, digits: usize, up: bool) -> String {
    let nearest = significant(x, digits);
    let is_right = |text: &str| text.parse().is_ok_and(|read: f64| if up { read >= x } else { read <= x });
    if is_right(&nearest) {
        return nearest;
    }
    let scientific = format!("{x:e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let last_place = exponent.zip(i32::try_from(digits).ok()).and_then(|(exponent, digits)| {
        let place = exponent - digits + 1;
        // Plain numbers keep all digits before the point.
        let place = if (-4..=6).contains(&exponent) { place.min(0) } else { place };
        format!("1e{place}").parse::<f64>().ok()
    });
    let unit = last_place.unwrap_or(0.0);
    // With as many digits as a double has, a unit of the last one may be lost.
    let mut stepped = if up { x + unit } else { x - unit };
    for _ in 0..4 {
        let text = significant(stepped, digits);
        if is_right(&text) {
            return text;
        }
        stepped = if up { stepped.next_up() } else { stepped.next_down() };
    }
    // Where rounding carries from plain numbers to those with an exponent.
    if digits < 17 { on_side(x, digits + 1, up) } else { nearest }
}

fn trim_zeros(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Number;

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(significant(3.148_612, 5), "3.1486");
        assert_eq!(significant(-0.000_123_456, 3), "-0.000123");
        assert_eq!(significant(1.5e-9, 5), "1.5e-9");
        assert_eq!(significant(123_456.7, 3), "123457");
        assert_eq!(significant(1e8, 4), "1e8");
        assert_eq!(significant(9.9999, 3), "10");
        assert_eq!(significant(0.0, 5), "0");
        assert_eq!(significant(f64::INFINITY, 5), "inf");
    }

    #[test]
    fn exact_numbers_are_read_back_however_long() {
        let power = |base: u8, n: usize| RBig::from(UBig::from(base).pow(n));
        let long = power(3, 600) / power(7, 400);
        assert_eq!(short(&RBig::from_parts((-9).into(), 8u8.into())), "-1.125");
        assert_eq!(short(&RBig::from_parts(2.into(), 7u8.into())), "2/7");
        for x in [long.clone(), -long, power(3, 500) / power(2, 800), power(3, 500) / power(2, 790) / RBig::from(7)] {
            let number: Number = short(&x).parse().unwrap();
            assert_eq!(*number.value(), x);
        }
    }

    #[test]
    fn a_bound_is_rounded_up() {
        assert_eq!(bound(4.1e-15, 1), "5e-15");
        assert_eq!(bound(4e-15, 1), "4e-15");
        assert_eq!(bound(9.96e-7, 2), "1e-6");
        assert_eq!(bound(5.83e-15, 2), "5.9e-15");
        assert_eq!(bound(123.4, 2), "124");
        assert_eq!(bound(0.0, 2), "0");
        for x in std::iter::successors(Some(1e-40), |x| Some(x * 1.1)).take_while(|x| *x < 1e40) {
            for digits in 1..4 {
                assert!(bound(x, digits).parse::<f64>().unwrap() >= x, "{x:e}");
            }
            for digits in 1..18 {
                let [low, high] = [bound_below(x, digits), bound(x, digits)].map(|text| text.parse::<f64>().unwrap());
                let unit: f64 = format!("2.001e-{}", digits - 1).parse().unwrap();
                assert!(low <= x && x <= high && high - low <= unit.max(3e-15) * x, "{x:e} {digits}");
            }
        }
        assert_eq!(bound_below(0.0, 2), "0");
        assert_eq!(bound_below(9.8e-40, 1), "9e-40");
        assert_eq!(bound_below(2.999e10, 3), "2.99e10");
    }

    #[test]
    fn numbers_that_differ_have_other_digits() {
        assert_eq!(all_apart(&[1.0, 2.0, 2.000_01, 3.0], 3), ["1", "2", "2.00001", "3"]);
        assert_eq!(all_apart(&[2.0, 1.0, 2.000_01], 3), ["2", "1", "2.00001"]);
        assert_eq!(all_apart(&[0.5, 0.5], 3), ["0.5", "0.5"]);
        assert_eq!(all_apart(&[0.123_456], 3), ["0.123"]);
    }

    fn value(text: &str) -> RBig {
        text.parse::<Number>().unwrap().value().clone()
    }

    #[test]
    fn decimals_are_exact_or_on_the_right_side() {
        for x in [0.1, 1.0, 3.0, -0.75, 1e-20, 6.02e23] {
            let x = RBig::try_from(x).unwrap();
            assert_eq!(value(&exact(&x)), x);
            for digits in [5, 17, 30] {
                let (low, high) = (value(&rounded(&x, digits, false)), value(&rounded(&x, digits, true)));
                assert!(low <= x && x <= high && (&high - &low) * RBig::from(1000) <= x.clone().max(-x.clone()));
            }
        }
        assert_eq!(exact(&RBig::from_parts(1.into(), 3u8.into())), "1/3");
    }

    #[test]
    fn numbers_of_one_size_have_decimals_of_one_length() {
        for text in ["0.15725", "1/3", "2/3", "99/100", "101/100", "-7/9", "123456789/1000", "1/1024"] {
            let decimal = of_length(&value(text), 7);
            let digits = decimal.trim_start_matches('-').split('e').next().map(str::len);
            assert_eq!(digits, Some(7), "{text}: {decimal}");
            assert!(value(&decimal) <= value(text));
        }
    }

    #[test]
    fn short_decimals_have_no_exponent() {
        for text in ["0", "-3", "0.1", "-12.5", "0.0009765625", "1/3", "-22/7", "120"] {
            assert_eq!(short(&value(text)), text);
        }
        assert_eq!(short(&value("1e-119")).len(), 121);
        let least = value("1e-100") * value("1e-100");
        assert_eq!(short(&least).len(), 202);
        assert_eq!(short(&(least / RBig::from(7))).split('/').nth(1).map(str::len), Some("0.7".len()));
    }
}
