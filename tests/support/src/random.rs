//! SplitMix64: the same numbers on every machine.

/// Steele, Lea and Flood (2014).
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// Uniform in [lo, hi).
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// 10 to a power that is uniform in [lo, hi).
    pub fn power_of_ten(&mut self, lo: f64, hi: f64) -> f64 {
        // The series keeps the numbers the same on every machine.
        let x = self.between(lo, hi) * std::f64::consts::LN_10;
        let halvings = 8;
        let small = x / f64::from(1 << halvings);
        let series = (1..=12).rev().fold(1.0, |sum, n| 1.0 + sum * small / f64::from(n));
        (0..halvings).fold(series, |power, _| power * power)
    }

    /// 0, …, count − 1.
    pub fn index(&mut self, count: usize) -> usize {
        usize::try_from(self.next_u64() % count as u64).expect("smaller than count")
    }

    /// +1 or −1.
    pub fn sign(&mut self) -> f64 {
        if self.next_u64() & 1 == 0 { 1.0 } else { -1.0 }
    }

    /// A unit vector, uniform on the sphere.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = [self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0)];
            let n = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
            if (0.1..=1.0).contains(&n) {
                return v.map(|x| x / n);
            }
        }
    }
}
