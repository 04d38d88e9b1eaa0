//! A real part: inertia tensor, mass and centre of mass, reduced to principal axes.

use dashu_int::UBig;
use dashu_ratio::RBig;
use thiserror::Error;

use super::rigid_body::{Body, BodyError};
use numbers::{Number, ParseNumberError};

/// The mass properties of a part, as an engineer has them. SI units; all values exact.
///
/// # Convention of the tensor
/// `tensor` holds the **matrix entries** I_xx, I_yy, I_zz, I_xy, I_xz, I_yz of the inertia tensor about the *fixed
/// point*, with I_xy = −∫ x y dm. Programs that print the products of inertia +∫ x y dm need their signs reversed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MassProperties {
    /// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz about the fixed point, in kg m².
    pub tensor: [Number; 6],
    /// The centre of mass from the fixed point, in m.
    pub center_of_mass: [Number; 3],
    /// The mass in kg.
    pub mass: Number,
    /// The acceleration of gravity in m/s².
    pub gravity: Number,
}

/// Whether some distribution of mass has the tensor; decided exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Realizability {
    /// The principal moments violate the triangle inequality.
    pub unphysical: bool,
    /// The principal moments satisfy it with equality.
    pub plate: bool,
    /// The tensor about the fixed point is at least that of the same mass about its centre (parallel axes), and
    /// what remains is physical. Where false, a tensor about the centre of mass was probably given.
    pub parallel_axes: bool,
}

/// A part in its principal axes.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalBody {
    body: Body,
    rotation: [[f64; 3]; 3],
    exact: bool,
    residual: f64,
    realizability: Realizability,
}

/// Why mass properties do not make a body.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum InertiaError {
    /// A leading minor of the tensor is zero or negative.
    #[error(
        "the inertia tensor is not positive definite (its leading {order}x{order} minor is {minor}); give the matrix \
         entries Ixx,Iyy,Izz,Ixy,Ixz,Iyz about the fixed point, with Ixy = -∫ x y dm"
    )]
    NotPositiveDefinite {
        /// 1, 2 or 3.
        order: usize,
        /// The minor, rounded.
        minor: String,
    },
    /// The mass is zero or negative.
    #[error("the mass {value} is not positive; give it in kg")]
    MassNotPositive {
        /// The mass as given.
        value: String,
    },
    /// The acceleration of gravity is negative.
    #[error("the acceleration of gravity {value} is negative; give its magnitude in m/s², such as 9.80665")]
    GravityNegative {
        /// g as given.
        value: String,
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
    /// A principal moment is lost in rounding: the tensor is singular within f64.
    #[error("the inertia tensor is singular within rounding: {0}")]
    Singular(#[source] BodyError),
}

type Matrix = [[f64; 3]; 3];
type ExactMatrix = [[RBig; 3]; 3];

impl MassProperties {
    /// The body in its principal axes, with r = m g Rᵀ c.
    ///
    /// An axis along which both products vanish is kept, and its moment and component of r are exact; a diagonal
    /// tensor so keeps the order of its axes and loses nothing. Other axes are found by Jacobi rotations in f64,
    /// which keep small moments to full relative accuracy, and the result is rounded.
    ///
    /// # Errors
    /// Every [`InertiaError`].
    pub fn to_principal_axes(&self) -> Result<PrincipalBody, InertiaError> {
        if self.mass.value() <= &RBig::ZERO {
            return Err(InertiaError::MassNotPositive { value: self.mass.text().to_owned() });
        }
        if self.gravity.value() < &RBig::ZERO {
            return Err(InertiaError::GravityNegative { value: self.gravity.text().to_owned() });
        }
        let tensor = self.exact_tensor();
        check_positive_definite(&tensor)?;

        let rounded = tensor.each_ref().map(|row| row.each_ref().map(nearest));
        let (moments, rotation) = jacobi(rounded);
        let weight = self.mass.value() * self.gravity.value();
        let principal: [bool; 3] = std::array::from_fn(|k| (0..3).all(|i| i == k || tensor[i][k].is_zero()));
        let mut a = Vec::with_capacity(3);
        let mut r = Vec::with_capacity(3);
        for k in 0..3 {
            let out_of_range = |name| move |source| InertiaError::OutOfRange { name, axis: k + 1, source };
            if principal[k] {
                a.push(exact_number(&tensor[k][k]).map_err(out_of_range("A"))?);
                let component = &weight * self.center_of_mass[k].value();
                r.push(exact_number(&component).map_err(out_of_range("r"))?);
            } else {
                a.push(Number::from_f64(moments[k]).map_err(out_of_range("A"))?);
                let column = rotation.map(|row| row[k]);
                r.push(rounded_number(&(&weight * self.component_along(column))).map_err(out_of_range("r"))?);
            }
        }
        let body = Body::new(triple(a), triple(r)).map_err(InertiaError::Singular)?;
        Ok(PrincipalBody {
            body,
            rotation,
            exact: principal == [true; 3],
            residual: residual(&rounded, &moments, &rotation),
            realizability: self.realizability(&tensor),
        })
    }

    fn exact_tensor(&self) -> ExactMatrix {
        let [xx, yy, zz, xy, xz, yz] = self.tensor.each_ref().map(|x| x.value().clone());
        [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]]
    }

    /// ⟨column, c⟩ with the column's doubles taken as exact.
    fn component_along(&self, column: [f64; 3]) -> RBig {
        column.iter().zip(&self.center_of_mass).fold(RBig::ZERO, |sum, (x, c)| sum + exact(*x) * c.value())
    }

    /// With the second moments S = ∫ x xᵀ dm = (tr I / 2) E − I, a tensor is physical iff S ⪰ 0, a plate iff S is
    /// singular as well; about the centre of mass S loses m c cᵀ and must still be ⪰ 0.
    fn realizability(&self, tensor: &ExactMatrix) -> Realizability {
        let half_trace = (&tensor[0][0] + &tensor[1][1] + &tensor[2][2]) / RBig::from(2);
        let second: ExactMatrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { &half_trace - &tensor[i][j] } else { -tensor[i][j].clone() })
        });
        let c = self.center_of_mass.each_ref().map(Number::value);
        let central: ExactMatrix =
            std::array::from_fn(|i| std::array::from_fn(|j| &second[i][j] - self.mass.value() * c[i] * c[j]));
        let physical = is_positive_semidefinite(&second);
        Realizability {
            unphysical: !physical,
            plate: physical && determinant(&second).is_zero(),
            parallel_axes: is_positive_semidefinite(&central),
        }
    }
}

impl PrincipalBody {
    /// The body: A in kg m², r = m g Rᵀ c in N m; then h is in J and l in kg m²/s.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// R, by rows: column k is principal axis k in the axes of the input, so that v_input = R v_principal.
    /// A proper rotation.
    #[must_use]
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        self.rotation
    }

    /// True when nothing was rounded (the tensor was given diagonal).
    #[must_use]
    pub fn exact(&self) -> bool {
        self.exact
    }

    /// The largest entry of |I − R A Rᵀ|, in kg m².
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// Whether some distribution of mass has the tensor, decided on the tensor as given.
    #[must_use]
    pub fn realizability(&self) -> Realizability {
        self.realizability
    }
}

fn nearest(x: &RBig) -> f64 {
    x.to_f64().value()
}

/// The rational that a finite double is.
fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("entries of a rotation are finite")
}

fn triple(numbers: Vec<Number>) -> [Number; 3] {
    numbers.try_into().expect("three axes give three numbers")
}

/// A number whose text is the exact decimal where there is a short one, else the exact rational.
fn exact_number(x: &RBig) -> Result<Number, ParseNumberError> {
    decimal_text(x).unwrap_or_else(|| x.to_string()).parse()
}

fn rounded_number(x: &RBig) -> Result<Number, ParseNumberError> {
    Number::from_f64(nearest(x))
}

/// The finite decimal expansion of x, if it has one of at most 60 places.
fn decimal_text(x: &RBig) -> Option<String> {
    const MAX_PLACES: usize = 60;
    let ten = RBig::from(10);
    let mut shifted = x.clone();
    let mut places = 0;
    while *shifted.denominator() != UBig::ONE {
        if places == MAX_PLACES {
            return None;
        }
        shifted *= &ten;
        places += 1;
    }
    let digits = shifted.numerator().to_string();
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits.as_str()), |rest| ("-", rest));
    if places == 0 {
        return Some(format!("{sign}{digits}"));
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Some(format!("{sign}{whole}.{fraction}"))
}

fn minor(m: &ExactMatrix, i: usize, j: usize) -> RBig {
    &m[i][i] * &m[j][j] - &m[i][j] * &m[j][i]
}

fn determinant(m: &ExactMatrix) -> RBig {
    let cofactor = |i: usize, j: usize| &m[1][i] * &m[2][j] - &m[1][j] * &m[2][i];
    &m[0][0] * cofactor(1, 2) - &m[0][1] * cofactor(0, 2) + &m[0][2] * cofactor(0, 1)
}

/// Sylvester's criterion, exactly.
fn check_positive_definite(m: &ExactMatrix) -> Result<(), InertiaError> {
    let minors = [m[0][0].clone(), minor(m, 0, 1), determinant(m)];
    match minors.iter().position(|minor| *minor <= RBig::ZERO) {
        None => Ok(()),
        Some(at) => {
            Err(InertiaError::NotPositiveDefinite { order: at + 1, minor: format!("{:e}", nearest(&minors[at])) })
        }
    }
}

/// All principal minors ≥ 0, exactly.
fn is_positive_semidefinite(m: &ExactMatrix) -> bool {
    (0..3).all(|i| m[i][i] >= RBig::ZERO && minor(m, i, (i + 1) % 3) >= RBig::ZERO) && determinant(m) >= RBig::ZERO
}

/// Eigenvalues and eigenvectors (columns) of a positive definite symmetric matrix by cyclic Jacobi rotations.
///
/// Rotations by at most 45°, so that each eigenvector stays nearest to its own axis; zeros stay zeros; the stopping
/// criterion |a_pq| ≤ ε √(a_pp a_qq) gives every eigenvalue, however small, to high relative accuracy (Demmel and
/// Veselić, SIAM J. Matrix Anal. Appl. 13, 1992). Only + − · / √, so the same bits on every machine.
fn jacobi(mut a: Matrix) -> ([f64; 3], Matrix) {
    // Convergence is quadratic; five sweeps are the most that was seen.
    const MAX_SWEEPS: usize = 30;
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let scale = (a[p][p].abs() * a[q][q].abs()).sqrt();
            if a[p][q].abs() <= 0.25 * f64::EPSILON * scale {
                continue;
            }
            rotated = true;
            rotate(&mut a, &mut v, p, q);
        }
        if !rotated {
            break;
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v)
}

/// Annihilates a_pq: t = tan θ is the smaller root of t² + 2 τ t − 1 = 0 with τ = (a_qq − a_pp) / (2 a_pq).
fn rotate(a: &mut Matrix, v: &mut Matrix, p: usize, q: usize) {
    let tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = if tau >= 0.0 { 1.0 } else { -1.0 } / (tau.abs() + (1.0 + tau * tau).sqrt());
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let k = 3 - p - q;
    let (kp, kq) = (a[k][p], a[k][q]);
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
    a[p][k] = a[k][p];
    a[q][k] = a[k][q];
    for row in v {
        let (x, y) = (row[p], row[q]);
        row[p] = c * x - s * y;
        row[q] = s * x + c * y;
    }
}

fn residual(tensor: &Matrix, moments: &[f64; 3], rotation: &Matrix) -> f64 {
    let mut largest: f64 = 0.0;
    for i in 0..3 {
        for j in 0..3 {
            let rebuilt: f64 = (0..3).map(|k| rotation[i][k] * moments[k] * rotation[j][k]).sum();
            largest = largest.max((tensor[i][j] - rebuilt).abs());
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn numbers<const N: usize>(texts: [&str; N]) -> [Number; N] {
        texts.map(|text| text.parse().unwrap())
    }

    fn part(tensor: [&str; 6], center: [&str; 3], mass: &str, gravity: &str) -> MassProperties {
        MassProperties {
            tensor: numbers(tensor),
            center_of_mass: numbers(center),
            mass: mass.parse().unwrap(),
            gravity: gravity.parse().unwrap(),
        }
    }

    #[test]
    fn a_diagonal_tensor_loses_nothing() {
        let part = part(["0.3", "0.1", "0.2", "0", "0", "0"], ["0.05", "-1/3", "0"], "2", "9.81");
        let principal = part.to_principal_axes().unwrap();
        assert!(principal.exact());
        assert_eq!(principal.residual(), 0.0);
        assert_eq!(principal.body().moments().each_ref().map(Number::text), ["0.3", "0.1", "0.2"]);
        assert_eq!(principal.body().center().each_ref().map(Number::text), ["0.981", "-6.54", "0"]);
        assert_eq!(principal.rotation(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }

    #[test]
    fn an_axis_without_products_stays_exact() {
        let part = part(["2", "2", "3", "0.5", "0", "0"], ["0.1", "0.1", "0.7"], "1", "10");
        let principal = part.to_principal_axes().unwrap();
        assert!(!principal.exact());
        let body = principal.body();
        assert_eq!(body.moments_f64(), [1.5, 2.5, 3.0]);
        assert_eq!(body.moments()[2].text(), "3");
        assert_eq!(body.center()[2].text(), "7");
        // The centre of mass lies on the bisector of x and y, which is a principal axis.
        assert_eq!(body.center_f64()[0], 0.0);
        assert!((body.center_f64()[1] - 2f64.sqrt()).abs() < 4.0 * f64::EPSILON);
    }

    #[test]
    fn thirds_stay_rationals() {
        let principal = part(["1", "1", "1", "0", "0", "0"], ["1/3", "0", "0"], "1", "1").to_principal_axes().unwrap();
        assert_eq!(principal.body().center()[0].text(), "1/3");
    }

    #[test]
    fn wrong_mass_properties_are_refused() {
        let good = ["1", "1", "1", "0", "0", "0"];
        let error =
            |tensor, mass, gravity| part(tensor, ["0", "0", "1"], mass, gravity).to_principal_axes().unwrap_err();
        assert_eq!(error(good, "0", "9.81"), InertiaError::MassNotPositive { value: "0".into() });
        assert_eq!(error(good, "1", "-9.81"), InertiaError::GravityNegative { value: "-9.81".into() });
        for (tensor, order) in [
            (["0", "1", "1", "0", "0", "0"], 1),
            (["1", "1", "1", "1", "0", "0"], 2),
            (["1", "1", "1", "0.8", "0.8", "-0.8"], 3),
        ] {
            let InertiaError::NotPositiveDefinite { order: found, .. } = error(tensor, "1", "1") else {
                panic!("{tensor:?} was accepted as positive definite");
            };
            assert_eq!(found, order);
        }
        assert!(matches!(error(good, "1e150", "1e150"), InertiaError::OutOfRange { name: "r", axis: 3, .. }));
    }

    #[test]
    fn what_mass_can_do_is_decided_exactly() {
        let of = |tensor, center| part(tensor, center, "1", "1").to_principal_axes().unwrap().realizability();
        let plate = of(["0.3", "0.1", "0.2", "0", "0", "0"], ["0", "0", "0"]);
        assert_eq!(plate, Realizability { unphysical: false, plate: true, parallel_axes: true });
        assert!(of(["0.3", "0.1", "0.19", "0", "0", "0"], ["0", "0", "0"]).unphysical);
        // The plate with moments 0.1, 0.2, 0.3 in axes turned by 3-4-5: still a plate, although A is rounded.
        let turned = of(["0.164", "0.136", "0.3", "0.048", "0", "0"], ["0", "0", "0"]);
        assert_eq!(turned, plate);
        // A ball of I = 0.4 about its centre, hung 1 m away: the tensor about the fixed point is 1.4.
        let ball = ["1.4", "1.4", "0.4", "0", "0", "0"];
        assert!(of(ball, ["0", "0", "1"]).parallel_axes);
        assert!(!of(["0.4", "0.4", "0.4", "0", "0", "0"], ["0", "0", "1"]).parallel_axes);
    }

    proptest! {
        /// Planted: I = Q diag(a) Qᵀ with a random rotation; the moments come back to relative 1e-13 of the largest,
        /// and nalgebra's solver agrees.
        #[test]
        fn planted_principal_axes_are_found(
            a in prop::array::uniform3(0.1f64..10.0),
            q in prop::array::uniform4(-1.0f64..1.0),
        ) {
            prop_assume!(q.iter().map(|x| x * x).sum::<f64>() > 0.01);
            let rotation = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(q[0], q[1], q[2], q[3]))
                .to_rotation_matrix();
            let tensor = rotation.matrix() * nalgebra::Matrix3::from_diagonal(&a.into()) * rotation.matrix().transpose();
            let symmetric = (tensor + tensor.transpose()) * 0.5;
            let (moments, axes) = jacobi(std::array::from_fn(|i| std::array::from_fn(|j| symmetric[(i, j)])));
            let sorted = |mut m: [f64; 3]| { m.sort_by(f64::total_cmp); m };
            let tolerance = 1e-13 * a.iter().fold(0.0, |m: f64, x| m.max(*x));
            let library: [f64; 3] = symmetric.symmetric_eigen().eigenvalues.into();
            for ((found, planted), library) in sorted(moments).iter().zip(sorted(a)).zip(sorted(library)) {
                prop_assert!((found - planted).abs() < tolerance);
                prop_assert!((found - library).abs() < tolerance);
            }
            let axes = nalgebra::Matrix3::from_fn(|i, j| axes[i][j]);
            prop_assert!((axes.determinant() - 1.0).abs() < 1e-14);
            prop_assert!((axes * nalgebra::Matrix3::from_diagonal(&moments.into()) * axes.transpose() - symmetric).amax() < tolerance);
        }
    }
}
