//! Verdicts along the curves: what follows from eigenvalues, energy and further integrals, and from Arnold's theorem.

use bifdiag_schema::{CurveDocument, Damped, FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, Stability};

use super::hypotheses::Stretch;
use crate::Refused;
use crate::equilibria::pieces::Branch;
use crate::order::orders::Orders;

/// The normal form decides where no eigenvalue does.
pub(super) fn needs_normal_form(orders: &Orders, curve: &CurveDocument, number: usize) -> bool {
    curve.index == Some(2) && !has_integral(orders, number)
}

/// Checks the verdicts along a curve whose Morse index and types are confirmed; false where one of them is not checked.
pub(super) fn check(
    orders: &Orders,
    curve: &CurveDocument,
    number: usize,
    elliptic: &[Stretch],
) -> Result<bool, Refused> {
    let index = curve.index.ok_or(Refused::Field { field: "curves.index" })?;
    let integral = has_integral(orders, number);
    let is_arnold = || elliptic.iter().all(|stretch| stretch.has_determinant(orders.spaces));
    let mut all = true;
    for span in &curve.stability {
        let open = NonlinearDocument::along(NonlinearVerdict::Open, Reason::Degenerate, false);
        let arnold = |proved| NonlinearDocument::along(NonlinearVerdict::Stable, Reason::Arnold, proved);
        let possible = match expected(span.stability, index, integral) {
            Some((verdict, why)) => [NonlinearDocument::along(verdict, why, true); 2],
            None if span.nonlinear != open && is_arnold() => [arnold(true); 2],
            // What is left open claims nothing. Where the determinant vanishes along all of the stretch the theorem says nothing.
            None => {
                all = false;
                [arnold(false), open]
            }
        };
        if !possible.contains(&span.nonlinear) {
            return Err(Refused::Field { field: "curves.stability.nonlinear" });
        }
        // Thomson, Tait and Chetaev: as many directions grow as the energy falls in.
        let conserving_l = Some(if index == 0 { Damped::Survives } else { Damped::Lost });
        if span.friction != (FrictionDocument { conserving_l, growing: index, rates: Vec::new() }) {
            return Err(Refused::Field { field: "curves.stability.friction" });
        }
    }
    Ok(all)
}

/// What the linear type, the Morse index and integrals say (Proposition 13.6); `None` at two imaginary pairs of opposite sign.
fn expected(kind: Stability, index: u8, integral: bool) -> Option<(NonlinearVerdict, Reason)> {
    match kind {
        _ if kind.is_unstable() => Some((NonlinearVerdict::Unstable, Reason::Spectrum)),
        Stability::Zero if !integral => Some((NonlinearVerdict::Open, Reason::Degenerate)),
        Stability::Zero => Some((NonlinearVerdict::Stable, Reason::Integral)),
        _ if index == 0 => Some((NonlinearVerdict::Stable, Reason::Energy)),
        _ => integral.then_some((NonlinearVerdict::Stable, Reason::Integral)),
    }
}

/// Motion without weight, circles and spheres of equilibria, and rotation about the axis of a body that is symmetric about r.
fn has_integral(orders: &Orders, number: usize) -> bool {
    let spaces = orders.spaces;
    let alone = |k: usize| spaces.list[k].axes.len() == 1;
    match orders.pieces.list[number].branch {
        Branch::Rotation(_) => true,
        Branch::Over(base) => !alone(base),
        Branch::Line(_) => match (spaces.list.len(), spaces.active.first()) {
            (1, _) => true,
            (2, Some(&k)) => alone(k),
            _ => false,
        },
        Branch::Generic(_) => false,
    }
}
