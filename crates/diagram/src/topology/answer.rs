//! What is said of a point (h, l).

use super::component::Component;
use bifdiag_equilibria::curves::CurveName;

/// The components of U_hl in canonical order; none below the lowest critical value.
pub type Components = Vec<Component>;

/// What is known of a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Inside a region, with these components.
    Regular(Components),
    /// Below the lowest critical value: U_hl is empty.
    Forbidden,
    /// Exactly on a curve (proved); each class that meets there, once.
    Critical(Vec<Components>),
    /// Closer to a curve than the error bound; each possible class, once.
    Undecided(Vec<Components>),
}

impl Answer {
    /// A region with these components may be that of the point, or meet there.
    #[must_use]
    pub fn allows(&self, components: &[Component]) -> bool {
        match self {
            Self::Regular(known) => known == components,
            Self::Forbidden => components.is_empty(),
            Self::Critical(classes) | Self::Undecided(classes) => classes.iter().any(|class| class == components),
        }
    }
}

/// Distance in h to the nearest curve, and how much of it can be trusted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// |h − h_c| to the nearest critical curve or pole line at this l.
    pub h: f64,
    /// That curve; `None` when no curve was computed.
    pub nearest: Option<CurveName>,
    /// Bound on the error of `h`.
    pub error_bound: f64,
}

/// The type of U_hl, E_hl and P_hl at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Classification {
    /// What is known.
    pub answer: Answer,
    /// Distance to the nearest curve.
    pub margin: Margin,
}

impl Classification {
    /// A point off the curves; without components it is forbidden.
    #[must_use]
    pub fn decided(components: Components, margin: Margin) -> Self {
        let answer = if components.is_empty() { Answer::Forbidden } else { Answer::Regular(components) };
        Self { answer, margin }
    }

    /// A point on a curve, or too near to one.
    #[must_use]
    pub fn open(critical: bool, candidates: Vec<Components>, margin: Margin) -> Self {
        let answer = if critical { Answer::Critical(candidates) } else { Answer::Undecided(candidates) };
        Self { answer, margin }
    }

    /// The components where they are known: none when forbidden; `None` when critical or undecided.
    #[must_use]
    pub fn components(&self) -> Option<&[Component]> {
        match &self.answer {
            Answer::Regular(components) => Some(components),
            Answer::Forbidden => Some(&[]),
            Answer::Critical(_) | Answer::Undecided(_) => None,
        }
    }

    /// The classes that may meet there; none for a point that is decided.
    #[must_use]
    pub fn candidates(&self) -> &[Components] {
        match &self.answer {
            Answer::Critical(candidates) | Answer::Undecided(candidates) => candidates,
            Answer::Regular(_) | Answer::Forbidden => &[],
        }
    }
}
