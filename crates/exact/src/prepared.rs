//! A body that is asked many questions: its atlas is made once, when it is first needed.

use std::sync::OnceLock;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, NoCell, Spot};
use bifdiag_diagram::classify::{Answer, Classification, ClassifyError};

use crate::CertifiedAtlas;
use crate::accuracy::{Accuracy, Unanswered, classify, decided as settled, proved_atlas, quick_atlas};
use crate::places::{NotPlaced, places};
use crate::work::{Question, Rung, decided};

/// A body and what is known of it.
#[derive(Debug)]
pub struct Prepared {
    body: Body,
    accuracy: Accuracy,
    quick: OnceLock<Option<Atlas>>,
    proof: OnceLock<Option<CertifiedAtlas>>,
    /// That of the proof, where there is none of `f64`.
    drawn: OnceLock<Option<Atlas>>,
}

impl Prepared {
    /// Nothing is computed yet.
    #[must_use]
    pub fn new(body: Body, accuracy: Accuracy) -> Self {
        Self { body, accuracy, quick: OnceLock::new(), proof: OnceLock::new(), drawn: OnceLock::new() }
    }

    /// One whose atlas is made already.
    #[must_use]
    pub fn of(atlas: Atlas, accuracy: Accuracy) -> Self {
        let body = atlas.body().clone();
        Self { quick: OnceLock::from(Some(atlas)), ..Self::new(body, accuracy) }
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
        let drawn = || self.drawn.get_or_init(|| settled(self.proof()?.drawn().ok()?).ok()).as_ref();
        self.quick().or_else(drawn)
    }

    fn proof(&self) -> Option<&CertifiedAtlas> {
        self.proof.get_or_init(|| proved_atlas(&self.body, self.accuracy)).as_ref()
    }

    /// The one that was given or that of `f64`: it answers points.
    fn quick(&self) -> Option<&Atlas> {
        self.quick.get_or_init(|| quick_atlas(&self.body, self.accuracy)).as_ref()
    }

    /// The type of a point, from the atlas where its error bounds suffice.
    ///
    /// # Errors
    /// [`Unanswered`].
    pub fn classify(&self, h: &Number, l: &Number) -> Result<Classification, Unanswered> {
        let answered = self.quick().map(|atlas| match self.accuracy {
            Accuracy::Fast => atlas.classify(h, l).map(Some),
            Accuracy::Exact => atlas.classify_if_clear(h, l),
        });
        match answered {
            Some(Ok(Some(found))) => {
                decided(Question::Point, Rung::Double);
                Ok(found)
            }
            Some(Err(error)) if self.accuracy == Accuracy::Fast => Err(error.into()),
            _ => classify(&self.body, h, l, self.accuracy),
        }
    }

    /// The regions at a point of known type, each once; `None` in the list is the forbidden region. A regular or forbidden
    /// point has one; a point on a curve each that meets there. Where `f64` does not tell them apart, they follow from the
    /// exact order of the curves over l.
    ///
    /// # Errors
    /// [`NotPlaced`].
    pub fn places(&self, h: &Number, l: &Number, answer: &Answer) -> Result<Vec<Option<RegionId>>, NotPlaced> {
        let atlas = self.atlas().ok_or(NotPlaced::NoAtlas)?;
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
            _ if self.accuracy == Accuracy::Fast || l.value().is_zero() => Err(NotPlaced::Rounding),
            // What does not fit the answer is no answer.
            _ => self.placed_exactly(atlas, h, l).and_then(|found| {
                let fits = |&place: &Option<RegionId>| atlas.class(place).is_some_and(|class| answer.allows(class));
                if found.iter().all(fits) { Ok(found) } else { Err(NoCell.into()) }
            }),
        }
    }

    /// By the slabs within rounding of l; where several of them have such a cell, by those of the proof.
    fn placed_exactly(&self, atlas: &Atlas, h: &Number, l: &Number) -> Result<Vec<Option<RegionId>>, NotPlaced> {
        let found = places(&self.body, h, l, &|x, sides| atlas.region_between(x.to_f64().value(), sides));
        let proof = || self.proof().filter(|proof| proof.agrees_with(atlas));
        match found {
            Err(NotPlaced::Cells(_)) => match proof() {
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

    /// Where the points (h, l) of a row lie; each double stands for its shortest decimal. Points without an answer are
    /// undecided. `None` without an atlas.
    ///
    /// # Errors
    /// [`Unanswered`] when l is out of range.
    pub fn row(&self, l: f64, h: &[f64]) -> Option<Result<Vec<Spot>, Unanswered>> {
        let decide = |h: &Number, l: &Number| {
            self.classify(h, l).map_or(Spot::Undecided, |found| self.spot(h, l, &found.answer))
        };
        Some(self.atlas()?.row(l, h, decide).map_err(|error| ClassifyError::from(error).into()))
    }
}
