//! The whole linearisation on (γ, l) space, and its eigenvalues from faer: the path that shares nothing with
//! the closed form.

use nalgebra::Complex;
use thiserror::Error;

use super::RelativeEquilibrium;
use bifdiag_body::Frame;
use bifdiag_numbers::vector::cross;

/// Why the eigenvalues of the whole linearisation could not be had.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SpectrumError {
    /// The QR iteration did not converge.
    #[error("the eigenvalue iteration of the 6×6 linearisation did not converge")]
    NoConvergence,
}

/// The 6×6 matrix of δγ̇ = δγ×ω + γ×δω, δl̇ = δl×ω + l×δω − δγ×r, with δω = A⁻¹δl; rows and columns are (γ, l).
#[must_use]
pub fn whole_matrix(frame: &Frame, point: &RelativeEquilibrium) -> [[f64; 6]; 6] {
    let omega = point.gamma.map(|x| point.omega * x);
    let l: [f64; 3] = std::array::from_fn(|j| frame.a[j] * omega[j]);
    let mut matrix = [[0.0; 6]; 6];
    for column in 0..3 {
        let mut unit = [0.0; 3];
        unit[column] = 1.0;
        let turned = cross(unit, omega);
        let weight = cross(unit, frame.r);
        let tilt = cross(point.gamma, unit);
        let drag = cross(l, unit);
        for row in 0..3 {
            matrix[row][column] = turned[row];
            matrix[row + 3][column] = -weight[row];
            matrix[row][column + 3] = tilt[row] / frame.a[column];
            matrix[row + 3][column + 3] = turned[row] + drag[row] / frame.a[column];
        }
    }
    matrix
}

/// The six eigenvalues of [`whole_matrix`], two of which are zero but for rounding.
///
/// # Errors
/// [`SpectrumError::NoConvergence`].
pub fn whole_spectrum(frame: &Frame, point: &RelativeEquilibrium) -> Result<Vec<Complex<f64>>, SpectrumError> {
    let matrix = whole_matrix(frame, point);
    let eigenvalues = faer::Mat::from_fn(6, 6, |row, column| matrix[row][column])
        .eigenvalues()
        .map_err(|_no_convergence| SpectrumError::NoConvergence)?;
    Ok(eigenvalues.into_iter().map(|x| Complex::new(x.re, x.im)).collect())
}
