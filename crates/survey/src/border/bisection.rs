//! Bisection on the class.

use thiserror::Error;

use super::event::{self, BorderEvent};
use super::refine::{self, Root};
use super::segment::Segment;
use proof::{Accuracy, atlas_of};
use top::atlas::Atlas;
use top::body::Flags;
use top::class::Class;

/// Where an interval is cut: not in the middle, where special bodies lie.
const GOLDEN: f64 = 0.381_966_011_250_105_2;

/// How a border is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorderOptions {
    /// The border is wanted to this in every parameter.
    pub tolerance: f64,
    /// The most atlases that are made.
    pub atlases_max: u32,
    /// What the classes must be worth.
    pub accuracy: Accuracy,
}

impl Default for BorderOptions {
    fn default() -> Self {
        Self { tolerance: 1e-10, atlases_max: 600, accuracy: Accuracy::Standard }
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

/// Why there is no border.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BorderError {
    /// An end of the way has no class.
    #[error("the body at the {end} end has no class: {reason}")]
    NoClass {
        /// Lower or upper.
        end: &'static str,
        /// Why.
        reason: String,
    },
    /// Both ends have one class.
    #[error("both ends have the class {class}; there is no border to find, or an even number of them")]
    SameClass {
        /// Its name.
        class: String,
    },
}

/// A body with its atlas and class.
pub(super) struct Seen {
    pub atlas: Atlas,
    pub class: Class,
}

fn look(segment: &Segment, t: f64, accuracy: Accuracy) -> Result<Seen, String> {
    let atlas = atlas_of(&segment.body(t), accuracy).map_err(|error| error.to_string())?;
    let class = Class::of(&atlas).map_err(|error| error.to_string())?;
    Ok(Seen { atlas, class })
}

/// Finds a border between the ends of a segment. Where several lie between, it finds one of them.
///
/// Bodies near a border may be undecided; then both sides of that zone are sought, and the border lies between.
///
/// # Errors
/// [`BorderError`].
pub fn find(segment: &Segment, options: &BorderOptions) -> Result<Border, BorderError> {
    let end = |t: f64, end: &'static str| {
        look(segment, t, options.accuracy).map_err(|reason| BorderError::NoClass { end, reason })
    };
    let (mut low, mut high) = ((0.0, end(0.0, "lower")?), (1.0, end(1.0, "upper")?));
    if low.1.class == high.1.class {
        return Err(BorderError::SameClass { class: low.1.class.id().to_owned() });
    }
    let wanted = options.tolerance / segment.length().max(f64::MIN_POSITIVE);
    let mut atlases = 2;
    // Bodies that are more special than those around them lie on a border, and belong to neither side.
    let ordinary = Flags { plate: false, unphysical: false, ..segment.body(GOLDEN).flags() };
    // A zone where nothing is decided, once one was met.
    let mut zone: Option<[f64; 2]> = None;
    while high.0 - low.0 > wanted && atlases < options.atlases_max {
        let zone_now = zone.unwrap_or([high.0, low.0]);
        let t = match zone {
            None => low.0 + GOLDEN * (high.0 - low.0),
            // The wider of the two gaps beside the zone.
            Some([from, to]) if from - low.0 >= high.0 - to => 0.5 * (low.0 + from),
            Some([_, to]) => 0.5 * (to + high.0),
        };
        if t <= low.0 || t >= high.0 || zone.is_some_and(|[from, to]| t >= from && t <= to) {
            break;
        }
        // What is gained beside the zone is not worth more atlases once it is small against the zone.
        if zone.is_some_and(|[from, to]| (from - low.0).max(high.0 - to) < 0.01 * (to - from).max(wanted)) {
            break;
        }
        atlases += 1;
        let is_special = |t: f64| Flags { plate: false, unphysical: false, ..segment.body(t).flags() } != ordinary;
        match look(segment, t, options.accuracy) {
            Ok(_) if is_special(t) => zone = Some([zone_now[0].min(t), zone_now[1].max(t)]),
            Ok(seen) if seen.class == low.1.class => low = (t, seen),
            Ok(seen) => high = (t, seen),
            Err(_undecided) => zone = Some([zone_now[0].min(t), zone_now[1].max(t)]),
        }
        // Decided bodies beyond the zone make it pointless.
        zone = zone.filter(|[from, to]| *from > low.0 && *to < high.0);
    }
    let (event, witness) = event::between(&low.1, &high.1);
    let enclosure = [low.0, high.0];
    let by_class = Root { t: 0.5 * (low.0 + high.0), error: 0.5 * (high.0 - low.0) };
    let inside = |root: &Root| enclosure[0] <= root.t && root.t <= enclosure[1];
    let Root { t, error } = refine::root(segment, &witness, enclosure).filter(inside).unwrap_or(by_class);
    let reached = error <= wanted;
    Ok(Border { enclosure, t, error, classes: [low.1.class, high.1.class], reached, event, atlases })
}
