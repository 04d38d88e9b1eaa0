//! Windows of insets that do not reach into each other.

use super::ranges::{area, contains, length};
use bifdiag_schema::WindowDocument;

/// Between two windows, as a share of the smaller one.
const BETWEEN: f64 = 0.03;

/// Free space between two windows, in h and l.
fn between(a: &WindowDocument, b: &WindowDocument) -> [f64; 2] {
    [[a.h, b.h], [a.l, b.l]].map(|sides| BETWEEN * length(sides[0]).min(length(sides[1])))
}

/// Whether two windows meet, though neither holds the other.
pub(super) fn reach_into(a: &WindowDocument, b: &WindowDocument) -> bool {
    let meet = |p: [f64; 2], q: [f64; 2]| p[0] < q[1] && q[0] < p[1];
    meet(a.h, b.h) && meet(a.l, b.l) && !contains(a, b) && !contains(b, a)
}

/// The parts of a window on each of the four sides of another, the largest first.
pub(super) fn beside(window: &WindowDocument, other: &WindowDocument) -> Vec<WindowDocument> {
    let own = *window;
    let [dh, dl] = between(window, other);
    let mut parts = vec![
        WindowDocument { h: [own.h[0], own.h[1].min(other.h[0] - dh)], l: own.l },
        WindowDocument { h: [own.h[0].max(other.h[1] + dh), own.h[1]], l: own.l },
        WindowDocument { h: own.h, l: [own.l[0], own.l[1].min(other.l[0] - dl)] },
        WindowDocument { h: own.h, l: [own.l[0].max(other.l[1] + dl), own.l[1]] },
    ];
    parts.retain(|part| length(part.h) > 0.0 && length(part.l) > 0.0);
    parts.sort_by(|a, b| area(b).total_cmp(&area(a)));
    parts
}

/// The largest part of a window that holds `target` and reaches into none of `others`; `None`: there is no such part.
pub(super) fn clear(
    window: WindowDocument,
    target: &WindowDocument,
    others: &[WindowDocument],
) -> Option<WindowDocument> {
    let Some(other) = others.iter().find(|other| reach_into(&window, other)) else { return Some(window) };
    let parts = beside(&window, other).into_iter().filter(|part| contains(part, target));
    parts.filter_map(|part| clear(part, target, others)).max_by(|a, b| area(a).total_cmp(&area(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_trimmed_until_they_are_apart() {
        let window = |h, l| WindowDocument { h, l };
        let (a, b) = (window([100.0, 200.0], [100.0, 200.0]), window([180.0, 300.0], [150.0, 400.0]));
        assert!(reach_into(&a, &b) && !reach_into(&a, &window([0.0, 500.0], [0.0, 500.0])));
        let target = window([250.0, 260.0], [210.0, 220.0]);
        let cleared = clear(b, &target, &[a]).unwrap();
        assert!(!reach_into(&a, &cleared) && contains(&cleared, &target) && contains(&b, &cleared));
        // Beside the other, which leaves 97 · 250, more than the 120 · 197 above it.
        assert_eq!((cleared.h, cleared.l), ([203.0, 300.0], b.l));
        assert!(clear(b, &window([185.0, 250.0], [160.0, 300.0]), &[a]).is_none());
    }
}
