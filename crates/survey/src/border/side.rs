//! Bodies on the two sides of a border.

use std::collections::BTreeMap;
use std::fmt;

use thiserror::Error;

use super::segment::Segment;
use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::{Class, ClassName, Unclassified};
use bifdiag_exact::{Accuracy, AnswerError};

/// An end of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// t = 0.
    Lower,
    /// t = 1.
    Upper,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Lower { "lower" } else { "upper" })
    }
}

/// Why a body has no class.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NoClass {
    /// It has no atlas.
    #[error(transparent)]
    Atlas(#[from] AnswerError),
    /// Its diagram is open.
    #[error(transparent)]
    Diagram(#[from] Unclassified),
}

/// A body of a segment with its atlas and class.
pub(super) struct Side {
    pub t: f64,
    pub atlas: Atlas,
    pub class: Class,
}

impl Side {
    pub(super) fn of(segment: &Segment, t: f64, accuracy: Accuracy) -> Result<Self, NoClass> {
        let (atlas, class) = class_of(&segment.body(t), accuracy)?;
        Ok(Self { t, atlas, class })
    }
}

/// How many of some bodies have each class, the most frequent first; no class stands for bodies whose class is not decided,
/// and for those that are none.
#[must_use]
pub fn classes_of(bodies: impl Iterator<Item = Option<Body>>) -> Vec<(Option<ClassName>, usize)> {
    let mut counts: BTreeMap<Option<ClassName>, usize> = BTreeMap::new();
    for body in bodies {
        let class = body.and_then(|body| class_of(&body, Accuracy::Exact).ok());
        *counts.entry(class.map(|(_, class)| class.name().clone())).or_default() += 1;
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by(|(p, p_count), (q, q_count)| q_count.cmp(p_count).then_with(|| p.cmp(q)));
    counts
}

/// The atlas and the class of a body.
///
/// # Errors
/// [`NoClass`].
pub fn class_of(body: &Body, accuracy: Accuracy) -> Result<(Atlas, Class), NoClass> {
    let atlas = bifdiag_exact::atlas(body, accuracy)?;
    let class = Class::of(&atlas)?;
    Ok((atlas, class))
}
