//! The certificate of a proved atlas.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::CertifiedAtlas;
use super::arrange::{Arrangement, EventSource, Slab};
use super::curves::{Place, Shape};
use super::evaluator::{Evaluator, Evaluators};
use super::family::Half;
use super::model::exact_unit;
use super::pair::{Proof, Stretch, StretchEnd};
use bifdiag_diagram::arrangement::EventId;
use bifdiag_equilibria::curves::{CurveId, CurveName, End, Pole};
use bifdiag_numbers::decimal;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::Id;
use bifdiag_numbers::wide::Interval384;
use bifdiag_numbers::{Number, Sign};
use bifdiag_schema::{
    CertificateDocument, CertificateUnits, CertifiedCusp, CertifiedEvent, CertifiedHeight, CertifiedMeeting,
    CertifiedNode, CertifiedPair, CertifiedSample, CertifiedSlab, CertifiedStretch, PlaceDocument,
};

/// Digits of isolating ranges, where no events lie closer together than a third of them.
const ROOT_DIGITS: usize = 66;
/// Digits of events, and of the positions of nodes known better than in doubles: fewer than of roots, so that a second
/// arithmetic confirms them.
const FINE_DIGITS: usize = 44;
/// Digits of the places of nodes that are known to doubles.
const NODE_DIGITS: usize = 24;

impl CertifiedAtlas {
    /// Name of a curve.
    pub(super) fn name(&self, curve: CurveId) -> CurveName {
        self.arrangement.curves.list[curve].name(&self.frame)
    }

    fn id(&self, curve: CurveId) -> String {
        self.name(curve).to_string()
    }

    /// The certificate, without its checksum.
    #[must_use]
    pub fn certificate(&self) -> CertificateDocument {
        let a = &self.arrangement;
        let names = |list: &[CurveId]| list.iter().map(|&c| self.id(c)).collect::<Vec<_>>();
        let evaluators = &Evaluators::new(&a.model, &a.curves, &[]);
        let spacing = Spacing::of(a);
        let root = |place: &Place| root(place, spacing.digits + ROOT_DIGITS - FINE_DIGITS);
        CertificateDocument {
            units: self.units(),
            bits: self.bits(),
            cusps: a
                .curves
                .cusps
                .iter()
                .map(|cusp| CertifiedCusp { place: root(&cusp.place), curves: cusp.curves.map(|c| self.id(c)) })
                .collect(),
            inflection: a.curves.inflection.as_ref().map(|(_, place)| root(place)),
            meetings: a
                .meetings
                .iter()
                .map(|meeting| CertifiedMeeting {
                    pole: if meeting.pole == Pole::Plus { "+" } else { "-" }.to_owned(),
                    place: root(&meeting.place),
                    curves: names(&meeting.curves),
                    touch: meeting.touch,
                })
                .collect(),
            pairs: a
                .pairs
                .iter()
                .map(|pair| CertifiedPair {
                    curves: pair.curves.map(|c| self.id(c)),
                    stretches: pair.stretches.iter().map(|s| self.stretch(evaluators, pair.curves, s)).collect(),
                })
                .collect(),
            events: a
                .events
                .iter()
                .map(|event| CertifiedEvent {
                    sources: event.sources.iter().map(source).collect(),
                    curves: names(&event.curves),
                    x: spacing.outward(&event.x),
                    h: decimal::outward(&event.h.map(super::region::exact), NODE_DIGITS),
                })
                .collect(),
            transitions: a.transitions.iter().map(|group| group.iter().map(|e| e.index()).collect()).collect(),
            slabs: a.slabs.iter().map(|slab| self.slab(evaluators, slab)).collect(),
            samples: self
                .regions
                .pairs()
                .filter_map(|(id, region)| {
                    let sample = region.sample.as_ref()?;
                    let h = decimal::exact(&sample.h);
                    Some(CertifiedSample { region: id.to_string(), slab: sample.cell.slab.index(), h })
                })
                .collect(),
            checksum: String::new(),
        }
    }

    fn units(&self) -> CertificateUnits {
        let energy = exact_unit(self.frame.energy_unit);
        let momentum = exact_unit(self.frame.momentum_unit);
        let moment = &momentum * &momentum / &energy;
        CertificateUnits { moment: decimal::exact(&moment), energy: decimal::exact(&energy) }
    }

    fn stretch(&self, evaluators: &Evaluators<'_>, curves: [CurveId; 2], stretch: &Stretch) -> CertifiedStretch {
        CertifiedStretch {
            from: self.node(evaluators, curves, &stretch.x[0], 0),
            to: self.node(evaluators, curves, &stretch.x[1], 1),
            sign: stretch.sign.into(),
            crossing: match &stretch.proof {
                Proof::Crossing(x) => {
                    Some(x.each_ref().map(|x| self.node(evaluators, curves, &StretchEnd::At(x.clone()), 0)))
                }
                Proof::Constant => None,
            },
        }
    }

    fn slab(&self, evaluators: &Evaluators<'_>, slab: &Slab) -> CertifiedSlab {
        let curves = slab.order.iter().zip(&slab.region_above).map(|(&curve, region)| CertifiedHeight {
            curve: self.id(curve),
            place: place_over(evaluators.narrow(), curve, &slab.x)
                .or_else(|| place_over(evaluators.wide(), curve, &slab.x)),
            region: region.to_string(),
        });
        CertifiedSlab { x: decimal::exact(&slab.x), curves: curves.collect() }
    }

    /// The number of the slab in which l²/2 lies, and its curves over it with their places; `None` where l is 0, or too close
    /// to an event.
    #[must_use]
    pub fn level(&self, l: &Number) -> Option<(usize, CertifiedSlab)> {
        let a = &self.arrangement;
        let l = l.value() / exact_unit(self.frame.momentum_unit);
        let x = &l * &l / RBig::from(2);
        let range = |group: &Vec<EventId>| {
            let ends = |side: usize| group.iter().map(move |&event| &a.events[event].x[side]);
            Some([ends(0).min()?, ends(1).max()?])
        };
        let ranges: Vec<[&RBig; 2]> = a.transitions.iter().filter_map(range).collect();
        let number = ranges.iter().filter(|[_, high]| x > **high).count();
        if x <= RBig::ZERO || ranges.get(number).is_some_and(|[low, _]| x >= **low) {
            return None;
        }
        let slab = a.slabs.iter().nth(number)?;
        let slab = Slab { x, ..slab.clone() };
        Some((number, self.slab(&Evaluators::new(&a.model, &a.curves, &[]), &slab)))
    }

    /// A node of a pair; `side` says which end of the common range an unmarked one is.
    fn node(&self, evaluators: &Evaluators<'_>, curves: [CurveId; 2], mark: &StretchEnd, side: usize) -> CertifiedNode {
        if let StretchEnd::At(x) = mark {
            let places =
                curves.map(|c| place_over(evaluators.narrow(), c, x).or_else(|| place_over(evaluators.wide(), c, x)));
            let [Some(p), Some(q)] = places else { return CertifiedNode { x: Some(decimal::exact(x)), places: None } };
            return CertifiedNode { x: Some(decimal::exact(x)), places: Some([p, q]) };
        }
        CertifiedNode { x: None, places: self.end_places(evaluators.wide(), curves, side) }
    }

    /// Places at the beginning or end of the common range, where one curve ends and the other continues.
    fn end_places(
        &self,
        wide: &Evaluator<'_, Interval384>,
        curves: [CurveId; 2],
        side: usize,
    ) -> Option<[PlaceDocument; 2]> {
        let ends = curves.map(|c| self.arrangement.curves.list[c].ends[side]);
        if ends[0] == ends[1] {
            return None;
        }
        let reach = |which: usize| match ends[which] {
            End::Cusp(_) | End::Pitchfork(_) => wide.end_x(curves[which], side),
            _ => None,
        };
        let x = [reach(0), reach(1)];
        let ending = match &x {
            [Some(p), Some(q)] => usize::from(p.is_below(q) == (side == 0)),
            [Some(_), None] => 0,
            _ => 1,
        };
        let end = wide.end_point(curves[ending], side)?;
        let opposite = wide.point(curves[1 - ending], &end.x)?;
        let p = match ends[ending] {
            // It holds the whole range in which the cusp is isolated.
            End::Cusp(cusp) => root(&self.arrangement.curves.cusps[cusp].place, ROOT_DIGITS),
            _ => document(&end.place?, ROOT_DIGITS)?,
        };
        // The place opposite must hold x of that range.
        let q = document(&opposite.place?, FINE_DIGITS)?;
        Some(if ending == 0 { [p, q] } else { [q, p] })
    }
}

fn source(source: &EventSource) -> String {
    match source {
        EventSource::Cusp(n) => format!("cusp:{}", n.index()),
        EventSource::Pitchfork(n) => format!("pitchfork:{}", n.index()),
        EventSource::Pole(n) => format!("meeting:{}", n.index()),
        EventSource::Crossing(_) => "crossing".to_owned(),
    }
}

/// How the enclosures of events are written so that those of two transitions are as much apart as they are proved to be.
struct Spacing {
    /// The least distance between two transitions.
    gap: Option<RBig>,
    digits: usize,
}

impl Spacing {
    fn of(arrangement: &Arrangement) -> Self {
        let end = |group: &[EventId], side: usize| {
            let ends = group.iter().map(|&event| &arrangement.events[event].x[side]);
            if side == 0 { ends.min() } else { ends.max() }
        };
        let groups: Vec<&Vec<EventId>> = arrangement.transitions.iter().collect();
        let gaps = groups.windows(2).filter_map(|pair| {
            let (from, to) = (end(pair[0], 1)?, end(pair[1], 0)?);
            Some((to - from, to))
        });
        let mut spacing = Self { gap: None, digits: FINE_DIGITS };
        for (gap, x) in gaps.filter(|(gap, _)| *gap > RBig::ZERO) {
            // Rounding to these moves an end by less than a fortieth of the gap.
            let digits = (x * RBig::from(4) / &gap).ceil().to_string().len() + 2;
            spacing.digits = spacing.digits.max(digits);
            spacing.gap = Some(spacing.gap.into_iter().fold(gap, Ord::min));
        }
        spacing
    }

    /// With a little room, so that a second arithmetic with roundings of its own can confirm the enclosure.
    fn outward(&self, [lo, hi]: &[RBig; 2]) -> [String; 2] {
        let room = hi / RBig::from(IBig::ONE << 140);
        let room = self.gap.iter().map(|gap| gap / RBig::from(8)).fold(room, Ord::min);
        decimal::outward(&[lo - &room, hi + room], self.digits)
    }
}

/// The point of a curve of a family at x.
fn place_over<E: Enclosure>(evaluator: &Evaluator<'_, E>, curve: CurveId, x: &RBig) -> Option<PlaceDocument> {
    let Shape::Family(_) = evaluator.curves.list[curve].shape else { return None };
    let point = evaluator.point(curve, &E::rational(x, evaluator.c.precision))?;
    let place = point.place.as_ref()?;
    let [lo, hi] = place.1.exact_bounds()?;
    // Rounding must not reach beyond the end of a curve that is near.
    let is_coarse = (hi.clone() - lo) * RBig::from(IBig::from(10).pow(NODE_DIGITS - 4)) > hi;
    document(place, if is_coarse { NODE_DIGITS } else { FINE_DIGITS })
}

fn document<E: Enclosure>((half, y): &(Half, E), digits: usize) -> Option<PlaceDocument> {
    Some(of_half(*half, decimal::outward(&y.exact_bounds()?, digits)))
}

fn root(place: &Place, digits: usize) -> PlaceDocument {
    of_half(place.half, decimal::outward(&[place.lo.clone(), place.hi.clone()], digits))
}

fn of_half(half: Half, y: [String; 2]) -> PlaceDocument {
    let (base, side) = match half {
        Half::Generic { base, sign: Sign::Positive } => (base, "+"),
        Half::Generic { base, .. } => (base, "-"),
        Half::Over { group } => (group, "over"),
    };
    PlaceDocument { base, side: side.to_owned(), y }
}
