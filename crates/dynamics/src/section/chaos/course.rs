//! An orbit while it is followed: the record of its steps, and the tests of this record.

use super::averages::INTEGRAL;
use super::ladder::NARROW;
use super::verdict::{AGREE, Evidence, OpenReason, OrbitVerdict, verdict};
use crate::field::{norm, sub};

/// Where the two windows of a look begin and end, as parts of the time until then: those of other verdicts.
const PARTS: [f64; 3] = [0.25, 0.625, 1.0];
/// Moments of γ over a piece that are kept: what is left out of an average is of the third order in piece/window.
pub(super) const MOMENTS: usize = 3;
/// The most pieces that are kept of an orbit; then they are joined in pairs. Each look has at least 60 in a window.
const PIECES: usize = 640;
/// Averages apart by no more than this part of the spread at [`SETTLED_LOOKS`] looks in a row are those of a regular orbit,
/// whatever a tangent vector does. Those of an orbit in a thin chaotic layer agree to 1e-4 or 1e-5 for long.
const SETTLED: f64 = 3e-7;
const SETTLED_LOOKS: usize = 2;
/// The growth of a tangent vector counts after this many steps: earlier, chaos of one e-fold in 500 steps would not
/// show.
const GROWTH_FROM: u32 = 1280;
/// Growth within this of a linear one, at [`LINEAR_LOOKS`] looks in a row, is that of a regular orbit, however slowly its averages
/// settle.
const NEARLY_LINEAR: f64 = 0.2;
const LINEAR_LOOKS: usize = 4;
/// Where the averages have settled less closely, growth by no more than this beyond a linear one, at [`AGREE`] looks in a row.
const HARDLY_MORE: f64 = 0.5;
/// ln|δ| beyond which steady growth is chaos although the averages agree now and then by chance, as long as they do not settle.
const VERY_MUCH: f64 = 60.0;

/// What an orbit is, and what showed it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// Regular, chaotic or open.
    pub verdict: OrbitVerdict,
    /// For how long the orbit was followed.
    pub time: f64,
    /// How often S = ⟨ω, r×γ⟩ changed its sign from one step to the next.
    pub crossings: u32,
    /// Steps of the integrator that it took.
    pub steps: u32,
}

/// A piece of an orbit: one step, or several in a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// Time at its begin.
    pub begin: f64,
    pub length: f64,
    /// ∫ (ξ − 1/2)ʲ γ dt over it, ξ from 0 to 1.
    pub moments: [[f64; 3]; MOMENTS],
    /// By how much ln|δ| grew.
    pub growth: f64,
}

impl Piece {
    fn middle(&self) -> f64 {
        self.begin + 0.5 * self.length
    }

    /// This piece and the one behind it as one.
    fn and(&self, next: &Self) -> Self {
        let length = self.length + next.length;
        let middle = self.begin + 0.5 * length;
        let mut moments = [[0.0; 3]; MOMENTS];
        for part in [self, next] {
            // (t − middle)/length = ratio · (t − its own middle)/its own length + shift
            let (ratio, shift) = (part.length / length, (part.middle() - middle) / length);
            for i in 0..3 {
                let zeroth = part.moments[0][i];
                let first = ratio * part.moments[1][i];
                let second = ratio * ratio * part.moments[2][i];
                moments[0][i] += zeroth;
                moments[1][i] += first + shift * zeroth;
                moments[2][i] += second + 2.0 * shift * first + shift * shift * zeroth;
            }
        }
        Self { begin: self.begin, length, moments, growth: self.growth + next.growth }
    }
}

/// An orbit in a lane.
pub(super) struct Course {
    /// Which it is.
    pub number: usize,
    steps: u32,
    /// Of `together` steps each; the last may have fewer.
    pieces: Vec<Piece>,
    together: u32,
    seen: Vec<Evidence>,
    time: f64,
    /// ln|δ|, and of what was taken out of δ.
    log: f64,
    removed: f64,
    is_positive: bool,
    crossings: u32,
}

impl Course {
    /// At its start, where S has this value.
    pub fn new(number: usize, value: f64) -> Self {
        Self {
            number,
            steps: 0,
            pieces: Vec::with_capacity(PIECES),
            together: 1,
            seen: Vec::new(),
            time: 0.0,
            log: 0.0,
            removed: 0.0,
            is_positive: value >= 0.0,
            crossings: 0,
        }
    }

    /// The growth of ln|δ| if |δ|² has this value now; a power of two is divided out next.
    pub fn stretched(&mut self, length_squared: f64, power: i32) -> f64 {
        let log = self.removed + 0.5 * libm::log(length_squared);
        let growth = log - self.log;
        self.log = log;
        self.removed += f64::from(power) * std::f64::consts::LN_2;
        growth
    }

    /// Goes over a step, at whose end S has this value.
    pub fn take(&mut self, step: Piece, value: f64) {
        self.time = step.begin + step.length;
        self.crossings += u32::from((value >= 0.0) != self.is_positive);
        self.is_positive = value >= 0.0;
        if self.steps.is_multiple_of(self.together) {
            if self.pieces.len() == PIECES {
                for k in 0..PIECES / 2 {
                    self.pieces[k] = self.pieces[2 * k].and(&self.pieces[2 * k + 1]);
                }
                self.pieces.truncate(PIECES / 2);
                self.together *= 2;
            }
            self.pieces.push(step);
        } else if let Some(last) = self.pieces.last_mut() {
            *last = last.and(&step);
        }
        self.steps += 1;
    }

    /// Looks at the orbit if it has come to the next of these numbers of steps; its end, if this is it.
    pub fn look(&mut self, looks: &[usize]) -> Option<Decision> {
        if looks.get(self.seen.len()) != Some(&(self.steps as usize)) {
            return None;
        }
        self.seen.push(self.evidence());
        let verdict = self.verdict();
        let is_over = !verdict.is_open() || self.seen.len() == looks.len();
        is_over.then(|| self.decision(verdict))
    }

    /// Where it could not be followed.
    pub fn failed(&self) -> Decision {
        self.decision(OrbitVerdict::Open(OpenReason::Unfinished))
    }

    fn decision(&self, verdict: OrbitVerdict) -> Decision {
        Decision { verdict, time: self.time, crossings: self.crossings, steps: self.steps }
    }

    /// What is seen of the orbit where it is now.
    fn evidence(&self) -> Evidence {
        let [begin, middle, end] = PARTS.map(|part| part * self.time);
        let ((first, early), (second, late)) = (self.means(begin, middle), self.means(middle, end));
        let mean: [f64; 3] = std::array::from_fn(|i| 0.5 * (first[i] + second[i]));
        // The mean square of γ − its mean, where |γ| = 1.
        let spread = (1.0 - norm(mean) * norm(mean)).max(0.0).sqrt().max(NARROW);
        let apart = norm(sub(first, second)) / spread;
        Evidence { time: self.time, apart, growth: [early, late], log: self.log }
    }

    /// ∫ w γ dt / ∫ w dt over a window, with the weight w = (u(1 − u))⁸ of its part u, and ∫ w d ln|δ| likewise.
    fn means(&self, begin: f64, end: f64) -> ([f64; 3], f64) {
        let length = end - begin;
        let from = self.pieces.partition_point(|piece| piece.middle() <= begin);
        let pieces = self.pieces[from..].iter().take_while(|piece| piece.middle() < end);
        let (mut sum, mut log) = ([0.0; 3], 0.0);
        for piece in pieces {
            let u = (piece.middle() - begin) / length;
            // w at u + ε to the second order in ε, with v = u(1 − u): 8v⁷v′ ε + (28 v⁶v′² − 8v⁷) ε².
            let (v, slope) = (u * (1.0 - u), 1.0 - 2.0 * u);
            let v2 = v * v;
            let v6 = v2 * v2 * v2;
            let ratio = piece.length / length;
            let weight = v6 * v2;
            let first = 8.0 * v6 * v * slope * ratio;
            let second = (28.0 * v6 * slope * slope - 8.0 * v6 * v) * ratio * ratio;
            for (i, sum) in sum.iter_mut().enumerate() {
                *sum += weight * piece.moments[0][i] + first * piece.moments[1][i] + second * piece.moments[2][i];
            }
            log += weight * piece.growth;
        }
        (sum.map(|sum| sum / (length * INTEGRAL)), log / INTEGRAL)
    }

    /// The last `AGREE` tests all saw this.
    fn saw(&self, looks: usize, what: impl FnMut(&Evidence) -> bool) -> bool {
        self.seen.len() >= looks && self.seen.iter().rev().take(looks).all(what)
    }

    /// The results of the tests.
    fn verdict(&self) -> OrbitVerdict {
        if self.saw(SETTLED_LOOKS, |seen| seen.apart <= SETTLED) {
            return OrbitVerdict::Regular;
        }
        let Some(looks) = self.seen.last_chunk::<AGREE>().filter(|_| self.steps >= GROWTH_FROM) else {
            return OrbitVerdict::Open(OpenReason::TooShort { crossings: self.crossings as usize });
        };
        if self.saw(LINEAR_LOOKS, |seen| seen.grows_linearly(NEARLY_LINEAR))
            || looks.iter().all(|seen| seen.settled() && seen.grows_no_faster(HARDLY_MORE))
        {
            return OrbitVerdict::Regular;
        }
        match verdict(looks) {
            OrbitVerdict::Open(OpenReason::GrowsButSettles)
                if looks[AGREE - 1].log >= VERY_MUCH && looks.iter().all(|seen| seen.apart > SETTLED) =>
            {
                OrbitVerdict::Chaotic
            }
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// γ = (cos ωt, sin ωt, 0) in steps of 0.2, with the moments of each by Simpson's rule.
    fn step(number: u32, frequency: f64) -> Piece {
        let (length, nodes) = (0.2, 8_u32);
        let begin = length * f64::from(number);
        let mut moments = [[0.0; 3]; MOMENTS];
        for n in 0..nodes {
            for (part, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
                let x = (f64::from(n) + part) / f64::from(nodes);
                let (sin, cos) = libm::sincos(frequency * (begin + x * length));
                let mut power = weight * length / f64::from(6 * nodes);
                for moment in &mut moments {
                    moment[0] += power * cos;
                    moment[1] += power * sin;
                    power *= x - 0.5;
                }
            }
        }
        Piece { begin, length, moments, growth: length }
    }

    #[test]
    fn joined_pieces_have_the_moments_of_their_steps() {
        let steps: Vec<Piece> = (0..7).map(|number| step(number, 1.3)).collect();
        let joined = steps[1..].iter().fold(steps[0], |all, next| all.and(next));
        let other = steps[0].and(&steps[1]).and(&steps[2].and(&steps[3]).and(&steps[4])).and(&steps[5].and(&steps[6]));
        for j in 0..MOMENTS {
            for i in 0..3 {
                assert!((joined.moments[j][i] - other.moments[j][i]).abs() < 1e-15);
            }
        }
        // ∫ (t/T − 1/2) cos ωt dt = (T sin ωT/2 + (cos ωT − 1)/ω)/(ωT)
        let (length, frequency) = (1.4, 1.3);
        let (sin, cos) = libm::sincos(frequency * length);
        let exact = (0.5 * length * sin + (cos - 1.0) / frequency) / (frequency * length);
        assert!((joined.moments[1][0] - exact).abs() < 1e-8);
        assert!((joined.growth - length).abs() < 1e-15 && (joined.length - length).abs() < 1e-15);
    }

    /// However many steps are joined in a piece, the mean of a periodic motion is that of it.
    #[test]
    fn averages_over_joined_pieces_converge() {
        let mut course = Course::new(0, 1.0);
        for number in 0..30_000 {
            course.take(step(number, 2.1), 1.0);
            assert!(course.pieces.len() <= PIECES);
        }
        assert_eq!(course.together, 64);
        let seen = course.evidence();
        assert!(seen.apart < 1e-7, "{}", seen.apart);
        // d ln|δ|/dt = 1 over windows of 3/8 of the time.
        for growth in seen.growth {
            assert!((growth / (0.375 * 6000.0) - 1.0).abs() < 1e-3, "{growth}");
        }
    }

    /// A course of many steps at whose looks this was seen.
    fn judged(seen: &[Evidence]) -> OrbitVerdict {
        let mut course = Course::new(0, 1.0);
        (course.steps, course.seen) = (GROWTH_FROM, seen.to_vec());
        course.verdict()
    }

    fn seen(apart: f64, growth: [f64; 2], log: f64) -> Evidence {
        Evidence { time: 1.0, apart, growth, log }
    }

    /// Averages in a thin chaotic layer agree to 1e-4 for long: alone they once made such an orbit regular.
    #[test]
    fn averages_alone_are_believed_only_where_they_settle_closely() {
        let weak = |apart| judged(&[seen(apart, [2.3, 2.9], 14.0), seen(apart, [3.1, 3.3], 17.0)]);
        assert!(weak(5e-5).is_open() && weak(4e-7).is_open());
        assert_eq!(weak(2e-7), OrbitVerdict::Regular);
    }

    /// Growth over few steps would hide slow chaos.
    #[test]
    fn a_tangent_vector_is_believed_only_after_many_steps() {
        let mut course = Course::new(0, 1.0);
        course.seen = vec![seen(1e-3, [0.9, 0.5], 4.0); 8];
        for (steps, expected) in [(GROWTH_FROM - 1, false), (GROWTH_FROM, true)] {
            course.steps = steps;
            assert_eq!(course.verdict() == OrbitVerdict::Regular, expected);
        }
    }

    /// Steady growth far beyond the distance of two doubles is chaos, although averages agree at a look by chance; where they settle, it
    /// is an unstable periodic orbit.
    #[test]
    fn steady_growth_is_chaos_unless_the_averages_settle() {
        let grown = |apart| {
            judged(&[seen(0.03, [9.0, 8.0], 30.0), seen(apart, [13.0, 11.0], 48.0), seen(0.02, [20.0, 15.0], 70.0)])
        };
        assert_eq!(grown(0.01), OrbitVerdict::Chaotic);
        assert_eq!(grown(1e-4), OrbitVerdict::Chaotic);
        assert!(grown(1e-7).is_open());
    }
}
