//! Steady rotations near an axis when tensor and centre of mass are known as intervals: their type over the spin.
//!
//! In a part whose products of inertia or centre of mass are uncertain no axis is permanent at every spin, but at every spin
//! there is a steady rotation near one. Pieces of the spin are halved until on each one square of directions holds exactly one
//! steady rotation of every part, of one type. Squares at neighbouring spins have one middle, so that they hold the same
//! rotation.

use bifdiag_body::Body;
use bifdiag_body::part::{INPUTS, MeasuredPart, Part};
use bifdiag_numbers::Number;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::sequence;
use bifdiag_schema::SpinType;
use dashu_ratio::RBig;

use super::certain::{self, Permanence};
use super::path::{NominalBody, NominalRotation, Path};
use super::rotation::AxisRotation;
use super::square::{BoxedBody, basis, kind_of_all};
use super::tolerance::{SpinRange, ranges_over};

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
    /// The nominal part's steady rotation.
    Rotation(NominalRotation),
}

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
        Near::Axis(rotation) => match certain::permanence(measured, &part.units, rotation, up) {
            Permanence::Boxed(boxes) => SettledTypes { ranges: ranges_over(rotation, &boxes), tilt: None },
            Permanence::EitherSide => SettledTypes { tilt: None, ..settled_types(&boxed(measured), up) },
            Permanence::Unknown => settled_types(&boxed(measured), up),
        },
        Near::Rotation(rotation) => settled_types_beside(&boxed(measured), nominal, up, &rotation),
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
        let least = if to.is_finite() { ROUNDING * to } else { 0.0 };
        let moved = alone.iter().map(|(input, found)| (*input, unsettled(found))).filter(|(_, moved)| *moved > least);
        // Of equals the first.
        let most = moved.max_by(|p, q| p.1.total_cmp(&q.1).then(q.0.cmp(&p.0)));
        range.most = most.map(|(input, moved)| (measured.named(input).0, moved));
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
/// with the principal axes of the nominal one: beside one of its steady rotations.
#[must_use]
pub fn settled_types_of_shares(body: &Body, share: &RBig, up: [f64; 3], rotation: &NominalRotation) -> SettledTypes {
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
    settled_types_beside(&boxed, NominalBody { tensor, center }, up, rotation)
}

/// Bodies within a share of a nominal one; `None` for one that is no body.
pub fn sampled_shares<'a>(body: &'a Body, share: &'a RBig) -> impl Iterator<Item = Option<Body>> + 'a {
    let samples = if share.is_zero() { 1 } else { MEASURED_SAMPLES };
    (0..samples).map(move |number| {
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

/// The types of the steady rotations near a nominal one, with the end of its axis up that is nearer to `up`.
fn settled_types_beside(
    body: &BoxedBody,
    nominal: NominalBody,
    up: [f64; 3],
    rotation: &NominalRotation,
) -> SettledTypes {
    let Some(path) = Path::new(nominal, body.unit(), up, rotation) else {
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
