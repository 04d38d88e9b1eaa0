//! Two views of the sphere from opposite sides, in orthographic projection.

use std::f64::consts::TAU;

use bifdiag_dynamics::field::{cross, dot};

use bifdiag_page::Point;

pub(super) type Vector = [f64; 3];

/// By how much a view may look down on the equator of r̂, in radians, the usual first; and views round it for each.
const TILTS: [f64; 4] = [0.35, 0.2, 0.6, 0.85];
const ROUND: u32 = 24;
/// Places on a rim at which is seen where ∂U crosses it.
const RIM: u32 = 240;
/// What it costs to cut ∂U once, against the height of a mark over the rim, which is 1 in the middle of a view.
const CUT: f64 = 0.1;

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

/// The part of `v` across the unit vector `axis`, as a unit vector; of a principal axis if `v` has none.
fn across(v: Vector, axis: Vector) -> Vector {
    let candidates = [v, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let parts = candidates.map(|v| {
        let along = dot(v, axis);
        [v[0] - along * axis[0], v[1] - along * axis[1], v[2] - along * axis[2]]
    });
    unit(parts.into_iter().find(|part| dot(*part, *part) > 1e-6).unwrap_or([1.0, 0.0, 0.0]))
}

/// `v` turned about a unit vector (Rodrigues' formula).
pub(super) fn turned(v: Vector, axis: Vector, angle: f64) -> Vector {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let (along, side) = (dot(v, axis), cross(axis, v));
    [0, 1, 2].map(|k| cos * v[k] + sin * side[k] + (1.0 - cos) * along * axis[k])
}

/// What points up on the page: −r̂ as in space.
fn upright(r_hat: Option<Vector>) -> Vector {
    r_hat.map_or([0.0, 0.0, 1.0], |r| r.map(|c| -c))
}

/// The direction from which most is seen: the rims cut ∂U least often, and the points that are marked, poles and equilibria, are
/// farthest from them. Of equally good ones the first, which looks from beside r̂, a little above.
pub(super) fn best_direction(r_hat: Option<Vector>, above: &dyn Fn(Vector) -> f64, marked: &[Vector]) -> Vector {
    let upright = upright(r_hat);
    let level = across([0.6, 0.7, 0.4], upright);
    let part = |k: u32, of: u32| TAU * f64::from(k) / f64::from(of);
    let directions = TILTS.into_iter().flat_map(|tilt| {
        (0..ROUND).map(move |k| {
            let beside = turned(level, upright, part(k, ROUND));
            let (sin, cos) = (libm::sin(tilt), libm::cos(tilt));
            [0, 1, 2].map(|i| cos * beside[i] + sin * upright[i])
        })
    });
    let cost = |toward: &Vector| {
        let start = across(upright, *toward);
        let inside: Vec<bool> = (0..=RIM).map(|k| above(turned(start, *toward, part(k, RIM))) <= 0.0).collect();
        let cuts = inside.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let lowest = marked.iter().map(|mark| dot(*mark, *toward).abs()).fold(1.0, f64::min);
        CUT * cuts as f64 - lowest
    };
    let costs = directions.map(|toward| (cost(&toward), toward));
    // Views of symmetric bodies differ only by rounding.
    let better = |best: (f64, Vector), next: (f64, Vector)| if next.0 < best.0 - 1e-9 { next } else { best };
    costs.reduce(better).map_or(level, |(_, toward)| toward)
}

/// One of the two views.
#[derive(Clone, Copy, Debug)]
pub(super) struct SphereView {
    right: Vector,
    up: Vector,
    toward: Vector,
    pub center: Point,
    pub radius: f64,
}

impl SphereView {
    /// The view from a direction, and the one from the other side. −r̂, the upright position, points up on the page as it does
    /// in space.
    pub fn pair(direction: Vector, r_hat: Option<Vector>, centers: [Point; 2], radius: f64) -> [Self; 2] {
        let (upright, toward) = (upright(r_hat), unit(direction));
        let up = across(upright, toward);
        let front = Self { right: cross(up, toward), up, toward, center: centers[0], radius };
        let negative = |v: Vector| v.map(|c| -c);
        let back = Self { right: negative(front.right), toward: negative(toward), center: centers[1], ..front };
        [front, back]
    }

    /// The point of the sphere at the angle `t` from the middle of the view in the direction `phi` on the page.
    pub fn gamma(&self, t: f64, phi: f64) -> Vector {
        let (x, y, z) = (libm::sin(t) * libm::cos(phi), libm::sin(t) * libm::sin(phi), libm::cos(t));
        [0, 1, 2].map(|k| x * self.right[k] + y * self.up[k] + z * self.toward[k])
    }

    /// Where (t, phi) lies on the page.
    pub fn place(&self, t: f64, phi: f64) -> Point {
        let rho = self.radius * libm::sin(t);
        [self.center[0] + rho * libm::cos(phi), self.center[1] - rho * libm::sin(phi)]
    }

    /// Where a point of the sphere lies on the page, if this view shows it.
    pub fn position(&self, gamma: Vector) -> Option<Point> {
        let [x, y, z] = [self.right, self.up, self.toward].map(|axis| dot(axis, gamma));
        // Points on the rim are shown by the first view and the second.
        (z >= -1e-9).then(|| [self.center[0] + self.radius * x, self.center[1] - self.radius * y])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_views_share_their_rim_and_show_every_point() {
        let views = SphereView::pair([0.3, -0.5, 0.2], Some([0.6, 0.0, 0.8]), [[100.0, 100.0], [300.0, 100.0]], 90.0);
        for k in 0..24 {
            let phi = f64::from(k) * 0.3;
            let rim = views[0].gamma(std::f64::consts::FRAC_PI_2, phi);
            let other = views[1].gamma(std::f64::consts::FRAC_PI_2, std::f64::consts::PI - phi);
            assert!((0..3).all(|i| (rim[i] - other[i]).abs() < 1e-14));
            let gamma = unit([libm::sin(phi), libm::cos(2.0 * phi), 0.3]);
            assert!(views.iter().any(|view| view.position(gamma).is_some()));
        }
    }

    /// A small hole and the poles keep away from the rims; among equally good views the first is taken.
    #[test]
    fn the_best_view_cuts_no_small_circle() {
        let r_hat = Some([0.0, 0.0, 1.0]);
        let usual = best_direction(r_hat, &|_| -1.0, &[]);
        for k in 0..20 {
            let (sin, cos) = libm::sincos(0.3 * f64::from(k));
            let hole = [0.96 * cos, 0.96 * sin, 0.28];
            let above = |gamma: Vector| dot(gamma, hole) - 0.97;
            let toward = best_direction(r_hat, &above, &[hole, [0.0, 0.0, 1.0]]);
            // It reaches 14° far.
            assert!(dot(toward, hole).abs() > 0.3 && toward[2].abs() > 0.15, "{k}: {toward:?}");
            assert_eq!(best_direction(r_hat, &|_| -1.0, &[]), usual);
        }
    }

    #[test]
    fn places_and_positions_agree() {
        let [front, _] =
            SphereView::pair([0.0, 0.0, 2.0], Some([1.0, 0.0, 0.0]), [[100.0, 100.0], [300.0, 100.0]], 90.0);
        let (place, position) = (front.place(0.7, 1.2), front.position(front.gamma(0.7, 1.2)).unwrap());
        assert!((place[0] - position[0]).abs() < 1e-12 && (place[1] - position[1]).abs() < 1e-12);
    }
}
