//! Distance between the curve and a chord of it in the (h, l) plane.

use super::options::TrackOptions;

/// The curve at one end of a chord.
#[derive(Clone, Copy, Debug)]
pub(super) struct ChordEnd {
    pub l: f64,
    pub h: f64,
    /// dh/dl = Ω.
    pub slope: f64,
    /// d²h/dl² = dΩ/dl; infinite at a cusp.
    pub curvature: f64,
}

/// Largest distance between the curve and its chord, in the plane scaled by `options`, as estimated from both ends.
///
/// The cubic h(l) through both ends with their slopes leaves the chord by Δl (p t(1−t)² − q t²(1−t)), where p and q are
/// Ω minus the chord's slope. Next to a cusp, where h(l) goes with the power 3/2, this overstates the distance by
/// a quarter. Next to an inflection it understates it; there the quintic that has the right curvatures too is better. The
/// larger of both counts, the correction held to the size of p and q, because curvatures are unbounded at cusps.
pub(super) fn chord_distance(from: &ChordEnd, to: &ChordEnd, options: &TrackOptions) -> f64 {
    let (dl, dh) = (to.l - from.l, to.h - from.h);
    if dl == 0.0 {
        return 0.0;
    }
    let slope = dh / dl;
    let (p, q) = (from.slope - slope, to.slope - slope);
    let limit = p.abs() + q.abs();
    let correction = |difference: f64| (0.5 * difference).clamp(-limit, limit);
    let alpha = correction(from.curvature * dl + 4.0 * p + 2.0 * q);
    let beta = correction(to.curvature * dl - 2.0 * p - 4.0 * q);
    let distance = |t: f64| {
        if !(t > 0.0 && t < 1.0) {
            return 0.0;
        }
        let weight = t * (1.0 - t);
        let cubic = weight * (p * (1.0 - t) - q * t);
        let quintic = cubic + weight * weight * (alpha * (1.0 - t) + beta * t);
        cubic.abs().max(quintic.abs())
    };
    // The extrema of the cubic, 3(p+q)t² − 2(2p+q)t + p = 0, and the middle.
    let (a, half_b) = (3.0 * (p + q), 2.0 * p + q);
    let root = (half_b * half_b - a * p).max(0.0).sqrt();
    let sum = half_b + if half_b < 0.0 { -root } else { root };
    let largest = distance(p / sum).max(distance(sum / a)).max(distance(0.5));
    let vertical = largest * dl.abs() / options.h_scale;
    let scaled_slope = slope * options.l_scale / options.h_scale;
    vertical / (1.0 + scaled_slope * scaled_slope).sqrt()
}
