//! Steady rotations near an axis when tensor and centre of mass are known as intervals: their type over the spin.
//!
//! In a part whose products of inertia or centre of mass are uncertain no axis is permanent at every spin, but at every spin
//! there is a steady rotation near one. With g = −up + x e + y f, where e and f lie across, it is a zero of ⟨v × g, e⟩ and
//! ⟨v × g, f⟩, v = s A g + |g| r. Krawczyk's operator shows that a square of (x, y) holds exactly one zero for every part of
//! the box and every spin of an interval; Theorem 13.1 of docs/mathematics.md gives its type over that square (Proposition
//! 13.8). Squares at neighbouring spins have one middle, so that they hold the same rotation.

use bifdiag_body::Body;
use bifdiag_body::part::{INPUT_NAMES, INPUTS, MeasuredPart, Part};
use bifdiag_numbers::Number;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::sequence;
use bifdiag_numbers::vector::{self, normalised};
use dashu_ratio::RBig;

use super::certain;
use super::path::{NominalBody, Path};
use super::rotation::{AxisRotation, SpinType};
use super::tolerance::{SpinRange, ranges_over};

/// Three numbers known as intervals.
pub type Vector = [Interval; 3];

/// The tensor about the fixed point and r, of inputs within a box.
#[derive(Clone, Copy, Debug)]
pub struct BoxedBody {
    /// A, symmetric.
    pub tensor: [Vector; 3],
    /// r.
    pub center: Vector,
}

/// What holds for every part of a box.
#[derive(Clone, Debug, PartialEq)]
pub struct SettledTypes {
    /// Where the type is not settled, by rising spin and apart.
    pub ranges: Vec<SpinRange>,
    /// Outside the ranges the axis of the rotation is nearer than this angle, in radians, to the given one or, where that of
    /// the nominal part is followed, to that at the same spin; `None` where the given one is permanent for every part.
    pub tilt: Option<f64>,
}

/// Near what rotations are meant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Near<'a> {
    /// The axis itself, which is permanent for the nominal part: its rotation with that end up.
    Axis(&'a AxisRotation),
    /// The nominal part's steady rotation that tends to the principal axis nearest to the given one at fast spins.
    NominalRotation {
        /// The spin at which it begins.
        slowest: f64,
    },
}

/// Steady rotations tilted by more than about this, in radians, are not called near.
const NEAR: f64 = 0.1;

/// Pieces of the parameter are not halved beyond this, relative to the parameter …
const FINEST: f64 = 2e-4;
/// … or, at rest and at infinite spin, to its unit.
const FLOOR: f64 = 1e-7;

/// Pieces shorter than this, relative to the parameter, are given up when both ends and the middle fail.
const COARSE: f64 = 0.02;

/// Into how many pieces the box is cut along each entry of the diagonal, where intervals of the whole are too wide.
const CUTS: [u32; 3] = [1, 2, 5];

/// Parts that are tried for their classes, the nominal one first.
const MEASURED_SAMPLES: u64 = 81;

/// What bounds may be wide by without a tolerance, over their size.
const ROUNDING: f64 = 1e-12;

/// The types of a measured part's steady rotations near the axis that points up along `up` in the part's frame. With each
/// range the number that alone leaves the largest part of it unsettled, and half of that.
#[must_use]
pub fn settled_types_of_part(part: &Part, measured: &MeasuredPart, up: [f64; 3], near: Near<'_>) -> SettledTypes {
    let boxed = |measured: &MeasuredPart| {
        let (tensor, center) = measured.bounds(&part.units);
        BoxedBody { tensor, center }
    };
    let nominal = boxed(&measured.nominal()).middle();
    let settled = |measured: &MeasuredPart| match near {
        Near::Axis(rotation) => match certain::boxes(measured, &part.units, rotation, up) {
            Some(boxes) => SettledTypes { ranges: ranges_over(rotation, &boxes), tilt: None },
            None => settled_types(&boxed(measured), up),
        },
        Near::NominalRotation { slowest } => settled_types_beside(&boxed(measured), nominal, up, slowest),
    };
    let mut found = settled(measured);
    let alone: Vec<(usize, SettledTypes)> = measured.uncertain().map(|k| (k, settled(&measured.only(k)))).collect();
    for range in &mut found.ranges {
        let [from, to] = range.omega;
        let unsettled = |found: &SettledTypes| {
            let common = found.ranges.iter().map(|other| (other.omega[1].min(to) - other.omega[0].max(from)).max(0.0));
            0.5 * common.sum::<f64>()
        };
        // Less is rounding: the bounds of a part without tolerances have some width too.
        let least = ROUNDING * to.abs();
        let moved = alone.iter().map(|(input, found)| (*input, unsettled(found))).filter(|(_, moved)| *moved > least);
        // Of equals the first.
        let most = moved.max_by(|p, q| p.1.total_cmp(&q.1).then(q.0.cmp(&p.0)));
        range.most = most.map(|(input, moved)| (INPUT_NAMES[input], moved));
    }
    found
}

/// The bodies of sampled parts that can exist (of all, where the nominal one cannot); `None` for one whose tensor is not
/// positive definite.
pub fn sampled_parts<'a>(part: &'a Part, measured: &'a MeasuredPart) -> impl Iterator<Item = Option<Body>> + 'a {
    let physical = part.properties.existence().is_possible();
    let sampled = (0..MEASURED_SAMPLES).filter_map(|number| measured.at(&deviations(number)).ok());
    let possible = sampled.filter(move |(properties, _)| !physical || properties.existence().is_possible());
    possible.map(|(properties, gravity)| Some(Part { properties, gravity, ..part.clone() }.principal().ok()?.body))
}

/// A random point of the cube from −1 to 1; number 0 is its middle.
fn deviations(number: u64) -> [RBig; INPUTS] {
    const BITS: u32 = 20;
    std::array::from_fn(|k| {
        if number == 0 {
            return RBig::ZERO;
        }
        let bits = sequence::random(number * INPUTS as u64 + k as u64) >> (64 - BITS - 1);
        RBig::from_parts(i64::try_from(bits).unwrap_or_default().into(), (1_u64 << BITS).into()) - RBig::ONE
    })
}

/// The same of all bodies whose principal moments and components of r differ by a factor from 1 − `share` to 1 + `share`,
/// with the principal axes of the nominal one: beside its steady rotation, which begins at the spin `slowest`.
#[must_use]
pub fn settled_types_of_shares(body: &Body, share: &RBig, up: [f64; 3], slowest: f64) -> SettledTypes {
    let around = |value: &RBig| {
        let end = |factor: RBig| Interval::rational(&(value * factor), ());
        end(RBig::ONE - share).hull(&end(RBig::ONE + share))
    };
    let moments = body.moments().each_ref().map(|a| around(a.value()));
    let tensor = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { moments[i] } else { Interval::ZERO }));
    let center = body.center().each_ref().map(|r| around(r.value()));
    let boxed = BoxedBody { tensor, center };
    let (a, center) = (body.moments_f64(), body.center_f64());
    let tensor = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { a[i] } else { 0.0 }));
    settled_types_beside(&boxed, NominalBody { tensor, center }, up, slowest)
}

/// Bodies within a share of a nominal one; `None` for one that is no body.
pub fn sampled_shares<'a>(body: &'a Body, share: &'a RBig) -> impl Iterator<Item = Option<Body>> + 'a {
    (0..MEASURED_SAMPLES).map(move |number| {
        let steps = deviations(number);
        let text = |(value, step): (&Number, &RBig)| (value.value() * (RBig::ONE + share * step)).to_string();
        let list = |numbers: &[Number; 3], steps: &[RBig]| -> [String; 3] {
            let texts: Vec<String> = numbers.iter().zip(steps).map(text).collect();
            texts.try_into().unwrap_or_default()
        };
        let (a, r) = (list(body.moments(), &steps[..3]), list(body.center(), &steps[3..6]));
        Body::parse(&a.each_ref().map(String::as_str), &r.each_ref().map(String::as_str)).ok()
    })
}

/// The types of the steady rotations near the nominal one that tends to the principal axis nearest to `up`.
fn settled_types_beside(body: &BoxedBody, nominal: NominalBody, up: [f64; 3], slowest: f64) -> SettledTypes {
    let Some(path) = Path::new(nominal, body.unit(), up, slowest) else {
        let omega = [0.0, f64::INFINITY];
        let whole = SpinRange { from: None, to: None, omega, between: Vec::new(), most: None };
        return SettledTypes { ranges: vec![whole], tilt: Some(0.0) };
    };
    settled_by(Search::new(body, Middle::Along(path)))
}

/// The types of the steady rotations near the axis that points up along `up`, at all spins.
#[must_use]
pub fn settled_types(body: &BoxedBody, up: [f64; 3]) -> SettledTypes {
    settled_by(Search::new(body, Middle::Fixed(basis(up))))
}

fn settled_by(mut search: Search) -> SettledTypes {
    for half in [[0.0, 1.0], [1.0, 2.0]] {
        search.settle(half);
    }
    search.collected()
}

/// A piece of the parameter on which all parts have one type.
#[derive(Clone, Copy, Debug)]
struct Settled {
    ends: [f64; 2],
    kind: SpinType,
    tilt: f64,
}

/// The search over the parameter θ from 0, at rest, to 2, at infinite spin: s = θ·unit up to θ = 1, and beyond it r is
/// scaled by 2 − θ at s = unit, which is the same up to the unit of time.
struct Search {
    /// The box, whole and cut more and more finely.
    boxes: [Vec<BoxedBody>; CUTS.len()],
    unit: f64,
    middle: Middle,
    settled: Vec<Settled>,
}

/// The middle of the squares, each as −up, e, f.
enum Middle {
    Fixed([[f64; 3]; 3]),
    /// That of the nominal rotation.
    Along(Path),
}

impl Search {
    fn new(body: &BoxedBody, middle: Middle) -> Self {
        Self { boxes: CUTS.map(|pieces| body.cut(pieces)), unit: body.unit(), middle, settled: Vec::new() }
    }

    fn basis(&self, [from, to]: [f64; 2]) -> Option<[[f64; 3]; 3]> {
        match &self.middle {
            Middle::Fixed(basis) => Some(*basis),
            Middle::Along(path) => path.at(0.5 * (from + to)).map(basis),
        }
    }

    /// Halves a piece until each part is settled or too short.
    fn settle(&mut self, ends: [f64; 2]) {
        if let Some((kind, tilt)) = self.kind(ends) {
            self.settled.push(Settled { ends, kind, tilt });
            return;
        }
        let [from, to] = ends;
        let size = if to <= 1.0 { to } else { 2.0 - from };
        let width = to - from;
        if width <= FLOOR.max(FINEST * size) {
            return;
        }
        let middle = from + 0.5 * width;
        if width <= COARSE * size && [from, middle, to].iter().all(|&at| self.kind([at, at]).is_none()) {
            return;
        }
        self.settle([from, middle]);
        self.settle([middle, to]);
    }

    /// The type of every part at every parameter of a piece, and the largest tilt.
    fn kind(&self, [from, to]: [f64; 2]) -> Option<(SpinType, f64)> {
        let basis = self.basis([from, to])?;
        let at = |s, weight| self.boxes.iter().find_map(|boxes| kind_of_all(boxes, &basis, s, weight));
        if to <= 1.0 {
            at(Interval::between(from, to) * Interval::point(self.unit), Interval::point(1.0))
        } else {
            at(Interval::point(self.unit), Interval::between(2.0 - from, 2.0 - to))
        }
    }

    /// What lies between the settled pieces, as ranges of Ω.
    fn collected(&self) -> SettledTypes {
        let omega = |theta: f64| {
            let s = if theta <= 1.0 { self.unit * theta } else { self.unit / (2.0 - theta) };
            s.sqrt()
        };
        let mut ranges = Vec::new();
        let mut before: Option<&Settled> = None;
        let mut unsettled = |before: Option<&Settled>, after: Option<&Settled>| {
            let [low, high] = [before.map_or(0.0, |piece| piece.ends[1]), after.map_or(2.0, |piece| piece.ends[0])];
            // Squares with another middle may hold another rotation.
            let differ = before.zip(after).is_some_and(|(before, after)| before.kind != after.kind);
            if low < high || differ {
                let ends = [omega(low) * (1.0 - 4.0 * f64::EPSILON), omega(high) * (1.0 + 4.0 * f64::EPSILON)];
                let [from, to] = [before, after].map(|piece| piece.map(|piece| piece.kind));
                ranges.push(SpinRange { from, to, omega: ends, between: Vec::new(), most: None });
            }
        };
        for piece in &self.settled {
            unsettled(before, Some(piece));
            before = Some(piece);
        }
        unsettled(before, None);
        let tilt = self.settled.iter().map(|piece| piece.tilt).fold(0.0, f64::max);
        // The nominal rotation lies in the square, too, but not in its middle.
        let tilt = if matches!(self.middle, Middle::Along(_)) { 2.0 * tilt } else { tilt };
        SettledTypes { ranges, tilt: Some(tilt) }
    }
}

/// The type that all boxes share, and the largest tilt.
fn kind_of_all(boxes: &[BoxedBody], basis: &[[f64; 3]; 3], s: Interval, weight: Interval) -> Option<(SpinType, f64)> {
    let mut shared: Option<(SpinType, f64)> = None;
    for body in boxes {
        let rotation = rotation(body, basis, s, weight)?;
        let kind = rotation.kind(s, weight)?;
        let tilt = match shared {
            Some((other, _)) if other != kind => return None,
            Some((_, tilt)) => tilt.max(rotation.tilt),
            None => rotation.tilt,
        };
        shared = Some((kind, tilt));
    }
    shared
}

/// The square that holds exactly one steady rotation of every part of a box.
fn rotation<'a>(body: &'a BoxedBody, basis: &'a [[f64; 3]; 3], s: Interval, weight: Interval) -> Option<Rotation<'a>> {
    let middle = Square { body, basis, half: 0.0 };
    let value = middle.value(s, weight);
    let inverse = inverse(middle.jacobian(s, weight))?;
    let step = apply(&inverse, value).map(Interval::magnitude);
    for inflation in [1.5, 4.0] {
        let half = inflation * step[0].max(step[1]) + 1e-15;
        if half.is_nan() || half > NEAR {
            return None;
        }
        let square = Square { half, ..middle };
        let jacobian = square.jacobian(s, weight);
        let inside = (0..2).all(|i| {
            // −Y F(0) + (1 − Y J) X
            let rest: f64 = (0..2)
                .map(|j| {
                    let product = Interval::point(inverse[i][0]) * jacobian[0][j]
                        + Interval::point(inverse[i][1]) * jacobian[1][j];
                    let unit = if i == j { Interval::point(1.0) } else { Interval::ZERO };
                    ((unit - product) * Interval::point(half)).magnitude()
                })
                .map(f64::next_up)
                .sum();
            (step[i] + rest).next_up().next_up() < half
        });
        if inside {
            return Some(Rotation { square, tilt: 1.001 * std::f64::consts::SQRT_2 * half });
        }
    }
    None
}

/// Points g = −up + x e + y f with |x| and |y| up to `half`.
#[derive(Clone, Copy)]
struct Square<'a> {
    body: &'a BoxedBody,
    basis: &'a [[f64; 3]; 3],
    half: f64,
}

impl Square<'_> {
    fn point(&self) -> Vector {
        let either = Interval::between(-self.half, self.half);
        let [n, e, f] = self.basis.map(|v| v.map(Interval::point));
        [0, 1, 2].map(|k| n[k] + either * e[k] + either * f[k])
    }

    /// s A g + |g| r, r scaled.
    fn force(&self, g: &Vector, s: Interval, weight: Interval) -> Vector {
        let (length, turned) = (dot(g, g).sqrt(), self.body.times(g));
        [0, 1, 2].map(|k| s * turned[k] + weight * length * self.body.center[k])
    }

    fn value(&self, s: Interval, weight: Interval) -> [Interval; 2] {
        let g = self.point();
        let normal = cross(&self.force(&g, s, weight), &g);
        [1, 2].map(|k| dot(&normal, &self.basis[k].map(Interval::point)))
    }

    fn jacobian(&self, s: Interval, weight: Interval) -> [[Interval; 2]; 2] {
        let g = self.point();
        let (force, length) = (self.force(&g, s, weight), dot(&g, &g).sqrt());
        let across = [1, 2].map(|k| self.basis[k].map(Interval::point));
        let columns = across.map(|e| {
            let (turned, longer) = (self.body.times(&e), dot(&g, &e) / length);
            let change = [0, 1, 2].map(|k| s * turned[k] + weight * longer * self.body.center[k]);
            let (first, second) = (cross(&change, &g), cross(&force, &e));
            let normal = [0, 1, 2].map(|k| first[k] + second[k]);
            across.map(|f| dot(&normal, &f))
        });
        [[columns[0][0], columns[1][0]], [columns[0][1], columns[1][1]]]
    }
}

/// A square that holds exactly one steady rotation of every part.
struct Rotation<'a> {
    square: Square<'a>,
    tilt: f64,
}

impl Rotation<'_> {
    /// The type by the signs of K, b and b² − 4c; `None` where one is open.
    fn kind(&self, s: Interval, weight: Interval) -> Option<SpinType> {
        let Square { body, basis, .. } = self.square;
        let g = self.square.point();
        let length = dot(&g, &g).sqrt();
        let gamma = g.map(|x| x / length);
        let turned = body.times(&gamma);
        let j = dot(&gamma, &turned);
        let multiplier = s * j + weight * dot(&gamma, &body.center);
        // An orthonormal basis across γ.
        let e = basis[1].map(Interval::point);
        let along = dot(&e, &gamma);
        let across = [0, 1, 2].map(|i| e[i] - along * gamma[i]);
        let size = dot(&across, &across).sqrt();
        let first = across.map(|x| x / size);
        let across = [first, cross(&gamma, &first)];
        let tangential = across.each_ref().map(|e| dot(e, &turned));
        // K, and S with M⁻¹ = S/det S: by Theorem 13.1 M is the adjugate of A′ − aaᵀ/J.
        let form = |p: usize, q: usize| {
            let turned = dot(&across[p], &body.times(&across[q]));
            let coupled = tangential[p] * tangential[q] / j;
            let unit = if p == q { multiplier } else { Interval::ZERO };
            [unit - s * turned + (s * coupled).twice().twice(), turned - coupled, turned]
        };
        let ([k11, s11, a11], [k12, s12, a12], [k22, s22, a22]) = (form(0, 0), form(0, 1), form(1, 1));
        match ((k11 * k22 - k12.square()).is_positive()?, k11.is_positive()) {
            (false, _) => return Some(SpinType::SaddleCentre),
            (true, Some(true)) => return Some(SpinType::Minimum),
            (true, None) => return None,
            (true, Some(false)) => {}
        }
        // tr A − 2 |Aγ|²/J with the trace t of P = A′, d = |a|²/J and c = ⟨a, Pa⟩/J.
        let [x, y] = tangential;
        let (trace, d) = (a11 + a22, (x.square() + y.square()) / j);
        let c = (x.square() * a11 + (x * y * a12).twice() + y.square() * a22) / j;
        let gyroscopic = s * (trace - j - d.twice()).square();
        // g² + 2 tr SK, in which most of both cancels: s (J² − (P₁₁ − P₂₂)² − 4 P₁₂² + 2Jd − 4td − 4d² + 10c) + 2⟨γ, r⟩(t − d).
        let small = (j * d).twice() - (trace * d + d.square()).twice().twice() + c * Interval::point(10.0);
        let turning = s * (j.square() - (a11 - a22).square() - a12.square().twice().twice() + small);
        let excess = turning + (weight * dot(&gamma, &body.center) * (trace - d)).twice();
        // S K
        let product = [[s11 * k11 + s12 * k12, s11 * k12 + s12 * k22], [s12 * k11 + s22 * k12, s12 * k12 + s22 * k22]];
        // b² − 4c times (det S)², with (tr)² − 4 det = (p − v)² + 4 q u, which is small where both pairs are alike.
        let discriminant = gyroscopic * excess
            + (product[0][0] - product[1][1]).square()
            + (product[0][1] * product[1][0]).twice().twice();
        // 2b det S = g² + (g² + 2 tr SK)
        match (discriminant.is_positive()?, (gyroscopic + excess).is_positive()) {
            (false, _) => Some(SpinType::Complex),
            (true, Some(true)) => Some(SpinType::Elliptic),
            (true, Some(false)) => Some(SpinType::Saddle),
            (true, None) => None,
        }
    }
}

impl BoxedBody {
    /// Ω² at which weight and turning are alike.
    fn unit(&self) -> f64 {
        let largest = |list: &[Interval]| list.iter().map(|x| x.magnitude()).fold(0.0, f64::max);
        let weight = largest(&self.center);
        let moment = self.tensor.iter().map(|row| largest(row)).fold(0.0, f64::max);
        if weight > 0.0 { weight / moment } else { 1.0 }
    }

    fn middle(&self) -> NominalBody {
        let middle = |x: Interval| x.middle().lo;
        NominalBody { tensor: self.tensor.map(|row| row.map(middle)), center: self.center.map(middle) }
    }

    fn times(&self, v: &Vector) -> Vector {
        [0, 1, 2].map(|k| dot(&self.tensor[k], v))
    }

    /// The box cut into this many pieces along each entry of the diagonal.
    fn cut(&self, pieces: u32) -> Vec<Self> {
        let cut = |x: Interval| -> Vec<Interval> {
            let pieces = if x.lo == x.hi { 1 } else { pieces };
            let end = |k: u32| if k == pieces { x.hi } else { x.lo + (x.hi - x.lo) * f64::from(k) / f64::from(pieces) };
            (0..pieces).map(|k| Interval::between(end(k), end(k + 1))).collect()
        };
        let [xx, yy, zz] = [0, 1, 2].map(|k| cut(self.tensor[k][k]));
        let mut boxes = Vec::with_capacity(xx.len() * yy.len() * zz.len());
        for &x in &xx {
            for &y in &yy {
                for &z in &zz {
                    let mut piece = *self;
                    for (k, entry) in [x, y, z].into_iter().enumerate() {
                        piece.tensor[k][k] = entry;
                    }
                    boxes.push(piece);
                }
            }
        }
        boxes
    }
}

/// The inverse of the middle of a matrix, rounded.
fn inverse(matrix: [[Interval; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let [[a, b], [c, d]] = matrix.map(|row| row.map(|x| x.middle().lo));
    let determinant = a * d - b * c;
    let inverse = [[d, -b], [-c, a]].map(|row| row.map(|x| x / determinant));
    inverse.iter().flatten().all(|x| x.is_finite()).then_some(inverse)
}

fn apply(matrix: &[[f64; 2]; 2], v: [Interval; 2]) -> [Interval; 2] {
    matrix.map(|row| Interval::point(row[0]) * v[0] + Interval::point(row[1]) * v[1])
}

fn dot(v: &Vector, w: &Vector) -> Interval {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

fn cross(v: &Vector, w: &Vector) -> Vector {
    [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]]
}

/// −up and two directions across, all of about unit length.
fn basis(up: [f64; 3]) -> [[f64; 3]; 3] {
    let n = normalised(up.map(|x| -x));
    let least = if n[0].abs() <= n[1].abs().min(n[2].abs()) {
        [1.0, 0.0, 0.0]
    } else if n[1].abs() <= n[2].abs() {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let e = normalised(vector::cross(n, least));
    [n, e, vector::cross(n, e)]
}
