//! Reversors: maps of phase space that preserve h and l and reverse time.

use bifdiag_dynamics::field::{HeavyTop, State};
use nalgebra::{Matrix3, Vector3};

use crate::flow::Space;

/// (γ, l) ↦ (Qγ, −det Q · Ql) for an orthogonal Q with Q² = 1 that commutes with A and fixes r: it maps motions to
/// motions run backwards, and ⟨γ,l⟩ to −det Q ⟨γ,l⟩.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reversor {
    matrix: Matrix3<f64>,
    /// −det Q.
    sign: f64,
}

/// The reversors of a top at one l. Where they form a circle, as for a Lagrange top, one of each kind.
#[must_use]
pub fn reversors(top: &HeavyTop, l: f64) -> Vec<Reversor> {
    let (a, r) = (top.moments(), Vector3::from(top.center()));
    let mut maps: Vec<Matrix3<f64>> = (0..8_u8)
        .map(|signs| Matrix3::from_diagonal(&Vector3::from_fn(|k, _| if signs >> k & 1 == 1 { -1.0 } else { 1.0 })))
        .collect();
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let mut normal = Vector3::zeros();
        (normal[i], normal[j]) = (r[j], -r[i]);
        // Equal moments: the plane of the third axis and r is a mirror too.
        if a[i] == a[j] && normal.norm() > 0.0 {
            let normal = normal.normalize();
            maps.push(Matrix3::identity() - 2.0 * normal * normal.transpose());
        }
    }
    let keeps = |matrix: &Matrix3<f64>| (matrix * r - r).norm() <= 1e-15 * r.norm();
    let reversors =
        maps.into_iter().filter(keeps).map(|matrix| Reversor { matrix, sign: -matrix.determinant().round() });
    reversors.filter(|reversor| reversor.sign > 0.0 || l == 0.0).collect()
}

/// True where every plane through r is a plane of symmetry, as for the tops of Lagrange. Then every motion is symmetric
/// about the plane of γ and r at any zero of S = ⟨ω, r×γ⟩, since ω lies in it there; where γ is parallel to r, about
/// the plane of ω and r. (⟨γ,r⟩ has an extremum on every closed orbit.)
#[must_use]
pub fn all_are_symmetric(top: &HeavyTop) -> bool {
    let (a, r) = (top.moments(), top.center());
    let along = |k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] == a[j] && r[i] == 0.0 && r[j] == 0.0
    };
    (a[0] == a[1] && a[1] == a[2]) || (0..3).any(along)
}

impl Reversor {
    /// The image of a state.
    #[must_use]
    pub fn apply(&self, state: &State) -> State {
        let turn = |v: [f64; 3]| -> [f64; 3] { (self.matrix * Vector3::from(v)).into() };
        State { gamma: turn(state.gamma), l: turn(state.l).map(|x| self.sign * x) }
    }

    /// How far it moves a state: a signed component, which changes sign where an orbit passes a fixed point, and the
    /// norm.
    #[must_use]
    pub fn distance(&self, space: &Space, state: &State) -> (f64, f64) {
        /// An arbitrary direction, so that no symmetry makes the component of an orbit along it vanish.
        const LOOK: [f64; 6] = [0.531, 0.327, 0.411, 0.263, 0.479, 0.377];
        let moved = space.point(&self.apply(state)) - space.point(state);
        (moved.iter().zip(LOOK).map(|(x, look)| x * look).sum(), moved.norm())
    }

    /// The signed component of [`distance`](Self::distance), which is linear in the state.
    #[must_use]
    pub fn covector(&self, space: &Space) -> State {
        let unit = |j: usize| State {
            gamma: std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 }),
            l: std::array::from_fn(|i| if i + 3 == j { 1.0 } else { 0.0 }),
        };
        let of = |j: usize| self.distance(space, &unit(j)).0;
        State { gamma: std::array::from_fn(of), l: std::array::from_fn(|i| of(i + 3)) }
    }
}
