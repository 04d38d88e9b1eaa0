//! Distance between the curve and a chord of it in the (h, l) plane.

use super::options::TrackOptions;
use super::report::Vertex;

/// Largest distance between the curve from `from` to `to` and its chord, in the scaled plane.
///
/// Both ends know the slope dh/dl = Ω. The cubic h(l) through both with these slopes leaves the chord by
/// Δl (p t(1−t)² − q t²(1−t)), where p and q are Ω minus the chord's slope at its ends; next to a cusp, where h(l) goes
/// with the power 3/2, this overstates the distance by a quarter.
pub(super) fn chord_distance(from: &Vertex, to: &Vertex, options: &TrackOptions) -> f64 {
    let (dl, dh) = (to.l - from.l, to.h - from.h);
    if dl == 0.0 {
        return 0.0;
    }
    let slope = dh / dl;
    let p = from.equilibrium.omega - slope;
    let q = to.equilibrium.omega - slope;
    let distance = |t: f64| {
        if t > 0.0 && t < 1.0 { (t * (1.0 - t) * (p * (1.0 - t) - q * t)).abs() } else { 0.0 }
    };
    // 3(p+q)t² − 2(2p+q)t + p = 0.
    let (a, half_b) = (3.0 * (p + q), 2.0 * p + q);
    let root = (half_b * half_b - a * p).max(0.0).sqrt();
    let sum = half_b + if half_b < 0.0 { -root } else { root };
    let largest = distance(p / sum).max(distance(sum / a));
    let vertical = largest * dl.abs() / options.h_scale;
    let scaled_slope = slope * options.l_scale / options.h_scale;
    vertical / (1.0 + scaled_slope * scaled_slope).sqrt()
}
