//! A relative equilibrium with the numbers that its linearisation needs.

use bifdiag_body::Frame;

/// A solution of sAγ + r = λγ, |γ| = 1, s = Ω², in the coordinates of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeEquilibrium {
    /// The vertical γ, |γ| = 1.
    pub gamma: [f64; 3],
    /// Angular velocity Ω ≥ 0 about γ.
    pub omega: f64,
    /// The gaps B_j = λ − sA_j = s(μ − A_j), so that B_j γ_j = r_j. They are kept beside γ because their differences
    /// s(A_i − A_j) are known without cancellation while λ − sA_j, taken literally, is lost to rounding at large Ω.
    pub gap: [f64; 3],
}

impl RelativeEquilibrium {
    /// The gaps from γ and Ω: the smallest r_j/γ_j fixes one of them, s(A_i − A_j) the others.
    ///
    /// The zeros of γ carry structure: where r_j = 0, γ_j = 0 says that the point lies in the symmetry plane and
    /// γ_j ≠ 0 that B_j = 0 (a symmetric pair, or a principal axis of a body with r = 0).
    #[must_use]
    pub fn new(frame: &Frame, gamma: [f64; 3], omega: f64) -> Self {
        let (anchor, gap) = anchor_of(frame, &gamma);
        let s = omega * omega;
        Self { gamma, omega, gap: std::array::from_fn(|j| gap + s * frame.diff[anchor][j]) }
    }

    /// J = ⟨γ, Aγ⟩.
    #[must_use]
    pub fn moment(&self, frame: &Frame) -> f64 {
        (0..3).map(|j| frame.a[j] * self.gamma[j] * self.gamma[j]).sum()
    }

    /// l = ΩJ.
    #[must_use]
    pub fn l(&self, frame: &Frame) -> f64 {
        self.omega * self.moment(frame)
    }

    /// h = Ω²J/2 − ⟨γ, r⟩.
    #[must_use]
    pub fn h(&self, frame: &Frame) -> f64 {
        let potential: f64 = (0..3).map(|j| self.gamma[j] * frame.r[j]).sum();
        0.5 * self.omega * self.omega * self.moment(frame) - potential
    }
}

/// The axis with the smallest gap |r_j/γ_j|, and that gap.
fn anchor_of(frame: &Frame, gamma: &[f64; 3]) -> (usize, f64) {
    let gap = |j: usize| if frame.r[j] == 0.0 { 0.0 } else { frame.r[j] / gamma[j] };
    let mut anchor = None;
    for j in (0..3).filter(|&j| gamma[j] != 0.0) {
        let smaller = |i: usize| {
            let (new, old) = (gap(j).abs(), gap(i).abs());
            new < old || (new == old && gamma[j].abs() > gamma[i].abs())
        };
        if anchor.is_none_or(smaller) {
            anchor = Some(j);
        }
    }
    anchor.map_or((0, f64::NAN), |i| (i, gap(i)))
}
