//! Bisection on the class.

use thiserror::Error;

use super::event::{self, BorderEvent};
use super::segment::Segment;
use crate::atlas::Atlas;
use crate::class::Class;

/// How a border is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorderOptions {
    /// The border is wanted to this in every parameter.
    pub tolerance: f64,
    /// The most atlases that are made.
    pub atlases_max: u32,
}

impl Default for BorderOptions {
    fn default() -> Self {
        Self { tolerance: 1e-10, atlases_max: 600 }
    }
}

/// A place where the class changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// The class at the first end is that of `classes[0]`, at the second another one. Nothing is known between.
    pub t: [f64; 2],
    /// The classes at the two ends.
    pub classes: [Class; 2],
    /// True when the two ends are as close as was wanted.
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

fn look(segment: &Segment, t: f64) -> Result<Seen, String> {
    let atlas = Atlas::new(&segment.body(t)).map_err(|error| error.to_string())?;
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
    let end = |t: f64, end: &'static str| look(segment, t).map_err(|reason| BorderError::NoClass { end, reason });
    let (mut low, mut high) = ((0.0, end(0.0, "lower")?), (1.0, end(1.0, "upper")?));
    if low.1.class == high.1.class {
        return Err(BorderError::SameClass { class: low.1.class.id().to_owned() });
    }
    let wanted = options.tolerance / segment.length().max(f64::MIN_POSITIVE);
    let mut atlases = 2;
    // A zone where nothing is decided, once one was met.
    let mut zone: Option<[f64; 2]> = None;
    while high.0 - low.0 > wanted && atlases < options.atlases_max {
        let zone_now = zone.unwrap_or([high.0, low.0]);
        let t = match zone {
            None => 0.5 * (low.0 + high.0),
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
        match look(segment, t) {
            Ok(seen) if seen.class == low.1.class => low = (t, seen),
            Ok(seen) => high = (t, seen),
            Err(_undecided) => zone = Some([zone_now[0].min(t), zone_now[1].max(t)]),
        }
        // Decided bodies beyond the zone make it pointless.
        zone = zone.filter(|[from, to]| *from > low.0 && *to < high.0);
    }
    let event = event::between(&low.1, &high.1);
    let reached = high.0 - low.0 <= wanted;
    Ok(Border { t: [low.0, high.0], classes: [low.1.class, high.1.class], reached, event, atlases })
}
