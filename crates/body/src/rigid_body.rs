//! A heavy rigid body as it was given, exact: by principal moments and centre of mass, or by a tensor.

use std::sync::Arc;

use bifdiag_numbers::symmetric::{Real, Symmetric, dot};
use bifdiag_numbers::{Number, ParseNumberError};
use bifdiag_schema::Flags;
use dashu_ratio::RBig;
use thiserror::Error;

/// A heavy rigid body with a fixed point: A = diag(A1, A2, A3) and the centre of mass r, multiplied by the weight m g.
/// Validated once; all values are exact, except for a body given by a [`Tensor`] whose principal form is irrational.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    moments: [Number; 3],
    center: [Number; 3],
    origin: Option<Origin>,
}

/// A tensor that is not diagonal, and whether moments and r are rounded.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Origin {
    tensor: Arc<Tensor>,
    is_rounded: bool,
}

/// Why three moments and a centre of mass are not a body.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum BodyError {
    /// A moment of inertia is zero or negative.
    #[error("A{axis} = {value} is not positive; a moment of inertia must be greater than zero")]
    MomentNotPositive {
        /// 1, 2 or 3.
        axis: usize,
        /// The moment as given.
        value: String,
    },
    /// A has a number of moments other than three.
    #[error("A needs three moments of inertia, {count} given")]
    MomentCount {
        /// How many were given.
        count: usize,
    },
    /// r has a number of coordinates other than three.
    #[error("r needs three coordinates, {count} given")]
    CenterCount {
        /// How many were given.
        count: usize,
    },
    /// A component is not a number.
    #[error("{name}{axis}: {source}")]
    Component {
        /// `A` or `r`.
        name: &'static str,
        /// 1, 2 or 3.
        axis: usize,
        /// What is wrong with it.
        source: ParseNumberError,
    },
}

impl Body {
    /// A body from exact numbers.
    ///
    /// # Errors
    /// [`BodyError::MomentNotPositive`] when some A_i ≤ 0.
    pub fn new(moments: [Number; 3], center: [Number; 3]) -> Result<Self, BodyError> {
        for (i, moment) in moments.iter().enumerate() {
            if moment.value() <= &RBig::ZERO {
                return Err(BodyError::MomentNotPositive { axis: i + 1, value: moment.text().to_owned() });
            }
        }
        Ok(Self { moments, center, origin: None })
    }

    /// The body whose moments and centre of mass are those of a tensor.
    pub(super) fn with_tensor(mut self, tensor: Tensor, is_rounded: bool) -> Self {
        self.origin = Some(Origin { tensor: Arc::new(tensor), is_rounded });
        self
    }

    /// The tensor by which the body was given; `None` when it was given in principal axes.
    #[must_use]
    pub fn tensor(&self) -> Option<&Tensor> {
        self.origin.as_ref().map(|origin| &*origin.tensor)
    }

    /// The moments and r are those of the tensor, rounded.
    #[must_use]
    pub fn is_rounded(&self) -> bool {
        self.origin.as_ref().is_some_and(|origin| origin.is_rounded)
    }

    /// r in the axes in which the body was given: those of the tensor, if there is one.
    #[must_use]
    pub fn center_as_given(&self) -> [RBig; 3] {
        let own = || self.center.each_ref().map(|x| x.value().clone());
        self.tensor().map_or_else(own, |tensor| tensor.center.clone())
    }

    /// |r|², exact.
    #[must_use]
    pub fn center_squared(&self) -> RBig {
        match self.tensor() {
            Some(tensor) => tensor.center_squared(),
            None => self.center.iter().fold(RBig::ZERO, |sum, r| sum + r.value() * r.value()),
        }
    }

    /// |r|, exact where it is rational, else enclosed.
    #[must_use]
    pub fn center_norm(&self) -> Real {
        /// More than a double has, and than is lost where h is nearly |r|.
        const DIGITS: usize = 60;
        Real::root_of(&self.center_squared(), DIGITS)
    }

    /// rᵀAr = |r|² J_r, exact.
    #[must_use]
    pub fn weighted_moment(&self) -> RBig {
        let weighted = |k: usize| self.moments[k].value() * self.center[k].value() * self.center[k].value();
        match self.tensor() {
            Some(tensor) => tensor.weighted_moment(),
            None => (0..3).fold(RBig::ZERO, |sum, k| sum + weighted(k)),
        }
    }

    /// Aω in principal axes, with the moments as they are given.
    #[must_use]
    pub fn angular_momentum(&self, omega: &[RBig; 3]) -> [RBig; 3] {
        std::array::from_fn(|k| self.moments[k].value() * &omega[k])
    }

    /// Aω, exact, in the axes in which the body was given: those of the tensor, if there is one.
    #[must_use]
    pub fn angular_momentum_as_given(&self, omega: &[RBig; 3]) -> [RBig; 3] {
        self.tensor().map_or_else(|| self.angular_momentum(omega), |tensor| tensor.matrix.times(omega))
    }

    /// A body from texts, each a decimal or a rational.
    ///
    /// # Errors
    /// Every [`BodyError`].
    pub fn parse<S: AsRef<str>>(moments: &[S], center: &[S]) -> Result<Self, BodyError> {
        let moments = parse_triple("A", moments, |count| BodyError::MomentCount { count })?;
        let center = parse_triple("r", center, |count| BodyError::CenterCount { count })?;
        Self::new(moments, center)
    }

    /// A body from doubles, each read as its shortest decimal.
    ///
    /// # Errors
    /// [`BodyError::MomentNotPositive`]; [`BodyError::Component`] for NaN, infinities and magnitudes out of range.
    pub fn from_f64(moments: [f64; 3], center: [f64; 3]) -> Result<Self, BodyError> {
        Self::new(numbers_from_f64("A", moments)?, numbers_from_f64("r", center)?)
    }

    /// A1, A2, A3 as given.
    #[must_use]
    pub fn moments(&self) -> &[Number; 3] {
        &self.moments
    }

    /// r1, r2, r3 as given.
    #[must_use]
    pub fn center(&self) -> &[Number; 3] {
        &self.center
    }

    /// The principal moments, rounded.
    #[must_use]
    pub fn moments_f64(&self) -> [f64; 3] {
        self.moments.each_ref().map(Number::to_f64)
    }

    /// The centre of mass, rounded.
    #[must_use]
    pub fn center_f64(&self) -> [f64; 3] {
        self.center.each_ref().map(Number::to_f64)
    }

    /// r = 0: Euler's case.
    #[must_use]
    pub fn is_euler(&self) -> bool {
        self.center.iter().all(|x| x.value().is_zero())
    }

    /// What is special about this body.
    #[must_use]
    pub fn flags(&self) -> Flags {
        let a = self.moments.each_ref().map(Number::value);
        let r = self.center.each_ref().map(Number::value);
        let mut flags = Flags::default();
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            // ∫ x_k² dm = (A_i + A_j − A_k)/2; where it is 0 the centre of mass lies in the plane x_k = 0.
            match (a[i] + a[j]).cmp(a[k]) {
                std::cmp::Ordering::Greater => {}
                std::cmp::Ordering::Equal if r[k].is_zero() => flags.plate = true,
                std::cmp::Ordering::Equal | std::cmp::Ordering::Less => flags.unphysical = true,
            }
            flags.symmetric |= a[i] == a[j];
            flags.plane |= r[k].is_zero();
        }
        if let Some(tensor) = self.tensor() {
            [flags.unphysical, flags.plate] = tensor.existence();
        }
        flags.plate &= !flags.unphysical;
        flags.euler = self.is_euler();
        let moment_of_first = (0..3).find(|&i| !r[i].is_zero()).map(|i| a[i]);
        flags.axis = moment_of_first.is_some_and(|first| (0..3).all(|i| r[i].is_zero() || a[i] == first));
        flags
    }
}

fn parse_triple<S: AsRef<str>>(
    name: &'static str,
    texts: &[S],
    wrong_count: impl Fn(usize) -> BodyError,
) -> Result<[Number; 3], BodyError> {
    let [x, y, z] = texts else {
        return Err(wrong_count(texts.len()));
    };
    let parse =
        |axis: usize, text: &S| text.as_ref().parse().map_err(|source| BodyError::Component { name, axis, source });
    Ok([parse(1, x)?, parse(2, y)?, parse(3, z)?])
}

fn numbers_from_f64(name: &'static str, values: [f64; 3]) -> Result<[Number; 3], BodyError> {
    let number =
        |axis: usize| Number::from_f64(values[axis - 1]).map_err(|source| BodyError::Component { name, axis, source });
    Ok([number(1)?, number(2)?, number(3)?])
}

/// A body that is given by a tensor: the tensor of inertia about the fixed point and r = m g c, in the same axes, neither
/// reduced nor rounded.
///
/// Everything about relative equilibria depends on D(μ) = det(μ − A), N(μ) = rᵀ adj(μ − A) r and J_r = rᵀAr/|r|², which
/// are rational in the entries of a tilted tensor. Symmetry is a gcd (D with D′, N with D), J_r and |r|² are exact. The
/// principal form, in which the rest of the program computes, is exact where it is rational; else its numbers are
/// rounded to [`Tensor::DIGITS`] digits such that symmetries and coincidences hold exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tensor {
    matrix: Symmetric,
    center: [RBig; 3],
}

/// Why a tensor makes no body.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum TensorError {
    /// A leading minor of the tensor is zero or negative.
    #[error(
        "the inertia tensor about the fixed point is not positive definite (its leading {order}x{order} minor is \
         {minor}); no body turns about a fixed point with such a tensor"
    )]
    NotPositiveDefinite {
        /// 1, 2 or 3.
        order: usize,
        /// The minor, rounded.
        minor: String,
    },
    /// A moment or a component of r in principal axes left the range of magnitudes.
    #[error("in principal axes {name}{axis} leaves the supported range: {source}")]
    OutOfRange {
        /// `A` or `r`.
        name: &'static str,
        /// 1, 2 or 3.
        axis: usize,
        /// What is wrong with it.
        source: ParseNumberError,
    },
    /// The numbers of the principal form are not a body.
    #[error(transparent)]
    Body(#[from] BodyError),
}

impl Tensor {
    /// Digits that a rounded principal form keeps: of each moment, of each difference of two moments and of each
    /// component of r. That is finer than 400 bits (120 digits), the highest precision of the proofs for a rounded body, so that
    /// the rounding changes nothing that is decided there.
    pub const DIGITS: usize = 130;

    /// A tensor about the fixed point with r = m g c.
    ///
    /// # Errors
    /// [`TensorError::NotPositiveDefinite`], decided exactly.
    pub fn new(matrix: Symmetric, center: [RBig; 3]) -> Result<Self, TensorError> {
        let minors = matrix.leading_minors();
        match minors.iter().position(|minor| *minor <= RBig::ZERO) {
            None => Ok(Self { matrix, center }),
            Some(at) => {
                let minor = format!("{:e}", minors[at].to_f64().value());
                Err(TensorError::NotPositiveDefinite { order: at + 1, minor })
            }
        }
    }

    /// The matrix.
    #[must_use]
    pub fn matrix(&self) -> &Symmetric {
        &self.matrix
    }

    /// r.
    #[must_use]
    pub fn center(&self) -> &[RBig; 3] {
        &self.center
    }

    /// |r|².
    #[must_use]
    pub fn center_squared(&self) -> RBig {
        dot(&self.center, &self.center)
    }

    /// rᵀAr = |r|² J_r.
    #[must_use]
    pub fn weighted_moment(&self) -> RBig {
        dot(&self.center, &self.matrix.times(&self.center))
    }

    /// Σ r_i²/(A_i − a)ⁿ for n = 1, 2, 3, for a simple moment a across r.
    pub(super) fn sums_at_fork(&self, a: &RBig) -> Option<[RBig; 3]> {
        let v = self.solved_across(a, &self.center)?;
        let w = self.solved_across(a, &v)?;
        Some([-dot(&v, &self.center), dot(&v, &v), -dot(&v, &w)])
    }

    /// The solution x of (a − A)x = v across the axis of a simple moment a, for v across this axis; `None` where a is no
    /// simple moment.
    fn solved_across(&self, a: &RBig, v: &[RBig; 3]) -> Option<[RBig; 3]> {
        // M = a − A has the eigenvalues 0 and two others, m and n, with (m + n − M) M v = m n v for every v across their axis.
        let shifted = self.matrix.subtracted_from(a);
        let product = shifted.adjugate().trace();
        if !shifted.determinant().is_zero() || product.is_zero() {
            return None;
        }
        let image = shifted.times(v);
        Some(std::array::from_fn(|i| (shifted.trace() * &v[i] - &image[i]) / &product))
    }

    /// Whether the body is unphysical, and whether it is a plate. Some distribution of mass has the tensor and r if and only if
    /// the second moments ∫ x xᵀ dm = (tr A / 2) E − A are positive semidefinite and r lies in their range: a plate where
    /// they are singular. As A is positive, their rank is 2 at least, and the adjugate projects onto their kernel.
    #[must_use]
    fn existence(&self) -> [bool; 2] {
        let second = self.matrix.subtracted_from(&(self.matrix.trace() / RBig::from(2)));
        let is_flat = second.determinant().is_zero();
        let in_range = || second.adjugate().times(&self.center).iter().all(RBig::is_zero);
        let exists = second.is_positive_semidefinite() && (!is_flat || in_range());
        [!exists, exists && is_flat]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_must_be_positive() {
        let error = Body::parse(&["2", "0", "1"], &["1", "0", "0"]).unwrap_err();
        assert_eq!(error, BodyError::MomentNotPositive { axis: 2, value: "0".into() });
        let error = Body::from_f64([2.0, 1.0, f64::NAN], [1.0, 0.0, 0.0]).unwrap_err();
        assert!(matches!(error, BodyError::Component { name: "A", axis: 3, .. }));
        assert_eq!(Body::parse(&["2", "1"], &["1", "0"]).unwrap_err(), BodyError::MomentCount { count: 2 });
    }

    #[test]
    fn plates_are_physical_and_decided_exactly() {
        let flags = |a: [&str; 3]| Body::parse(&a, &["0", "1", "0"]).unwrap().flags();
        assert!(flags(["0.3", "0.1", "0.2"]).plate);
        assert!(!flags(["0.3", "0.1", "0.2"]).unphysical);
        assert!(flags(["0.3000000000000000000001", "0.1", "0.2"]).unphysical);
        assert!(!flags(["2", "1.1", "1"]).plate);
    }

    /// For some mass m, with r = m c, the second moments J = (tr A / 2) E − A exceed m c cᵀ = r rᵀ/m: J ⪰ 0 and r in its range.
    #[test]
    fn a_body_exists_where_its_second_moments_hold_its_centre() {
        let values = |numbers: &[Number; 3]| numbers.each_ref().map(|x| x.value().clone());
        for a in [["1", "1", "2"], ["3", "2", "1"], ["1", "2", "1"], ["2", "1", "1"], ["1", "1", "3"], ["2", "2", "3"]]
        {
            for bits in 0..8_usize {
                let r: [&str; 3] = std::array::from_fn(|k| if bits >> k & 1 == 1 { "1/3" } else { "0" });
                let body = Body::parse(&a, &r).unwrap();
                let [a, r] = [values(body.moments()), values(body.center())];
                let twice_j: [RBig; 3] = std::array::from_fn(|k| &a[(k + 1) % 3] + &a[(k + 2) % 3] - &a[k]);
                let exists = (0..3).all(|k| twice_j[k] > RBig::ZERO || (twice_j[k].is_zero() && r[k].is_zero()));
                let is_flat = twice_j.iter().any(RBig::is_zero);
                let flags = body.flags();
                assert_eq!([flags.unphysical, flags.plate], [!exists, exists && is_flat], "{a:?} {r:?}");
                let matrix = Symmetric::diagonal(a);
                let tensor = Tensor::new(matrix, r).unwrap();
                assert_eq!(tensor.existence(), [flags.unphysical, flags.plate]);
            }
        }
    }

    #[test]
    fn special_bodies_are_flagged() {
        let flags = |a: [&str; 3], r: [&str; 3]| Body::parse(&a, &r).unwrap().flags();
        assert!(flags(["1", "1", "1"], ["1", "2", "3"]).axis);
        assert!(flags(["1", "1", "2"], ["1", "2", "0"]).axis);
        assert!(!flags(["1", "1", "2"], ["1", "2", "3"]).axis);
        assert!(flags(["1", "1", "2"], ["0", "0", "0"]).euler);
        assert!(!flags(["1", "1", "2"], ["0", "0", "0"]).axis);
        assert!(!flags(["3", "1", "2.5"], ["1", "1", "1"]).degenerate());
    }
}
