//! ∫ dm, ∫ x dm and ∫ x xᵀ dm over the inside of a closed surface of triangles, exactly.
//!
//! Coordinates are doubles, hence integers over a common power of two. Over the tetrahedron of the origin and a triangle
//! a, b, c with d = det(a, b, c) and s = a + b + c: ∫ dV = d/6, ∫ x dV = d s/24, ∫ x xᵀ dV = d (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/120.

use bifdiag_numbers::power::times_power_of_two;
use bifdiag_numbers::symmetric::Symmetric;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::surface::Mesh;
use crate::part::mass::{MassError, MassProperties};

/// Integrals over a volume.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VolumeIntegrals {
    /// The volume.
    pub volume: RBig,
    /// ∫ x dV.
    pub first: [RBig; 3],
    /// ∫ x xᵀ dV.
    pub second: Symmetric,
}

/// The pairs of coordinates in the order of [`Symmetric::new`].
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl VolumeIntegrals {
    /// Over the inside of these triangles, which are closed.
    pub(super) fn over(mesh: &Mesh, triangles: &[[usize; 3]]) -> Self {
        let exponent = mesh.corners().iter().flatten().map(|x| parts(*x).1).min().unwrap_or(0);
        let whole = |x: f64| {
            let (mantissa, own) = parts(x);
            IBig::from(mantissa) << usize::try_from(own - exponent).unwrap_or(0)
        };
        let corners: Vec<[IBig; 3]> = mesh.corners().iter().map(|corner| corner.map(whole)).collect();
        let (mut volume, mut first, mut second) = (IBig::ZERO, [IBig::ZERO; 3], [const { IBig::ZERO }; 6]);
        for [a, b, c] in triangles.iter().map(|triangle| triangle.map(|k| &corners[k])) {
            let d = determinant(a, b, c);
            let s: [IBig; 3] = std::array::from_fn(|i| &a[i] + &b[i] + &c[i]);
            for i in 0..3 {
                first[i] += &d * &s[i];
            }
            for (sum, (i, j)) in second.iter_mut().zip(PAIRS) {
                *sum += &d * (&a[i] * &a[j] + &b[i] * &b[j] + &c[i] * &c[j] + &s[i] * &s[j]);
            }
            volume += d;
        }
        // Each coordinate brings one factor 2^exponent.
        let scaled = |sum: IBig, over: i64, degree: i64| {
            times_power_of_two(RBig::from(sum) / RBig::from(over), exponent * degree)
        };
        Self {
            volume: scaled(volume, 6, 3),
            first: first.map(|sum| scaled(sum, 24, 4)),
            second: Symmetric::new(second.map(|sum| scaled(sum, 120, 5))),
        }
    }

    /// The mass properties of a homogeneous body of this density.
    ///
    /// # Errors
    /// [`MassError::NotPositive`].
    pub fn with_density(&self, density: &RBig) -> Result<MassProperties, MassError> {
        let mass = density * &self.volume;
        let com = self.first.each_ref().map(|x| x / &self.volume);
        let central = self.second.plus(&-self.volume.clone(), &Symmetric::outer(&com));
        let tensor = central.subtracted_from(&central.trace()).map(|_, _, x| x * density);
        MassProperties::about_com(mass, com, tensor)
    }

    /// The mass properties of a homogeneous body of this mass.
    ///
    /// # Errors
    /// [`MassError::NotPositive`].
    pub fn with_mass(&self, mass: &RBig) -> Result<MassProperties, MassError> {
        self.with_density(&(mass / &self.volume))
    }
}

/// x = mantissa · 2^exponent with an odd mantissa; exponent 0 for 0, as large as any.
fn parts(x: f64) -> (i64, i64) {
    if x == 0.0 {
        return (0, 0);
    }
    let bits = x.to_bits();
    let biased = i64::try_from((bits >> 52) & 0x7ff).unwrap_or(0);
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    let zeros = mantissa.trailing_zeros();
    let mantissa = i64::try_from(mantissa >> zeros).unwrap_or(0);
    (if x < 0.0 { -mantissa } else { mantissa }, exponent + i64::from(zeros))
}

fn determinant(a: &[IBig; 3], b: &[IBig; 3], c: &[IBig; 3]) -> IBig {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}
