//! The borders of classes around a body.

mod foot;
mod function;

use std::collections::BTreeMap;

use nalgebra::DVector;
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use crate::border::{self, BodySegment, BorderEventKind, BorderOptions, class_of};
use crate::parallel::each;
use crate::space::{BodyLine, BodySet, ReducedBody, TangentBasis, unit_vector};
use bifdiag_body::{Body, BodyAxis};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;
use foot::{Level, Surroundings};

pub use foot::HERE;

/// How borders are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestOptions {
    /// Random lines through the body on which borders are sought, beside those that its own diagram suggests; without a number
    /// [`LINES`] where it suggests none.
    pub lines: Option<u32>,
    /// Where lines end.
    pub set: BodySet,
    /// Chooses the lines.
    pub seed: u64,
}

impl Default for NearestOptions {
    fn default() -> Self {
        Self { lines: None, set: BodySet::All, seed: 0 }
    }
}

/// Lines where a diagram suggests no border.
pub const LINES: u32 = 48;

/// A border of the class of a body, as near to the body as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct NearestBorder {
    /// The class beyond.
    pub class: Class,
    /// What happens there.
    pub event: BorderEventKind,
    /// How far it is: √(|ΔA|² + ∠²), for A with the sum 2 and the angle between the two r.
    pub distance: f64,
    /// The body on the border.
    pub body: ReducedBody,
    /// Coordinates of its direction in the body's [`TangentBasis`], of length 1.
    pub direction: Vec<f64>,
}

/// The borders of a class around one of its bodies, each at the place that is nearest to the body, in the order of their
/// distances: zeros of functions suggested by its diagram, and those met by random lines through it. What makes the
/// body special is kept on the way. `class` is the body's own; on a border, that of its rounded numbers may
/// be another.
///
/// Each distance is that of a body on the border: the border is as near, and a nearer part of it may be unknown.
#[must_use]
pub fn nearest(body: ReducedBody, class: Class, options: &NearestOptions) -> Vec<NearestBorder> {
    let rounded = Body::from_f64(body.a, body.r);
    let atlas = |accuracy| bifdiag_exact::atlas(rounded.as_ref().ok()?, accuracy).ok();
    let Some(atlas) = [Accuracy::Fast, Accuracy::Exact].into_iter().find_map(atlas) else { return Vec::new() };
    let around = Surroundings { basis: TangentBasis::new(body), set: options.set };
    let search = BorderSearch { around, own: (atlas, class) };
    let mut found = search.suggested();
    found.extend(search.passing(&body));
    let lines = options.lines.unwrap_or(if found.is_empty() { LINES } else { 0 });
    let mut rng = SplitMix64::seed_from_u64(options.seed);
    let lines = (0..lines).map_while(|_| unit_vector(search.around.basis.random(&mut rng)));
    let both_ways = lines.flat_map(|line| [1.0, -1.0].map(|sign| line.iter().map(|x| sign * x).collect()));
    let directions: Vec<Vec<f64>> = both_ways.collect();
    found.extend(each(&directions, |direction| search.first(direction)).into_iter().flatten());
    let mut nearest: BTreeMap<(ClassName, String), NearestBorder> = BTreeMap::new();
    for border in found {
        let key = (border.class.name().clone(), border.event.to_string());
        if nearest.get(&key).is_none_or(|known| border.distance < known.distance) {
            nearest.insert(key, border);
        }
    }
    let mut nearest: Vec<NearestBorder> = nearest.into_values().collect();
    nearest.sort_by(|p, q| p.distance.total_cmp(&q.distance));
    nearest
}

/// A place on a line through the body.
struct Beside {
    line: BodyLine,
    /// How far along the line it is, 0 where it is the body itself.
    s: f64,
    /// The classes just before and just beyond it.
    sides: [(Atlas, Class); 2],
}

/// The surroundings of one body.
struct BorderSearch {
    around: Surroundings,
    /// The atlas of its rounded numbers, and its class.
    own: (Atlas, Class),
}

impl BorderSearch {
    /// The borders that the diagram suggests, nearest first.
    fn suggested(&self) -> Vec<NearestBorder> {
        let here = DVector::zeros(self.around.basis.dimensions());
        let feet = each(&function::all(self.own.0.arrangement()), |function| {
            let foot = self.around.foot(&here, vec![Level { function: *function, value: 0.0 }])?;
            Some((Level { function: *function, value: self.around.value(*function, &here)?.0 }, foot))
        });
        let mut feet: Vec<(Level, DVector<f64>)> = feet.into_iter().flatten().collect();
        feet.sort_by(|p, q| p.1.norm().total_cmp(&q.1.norm()));
        let (mut walls, mut found) = (Vec::new(), Vec::new());
        for (wall, foot) in feet {
            let borders = self.within(&walls, wall, foot);
            if !borders.is_empty() {
                found.extend(borders);
                walls.push(wall);
            }
        }
        found
    }

    /// The borders of a special body at which the moment of an axis with r_k = 0 passes that of one with r_i ≠ 0, and a pitchfork goes
    /// through infinity, or without weight any moment another: the bodies with A_k = A_i that are nearest to it.
    fn passing(&self, body: &ReducedBody) -> Vec<NearestBorder> {
        let Surroundings { basis, set } = &self.around;
        let ReducedBody { a, r } = body;
        let is_free = r.iter().all(|x| *x == 0.0);
        let pass = |k: usize, i: usize| if is_free { a[k] > a[i] } else { r[k] == 0.0 && r[i] > 0.0 };
        let pairs = (0..3).flat_map(|k| (0..3).map(move |i| (k, i))).filter(|&(k, i)| pass(k, i));
        let places = pairs.filter_map(|(k, i)| {
            let mut apart = [0.0; 3];
            (apart[k], apart[i]) = (1.0, -1.0);
            let slopes = DVector::from_vec(basis.coordinates(&[apart, [0.0; 3]]));
            // Moments that are equal stay so.
            let gap = (a[k] - a[i]) / slopes.norm_squared();
            let place = slopes * -gap;
            let reach = basis.line(place.as_slice(), *set)?.reach()[1];
            // The set goes up to the border, to a rounding.
            (reach >= (1.0 - 1e-9) * place.norm()).then_some(place)
        });
        // What else the diagrams suggest goes to infinity there.
        let named = |border: NearestBorder| {
            if matches!(border.event, BorderEventKind::PitchforkAtInfinity { .. }) {
                return border;
            }
            NearestBorder { event: BorderEventKind::MomentsEqual { axes: equal_moments(&border.body) }, ..border }
        };
        places.flat_map(|place| self.at(&place)).map(named).collect()
    }

    /// The border on a wall, a function with its value at the body: at its foot, or where that lies beyond other walls, at
    /// the nearest place just before those.
    fn within(&self, walls: &[Level], wall: Level, mut foot: DVector<f64>) -> Vec<NearestBorder> {
        /// The part of a wall's value that is left before it.
        const BEFORE: f64 = 1e-3;
        let mut conditions = vec![Level { function: wall.function, value: 0.0 }];
        loop {
            let borders = self.at(&foot);
            if !borders.is_empty() || conditions.len() == foot.len() {
                return borders;
            }
            let is_beyond = |wall: &&Level| {
                self.around.value(wall.function, &foot).is_none_or(|(value, _)| value * wall.value <= 0.0)
            };
            let Some(Level { function, value }) = walls.iter().find(is_beyond).copied() else { return borders };
            conditions.push(Level { function, value: BEFORE * value });
            let Some(next) = self.around.foot(&foot, conditions.clone()) else { return borders };
            foot = next;
        }
    }

    /// The border at a place, if the class of the body ends there; two where the body itself is on the border, and belongs
    /// to neither side.
    fn at(&self, place: &DVector<f64>) -> Vec<NearestBorder> {
        let Some(Beside { line, s, sides }) = self.beside(place) else { return Vec::new() };
        let [below, above] = &sides;
        let is_here = s == 0.0;
        let (event, _) = border::between(below.0.arrangement(), above.0.arrangement());
        let beyond = match sides.each_ref().map(|side| side.1 == self.own.1) {
            [true, false] => vec![above],
            [false, true] if is_here => vec![below],
            [false, false] if is_here && below.1 != above.1 => vec![below, above],
            _ => Vec::new(),
        };
        let direction: Vec<f64> = place.normalize().iter().copied().collect();
        beyond
            .into_iter()
            .map(|side| border_at(&line, s, side.1.clone(), event.kind.clone(), direction.clone()))
            .collect()
    }

    /// What is beside a place.
    fn beside(&self, place: &DVector<f64>) -> Option<Beside> {
        /// How far from the place classes are asked, as a part of its distance.
        const SIDE: f64 = 1e-6;
        /// What stands for that distance where the body itself is on the border, as a part of the way to the end of the set.
        const BESIDE: f64 = 1e-2;
        /// A shorter step is lost in the rounding of the bodies.
        const LEAST: f64 = 3e-14;
        let direction = place.normalize();
        let line = self.around.basis.line(direction.as_slice(), self.around.set)?;
        let class = |s: f64| {
            let body = body_at(&line, s)?;
            class_of(&body, Accuracy::Fast).or_else(|_open| class_of(&body, Accuracy::Exact)).ok()
        };
        let is_here = place.norm() <= HERE;
        let [s, unit] =
            if is_here { [0.0, BESIDE * line.reach()[0].min(line.reach()[1]).min(1.0)] } else { [place.norm(); 2] };
        let side = (SIDE * unit).max(LEAST);
        let sides = [class(s - side)?, class(s + side)?];
        Some(Beside { line, s, sides })
    }

    /// The first border in a direction that shows between bodies on the line, or that border where it is nearer.
    fn first(&self, direction: &[f64]) -> Option<NearestBorder> {
        let line = self.around.basis.line(direction, self.around.set)?;
        // The last body of the same class.
        let mut before = None;
        for s in line.nodes(true, 0.5) {
            let Some(found) = body_at(&line, s).and_then(|body| class_of(&body, Accuracy::Fast).ok()) else { continue };
            if found.1 == self.own.1 {
                before = Some((s, found));
                continue;
            }
            let (last, same) = before.unwrap_or_else(|| (0.0, self.own.clone()));
            let options = BorderOptions { tolerance: 1e-9, by_zeros: true, ..BorderOptions::default() };
            let segment = BodySegment::new(same.0.body().clone(), found.0.body().clone());
            let (met, vanishing) = border::find_between(&segment, [same, found], &options).ok()?;
            let near = DVector::from_column_slice(direction) * (last + met.t * (s - last));
            // The class of the node may lie beyond further borders.
            let border = self.at(&near).into_iter().next()?;
            let foot = self.around.foot(&near, vec![Level { function: vanishing, value: 0.0 }]);
            let is_nearer = |foot: &NearestBorder| {
                foot.class == border.class && foot.event == border.event && foot.distance < border.distance
            };
            let nearer = foot.and_then(|foot| self.at(&foot).into_iter().find(is_nearer));
            return Some(nearer.unwrap_or(border));
        }
        None
    }
}

fn border_at(line: &BodyLine, s: f64, class: Class, event: BorderEventKind, direction: Vec<f64>) -> NearestBorder {
    let body = ReducedBody::of(line.at(s));
    let axes = equal_moments(&body);
    // More than one pitchfork goes to infinity there.
    let event = if axes.len() == 3 { BorderEventKind::MomentsEqual { axes } } else { event };
    NearestBorder { class, event, distance: line.distance(s), body, direction }
}

/// The axes whose moment is that of another one, too.
fn equal_moments(body: &ReducedBody) -> Vec<BodyAxis> {
    /// Moments of the sum 2 that differ by less are equal.
    const EQUAL: f64 = 1e-12;
    let is_equal = |k: &BodyAxis| (0..3).any(|i| i != k.index() && (body.a[k.index()] - body.a[i]).abs() < EQUAL);
    BodyAxis::ALL.into_iter().filter(is_equal).collect()
}

/// The body at a place of a line.
fn body_at(line: &BodyLine, s: f64) -> Option<Body> {
    let [a, r] = line.at(s);
    Body::from_f64(a, r).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the border is known: J_r = A2 is a cone over r, and the nearest of its bodies is sought by other means.
    #[test]
    fn the_distance_to_the_middle_moment_is_found() {
        let body = ReducedBody::of([[0.5, 0.6, 0.9], [0.6, 0.12, 0.45]]);
        let (_, class) = class_of(&Body::from_f64(body.a, body.r).unwrap(), Accuracy::Fast).unwrap();
        let borders = nearest(body, class, &NearestOptions::default());
        let border = borders.iter().find(|border| matches!(border.event, BorderEventKind::PoleLinesAtInfinity { .. }));
        let border = border.unwrap();
        let excess = |body: &ReducedBody| (0..3).map(|k| (body.a[k] - body.a[1]) * body.r[k] * body.r[k]).sum::<f64>();
        assert!(excess(&border.body).abs() < 1e-8, "{border:?}");
        // First order: |excess| over the length of its gradient along the chart.
        let basis = TangentBasis::new(body);
        let step = 1e-6;
        let slope = |k: usize| {
            let mut y = vec![0.0; 4];
            y[k] = step;
            (excess(&ReducedBody::of(basis.line(&y, BodySet::All).unwrap().at(step))) - excess(&body)) / step
        };
        let estimate = excess(&body).abs() / (0..4).map(|k| slope(k) * slope(k)).sum::<f64>().sqrt();
        assert!((border.distance / estimate - 1.0).abs() < 0.2, "{} {estimate}", border.distance);
    }
}
