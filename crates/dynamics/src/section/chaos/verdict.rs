//! What an orbit can turn out to be.

use std::fmt;

/// The time of this crossing is the unit of the times at which an orbit is looked at.
pub const UNIT: usize = 42;

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

impl Verdict {
    /// Is it none?
    #[must_use]
    pub fn is_open(&self) -> bool {
        matches!(self, Self::Open(_))
    }
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
    /// Neither can be told: the orbit is near a separatrix, or its chaos is too weak for the time.
    Neither,
}

impl fmt::Display for Open {
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
