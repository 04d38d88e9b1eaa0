//! A body that is asked many questions: its atlas is made once, when it is first needed.

use std::sync::OnceLock;

use top::atlas::{Atlas, Spot};
use top::body::{Body, Number};
use top::classify::{Answer, Classification, ClassifyError};

use crate::accuracy::{Accuracy, Unanswered, classify, proved_atlas, quick_atlas};
use crate::work::{Question, Rung, decided};

/// A body and what is known of it.
#[derive(Debug)]
pub struct Prepared {
    body: Body,
    accuracy: Accuracy,
    quick: OnceLock<Option<Atlas>>,
    proved: OnceLock<Option<Atlas>>,
}

impl Prepared {
    /// Nothing is computed yet.
    #[must_use]
    pub fn new(body: Body, accuracy: Accuracy) -> Self {
        Self { body, accuracy, quick: OnceLock::new(), proved: OnceLock::new() }
    }

    /// One whose atlas is made already.
    #[must_use]
    pub fn of(atlas: Atlas, accuracy: Accuracy) -> Self {
        Self { body: atlas.body().clone(), accuracy, quick: OnceLock::from(Some(atlas)), proved: OnceLock::new() }
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
        let proved = || self.proved.get_or_init(|| proved_atlas(&self.body, self.accuracy)).as_ref();
        self.quick().or_else(proved)
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

    /// Where the points (h, l) of a row lie; each double stands for its shortest decimal. Points without an answer are
    /// undecided. `None` without an atlas.
    ///
    /// # Errors
    /// [`Unanswered`] when l is out of range.
    pub fn row(&self, l: f64, h: &[f64]) -> Option<Result<Vec<Spot>, Unanswered>> {
        let decide = |h: &Number, l: &Number| {
            self.classify(h, l).map_or_else(|_unanswered| Answer::Undecided(Vec::new()), |found| found.answer)
        };
        Some(self.atlas()?.row(l, h, decide).map_err(|error| ClassifyError::from(error).into()))
    }
}
