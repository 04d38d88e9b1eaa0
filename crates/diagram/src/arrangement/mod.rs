//! The arrangement of all critical curves and pole lines in the half-plane l > 0 (docs/mathematics.md, section 8).
//!
//! Coordinates enter in `pair` (isolated crossings) and `event` (their order in x); `faces` works on vertical orders alone, and
//! `cells` numbers what they leave.

mod event;
mod faces;
mod id;
mod order;
mod pair;
mod settle;
mod undecided;

pub use event::{Change, Event};
pub use faces::{Cells, Continued, Faces};
pub use faces::{InconsistentOrder, continued};
pub use id::{Cell, EventId, ParseRegionIdError, RegionId, SlabId};
pub use order::{PairCrossing, PairOrder};

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use bifdiag_equilibria::curves::{ClusterId, CriticalSet, Curve, CurveId, End, Gap};
use bifdiag_numbers::table::{Id, Table};
use order::ProvedPair;

/// A strip between two events in which the vertical order of the curves is constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Slab {
    /// Range of x = l²/2; 0 and ∞ at the ends.
    pub x: [f64; 2],
    /// Curves by rising h.
    pub order: Vec<CurveId>,
    /// Region above each curve of `order`.
    pub region_above: Vec<RegionId>,
}

/// Something that f64 did not decide.
#[derive(Clone, Debug, PartialEq)]
pub enum Undecided {
    /// Whether two curves cross in a range of x.
    Contact {
        /// The curves.
        curves: [CurveId; 2],
        /// The range of x.
        x: [f64; 2],
    },
    /// How many cusps there are near a point.
    Cusps {
        /// Number in [`CriticalSet::clusters`].
        cluster: ClusterId,
    },
    /// The order of two events that share a curve and cannot be separated.
    Simultaneous {
        /// The events.
        events: [EventId; 2],
    },
    /// The faces could not be glued: the orders on the two sides of an event contradict each other.
    Order {
        /// The event.
        event: EventId,
    },
}

/// Curves, events and faces of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrangement {
    /// Curves with their cusps and pitchforks.
    pub set: CriticalSet,
    /// Events by rising x.
    pub events: Table<EventId, Event>,
    /// Slabs by rising x: one more than events. Empty when the faces could not be glued.
    pub slabs: Table<SlabId, Slab>,
    /// Number of regions.
    pub region_count: usize,
    /// What is not decided.
    pub undecided: Vec<Undecided>,
    /// Points of curves that were computed to find the crossings.
    pub evaluations: u32,
}

impl Arrangement {
    /// An abscissa well inside a slab.
    #[must_use]
    pub fn middle(&self, slab: SlabId) -> f64 {
        let [from, to] = self.slabs[slab].x;
        match (from > 0.0, to.is_finite()) {
            (true, true) if to > 4.0 * from => from.sqrt() * to.sqrt(),
            (true, true) => 0.5 * (from + to),
            (true, false) => 2.0 * from,
            (false, true) => 0.5 * to,
            (false, false) => 1.0,
        }
    }

    /// The events between a slab and the next one: one, but where several are proved to be at one l, without slabs between them.
    pub fn events_after(&self, slab: SlabId) -> impl Iterator<Item = EventId> {
        let numbers = if self.slabs.len() == self.events.len() + 1 {
            slab.index()..slab.index() + 1
        } else {
            let from = |slab: usize| {
                let x = self.slabs.as_slice().get(slab).map_or(f64::INFINITY, |slab| slab.x[1]);
                self.events.as_slice().partition_point(|event| event.x < x)
            };
            from(slab.index())..from(slab.index() + 1)
        };
        numbers.map(EventId::at).filter(|event| self.events.get(*event).is_some())
    }

    /// Enumerates all crossings, orders the events and glues the faces.
    #[must_use]
    pub fn new(set: CriticalSet) -> Self {
        let mut pairs = Vec::new();
        let mut undecided: Vec<Undecided> = set.clusters.ids().map(|cluster| Undecided::Cusps { cluster }).collect();
        let mut evaluations = 0;
        for b in set.curves.ids() {
            for a in set.curves.ids().take_while(|a| *a < b) {
                if let Some(order) = pair::compare(&set.frame, &set.curves[a], &set.curves[b]) {
                    evaluations += order.evaluations;
                    pairs.push(ProvedPair { curves: [a, b], order });
                }
            }
        }
        order::resolve(&set, &mut pairs);
        for ProvedPair { curves, order } in &pairs {
            undecided.extend(order.open_ranges().into_iter().map(|x| Undecided::Contact { curves: *curves, x }));
        }
        let order = |p: CurveId, q: CurveId, range: [f64; 2]| order::proved(&pairs, p, q, range);
        let mut events = event::collect(&set, &pairs);
        settle::settle(&mut events, order);
        let orders = |events: &[Event]| vertical_orders(&set, events, &pairs);
        let (orders, glued) = settle::settle_by_gluing(&mut events, orders);
        let (slabs, region_count) = match glued {
            Ok(faces) => (slabs(orders, &events, faces.above), faces.count),
            Err(InconsistentOrder { event }) => {
                undecided.push(Undecided::Order { event });
                (Table::new(), 0)
            }
        };
        let events = Table::from(events);
        undecided.extend(simultaneous(&events, order));
        Self { set, events, slabs, region_count, undecided, evaluations }
    }
}

/// Pairs of events on a common curve that lie within their errors of each other and that nothing else orders.
fn simultaneous(
    events: &Table<EventId, Event>,
    order: impl Fn(CurveId, CurveId, [f64; 2]) -> Option<Ordering>,
) -> Vec<Undecided> {
    let mut found = Vec::new();
    for (first, event) in events.pairs() {
        for (second, other) in events.pairs().skip_while(|(other, _)| *other <= first) {
            if other.x - event.x > 4.0 * (event.x_error + other.x_error) {
                if other.x > 2.0 * event.x {
                    break;
                }
                continue;
            }
            let shared = event.change.curves().iter().any(|c| other.change.curves().contains(c));
            let near = (event.h - other.h).abs() <= 4.0 * (event.h_error + other.h_error);
            let span = [event.x.min(other.x) - event.x_error, event.x.max(other.x) + other.x_error];
            let ordered = settle::common_curve(event, other)
                .is_some_and(|shared| order(shared.others[0], shared.others[1], span).is_some());
            if shared && near && !ordered {
                found.push(Undecided::Simultaneous { events: [first, second] });
            }
        }
    }
    found
}

/// The vertical order in each slab, from the proved orders of all pairs; no two rounded heights are compared.
fn vertical_orders(set: &CriticalSet, events: &[Event], pairs: &[ProvedPair]) -> Table<SlabId, Vec<CurveId>> {
    let n = set.curves.len();
    let spans = slab_spans(set, events);
    let mut crossings: Vec<Vec<usize>> = vec![Vec::new(); n * n];
    for (number, event) in events.iter().enumerate() {
        if let Change::Swap([a, b]) = event.change {
            crossings[a.index() * n + b.index()].push(number);
        }
    }
    let mut order_of: Vec<Option<&PairOrder>> = vec![None; n * n];
    for ProvedPair { curves: [a, b], order } in pairs {
        order_of[a.index() * n + b.index()] = Some(order);
    }
    (0..=events.len())
        .map(|slab| {
            let active: Vec<CurveId> = set.curves.ids().filter(|&c| spans[c].contains(&slab)).collect();
            let mut ranked: Vec<(usize, CurveId)> = active
                .iter()
                .map(|&c| {
                    let below = active.iter().filter(|&&other| other != c).filter(|&&other| {
                        let key = c.min(other).index() * n + c.max(other).index();
                        let passed = crossings[key].iter().filter(|&&event| event < slab).count();
                        let initial = order_of[key].map_or_else(|| touching_order(set, c, other), PairOrder::initial);
                        let order = if passed.is_multiple_of(2) { initial } else { initial.reverse() };
                        if other < c { order.is_lt() } else { order.is_gt() }
                    });
                    (below.count(), c)
                })
                .collect();
            ranked.sort_unstable();
            ranked.into_iter().map(|(_, c)| c).collect()
        })
        .collect()
}

/// The order of a and b, a < b, two curves, one of which ends where the other begins: between events at the same x both
/// are in a slab of width 0. Equal when rounding hides it.
fn touching_order(set: &CriticalSet, p: CurveId, q: CurveId) -> Ordering {
    let (a, b) = (&set.curves[p.min(q)], &set.curves[p.max(q)]);
    let at = |curve: &Curve| {
        let x = a.x()[0].max(b.x()[0]).clamp(curve.x()[0], curve.x()[1]);
        curve.point(&set.frame, x)
    };
    Gap::between(&set.frame, &at(a), &at(b)).order().unwrap_or(Ordering::Equal)
}

/// The slabs in which each curve lives.
fn slab_spans(set: &CriticalSet, events: &[Event]) -> Table<CurveId, RangeInclusive<usize>> {
    set.curves
        .pairs()
        .map(|(c, curve)| {
            let meets = |event: &Event| {
                let ends_here = match event.change {
                    Change::Birth(curves) | Change::Death(curves) => curves.contains(&c),
                    Change::Open { through, pair } | Change::Close { through, pair } => {
                        through.contains(&c) || pair == c
                    }
                    Change::Swap(_) => false,
                };
                ends_here.then_some(event.x)
            };
            let at = |x: f64| events.iter().position(|event| meets(event) == Some(x));
            let first = match curve.ends[0] {
                End::Origin | End::Infinity => 0,
                End::Cusp(_) | End::Pitchfork(_) => at(curve.x()[0]).map_or(0, |event| event + 1),
            };
            let last = match curve.ends[1] {
                End::Origin | End::Infinity => events.len(),
                End::Cusp(_) | End::Pitchfork(_) => at(curve.x()[1]).unwrap_or(events.len()),
            };
            first..=last
        })
        .collect()
}

fn slabs(
    orders: Table<SlabId, Vec<CurveId>>,
    events: &[Event],
    above: Table<SlabId, Vec<RegionId>>,
) -> Table<SlabId, Slab> {
    let x = |number: usize| events.get(number).map_or(f64::INFINITY, |event| event.x);
    let cells = orders.into_iter().zip(above).enumerate();
    cells
        .map(|(slab, (order, region_above))| Slab {
            x: [if slab == 0 { 0.0 } else { x(slab - 1) }, x(slab)],
            order,
            region_above,
        })
        .collect()
}
