//! Regular or chaotic: two witnesses that know nothing of each other must agree.

use std::fmt;

use super::average::bump;
use super::growth::Sample;
use crate::field::{add, norm, scale, sub};
use crate::section::orbit::SectionPoint;

/// Fewest returns from which a verdict is given.
pub const FEWEST_RETURNS: usize = 32;
/// Exponential growth: at least so much of ln|δ| in each of the last three quarters of the time. Linear growth leaves
/// ln 2, ln 3/2 and ln 4/3 there.
const STEADY: f64 = 3.0;
/// Exponential growth: at least so much in these three quarters together.
const MUCH: f64 = 16.0;
/// Linear growth: at most so much of ln|δ| in the second half of the time, where it leaves ln 2.
const LITTLE: f64 = 1.5;
/// Averages that differ by no more than this part of the spread have settled.
const SETTLED: f64 = 1e-3;
/// Averages over n crossings that differ by more than this part of the spread, divided by n², have not settled: the sums
/// that stand for integrals have an error of about 1/n².
const RESTLESS: f64 = 100.0;
/// A spread below this is taken as this.
const NARROW: f64 = 1e-5;

/// Is an orbit regular or chaotic, as far as it was followed?
///
/// Chaotic is not unstable: an unstable periodic orbit has neighbours that leave it, and is regular; a chaotic orbit
/// may stay for ever near a stable one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A tangent vector grows no faster than linearly, and the averages over the orbit settle as those over a
    /// quasiperiodic motion do.
    Regular,
    /// A tangent vector grows exponentially and steadily, and the averages over the orbit do not settle.
    Chaotic,
    /// The witnesses are silent, or do not agree.
    Open(Open),
}

/// Why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Open {
    /// It was not asked for.
    NotAsked,
    /// The orbit stays on the section, which then tells nothing.
    StaysOnSection,
    /// The work was stopped, or the motion did not remain finite.
    Unfinished,
    /// Too few returns.
    TooShort {
        /// Returns to the incoming half.
        returns: usize,
    },
    /// The averages have settled, but the tangent vector grows exponentially: an unstable periodic orbit, or an
    /// orbit that was beside one all the time.
    GrowsButSettles,
    /// The averages have settled, but the tangent vector has grown neither linearly nor exponentially.
    SettlesOnly,
    /// The tangent vector grows linearly; the averages have not settled yet.
    LinearOnly,
    /// Neither can be told: the orbit is near a separatrix, or its chaos is too weak for the time.
    Neither,
}

/// The criterion's numbers over the first part of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// How much ln|δ| has grown in each quarter of the time: the mean of d ln|δ|/dt with the weight
    /// exp(−1/(u(1−u))), times the quarter's length.
    pub growth: [f64; 4],
    /// The same for the second half of the time.
    pub late_growth: f64,
    /// How far the averages of γ over the two halves of the time are apart, with that weight, in units of the spread of
    /// γ over the crossings.
    pub halves: f64,
    /// The same for successive quarters, the smallest of the three.
    pub quarters: f64,
    /// Number of crossings.
    pub crossings: usize,
}

/// A verdict with what it rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judgement {
    /// What it is.
    pub verdict: Verdict,
    /// Over the whole orbit; None if it was too short or not measured.
    pub evidence: Option<Evidence>,
    /// Time and number of the crossing from which on the verdict was the same; None where it is open.
    pub decided: Option<(f64, u32)>,
}

impl Judgement {
    /// None, and why.
    #[must_use]
    pub fn open(why: Open) -> Self {
        Self { verdict: Verdict::Open(why), evidence: None, decided: None }
    }
}

/// Judges an orbit by its crossings and by the samples of its course at each of them.
///
/// The verdict is that over the whole orbit. The halves, quarters, … of the orbit tell from when on it was the same.
#[must_use]
pub fn judge(points: &[SectionPoint], samples: &[Sample]) -> Judgement {
    let incoming: Vec<usize> = (0..points.len().min(samples.len())).filter(|&i| points[i].s_dot < 0.0).collect();
    let returns = incoming.len().saturating_sub(1);
    if returns < FEWEST_RETURNS {
        return Judgement::open(Open::TooShort { returns });
    }
    let mut judgement = judge_first(points, samples, &incoming);
    if let Verdict::Open(_) = judgement.verdict {
        return judgement;
    }
    let mut shorter = returns / 2;
    while shorter >= FEWEST_RETURNS {
        let earlier = judge_first(points, samples, &incoming[..=shorter]);
        if earlier.verdict != judgement.verdict {
            break;
        }
        judgement.decided = earlier.decided;
        shorter /= 2;
    }
    judgement
}

/// By the incoming crossings of these numbers.
fn judge_first(points: &[SectionPoint], samples: &[Sample], incoming: &[usize]) -> Judgement {
    let evidence = Evidence::new(points, samples, incoming);
    let verdict = evidence.verdict();
    let last = &points[incoming[incoming.len() - 1]];
    let decided = (!matches!(verdict, Verdict::Open(_))).then_some((last.time, last.index));
    Judgement { verdict, evidence: Some(evidence), decided }
}

impl Evidence {
    fn new(points: &[SectionPoint], samples: &[Sample], incoming: &[usize]) -> Self {
        let last = incoming[incoming.len() - 1];
        let (begin, end) = (points[incoming[0]].time, points[last].time);
        let quarter = |k: u32| begin + (end - begin) * 0.25 * f64::from(k);
        let rates = |from, to| rates(&points[..=last], samples, (quarter(from), quarter(to)));
        let quarters = [rates(0, 1), rates(1, 2), rates(2, 3), rates(3, 4)];
        let halves = [rates(0, 2), rates(2, 4)];
        let spread = spread(&points[..=last]);
        let apart = |one: &Rates, other: &Rates| norm(sub(one.gamma, other.gamma)) / spread;
        Self {
            growth: quarters.map(|quarter| quarter.log * 0.25 * (end - begin)),
            late_growth: halves[1].log * 0.5 * (end - begin),
            halves: apart(&halves[0], &halves[1]),
            quarters: quarters.windows(2).map(|pair| apart(&pair[0], &pair[1])).fold(f64::INFINITY, f64::min),
            crossings: last,
        }
    }

    /// What the two witnesses say together.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let late = &self.growth[1..];
        let exponential = late.iter().all(|&growth| growth >= STEADY) && late.iter().sum::<f64>() >= MUCH;
        let linear = self.late_growth <= LITTLE && !exponential;
        let settled = self.halves <= SETTLED;
        let crossings = self.crossings as f64;
        let restless = self.halves.min(self.quarters) * crossings * crossings > RESTLESS;
        match (linear, exponential) {
            (true, _) if settled => Verdict::Regular,
            (_, true) if restless => Verdict::Chaotic,
            (_, true) => Verdict::Open(Open::GrowsButSettles),
            (true, _) => Verdict::Open(Open::LinearOnly),
            _ if settled => Verdict::Open(Open::SettlesOnly),
            _ => Verdict::Open(Open::Neither),
        }
    }
}

/// Weighted averages over a span of time.
#[derive(Clone, Copy)]
struct Rates {
    /// Of d ln|δ|/dt.
    log: f64,
    /// Of γ.
    gamma: [f64; 3],
}

/// ∫ w dx / ∫ w dt, w at the middle between two crossings.
fn rates(points: &[SectionPoint], samples: &[Sample], (begin, end): (f64, f64)) -> Rates {
    let first = points.partition_point(|point| point.time < begin).saturating_sub(1);
    let (mut log, mut gamma, mut weights) = (0.0, [0.0; 3], 0.0);
    for (pair, samples) in points[first..].windows(2).zip(samples[first..].windows(2)) {
        if pair[0].time > end {
            break;
        }
        let middle = f64::midpoint(pair[0].time, pair[1].time);
        let weight = bump((middle - begin) / (end - begin));
        log += weight * (samples[1].log - samples[0].log);
        gamma = add(gamma, scale(weight, sub(samples[1].integral, samples[0].integral)));
        weights += weight * (pair[1].time - pair[0].time);
    }
    Rates { log: log / weights, gamma: scale(1.0 / weights, gamma) }
}

/// Root of the mean square of γ − its mean over the crossings, but not below `NARROW`.
fn spread(points: &[SectionPoint]) -> f64 {
    let count = points.len() as f64;
    let mean = scale(1.0 / count, points.iter().fold([0.0; 3], |sum, point| add(sum, point.gamma)));
    let square = |point: &SectionPoint| {
        let distance = norm(sub(point.gamma, mean));
        distance * distance
    };
    (points.iter().map(square).sum::<f64>() / count).sqrt().max(NARROW)
}

impl fmt::Display for Judgement {
    /// Why the verdict is what it is.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.verdict, &self.evidence) {
            (Verdict::Regular, Some(evidence)) => write!(
                f,
                "a tangent vector grows no faster than linearly (ln|δ| by {:.2} in the second half of the time; ln 2 \
                 = 0.69 is linear) and the averages settle (to {:.1e} of the spread)",
                evidence.late_growth, evidence.halves
            ),
            (Verdict::Chaotic, Some(Evidence { growth: [_, b, c, d], halves, .. })) => write!(
                f,
                "a tangent vector grows exponentially (ln|δ| by {b:.1}, {c:.1} and {d:.1} in the last three quarters \
                 of the time) and the averages do not settle ({halves:.1e} of the spread)"
            ),
            (Verdict::Open(why), _) => why.fmt(f),
            (_, None) => Ok(()),
        }
    }
}

impl fmt::Display for Open {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotAsked => "it was not asked for",
            Self::StaysOnSection => "the orbit stays on the section, which then tells nothing of it",
            Self::Unfinished => "the tangent vector could not be followed to the orbit's end",
            Self::TooShort { returns } => {
                return write!(f, "{returns} returns are too few, {FEWEST_RETURNS} are needed");
            }
            Self::GrowsButSettles => {
                "a tangent vector grows exponentially, but the averages settle: the orbit is, or keeps beside, an \
                 unstable periodic one"
            }
            Self::SettlesOnly => "the averages settle, but a tangent vector grows neither linearly nor exponentially",
            Self::LinearOnly => "a tangent vector grows linearly, but the averages have not settled yet",
            Self::Neither => {
                "a tangent vector grows neither linearly nor exponentially, and the averages do not settle"
            }
        })
    }
}
