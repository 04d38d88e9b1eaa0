//! The curves that are not of the generic family: principal rotations, pairs and circles, pole lines.

use super::arc::{Arc, Shape};
use super::critical_set::{CriticalSet, Cusp, Pitchfork};
use super::curve::{Branch, Curve, CurveId, End, Orbit, PitchforkId, Pole};
use super::curve_point::Point;
use super::families::SymmetricFamily;
use super::index;
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::table::Id;

impl CriticalSet {
    /// r = 0: rotations about the principal axes, straight lines through the origin.
    pub(super) fn add_euler(&mut self, passive: &[Axis]) {
        for &axis in passive {
            let dimension = eigenspace_dimension(&self.frame, axis);
            let orbit = match dimension {
                1 => Orbit::Pair(axis),
                2 => Orbit::Circle(axis),
                _ => Orbit::Sphere,
            };
            let index = (0..3).filter(|&k| self.frame.group[k] > self.frame.group[axis]).count();
            // For a circle the index counts the one normal direction only; a sphere has none.
            let index = if dimension == 1 { index } else { index.min(3 - dimension) };
            self.curves.push(Curve {
                branch: Branch::Symmetric(axis),
                piece: 1,
                orbit,
                index: Some(u8::try_from(index).unwrap_or(2)),
                pole: None,
                arcs: vec![Arc::straight(unit(axis, 1.0), self.frame.a[axis], [0.0, f64::INFINITY])],
                ends: [End::Origin, End::Infinity],
            });
        }
    }

    /// r on an eigenspace: two straight lines γ = ±r̂, cut at the pitchforks of the other axes.
    pub(super) fn add_axis(&mut self, axis: Axis, passive: &[Axis]) {
        let a = self.frame.a[axis];
        for (pole, sign) in [(Pole::Minus, -1.0), (Pole::Plus, 1.0)] {
            let gamma = unit(axis, sign);
            // μ = a ± r/s passes a_k at s = r/|a_k − a|, on the line on whose side a_k lies.
            let mut cuts: Vec<(f64, Axis)> = passive
                .iter()
                .filter(|&&k| self.frame.diff[k][axis] * sign > 0.0)
                .map(|&k| (0.5 * a * a * self.frame.r[axis] / self.frame.diff[k][axis].abs(), k))
                .collect();
            // Their x can be equal in doubles; differences of moments are not.
            cuts.sort_by(|p, q| (sign * self.frame.diff[q.1][p.1]).total_cmp(&0.0));
            let first = self.curves.len();
            let mut from = (0.0, End::Origin);
            for piece in 0..=cuts.len() {
                let to = cuts.get(piece).map_or((f64::INFINITY, End::Infinity), |&(x, _)| {
                    (x, End::Pitchfork(PitchforkId::at(self.pitchforks.len() + piece)))
                });
                let index = index::on_axis(&self.frame, axis, sign, cuts[..piece].iter().map(|cut| cut.1));
                self.curves.push(Curve {
                    branch: Branch::Axis(pole),
                    piece: piece + 1,
                    orbit: Orbit::Point,
                    index: Some(index),
                    pole: Some(pole),
                    arcs: vec![Arc::straight(gamma, a, [from.0, to.0])],
                    ends: [from.1, to.1],
                });
                from = to;
            }
            for (n, &(x, k)) in cuts.iter().enumerate() {
                let point = Point::over(&self.frame, x, gamma, a);
                let through = [first + n, first + n + 1].map(CurveId::at);
                self.pitchforks.push(Pitchfork { point, axis: k, through, pair: None });
            }
        }
    }

    /// The pairs and circles over eigenspaces without r; their pitchforks are known by now.
    pub(super) fn add_symmetric(&mut self, passive: &[Axis]) {
        for &axis in passive {
            let Some((number, pitchfork)) = self.pitchforks.pairs().find(|(_, p)| p.axis == axis) else {
                continue;
            };
            let family = SymmetricFamily::over(&self.frame, axis);
            let root = pitchfork.point;
            let orbit =
                if eigenspace_dimension(&self.frame, axis) == 2 { Orbit::Circle(axis) } else { Orbit::Pair(axis) };
            let start = (0.0, root.x, root.slope());
            let end = (f64::INFINITY, f64::INFINITY, 1.0 / self.frame.a[axis]);
            let cusp = family.cusp(&self.frame).map(|t| {
                let state = family.at(&self.frame, t);
                (t, Point::over(&self.frame, state.x, state.gamma, state.j))
            });
            // dx/ds has the sign of a + 3R̂/s²: x falls up to the cusp and rises beyond it, also where rounding hides that.
            let push = |set: &mut Self, piece, from: (f64, f64, f64), to: (f64, f64, f64), mut ends: [End; 2]| {
                let (mut t, mut x, mut slope) = ([from.0, to.0], [from.1, to.1], [from.2, to.2]);
                let rising = !matches!(ends[1], End::Cusp(_));
                if !rising {
                    t.reverse();
                    x.reverse();
                    slope.reverse();
                    ends.reverse();
                }
                x[0] = x[0].min(x[1]);
                let index = index::symmetric(&set.frame, &family, t, rising, orbit);
                let arcs = vec![Arc { shape: Shape::Symmetric { family, t }, x, slope }];
                let index = Some(index);
                set.curves.push(Curve { branch: Branch::Symmetric(axis), piece, orbit, index, pole: None, arcs, ends })
            };
            let first = match cusp {
                None => push(self, 1, start, end, [End::Pitchfork(number), End::Infinity]),
                Some((t, point)) => {
                    let turn = (t, point.x, point.slope());
                    let cusp = self.cusps.next_id();
                    let first = push(self, 1, start, turn, [End::Pitchfork(number), End::Cusp(cusp)]);
                    let second = push(self, 2, turn, end, [End::Cusp(cusp), End::Infinity]);
                    self.cusps.push(Cusp { point, curves: [first, second], opens_upward: true });
                    first
                }
            };
            self.pitchforks[number].pair = Some(first);
        }
    }

    /// The two pole lines off the critical curves.
    pub(super) fn add_pole_lines(&mut self) {
        let r_hat = self.frame.r_hat();
        for (pole, sign) in [(Pole::Plus, 1.0), (Pole::Minus, -1.0)] {
            self.curves.push(Curve {
                branch: Branch::Pole(pole),
                piece: 1,
                orbit: Orbit::Pole(pole),
                index: None,
                pole: Some(pole),
                arcs: vec![Arc::straight(r_hat.map(|c| sign * c), self.frame.j_r, [0.0, f64::INFINITY])],
                ends: [End::Origin, End::Infinity],
            });
        }
    }
}

fn unit(axis: Axis, sign: f64) -> [f64; 3] {
    let mut v = [0.0; 3];
    v[axis] = sign;
    v
}

/// Dimension of the eigenspace whose first axis is given.
fn eigenspace_dimension(frame: &Frame, axis: Axis) -> usize {
    (0..3).filter(|&k| frame.group[k] == frame.group[axis]).count()
}
