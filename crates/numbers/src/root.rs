//! One root of a function inside a bracket: in doubles, with and without a derivative, and enclosed.

use super::Sign;
use super::enclosure::Enclosure;

/// A bracket in which a function changes sign, for a function with derivative.
#[derive(Clone, Copy, Debug)]
pub struct Bracket {
    /// End where the function is negative (or its limit is).
    pub negative: f64,
    /// End where the function is positive (or its limit is).
    pub positive: f64,
}

/// Between two positive reals of very different size, halve the logarithm, not the length. An end may be 0 or ∞.
fn middle(a: f64, b: f64) -> f64 {
    const FAR: f64 = 4.0;
    let (small, large) = (a.min(b), a.max(b));
    if large.is_infinite() {
        return if small == 0.0 { 1.0 } else { small * 16.0 };
    }
    if small == 0.0 {
        return large / 16.0;
    }
    if large > FAR * small { small.sqrt() * large.sqrt() } else { 0.5 * (small + large) }
}

/// Newton's method safeguarded by bisection on a positive axis.
///
/// `f` returns value and derivative. Precondition: both bracket ends are ≥ 0 (0 and ∞ are allowed and never
/// evaluated) and `f` is monotone between them. The search stops when |f| ≤ `tolerance` or the bracket has shrunk to
/// neighbouring doubles, so that it always ends.
pub fn newton_bracketed(bracket: Bracket, guess: f64, tolerance: f64, mut f: impl FnMut(f64) -> (f64, f64)) -> f64 {
    const MAX_EVALUATIONS: u32 = 200;
    let Bracket { mut negative, mut positive } = bracket;
    let inside = |y: f64, a: f64, b: f64| y > a.min(b) && y < a.max(b);
    let mut y = if inside(guess, negative, positive) { guess } else { middle(negative, positive) };
    let mut evaluations = 0;
    let mut previous = f64::INFINITY;
    loop {
        let (value, slope) = f(y);
        evaluations += 1;
        if value.abs() <= tolerance || evaluations >= MAX_EVALUATIONS {
            return y;
        }
        if value < 0.0 {
            negative = y;
        } else {
            positive = y;
        }
        let newton = y - value / slope;
        // Newton must at least halve the residual, else bisect.
        let contracts = value.abs() <= 0.5 * previous;
        let next = if contracts && inside(newton, negative, positive) { newton } else { middle(negative, positive) };
        previous = if contracts { value.abs() } else { f64::INFINITY };
        if next == y || !inside(next, negative, positive) {
            return y;
        }
        y = next;
    }
}

/// The first of start, 2 start, 4 start, … that reaches `goal`; `start` is a normal double > 0.
fn doubled_to(start: f64, goal: f64) -> f64 {
    const EXPONENT: u64 = f64::INFINITY.to_bits();
    if start < goal {
        // The significand of `start` with the exponent of `goal`.
        let beside = f64::from_bits(goal.min(f64::MAX).to_bits() & EXPONENT | start.to_bits() & !EXPONENT);
        if beside < goal { 2.0 * beside } else { beside }
    } else {
        start
    }
}

/// Bracketing search without derivatives: the ITP method of Oliveira and Takahashi
/// (ACM Trans. Math. Softw. 47, 2021), never slower than bisection by more than one step.
///
/// Precondition: `f(a)` and `f(b)` have opposite signs, given as `fa` and `fb`. Returns the point with the smaller
/// residual when the bracket has shrunk to `tolerance` (or to neighbouring doubles).
pub fn itp(a: f64, b: f64, fa: f64, fb: f64, tolerance: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    const MAX_EVALUATIONS: u32 = 200;
    let (mut a, mut b, mut fa, mut fb) = if a < b { (a, b, fa, fb) } else { (b, a, fb, fa) };
    let width = b - a;
    let half = 0.5 * width;
    let k1 = 0.2 / width;
    // tolerance · 2^n with n the bisection count; one extra step is granted.
    let mut budget = 2.0 * doubled_to(tolerance.max(f64::MIN_POSITIVE), half);
    let mut evaluations = 0;
    while b - a > 2.0 * tolerance && evaluations < MAX_EVALUATIONS {
        let mid = 0.5 * (a + b);
        if mid <= a || mid >= b {
            break;
        }
        let false_position = (fb * a - fa * b) / (fb - fa);
        let towards = if mid >= false_position { 1.0 } else { -1.0 };
        let delta = k1 * (b - a) * (b - a);
        let truncated = if delta <= (mid - false_position).abs() { false_position + towards * delta } else { mid };
        let slack = (budget - 0.5 * (b - a)).max(0.0);
        let candidate = if (truncated - mid).abs() <= slack { truncated } else { mid - towards * slack };
        let y = if candidate > a && candidate < b { candidate } else { mid };
        let value = f(y);
        evaluations += 1;
        if value == 0.0 {
            return y;
        }
        if (value > 0.0) == (fb > 0.0) {
            (b, fb) = (y, value);
        } else {
            (a, fa) = (y, value);
        }
        budget *= 0.5;
    }
    if fa.abs() < fb.abs() { a } else { b }
}

/// The one root of a function in a range, as narrow as the arithmetic makes it, by Newton's method for intervals: a root of f
/// in X lies in m − f(m)/f′(X) for every m in X. Where that does not halve X, the sign in the middle does. Precondition: f has the
/// sign `above` at the upper end, and the other one at the lower.
#[must_use]
pub(crate) fn narrowed<E: Enclosure>(
    mut range: E,
    above: Sign,
    value: impl Fn(&E) -> E,
    slope: impl Fn(&E) -> E,
    precision: E::Precision,
) -> E {
    const STEPS: usize = 1000;
    let width = |range: &E| range.upper() - range.lower();
    for _ in 0..STEPS {
        let middle = range.middle();
        let residual = value(&middle);
        let newton = middle.clone() - residual.clone() / slope(&range);
        let Some(found) = newton.meet(&range) else { return E::line(precision) };
        let next = if (width(&found) * E::small(2, precision)).is_below(&width(&range)) {
            found
        } else {
            // The middle may all but be the root, and its sign not known.
            let beside = (range.lower() + width(&range) * E::double(0.375, precision)).middle();
            let sure = |at: E, value: &E| value.sign().map(|sign| (sign, at));
            match sure(middle, &residual).or_else(|| sure(beside.clone(), &value(&beside))) {
                Some((Sign::Zero, at)) => return at,
                Some((sign, at)) if sign == above => range.lower().hull(&at),
                Some((_, at)) => at.hull(&range.upper()),
                None => return found,
            }
        };
        if !width(&next).is_below(&width(&range)) {
            return next;
        }
        range = next;
    }
    range
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn planted_roots_are_found(root in 1e-9..1e9f64) {
            let found = newton_bracketed(
                Bracket { negative: f64::INFINITY, positive: 0.0 }, 1.0, 0.0, |y| (1.0 - y / root, -1.0 / root));
            prop_assert!((found / root - 1.0).abs() < 4e-16, "{found:?}");
        }

        #[test]
        fn planted_simple_roots_of_cubics_are_found(root in -0.9..0.9f64, scale in 0.1..10.0f64) {
            let f = |y: f64| (y - root) * (y * y + scale);
            let mut evaluations = 0;
            let found = itp(-1.0, 1.0, f(-1.0), f(1.0), 0.0, |y| {
                evaluations += 1;
                f(y)
            });
            prop_assert!((found - root).abs() < 1e-15);
            prop_assert!(evaluations < 70);
        }
    }

    proptest! {
        #[test]
        fn doubling_is_found_at_once(start in f64::MIN_POSITIVE..1e9, goal in prop_oneof![0.0..1e-300, 0.0..1e12, 0.0..f64::MAX]) {
            let mut expected = start;
            while expected < goal {
                expected *= 2.0;
            }
            prop_assert_eq!(doubled_to(start, goal), expected);
        }
    }

    #[test]
    fn doubling_ends_at_powers_of_two() {
        for (start, goal, expected) in [
            (f64::MIN_POSITIVE, 0.5, 0.5),
            (0.75, 0.75, 0.75),
            (0.75, 1.5, 1.5),
            (0.75, 1.6, 3.0),
            (f64::MIN_POSITIVE, f64::INFINITY, f64::INFINITY),
            (1.0, f64::MAX, f64::INFINITY),
        ] {
            assert_eq!(doubled_to(start, goal), expected);
        }
    }

    #[test]
    fn the_square_root_end_of_a_fold_is_reached() {
        let found = newton_bracketed(Bracket { negative: 1.0, positive: 2.0 }, 1.5, 0.0, |y| {
            ((y - 1.0) * (y - 1.0) - 1e-14, 2.0 * (y - 1.0))
        });
        assert!((found - 1.0 - 1e-7).abs() < 1e-14, "{found:?}");
    }
}
