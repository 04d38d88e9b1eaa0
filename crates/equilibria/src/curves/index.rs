//! The Morse index of U_l along the curves.
//!
//! On the tangent plane at a critical point the Hessian is s [(μ − A) + (4/J) Aγ (Aγ)ᵀ] (Proposition 4.1 of
//! docs/mathematics.md). Its determinant has the sign of −dx/dμ · Π_k (μ − a_k) along the generic family, and of
//! dx/ds · Π_{j≠i} (a_i − a_j) along the family over a_i; where it is positive, the sign of the trace separates minimum
//! from maximum (Proposition 4.2).

use super::arc::{Arc, Segment, Shape};
use super::curve::Orbit;
use super::families::{GenericState, Mu, SymmetricFamily};
use bifdiag_body::{Axis, Frame};

/// Trace of the Hessian over s: Σ (μ−a) − Σ w (μ−a) + (4/J) Var_w(a), with its scale.
fn trace(frame: &Frame, gamma: [f64; 3], j: f64, mu: Mu) -> (f64, f64) {
    let w = gamma.map(|g| g * g);
    let tau = Axis::ALL.map(|k| mu.minus_moment(frame, k));
    let pair = |i: usize, k: usize| w[i] * w[k] * frame.diff[i][k] * frame.diff[i][k];
    let variance = pair(0, 1) + pair(0, 2) + pair(1, 2);
    let free: f64 = (0..3).map(|k| (1.0 - w[k]) * tau[k]).sum();
    let scale: f64 = (0..3).map(|k| (1.0 - w[k]).abs() * tau[k].abs()).sum();
    (free + 4.0 * variance / j, scale + 4.0 * variance / j)
}

/// Minimum or maximum: the trace of the sample where it is clearest.
fn minimum_or_maximum(traces: impl Iterator<Item = (f64, f64)>) -> u8 {
    let clearest = traces.fold(0.0_f64, |best, (trace, scale)| {
        let relative = trace / scale;
        if relative.abs() > best.abs() { relative } else { best }
    });
    if clearest > 0.0 { 0 } else { 2 }
}

/// Index along a piece of the generic family; `x_rises`: x rises with μ.
pub(super) fn generic(frame: &Frame, arcs: &[Arc], x_rises: bool) -> u8 {
    let samples: Vec<Mu> = arcs
        .iter()
        .flat_map(|arc| match &arc.shape {
            Shape::Generic(segments) => segments.as_slice(),
            _ => &[],
        })
        .flat_map(sample)
        .collect();
    let negative = Axis::ALL.into_iter().filter(|&k| samples[0].minus_moment(frame, k) < 0.0).count();
    let product_negative = negative % 2 == 1;
    // sign det = −sign(dx/dμ) · sign Π(μ − a_k).
    if x_rises != product_negative {
        return 1;
    }
    minimum_or_maximum(samples.iter().map(|&mu| {
        let state = GenericState::at(frame, mu);
        trace(frame, state.gamma, state.j, mu)
    }))
}

/// Two places inside a segment.
fn sample(segment: &Segment) -> [Mu; 2] {
    let [a, b] = segment.distance;
    let (small, large) = (a.min(b), a.max(b));
    let at = |fraction: f64| {
        let distance = if large.is_infinite() {
            if small == 0.0 { fraction * 2.0 } else { small * (1.0 + 2.0 * fraction) }
        } else {
            small + fraction * (large - small)
        };
        Mu { base: segment.base, delta: segment.sign * distance }
    };
    [at(0.5), at(0.25)]
}

/// Index along a piece of the family over a_i, t from its lower to its upper end in x.
pub(super) fn symmetric(frame: &Frame, family: &SymmetricFamily, t: [f64; 2], s_rises: bool, orbit: Orbit) -> u8 {
    let axis = family.axis;
    let others: Vec<Axis> = Axis::ALL.into_iter().filter(|&k| frame.group[k] != frame.group[axis]).collect();
    let below = others.iter().filter(|&&k| frame.diff[axis][k] < 0.0).count();
    if matches!(orbit, Orbit::Circle(_)) {
        // One normal direction, with the sign of dx/ds · (a_i − a_j).
        return u8::from(s_rises == (below == 1));
    }
    let determinant_positive = s_rises == (below % 2 == 0);
    if !determinant_positive {
        return 1;
    }
    let (low, high) = (t[0].min(t[1]), t[0].max(t[1]));
    let unit = family.s_pitchfork.max(1.0);
    let at =
        |fraction: f64| if high.is_infinite() { low + unit * fraction * 2.0 } else { low + fraction * (high - low) };
    minimum_or_maximum([0.5, 0.25].into_iter().map(|fraction| {
        let state = family.at(frame, at(fraction));
        trace(frame, state.gamma, state.j, Mu { base: axis, delta: 0.0 })
    }))
}

/// Index along the line γ = ±e_axis = ±r̂, on which μ − a_axis has the sign `sign`, beyond the pitchforks of these axes: the
/// number of the other axes with μ < a_k.
pub(super) fn on_axis(frame: &Frame, axis: Axis, sign: f64, passed: impl Iterator<Item = Axis>) -> u8 {
    let passed: Vec<_> = passed.map(|k| frame.group[k]).collect();
    let is_negative = |k: &Axis| (sign < 0.0) != passed.contains(&frame.group[*k]);
    let negative = axis.others().into_iter().filter(is_negative).count();
    u8::try_from(negative).unwrap_or(2)
}
