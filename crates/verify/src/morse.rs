//! Minima and maxima of U among the relative equilibria.

use super::equilibria::Point;
use super::fixed::Fixed;
use super::pieces::Branch;
use super::spaces::Spaces;

/// An extremum of U: γ in the body's axes, rounded.
pub(super) struct Extremum {
    pub minimum: bool,
    /// Both of a symmetric pair; one of a circle.
    pub gamma: Vec<[f64; 3]>,
}

/// What an equilibrium is for U.
pub(super) enum Nature {
    Extremum(Extremum),
    Saddle,
}

/// What an equilibrium is, or `None` when that is not certain.
pub(super) fn nature(spaces: &Spaces, branch: Branch, point: &Point) -> Option<Nature> {
    let space = match branch {
        Branch::Over(base) | Branch::Rotation(base) => Some(base),
        Branch::Generic(_) | Branch::Line(_) => None,
    };
    let circle = space.is_some_and(|base| spaces.list[base].axes.len() > 1);
    let [trace, determinant] = second_variation(spaces, point)?;
    let minimum = match (circle, determinant.sign()) {
        (false, Some(-1)) => return Some(Nature::Saddle),
        (false, Some(1)) | (true, _) => trace.strict_sign()? > 0,
        _ => return None,
    };
    // Its direction must be known as well as doubles can tell.
    if !point.gamma.iter().all(Fixed::is_narrow) {
        return None;
    }
    let gamma = match space {
        Some(_) if !circle => vec![direction(spaces, point, None), direction(spaces, point, space)],
        _ => vec![direction(spaces, point, None)],
    };
    Some(Nature::Extremum(Extremum { minimum, gamma }))
}

/// Trace and determinant of the second variation on γ⊥, which is that of (μ−A) + (4/J)Aγ(Aγ)ᵀ (Propositions 4.1, 4.2).
/// On a circle of equilibria the determinant is 0, and the trace tells alone.
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

/// γ in the body's axes, with the other sign in one space.
fn direction(spaces: &Spaces, point: &Point, flipped: Option<usize>) -> [f64; 3] {
    let mut v = [0.0; 3];
    for (k, space) in spaces.list.iter().enumerate() {
        let along = point.gamma[k].to_f64();
        let along = if flipped == Some(k) { -along } else { along };
        for (unit, &axis) in space.direction.iter().zip(&space.axes) {
            v[axis] = along * unit;
        }
    }
    v
}
