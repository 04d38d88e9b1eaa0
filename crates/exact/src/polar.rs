//! Where pole lines meet critical curves: every root of an exactly isolated polynomial.

use std::cmp::Ordering;
use std::sync::Arc;

use dashu_ratio::RBig;

use super::curves::{Curves, IsolationError, Place, Shape, order, roots_in_interval};
use super::family::Half;
use super::id::MeetingId;
use super::model::Model;
use bifdiag_equilibria::curves::{Branch, CurveId, End, IntervalId, Pole};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure, horner};
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::table::{Id, Table};
use bifdiag_numbers::wide::Interval384;

/// A meeting of a pole line with a critical curve off the line.
#[derive(Clone, Debug)]
pub(super) struct Meeting {
    pub pole: Pole,
    pub place: Place,
    /// The curve; both curves of a cusp or pitchfork if it is one of these points.
    pub curves: Vec<CurveId>,
    /// The end at which the meeting lies exactly, if it does.
    pub end: Option<End>,
    /// The curves touch and do not cross.
    pub touch: bool,
}

/// All meetings. `IsolationError` when a root cannot be separated from a cusp or pitchfork, nor proved equal to it.
pub(super) fn meetings(
    model: &Model,
    curves: &Curves,
    bits: usize,
) -> Result<Table<MeetingId, Meeting>, IsolationError> {
    let mut found = Table::new();
    if model.active.len() > 1 {
        let [side, polynomial] = model.pole_polynomials();
        for number in 0..=model.active.len() {
            for (place, odd) in roots_in_interval(model, &polynomial, number, bits)? {
                let pole = side_of(&side, model, &place)?;
                found.push(on_branch(model, curves, Branch::Generic(IntervalId::at(number)), place, pole, !odd)?);
            }
        }
    }
    for &group in &model.passive {
        if model.active.is_empty() {
            break;
        }
        let (_, p_sum) = model.sums_over(group);
        let [side, polynomial] = model.pole_polynomials_over(group).map(|p| p.composed(&p_sum, &RBig::ONE));
        let roots = polynomial.positive_roots().ok_or(IsolationError)?;
        for mut root in roots {
            root.refine(bits);
            let odd = root.odd;
            let half = Half::Over { group };
            let place = Place { half, lo: root.lo.clone(), hi: root.hi.clone(), root: Some(Arc::new(root)) };
            // E = 2 r s³ on P+ and −2 r s³ on P−, where N has the other sign (Proposition 5.3, Proposition 5.4).
            let pole = match sign_on(&side, &place.lo, &place.hi)? {
                Pole::Plus => Pole::Minus,
                Pole::Minus => Pole::Plus,
            };
            found.push(on_branch(model, curves, Branch::Symmetric(model.axis[group]), place, pole, !odd)?);
        }
    }
    Ok(found)
}

/// P+ where N < 0, P− where N > 0.
fn side_of(side: &Polynomial, model: &Model, place: &Place) -> Result<Pole, IsolationError> {
    let [lo, hi] = place.mu(model);
    sign_on(side, &lo, &hi)
}

/// The pole line from the sign of N (or E) at the root. N has no root in common with F unless P D vanishes there, which
/// it does not on the open intervals.
fn sign_on(side: &Polynomial, lo: &RBig, hi: &RBig) -> Result<Pole, IsolationError> {
    let range = Interval384::rational(lo, ()).hull(&Interval384::rational(hi, ()));
    match horner(&side.enclosed(()), &range, ()).strict_sign() {
        Some(Sign::Positive) => return Ok(Pole::Minus),
        Some(_) => return Ok(Pole::Plus),
        None => {}
    }
    let signs = [side.sign_at(lo), side.sign_at(hi)];
    let none_between = lo == hi || side.composed(lo, &(hi - lo)).roots_in_unit().is_some_and(|roots| roots.is_empty());
    match signs {
        [Sign::Positive, Sign::Positive] if none_between => Ok(Pole::Minus),
        [Sign::Negative, Sign::Negative] if none_between => Ok(Pole::Plus),
        _ => Err(IsolationError),
    }
}

/// The piece of a branch on which a place lies.
fn on_branch(
    model: &Model,
    curves: &Curves,
    branch: Branch,
    place: Place,
    pole: Pole,
    touch: bool,
) -> Result<Meeting, IsolationError> {
    let mut pieces: Vec<CurveId> = curves.list.ids().filter(|&c| curves.list[c].branch == branch).collect();
    pieces.sort_by_key(|&c| curves.list[c].piece);
    let mut at = 0;
    for window in pieces.windows(2) {
        let (end, station) = station_between(curves, window[0], window[1]).ok_or(IsolationError)?;
        match order(model, &station, &place) {
            Some(Ordering::Less) => at += 1,
            Some(_) => break,
            None => {
                return if same_point(&place, &station) {
                    Ok(Meeting { pole, place, curves: window.to_vec(), end: Some(end), touch })
                } else {
                    Err(IsolationError)
                };
            }
        }
    }
    Ok(Meeting { pole, curves: vec![pieces[at]], place, end: None, touch })
}

/// The cusp or pitchfork between two successive pieces of a branch.
fn station_between(curves: &Curves, p: CurveId, q: CurveId) -> Option<(End, Place)> {
    let common = curves.list[p]
        .ends
        .into_iter()
        .find(|end| matches!(end, End::Cusp(_) | End::Pitchfork(_)) && curves.list[q].ends.contains(end))?;
    let place = match common {
        End::Cusp(number) => curves.cusps[number].place.clone(),
        End::Pitchfork(number) => curves.pitchforks[number].place.clone()?,
        _ => return None,
    };
    Some((common, place))
}

/// The root at `place` is the point `station`: by gcd, or by the value at a rational.
fn same_point(place: &Place, station: &Place) -> bool {
    let Some(root) = &place.root else { return false };
    if place.half != station.half {
        return false;
    }
    // The root's own coordinate is y over a scale.
    let scale = if root.hi.is_zero() { RBig::ONE } else { &place.hi / &root.hi };
    match &station.root {
        Some(other) => root.is_root_of(other.polynomial()),
        None => root.polynomial().sign_at(&(&station.lo / scale)) == Sign::Zero,
    }
}

/// r on an axis: whether the meeting of a pair with the line γ = ±r̂ lies exactly at x of a pitchfork of that line. With
/// v = s² on the pair, 4x² v³ = (a v − R̂)⁴; and 4x² = α⁴ r²/d² at the pitchfork of a group at distance d from the axis.
pub(super) fn meets_pitchfork(model: &Model, place: &Place, pitchfork_group: usize) -> bool {
    use bifdiag_numbers::polynomial::rational;
    let (Half::Over { group }, Some(root)) = (place.half, &place.root) else { return false };
    let (r_sum, p_sum) = model.sums_over(group);
    let j = [-r_sum, model.a(group).clone()];
    let square = rational::mul(&j, &j);
    let axis = model.active[0];
    let alpha2 = model.a(axis) * model.a(axis);
    let d = model.difference(pitchfork_group, axis);
    let x2 = &alpha2 * &alpha2 * &model.r2 / (&d * &d);
    let cube = [RBig::ZERO, RBig::ZERO, RBig::ZERO, x2];
    let difference = Polynomial::from_rationals(&rational::sub(&rational::mul(&square, &square), &cube));
    root.is_root_of(&difference.composed(&p_sum, &RBig::ONE))
}

/// The piece of the line γ = ±r̂ (r on an axis), by the number of its pitchforks below.
pub(super) fn line_pieces(curves: &Curves, pole: Pole) -> Vec<CurveId> {
    let mut pieces: Vec<CurveId> = curves
        .list
        .ids()
        .filter(|&c| curves.list[c].pole == Some(pole) && matches!(curves.list[c].shape, Shape::Pole(_)))
        .collect();
    pieces.sort_by_key(|&c| curves.list[c].piece);
    pieces
}
