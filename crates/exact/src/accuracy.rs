//! What an answer is worth, and the answers at each level.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, AtlasError};
use bifdiag_diagram::classify::{self, Classification, ClassifyError};
use thiserror::Error;

use crate::work::{Question, Rung, decided as worked};
use crate::{CertifiedAtlas, NotProved, NotWritten, Open, classify_exactly};

/// What an answer is worth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Accuracy {
    /// Never undecided: `f64` where its error bounds suffice, exact arithmetic elsewhere.
    #[default]
    Exact,
    /// `f64` with error bounds alone; undecided where they do not suffice.
    Fast,
}

impl From<bifdiag_schema::Accuracy> for Accuracy {
    fn from(word: bifdiag_schema::Accuracy) -> Self {
        match word {
            bifdiag_schema::Accuracy::Exact => Self::Exact,
            bifdiag_schema::Accuracy::Fast => Self::Fast,
        }
    }
}

impl From<Accuracy> for bifdiag_schema::Accuracy {
    fn from(accuracy: Accuracy) -> Self {
        match accuracy {
            Accuracy::Exact => Self::Exact,
            Accuracy::Fast => Self::Fast,
        }
    }
}

/// Why there is no atlas at a level of accuracy.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NoAtlas {
    /// There is none in `f64`.
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    /// It is not proved.
    #[error(transparent)]
    NotProved(#[from] NotProved),
    /// It is proved and cannot be drawn.
    #[error(transparent)]
    NotWritten(#[from] NotWritten),
    /// The regions are proved, but not what some of them are.
    #[error("the topology of region {region} is not proved")]
    Topology {
        /// The first of them.
        region: RegionId,
    },
}

/// The atlas of a body. At [`Accuracy::Exact`] it leaves nothing undecided: it is that of `f64` where its error bounds
/// decide everything, and a proved one elsewhere.
///
/// # Errors
/// [`NoAtlas`].
pub fn atlas_of(body: &Body, accuracy: Accuracy) -> Result<Atlas, NoAtlas> {
    let quick = Atlas::new(body);
    let settled = match &quick {
        Ok(atlas) => accuracy == Accuracy::Fast || is_decided(atlas),
        // Nothing that needs a frame can be computed of such a body.
        Err(error) => accuracy == Accuracy::Fast || matches!(error, AtlasError::Equilibria(_)),
    };
    worked(Question::Atlas, if settled { Rung::Double } else { Rung::Further });
    if settled { Ok(quick?) } else { decided(CertifiedAtlas::new(body)?.drawn()?) }
}

/// So many points of each pair of curves at each precision are spent on a proof of the whole plane for the sake of one point.
const POINTS_AT_ONCE: u32 = 400;

/// The atlas that answers points: that of `f64` if it leaves nothing undecided.
pub(crate) fn quick_atlas(body: &Body, accuracy: Accuracy) -> Option<Atlas> {
    Atlas::new(body).ok().filter(|atlas| accuracy == Accuracy::Fast || is_decided(atlas))
}

/// The atlas that names the regions of points where that of `f64` leaves something undecided: one that is proved at once.
pub(crate) fn proved_atlas(body: &Body, accuracy: Accuracy) -> Option<CertifiedAtlas> {
    (accuracy == Accuracy::Exact).then(|| CertifiedAtlas::with_points(body, POINTS_AT_ONCE).ok()).flatten()
}

/// An atlas in which the components of every region are known.
pub(crate) fn decided(atlas: Atlas) -> Result<Atlas, NoAtlas> {
    match atlas.regions().ids().find(|&region| atlas.components(region).is_err()) {
        None => Ok(atlas),
        Some(region) => Err(NoAtlas::Topology { region }),
    }
}

fn is_decided(atlas: &Atlas) -> bool {
    atlas.arrangement().undecided.is_empty() && atlas.regions().iter().all(|region| region.components.is_ok())
}

/// Why a point has no answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Unanswered {
    /// There is none in `f64`.
    #[error(transparent)]
    Classify(#[from] ClassifyError),
    /// A question that the largest precision does not decide.
    #[error(transparent)]
    Open(#[from] Open),
}

/// The type of U, E and P at one point. At [`Accuracy::Exact`] the answer is never [`bifdiag_diagram::classify::Answer::Undecided`].
///
/// # Errors
/// [`Unanswered`].
pub fn classify(body: &Body, h: &Number, l: &Number, accuracy: Accuracy) -> Result<Classification, Unanswered> {
    if accuracy == Accuracy::Fast {
        return Ok(classify::classify(body, h, l)?);
    }
    let clear = classify::classify_if_clear(body, h, l)?;
    worked(Question::Point, if clear.is_some() { Rung::Double } else { Rung::Further });
    match clear {
        Some(found) => Ok(found),
        None => Ok(classify_exactly(body, h, l)?),
    }
}
