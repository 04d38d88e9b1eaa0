//! What is seen of an orbit at one time, and what successive looks decide.

use super::verdict::{Open, Verdict};
use crate::field::{Dimension, Units};

/// Linear growth of |δ|: what ln|δ| gains over the two windows of a look, the means of 1/t times their lengths.
pub(super) const LINEAR: [f64; 2] = [0.866, 0.463];
/// It is linear, or less, up to so much.
const TOLERANCE: f64 = 0.3;
/// Exponential growth: at least so much in each window.
const STEADY: f64 = 4.0;
/// Exponential growth: at least so much since the start. No distance of two doubles can be the cause: ln 2⁵³ is 36.7.
const MUCH: f64 = 40.0;
/// Averages that differ by no more than this part of the spread have settled.
const SETTLED: f64 = 2e-3;
/// Looks that must agree. Chance makes an orbit that sticks to an island look regular once or twice, but hardly over
/// so long a range of times, and likewise a regular orbit near a separatrix chaotic.
pub(super) const AGREE: usize = 3;

/// What is seen of an orbit at one time T, in the windows [T/4, 5T/8] and [5T/8, T].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// T.
    pub time: f64,
    /// How far the means of γ over the two windows are apart, in units of the spread of γ.
    pub apart: f64,
    /// By how much ln|δ| grows in each of them, at its mean rate there. Linear growth of |δ| leaves 0.87 and 0.46.
    pub growth: [f64; 2],
    /// ln(|δ(T)|/|δ(0)|), at the end of the step that reaches T.
    pub log: f64,
}

impl Evidence {
    fn settled(&self) -> bool {
        self.apart <= SETTLED
    }

    fn linear(&self) -> bool {
        self.growth.iter().zip(LINEAR).all(|(growth, linear)| (-TOLERANCE..=linear + TOLERANCE).contains(growth))
    }

    fn exponential(&self) -> bool {
        self.growth.iter().all(|growth| *growth >= STEADY)
    }

    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(self, units: Units) -> Self {
        Self { time: units.restore(self.time, Dimension::TIME), ..self }
    }
}

/// What successive looks say together.
pub(super) fn verdict(looks: &[Evidence; AGREE]) -> Verdict {
    let all = |holds: fn(&Evidence) -> bool| looks.iter().all(holds);
    let settled = all(Evidence::settled);
    let linear = all(Evidence::linear);
    let exponential = all(Evidence::exponential) && looks[AGREE - 1].log >= MUCH;
    match (linear, exponential) {
        (true, _) if settled => Verdict::Regular,
        (true, _) => Verdict::Open(Open::LinearOnly),
        (_, true) if !looks.iter().any(Evidence::settled) => Verdict::Chaotic,
        (_, true) => Verdict::Open(Open::GrowsButSettles),
        _ if settled => Verdict::Open(Open::SettlesOnly),
        _ => Verdict::Open(Open::Neither),
    }
}

/// The first successive looks that decide, with what they say.
pub(super) fn first_decision(seen: &[Evidence]) -> Option<(Verdict, &[Evidence; AGREE])> {
    let mut runs = seen.windows(AGREE).filter_map(<[Evidence]>::first_chunk);
    runs.find_map(|looks| Some((verdict(looks), looks)).filter(|(verdict, _)| !verdict.is_open()))
}
