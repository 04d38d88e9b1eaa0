//! The effective potential beside a point of the sphere: U(γ) − U(p) without cancellation.

use super::path::Path;
use crate::equilibria::places::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::interval::Interval;
use crate::numbers::jet::Jet;

/// Coordinates in the eigenspaces of A, by rising moment; in each the first axis is that of r.
pub(crate) type Coordinates = [Fixed; 3];

/// A body at one x.
pub(crate) struct Landscape<'a> {
    spaces: &'a Spaces,
    a: [Interval; 3],
    /// a_i − a_2, with the middle moment: as small as they are.
    offset: [Interval; 3],
    r: [Interval; 3],
    x: Interval,
}

/// A point from which heights are measured.
pub(crate) struct Origin {
    pub gamma: Coordinates,
    /// The same.
    pub p: [Interval; 3],
    /// x/J.
    ratio: Interval,
    kind: Kind,
}

impl Origin {
    /// The order of the first derivative of U that need not vanish here.
    pub fn order(&self) -> usize {
        match self.kind {
            Kind::Equilibrium(_) => 2,
            Kind::Pole(_) => 1,
        }
    }
}

enum Kind {
    /// With μ − a_i.
    Equilibrium([Interval; 3]),
    /// ± r̂, with ± |r|.
    Pole(Interval),
}

/// A number for each axis, from one for each space: on the first axis of a space, and on its others.
fn spread<T>(spaces: &Spaces, first: impl Fn(usize) -> T, other: impl Fn(usize) -> T) -> Option<[T; 3]> {
    let axes = spaces.list.iter().enumerate().flat_map(|(k, space)| (0..space.axes.len()).map(move |n| (k, n)));
    let list: Vec<T> = axes.map(|(k, n)| if n == 0 { first(k) } else { other(k) }).collect();
    list.try_into().ok()
}

impl<'a> Landscape<'a> {
    pub fn new(spaces: &'a Spaces, x: &Fixed) -> Option<Self> {
        let of_space = spread(spaces, |k| k, |k| k)?;
        let zero = |_| Interval::point(0.0);
        Some(Self {
            spaces,
            a: of_space.map(|k| Interval::of(&spaces.list[k].a_set)),
            offset: of_space.map(|k| Interval::of(spaces.difference(k, of_space[1]))),
            r: spread(spaces, |k| Interval::of(&spaces.list[k].root_q), zero)?,
            x: Interval::of(x),
        })
    }

    /// An equilibrium; `mirrored` in a space if it is one of a pair.
    pub fn equilibrium(&self, point: &Point, mirrored: Option<usize>) -> Option<Origin> {
        let tau = point.tau.as_ref()?;
        let tau = spread(self.spaces, |k| Interval::of(&tau[k]), |k| Interval::of(&tau[k]))?;
        self.origin(point, mirrored, Kind::Equilibrium(tau))
    }

    /// A pole ± r̂ that is no equilibrium.
    pub fn pole(&self, point: &Point) -> Option<Origin> {
        self.origin(point, None, Kind::Pole(Interval::of(&point.rho)))
    }

    fn origin(&self, point: &Point, mirrored: Option<usize>, kind: Kind) -> Option<Origin> {
        let sign = |k: usize| {
            if mirrored == Some(k) { -&point.gamma[k] } else { point.gamma[k].clone() }
        };
        let gamma = spread(self.spaces, sign, |_| Fixed::whole(0))?;
        let ratio = self.x * Interval::of(&point.j).recip();
        Some(Origin { p: gamma.each_ref().map(Interval::of), gamma, ratio, kind })
    }

    /// U(γ) − U(p), twice, each time with a positive factor and its first two derivatives over a range of t. With
    /// Δ = γ − p and K = J(γ) − J(p) = Σ (a_i − a_2) Δ_i (2p_i + Δ_i) it is −x K/(J(p) J(γ)) − ⟨Δ, r⟩, and what does not
    /// cancel near p: Σ (μ−a_i) Δ_i² + K²/J(γ) from an equilibrium (Proposition 3.9), and the same with ± |r| |Δ|²/2 for
    /// −⟨Δ, r⟩ from a pole ± r̂.
    pub fn rise(&self, from: &Origin, path: &Path, t: Interval) -> [Jet; 2] {
        let p = from.p.map(Jet::constant);
        let w = path.jets(&from.p, t);
        let one = Jet::constant(Interval::point(1.0));
        let sum = |terms: [Jet; 3]| terms[0] + terms[1] + terms[2];
        // |p + w|² = 1 + excess, and stretch = |p + w| − 1.
        let excess = path.excess(&from.p, &w);
        let length = (one + excess).sqrt();
        let stretch = excess * (one + length).recip();
        let inverse = length.recip();
        let delta: [Jet; 3] = std::array::from_fn(|i| (w[i] - stretch * p[i]) * inverse);
        let twice: [Jet; 3] = std::array::from_fn(|i| p[i] + p[i] + delta[i]);
        let gain = sum(std::array::from_fn(|i| (delta[i] * twice[i]).times(self.offset[i])));
        let moment = sum(std::array::from_fn(|i| (p[i] + delta[i]).square().times(self.a[i])));
        let drop = sum(std::array::from_fn(|i| delta[i].times(self.r[i])));
        let relative = gain * moment.recip();
        let plain = Jet::constant(Interval::point(0.0)) - relative.times(from.ratio) - drop;
        let squares = |factors: [Interval; 3]| sum(std::array::from_fn(|i| delta[i].square().times(factors[i])));
        let close = match from.kind {
            Kind::Equilibrium(tau) => squares(tau) + gain * relative,
            Kind::Pole(r) => squares([Interval::point(0.5) * r; 3]) - relative.times(from.ratio),
        };
        [close, plain]
    }

    /// The direction in which U falls fastest at p + w, rounded; along the sphere, of length 1.
    pub fn steepest(&self, from: &Origin, w: &[f64; 3]) -> [f64; 3] {
        let start = w.map(Interval::point);
        let slope = |direction: [f64; 3]| {
            let line = Path::Line { start, direction: direction.map(Interval::point) };
            self.rise(from, &line, Interval::point(0.0))[0].0[1].middle()
        };
        let basis = tangents(&std::array::from_fn(|i| from.p[i].middle() + w[i]));
        let [u, v] = basis.map(slope);
        unit(std::array::from_fn(|i| -u * basis[0][i] - v * basis[1][i]))
    }

    /// How a valley runs at p + w, rounded: the way to its floor, and the direction in which it falls, along the sphere and of
    /// length 1. The second derivatives distinguish the stiff direction, across the valley, from the soft one, along it.
    pub fn valley(&self, from: &Origin, w: &[f64; 3]) -> [[f64; 3]; 2] {
        let start = w.map(Interval::point);
        let derivatives = |direction: [f64; 3]| {
            let line = Path::Line { start, direction: direction.map(Interval::point) };
            let [_, slope, bend] = self.rise(from, &line, Interval::point(0.0))[0].0;
            [slope.middle(), 2.0 * bend.middle()]
        };
        let [first, second] = tangents(&std::array::from_fn(|i| from.p[i].middle() + w[i]));
        let along = |[p, q]: [f64; 2]| std::array::from_fn(|i| p * first[i] + q * second[i]);
        let ([g, u], [k, v]) = (derivatives(first), derivatives(second));
        let [_, sum] = derivatives(along([1.0, 1.0]));
        let soft = lower_eigenvector([u, 0.5 * (sum - u - v), v]);
        let stiff = [-soft[1], soft[0]];
        let slope = |[p, q]: [f64; 2]| g * p + k * q;
        let bend = u * stiff[0] * stiff[0] + (sum - u - v) * stiff[0] * stiff[1] + v * stiff[1] * stiff[1];
        let down = if slope(soft) > 0.0 { -1.0 } else { 1.0 };
        if bend > 0.0 {
            let floor = -slope(stiff) / bend;
            [along(stiff.map(|c| floor * c)), along(soft.map(|c| down * c))]
        } else {
            [[0.0; 3], unit(along([-g, -k]))]
        }
    }

    /// The tangent direction of least second derivative at an equilibrium, rounded: that of the lower eigenvalue of
    /// (μ−A) + (4/J) Aγ(Aγ)ᵀ on γ⊥ (Proposition 4.1).
    pub fn softest(&self, from: &Origin) -> Option<[f64; 3]> {
        let Kind::Equilibrium(tau) = from.kind else {
            return None;
        };
        let (p, tau) = (from.p.map(Interval::middle), tau.map(Interval::middle));
        let (a, offset) = (self.a.map(Interval::middle), self.offset.map(Interval::middle));
        let [first, second] = tangents(&p);
        let moment: f64 = (0..3).map(|i| a[i] * p[i] * p[i]).sum();
        let gain = |d: &[f64; 3]| (0..3).map(|i| offset[i] * p[i] * d[i]).sum::<f64>();
        let form = |d: &[f64; 3], e: &[f64; 3]| {
            (0..3).map(|i| tau[i] * d[i] * e[i]).sum::<f64>() + 4.0 / moment * gain(d) * gain(e)
        };
        let [alpha, beta] = lower_eigenvector([form(&first, &first), form(&first, &second), form(&second, &second)]);
        Some(unit(std::array::from_fn(|i| alpha * first[i] + beta * second[i])))
    }
}

/// A vector of length 1 to the lower eigenvalue λ of ((u, v), (v, w)), rounded: (u−λ)α + vβ = 0 = vα + (w−λ)β, using
/// the one without cancellation.
fn lower_eigenvector([u, v, w]: [f64; 3]) -> [f64; 2] {
    let half = 0.5 * (u - w);
    let root = (half * half + v * v).sqrt();
    let [alpha, beta] = match (root > 0.0, half >= 0.0) {
        (false, _) => [1.0, 0.0],
        (_, true) => [v, -(half + root)],
        (_, false) => [half - root, v],
    };
    let length = (alpha * alpha + beta * beta).sqrt();
    [alpha / length, beta / length]
}

/// p + w, rounded, moved back to the sphere: w of the same direction.
pub(crate) fn on_sphere(from: &Origin, w: &[f64; 3]) -> [f64; 3] {
    let p = from.p.map(Interval::middle);
    let excess: f64 = (0..3).map(|i| w[i] * (2.0 * p[i] + w[i])).sum();
    let length = (1.0 + excess).sqrt();
    let stretch = excess / (1.0 + length);
    std::array::from_fn(|i| (w[i] - stretch * p[i]) / length)
}

/// Two directions across a vector and one another, rounded: each component as well as it can be.
fn tangents(v: &[f64; 3]) -> [[f64; 3]; 2] {
    let p = unit(*v);
    let least = (1..3).fold(0, |least, i| if p[i].abs() < p[least].abs() { i } else { least });
    let first = unit(std::array::from_fn(|i| f64::from(u8::from(i == least)) - p[least] * p[i]));
    [first, cross(&p, &first)]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let v = v.map(|c| c / largest);
    let norm = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / norm)
}

fn cross(p: &[f64; 3], q: &[f64; 3]) -> [f64; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}
