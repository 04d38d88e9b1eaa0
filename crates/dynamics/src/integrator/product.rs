//! a·b + c as this machine does it best.

#![expect(clippy::inline_always, reason = "lanes must be inlined into the function compiled for their instructions")]

use pulp::Simd;

/// WebAssembly has no fused multiply-add, and in software it makes a section eighty times slower. There products are
/// rounded, so that its bits are its own.
const FUSED: bool = cfg!(not(target_family = "wasm"));

/// Sums with a product in every lane.
pub(crate) trait ProductSum: Simd {
    /// a·b + c.
    #[inline(always)]
    fn product_sum(self, a: Self::f64s, b: Self::f64s, c: Self::f64s) -> Self::f64s {
        if FUSED { self.mul_add_f64s(a, b, c) } else { self.add_f64s(self.mul_f64s(a, b), c) }
    }

    /// c − a·b.
    #[inline(always)]
    fn product_difference(self, a: Self::f64s, b: Self::f64s, c: Self::f64s) -> Self::f64s {
        if FUSED { self.negate_mul_add_f64s(a, b, c) } else { self.sub_f64s(c, self.mul_f64s(a, b)) }
    }
}

impl<S: Simd> ProductSum for S {}

/// a·b + c of single numbers.
#[inline(always)]
pub(crate) fn product_sum(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}
