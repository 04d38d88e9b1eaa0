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
    /// A moment of inertia of the body.
    #[error("A{axis} = {} is not positive; a moment of inertia must be greater than zero", shown(value))]
    Body {
        /// 1, 2 or 3.
        axis: usize,
        /// The moment as written.
        value: String,
    },
    /// The checksum.
    #[error("the checksum does not fit: the file is damaged")]
    Checksum,
    /// A text that is not a number within 10^±150, in the units in which it is told.
    #[error("`{}` is not a number, or out of range", shown(text))]
    Number {
        /// The text.
        text: String,
    },
    /// A place off the families of equilibria, or on the wrong one.
    #[error("{what} number {number} is not at a place where it can be")]
    BadPlace {
        /// Cusp or meeting.
        what: &'static str,
        /// Which.
        number: usize,
    },
    /// A list that is longer than it can be.
    #[error("the certificate lists {listed} {what}, but there are at most {most}")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// In the certificate.
        listed: usize,
        /// For this body.
        most: usize,
    },
    /// Cusps are missing or invented.
    #[error("branch {branch} has {counted} cusps but the certificate lists {listed}")]
    CuspCount {
        /// The branch.
        branch: String,
        /// In the certificate.
        listed: i64,
        /// In the branch.
        counted: i64,
    },
    /// A range does not hold exactly one root.
    #[error("{what} number {number} is not isolated by its range")]
    NotIsolated {
        /// Cusp or meeting.
        what: &'static str,
        /// Which.
        number: usize,
    },
    /// Meetings with pole lines are missing or invented.
    #[error("branch {branch} meets the pole lines {counted} times but the certificate lists {listed}")]
    MeetingCount {
        /// The branch.
        branch: String,
        /// In the certificate.
        listed: i64,
        /// In the branch.
        counted: i64,
    },
    /// A meeting with the wrong pole line or curve.
    #[error("meeting number {number}: {why}")]
    Meeting {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// The place where the slope turns.
    #[error("the inflection of the generic family is not where the certificate says")]
    Inflection,
    /// Ranges overlap.
    #[error("the ranges of {what} overlap")]
    Overlap {
        /// Of what.
        what: String,
    },
    /// Something that should be finite.
    #[error("{what} cannot be enclosed")]
    Unbounded {
        /// What.
        what: String,
    },
    /// A curve that does not exist, or one that is missing.
    #[error("there is no curve {}, or it is missing", shown(id))]
    UnknownCurve {
        /// Its id.
        id: String,
    },
    /// A point that is not on its curve.
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
    /// An event.
    #[error("event number {number}: {why}")]
    Event {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// A slab.
    #[error("slab number {number}: {why}")]
    Slab {
        /// Which.
        number: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// A region.
    #[error("region {}: {why}", shown(region))]
    Region {
        /// Which.
        region: String,
        /// What is wrong.
        why: &'static str,
    },
    /// The topology of a region.
    #[error("region {} is said to be {}, but it is {found}", shown(region), shown(claimed))]
    Topology {
        /// Which.
        region: String,
        /// In the atlas.
        claimed: String,
        /// By this check.
        found: String,
    },
    /// A region whose topology this check cannot decide, or that the atlas leaves open.
    #[error("the topology of region {} is not confirmed", shown(region))]
    Open {
        /// Which.
        region: String,
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
        /// Counted.
        found: usize,
    },
}
