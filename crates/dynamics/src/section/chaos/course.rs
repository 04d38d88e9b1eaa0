//! An orbit while it is followed: what is kept of its steps, and what the looks at them say.

use super::averages::INTEGRAL;
use super::ladder::NARROW;
use super::verdict::{AGREE, Evidence, LINEAR, OpenReason, OrbitVerdict, verdict};
use crate::field::{norm, sub};

/// Where the two windows of a look begin and end, as parts of the time until then: those of other verdicts.
const PARTS: [f64; 3] = [0.25, 0.625, 1.0];
/// Moments of γ over a piece that are kept: what is left out of an average is of the third order in piece/window.
pub(super) const MOMENTS: usize = 3;
/// The most pieces that are kept of an orbit; then they are joined in pairs. Each look has at least 60 in a window.
const PIECES: usize = 640;
/// Averages apart by no more than this part of the spread at [`SETTLED_LOOKS`] looks in a row are those of a regular orbit,
/// whatever a tangent vector does.
const SETTLED: f64 = 1e-4;
const SETTLED_LOOKS: usize = 2;
/// Growth within this of a linear one, at [`LINEAR_LOOKS`] looks in a row, is that of a regular orbit, however slowly its averages
/// settle.
const NEARLY_LINEAR: f64 = 0.2;
const LINEAR_LOOKS: usize = 4;
/// Averages further apart than this at two looks in a row, of which the second is at least the look [`RESTLESS_LOOK`], do not
/// settle soon: a tangent vector is asked.
const RESTLESS: f64 = 1e-2;
const RESTLESS_LOOK: usize = 4;

/// What an orbit is, and what showed it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// Regular, chaotic or open.
    pub verdict: OrbitVerdict,
    /// For how long the orbit was followed.
    pub time: f64,
    /// How often S = ⟨ω, r×γ⟩ changed its sign from one step to the next.
    pub crossings: u32,
    /// Steps of the integrator that it took: of the orbit alone, and of the orbit with a tangent vector.
    pub steps: [u32; 2],
}

/// How the way of an orbit ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ending {
    pub number: usize,
    pub decision: Decision,
    /// That is all: it does not ask for a tangent vector.
    pub is_over: bool,
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
    number: usize,
    with_tangent: bool,
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
    pub fn new(number: usize, value: f64, with_tangent: bool) -> Self {
        Self {
            number,
            with_tangent,
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

    /// By how much ln|δ| grew, if |δ|² is this now, of which a power of two is taken out next.
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
    pub fn look(&mut self, looks: &[usize]) -> Option<Ending> {
        if looks.get(self.seen.len()) != Some(&(self.steps as usize)) {
            return None;
        }
        self.seen.push(self.evidence());
        let is_last = self.seen.len() == looks.len();
        let verdict = self.verdict();
        let is_over = !verdict.is_open() || self.with_tangent && is_last;
        let asks = is_last || !self.with_tangent && self.is_restless();
        (is_over || asks).then(|| self.ending(verdict, is_over))
    }

    /// Where it could not be followed.
    pub fn failed(&self) -> Ending {
        self.ending(OrbitVerdict::Open(OpenReason::Unfinished), true)
    }

    fn ending(&self, verdict: OrbitVerdict, is_over: bool) -> Ending {
        let steps = if self.with_tangent { [0, self.steps] } else { [self.steps, 0] };
        let decision = Decision { verdict, time: self.time, crossings: self.crossings, steps };
        Ending { number: self.number, decision, is_over }
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

    /// The last looks, so many of them, all saw this.
    fn saw(&self, looks: usize, what: impl FnMut(&Evidence) -> bool) -> bool {
        self.seen.len() >= looks && self.seen.iter().rev().take(looks).all(what)
    }

    /// The averages do not settle soon.
    fn is_restless(&self) -> bool {
        self.seen.len() > RESTLESS_LOOK && self.saw(2, |seen| seen.apart > RESTLESS)
    }

    /// What the looks at it say.
    fn verdict(&self) -> OrbitVerdict {
        let is_linear = |seen: &Evidence| {
            seen.growth.iter().zip(LINEAR).all(|(growth, linear)| (growth - linear).abs() <= NEARLY_LINEAR)
        };
        if self.saw(SETTLED_LOOKS, |seen| seen.apart <= SETTLED)
            || self.with_tangent && self.saw(LINEAR_LOOKS, is_linear)
        {
            return OrbitVerdict::Regular;
        }
        match self.seen.last_chunk::<AGREE>() {
            Some(looks) if self.with_tangent => verdict(looks),
            _ => OrbitVerdict::Open(OpenReason::TooShort { crossings: self.crossings as usize }),
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
        let mut course = Course::new(0, 1.0, false);
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
}
