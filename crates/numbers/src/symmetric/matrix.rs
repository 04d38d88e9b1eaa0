//! The matrix itself.

use dashu_ratio::RBig;

use crate::enclosure::Arithmetic;

/// A symmetric 3×3 matrix of rationals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symmetric {
    entries: [[RBig; 3]; 3],
}

impl Symmetric {
    /// From the entries xx, yy, zz, xy, xz, yz.
    #[must_use]
    pub fn new([xx, yy, zz, xy, xz, yz]: [RBig; 6]) -> Self {
        Self { entries: [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]] }
    }

    /// The matrix with these entries on the diagonal and 0 elsewhere.
    #[must_use]
    pub fn diagonal([x, y, z]: [RBig; 3]) -> Self {
        Self::new([x, y, z, RBig::ZERO, RBig::ZERO, RBig::ZERO])
    }

    /// v vᵀ.
    #[must_use]
    pub fn outer([x, y, z]: &[RBig; 3]) -> Self {
        Self::new([x * x, y * y, z * z, x * y, x * z, y * z])
    }

    /// The entries, row by row.
    #[must_use]
    pub fn rows(&self) -> &[[RBig; 3]; 3] {
        &self.entries
    }

    /// All three entries off the diagonal vanish.
    #[must_use]
    pub fn is_diagonal(&self) -> bool {
        let [[_, xy, xz], [_, _, yz], _] = &self.entries;
        xy.is_zero() && xz.is_zero() && yz.is_zero()
    }

    /// The matrix with the entries f(i, j, x_ij); f is called with i ≤ j only and must return one value for each pair.
    #[must_use]
    pub fn map(&self, f: impl Fn(usize, usize, &RBig) -> RBig) -> Self {
        Self { entries: std::array::from_fn(|i| std::array::from_fn(|j| f(i.min(j), i.max(j), &self.entries[i][j]))) }
    }

    /// self + factor · other.
    #[must_use]
    pub fn plus(&self, factor: &RBig, other: &Self) -> Self {
        self.map(|i, j, x| x + factor * &other.entries[i][j])
    }

    /// factor · E − self.
    #[must_use]
    pub fn subtracted_from(&self, factor: &RBig) -> Self {
        self.map(|i, j, x| if i == j { factor - x } else { -x.clone() })
    }

    /// The sum of the diagonal.
    #[must_use]
    pub fn trace(&self) -> RBig {
        &self.entries[0][0] + &self.entries[1][1] + &self.entries[2][2]
    }

    /// adj(self), with self · adj(self) = det(self) E.
    #[must_use]
    pub fn adjugate(&self) -> Self {
        let m = &self.entries;
        self.map(|i, j, _| {
            let ([a, b], [c, d]) = ([(j + 1) % 3, (j + 2) % 3], [(i + 1) % 3, (i + 2) % 3]);
            &m[a][c] * &m[b][d] - &m[a][d] * &m[b][c]
        })
    }

    /// det(self), expanded along the first row.
    #[must_use]
    pub fn determinant(&self) -> RBig {
        let adjugate = self.adjugate();
        (0..3).fold(RBig::ZERO, |sum, j| sum + &self.entries[0][j] * &adjugate.entries[j][0])
    }

    /// The three leading minors; all are positive if and only if the matrix is positive definite (Sylvester).
    #[must_use]
    pub fn leading_minors(&self) -> [RBig; 3] {
        let m = &self.entries;
        [m[0][0].clone(), &m[0][0] * &m[1][1] - &m[0][1] * &m[0][1], self.determinant()]
    }

    /// All principal minors ≥ 0.
    #[must_use]
    pub fn is_positive_semidefinite(&self) -> bool {
        let adjugate = self.adjugate();
        let not_negative = |m: &Self| (0..3).all(|i| m.entries[i][i] >= RBig::ZERO);
        not_negative(self) && not_negative(&adjugate) && self.determinant() >= RBig::ZERO
    }

    /// self · v.
    #[must_use]
    pub fn times(&self, v: &[RBig; 3]) -> [RBig; 3] {
        self.entries.each_ref().map(|row| dot(row, v))
    }

    /// det(μ − self) by rising powers of μ.
    #[must_use]
    pub fn characteristic(&self) -> [RBig; 4] {
        [-self.determinant(), self.adjugate().trace(), -self.trace(), RBig::ONE]
    }

    /// rᵀ adj(μ − self) r by rising powers of μ, from adj(μ − A) = μ² + μ (A − tr A) + adj A.
    #[must_use]
    pub fn resolvent(&self, r: &[RBig; 3]) -> [RBig; 3] {
        let squared = dot(r, r);
        [dot(r, &self.adjugate().times(r)), dot(r, &self.times(r)) - self.trace() * &squared, squared]
    }

    /// A column of adj(μ − self) in any arithmetic.
    pub(super) fn resolvent_column<T: Arithmetic>(&self, mu: &T, column: usize, precision: T::Precision) -> [T; 3] {
        let (trace, adjugate) = (self.trace(), self.adjugate());
        std::array::from_fn(|i| {
            let diagonal = i == column;
            let linear = if diagonal { &self.entries[i][i] - &trace } else { self.entries[i][column].clone() };
            let rest = T::rational(&adjugate.entries[i][column], precision);
            let sum = mu.clone() * T::rational(&linear, precision) + rest;
            if diagonal { mu.square() + sum } else { sum }
        })
    }
}

/// ⟨v, w⟩ = Σ v_i w_i, exactly.
#[must_use]
pub fn dot(v: &[RBig; 3], w: &[RBig; 3]) -> RBig {
    &v[0] * &w[0] + &v[1] * &w[1] + &v[2] * &w[2]
}
