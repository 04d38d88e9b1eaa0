//! Names of branches and curves, in the axes in which the body was given.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use super::{Branch, CriticalSet, CurveId, IntervalId, Orbit, Pole};
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::table::Id;

/// Name of a branch of relative equilibria, or of a pole line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BranchName {
    /// `G0` … `G3`: the generic family, by rising μ.
    Generic(IntervalId),
    /// `L-`, `L+`: rotation about the axis that carries r, with γ = −r̂ or γ = r̂.
    Axis(Pole),
    /// `S2`: the pair over A2; `S12`: a circle in the plane of the axes 1 and 2 of the body.
    Over([bool; 3]),
    /// `P+`, `P-`: a pole line.
    Pole(Pole),
}

/// Name of a curve of critical values, or of a pole line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CurveName {
    /// `G0.1`: a piece of a branch, numbered from 1.
    Piece {
        /// The branch.
        branch: BranchName,
        /// Its number on the branch.
        piece: usize,
    },
    /// `P+`, `P-`: a pole line.
    Pole(Pole),
    /// `l=0`: the line of energies of a body without weight at rest.
    Rest,
}

/// A text that names no curve.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` does not name a curve; names are such as G0.1, L+.1, S2.1, P+")]
pub struct ParseCurveNameError(String);

impl BranchName {
    /// The name of a branch of a body with this frame.
    #[must_use]
    pub fn of(frame: &Frame, branch: Branch) -> Self {
        match branch {
            Branch::Generic(interval) => Self::Generic(interval),
            Branch::Axis(pole) => Self::Axis(pole),
            Branch::Symmetric(axis) => {
                let columns = (0..3).filter(|&k| frame.group[k] == frame.group[axis]);
                let mut axes = [false; 3];
                for k in columns {
                    for (i, row) in frame.to_body.iter().enumerate() {
                        axes[i] |= row[k] != 0.0;
                    }
                }
                Self::Over(axes)
            }
            Branch::Pole(pole) => Self::Pole(pole),
        }
    }
}

/// A branch in words, with the axes of the body: "from +r̂", "pair over axis 2". One name for each branch, everywhere.
#[must_use]
pub fn branch_words(set: &CriticalSet, branch: Branch) -> String {
    let frame = &set.frame;
    let active = frame.active();
    let axes = |k: Axis| {
        let members: Vec<String> = match BranchName::of(frame, Branch::Symmetric(k)) {
            BranchName::Over(axes) => (1..=3).filter(|i| axes[i - 1]).map(|i| i.to_string()).collect(),
            _ => Vec::new(),
        };
        format!("{} {}", if members.len() > 1 { "axes" } else { "axis" }, members.join(" and "))
    };
    match branch {
        Branch::Axis(Pole::Minus) => "from −r̂".to_owned(),
        Branch::Axis(Pole::Plus) => "from +r̂".to_owned(),
        Branch::Generic(interval) => match interval.index() {
            0 => "from −r̂".to_owned(),
            n if n < active.len() => format!("between {} and {}", axes(active[n - 1]), axes(active[n])),
            _ => "from +r̂".to_owned(),
        },
        Branch::Symmetric(k) => match set.curves.iter().find(|curve| curve.branch == branch).map(|curve| curve.orbit) {
            Some(Orbit::Circle(_)) => format!("circle over {}", axes(k)),
            Some(Orbit::Sphere) => "all directions".to_owned(),
            _ => format!("pair over {}", axes(k)),
        },
        Branch::Pole(Pole::Plus) => "pole line of +r̂".to_owned(),
        Branch::Pole(Pole::Minus) => "pole line of −r̂".to_owned(),
    }
}

impl CurveName {
    /// The name of a curve of a body.
    #[must_use]
    pub fn of(set: &CriticalSet, curve: CurveId) -> Self {
        let curve = &set.curves[curve];
        Self::on(BranchName::of(&set.frame, curve.branch), curve.piece)
    }

    /// The name of a piece of a branch.
    #[must_use]
    pub fn on(branch: BranchName, piece: usize) -> Self {
        if let BranchName::Pole(pole) = branch { Self::Pole(pole) } else { Self::Piece { branch, piece } }
    }
}

impl fmt::Display for Pole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Plus { "+" } else { "-" })
    }
}

impl fmt::Display for BranchName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Generic(interval) => write!(f, "G{}", interval.index()),
            Self::Axis(pole) => write!(f, "L{pole}"),
            Self::Over(axes) => {
                f.write_str("S")?;
                (0..3).filter(|&i| axes[i]).try_for_each(|i| write!(f, "{}", i + 1))
            }
            Self::Pole(pole) => write!(f, "P{pole}"),
        }
    }
}

impl fmt::Display for CurveName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Piece { branch, piece } => write!(f, "{branch}.{piece}"),
            Self::Pole(pole) => write!(f, "P{pole}"),
            Self::Rest => f.write_str("l=0"),
        }
    }
}

impl FromStr for BranchName {
    type Err = ParseCurveNameError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || ParseCurveNameError(text.to_owned());
        let pole = |sign: &str| match sign {
            "+" => Ok(Pole::Plus),
            "-" => Ok(Pole::Minus),
            _ => Err(wrong()),
        };
        match text.split_at_checked(1).ok_or_else(wrong)? {
            ("G", interval) => {
                interval.parse().map(|number| Self::Generic(IntervalId::at(number))).map_err(|_not_a_count| wrong())
            }
            ("L", sign) => pole(sign).map(Self::Axis),
            ("P", sign) => pole(sign).map(Self::Pole),
            ("S", digits) => {
                let axes = ['1', '2', '3'].map(|axis| digits.contains(axis));
                let name = Self::Over(axes);
                if name.to_string() == text && !digits.is_empty() { Ok(name) } else { Err(wrong()) }
            }
            _ => Err(wrong()),
        }
    }
}

impl FromStr for CurveName {
    type Err = ParseCurveNameError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || ParseCurveNameError(text.to_owned());
        if text == "l=0" {
            return Ok(Self::Rest);
        }
        match text.split_once('.') {
            Some((branch, piece)) => match branch.parse()? {
                BranchName::Pole(_) => Err(wrong()),
                branch => Ok(Self::Piece { branch, piece: piece.parse().map_err(|_not_a_count| wrong())? }),
            },
            None => match text.parse()? {
                BranchName::Pole(pole) => Ok(Self::Pole(pole)),
                _ => Err(wrong()),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for text in ["G0.1", "G3.12", "L-.1", "L+.2", "S2.1", "S12.1", "S123.1", "P+", "P-", "l=0"] {
            assert_eq!(text.parse::<CurveName>().unwrap().to_string(), text);
        }
        for text in ["", "G", "G0", "P+.1", "S.1", "S21.1", "L.1", "X1.1", "G0.", "S4.1"] {
            assert!(matches!(text.parse::<CurveName>(), Err(ParseCurveNameError(_))), "{text}");
        }
    }
}
