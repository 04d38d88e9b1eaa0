//! The motions that leave an equilibrium along a surface, one through each point of a closed curve about it.
//!
//! A motion crosses P⁻ again and again. As its start moves round the closed curve, each of its crossings moves along a
//! curve of the manifold. Where the closed curve itself meets P⁻, the first crossing appears or disappears and the
//! later ones are renumbered; curves are followed through by counting these places.

use std::f64::consts::TAU;

use super::series::Series;
use crate::chart::Surface;
use crate::flow::Phase;

/// The motions, numbered by s: s and s + 1 are the same motion.
#[derive(Clone, Debug)]
pub struct Ring {
    series: Series,
    /// Along the angle or against it.
    sense: f64,
    /// The angle at s = 0.
    origin: f64,
    /// Where the closed curve meets P⁻, and where the curve that the same motions pass a fixed time earlier does.
    zeros: [Vec<Zero>; 2],
    /// By how many levels a curve rises in a turn: 0 where curves are closed.
    pub winding: usize,
    /// The largest partial sum of changes in a turn.
    most: i64,
}

/// A place where the closed curve meets P⁻.
#[derive(Clone, Copy, Debug)]
struct Zero {
    s: f64,
    /// What is added to the numbers of crossings as s passes it upward.
    change: i64,
}

/// How much earlier, in units of 1 over the largest |re| or |im| of the rates.
const BEFORE: f64 = 0.1;
/// Points of the closed curve at which S is evaluated.
const SAMPLES: u32 = 1440;
/// Bisections of a zero.
const STEPS: usize = 60;

impl Ring {
    /// For an equilibrium in the world of a surface; `None` where the zeros of S on the closed curve cannot be
    /// separated.
    #[must_use]
    pub fn new(surface: &Surface, series: Series) -> Option<Self> {
        let angles = [0.0, 1.0].map(|back| zeros(surface, &series, back * before(&series)));
        let total = |zeros: &[(f64, i64)]| zeros.iter().map(|zero| zero.1).sum::<i64>();
        if angles[0].len() != angles[1].len() || total(&angles[0]) != total(&angles[1]) {
            return None;
        }
        let sense = if total(&angles[0]) < 0 { -1.0 } else { 1.0 };
        let origin = widest(angles.iter().flatten().map(|zero| zero.0).collect());
        let along = |(angle, change): &(f64, i64)| {
            let s = sense * (angle - origin) / TAU;
            Zero { s: s - s.floor(), change: if sense < 0.0 { -change } else { *change } }
        };
        let winding = usize::try_from(total(&angles[0]).abs()).ok()?;
        let zeros = angles.map(|own| {
            let mut zeros: Vec<Zero> = own.iter().map(along).collect();
            zeros.sort_by(|a, b| a.s.total_cmp(&b.s));
            zeros
        });
        let mut sum = 0;
        let sums = zeros[0].iter().map(|zero| {
            sum += zero.change;
            sum
        });
        let most = sums.max().unwrap_or(0).max(0);
        Some(Self { series, sense, origin, zeros, winding, most })
    }

    /// The equilibrium.
    #[must_use]
    pub fn center(&self) -> Phase {
        self.series.center
    }

    /// Places at which curves begin.
    pub fn places(&self) -> impl Iterator<Item = f64> + '_ {
        self.zeros[0].iter().map(|zero| zero.s)
    }

    /// The point from which the motion of s is followed, on that of the two closed curves that is farther from P⁻
    /// there.
    #[must_use]
    pub fn start(&self, s: f64) -> Phase {
        let back = if self.earlier(s) { before(&self.series) } else { 0.0 };
        self.series.at(self.series.coordinates(self.origin + self.sense * TAU * s, -back))
    }

    fn earlier(&self, s: f64) -> bool {
        let away = |zeros: &[Zero]| {
            let apart = zeros.iter().map(|zero| (s - zero.s - (s - zero.s).round()).abs());
            apart.fold(f64::INFINITY, f64::min)
        };
        away(&self.zeros[1]) > away(&self.zeros[0])
    }

    /// The number of the crossing of P⁻ after its start at which the motion of s meets the curve of a level; `None` if
    /// that lies before the start.
    #[must_use]
    pub fn number(&self, level: usize, s: f64) -> Option<usize> {
        let turns = s.floor();
        let passed = self.zeros[usize::from(self.earlier(s))].iter().filter(|zero| zero.s <= s - turns);
        let changes: i64 = passed.map(|zero| zero.change).sum();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_possible_wrap,
            reason = "seeds leave 0..1 by a few spacings at most, and numbers of crossings are small"
        )]
        let number = level as i64 + 1 + changes - self.most + self.winding as i64 * turns as i64;
        usize::try_from(number).ok().filter(|number| *number > 0)
    }
}

fn before(series: &Series) -> f64 {
    let fastest = series.rates.iter().fold(0.0, |most: f64, rate| most.max(rate.re).max(rate.im.abs()));
    BEFORE / fastest
}

/// The angles at which S falls through 0 along the motion, each with the change of numbers as the angle increases.
fn zeros(surface: &Surface, series: &Series, back: f64) -> Vec<(f64, i64)> {
    let seen = |angle: f64| surface.height(&series.at(series.coordinates(angle, -back)));
    let angle = |k: u32| TAU * f64::from(k) / f64::from(SAMPLES);
    let values: Vec<f64> = (0..=SAMPLES).map(|k| seen(angle(k % SAMPLES))[0]).collect();
    let mut found = Vec::new();
    for (k, pair) in (0..SAMPLES).zip(values.windows(2)) {
        if (pair[0] < 0.0) == (pair[1] < 0.0) {
            continue;
        }
        let mut ends = [angle(k), angle(k + 1)];
        for _ in 0..STEPS {
            let middle = 0.5 * (ends[0] + ends[1]);
            let side = usize::from((seen(middle)[0] < 0.0) != (pair[0] < 0.0));
            ends[side] = middle;
        }
        if seen(ends[0])[1] < 0.0 {
            // Where S > 0 the crossing is still to come.
            found.push((ends[0], if pair[0] < 0.0 { 1 } else { -1 }));
        }
    }
    found
}

/// The middle of the widest gap between angles.
fn widest(mut angles: Vec<f64>) -> f64 {
    angles.sort_by(f64::total_cmp);
    let Some(first) = angles.first().copied() else { return 0.0 };
    angles.push(first + TAU);
    let widest = angles.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    widest.map_or(0.0, |pair| 0.5 * (pair[0] + pair[1]))
}
