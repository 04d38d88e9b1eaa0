//! The whole linearisation on (γ, l) space and its eigenvalues by iteration, from faer: the path that shares nothing with
//! the closed form.

use bifdiag_body::Frame;
use bifdiag_numbers::vector::cross;
use nalgebra::Complex;

/// The 6×6 matrix of δγ̇ = δγ×ω + γ×δω, δl̇ = δl×ω + l×δω − δγ×r, with δω = A⁻¹δl, at ω = Ωγ; rows and columns are (γ, l).
pub fn matrix(frame: &Frame, gamma: [f64; 3], omega: f64) -> [[f64; 6]; 6] {
    let turning = gamma.map(|x| omega * x);
    let l: [f64; 3] = std::array::from_fn(|j| frame.a[j] * turning[j]);
    let mut matrix = [[0.0; 6]; 6];
    for column in 0..3 {
        let mut unit = [0.0; 3];
        unit[column] = 1.0;
        let turned = cross(unit, turning);
        let weight = cross(unit, frame.r);
        let tilt = cross(gamma, unit);
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

/// The six eigenvalues, two of which are zero but for rounding.
pub fn spectrum(matrix: &[[f64; 6]; 6]) -> Vec<Complex<f64>> {
    let eigenvalues = faer::Mat::from_fn(6, 6, |row, column| matrix[row][column]).eigenvalues().unwrap();
    eigenvalues.into_iter().map(|x| Complex::new(x.re, x.im)).collect()
}
