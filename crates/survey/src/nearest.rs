//! The borders of classes around a body.

use std::collections::BTreeMap;

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use crate::border::{self, BodySegment, BorderEventKind, BorderOptions, class_of};
use crate::parallel::each;
use crate::space::{BodyLine, BodySet, ReducedBody, TangentBasis};
use bifdiag_body::Body;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;

/// How borders are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestOptions {
    /// Random lines through the body.
    pub lines: u32,
    /// Borders whose distance is improved, the nearest first.
    pub improved: usize,
    /// Where lines end.
    pub set: BodySet,
    /// Chooses the lines.
    pub seed: u64,
}

impl Default for NearestOptions {
    fn default() -> Self {
        Self { lines: 48, improved: 6, set: BodySet::All, seed: 0 }
    }
}

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

/// The borders of a body's class that are met by random lines through it, each at the place that is nearest to the body,
/// in the order of their distances. What is special about the body stays so on each line.
///
/// Each distance is that of a body on the border: the border is as near, and a nearer part of it may be unknown.
#[must_use]
pub fn nearest(body: ReducedBody, options: &NearestOptions) -> Vec<NearestBorder> {
    let Some(search) = BorderSearch::new(body, options.set) else { return Vec::new() };
    let mut rng = SplitMix64::seed_from_u64(options.seed);
    let lines = (0..options.lines).map_while(|_| unit(search.basis.random(&mut rng)));
    let both_ways = lines.flat_map(|line| [1.0, -1.0].map(|sign| line.iter().map(|x| sign * x).collect()));
    let directions: Vec<Vec<f64>> = both_ways.collect();
    let met = each(&directions, |direction| search.first(direction, |line| line.nodes(true, 0.5)));
    let mut found: BTreeMap<(ClassName, String), NearestBorder> = BTreeMap::new();
    for (_, border) in met.into_iter().flatten() {
        let key = (border.class.name().clone(), border.event.to_string());
        if found.get(&key).is_none_or(|known| border.distance < known.distance) {
            found.insert(key, border);
        }
    }
    let mut found: Vec<NearestBorder> = found.into_values().collect();
    found.sort_by(|p, q| p.distance.total_cmp(&q.distance));
    let far = found.split_off(options.improved.min(found.len()));
    let improved = |border: &NearestBorder| {
        let mut border = border.clone();
        search.improve(&mut border);
        border
    };
    let mut found = each(&found, improved);
    found.extend(far);
    found.sort_by(|p, q| p.distance.total_cmp(&q.distance));
    found
}

/// Lines through one body.
struct BorderSearch {
    basis: TangentBasis,
    set: BodySet,
    class: Class,
    /// What the class of the body needs, which f64 may leave open; other such bodies are passed over.
    accuracy: Accuracy,
}

/// Improvements of a distance.
const STEPS: u32 = 5;

impl BorderSearch {
    fn new(body: ReducedBody, set: BodySet) -> Option<Self> {
        let body_itself = Body::from_f64(body.a, body.r).ok()?;
        let (accuracy, class) = [Accuracy::Fast, Accuracy::Exact]
            .into_iter()
            .find_map(|accuracy| Some((accuracy, class_of(&body_itself, accuracy).ok()?.1)))?;
        Some(Self { basis: TangentBasis::new(body), set, class, accuracy })
    }

    /// The first border in a direction that shows between bodies at some values of s, which grow, and where on the line it
    /// is.
    fn first(&self, direction: &[f64], nodes: impl Fn(&BodyLine) -> Vec<f64>) -> Option<(f64, NearestBorder)> {
        let line = self.basis.line(direction, self.set)?;
        let body_at = |s: f64| {
            let [a, r] = line.at(s);
            Body::from_f64(a, r).ok()
        };
        // The last body of the same class.
        let mut before = None;
        for s in nodes(&line) {
            let Some(found) = body_at(s).and_then(|body| class_of(&body, Accuracy::Fast).ok()) else { continue };
            if found.1 == self.class {
                before = Some((s, found));
                continue;
            }
            let start = || Some((0.0, class_of(&body_at(0.0)?, self.accuracy).ok()?));
            let (last, same) = before.or_else(start)?;
            let options = BorderOptions { tolerance: 1e-9, by_zeros: true, ..BorderOptions::default() };
            let segment = BodySegment::new(same.0.body().clone(), found.0.body().clone());
            let border = border::find_between(&segment, [same, found], &options).ok()?;
            let at = last + border.t * (s - last);
            let (distance, body) = (line.distance(at), ReducedBody::of(line.at(at)));
            let ([_, class], event) = (border.classes, border.event.kind);
            return Some((at, NearestBorder { class, event, distance, body, direction: direction.to_vec() }));
        }
        None
    }

    /// A border with the same event to the same class in another direction, near to s.
    fn again(&self, like: &NearestBorder, direction: &[f64], s: f64) -> Option<(f64, NearestBorder)> {
        let nodes = |line: &BodyLine| {
            let near = [0.5, 0.9, 1.1, 1.5, 2.5].into_iter().map(|share| share * s);
            near.filter(|s| *s < line.reach()[1]).collect()
        };
        let found = self.first(direction, nodes)?;
        (found.1.class == like.class && found.1.event == like.event).then_some(found)
    }

    /// Goes to the foot of the perpendicular: the plane through points of the border in as many directions as there are
    /// parameters has a foot, near to which the border's own lies.
    fn improve(&self, border: &mut NearestBorder) {
        let Some((mut s, _)) = self.again(border, &border.direction.clone(), border.distance) else { return };
        let mut tilt = 0.4;
        for _ in 0..STEPS {
            tilt *= 0.5;
            let direction = border.direction.clone();
            let mut points = vec![direction.iter().map(|x| s * x).collect::<Vec<f64>>()];
            for tangent in tangents(&direction) {
                let tilted = direction.iter().zip(&tangent).map(|(x, t)| x + tilt * t).collect();
                let Some(tilted) = unit(tilted) else { return };
                let Some((s, _)) = self.again(border, &tilted, s) else { return };
                points.push(tilted.iter().map(|x| s * x).collect());
            }
            // ⟨n, p⟩ = 1 on the plane.
            let ones = vec![1.0; points.len()];
            let Some(normal) = solved(points, ones) else { return };
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let Some(foot) = unit(normal) else { return };
            let Some((foot_s, better)) = self.again(border, &foot, 1.0 / length) else { return };
            if better.distance >= border.distance {
                return;
            }
            let gained = border.distance - better.distance;
            s = foot_s;
            *border = better;
            if gained < 1e-6 * border.distance {
                return;
            }
        }
    }
}

/// A vector of length 1; `None` for none.
fn unit(v: Vec<f64>) -> Option<Vec<f64>> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| v.into_iter().map(|x| x / length).collect())
}

/// Unit vectors that are orthogonal to a direction and to one another.
fn tangents(direction: &[f64]) -> Vec<Vec<f64>> {
    let n = direction.len();
    let largest = (0..n).max_by(|&i, &j| direction[i].abs().total_cmp(&direction[j].abs())).unwrap_or_default();
    let mut known: Vec<Vec<f64>> = vec![direction.to_vec()];
    for k in (0..n).filter(|&k| k != largest) {
        let mut v: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == k))).collect();
        for other in &known {
            let share: f64 = v.iter().zip(other).map(|(x, y)| x * y).sum();
            v.iter_mut().zip(other).for_each(|(x, y)| *x -= share * y);
        }
        known.extend(unit(v));
    }
    known.split_off(1)
}

/// The solution of a small linear system, by elimination with pivots; `None` for a singular one.
fn solved(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))?;
        if rows[pivot][k] == 0.0 {
            return None;
        }
        rows.swap(k, pivot);
        right.swap(k, pivot);
        for i in (0..n).filter(|&i| i != k) {
            let factor = rows[i][k] / rows[k][k];
            for j in k..n {
                rows[i][j] -= factor * rows[k][j];
            }
            right[i] -= factor * right[k];
        }
    }
    Some((0..n).map(|k| right[k] / rows[k][k]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_and_systems() {
        let direction = unit(vec![0.1, -0.7, 0.3, 0.2]).unwrap();
        let tangents = tangents(&direction);
        assert_eq!(tangents.len(), 3);
        let product = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| x * y).sum::<f64>();
        assert!(tangents.iter().all(|t| product(t, &direction).abs() < 1e-15 && (product(t, t) - 1.0).abs() < 1e-15));
        let solution = solved(vec![vec![0.0, 2.0], vec![3.0, 1.0]], vec![4.0, 5.0]).unwrap();
        assert!((solution[0] - 1.0).abs() < 1e-15 && (solution[1] - 2.0).abs() < 1e-15);
        assert_eq!(solved(vec![vec![1.0, 1.0], vec![1.0, 1.0]], vec![1.0, 2.0]), None);
    }

    /// Where the border is known: J_r = A2 is a cone over r, and the nearest of its bodies is sought by other means.
    #[test]
    fn the_distance_to_the_middle_moment_is_found() {
        let body = ReducedBody::of([[0.5, 0.6, 0.9], [0.6, 0.12, 0.45]]);
        let options = NearestOptions { lines: 8, ..NearestOptions::default() };
        let borders = nearest(body, &options);
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
