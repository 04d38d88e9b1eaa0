//! The real part whose principal form is the body: everything that the document says about it follows from its tensor,
//! its centre of mass, its mass and gravity.

use bifdiag_schema::{AtlasDocument, Flags, PartDocument, PrincipalDocument};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::integrable;
use super::tensor::{Matrix, Vector, cross, dot, read};
use crate::Refused;
use crate::equilibria::spaces::Body;
use crate::numbers::number;

/// Correct digits of the rounded numbers of a principal form: ten fewer than are written.
const DIGITS: usize = 120;
/// The same for numbers in doubles.
const ROUNDED: f64 = 1e-12;

/// m in the units of length and s in the units of time that a document may name, and the units of mass.
const LENGTHS: [(&str, i64, i64); 7] = [
    ("m", 1, 1),
    ("cm", 1, 100),
    ("mm", 1, 1000),
    ("um", 1, 1_000_000),
    ("km", 1000, 1),
    ("in", 254, 10_000),
    ("ft", 3048, 10_000),
];
const TIMES: [(&str, i64, i64); 3] = [("s", 1, 1), ("ms", 1, 1000), ("min", 60, 1)];
const MASSES: [&str; 7] = ["kg", "g", "mg", "t", "lb", "oz", "slug"];

/// Checks the part of a document, if it has one; the flags of its body, which are those of its tensor.
pub(crate) fn check(document: &AtlasDocument, body: &Body, flags: Flags) -> Result<Flags, Refused> {
    let refuse = |field| Err(Refused::Field { field });
    let is_integrable =
        |tensor: &Matrix, weight: &Vector| document.body.integrable == integrable::cases(tensor, weight, body);
    let Some(part) = &document.body.part else {
        let tensor = Matrix::of(|i, j| if i == j { body.moments[i].clone() } else { RBig::ZERO });
        return if is_integrable(&tensor, &body.center) { Ok(flags) } else { refuse("body.integrable") };
    };
    let tensor = Matrix::read(&part.inertia)?;
    let center = read(&part.com)?;
    let (mass, g) = (number::given(&part.mass)?, number::given(&part.g)?);
    let Some(weight) = acceleration(part, &g).map(|g| center.each_ref().map(|c| c * &mass * &g)) else {
        return refuse("body.part.units");
    };
    if !tensor.is_symmetric() || mass <= RBig::ZERO {
        return refuse("body.part.inertia or body.part.mass");
    }
    if part.moments != document.body.given.moments || part.center != document.body.given.center {
        return refuse("body.part: A or r");
    }
    if !is_principal_form(&tensor, &weight, body, part.exact) {
        return refuse("body.part: inertia, com, mass, g, units or exact");
    }
    // |c|² − c cᵀ.
    let about_com = tensor.minus(&Matrix::turning(&center), &mass);
    if part.physical != about_com.second_moments().is_positive_semidefinite() {
        return refuse("body.part.physical");
    }
    let moments = body.moments.each_ref().map(float);
    if !are_axes(&part.principal, &tensor, Some((&weight, body))) || !near(part.principal.moments, moments) {
        return refuse("body.part.principal");
    }
    if !are_axes(&part.principal_com, &about_com, None) {
        return refuse("body.part.principal_com");
    }
    if !is_integrable(&tensor, &weight) {
        return refuse("body.integrable");
    }
    let second = tensor.second_moments();
    let [_, _, determinant] = second.invariants();
    // Flat: no weight along the kernel, which two of the rows span the complement of.
    let [x, y, z] = &second.0;
    let in_range = [cross(x, y), cross(y, z), cross(z, x)].iter().all(|v| dot(v, &weight).is_zero());
    let unphysical = determinant < RBig::ZERO || (determinant.is_zero() && !in_range);
    Ok(Flags { unphysical, plate: determinant.is_zero() && in_range, ..flags })
}

/// g in the units of a part, if they are known.
fn acceleration(part: &PartDocument, g: &RBig) -> Option<RBig> {
    let names: Vec<&str> = part.units.split(',').collect();
    let [mass, length, time] = names[..] else {
        return None;
    };
    let factor = |table: &[(&str, i64, i64)], name: &str| {
        let (_, p, q) = table.iter().find(|(known, ..)| *known == name)?;
        Some(RBig::from(*p) / RBig::from(*q))
    };
    let (length, time) = (factor(&LENGTHS, length)?, factor(&TIMES, time)?);
    MASSES.contains(&mass).then(|| g * &time * &time / length)
}

/// D(μ) = det(μ − A) and N(μ) = rᵀ adj(μ − A) r of the tensor are those of the body, exactly or rounded; so are the number of
/// different moments and the number of those that carry r. All terms of the sums are positive: rounded numbers make them as
/// good as they are.
fn is_principal_form(tensor: &Matrix, weight: &Vector, body: &Body, is_exact: bool) -> bool {
    let [a, b, c] = &body.moments;
    let squares = body.center.each_ref().map(|r| r * r);
    let others: [Vector; 3] = [[RBig::ONE, b + c, b * c], [RBig::ONE, a + c, a * c], [RBig::ONE, a + b, a * b]];
    let of_body = |k: usize| (0..3).fold(RBig::ZERO, |sum, i| sum + &squares[i] * &others[i][k]);
    let [trace, second, determinant] = tensor.invariants();
    let turned = tensor.times(weight);
    let square = dot(weight, weight);
    let along = dot(weight, &turned);
    // adj T = T² − (tr T) T + e₂.
    let adjugate = dot(&turned, &turned) - &trace * &along + &second * &square;
    let pairs = [
        (trace.clone(), a + b + c),
        (second, a * b + a * c + b * c),
        (determinant, a * b * c),
        (square.clone(), of_body(0)),
        (&trace * &square - along, of_body(1)),
        (adjugate, of_body(2)),
    ];
    let small = RBig::from_parts(IBig::ONE, UBig::from(10u8).pow(DIGITS));
    let same = |(p, q): &(RBig, RBig)| {
        let off = p - q;
        off.clone().max(-off) <= q * &small
    };
    let mut carrying: Vec<&RBig> = Vec::new();
    let mut moments: Vec<&RBig> = Vec::new();
    for (a, r) in body.moments.iter().zip(&body.center) {
        if !moments.contains(&a) {
            moments.push(a);
        }
        if !r.is_zero() && !carrying.contains(&a) {
            carrying.push(a);
        }
    }
    let are_equal = pairs.iter().all(|(p, q)| p == q);
    are_equal == is_exact
        && pairs.iter().all(same)
        && moments.len() == tensor.different_moments()
        && carrying.len() == tensor.rank_of_orbit(weight)
}

/// Axes about a point: a rotation that makes the tensor diagonal and turns r into that of the body.
fn are_axes(claim: &PrincipalDocument, tensor: &Matrix, center: Option<(&Vector, &Body)>) -> bool {
    let axes = claim.axes;
    let product = |p: &[f64; 3], q: &[f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let rows = tensor.0.each_ref().map(|row| row.each_ref().map(float));
    let turned = |v: &[f64; 3]| rows.map(|row| product(&row, v));
    let size = (0..3).map(|k| rows[k][k].abs()).fold(0.0, f64::max);
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    let all = |good: &dyn Fn(usize, usize) -> bool| (0..3).all(|i| (0..3).all(|j| good(i, j)));
    let [x, y, z] = axes;
    let across = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    all(&|i, j| (product(&axes[i], &axes[j]) - unit(i, j)).abs() <= ROUNDED)
        && product(&across, &z) > 0.0
        && all(&|i, j| (product(&axes[i], &turned(&axes[j])) - unit(i, j) * claim.moments[i]).abs() <= ROUNDED * size)
        && center.is_none_or(|(weight, body)| {
            let weight = weight.each_ref().map(float);
            near(axes.map(|axis| product(&axis, &weight)), body.center.each_ref().map(float))
        })
}

/// Two vectors in doubles, within rounding of their largest component.
fn near(p: [f64; 3], q: [f64; 3]) -> bool {
    let size = q.iter().map(|x| x.abs()).fold(0.0, f64::max);
    (0..3).all(|k| (p[k] - q[k]).abs() <= ROUNDED * size)
}

fn float(x: &RBig) -> f64 {
    x.to_f64().value()
}
