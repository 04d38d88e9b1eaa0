//! Symmetric matrices of exact numbers, and their invariants.

use dashu_ratio::RBig;

use crate::Refused;
use crate::numbers::number;

pub(super) type Vector = [RBig; 3];

/// A symmetric matrix.
pub(super) struct Matrix(pub(super) [Vector; 3]);

impl Matrix {
    pub(super) fn read(rows: &[[String; 3]; 3]) -> Result<Self, Refused> {
        let [x, y, z] = rows.each_ref().map(read);
        Ok(Self([x?, y?, z?]))
    }

    pub(super) fn is_symmetric(&self) -> bool {
        (0..3).all(|i| (0..i).all(|j| self.0[i][j] == self.0[j][i]))
    }

    pub(super) fn of(entry: impl Fn(usize, usize) -> RBig) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }

    /// |c|² − c cᵀ.
    pub(super) fn turning(c: &Vector) -> Self {
        let square = dot(c, c);
        Self::of(|i, j| if i == j { &square - &c[i] * &c[j] } else { -(&c[i] * &c[j]) })
    }

    pub(super) fn minus(&self, other: &Self, factor: &RBig) -> Self {
        Self::of(|i, j| &self.0[i][j] - &other.0[i][j] * factor)
    }

    pub(super) fn times(&self, v: &Vector) -> Vector {
        self.0.each_ref().map(|row| dot(row, v))
    }

    /// ∫ x xᵀ dm = tr/2 − A.
    pub(super) fn second_moments(&self) -> Self {
        let half = (&self.0[0][0] + &self.0[1][1] + &self.0[2][2]) / RBig::from(2);
        Self::of(|i, j| if i == j { &half - &self.0[i][j] } else { -self.0[i][j].clone() })
    }

    /// The elementary symmetric functions of the eigenvalues.
    pub(super) fn invariants(&self) -> Vector {
        let [x, y, z] = &self.0;
        let minor = |i: usize, j: usize| &self.0[i][i] * &self.0[j][j] - &self.0[i][j] * &self.0[j][i];
        [&x[0] + &y[1] + &z[2], minor(0, 1) + minor(0, 2) + minor(1, 2), dot(x, &cross(y, z))]
    }

    /// All eigenvalues are real: none is negative if their elementary symmetric functions are not.
    pub(super) fn is_positive_semidefinite(&self) -> bool {
        self.invariants().iter().all(|e| *e >= RBig::ZERO)
    }

    /// How many different eigenvalues there are, by the discriminant of the characteristic polynomial.
    pub(super) fn different_moments(&self) -> usize {
        let is_scalar =
            (0..3).all(|i| (0..3).all(|j| if i == j { self.0[i][i] == self.0[0][0] } else { self.0[i][j].is_zero() }));
        let [p, q, r] = self.invariants();
        let n = |n: i32| RBig::from(n);
        let discriminant =
            &p * &p * &q * &q - n(4) * &q * &q * &q - n(4) * &p * &p * &p * &r + n(18) * &p * &q * &r - n(27) * &r * &r;
        match (is_scalar, discriminant.is_zero()) {
            (true, _) => 1,
            (false, true) => 2,
            (false, false) => 3,
        }
    }

    /// The rank of v, Av, A²v: in how many eigenspaces v has a component.
    pub(super) fn rank_of_orbit(&self, v: &Vector) -> usize {
        let first = self.times(v);
        let across = cross(v, &first);
        let is_zero = |v: &Vector| v.iter().all(RBig::is_zero);
        if is_zero(v) {
            0
        } else if is_zero(&across) {
            1
        } else if dot(&across, &self.times(&first)).is_zero() {
            2
        } else {
            3
        }
    }
}

pub(super) fn read(texts: &[String; 3]) -> Result<Vector, Refused> {
    let [x, y, z] = texts.each_ref().map(|text| number::given(text));
    Ok([x?, y?, z?])
}

pub(super) fn dot(p: &Vector, q: &Vector) -> RBig {
    &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]
}

pub(super) fn cross(p: &Vector, q: &Vector) -> Vector {
    [&p[1] * &q[2] - &p[2] * &q[1], &p[2] * &q[0] - &p[0] * &q[2], &p[0] * &q[1] - &p[1] * &q[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix([xx, yy, zz, xy, xz, yz]: [i32; 6]) -> Matrix {
        Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| row.map(RBig::from)))
    }

    fn vector(v: [i32; 3]) -> Vector {
        v.map(RBig::from)
    }

    #[test]
    fn symmetries_are_seen_exactly() {
        // 1 + v vᵀ with v = (1, 2, 3): a double moment 1 and the moment 15 along v.
        let tensor = matrix([2, 5, 10, 2, 3, 6]);
        assert_eq!(tensor.different_moments(), 2);
        assert_eq!(tensor.rank_of_orbit(&vector([1, 2, 3])), 1);
        assert_eq!(tensor.rank_of_orbit(&vector([3, 0, -1])), 1);
        assert_eq!(tensor.rank_of_orbit(&vector([1, 0, 0])), 2);
        assert_eq!(tensor.rank_of_orbit(&vector([0, 0, 0])), 0);
        let tilted = matrix([2, 3, 4, 1, 0, 0]);
        assert_eq!(tilted.different_moments(), 3);
        assert_eq!(tilted.rank_of_orbit(&vector([1, 1, 0])), 2);
        assert_eq!(tilted.rank_of_orbit(&vector([1, 1, 1])), 3);
        assert_eq!(matrix([2, 2, 2, 0, 0, 0]).different_moments(), 1);
    }

    #[test]
    fn what_can_exist_has_second_moments() {
        let exists = |diagonal: [i32; 3]| {
            let [x, y, z] = diagonal;
            matrix([x, y, z, 0, 0, 0]).second_moments().is_positive_semidefinite()
        };
        assert!(exists([2, 3, 4]) && exists([1, 2, 3]) && !exists([1, 2, 4]) && !exists([9, 2, 4]));
    }
}
