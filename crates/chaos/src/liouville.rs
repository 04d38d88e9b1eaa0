//! States of one component of an energy surface, spread evenly in Liouville measure (Proposition 12.7 of
//! docs/algorithms.md).

use std::f64::consts::{PI, SQRT_2, TAU};
use std::sync::OnceLock;

use bifdiag_body::Body;
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};
use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::merge::{MergeError, Partition};
use bifdiag_dynamics::field::{Dimension, HeavyTop, State, add, cross, dot, norm, scale};
use bifdiag_numbers::sequence;
use thiserror::Error;

/// Places that are tried for each state before a component counts as too small.
const TRIES: u64 = 200_000;
/// Points of a circle at which its energy is evaluated.
const CIRCLE: u32 = 128;
/// Circles round a minimum, each √2 times as wide as the one before; the narrowest is wider than rounding.
const CIRCLES: u32 = 48;

/// Why a component has no states.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SampleError {
    /// The body or l leave the range of `f64`.
    #[error(transparent)]
    Range(#[from] FastError),
    /// Components that rounding does not tell apart.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// None was met.
    #[error("component {component} is too small: none of {TRIES} places lies in it")]
    TooSmall {
        /// Its number, from 0.
        component: usize,
    },
}

/// One energy surface, E at (h, l), which must be on no curve.
#[derive(Clone, Debug)]
pub struct EnergySurface {
    /// In its own units, as h and l are.
    reduced: HeavyTop,
    top: HeavyTop,
    h: f64,
    l: f64,
    components: usize,
    region: AccessibleRegion,
    /// For each component, once it was requested.
    domains: Vec<OnceLock<Domain>>,
}

impl EnergySurface {
    /// The surface over the accessible region, which has this many components.
    ///
    /// # Errors
    /// [`SampleError::Range`].
    pub fn new(body: &Body, h: f64, l: f64, components: usize) -> Result<Self, SampleError> {
        let top = HeavyTop::new(body);
        let units = top.units();
        Ok(Self {
            reduced: top.reduced(),
            top,
            h: units.reduce(h, Dimension::ENERGY),
            l: units.reduce(l, Dimension::MOMENTUM),
            components,
            region: AccessibleRegion::new(body, h, l)?,
            domains: vec![OnceLock::new(); components],
        })
    }

    /// The top as it was given, in whose units the states are.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        &self.top
    }

    /// How many components it has.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components
    }

    /// The first `count` states of one component, in a sequence of low discrepancy that `seed` chooses. More states begin
    /// with the same ones.
    ///
    /// # Errors
    /// [`SampleError::Merge`] and [`SampleError::TooSmall`].
    pub fn states(&self, component: usize, count: usize, seed: u64) -> Result<Vec<State>, SampleError> {
        Ok(self.states_from(component, count, seed, 0)?.0)
    }

    /// States from a position in the sequence, and the position at which it continues.
    ///
    /// # Errors
    /// Those of [`states`](Self::states).
    pub fn states_from(
        &self,
        component: usize,
        count: usize,
        seed: u64,
        from: u64,
    ) -> Result<(Vec<State>, u64), SampleError> {
        let partition = match self.region.partition() {
            Ok(partition) => partition,
            // A minimum may be degenerate, but every point belongs to the only component.
            Err(_) if self.components == 1 => None,
            Err(error) => return Err(error.into()),
        };
        let Some(domain) = self.domains.get(component) else { return Err(SampleError::TooSmall { component }) };
        let domain = domain.get_or_init(|| self.domain(partition.as_ref(), component));
        let smallest = self.reduced.moments().iter().copied().fold(f64::INFINITY, f64::min);
        let mut states = Vec::with_capacity(count);
        let mut idle = 0;
        let mut next = from;
        while states.len() < count {
            if idle == TRIES {
                return Err(SampleError::TooSmall { component });
            }
            idle += 1;
            let place = sequence::point(next, 4, seed);
            next += 1;
            let gamma = domain.cap.point(place[0], place[1]);
            let j = dot(gamma, self.reduced.inertia(gamma));
            // The density J^(−1/2), relative to its largest value.
            if place[2] * place[2] * j > smallest || self.height(gamma) < 0.0 {
                continue;
            }
            let is_here = domain.is_alone
                || partition.as_ref().is_none_or(|partition| component_of(partition, gamma) == Some(component));
            if is_here {
                states.push(self.state(gamma, TAU * place[3]).restored(self.top.units()));
                idle = 0;
            }
        }
        Ok((states, next))
    }

    /// h − U(γ).
    fn height(&self, gamma: [f64; 3]) -> f64 {
        self.h - self.reduced.effective_potential(gamma, self.l)
    }

    /// The state over γ in a direction: 𝐥 = l Aγ/J + √(2(h − U)) (e cos θ + f sin θ), where e, f are orthonormal in A⁻¹
    /// and perpendicular to γ.
    fn state(&self, gamma: [f64; 3], direction: f64) -> State {
        let smallest = (0..3).min_by(|&i, &j| gamma[i].abs().total_cmp(&gamma[j].abs())).unwrap_or(0);
        let normalised = |v: [f64; 3]| scale(1.0 / dot(v, self.reduced.inverse_inertia(v)).sqrt(), v);
        let e = normalised(cross(gamma, std::array::from_fn(|i| if i == smallest { 1.0 } else { 0.0 })));
        let f = normalised(cross(gamma, self.reduced.inverse_inertia(e)));
        let inertia_gamma = self.reduced.inertia(gamma);
        let (sin, cos) = libm::sincos(direction);
        let speed = (2.0 * self.height(gamma).max(0.0)).sqrt();
        let turning = add(scale(speed * cos, e), scale(speed * sin, f));
        State { gamma, l: add(scale(self.l / dot(gamma, inertia_gamma), inertia_gamma), turning) }
    }

    /// Where the places of a component are looked for: in the smallest cap about a minimum, or another point of the only
    /// component, whose rim is proved to be inaccessible, or on the whole sphere.
    fn domain(&self, partition: Option<&Partition<'_>>, component: usize) -> Domain {
        let minimum = |component: usize| match partition {
            Some(partition) => partition.minimum_of(component).map(|gamma| partition.frame().vector_to_body(gamma)),
            None => self.reduced.r_hat().filter(|gamma| self.height(*gamma) >= 0.0),
        };
        let found = minimum(component).and_then(|center| {
            let mut radius = PI;
            let radii = (0..CIRCLES).map(|_| {
                radius /= SQRT_2;
                radius
            });
            let radii: Vec<f64> = radii.collect();
            radii.into_iter().rev().map(|radius| Cap::new(center, radius)).find(|cap| self.is_inaccessible(cap))
        });
        let Some(cap) = found else {
            return Domain { cap: Cap::new([0.0, 0.0, 1.0], PI), is_alone: self.components == 1 };
        };
        // Another component that is met by the cap does not meet its rim, and lies in it with its minimum.
        let is_elsewhere = |other: usize| minimum(other).is_some_and(|gamma| !cap.contains(gamma));
        let is_alone = (0..self.components).filter(|other| *other != component).all(is_elsewhere);
        Domain { cap, is_alone }
    }

    /// True if U > h on the whole rim of a cap.
    ///
    /// There G = J (h − U) is a trigonometric polynomial of degree 3 (Lemma 2.3 of docs/mathematics.md), and |G″| ≤ 9 max|G|
    /// (Bernstein), so that between points δ apart it is at most 9δ²/8 max|G| above the larger of both.
    fn is_inaccessible(&self, cap: &Cap) -> bool {
        let step = TAU / f64::from(CIRCLE);
        let (mut highest, mut size) = (f64::NEG_INFINITY, 0.0_f64);
        for k in 0..CIRCLE {
            let gamma = cap.rim(step * f64::from(k));
            let g = dot(gamma, self.reduced.inertia(gamma)) * self.height(gamma);
            (highest, size) = (highest.max(g), size.max(g.abs()));
        }
        let between = 9.0 * step * step / 8.0;
        // max|G| ≤ size + between · max|G|
        highest + between * size / (1.0 - between) < 0.0
    }
}

/// Where the places of a component lie.
#[derive(Clone, Copy, Debug)]
struct Domain {
    cap: Cap,
    /// No other component meets the cap.
    is_alone: bool,
}

/// The points of the sphere within an angle from a centre.
#[derive(Clone, Copy, Debug)]
struct Cap {
    center: [f64; 3],
    first: [f64; 3],
    second: [f64; 3],
    /// 1 − cos of the angle, and its sine.
    height: f64,
    sin: f64,
}

impl Cap {
    fn new(center: [f64; 3], radius: f64) -> Self {
        let smallest = (0..3).min_by(|&i, &j| center[i].abs().total_cmp(&center[j].abs())).unwrap_or(0);
        let first = cross(center, std::array::from_fn(|i| if i == smallest { 1.0 } else { 0.0 }));
        let first = scale(1.0 / norm(first), first);
        let half = libm::sin(0.5 * radius);
        Self { center, first, second: cross(center, first), height: 2.0 * half * half, sin: libm::sin(radius) }
    }

    /// A point by its place in the unit square, whose area goes over into that of the cap.
    fn point(&self, x: f64, y: f64) -> [f64; 3] {
        let depth = self.height * x;
        self.at(depth, (depth * (2.0 - depth)).max(0.0).sqrt(), TAU * y)
    }

    fn rim(&self, angle: f64) -> [f64; 3] {
        self.at(self.height, self.sin, angle)
    }

    /// The point 1 − cos = `depth`, sin = `sin` away from the centre.
    fn at(&self, depth: f64, sin: f64, angle: f64) -> [f64; 3] {
        let (up, across) = libm::sincos(angle);
        let around = add(scale(sin * across, self.first), scale(sin * up, self.second));
        let gamma = add(scale(1.0 - depth, self.center), around);
        scale(1.0 / norm(gamma), gamma)
    }

    fn contains(&self, gamma: [f64; 3]) -> bool {
        let difference: [f64; 3] = std::array::from_fn(|i| gamma[i] - self.center[i]);
        // 1 − cos = |difference|²/2
        0.5 * dot(difference, difference) <= self.height
    }
}
