//! Boxes of parts for which an axis is always permanent: C, A, B and the weight, and with them the closed form of
//! [`spin_ranges`](super::spin_ranges).

use bifdiag_body::part::{INPUTS, Measured, MeasuredPart, Units};
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use dashu_ratio::RBig;

use super::rotation::AxisRotation;

/// Moments and weight of the parts of a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisBox {
    /// C, A, B.
    pub moments: [Interval; 3],
    /// C − A, C − B and A − B, which are 0 exactly where the moments of every part are equal.
    pub differences: [Interval; 3],
    /// −ρ, zero or of one sign.
    pub weight: Interval,
}

/// The pairs of moments whose differences count.
const PAIRS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];

impl AxisBox {
    /// Of parts whose moments vary each for itself between two exact ends.
    pub fn new(ends: &[[RBig; 2]; 3], weight: Interval) -> Self {
        let between = |from: &RBig, to: &RBig| exactly(from).hull(&exactly(to));
        Self {
            moments: ends.each_ref().map(|[from, to]| between(from, to)),
            differences: PAIRS.map(|[i, j]| between(&(&ends[i][0] - &ends[j][1]), &(&ends[i][1] - &ends[j][0]))),
            weight,
        }
    }
}

/// Where the products of inertia begin.
const PRODUCTS: usize = 3;
const COM: usize = 6;
const MASS: usize = 9;
const GRAVITY: usize = 10;

/// Into how many pieces numbers that enter tensor and weight are cut, so that both change together.
const PIECES: u8 = 8;

/// What is known of an axis over all parts of a box.
pub(super) enum Permanence {
    /// It is permanent for each of them, which these smaller boxes hold.
    Boxed(Vec<AxisBox>),
    /// It is permanent for each of them, but the centre of mass may lie on either side of the fixed point.
    EitherSide,
    /// It may not be permanent for one of them.
    Unknown,
}

/// Of the axis of a rotation, which points up along `up` in the part's frame.
pub(super) fn permanence(measured: &MeasuredPart, units: &Units, rotation: &AxisRotation, up: [f64; 3]) -> Permanence {
    let moves_tensor = |k: usize| k < COM || (k <= MASS && measured.about_com);
    let exact =
        |weight| AxisBox::new(&rotation.moments.each_ref().map(|moment| [moment.clone(), moment.clone()]), weight);
    let boxes = if measured.uncertain().any(|k| k < MASS || moves_tensor(k)) {
        let Some(found) = along_coordinates(measured, units, up) else { return Permanence::Unknown };
        // Principal moments of a diagonal tensor are its entries; of another one they are rounded.
        let is_diagonal = measured.inputs[PRODUCTS..COM].iter().all(|product| product.value.is_zero());
        let is_exact = is_diagonal && !measured.uncertain().any(moves_tensor);
        if is_exact { found.into_iter().map(|found| exact(found.weight)).collect() } else { found }
    } else {
        // r = m g c: mass and gravity scale the weight, and nothing else.
        let share = |k: usize| measured.inputs[k].enclosed() / exactly(&measured.inputs[k].value);
        vec![exact(exactly(&-&rotation.weight) * share(MASS) * share(GRAVITY))]
    };
    let has_sign = |found: &AxisBox| found.weight.is_positive().is_some() || found.weight == Interval::ZERO;
    if boxes.iter().all(has_sign) { Permanence::Boxed(boxes) } else { Permanence::EitherSide }
}

fn exactly(value: &RBig) -> Interval {
    Interval::rational(value, ())
}

/// The axis is one of coordinates, and centre of mass and products leave it principal for every part.
fn along_coordinates(measured: &MeasuredPart, units: &Units, up: [f64; 3]) -> Option<Vec<AxisBox>> {
    let axis = (0..3).find(|&k| up[k].abs() > 1.0 - 1e-9)?;
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let is_zero = |k: usize| measured.inputs[k].value.is_zero() && measured.inputs[k].within.is_zero();
    // Ixy, Ixz, Iyz are the inputs 3, 4 and 5.
    let product = |other: usize| 2 + axis + other;
    if !others.iter().all(|&k| is_zero(COM + k) && is_zero(product(k))) {
        return None;
    }
    let cut = |part: MeasuredPart, k: usize| -> Vec<MeasuredPart> {
        let within = &measured.inputs[k].within;
        if within.is_zero() || !measured.about_com {
            return vec![part];
        }
        let piece = |number: u8| {
            let [step, share] = [2 * i64::from(number) + 1 - i64::from(PIECES), 1]
                .map(|numerator| RBig::from_parts(numerator.into(), PIECES.into()));
            let value = &measured.inputs[k].value + within * step;
            let mut piece = part.clone();
            piece.inputs[k] = Measured { value, within: within * share };
            piece
        };
        (0..PIECES).map(piece).collect()
    };
    let pieces = cut(measured.clone(), MASS).into_iter().flat_map(|part| cut(part, COM + axis));
    let one = |part: MeasuredPart| {
        let (tensor, center) = part.bounds(units);
        let [i, j] = others;
        let [a, b, d] = [tensor[i][i], tensor[j][j], tensor[i][j]];
        let c = tensor[axis][axis];
        // m z² adds the same to both moments across the axis, and nothing to that about it.
        let [mass, z] = [&part.inputs[MASS], &part.inputs[COM + axis]];
        let added = if part.about_com { &mass.value * &z.value * &z.value } else { RBig::ZERO };
        let is_added_exactly = !part.about_com || (mass.within.is_zero() && z.within.is_zero());
        let apart = |i: usize, j: usize| {
            let [first, second] = [i, j].map(|k| &part.inputs[k]);
            let is_exact = first.within.is_zero() && second.within.is_zero() && (is_added_exactly || i != axis);
            let own = &first.value - &second.value;
            match (is_exact, i == axis) {
                (true, true) => exactly(&(own - &added)),
                (true, false) => exactly(&own),
                (false, true) => c - tensor[j][j],
                (false, false) => first.enclosed() - second.enclosed(),
            }
        };
        let (first, second, differences) = if d == Interval::ZERO {
            let differences = [apart(axis, i), apart(axis, j), apart(i, j)];
            (a, b, differences)
        } else {
            // The eigenvalues of the block across the axis.
            let half = Interval::point(0.5);
            let (middle, apart) = (half * (a + b), ((half * apart(i, j)).square() + d.square()).sqrt());
            let [first, second] = [middle - apart, middle + apart];
            (first, second, [c - first, c - second, -apart.twice()])
        };
        let weight = if up[axis] < 0.0 { -center[axis] } else { center[axis] };
        AxisBox { moments: [c, first, second], differences, weight }
    };
    Some(pieces.map(one).collect())
}

const _: () = assert!(GRAVITY + 1 == INPUTS);
