//! Bisection on the class between two bodies.

use std::collections::BTreeMap;

use thiserror::Error;

use super::difference;
use super::event::BorderEvent;
use super::segment::BodySegment;
use super::special::{explained, special as special_body};
use super::vanishing::{self, ParameterRoot, Vanishing};
use bifdiag_body::{Body, Flags};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::{Class, ClassName, Unclassified};
use bifdiag_exact::{Accuracy, AnswerError};

/// Where an interval is cut: not in the middle, where special bodies lie.
const GOLDEN: f64 = 0.381_966_011_250_105_2;

/// Looks between two tries to go to the zero.
const LOOKS: u32 = 3;

/// The most borders that [`all`] looks for.
const BORDERS_MAX: usize = 32;

/// How a border is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorderOptions {
    /// The border is wanted to this in every parameter.
    pub tolerance: f64,
    /// The most atlases that are made.
    pub atlases_max: u32,
    /// What the classes must be worth.
    pub accuracy: Accuracy,
    /// Go to the zero of what vanishes between the two diagrams as soon as their classes confirm it on both sides: a border as
    /// sure as by bisection, with a quarter of the atlases; of several between the ends it may be another one.
    pub by_zeros: bool,
}

impl Default for BorderOptions {
    fn default() -> Self {
        Self { tolerance: 1e-10, atlases_max: 600, accuracy: Accuracy::Exact, by_zeros: false }
    }
}

/// A place where the class changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// The class at the first end is that of `classes[0]`, at the second another one. Nothing is known between.
    pub enclosure: [f64; 2],
    /// Where between them it changes.
    pub t: f64,
    /// Estimate of the error of `t`.
    pub error: f64,
    /// The classes at the two ends.
    pub classes: [Class; 2],
    /// True when the error is as small as was wanted.
    pub reached: bool,
    /// What happens there.
    pub event: BorderEvent,
    /// Atlases that were made.
    pub atlases: u32,
}

impl Border {
    /// The border of a part of a way, the one between these two places, as one of the whole way.
    pub(crate) fn on_the_whole(self, [from, to]: [f64; 2]) -> Self {
        let whole = |t: f64| from + (to - from) * t;
        Self { enclosure: self.enclosure.map(whole), t: whole(self.t), error: self.error * (to - from), ..self }
    }
}

/// Why there is no border.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BorderError {
    /// An end of the way has no class.
    #[error("the body at the {end} end has no class: {source}")]
    NoClass {
        /// Lower (t = 0) or upper (t = 1).
        end: &'static str,
        /// Why.
        source: NoClass,
    },
    /// Both ends have one class.
    #[error(
        "both ends have the class {class}; a border is searched between two classes: take ends of different classes"
    )]
    SameClass {
        /// Its name.
        class: ClassName,
    },
}

/// Finds a border between the ends of a segment. Where several lie between, it finds one of them.
///
/// Bodies near a border may be undecided; then both sides of that zone are sought, and the border lies between.
///
/// # Errors
/// [`BorderError`].
pub fn find(segment: &BodySegment, options: &BorderOptions) -> Result<Border, BorderError> {
    let side = |t: f64, end| {
        ClassifiedBody::of(segment, t, options.accuracy).map_err(|source| BorderError::NoClass { end, source })
    };
    Ok(between(segment, [side(0.0, "lower")?, side(1.0, "upper")?], options)?.0)
}

/// The same where the atlases and classes of both ends are known, with what vanishes at the border.
///
/// # Errors
/// [`BorderError::SameClass`].
pub(crate) fn find_between(
    segment: &BodySegment,
    [low, high]: [(Atlas, Class); 2],
    options: &BorderOptions,
) -> Result<(Border, Vanishing), BorderError> {
    between(segment, [ClassifiedBody::new(0.0, low), ClassifiedBody::new(1.0, high)], options)
}

fn between(
    segment: &BodySegment,
    ends: [ClassifiedBody; 2],
    options: &BorderOptions,
) -> Result<(Border, Vanishing), BorderError> {
    let mut bracket = ClassBracket::new(segment, ends, options)?;
    for looks in 1.. {
        let Some(t) = bracket.next() else { break };
        bracket.look(t);
        if options.by_zeros && looks % LOOKS == 0 {
            bracket.jump();
        }
    }
    let ClassBracket { low, high, wanted, atlases, .. } = bracket;
    let (mut event, vanishing) = difference::between(low.atlas.arrangement(), high.atlas.arrangement());
    let enclosure = [low.t, high.t];
    let by_class = ParameterRoot { t: 0.5 * (low.t + high.t), error: 0.5 * (high.t - low.t) };
    let inside = |root: &ParameterRoot| enclosure[0] <= root.t && root.t <= enclosure[1];
    let by_diagram = vanishing::root(segment, &vanishing, enclosure).filter(inside);
    let (special, by_body) = special_body(segment, enclosure).unzip();
    let kind = explained(special, event.kind.clone(), by_diagram.is_some());
    let by_zero = if by_body.is_some() && kind.is_of_the_body() {
        (event.curves, event.place) = (Vec::new(), None);
        by_body
    } else {
        if let Some(place) = by_diagram.as_ref().and_then(|root| vanishing::place(segment, &vanishing, root)) {
            event.place = Some(place);
        }
        by_diagram
    };
    event.kind = kind;
    let ParameterRoot { t, error } = by_zero.unwrap_or(by_class);
    let reached = error <= wanted;
    Ok((Border { enclosure, t, error, classes: [low.class, high.class], reached, event, atlases }, vanishing))
}

/// The borders of a segment in order: what [`find`] finds, and again behind it until the class is that of the upper end.
/// None where an end has no class, or both have one.
#[must_use]
pub fn all(segment: &BodySegment, options: &BorderOptions) -> Vec<Border> {
    let mut borders = Vec::new();
    let Ok(last) = ClassifiedBody::of(segment, 1.0, options.accuracy) else { return borders };
    let mut from = 0.0;
    while borders.len() < BORDERS_MAX {
        let rest = BodySegment::new(segment.body(from), segment.body(1.0));
        let Ok(border) = find(&rest, options) else { break };
        // The class below a border is that of the lower end; above it bisection may have met any other.
        let border = border.on_the_whole([from, 1.0]);
        from = border.enclosure[1];
        let is_last = border.classes[1] == last.class;
        borders.push(border);
        if is_last {
            break;
        }
    }
    borders
}

/// The part of a segment that holds the border.
struct ClassBracket<'a> {
    segment: &'a BodySegment,
    options: &'a BorderOptions,
    low: ClassifiedBody,
    high: ClassifiedBody,
    /// A zone where nothing is decided, once one was met.
    zone: Option<[f64; 2]>,
    /// The width of t that is wanted.
    wanted: f64,
    /// What is special about the bodies of the segment.
    ordinary: Flags,
    atlases: u32,
}

impl<'a> ClassBracket<'a> {
    fn new(
        segment: &'a BodySegment,
        [low, high]: [ClassifiedBody; 2],
        options: &'a BorderOptions,
    ) -> Result<Self, BorderError> {
        if low.class == high.class {
            return Err(BorderError::SameClass { class: low.class.name().clone() });
        }
        let wanted = options.tolerance / segment.length().max(f64::MIN_POSITIVE);
        Ok(Self { segment, options, low, high, zone: None, wanted, ordinary: shown(&segment.body(GOLDEN)), atlases: 2 })
    }

    /// Where to look next; `None` when nothing more is to be gained.
    fn next(&self) -> Option<f64> {
        let (low, high) = (self.low.t, self.high.t);
        if high - low <= self.wanted || self.atlases >= self.options.atlases_max {
            return None;
        }
        let t = match self.zone {
            None => low + GOLDEN * (high - low),
            // The wider of the two gaps beside the zone.
            Some([from, to]) if from - low >= high - to => 0.5 * (low + from),
            Some([_, to]) => 0.5 * (to + high),
        };
        if t <= low || t >= high {
            return None;
        }
        if let Some([from, to]) = self.zone {
            // What is gained beside the zone is not worth more atlases once it is small against the zone.
            let little = (from - low).max(high - to) < 0.01 * (to - from).max(self.wanted);
            if little || (from..=to).contains(&t) {
                return None;
            }
        }
        Some(t)
    }

    /// Goes to the zero of what vanishes, if the classes on both sides of it are those of a border.
    fn jump(&mut self) {
        /// Distances from the zero at which classes are asked, in units of the wanted width: rounding may leave the first open.
        const SIDES: [f64; 2] = [0.4, 400.0];
        if self.zone.is_some() {
            return;
        }
        let (_, vanishing) = difference::between(self.low.atlas.arrangement(), self.high.atlas.arrangement());
        let ends = [self.low.t, self.high.t];
        let Some(root) = vanishing::root(self.segment, &vanishing, ends) else { return };
        for side in SIDES.map(|side| (side * self.wanted).max(2.0 * root.error)) {
            let beside = [root.t - side, root.t + side];
            if beside[0] <= ends[0] || beside[1] >= ends[1] {
                return;
            }
            self.atlases += 2;
            let [Ok(low), Ok(high)] = beside.map(|t| ClassifiedBody::of(self.segment, t, Accuracy::Fast)) else {
                continue;
            };
            let is_ordinary = [&low, &high].into_iter().all(|side| side.shown == self.ordinary);
            if is_ordinary && low.class == self.low.class && high.class != self.low.class {
                (self.low, self.high) = (low, high);
            }
            return;
        }
    }

    fn look(&mut self, t: f64) {
        self.atlases += 1;
        // Inside, f64 gives a class or leaves a zone open, whose sides are sought; a proof would fill the zone in part.
        match ClassifiedBody::of(self.segment, t, Accuracy::Fast) {
            // Bodies that are more special than those around them lie on a border, and belong to neither side.
            Ok(side) if side.shown == self.ordinary => {
                if side.class == self.low.class {
                    self.low = side;
                } else {
                    self.high = side;
                }
            }
            Ok(_) | Err(_) => {
                let [from, to] = self.zone.unwrap_or([self.high.t, self.low.t]);
                self.zone = Some([from.min(t), to.max(t)]);
            }
        }
        // Decided bodies beyond the zone make it pointless.
        self.zone = self.zone.filter(|[from, to]| *from > self.low.t && *to < self.high.t);
    }
}

/// What is special about a body, except the sums of its moments, which no diagram shows.
fn shown(body: &Body) -> Flags {
    Flags { plate: false, unphysical: false, ..body.flags() }
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
struct ClassifiedBody {
    t: f64,
    atlas: Atlas,
    class: Class,
    shown: Flags,
}

impl ClassifiedBody {
    fn of(segment: &BodySegment, t: f64, accuracy: Accuracy) -> Result<Self, NoClass> {
        Ok(Self::new(t, class_of(&segment.body(t), accuracy)?))
    }

    fn new(t: f64, (atlas, class): (Atlas, Class)) -> Self {
        Self { t, shown: shown(atlas.body()), atlas, class }
    }
}

/// How many of some bodies have each class, the most frequent first; `None` counts undecided and invalid bodies.
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
