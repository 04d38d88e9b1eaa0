//! What an equilibrium is for U.

use crate::equilibria::places::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;

/// A nondegenerate critical point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Nature {
    Minimum,
    Saddle,
    Maximum,
}

/// What an isolated equilibrium is (Proposition 4.2), or `None` when that is not certain.
pub(crate) fn nature(spaces: &Spaces, point: &Point) -> Option<Nature> {
    let [trace, determinant] = second_variation(spaces, point)?;
    match (determinant.strict_sign()?, trace.strict_sign()) {
        (-1, _) => Some(Nature::Saddle),
        (_, Some(1)) => Some(Nature::Minimum),
        (_, Some(_)) => Some(Nature::Maximum),
        _ => None,
    }
}

/// The Morse index of an equilibrium of a circle over a space with two axes in its normal direction, of one of a sphere, 0, and
/// of an isolated one; `None` when that is not certain.
pub(crate) fn index(spaces: &Spaces, point: &Point, axes: usize) -> Option<u8> {
    match axes {
        1 => Some(match nature(spaces, point)? {
            Nature::Minimum => 0,
            Nature::Saddle => 1,
            Nature::Maximum => 2,
        }),
        // The second variation vanishes along the circle.
        2 => Some(u8::from(second_variation(spaces, point)?[0].strict_sign()? < 0)),
        _ => Some(0),
    }
}

/// Trace and determinant of the second variation on γ⊥, which is that of (μ−A) + (4/J)Aγ(Aγ)ᵀ (Propositions 4.1, 4.2).
fn second_variation(spaces: &Spaces, point: &Point) -> Option<[Fixed; 2]> {
    let tau_of = point.tau.as_ref()?;
    let (mut a, mut tau, mut gamma) = (Vec::new(), Vec::new(), Vec::new());
    for (k, space) in spaces.list.iter().enumerate() {
        for n in 0..space.axes.len() {
            a.push(&space.a_set);
            tau.push(&tau_of[k]);
            // Along the first direction of each space, which is that of r where there is r.
            gamma.push(if n == 0 { point.gamma[k].clone() } else { Fixed::whole(0) });
        }
    }
    let w: Vec<Fixed> = gamma.iter().map(Fixed::square).collect();
    let one = Fixed::whole(1);
    let stiffness = Fixed::whole(4).over(&point.j)?;
    let (mut trace, mut determinant) = (Fixed::whole(0), Fixed::whole(0));
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let twist = (&(&gamma[i] * &gamma[j]) * &(a[j] - a[i])).square();
        trace = &(&trace + &(&(&one - &w[k]) * tau[k])) + &(&stiffness * &twist);
        determinant = &(&determinant + &(&w[k] * &(tau[i] * tau[j]))) + &(&stiffness * &(tau[k] * &twist));
    }
    Some([trace, determinant])
}
