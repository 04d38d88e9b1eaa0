//! The topology of U when it depends on the distance from an axis of symmetry alone.

use super::component::Component;
use crate::equilibria::pieces::Branch;
use crate::numbers::fixed::Fixed;
use crate::order::orders::Orders;
use crate::order::slabs::Slab;

/// The critical circles and the two ends of the axis along it, each by its position in a slab. All critical points of U
/// as a function of the coordinate z along the axis are among them, so that U is monotone between two.
pub(crate) struct Rings {
    positions: Vec<usize>,
    has_poles: bool,
}

impl Rings {
    /// `None` when the order along the axis is not certain.
    pub fn new(orders: &Orders, slab: &Slab, axis: usize) -> Option<Self> {
        let mut found = Vec::new();
        for (position, level) in slab.levels.iter().enumerate() {
            let z = &level.point.gamma[axis];
            found.push((z.clone(), position));
            if orders.pieces.list[level.curve].branch == Branch::Rotation(axis) {
                found.push((-z, position));
            }
        }
        // Sorted by insertion, so that every comparison is one that decides.
        let mut sorted: Vec<(Fixed, usize)> = Vec::new();
        for ring in found {
            let below = sorted.iter().filter(|other| other.0.below(&ring.0)).count();
            let above = sorted.iter().filter(|other| ring.0.below(&other.0)).count();
            if below + above != sorted.len() {
                return None;
            }
            sorted.insert(below, ring);
        }
        let positions = sorted.into_iter().map(|(_, position)| position).collect();
        Some(Self { positions, has_poles: !orders.spaces.active.is_empty() })
    }

    /// The components of U above the curve at a position: runs of critical points below it, which end in a circle or at
    /// an end of the axis. r points along the axis, if there is one.
    pub fn components(&self, position: usize) -> Vec<Component> {
        let mut found: Vec<Component> = Vec::new();
        let last = self.positions.len() - 1;
        let below = |n: usize| self.positions[n] <= position;
        for n in (0..=last).filter(|&n| below(n)) {
            if n == 0 || !below(n - 1) {
                let poles = self.has_poles.then_some([false, n == 0]);
                found.push(Component { boundary_circles: u32::from(n > 0), poles });
            }
            if let Some(component) = found.last_mut().filter(|_| n == last || !below(n + 1)) {
                component.boundary_circles += u32::from(n < last);
                if let Some([plus, _]) = &mut component.poles {
                    *plus = n == last;
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_rings_are_components() {
        // A circle of minima between two ends, the upper one higher.
        let rings = Rings { positions: vec![1, 0, 2], has_poles: true };
        let component = |boundary_circles, poles| Component { boundary_circles, poles: Some(poles) };
        assert_eq!(rings.components(0), [component(2, [false, false])]);
        assert_eq!(rings.components(1), [component(1, [false, true])]);
        assert_eq!(rings.components(2), [component(0, [true, true])]);
        // A circle of maxima.
        let rings = Rings { positions: vec![1, 2, 0], has_poles: true };
        assert_eq!(rings.components(1), [component(1, [false, true]), component(1, [true, false])]);
    }
}
