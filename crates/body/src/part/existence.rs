//! Whether some distribution of mass has these properties.

use std::fmt;

use bifdiag_numbers::symmetric::{PrincipalAxes, Symmetric};
use dashu_ratio::RBig;

/// Whether a part can exist, judged about its centre of mass; decided exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Existence {
    /// Each principal moment is less than the sum of the other two.
    Solid,
    /// The largest is the sum of the others: a flat body, a rod or a point.
    Flat,
    /// It cannot exist.
    Impossible(Inequality),
}

/// The triangle inequality of the principal moments about the centre of mass that fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Inequality {
    /// The principal moments, ascending.
    pub moments: [f64; 3],
    /// What is missing on the smaller side: I3 − I1 − I2.
    pub missing: f64,
}

impl Existence {
    /// Judges the tensor about the centre of mass: the second moments ∫ x xᵀ dm = (tr I / 2) E − I must be positive
    /// semidefinite.
    #[must_use]
    pub fn of(about_com: &Symmetric) -> Self {
        let second = about_com.subtracted_from(&(about_com.trace() / RBig::from(2)));
        if second.is_positive_semidefinite() {
            return if second.determinant().is_zero() { Self::Flat } else { Self::Solid };
        }
        let axes = PrincipalAxes::new(about_com, &[RBig::ZERO, RBig::ZERO, RBig::ZERO], 30);
        let mut values = axes.values;
        values.sort_by(|x, y| x.lo.cmp(&y.lo));
        let missing = &values[2].lo - &values[0].lo - &values[1].lo;
        Self::Impossible(Inequality {
            moments: values.each_ref().map(bifdiag_numbers::symmetric::Real::to_f64),
            missing: missing.to_f64().value(),
        })
    }

    /// Whether it can exist.
    #[must_use]
    pub fn is_possible(&self) -> bool {
        !matches!(self, Self::Impossible(_))
    }
}

impl fmt::Display for Inequality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.moments.map(shown);
        let missing = shown(self.missing);
        write!(f, "I1 + I2 >= I3 fails: {a:?} + {b:?} < {c:?}, {missing:?} is missing")
    }
}

/// Rounded to seven digits.
fn shown(x: f64) -> f64 {
    format!("{x:.6e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(entries: [&str; 6]) -> Existence {
        let rational = |text: &str| text.parse::<bifdiag_numbers::Number>().unwrap().value().clone();
        Existence::of(&Symmetric::new(entries.map(rational)))
    }

    #[test]
    fn flat_parts_exist_and_are_decided_exactly() {
        assert_eq!(of(["0.3", "0.1", "0.25", "0", "0", "0"]), Existence::Solid);
        assert_eq!(of(["0.3", "0.1", "0.2", "0", "0", "0"]), Existence::Flat);
        // A plate with the moments 0.1, 0.2, 0.3 turned by 3-4-5.
        assert_eq!(of(["0.164", "0.136", "0.3", "0.048", "0", "0"]), Existence::Flat);
        // A rod, a point.
        assert_eq!(of(["1", "1", "0", "0", "0", "0"]), Existence::Flat);
        assert_eq!(of(["0", "0", "0", "0", "0", "0"]), Existence::Flat);
    }

    #[test]
    fn what_cannot_be_says_by_how_much() {
        let Existence::Impossible(inequality) = of(["0.3", "0.1", "0.19", "0", "0", "0"]) else { panic!() };
        assert_eq!(inequality.moments, [0.1, 0.19, 0.3]);
        assert_eq!(inequality.to_string(), "I1 + I2 >= I3 fails: 0.1 + 0.19 < 0.3, 0.01 is missing");
        // A negative moment fails, too.
        assert!(!of(["1", "1", "-0.1", "0", "0", "0"]).is_possible());
    }
}
