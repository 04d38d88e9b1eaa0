//! Curves in closed form: lines, and pairs or circles over a group without r.

use dashu_ratio::RBig;

use super::curve::{Bound, Curve, Curves, Cusp, Limit, Pitchfork, Segment, Shape, orbit};
use super::place::Place;
use crate::family::Half;
use crate::model::Model;
use bifdiag_equilibria::curves::{Branch, CurveId, End, Orbit, PitchforkId, Pole};
use bifdiag_numbers::Sign;
use bifdiag_numbers::table::Id;

impl Curves {
    pub(super) fn add_euler(&mut self, model: &Model) {
        for (group, eigenspace) in model.groups.iter().enumerate() {
            self.list.push(Curve {
                branch: Branch::Symmetric(model.axis[group]),
                piece: 1,
                orbit: orbit(eigenspace.size, model.axis[group]),
                pole: None,
                shape: Shape::Euler { group },
                ends: [End::Origin, End::Infinity],
                limit: None,
                lowest: group + 1 == model.groups.len(),
            });
        }
    }

    /// r on a principal axis: the lines γ = ∓r̂, cut where a pair leaves them: μ = a ∓ r/s passes a_k at
    /// x = a² r/(2 |a_k − a|).
    pub(super) fn add_lines(&mut self, model: &Model) {
        let axis = model.active[0];
        for (side, pole) in [(0, Pole::Minus), (1, Pole::Plus)] {
            let mut cuts: Vec<usize> = model.passive.iter().copied().filter(|&k| (k > axis) == (side == 1)).collect();
            // x falls with |a_k − a|.
            cuts.sort_by_key(|&k| std::cmp::Reverse(k.abs_diff(axis)));
            let first = self.list.len();
            let mut from = End::Origin;
            for piece in 0..=cuts.len() {
                let to = cuts
                    .get(piece)
                    .map_or(End::Infinity, |_| End::Pitchfork(PitchforkId::at(self.pitchforks.len() + piece)));
                self.list.push(Curve {
                    branch: Branch::Axis(pole),
                    piece: piece + 1,
                    orbit: Orbit::Point,
                    pole: Some(pole),
                    shape: Shape::Pole(pole),
                    ends: [from, to],
                    limit: None,
                    // Beyond the first cut μ has passed the largest moment.
                    lowest: side == 1 && (piece == 0 || cuts.is_empty()),
                });
                from = to;
            }
            for (piece, &group) in cuts.iter().enumerate() {
                let through = [first + piece, first + piece + 1].map(CurveId::at);
                self.pitchforks.push(Pitchfork { group, place: None, through, pair: through[0], opens: true });
            }
        }
    }

    /// The pairs and circles over groups without r: v = s² from P̂ on, with a cusp at v = −3R̂/a if that lies beyond.
    pub(super) fn add_pairs(&mut self, model: &Model) {
        if model.active.is_empty() {
            return;
        }
        for &group in &model.passive {
            let Some((number, _)) = self.pitchforks.pairs().find(|(_, p)| p.group == group) else { continue };
            let half = Half::Over { group };
            let (r_sum, p_sum) = model.sums_over(group);
            let turn = r_sum * RBig::from(-3) / model.a(group) - p_sum;
            let axis = model.axis[group];
            let orbit = orbit(model.groups[group].size, axis);
            let first = self.list.next_id();
            let lowest = group + 1 == model.groups.len();
            let limit = Some(Limit { group, side: Sign::Zero });
            let curve = |piece, ends: [Bound; 2], marks, limit| Curve {
                branch: Branch::Symmetric(axis),
                piece,
                orbit,
                pole: None,
                shape: Shape::Family(vec![Segment { half, ends }]),
                ends: marks,
                limit,
                lowest,
            };
            if turn > RBig::ZERO {
                let place = Place::exact(half, turn);
                let at = || Bound::At(place.clone());
                let cusp = End::Cusp(self.cusps.next_id());
                self.list.push(curve(1, [at(), Bound::Zero], [cusp, End::Pitchfork(number)], None));
                let second = self.list.push(curve(2, [at(), Bound::Infinity], [cusp, End::Infinity], limit));
                self.cusps.push(Cusp { place, curves: [first, second], opens: true });
                self.pitchforks[number].opens = false;
            } else {
                let marks = [End::Pitchfork(number), End::Infinity];
                self.list.push(curve(1, [Bound::Zero, Bound::Infinity], marks, limit));
            }
            self.pitchforks[number].pair = first;
        }
    }

    pub(super) fn add_pole_lines(&mut self) {
        for pole in [Pole::Plus, Pole::Minus] {
            self.list.push(Curve {
                branch: Branch::Pole(pole),
                piece: 1,
                orbit: Orbit::Pole(pole),
                pole: Some(pole),
                shape: Shape::Pole(pole),
                ends: [End::Origin, End::Infinity],
                limit: None,
                lowest: false,
            });
        }
    }
}
