//! A body that is asked many questions: its atlas is made once, when it is first needed.

use std::sync::OnceLock;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, CellError, Spot};
use bifdiag_diagram::fast::{self, FastError};
use bifdiag_diagram::topology::{Answer, Classification};

use crate::CertifiedAtlas;
use crate::answers::{Accuracy, AnswerError, classify, complete, is_decided};
use crate::plane_point::{PlaceError, places};
use crate::statistics::{Precision, Question, count};

/// Points of each pair of curves spent at each precision on a proof of the whole plane for the sake of one point.
const POINTS_AT_ONCE: u32 = 400;

/// Answers questions about one body.
#[derive(Debug)]
pub struct Solver {
    body: Body,
    accuracy: Accuracy,
    /// The atlas that was given or that of `f64`: it answers points.
    fast: OnceLock<Option<Atlas>>,
    proof: OnceLock<Option<Proof>>,
}

/// A proof that was finished at once.
#[derive(Debug)]
struct Proof {
    certified: CertifiedAtlas,
    /// `None` where a region's topology is not proved.
    atlas: Option<Atlas>,
}

impl Solver {
    /// Nothing is computed yet.
    #[must_use]
    pub fn new(body: Body, accuracy: Accuracy) -> Self {
        Self { body, accuracy, fast: OnceLock::new(), proof: OnceLock::new() }
    }

    /// One whose atlas is made already.
    #[must_use]
    pub fn of(atlas: Atlas, accuracy: Accuracy) -> Self {
        let body = atlas.body().clone();
        Self { fast: OnceLock::from(Some(atlas)), ..Self::new(body, accuracy) }
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// What answers are worth.
    #[must_use]
    pub fn accuracy(&self) -> Accuracy {
        self.accuracy
    }

    /// The atlas, or `None` where none is finished at once: points are then still answered one by one.
    pub fn atlas(&self) -> Option<&Atlas> {
        self.fast().or_else(|| self.proof()?.atlas.as_ref())
    }

    /// What to say where there is [no atlas](Self::atlas).
    #[must_use]
    pub fn without_atlas(&self) -> PlaceError {
        if self.accuracy == Accuracy::Fast { PlaceError::NoFastAtlas } else { PlaceError::NoAtlas }
    }

    fn fast(&self) -> Option<&Atlas> {
        let is_answer = |atlas: &Atlas| self.accuracy == Accuracy::Fast || is_decided(atlas);
        self.fast.get_or_init(|| fast::atlas(&self.body).ok().filter(is_answer)).as_ref()
    }

    fn proof(&self) -> Option<&Proof> {
        let prove = || {
            let certified = CertifiedAtlas::with_points(&self.body, POINTS_AT_ONCE).ok()?;
            let atlas = certified.to_atlas().ok().and_then(|atlas| complete(atlas).ok());
            Some(Proof { certified, atlas })
        };
        self.proof.get_or_init(|| if self.accuracy == Accuracy::Exact { prove() } else { None }).as_ref()
    }

    /// The type of a point, from the atlas where its error bounds suffice.
    ///
    /// # Errors
    /// [`AnswerError`].
    pub fn classify(&self, h: &Number, l: &Number) -> Result<Classification, AnswerError> {
        match self.fast().map(|atlas| fast::classify_in(atlas, h, l)) {
            Some(Ok((found, named))) if self.accuracy == Accuracy::Fast || (named && found.components().is_some()) => {
                count(Question::Point, Precision::Double);
                Ok(found)
            }
            Some(Err(error)) if self.accuracy == Accuracy::Fast => Err(error.into()),
            _ => classify(&self.body, h, l, self.accuracy),
        }
    }

    /// The regions at a point of known type, each once; `None` in the list is the forbidden region. A regular or forbidden
    /// point has one; a point on a curve each that meets there. Where `f64` does not separate them, they follow from the
    /// exact order of the curves over l.
    ///
    /// # Errors
    /// [`PlaceError`].
    pub fn places(&self, h: &Number, l: &Number, answer: &Answer) -> Result<Vec<Option<RegionId>>, PlaceError> {
        let is_fast = self.accuracy == Accuracy::Fast;
        let atlas = self.atlas().ok_or_else(|| self.without_atlas())?;
        let places = atlas.places(h, l, answer);
        let is_exact = match (self.accuracy, answer) {
            // Each class of a critical point is that of one region at least.
            (Accuracy::Exact, Answer::Critical(classes)) if !l.value().is_zero() => {
                places.as_ref().is_some_and(|places| places.len() == classes.len())
            }
            _ => places.is_some(),
        };
        match places {
            Some(places) if is_exact => Ok(places),
            _ if is_fast || l.value().is_zero() => Err(PlaceError::Rounding),
            // What does not fit the answer is no answer.
            _ => self.placed_exactly(atlas, h, l).and_then(|found| {
                let fits = |&place: &Option<RegionId>| atlas.class(place).is_some_and(|class| answer.allows(class));
                if found.iter().all(fits) { Ok(found) } else { Err(CellError.into()) }
            }),
        }
    }

    /// By the slabs within rounding of l; where several of them have such a cell, by those of the proof.
    fn placed_exactly(&self, atlas: &Atlas, h: &Number, l: &Number) -> Result<Vec<Option<RegionId>>, PlaceError> {
        let found = places(&self.body, h, l, &|x, sides| atlas.region_between(x.to_f64().value(), sides));
        let proof = || Some(&self.proof()?.certified).filter(|proof| proof.agrees_with(atlas));
        match found {
            Err(PlaceError::Cells(_)) => match proof() {
                Some(proof) => places(&self.body, h, l, &|x, sides| proof.region_between(x, sides)),
                None => found,
            },
            found => found,
        }
    }

    /// Where a point of known type lies.
    #[must_use]
    pub fn spot(&self, h: &Number, l: &Number, answer: &Answer) -> Spot {
        match answer {
            Answer::Critical(_) => Spot::Critical,
            Answer::Undecided(_) => Spot::Undecided,
            Answer::Forbidden => Spot::Forbidden,
            Answer::Regular(_) => match self.places(h, l, answer).as_deref() {
                Ok([Some(region)]) => Spot::Region(*region),
                _ => Spot::Undecided,
            },
        }
    }

    /// Whether a point of doubles, each denoting its shortest decimal, is known not to lie in a region: the rounded
    /// sample of a very narrow region may lie outside it.
    #[must_use]
    pub fn is_outside(&self, region: RegionId, [h, l]: [f64; 2]) -> bool {
        let spots = self.row(l, &[h]).and_then(Result::ok).unwrap_or_default();
        spots.first().is_some_and(|spot| ![Spot::Region(region), Spot::Undecided].contains(spot))
    }

    /// Where the points (h, l) of a row lie; each double denotes its shortest decimal. Points without an answer are
    /// undecided. `None` without an atlas.
    ///
    /// # Errors
    /// [`AnswerError`] when l is out of range.
    pub fn row(&self, l: f64, h: &[f64]) -> Option<Result<Vec<Spot>, AnswerError>> {
        let decide = |h: &Number, l: &Number| {
            self.classify(h, l).map_or(Spot::Undecided, |found| self.spot(h, l, &found.answer))
        };
        Some(self.atlas()?.row(l, h, decide).map_err(|error| FastError::from(error).into()))
    }
}
