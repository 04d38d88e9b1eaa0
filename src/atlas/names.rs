//! Names of branches and curves, in the axes in which the body was given.

use crate::body::Frame;
use crate::equilibria::{Branch, CriticalSet, Pole};

/// Name of a branch: `G0` … `G3` for the generic family by rising μ, `L-`, `L+` for rotation about the axis that
/// carries r, `S2` for the pair over A2 (`S12` for a circle in the plane of the axes 1 and 2), `P+`, `P-` for pole lines.
#[must_use]
pub fn branch_name(frame: &Frame, branch: Branch) -> String {
    match branch {
        Branch::Generic(interval) => format!("G{interval}"),
        Branch::Axis(0) => "L-".to_owned(),
        Branch::Axis(_) => "L+".to_owned(),
        Branch::Symmetric(axis) => {
            let columns: Vec<usize> = (0..3).filter(|&k| frame.group[k] == frame.group[axis]).collect();
            let axes = (0..3).filter(|&i| columns.iter().any(|&k| frame.to_body[i][k] != 0.0));
            format!("S{}", axes.map(|i| (i + 1).to_string()).collect::<String>())
        }
        Branch::Pole(Pole::Plus) => "P+".to_owned(),
        Branch::Pole(Pole::Minus) => "P-".to_owned(),
    }
}

/// Name of a curve: its branch and, but for pole lines, the number of the piece.
#[must_use]
pub fn curve_name(set: &CriticalSet, curve: usize) -> String {
    let curve = &set.curves[curve];
    let branch = branch_name(&set.frame, curve.branch);
    if matches!(curve.branch, Branch::Pole(_)) { branch } else { format!("{branch}.{}", curve.piece) }
}
