//! One point of a proved atlas.

use dashu_ratio::RBig;

use super::CertifiedAtlas;
use super::arrange::STAGES;
use super::curves::Shape;
use super::id::TransitionId;
use super::point::Evaluator;
use numbers::enclosure::{Arithmetic, Enclosure};
use numbers::wide::Wide;
use top::atlas;
use top::body::Number;
use top::classify::{Classification, Components, Margin, at_rest};
use top::curves::CurveId;
use top::diagram::{EventId, RegionId, SlabId};
use top::table::Id;

/// A curve or an event over the x of the point, with its height against h.
struct Level {
    /// Curves in this slab's order: one, or the run that meets in an event.
    first: usize,
    count: usize,
    /// Sign of h minus its height; `None` when the largest precision does not tell.
    sign: Option<i8>,
    distance: [f64; 2],
}

impl CertifiedAtlas {
    /// Classifies a point: the answer is proved, or the point is `undecided`; `critical` only when it is proved to lie on
    /// a straight curve.
    #[must_use]
    pub fn classify(&self, h: &Number, l: &Number) -> Classification {
        if l.value().is_zero() {
            return at_rest(&self.body, h);
        }
        let exact = |unit: f64| RBig::try_from(unit).unwrap_or(RBig::ONE);
        let momentum = l.value() / exact(self.frame.momentum_unit);
        let x = &momentum * &momentum / RBig::from(2);
        let energy = h.value() / exact(self.frame.energy_unit);
        let a = &self.arrangement;
        // The slab before or over x, and the events whose enclosures hold x.
        let passed = a.transitions.iter().take_while(|group| group.iter().all(|&e| a.events[e].x[1] < x)).count();
        let (passed, slab) = (TransitionId::at(passed), SlabId::at(passed));
        let near: Vec<EventId> = a
            .transitions
            .get(passed)
            .map(|group| group.iter().copied().filter(|&e| a.events[e].x[0] <= x && x <= a.events[e].x[1]).collect())
            .unwrap_or_default();
        let levels = self.levels(slab, &near, &x, &energy);
        let unit = self.frame.energy_unit;
        let nearest = levels.iter().min_by(|p, q| p.distance[0].total_cmp(&q.distance[0]));
        let margin = Margin {
            h: nearest.map_or(0.0, |level| level.distance[0].max(0.0) * unit),
            nearest: nearest.map(|level| self.name(a.slabs[slab].order[level.first])),
            error_bound: nearest.map_or(0.0, |level| (level.distance[1] - level.distance[0]) * unit),
        };
        let unknown: Vec<&Level> =
            levels.iter().filter(|level| level.sign.is_none() || level.sign == Some(0)).collect();
        let below = levels.iter().filter(|level| level.sign == Some(1)).map(|level| level.first + level.count).max();
        let below = below.unwrap_or(0);
        if unknown.is_empty() {
            return self.settled(slab, below, margin);
        }
        let above = unknown.iter().map(|level| level.first + level.count).max().unwrap_or(below);
        let mut regions: Vec<Option<RegionId>> = (below..=above).map(|gap| self.region(slab, gap)).collect();
        if !near.is_empty() {
            // Regions that begin at the event.
            let after = passed.after();
            for &event in &near {
                for (position, curve) in a.slabs[after].order.iter().enumerate() {
                    if a.events[event].curves.contains(curve) {
                        regions.extend([self.region(after, position), self.region(after, position + 1)]);
                    }
                }
            }
        }
        regions.sort_unstable();
        regions.dedup();
        Classification::open(atlas::on_straight_curve(&self.body, h, l), self.classes(&regions), margin)
    }

    /// The proved classes of these regions, each once.
    fn classes(&self, regions: &[Option<RegionId>]) -> Vec<Components> {
        let mut candidates: Vec<Components> = Vec::new();
        for region in regions {
            let class = match region {
                None => Vec::new(),
                Some(region) => match &self.regions[*region].components {
                    Ok(components) => components.clone(),
                    Err(_unproved) => continue,
                },
            };
            if !candidates.contains(&class) {
                candidates.push(class);
            }
        }
        candidates
    }

    /// The region above this many curves of a slab; `None`: forbidden.
    fn region(&self, slab: SlabId, gap: usize) -> Option<RegionId> {
        gap.checked_sub(1).map(|position| self.arrangement.slabs[slab].region_above[position])
    }

    fn settled(&self, slab: SlabId, below: usize, margin: Margin) -> Classification {
        let Some(region) = self.region(slab, below) else { return Classification::decided(Vec::new(), margin) };
        match &self.regions[region].components {
            Ok(components) => Classification::decided(components.clone(), margin),
            Err(_unproved) => {
                Classification { unproved_topology: true, ..Classification::open(false, Vec::new(), margin) }
            }
        }
    }

    /// h against every curve of a slab; curves that meet in an event at x are one level.
    fn levels(&self, slab: SlabId, near: &[EventId], x: &RBig, energy: &RBig) -> Vec<Level> {
        let a = &self.arrangement;
        let order = &a.slabs[slab].order;
        let evaluators = STAGES.map(|bits| Evaluator::<Wide>::new(&a.model, &a.curves, &[], bits));
        let mut levels = Vec::new();
        let mut position = 0;
        while position < order.len() {
            let event = near.iter().find(|&&e| a.events[e].curves.contains(&order[position]));
            let count =
                event.map_or(1, |&e| order[position..].iter().take_while(|c| a.events[e].curves.contains(c)).count());
            let mut level = Level { first: position, count, sign: None, distance: [0.0, f64::INFINITY] };
            for evaluator in &evaluators {
                let bits = evaluator.c.precision;
                let height = match event {
                    Some(&e) => Some(Wide::double(a.events[e].h[0], bits).hull(&Wide::double(a.events[e].h[1], bits))),
                    None => evaluator.point(order[position], &Wide::rational(x, bits)).map(|point| point.h()),
                };
                let Some(height) = height else { continue };
                let difference = Wide::rational(energy, bits) - height;
                let [lo, hi] = difference.bounds();
                level.distance = [if lo > 0.0 { lo } else { (-hi).max(0.0) }, hi.abs().max(lo.abs())];
                level.sign = difference.sign();
                if level.sign.is_some() {
                    break;
                }
            }
            if level.sign.is_none() && self.on_line(order[position], x, energy) {
                level.sign = Some(0);
            }
            levels.push(level);
            position += count;
        }
        // Events that stand alone in a cell before they begin.
        for &event in near {
            if order.iter().any(|c| a.events[event].curves.contains(c)) {
                continue;
            }
            let bits = STAGES[1];
            let height = Wide::double(a.events[event].h[0], bits).hull(&Wide::double(a.events[event].h[1], bits));
            let difference = Wide::rational(energy, bits) - height;
            if difference.sign().is_none() {
                let below = levels.iter().filter(|level| level.sign == Some(1)).map(|l| l.first + l.count).max();
                levels.push(Level { first: below.unwrap_or(1) - 1, count: 1, sign: None, distance: [0.0, 0.0] });
            }
        }
        levels
    }

    /// The point lies exactly on this straight curve.
    fn on_line(&self, curve: CurveId, x: &RBig, energy: &RBig) -> bool {
        let model = &self.arrangement.model;
        match self.arrangement.curves.list[curve].shape {
            Shape::Pole(_) => {
                let offset = energy - x / model.j_r();
                &offset * &offset == model.r2
            }
            Shape::Euler { group } => *energy == x / model.a(group),
            Shape::Family(_) => false,
        }
    }
}
