//! Regular or chaotic: two witnesses that know nothing of each other must agree, three times in a row.

use std::convert::Infallible;
use std::fmt;

use crate::field::{Dimension, TopUnits};

/// The time of this crossing is the unit of the times at which an orbit is tested.
pub const UNIT: usize = 42;

/// Whether an orbit is regular or chaotic over the time that it was followed.
///
/// Chaotic does not mean unstable: the neighbours of an unstable periodic orbit leave it, but it is regular; a chaotic
/// orbit may stay for ever near a stable one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OrbitVerdict {
    /// A tangent vector grows no faster than linearly, and the averages over the orbit settle as those over a
    /// quasiperiodic motion do.
    Regular,
    /// A tangent vector grows exponentially and steadily, and the averages over the orbit do not settle.
    Chaotic,
    /// The witnesses are silent, or do not agree.
    Open(OpenReason),
}

impl OrbitVerdict {
    /// True where there is no verdict.
    #[must_use]
    pub fn is_open(&self) -> bool {
        matches!(self, Self::Open(_))
    }
}

/// Why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenReason {
    /// It was not asked for.
    NotAsked,
    /// The orbit stays on the section, which then shows nothing.
    StaysOnSection,
    /// The work was stopped, or the motion did not remain finite.
    Unfinished,
    /// Too few crossings for three looks.
    TooShort {
        /// Crossings.
        crossings: usize,
    },
    /// The averages have settled, but the tangent vector grows exponentially: an unstable periodic orbit, or an
    /// orbit that was beside one all the time.
    GrowsButSettles,
    /// The averages have settled, but the tangent vector has grown neither linearly nor exponentially.
    SettlesOnly,
    /// The tangent vector grows linearly; the averages have not settled yet.
    LinearOnly,
    /// Neither can be decided: the orbit is near a separatrix, or its chaos is too weak for the time.
    Neither,
}

impl fmt::Display for OpenReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotAsked => "it was not asked for",
            Self::StaysOnSection => "the orbit stays on the section, which then tells nothing of it",
            Self::Unfinished => "the tangent vector could not be followed to the orbit's end",
            Self::TooShort { crossings } => {
                // The third look is at two units.
                return write!(f, "{crossings} crossings are too few, about {} are needed", 2 * UNIT);
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

/// Linear growth of |δ|: what ln|δ| gains over the two windows of a look, the means of 1/t times their lengths.
const LINEAR: [f64; 2] = [0.866, 0.463];
/// Growth counts as linear, or less, up to this excess.
const TOLERANCE: f64 = 0.3;
/// Exponential growth: at least this much in each window.
const STEADY: f64 = 4.0;
/// Exponential growth: at least this much since the start. No distance of two doubles can be the cause: ln 2⁵³ is 36.7.
const MUCH: f64 = 40.0;
/// Averages that differ by no more than this part of the spread have settled.
const SETTLED: f64 = 2e-3;
/// Tests that must agree. By chance an orbit that sticks to an island may look regular once or twice, but hardly over
/// such a long range of times; likewise, a regular orbit near a separatrix may look chaotic.
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
    pub(super) fn settled(&self) -> bool {
        self.apart <= SETTLED
    }

    /// No faster than linearly, up to this excess.
    pub(super) fn grows_no_faster(&self, excess: f64) -> bool {
        self.growth.iter().zip(LINEAR).all(|(growth, linear)| (-excess..=linear + excess).contains(growth))
    }

    /// Linearly, within this.
    pub(super) fn grows_linearly(&self, within: f64) -> bool {
        self.growth.iter().zip(LINEAR).all(|(growth, linear)| (growth - linear).abs() <= within)
    }

    fn exponential(&self) -> bool {
        self.growth.iter().all(|growth| *growth >= STEADY)
    }

    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(self, units: TopUnits) -> Self {
        Self { time: units.restore(self.time, Dimension::TIME), ..self }
    }
}

/// What successive looks say together.
pub(super) fn verdict(looks: &[Evidence; AGREE]) -> OrbitVerdict {
    let all = |holds: fn(&Evidence) -> bool| looks.iter().all(holds);
    let settled = all(Evidence::settled);
    let linear = all(|seen| seen.grows_no_faster(TOLERANCE));
    let exponential = all(Evidence::exponential) && looks[AGREE - 1].log >= MUCH;
    match (linear, exponential) {
        (true, _) if settled => OrbitVerdict::Regular,
        (true, _) => OrbitVerdict::Open(OpenReason::LinearOnly),
        (_, true) if !looks.iter().any(Evidence::settled) => OrbitVerdict::Chaotic,
        (_, true) => OrbitVerdict::Open(OpenReason::GrowsButSettles),
        _ if settled => OrbitVerdict::Open(OpenReason::SettlesOnly),
        _ => OrbitVerdict::Open(OpenReason::Neither),
    }
}

/// The first successive looks that decide, with what they say.
pub(super) fn first_decision(seen: &[Evidence]) -> Option<(OrbitVerdict, &[Evidence; AGREE])> {
    let mut runs = seen.windows(AGREE).filter_map(<[Evidence]>::first_chunk);
    runs.find_map(|looks| Some((verdict(looks), looks)).filter(|(verdict, _)| !verdict.is_open()))
}

/// A verdict with what it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// What it is.
    pub verdict: OrbitVerdict,
    /// The three looks that decided it; where it is open, the last three. Empty if the orbit was too short or not measured.
    pub evidence: Vec<Evidence>,
    /// Where it was decided: the last look's time since the start, and the number of the last crossing until then; None where it
    /// is open.
    pub decided: Option<(f64, u32)>,
}

impl Judgement {
    /// None, and why.
    #[must_use]
    pub fn open(why: OpenReason) -> Self {
        Self { verdict: OrbitVerdict::Open(why), evidence: Vec::new(), decided: None }
    }

    /// Judges an orbit by its tests, in their order. `crossings` are those of the orbit, `crossing_at` is the number of
    /// the last one until a time.
    ///
    /// The first three successive looks that decide do so for good: an orbit that is followed further has the same verdict.
    #[must_use]
    pub fn new(seen: &[Evidence], crossings: usize, crossing_at: impl FnOnce(f64) -> u32) -> Self {
        match Self::try_new(seen, crossings, |time| Ok::<u32, Infallible>(crossing_at(time))) {
            Ok(judgement) => judgement,
            Err(never) => match never {},
        }
    }

    /// Likewise, where the number of a crossing may not be found.
    ///
    /// # Errors
    /// That of `crossing_at`.
    pub fn try_new<E>(
        seen: &[Evidence],
        crossings: usize,
        crossing_at: impl FnOnce(f64) -> Result<u32, E>,
    ) -> Result<Self, E> {
        if let Some((verdict, looks)) = first_decision(seen) {
            let time = looks[AGREE - 1].time;
            return Ok(Self { verdict, evidence: looks.to_vec(), decided: Some((time, crossing_at(time)?)) });
        }
        Ok(match seen.last_chunk::<AGREE>() {
            Some(looks) => Self { verdict: verdict(looks), evidence: looks.to_vec(), decided: None },
            None => Self::open(OpenReason::TooShort { crossings }),
        })
    }
}

impl fmt::Display for Judgement {
    /// The reason for the verdict.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [linear, late] = LINEAR;
        match (self.verdict, self.evidence.last()) {
            (OrbitVerdict::Regular, Some(Evidence { growth: [a, b], apart, .. })) => write!(
                f,
                "a tangent vector grows no faster than linearly (ln|δ| by {a:.2} and {b:.2} in two windows of time; linear is \
                 {linear:.2} and {late:.2}) and the averages over them agree (to {apart:.1e} of the spread)"
            ),
            (OrbitVerdict::Chaotic, Some(Evidence { growth: [a, b], apart, log, .. })) => write!(
                f,
                "a tangent vector grows exponentially (ln|δ| by {a:.1} and {b:.1} in two windows of time, by {log:.1} in all) \
                 and the averages over them do not agree ({apart:.1e} of the spread)"
            ),
            (OrbitVerdict::Open(why), _) => why.fmt(f),
            (_, None) => Ok(()),
        }
    }
}
