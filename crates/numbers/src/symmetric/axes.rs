//! Principal axes, and the components of a vector along them.

use dashu_ratio::RBig;

use super::eigenvalue::{Eigenvalue, Real};
use super::matrix::{Symmetric, dot};
use crate::enclosure::{Arithmetic, Enclosure};
use crate::vector::{self, cross, normalised};
use crate::wide::Wide;

/// A symmetric matrix in its principal axes, with a vector.
///
/// A diagonal matrix keeps its axes in their order. Else the eigenvalues ascend; each axis points so that its largest
/// coordinate is positive, the last one so that the three are right-handed; inside the plane of a double eigenvalue the
/// first axis lies along the vector's projection.
#[derive(Clone, Debug)]
pub struct PrincipalAxes {
    /// The eigenvalues; they ascend unless the matrix was diagonal.
    pub values: [Real; 3],
    /// The components of the vector; exactly 0 where it is orthogonal to an axis.
    pub components: [Real; 3],
    /// The squares of the components, where they are rational.
    pub squares: [Option<RBig>; 3],
    /// Row k is axis k, a unit vector within rounding.
    pub axes: [[f64; 3]; 3],
}

impl PrincipalAxes {
    /// Principal axes; what is irrational, and each difference of two eigenvalues, is known to `digits` decimal digits.
    #[must_use]
    pub fn new(matrix: &Symmetric, vector: &[RBig; 3], digits: usize) -> Self {
        if matrix.is_diagonal() {
            return Self {
                values: std::array::from_fn(|k| Real::exact(matrix.rows()[k][k].clone())),
                components: vector.clone().map(Real::exact),
                squares: vector.each_ref().map(|x| Some(x * x)),
                axes: std::array::from_fn(|k| std::array::from_fn(|i| f64::from(u8::from(i == k)))),
            };
        }
        let eigenvalues = matrix.eigenvalues();
        match <[Eigenvalue; 3]>::try_from(eigenvalues) {
            Ok(simple) => Self::simple(matrix, simple, vector, digits),
            Err(eigenvalues) => Self::symmetric(matrix, &eigenvalues, vector, digits),
        }
        .right_handed()
    }

    /// Three simple eigenvalues.
    fn simple(matrix: &Symmetric, mut eigenvalues: [Eigenvalue; 3], vector: &[RBig; 3], digits: usize) -> Self {
        let resolvent = matrix.resolvent(vector);
        let vanishes = eigenvalues.each_ref().map(|eigenvalue| eigenvalue.is_root_of(&resolvent));
        let mut bits = 64 + 7 * digits / 2;
        loop {
            let values = eigenvalues.each_mut().map(|eigenvalue| eigenvalue.enclosed(bits));
            let lines: Option<Vec<Line>> =
                (0..3).map(|k| Line::new(matrix, &values[k], vector, vanishes[k], bits, digits)).collect();
            let apart = (0..2).all(|k| {
                let gap = Real { lo: &values[k + 1].lo - &values[k].hi, hi: &values[k + 1].hi - &values[k].lo };
                gap.lo > RBig::ZERO && gap.is_known_to(digits)
            });
            if let (Some(lines), true) = (lines, apart && values.iter().all(|value| value.is_known_to(digits))) {
                let [x, y, z] = <[Line; 3]>::try_from(lines).unwrap_or_else(|_| unreachable!("three axes"));
                let mut squares = [x.square, y.square, z.square];
                if let Some(equal) = equal_squares(matrix, vector, &values, &squares) {
                    squares = squares.map(|square| square.or_else(|| Some(equal.clone())));
                }
                return Self {
                    values,
                    axes: [x.axis, y.axis, z.axis],
                    components: [x.component, y.component, z.component],
                    squares,
                };
            }
            bits *= 2;
        }
    }

    /// A double eigenvalue and a simple one, both rational.
    fn symmetric(matrix: &Symmetric, eigenvalues: &[Eigenvalue], vector: &[RBig; 3], digits: usize) -> Self {
        let single = usize::from(eigenvalues[0].multiplicity > 1);
        let value = |k: usize| eigenvalues[k].rational().unwrap_or(RBig::ZERO);
        let own = column(matrix, &value(single));
        let squared = dot(&own, &own);
        let overlap = dot(&own, vector);
        let along_squared = &overlap * &overlap / &squared;
        let along = signed(Real::root_of(&along_squared, digits), &overlap);
        let across: [RBig; 3] = std::array::from_fn(|i| &vector[i] - &overlap * &own[i] / &squared);
        let across_squared = dot(&across, &across);
        let length = Real::root_of(&across_squared, digits);
        let axis = oriented(unit(&own));
        let along = if axis_follows(&axis, &own) { along } else { along.negated() };
        let lead = if across.iter().all(RBig::is_zero) { orthogonal_to(&axis) } else { unit(&across) };
        let third = cross(axis, lead);
        let (zero, double) = (Real::exact(RBig::ZERO), Real::exact(value(1 - single)));
        let simple = Real::exact(value(single));
        if single == 0 {
            let values = [simple, double.clone(), double];
            let squares = [along_squared, across_squared, RBig::ZERO].map(Some);
            Self { values, components: [along, length, zero], squares, axes: [axis, lead, third] }
        } else {
            let values = [double.clone(), double, simple];
            let squares = [across_squared, RBig::ZERO, along_squared].map(Some);
            Self { values, components: [length, zero, along], squares, axes: [lead, third, axis] }
        }
    }

    /// Turns the axis that may be turned: the last, or the one of a pair that carries nothing.
    fn right_handed(mut self) -> Self {
        let [x, y, z] = self.axes;
        if vector::dot(cross(x, y), z) < 0.0 {
            let last = if self.values[0] == self.values[1] { 1 } else { 2 };
            self.axes[last] = self.axes[last].map(|x| -x);
            self.components[last] = self.components[last].negated();
        }
        self
    }
}

/// The square of both components along two axes with irrational eigenvalues, if they are equal. Else it is irrational, like the
/// eigenvalues: the squares are conjugate, too. With q = v_i² + v_j² and m = (a_i + a_j)/2, which are rational, they are equal if
/// and only if a_i v_i² + a_j v_j² = m q.
fn equal_squares(
    matrix: &Symmetric,
    vector: &[RBig; 3],
    values: &[Real; 3],
    squares: &[Option<RBig>; 3],
) -> Option<RBig> {
    let Some(k) = values.iter().position(Real::is_exact) else {
        // Three conjugate ones: they are equal if A and A² have the same mean over v as over all directions.
        let (squared, turned) = (dot(vector, vector), matrix.times(vector));
        let third = |trace: RBig| trace * &squared / RBig::from(3);
        let square_trace = matrix.rows().iter().flatten().fold(RBig::ZERO, |sum, x| sum + x * x);
        let is_mean = dot(vector, &turned) == third(matrix.trace()) && dot(&turned, &turned) == third(square_trace);
        return is_mean.then(|| squared / RBig::from(3));
    };
    let (value, own) = (&values[k].lo, squares[k].as_ref()?);
    let half = (dot(vector, vector) - own) / RBig::from(2);
    let weighted = dot(vector, &matrix.times(vector)) - value * own;
    (weighted == (matrix.trace() - value) * &half).then_some(half)
}

/// One axis of three, and the vector's component along it.
struct Line {
    axis: [f64; 3],
    component: Real,
    square: Option<RBig>,
}

impl Line {
    /// `None` when `bits` are too few.
    fn new(
        matrix: &Symmetric,
        value: &Real,
        vector: &[RBig; 3],
        vanishes: bool,
        bits: usize,
        digits: usize,
    ) -> Option<Self> {
        if value.is_exact() {
            let own = column(matrix, &value.lo);
            let overlap = dot(&own, vector);
            let square = &overlap * &overlap / dot(&own, &own);
            let length = Real::root_of(&square, digits);
            let axis = oriented(unit(&own));
            let component = signed(length, &overlap);
            let component = if axis_follows(&axis, &own) { component } else { component.negated() };
            return Some(Self { axis, component, square: Some(square) });
        }
        let mu = Wide::rational(&value.lo, bits).hull(&Wide::rational(&value.hi, bits));
        let columns: [[Wide; 3]; 3] = std::array::from_fn(|j| matrix.resolvent_column(&mu, j, bits));
        // adj(μ − A) = D′(μ) v vᵀ: the column with the largest entry on the diagonal is the longest.
        let size = |j: &usize| columns[*j][*j].bounds().map(f64::abs).into_iter().fold(0.0, f64::max);
        let longest = (0..3).max_by(|i, j| size(i).total_cmp(&size(j)))?;
        let own = &columns[longest];
        let norm = own.iter().fold(Wide::small(0, bits), |sum, x| sum + x.square()).sqrt();
        let facing = own[longest].sign()?;
        let unit = own.clone().map(|x| facing.orient(x) / norm.clone());
        let mut axis = [0.0; 3];
        for (to, from) in axis.iter_mut().zip(&unit) {
            let [lo, hi] = from.bounds();
            if hi - lo > 1e-15 {
                return None;
            }
            *to = 0.5 * (lo + hi);
        }
        if vanishes {
            return Some(Self { axis, component: Real::exact(RBig::ZERO), square: Some(RBig::ZERO) });
        }
        let overlap =
            (0..3).fold(Wide::small(0, bits), |sum, i| sum + unit[i].clone() * Wide::rational(&vector[i], bits));
        overlap.strict_sign()?;
        let [lo, hi] = overlap.exact_bounds()?;
        let component = Real { lo, hi };
        component.is_known_to(digits).then_some(Self { axis, component, square: None })
    }
}

/// The longest column of adj(μ − A), an eigenvector of the simple eigenvalue μ.
fn column(matrix: &Symmetric, mu: &RBig) -> [RBig; 3] {
    let adjugate = matrix.subtracted_from(mu).adjugate();
    let size = |j: &usize| adjugate.rows()[*j][*j].clone() * &adjugate.rows()[*j][*j];
    let longest = (0..3).max_by_key(size).unwrap_or(0);
    adjugate.rows()[longest].clone()
}

fn signed(length: Real, sign: &RBig) -> Real {
    if *sign < RBig::ZERO { length.negated() } else { length }
}

/// v / |v|, rounded.
fn unit(v: &[RBig; 3]) -> [f64; 3] {
    let magnitude = |x: &RBig| x.clone().max(-x.clone());
    let largest = v.iter().map(magnitude).fold(RBig::ZERO, RBig::max);
    normalised(v.each_ref().map(|x| (x / &largest).to_f64().value()))
}

/// With its largest coordinate positive.
fn oriented(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0_f64, |largest, &x| if x.abs() > largest.abs() { x } else { largest });
    if largest < 0.0 { v.map(|x| -x) } else { v }
}

/// Whether a unit vector points as an exact multiple of it.
fn axis_follows(axis: &[f64; 3], own: &[RBig; 3]) -> bool {
    (0..3).fold(0.0, |sum, i| sum + axis[i] * unit(own)[i]) > 0.0
}

/// A unit vector orthogonal to this one.
fn orthogonal_to(axis: &[f64; 3]) -> [f64; 3] {
    let least = (0..3).min_by(|&i, &j| axis[i].abs().total_cmp(&axis[j].abs())).unwrap_or(0);
    let mut v = axis.map(|x| -x * axis[least]);
    v[least] += 1.0;
    normalised(v)
}
