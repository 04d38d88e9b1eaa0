//! Taylor series of the Euler–Poisson equations, several orbits a SIMD register.
//!
//! The system is quadratic, so that the coefficients follow from nine Cauchy products (six of γ×ω, three of
//! l×ω; Proposition 12.1 of docs/algorithms.md). The order follows from the tolerance, the step of each lane from its
//! own last two coefficients (Jorba and Zou, Experimental Mathematics 14 (2005) 99–117).
//!
//! **Same bits everywhere.** Lanes never mix, every product-sum is a fused multiply-add and is summed in one
//! fixed order, so that an orbit does not depend on its lane, its neighbours, the thread or the instruction
//! set. Without hardware FMA the fused operation is done in software, about fifty times slower.
//!
//! **Why `pulp`.** It is in the tree already (faer uses it), dispatches at run time and wraps the intrinsics
//! safely, so that this crate stays free of unsafe code. Plain `[f64; N]` loops under `#[target_feature]`
//! were measured at half the speed: the superword vectoriser mixes components across lanes.

#![expect(clippy::inline_always, reason = "lanes must be inlined into the function compiled for their instructions")]

mod lanes;
mod moments;
mod series;
mod step_size;
mod stepper;
mod tangent;
mod transport;

pub(crate) use lanes::{Lanes, magnitude, state_of};
pub(crate) use moments::{MOMENTS, Moments};
pub(crate) use series::{LaneVector, ROWS, lane_values, lane_values_mut};
pub use step_size::{MAX_ORDER, order_for};
pub use stepper::{DEFAULT_TOLERANCE, Taylor, ToleranceError, check_tolerance};
pub(crate) use tangent::TangentLanes;
pub use transport::{Transport, transport};

use pulp::Arch;

/// Which SIMD instructions to use. The results are the same, bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InstructionSet {
    /// The best that this processor has.
    #[default]
    Best,
    /// 8 lanes: AVX-512 (F, BW, CD, DQ, VL).
    Avx512,
    /// 4 lanes: AVX2 with FMA.
    Avx2,
    /// One lane; FMA from the platform's library.
    Baseline,
}

impl InstructionSet {
    /// The sets that this processor has, the best first.
    #[must_use]
    pub fn available() -> Vec<Self> {
        [Self::Avx512, Self::Avx2, Self::Baseline].into_iter().filter(|set| set.arch().is_some()).collect()
    }

    /// None where this processor does not have the instructions.
    #[cfg(target_arch = "x86_64")]
    pub(crate) fn arch(self) -> Option<Arch> {
        match self {
            Self::Best => Some(Arch::new()),
            Self::Avx512 => pulp::x86::V4::try_new().map(Arch::V4),
            Self::Avx2 => pulp::x86::V3::try_new().map(Arch::V3),
            Self::Baseline => Some(Arch::Scalar),
        }
    }

    /// None where this processor does not have the instructions.
    #[cfg(not(target_arch = "x86_64"))]
    pub(crate) fn arch(self) -> Option<Arch> {
        match self {
            Self::Best => Some(Arch::new()),
            Self::Avx512 | Self::Avx2 => None,
            Self::Baseline => Some(Arch::Scalar),
        }
    }
}
