//! Natural numbers of N words, by rising significance: the arithmetic under `ball`.

pub(super) type Words<const N: usize> = [u64; N];

const BITS: usize = u64::BITS as usize;

/// a + b; the highest bit beyond N words apart.
pub(super) fn sum<const N: usize>(a: &Words<N>, b: &Words<N>) -> (Words<N>, bool) {
    let (mut sum, mut carry) = ([0; N], false);
    for k in 0..N {
        (sum[k], carry) = a[k].carrying_add(b[k], carry);
    }
    (sum, carry)
}

/// |a − b|, and whether a < b.
pub(super) fn difference<const N: usize>(a: &Words<N>, b: &Words<N>) -> (Words<N>, bool) {
    let is_less = a.iter().rev().lt(b.iter().rev());
    let (a, b) = if is_less { (b, a) } else { (a, b) };
    let (mut difference, mut borrow) = ([0; N], false);
    for k in 0..N {
        (difference[k], borrow) = a[k].borrowing_sub(b[k], borrow);
    }
    (difference, is_less)
}

/// The low and the high words of ab.
pub(super) fn product<const N: usize>(a: &Words<N>, b: &Words<N>) -> [Words<N>; 2] {
    let (mut low, mut high) = ([0; N], [0; N]);
    for i in 0..N {
        let mut carry = 0;
        for j in 0..N {
            let word = if i + j < N { &mut low[i + j] } else { &mut high[i + j - N] };
            (*word, carry) = a[i].carrying_mul_add(b[j], *word, carry);
        }
        high[i] = carry;
    }
    [low, high]
}

pub(super) fn leading_zeros<const N: usize>(a: &Words<N>) -> usize {
    let words = a.iter().rev().take_while(|&&word| word == 0).count();
    a.iter().rev().nth(words).map_or(N * BITS, |word| words * BITS + word.leading_zeros() as usize)
}

/// 2a + 1 or 2a, which fits.
pub(super) fn doubled<const N: usize>(a: &Words<N>, one: u64) -> Words<N> {
    std::array::from_fn(|k| a[k] << 1 | if k == 0 { one } else { a[k - 1] >> (BITS - 1) })
}

/// ⌊a/2ˢ⌋
pub(super) fn down<const N: usize>(a: &Words<N>, shift: usize) -> Words<N> {
    let (words, bits) = (shift / BITS, shift % BITS);
    let word = |k: usize| a.get(k).copied().unwrap_or(0);
    let carried = |word: u64| if bits == 0 { 0 } else { word << (BITS - bits) };
    std::array::from_fn(|k| word(k + words) >> bits | carried(word(k + words + 1)))
}

/// 2ˢa, which fits.
pub(super) fn up<const N: usize>(a: &Words<N>, shift: usize) -> Words<N> {
    let (words, bits) = (shift / BITS, shift % BITS);
    let word = |k: Option<usize>| k.map_or(0, |k| a[k]);
    let carried = |word: u64| if bits == 0 { 0 } else { word >> (BITS - bits) };
    std::array::from_fn(|k| word(k.checked_sub(words)) << bits | carried(word(k.checked_sub(words + 1))))
}
