//! The whole arrangement of a body.

use super::apart::{separate, transitions};
use super::event::{Event, Undecided, known_meetings, single_events};
use super::glue::glue;
use super::slab::{Slab, slabs};
use super::stages::{Stages, pairs};
use crate::curves::{Curves, IsolationError, ROOT_BITS};
use crate::evaluator::Evaluators;
use crate::id::{MeetingId, TransitionId};
use crate::model::Model;
use crate::pair::PairProof;
use crate::polar::{self, Meeting};
use bifdiag_diagram::arrangement::{EventId, SlabId};
use bifdiag_numbers::table::Table;

/// Everything that is proved of a body.
#[derive(Clone, Debug)]
pub(crate) struct Arrangement {
    pub model: Model,
    pub curves: Curves,
    pub meetings: Table<MeetingId, Meeting>,
    pub pairs: Vec<PairProof>,
    /// By rising x.
    pub events: Table<EventId, Event>,
    /// Numbers of the events between two slabs: more than one when they are not ordered and need not be.
    pub transitions: Table<TransitionId, Vec<EventId>>,
    pub slabs: Table<SlabId, Slab>,
    pub region_count: usize,
    /// Which precision was needed at most: 0 for `f64`.
    pub bits: usize,
}

/// The arrangement, if it can be proved with this many points of each pair of curves. With fewer than
/// [`POINTS`](crate::pair::POINTS) the first pair that is left open ends it.
pub(crate) fn arrange(model: Model, curves: &Curves, points: u32) -> Result<Arrangement, Vec<Undecided>> {
    if !curves.degenerate.is_empty() {
        return Err(vec![Undecided::Degenerate]);
    }
    let meetings = polar::meetings(&model, curves, ROOT_BITS).map_err(|IsolationError| vec![Undecided::Roots])?;
    let plain = Evaluators::new(&model, curves, &[]);
    let mut events = single_events(plain.wide(), &meetings)?;
    let known = known_meetings(curves, &events);
    let stages = Stages::new(&model, curves, &known, points);
    let (mut pairs, crossings) = pairs(plain.wide(), &stages)?;
    events.extend(crossings);
    let bits = stages.used.get().max(separate(&mut events, &mut pairs, &plain));
    let (events, transitions) = transitions(events)?;
    let stages = Stages::new(&model, curves, &[], points);
    let mut slabs = slabs(curves, &events, &transitions, &stages)?;
    let bits = bits.max(stages.used.get());
    let region_count = glue(&events, &transitions, &mut slabs)?;
    let curves = curves.clone();
    Ok(Arrangement { model, curves, meetings, pairs, events, transitions, slabs, region_count, bits })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair::POINTS;
    use bifdiag_body::{Body, Preset};

    fn arranged(body: &Body) -> Arrangement {
        let model = Model::new(body, &body.frame());
        let curves = Curves::of(&model).unwrap();
        arrange(model, &curves, POINTS).unwrap_or_else(|why| panic!("{body:?}: {why:?}"))
    }

    #[test]
    fn faces_are_those_of_the_standard_arrangement() {
        for preset in Preset::all() {
            let body = preset.body();
            let proved = arranged(&body);
            let standard = bifdiag_diagram::arrangement::Arrangement::new(
                bifdiag_equilibria::curves::CriticalSet::new(body.frame()).unwrap(),
            );
            assert_eq!(proved.region_count, standard.region_count, "{}", preset.name());
            assert_eq!(proved.events.len(), standard.events.len(), "{}", preset.name());
        }
    }

    #[test]
    fn the_triple_point_of_katoks_border_is_one_event() {
        let body = Body::parse(&["1", "5/9", "1/2"], &["1", "0", "0"]).unwrap();
        let proved = arranged(&body);
        let triple = proved.events.iter().find(|event| event.sources.len() > 1).unwrap();
        assert_eq!(triple.curves.len(), 4);
    }
}
