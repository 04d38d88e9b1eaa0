//! The arrangement: events in proved order, vertical orders, faces.

use std::cell::{Cell, OnceCell};

use dashu_ratio::RBig;

use super::curves::{Curves, NotIsolated, ROOT_BITS, Shape};
use super::id::{MeetingId, TransitionId};
use super::model::Model;
use super::pair::{Open, POINTS, PairProof, Proof};
use super::point::{Evaluator, Passage, Point};
use super::polar::{self, Meeting};
use super::work::{Question, Rung, decided};
use numbers::Sign;
use numbers::enclosure::Enclosure;
use numbers::interval::Interval;
use numbers::partition::Partition;
use numbers::wide::{Interval128, Interval384};
use top::curves::{CurveId, CuspId, End, PitchforkId};
use top::diagram::{EventId, RegionId, SlabId};
use top::table::{Id, Table};

/// Bits of the second and third stage.
pub(super) const STAGES: [usize; 2] = [128, 384];

/// What an event is.
#[derive(Clone, Debug)]
pub(super) enum Source {
    Cusp(CuspId),
    Pitchfork(PitchforkId),
    Pole(MeetingId),
    /// Crossing of these two.
    Crossing([CurveId; 2]),
}

/// A point at which curves meet; several sources when they are proved to be the same point.
#[derive(Clone, Debug)]
pub(super) struct Event {
    pub sources: Vec<Source>,
    pub curves: Vec<CurveId>,
    /// x lies strictly between, or at, these.
    pub x: [RBig; 2],
    pub h: [f64; 2],
}

/// A strip between events.
#[derive(Clone, Debug)]
pub(super) struct Slab {
    /// The abscissa at which the order is proved.
    pub x: RBig,
    /// l with x = l²/2, if it is a double.
    pub l: Option<f64>,
    /// Curves by rising h.
    pub order: Vec<CurveId>,
    /// Enclosures of their heights.
    pub heights: Vec<[f64; 2]>,
    /// Region above each curve.
    pub region_above: Vec<RegionId>,
}

/// Why nothing more is proved.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Undecided {
    /// Roots that cannot be told apart.
    Roots,
    /// A cusp on a pitchfork, or a degenerate point of the generic family.
    Degenerate,
    /// The order of two curves.
    Pair { curves: [CurveId; 2], x: [f64; 2] },
    /// Two events on a common curve.
    Events { curves: Vec<CurveId>, x: [f64; 2] },
    /// The order over one abscissa.
    Order { x: f64 },
    /// Orders on both sides of an event do not fit it.
    Gluing { x: f64 },
}

/// Everything that is proved of a body.
#[derive(Clone, Debug)]
pub(super) struct Arrangement {
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

/// Runs a question in growing precision until it is answered.
struct Stages<'a> {
    model: &'a Model,
    curves: &'a Curves,
    meetings: &'a [Passage],
    narrow: Evaluator<'a, Interval>,
    /// Made when first needed.
    middle: OnceCell<Evaluator<'a, Interval128>>,
    wide: OnceCell<Evaluator<'a, Interval384>>,
    used: Cell<usize>,
    /// The most points of a pair of curves at each precision.
    points: u32,
}

impl<'a> Stages<'a> {
    fn new(model: &'a Model, curves: &'a Curves, meetings: &'a [Passage], points: u32) -> Self {
        let narrow = Evaluator::new(model, curves, meetings, ());
        let (middle, wide, used) = (OnceCell::new(), OnceCell::new(), Cell::new(0));
        Self { model, curves, meetings, narrow, middle, wide, used, points }
    }

    fn middle(&self) -> &Evaluator<'a, Interval128> {
        self.used.set(self.used.get().max(STAGES[0]));
        self.middle.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    fn wide(&self) -> &Evaluator<'a, Interval384> {
        self.used.set(self.used.get().max(STAGES[1]));
        self.wide.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    fn pair(&self, a: CurveId, b: CurveId) -> Result<Option<PairProof>, Open> {
        let mut rung = Rung::Double;
        let found = self.narrow.pair(a, b, self.points);
        let found = found.or_else(|_| {
            rung = Rung::Bits(STAGES[0]);
            self.middle().pair(a, b, self.points)
        });
        let found = found.or_else(|_| {
            rung = Rung::Bits(STAGES[1]);
            self.wide().pair(a, b, self.points)
        });
        decided(Question::Pair, if found.is_ok() { rung } else { Rung::Open });
        found
    }

    /// The order of these curves over x, with enclosures of their heights.
    fn order(&self, curves: &[CurveId], x: &RBig) -> Option<Ordered> {
        let mut rung = Rung::Double;
        let found = order(&self.narrow, curves, x);
        let found = found.or_else(|| {
            rung = Rung::Bits(STAGES[0]);
            order(self.middle(), curves, x)
        });
        let found = found.or_else(|| {
            rung = Rung::Bits(STAGES[1]);
            order(self.wide(), curves, x)
        });
        decided(Question::Order, if found.is_some() { rung } else { Rung::Open });
        found
    }
}

/// Curves by rising height, with enclosures of their heights.
struct Ordered {
    curves: Vec<CurveId>,
    heights: Vec<[f64; 2]>,
}

/// The proved order of curves over x.
fn order<E: Enclosure>(evaluator: &Evaluator<'_, E>, curves: &[CurveId], x: &RBig) -> Option<Ordered> {
    let set = E::rational(x, evaluator.c.precision);
    let mut points: Vec<(CurveId, Point<E>, [f64; 2])> = Vec::with_capacity(curves.len());
    for &curve in curves {
        let point = evaluator.point(curve, &set)?;
        let bounds = point.h().bounds();
        points.push((curve, point, bounds));
    }
    let list = &evaluator.curves.list;
    let key = |bounds: &[f64; 2]| bounds[0] + bounds[1];
    points.sort_by(|p, q| list[q.0].lowest.cmp(&list[p.0].lowest).then(key(&p.2).total_cmp(&key(&q.2))));
    // Neighbours whose rounded heights mislead are exchanged by the sign of their gap.
    for _ in 0..points.len() {
        let mut changed = false;
        for k in 1..points.len() {
            if !list[points[k - 1].0].lowest
                && evaluator.gap(&points[k].1, &points[k - 1].1).sign() == Some(Sign::Negative)
            {
                points.swap(k - 1, k);
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    let proved = points
        .windows(2)
        .all(|pair| list[pair[0].0].lowest || evaluator.gap(&pair[1].1, &pair[0].1).sign() == Some(Sign::Positive));
    proved.then(|| Ordered {
        curves: points.iter().map(|p| p.0).collect(),
        heights: points.iter().map(|p| p.2).collect(),
    })
}

fn is_family(curves: &Curves, curve: CurveId) -> bool {
    matches!(curves.list[curve].shape, Shape::Family(_))
}

/// The arrangement, as far as it can be proved with so many points of each pair of curves. With fewer than [`POINTS`] the
/// first pair that is left open ends it.
pub(super) fn arrange(model: Model, curves: &Curves, points: u32) -> Result<Arrangement, Vec<Undecided>> {
    let roots = |_: NotIsolated| vec![Undecided::Roots];
    if !curves.degenerate.is_empty() {
        return Err(vec![Undecided::Degenerate]);
    }
    let meetings = polar::meetings(&model, curves, ROOT_BITS).map_err(roots)?;
    let plain = Evaluator::<Interval384>::new(&model, curves, &[], ());
    let mut events = single_events(&plain, &meetings)?;
    let mut bits = 0;
    let (mut pairs, crossings) = {
        let known = known_meetings(curves, &events);
        let stages = Stages::new(&model, curves, &known, points);
        let mut pairs = Vec::new();
        let mut crossings = Vec::new();
        let mut undecided = Vec::new();
        for b in curves.list.ids() {
            for a in curves.list.ids().take_while(|a| *a < b) {
                let apart = [a, b].iter().any(|&c| !is_family(curves, c) || curves.list[c].lowest);
                if apart {
                    continue;
                }
                match stages.pair(a, b) {
                    Ok(None) => {}
                    Ok(Some(proof)) => {
                        for stretch in &proof.stretches {
                            if let Proof::Crossing(x) = &stretch.proof {
                                crossings.push(crossing_event(&plain, [a, b], x));
                            }
                        }
                        pairs.push(proof);
                    }
                    Err(open) if points < POINTS => {
                        return Err(vec![Undecided::Pair { curves: [a, b], x: open.x }]);
                    }
                    Err(open) => undecided.push(Undecided::Pair { curves: [a, b], x: open.x }),
                }
            }
        }
        bits = bits.max(stages.used.get());
        if !undecided.is_empty() {
            return Err(undecided);
        }
        (pairs, crossings)
    };
    events.extend(crossings);
    bits = bits.max(told_apart(&mut events, &mut pairs, &model, curves));
    events.sort_by(|p, q| p.x[0].cmp(&q.x[0]).then(p.x[1].cmp(&q.x[1])));
    let events = Table::from(events);
    let transitions = transitions(&events)?;
    let stages = Stages::new(&model, curves, &[], points);
    let slabs = slabs(curves, &events, &transitions, &stages)?;
    bits = bits.max(stages.used.get());
    let mut arrangement = Arrangement {
        model,
        curves: curves.clone(),
        meetings,
        pairs,
        events,
        transitions,
        slabs,
        region_count: 0,
        bits,
    };
    arrangement.glue()?;
    Ok(arrangement)
}

/// Cusps, pitchforks and meetings with pole lines; those that are proved to coincide are one event.
fn single_events(
    evaluator: &Evaluator<'_, Interval384>,
    meetings: &Table<MeetingId, Meeting>,
) -> Result<Vec<Event>, Vec<Undecided>> {
    let curves = evaluator.curves;
    let mut events: Vec<Event> = Vec::new();
    let event = |source, list: Vec<CurveId>, x: &Interval384, h: &Interval384| -> Result<Event, Vec<Undecided>> {
        let bounds = x.exact_bounds().ok_or_else(|| vec![Undecided::Roots])?;
        Ok(Event { sources: vec![source], curves: list, x: bounds, h: h.bounds() })
    };
    for (number, cusp) in curves.cusps.pairs() {
        let state = evaluator.state(cusp.place.half, &evaluator.place(&cusp.place));
        events.push(event(Source::Cusp(number), cusp.curves.to_vec(), &state.x, &state.h())?);
    }
    for (number, fork) in curves.pitchforks.pairs() {
        let state = evaluator.state(super::family::Half::Over { group: fork.group }, &evaluator.c.small(0));
        let list = vec![fork.through[0], fork.through[1], fork.pair];
        events.push(event(Source::Pitchfork(number), list, &state.x, &state.h())?);
    }
    for (number, meeting) in meetings.pairs() {
        let state = evaluator.state(meeting.place.half, &evaluator.place(&meeting.place));
        let mut list = meeting.curves.clone();
        let mut onto = meeting.end;
        list.extend(line_at(evaluator, meeting, &state.x, &mut onto)?);
        // The events of cusps and pitchforks stand first.
        let place = match onto {
            Some(End::Cusp(cusp)) => Some(cusp.index()),
            Some(End::Pitchfork(fork)) => Some(curves.cusps.len() + fork.index()),
            _ => None,
        };
        if let Some(place) = place {
            let target = &mut events[place];
            target.sources.push(Source::Pole(number));
            for curve in list {
                if !target.curves.contains(&curve) {
                    target.curves.push(curve);
                }
            }
        } else {
            events.push(event(Source::Pole(number), list, &state.x, &state.h())?);
        }
    }
    Ok(events)
}

/// The pole line of a meeting; when r lies on an axis, the piece of the line over x, or the pitchfork that lies there.
fn line_at(
    evaluator: &Evaluator<'_, Interval384>,
    meeting: &Meeting,
    x: &Interval384,
    onto: &mut Option<End>,
) -> Result<Vec<CurveId>, Vec<Undecided>> {
    let curves = evaluator.curves;
    let pieces = polar::line_pieces(curves, meeting.pole);
    let mut at = 0;
    for window in pieces.windows(2) {
        let End::Pitchfork(number) = curves.list[window[0]].ends[1] else { break };
        let limit = evaluator.pitchfork_x(number);
        if limit.is_below(x) {
            at += 1;
        } else if x.is_below(&limit) {
            break;
        } else if polar::meets_pitchfork(evaluator.model, &meeting.place, curves.pitchforks[number].group) {
            *onto = Some(End::Pitchfork(number));
            return Ok(Vec::new());
        } else {
            return Err(vec![Undecided::Events { curves: meeting.curves.clone(), x: x.bounds() }]);
        }
    }
    Ok(vec![pieces[at]])
}

/// Ends of curves through which another curve is proved to pass.
fn known_meetings(curves: &Curves, events: &[Event]) -> Vec<Passage> {
    let mut known = Vec::new();
    for event in events.iter().filter(|event| event.sources.len() > 1) {
        for &curve in &event.curves {
            for side in [0, 1] {
                let ends_here = event.sources.iter().any(|source| match source {
                    Source::Cusp(number) => curves.list[curve].ends[side] == End::Cusp(*number),
                    Source::Pitchfork(number) => curves.list[curve].ends[side] == End::Pitchfork(*number),
                    _ => false,
                });
                if ends_here {
                    known.extend(event.curves.iter().filter(|&&other| other != curve).map(|&other| Passage {
                        curve,
                        side,
                        other,
                    }));
                }
            }
        }
    }
    known
}

fn crossing_event<E: Enclosure>(evaluator: &Evaluator<'_, E>, pair: [CurveId; 2], x: &[RBig; 2]) -> Event {
    // h rises with x.
    let height = |x: &RBig| {
        let point = evaluator.point(pair[0], &E::rational(x, evaluator.c.precision));
        point.map_or([f64::NEG_INFINITY, f64::INFINITY], |point| point.h().bounds())
    };
    let h = [height(&x[0])[0], height(&x[1])[1]];
    Event { sources: vec![Source::Crossing(pair)], curves: pair.to_vec(), x: x.clone(), h }
}

/// Narrows the boxes of crossings that overlap other events of their curves, with as many bits as it takes; which bits.
fn told_apart(events: &mut [Event], pairs: &mut [PairProof], model: &Model, curves: &Curves) -> usize {
    let mut used = 0;
    let mut open = overlapping(events);
    if !open.is_empty() {
        used = STAGES[0];
        narrow(&Evaluator::<Interval128>::new(model, curves, &[], ()), &open, events, pairs);
        open = overlapping(events);
    }
    if !open.is_empty() {
        used = STAGES[1];
        narrow(&Evaluator::<Interval384>::new(model, curves, &[], ()), &open, events, pairs);
    }
    used
}

/// The crossings whose boxes overlap other events of their curves.
fn overlapping(events: &[Event]) -> Vec<usize> {
    let overlaps = |p: &Event, q: &Event| {
        p.x[0] <= q.x[1] && q.x[0] <= p.x[1] && p.curves.iter().any(|curve| q.curves.contains(curve))
    };
    (0..events.len())
        .filter(|&n| matches!(events[n].sources[..], [Source::Crossing(_)]))
        .filter(|&n| (0..events.len()).any(|m| m != n && overlaps(&events[n], &events[m])))
        .collect()
}

/// Narrows the boxes of these crossings.
fn narrow<E: Enclosure>(evaluator: &Evaluator<'_, E>, open: &[usize], events: &mut [Event], pairs: &mut [PairProof]) {
    for &n in open {
        let [Source::Crossing(pair)] = events[n].sources[..] else { continue };
        if let Some(x) = evaluator.narrowed(pair, &events[n].x) {
            let proofs = pairs.iter_mut().filter(|proof| proof.curves == pair).flat_map(|proof| &mut proof.stretches);
            for stretch in proofs.filter(|stretch| stretch.proof == Proof::Crossing(events[n].x.clone())) {
                stretch.proof = Proof::Crossing(x.clone());
            }
            events[n] = crossing_event(evaluator, pair, &x);
        }
    }
}

/// Groups of events whose x cannot be told apart; each group must consist of events on different curves.
fn transitions(events: &Table<EventId, Event>) -> Result<Table<TransitionId, Vec<EventId>>, Vec<Undecided>> {
    let mut groups: Vec<Vec<EventId>> = Vec::new();
    let mut reach: Option<RBig> = None;
    for (number, event) in events.pairs() {
        match (&reach, groups.last_mut()) {
            (Some(limit), Some(group)) if event.x[0] <= *limit => group.push(number),
            _ => groups.push(vec![number]),
        }
        reach = Some(reach.take().map_or_else(|| event.x[1].clone(), |limit| limit.max(event.x[1].clone())));
    }
    for group in &groups {
        for (k, &p) in group.iter().enumerate() {
            for &q in &group[k + 1..] {
                if events[p].curves.iter().any(|c| events[q].curves.contains(c)) {
                    let mut curves = events[p].curves.clone();
                    curves.extend(&events[q].curves);
                    curves.sort_unstable();
                    curves.dedup();
                    let x = [events[p].x[0].to_f64().value(), events[q].x[1].to_f64().value()];
                    return Err(vec![Undecided::Events { curves, x }]);
                }
            }
        }
    }
    Ok(groups.into())
}

/// The slabs in which a curve lives.
fn span(
    curves: &Curves,
    events: &Table<EventId, Event>,
    transitions: &Table<TransitionId, Vec<EventId>>,
    curve: CurveId,
) -> [SlabId; 2] {
    let at = |end: End| {
        transitions.ids().find(|transition| {
            let group = &transitions[*transition];
            group.iter().any(|&event| {
                events[event].sources.iter().any(|source| match source {
                    Source::Cusp(number) => end == End::Cusp(*number),
                    Source::Pitchfork(number) => end == End::Pitchfork(*number),
                    _ => false,
                })
            })
        })
    };
    let [from, to] = curves.list[curve].ends;
    let last = transitions.next_id().before();
    [at(from).map_or(SlabId::at(0), TransitionId::after), at(to).map_or(last, TransitionId::before)]
}

/// x of a slab, and l when x = l²/2 for a double l: one with few bits, so that l² is exact.
fn sample(low: Option<&RBig>, high: Option<&RBig>) -> (RBig, Option<f64>) {
    let double = |x: &RBig| x.to_f64().value();
    let (from, to) = (low.map_or(0.0, double), high.map_or(f64::INFINITY, double));
    let [l_from, l_to] = [(2.0 * from).sqrt(), (2.0 * to).sqrt()];
    let target = match (from > 0.0, to.is_finite()) {
        (true, true) if l_to > 2.0 * l_from => (l_from * l_to).sqrt(),
        (true, true) => 0.5 * (l_from + l_to),
        (true, false) => 1.2 * l_from,
        (false, true) => 0.7 * l_to,
        (false, false) => 1.0,
    };
    for dropped in [44, 40, 36, 32, 28, 24, 20, 12, 4, 0] {
        let l = f64::from_bits((target.to_bits() >> dropped) << dropped);
        let Ok(exact) = RBig::try_from(l) else { break };
        let x = &exact * &exact / RBig::from(2);
        if low.is_none_or(|low| x > *low) && high.is_none_or(|high| x < *high) && l > 0.0 {
            return (x, Some(l));
        }
    }
    match (low, high) {
        (Some(low), Some(high)) => ((low + high) / RBig::from(2), None),
        (Some(low), None) => (low * RBig::from(2), None),
        (None, Some(high)) => (high / RBig::from(2), None),
        (None, None) => (RBig::ONE, None),
    }
}

fn slabs(
    curves: &Curves,
    events: &Table<EventId, Event>,
    transitions: &Table<TransitionId, Vec<EventId>>,
    stages: &Stages<'_>,
) -> Result<Table<SlabId, Slab>, Vec<Undecided>> {
    let spans: Table<CurveId, [SlabId; 2]> =
        curves.list.ids().map(|curve| span(curves, events, transitions, curve)).collect();
    let end = |transition| transitions.get(transition)?.iter().map(|&e| &events[e].x[1]).max();
    let start = |transition| transitions.get(transition)?.iter().map(|&e| &events[e].x[0]).min();
    (0..=transitions.len())
        .map(|slab| {
            let slab = SlabId::at(slab);
            let (low, high) = (TransitionId::at_start(slab).and_then(end), start(TransitionId::at_end(slab)));
            let (x, l) = sample(low, high);
            let alive: Vec<CurveId> =
                curves.list.ids().filter(|&c| spans[c][0] <= slab && slab <= spans[c][1]).collect();
            let Ordered { curves: order, heights } =
                stages.order(&alive, &x).ok_or_else(|| vec![Undecided::Order { x: x.to_f64().value() }])?;
            Ok(Slab { x, l, order, heights, region_above: Vec::new() })
        })
        .collect()
}

impl Arrangement {
    /// Glues cells to regions: across an event the curves that meet are a run of neighbours before and after; the cells
    /// inside the runs end and begin there, all others continue; where nothing stood before (or stands after), the cell
    /// around continues on both sides.
    fn glue(&mut self) -> Result<(), Vec<Undecided>> {
        let offsets: Table<SlabId, usize> = self
            .slabs
            .iter()
            .scan(0, |sum, slab| {
                let first = *sum;
                *sum += slab.order.len() + 1;
                Some(first)
            })
            .collect();
        let cells = self.slabs.iter().map(|slab| slab.order.len() + 1).sum();
        let mut joined = Partition::new(cells);
        for (transition, group) in self.transitions.pairs() {
            let blocks: Vec<&[CurveId]> = group.iter().map(|&event| self.events[event].curves.as_slice()).collect();
            let (left, right) = (transition.before(), transition.after());
            let (before, after) = (&self.slabs[left].order, &self.slabs[right].order);
            let continued = continuation(before, after, &blocks)
                .ok_or_else(|| vec![Undecided::Gluing { x: self.events[group[0]].x[0].to_f64().value() }])?;
            for Continued { before, after } in continued {
                joined.unite(offsets[left] + before, offsets[right] + after);
            }
        }
        let mut numbers: Vec<Option<RegionId>> = vec![None; cells];
        let mut count = 0;
        for (slab, offset) in self.slabs.iter_mut().zip(offsets) {
            slab.region_above = (1..=slab.order.len())
                .map(|gap| {
                    let root = joined.find(offset + gap);
                    *numbers[root].get_or_insert_with(|| {
                        count += 1;
                        RegionId::at(count - 1)
                    })
                })
                .collect();
        }
        self.region_count = count;
        Ok(())
    }
}

/// A gap before a transition and a gap after it that are in one region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Continued {
    before: usize,
    after: usize,
}

/// The gaps that continue across events on disjoint runs of curves. Gap k lies below curve k.
/// `None` when the orders do not fit.
fn continuation(before: &[CurveId], after: &[CurveId], blocks: &[&[CurveId]]) -> Option<Vec<Continued>> {
    permutations(blocks.len()).into_iter().find_map(|sequence| {
        let origins = (0..=before.len()).map(|gap| vec![gap]).collect();
        let mut now = Progress { order: before.to_vec(), origins };
        for &number in &sequence {
            now = across(&now, after, blocks[number])?;
        }
        (now.order == after).then(|| {
            let pairs = now.origins.into_iter().enumerate();
            pairs.flat_map(|(gap, from)| from.into_iter().map(move |before| Continued { before, after: gap })).collect()
        })
    })
}

/// The vertical order after some of the events of a transition.
struct Progress {
    order: Vec<CurveId>,
    /// For each gap now: the gaps of the beginning that continue into it.
    origins: Vec<Vec<usize>>,
}

/// One event: its run of curves is replaced by the run that stands there afterwards.
fn across(now: &Progress, after: &[CurveId], block: &[CurveId]) -> Option<Progress> {
    let Progress { order, origins } = now;
    let run = |list: &[CurveId]| -> Option<(usize, Vec<CurveId>)> {
        let places: Vec<usize> = (0..list.len()).filter(|&k| block.contains(&list[k])).collect();
        let first = places.first().copied();
        let contiguous = places.windows(2).all(|pair| pair[1] == pair[0] + 1);
        contiguous.then(|| (first.unwrap_or(usize::MAX), places.iter().map(|&k| list[k]).collect()))
    };
    // What is there once this event is over and the later ones are not yet.
    let after: Vec<CurveId> = after.iter().copied().filter(|c| order.contains(c) || block.contains(c)).collect();
    let (mut first, old) = run(order)?;
    let (place, new) = run(&after)?;
    if old.is_empty() {
        // Born in the cell above the curve below it.
        if new.is_empty() {
            return None;
        }
        first = match place.checked_sub(1) {
            None => 0,
            Some(below) => order.iter().position(|&c| c == after[below])? + 1,
        };
    }
    let mut next = order[..first].to_vec();
    next.extend(&new);
    next.extend(&order[first + old.len()..]);
    let mut gaps: Vec<Vec<usize>> = origins[..=first].to_vec();
    match (old.len(), new.len()) {
        (0, _) => {
            gaps.extend((1..new.len()).map(|_| Vec::new()));
            gaps.push(origins[first].clone());
        }
        (_, 0) => {
            let joined = origins[first + old.len()].clone();
            if let Some(last) = gaps.last_mut() {
                last.extend(joined);
            }
        }
        _ => {
            gaps.extend((1..new.len()).map(|_| Vec::new()));
            gaps.push(origins[first + old.len()].clone());
        }
    }
    gaps.extend(origins[first + old.len() + 1..].iter().cloned());
    Some(Progress { order: next, origins: gaps })
}

fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n > 6 {
        return vec![(0..n).collect()];
    }
    let mut all = vec![Vec::new()];
    for _ in 0..n {
        all = all
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                let free: Vec<usize> = (0..n).filter(|k| !start.contains(k)).collect();
                free.into_iter().map(|k| [start.as_slice(), &[k]].concat()).collect::<Vec<_>>()
            })
            .collect();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use top::body::{Body, Preset};

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
            let standard = top::diagram::Arrangement::new(top::curves::CriticalSet::new(body.frame()).unwrap());
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

    /// Pairs (gap before, gap after) that continue, for curves by number.
    fn glued(before: &[usize], after: &[usize], blocks: &[&[usize]]) -> Option<Vec<(usize, usize)>> {
        let ids = |list: &[usize]| list.iter().map(|&c| CurveId::at(c)).collect::<Vec<_>>();
        let blocks: Vec<Vec<CurveId>> = blocks.iter().map(|block| ids(block)).collect();
        let blocks: Vec<&[CurveId]> = blocks.iter().map(Vec::as_slice).collect();
        let gaps = continuation(&ids(before), &ids(after), &blocks)?;
        Some(gaps.into_iter().map(|gaps| (gaps.before, gaps.after)).collect())
    }

    #[test]
    fn a_birth_splits_the_cell_around_it_and_joins_it_at_the_sides() {
        let found = glued(&[0, 1], &[0, 2, 3, 1], &[&[2, 3]]).unwrap();
        assert_eq!(found, [(0, 0), (1, 1), (1, 3), (2, 4)]);
        let found = glued(&[0, 2, 3, 1], &[0, 1], &[&[2, 3]]).unwrap();
        assert_eq!(found, [(0, 0), (1, 1), (3, 1), (4, 2)]);
        let found = glued(&[0, 1], &[1, 0], &[&[0, 1]]).unwrap();
        assert_eq!(found, [(0, 0), (2, 2)]);
        // A swap, and a birth in the new cell: only one sequence fits.
        assert!(glued(&[0, 1], &[1, 2, 3, 0], &[&[2, 3], &[0, 1]]).is_some());
        assert!(glued(&[0, 1, 2], &[2, 1, 0], &[&[0, 2]]).is_none());
    }
}
