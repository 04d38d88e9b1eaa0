//! Newton's method for intervals.

use super::Sign;
use super::enclosure::Enclosure;

/// The one root of a function in a range, as narrow as the arithmetic makes it, by Newton's method for intervals: a root of f
/// in X lies in m − f(m)/f′(X) for every m in X. Where that does not halve X, the sign in the middle does. Precondition: f has the
/// sign `above` at the upper end, and the other one at the lower.
#[must_use]
pub fn narrowed<E: Enclosure>(
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
