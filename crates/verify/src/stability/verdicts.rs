//! Verdicts along the curves. What follows from eigenvalues, energy and further integrals is confirmed; what rests on Arnold's
//! theorem is not, and a document has to say so.

use bifdiag_schema::{CurveDocument, Damped, FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, Stability};

use crate::Refused;
use crate::equilibria::pieces::Branch;
use crate::order::stand::Orders;

/// Checks the verdicts along a curve whose Morse index and types are confirmed; true where one of them is not checked.
pub(crate) fn check(orders: &Orders, curve: &CurveDocument, number: usize) -> Result<bool, Refused> {
    let index = curve.index.ok_or(Refused::Field { field: "curves.index" })?;
    let integral = has_integral(orders, number);
    let mut unchecked = false;
    for span in &curve.stability {
        let expected = expected(span.stability, index, integral);
        let told = match expected {
            Some((verdict, why)) => vec![NonlinearDocument::along(verdict, why, true)],
            // Where the determinant vanishes along all of the stretch the theorem says nothing.
            None => vec![
                NonlinearDocument::along(NonlinearVerdict::Stable, Reason::Arnold, false),
                NonlinearDocument::along(NonlinearVerdict::Open, Reason::Degenerate, false),
            ],
        };
        unchecked |= expected.is_none();
        if !told.contains(&span.nonlinear) {
            return Err(Refused::Field { field: "curves.stability.nonlinear" });
        }
        // Thomson, Tait and Chetaev: as many directions grow as the energy falls in.
        let conserving_l = Some(if index == 0 { Damped::Survives } else { Damped::Lost });
        if span.friction != (FrictionDocument { conserving_l, growing: index, rates: Vec::new() }) {
            return Err(Refused::Field { field: "curves.stability.friction" });
        }
    }
    Ok(unchecked)
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
