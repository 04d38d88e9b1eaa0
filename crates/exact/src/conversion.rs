//! A proved atlas in the terms of the `f64` one: its curves, and events and regions as proved.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::arrange::{self, Event, EventSource};
use super::id::TransitionId;
use super::region::{self, Margin, Region, Sample, exact};
use super::{CertifiedAtlas, ConversionError};
use bifdiag_diagram::arrangement::{self, Arrangement, Cell, Change, EventId, RegionId, SlabId};
use bifdiag_diagram::atlas::{self, Atlas};
use bifdiag_diagram::topology::merge::MergeError;
use bifdiag_equilibria::curves::{CriticalSet, CurveId};
use bifdiag_numbers::decimal;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::table::Table;
use bifdiag_numbers::wide::Wide;
use bifdiag_schema::EnclosureDocument;

/// Bits and digits of the enclosures of l.
const BITS: usize = 160;
const DIGITS: usize = 24;

impl CertifiedAtlas {
    /// The atlas in the standard program's terms, whose curves are only drawn, with everything that is decided taken
    /// from the proof.
    ///
    /// # Errors
    /// [`ConversionError`] when the curves in `f64`, which give the polylines, are not those that are proved.
    pub fn to_atlas(&self) -> Result<Atlas, ConversionError> {
        let set = CriticalSet::new(self.frame.clone()).map_err(ConversionError::Equilibria)?;
        let proved = &self.arrangement;
        let map: Option<Table<CurveId, CurveId>> = proved
            .curves
            .list
            .iter()
            .map(|curve| {
                let same = |c: &CurveId| set.curves[*c].branch == curve.branch && set.curves[*c].piece == curve.piece;
                set.curves.ids().find(same)
            })
            .collect();
        let map = map.filter(|map| map.len() == set.curves.len()).ok_or(ConversionError::Curves)?;
        let arrangement = Arrangement {
            slabs: self.converted_slabs(&map),
            region_count: proved.region_count,
            events: self.converted_events(&map),
            undecided: Vec::new(),
            evaluations: 0,
            set,
        };
        Ok(Atlas::of_parts(self.body.clone(), arrangement, self.converted_regions(&map)))
    }

    fn converted_events(&self, map: &Table<CurveId, CurveId>) -> Table<EventId, arrangement::Event> {
        let proved = &self.arrangement;
        let events = proved.transitions.iter().flatten().flat_map(|&number| {
            let event = &proved.events[number];
            let x = event.x_middle();
            let (h, h_error) = (event.h_middle(), event.h[1] - event.h[0]);
            // x, its root and the product with a unit are rounded.
            let x_error = (double(&event.x[1]) - double(&event.x[0])).max(4.0 * f64::EPSILON * x);
            event.sources.iter().map(move |source| arrangement::Event {
                change: change(proved, event, source, map),
                x,
                x_error,
                h,
                h_error: h_error.max(f64::EPSILON * h.abs()),
            })
        });
        events.collect()
    }

    fn converted_slabs(&self, map: &Table<CurveId, CurveId>) -> Table<SlabId, arrangement::Slab> {
        let proved = &self.arrangement;
        let x = |transition| proved.transitions.get(transition).map(|group| proved.events[group[0]].x_middle());
        let slabs = proved.slabs.pairs().map(|(number, slab)| arrangement::Slab {
            x: [
                TransitionId::at_start(number).and_then(x).unwrap_or(0.0),
                x(TransitionId::at_end(number)).unwrap_or(f64::INFINITY),
            ],
            order: slab.order.iter().map(|&c| map[c]).collect(),
            region_above: slab.region_above.clone(),
        });
        slabs.collect()
    }

    fn converted_regions(&self, map: &Table<CurveId, CurveId>) -> Table<RegionId, atlas::Region> {
        let regions = self.regions.iter().map(|region| {
            let sample = self.converted_sample(region, map);
            atlas::Region {
                cells: region.cells.clone(),
                sample,
                components: region.components.clone().map_err(|_unproved| MergeError::UnknownOrder),
            }
        });
        regions.collect()
    }

    /// The doubles nearest to the sample of a region, with the margin of the sample itself and an error for the rounding too. A
    /// region without a sample has the height of the curve below it.
    fn converted_sample(&self, region: &Region, map: &Table<CurveId, CurveId>) -> atlas::Sample {
        let proved = &self.arrangement;
        let below = || {
            let Cell { slab, position } = region.cells[0];
            let (strip, [lo, hi]) = (&proved.slabs[slab], proved.slabs[slab].heights[position]);
            (slab, exact(hi), Margin { distance: [0.0, (hi - lo).next_up()], nearest: strip.order[position] })
        };
        let of_sample = |sample: &Sample| (sample.cell.slab, sample.h.clone(), sample.margin);
        let (slab, h, Margin { distance: [least, most], nearest }) =
            region.sample.as_ref().map_or_else(below, of_sample);
        let exact_x = &proved.slabs[slab].x;
        let (x, rounded_h) = (double(exact_x), double(&h));
        let rounding = region::rounding([exact_x, &h], [(2.0 * x).sqrt(), rounded_h], most, self.frame.r_norm);
        let error = ((most - least).next_up() + rounding).next_up();
        atlas::Sample { x, h: rounded_h, margin: least, error, nearest: map[nearest] }
    }

    /// Proved bounds of the events, in the order in which [`Self::to_atlas`] has them.
    #[must_use]
    pub fn enclosures(&self) -> Vec<EnclosureDocument> {
        let of_event = |&number: &EventId| {
            let event = &self.arrangement.events[number];
            std::iter::repeat_n(self.enclosure(event), event.sources.len())
        };
        self.arrangement.transitions.iter().flatten().flat_map(of_event).collect()
    }

    fn enclosure(&self, event: &Event) -> EnclosureDocument {
        // Room for the roundings of the certificate, which states x and h too.
        let roomy = |[lo, hi]: [RBig; 2], bits: usize| {
            let size = lo.clone().max(-lo.clone()).max(hi.clone()).max(-hi.clone());
            let room = size / RBig::from(IBig::ONE << bits);
            Wide::rational(&(lo - &room), BITS).hull(&Wide::rational(&(hi + room), BITS))
        };
        let x = roomy(event.x.clone(), 136);
        let l = (Wide::small(2, BITS) * x).sqrt() * Wide::double(self.frame.momentum_unit, BITS);
        let h = roomy(event.h.map(exact), 72) * Wide::double(self.frame.energy_unit, BITS);
        let text = |set: &Wide| {
            let bounds = set.exact_bounds();
            bounds.map_or(["-inf".to_owned(), "inf".to_owned()], |bounds| decimal::outward(&bounds, DIGITS))
        };
        EnclosureDocument { l: text(&l), h: text(&h) }
    }
}

fn double(x: &RBig) -> f64 {
    x.to_f64().value()
}

/// What an event does, in the standard program's terms.
fn change(proved: &arrange::Arrangement, event: &Event, source: &EventSource, map: &Table<CurveId, CurveId>) -> Change {
    let curves = &proved.curves;
    match source {
        EventSource::Cusp(number) => {
            let cusp = &curves.cusps[*number];
            let pair = cusp.curves.map(|c| map[c]);
            if cusp.opens { Change::Birth(pair) } else { Change::Death(pair) }
        }
        EventSource::Pitchfork(number) => {
            let fork = &curves.pitchforks[*number];
            let (through, pair) = (fork.through.map(|c| map[c]), map[fork.pair]);
            if fork.opens { Change::Open { through, pair } } else { Change::Close { through, pair } }
        }
        EventSource::Crossing(pair) => Change::Swap(pair.map(|c| map[c])),
        EventSource::Pole(number) => {
            // At a cusp or pitchfork more curves meet: the first that crosses the line there stands for them.
            let crossing = proved.meetings[*number].curves[0];
            let line = event.curves.iter().copied().find(|&c| curves.list[c].pole.is_some()).unwrap_or(crossing);
            let [first, second] = [map[crossing], map[line]];
            Change::Swap([first.min(second), first.max(second)])
        }
    }
}
