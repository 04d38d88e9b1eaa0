//! The answers: the atlas of a body and the class of a point. Each tries `f64` first.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::fast::{self, FastError};
use bifdiag_diagram::topology::Classification;
pub use bifdiag_schema::Accuracy;
use thiserror::Error;

use crate::statistics::{Precision, Question, count};
use crate::{CertifiedAtlas, ConversionError, Open, ProofError, classify_exactly};

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum AnswerError {
    /// There is no atlas in `f64`.
    #[error(transparent)]
    Fast(#[from] FastError),
    /// The arrangement is not proved.
    #[error(transparent)]
    Proof(#[from] ProofError),
    /// It is proved and cannot be drawn.
    #[error(transparent)]
    Conversion(#[from] ConversionError),
    /// The regions are proved, but not what some of them are.
    #[error("the topology of region {region} is not proved")]
    Topology {
        /// The first of them.
        region: RegionId,
    },
    /// A question about one point that the largest precision does not decide.
    #[error(transparent)]
    Open(#[from] Open),
}

/// The atlas of a body. At [`Accuracy::Exact`] it leaves nothing undecided: it is that of `f64` where its error bounds
/// decide everything, and a proved one elsewhere.
///
/// # Errors
/// [`AnswerError`].
pub fn atlas(body: &Body, accuracy: Accuracy) -> Result<Atlas, AnswerError> {
    let fast = fast::atlas(body);
    let is_answer = match &fast {
        Ok(atlas) => accuracy == Accuracy::Fast || is_decided(atlas),
        // Nothing that needs a frame can be computed of such a body.
        Err(error) => accuracy == Accuracy::Fast || matches!(error, FastError::Equilibria(_)),
    };
    count(Question::Atlas, if is_answer { Precision::Double } else { Precision::Further });
    if !is_answer {
        return complete(CertifiedAtlas::new(body)?.to_atlas()?);
    }
    let atlas = fast?;
    if accuracy == Accuracy::Fast || atlas.is_maximum_certain() {
        return Ok(atlas);
    }
    // Events that may be at one l: the proof has no slab between them if they are.
    let proved = CertifiedAtlas::new(body)?.to_atlas()?;
    Ok(atlas.with_critical_points_max(proved.critical_points_max()))
}

/// An atlas in which the components of every region are known.
pub(crate) fn complete(atlas: Atlas) -> Result<Atlas, AnswerError> {
    match atlas.regions().ids().find(|&region| atlas.components(region).is_err()) {
        None => Ok(atlas),
        Some(region) => Err(AnswerError::Topology { region }),
    }
}

pub(crate) fn is_decided(atlas: &Atlas) -> bool {
    atlas.arrangement().undecided.is_empty() && atlas.regions().iter().all(|region| region.components.is_ok())
}

/// The type of U, E and P at one point. At [`Accuracy::Exact`] the answer is never
/// [`Undecided`](bifdiag_diagram::topology::Answer::Undecided).
///
/// # Errors
/// [`AnswerError`].
pub fn classify(body: &Body, h: &Number, l: &Number, accuracy: Accuracy) -> Result<Classification, AnswerError> {
    if accuracy == Accuracy::Fast {
        return Ok(fast::classify(body, h, l)?);
    }
    if let Some((found, true)) = fast::classify_at_momentum(body, h, l)? {
        count(Question::Point, Precision::Double);
        return Ok(found);
    }
    // Likewise where only the nearest curve is not certain.
    count(Question::Point, Precision::Further);
    Ok(classify_exactly(body, h, l)?)
}
