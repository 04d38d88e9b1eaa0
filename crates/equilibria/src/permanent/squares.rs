//! The eigenvalues of the linearised flow through their squares.

/// The two values of λ².
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Squares {
    /// Real: negative ones are frequencies, positive ones rates of growth.
    Real([f64; 2]),
    /// re ± i im.
    Conjugate {
        /// Real part.
        re: f64,
        /// Imaginary part, positive.
        im: f64,
    },
}

impl Squares {
    /// The frequencies |Im λ|, in rad over the unit of time, and the largest rate of growth Re λ.
    #[must_use]
    pub fn frequencies_and_growth(&self) -> ([f64; 2], f64) {
        match *self {
            Self::Real(squares) => {
                let frequency = |x: f64| (-x).max(0.0).sqrt();
                (squares.map(frequency), squares.into_iter().fold(0.0, f64::max).sqrt())
            }
            Self::Conjugate { re, im } => {
                let modulus = (re * re + im * im).sqrt();
                // The smaller part from the product of both, im/2.
                let large = (0.5 * (modulus + re.abs())).sqrt();
                let small = 0.5 * im / large;
                let (frequency, growth) = if re > 0.0 { (small, large) } else { (large, small) };
                ([frequency, frequency], growth)
            }
        }
    }
}
