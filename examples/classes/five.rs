//! The search for a fifth maximum of U.
//!
//! Maxima lie on the branches μ < A1 and A1 < μ < A2 alone, and kinds change at the folds of x(μ) only. With w_i proportional to
//! r_i²/(μ − A_i)², Σ w_i = 1 and J = Σ A_i w_i,
//! d ln x/dμ = (1/J) Σ w_i (3J − 4A_i)/(μ − A_i). On the first branch x rises from 0 to ∞, on the second it falls from ∞
//! and rises to ∞ again; five maxima at one l need seven folds: six on the first, or four there and three on the second.
//! The *swing* measures how far a body is from that many: the largest θ for which the slope, over the sum of its terms'
//! sizes, is beyond θ to the one and the other side by turns. It is positive exactly if the folds are there (as far as a
//! grid shows). An evolution strategy (one parent, one child, the 1/5 rule) makes it as large as it can. Nothing is shared
//! with the program.

/// Slopes of x along both branches, between −1 and 1, in the direction of rising μ.
fn slopes(a: [f64; 3], r: [f64; 3]) -> [Vec<f64>; 2] {
    const POINTS: usize = 320;
    let slope = |offsets: [f64; 3]| {
        // μ − A_i, which no cancellation spoils.
        let gamma: [f64; 3] = std::array::from_fn(|i| r[i] / offsets[i]);
        let q = gamma.map(|x| x * x);
        let p: f64 = q.iter().sum();
        let j = q.iter().zip(a).map(|(q, a)| a * q).sum::<f64>() / p;
        let terms: [f64; 3] = std::array::from_fn(|i| q[i] / p * (3.0 * j - 4.0 * a[i]) / offsets[i]);
        let size: f64 = (0..3).map(|i| q[i] / p * (3.0 * j + 4.0 * a[i]) / offsets[i].abs()).sum();
        terms.iter().sum::<f64>() / size
    };
    let share = |k: usize| (k as f64 + 0.5) / POINTS as f64;
    let first = |k| {
        let y = libm::exp(12.0 - 52.0 * share(k));
        slope([-y, -(y + a[1] - a[0]), -(y + a[2] - a[0])])
    };
    let second = |k| {
        let t = 40.0 * share(k) - 20.0;
        let (low, high) = (1.0 / (1.0 + libm::exp(-t)), 1.0 / (1.0 + libm::exp(t)));
        let gap = a[1] - a[0];
        slope([gap * low, -gap * high, -(gap * high + a[2] - a[1])])
    };
    [(0..POINTS).map(first).collect(), (0..POINTS).map(second).collect()]
}

/// The largest θ so that the slopes reach beyond −θ, θ, −θ, … in this order, `turns` times in all.
fn swing(slopes: &[f64], first_sign: f64, turns: usize) -> f64 {
    let mut reached = vec![f64::NEG_INFINITY; turns];
    for slope in slopes {
        for turn in (0..turns).rev() {
            let sign = if turn % 2 == 0 { first_sign } else { -first_sign };
            let before = if turn == 0 { f64::INFINITY } else { reached[turn - 1] };
            reached[turn] = reached[turn].max(before.min(sign * slope));
        }
    }
    reached.last().copied().unwrap_or(f64::INFINITY)
}

/// The swing for these numbers of folds on the two branches.
fn folds_swing([first, second]: &[Vec<f64>; 2], folds: [usize; 2]) -> f64 {
    // The first branch ends rising as it begins, the second begins falling and ends rising.
    let on_first = swing(first, -1.0, folds[0].saturating_sub(1));
    on_first.min(swing(second, 1.0, folds[1].saturating_sub(1)))
}

/// A1 = 1 and the others by their gaps, r3 = 1; bodies that exist have A3 ≤ A1 + A2.
fn body(y: [f64; 4], exists: bool) -> [[f64; 3]; 2] {
    let gap = if exists { 1.0 / (1.0 + libm::exp(-y[1])) } else { libm::exp(y[1]) };
    let second = 1.0 + libm::exp(y[0]);
    [[1.0, second, second + gap], [libm::exp(y[2]), libm::exp(y[3]), 1.0]]
}

struct Random(u64);

impl Random {
    /// Between 0 and 1 (`splitmix64`).
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * libm::log(1.0 - self.next())).sqrt() * libm::cos(std::f64::consts::TAU * self.next())
    }
}

/// One run: the best swing and its body.
fn climb(random: &mut Random, steps: u64, folds: [usize; 2], exists: bool) -> (f64, [f64; 4]) {
    const RANGES: [[f64; 2]; 4] = [[-12.0, 6.0], [-8.0, 8.0], [-25.0, 4.0], [-14.0, 4.0]];
    let value = |y: [f64; 4]| {
        let inside = y.iter().zip(RANGES).all(|(y, [from, to])| (from..=to).contains(y));
        let [a, r] = body(y, exists);
        if inside { folds_swing(&slopes(a, r), folds) } else { f64::NEG_INFINITY }
    };
    let mut y = RANGES.map(|[from, to]| from + (to - from) * random.next());
    let (mut best, mut width) = (value(y), 1.0);
    for _ in 0..steps {
        let next = y.map(|y| y + width * random.normal());
        let found = value(next);
        if found >= best {
            (y, best) = (next, found);
            width *= 1.5;
        } else {
            width *= 0.904;
        }
        width = f64::clamp(width, 1e-9, 3.0);
    }
    (best, y)
}

/// Prints for each number of folds how far the search came.
pub fn five([seed, runs, steps]: [u64; 3]) {
    println!("{runs} runs of {steps} bodies each, seed {seed}; folds on μ < A1 and on A1 < μ < A2");
    for exists in [true, false] {
        // The first four are controls: they occur.
        for folds in [[2, 1], [4, 1], [0, 3], [2, 3], [4, 3], [6, 1]] {
            let mut random = Random(seed);
            let found = (0..runs).map(|_| climb(&mut random, steps, folds, exists));
            let all: Vec<(f64, [f64; 4])> = found.collect();
            let shown = all.iter().filter(|(swing, _)| *swing > 0.0).count();
            let best = all.iter().max_by(|p, q| p.0.total_cmp(&q.0));
            let Some((swing, [a, r])) = best.map(|(swing, y)| (swing, body(*y, exists))) else { continue };
            let whose = if exists { "bodies that exist" } else { "all A > 0" };
            println!(
                "{whose}, {} and {} folds: {shown} runs show them; largest swing {swing:+.3e} at A = {a:?}, r = {r:?}",
                folds[0], folds[1]
            );
        }
    }
}
