//! What a check can find wrong.

use bifdiag_schema::shown;
use thiserror::Error;

/// The first thing that is wrong. Messages quote texts of the document by [`shown`].
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Refused {
    /// An atlas without certificate.
    #[error("there is no certificate that could be checked; bifdiag atlas --certificate makes the atlas with one")]
    NoCertificate,
    /// A certificate is exact.
    #[error("there is a certificate, but the accuracy is not `exact`")]
    Accuracy,
    /// A moment of inertia of the body is not positive.
    #[error("A{axis} = {} is not positive; a moment of inertia must be greater than zero", shown(value))]
    Body {
        /// 1, 2 or 3.
        axis: usize,
        /// The moment as written.
        value: String,
    },
    /// The file is damaged.
    #[error("the checksum does not fit: the file is damaged")]
    Checksum,
    /// A text is not a number within 10^±150, in its units.
    #[error("`{}` is not a number, or out of range", shown(text))]
    Number {
        /// The text.
        text: String,
    },
    /// A list is longer than it can be for this body.
    #[error("the certificate lists {listed} {what}, but there are at most {most}")]
    TooMany {
        /// What is listed.
        what: &'static str,
        /// Entries of the list.
        listed: usize,
        /// Their largest number.
        most: usize,
    },
    /// Cusps, or meetings with pole lines, are missing or invented.
    #[error("branch {branch} has {counted} {what}, but the certificate lists {listed}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// The branch.
        branch: String,
        /// Entries of the certificate.
        listed: usize,
        /// Roots of the branch.
        counted: usize,
    },
    /// An entry of a list of the certificate: a cusp, a meeting, an event, a slab.
    #[error("{what} number {number}: {why}")]
    Entry {
        /// The kind of entry.
        what: &'static str,
        /// Its number, from 0.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// Something cannot be decided with the ranges that the certificate gives.
    #[error("{what}")]
    Uncertain {
        /// What.
        what: String,
    },
    /// A curve that does not exist, or one that is missing.
    #[error("there is no curve {}, or it is missing", shown(id))]
    UnknownCurve {
        /// Its id.
        id: String,
    },
    /// A point is not on its curve.
    #[error("curve {} is not where the certificate says at x = {x}", shown(curve))]
    Place {
        /// The curve.
        curve: String,
        /// x = l²/2 in the certificate's units.
        x: f64,
    },
    /// The order of two curves.
    #[error("curves {} and {} near x = {x}: {why}", shown(&curves[0]), shown(&curves[1]))]
    Pair {
        /// The curves.
        curves: [String; 2],
        /// x = l²/2 in the certificate's units.
        x: f64,
        /// What is wrong.
        why: &'static str,
    },
    /// A region.
    #[error("region {}: {why}", shown(region))]
    Region {
        /// Its id.
        region: String,
        /// What is wrong.
        why: &'static str,
    },
    /// The topology of a region.
    #[error("region {} is said to be {}, but it is {found}", shown(region), shown(claimed))]
    Topology {
        /// Its id.
        region: String,
        /// In the atlas.
        claimed: String,
        /// By this check.
        found: String,
    },
    /// A field of the document.
    #[error("{field} is not what this check finds")]
    Field {
        /// Its name.
        field: &'static str,
    },
    /// The summary.
    #[error("the summary says {claimed} {what}, but there are {found}")]
    Summary {
        /// Regions or events.
        what: &'static str,
        /// In the atlas.
        claimed: usize,
        /// By this check.
        found: usize,
    },
}

impl Refused {
    /// The refusal of an entry of a list.
    pub(crate) fn entry(what: &'static str, number: usize, why: &'static str) -> Self {
        Self::Entry { what, number, why }
    }

    pub(crate) fn misplaced(what: &'static str, number: usize) -> Self {
        Self::entry(what, number, "it is not at a place where it can be")
    }

    pub(crate) fn not_isolated(what: &'static str, number: usize) -> Self {
        Self::entry(what, number, "its range does not isolate it")
    }

    pub(crate) fn uncertain(what: &str) -> Self {
        Self::Uncertain { what: what.to_owned() }
    }
}
