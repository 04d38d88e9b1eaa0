//! The documents of `bifdiag periodic`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::term::term;
use super::{Ends, GivenBody, Head, PartDocument, RelativeEquilibriumDocument};

term! {
    /// What the multipliers of a periodic orbit say of its stability.
    pub enum OrbitStability {
        /// On the unit circle, not 1 or −1: linearly stable.
        Elliptic = "elliptic",
        /// Real and positive: unstable.
        Hyperbolic = "hyperbolic",
        /// Real and negative: unstable, and near motions turn half round it in a period.
        InverseHyperbolic = "inverse-hyperbolic",
        /// 1 or −1 within rounding: not decided by the linear terms.
        Parabolic = "parabolic",
    }
}

impl OrbitStability {
    /// It has a multiplier outside the unit circle.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self, Self::Hyperbolic | Self::InverseHyperbolic)
    }
}

/// A periodic orbit of γ and ω.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicOrbitDocument {
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
    /// γ at a point of it: a maximum of ⟨γ,r⟩, which lies on P, if it has one.
    pub gamma: [f64; 3],
    /// ω there.
    pub omega: [f64; 3],
    /// Crossings of P in a period, inward and outward.
    pub crossings: u32,
    /// Period of γ and ω.
    pub period: f64,
    /// The Floquet multipliers beside those that h, l and the flow make 1, each [re, im].
    pub multipliers: [[f64; 2]; 2],
    /// What they say.
    pub stability: OrbitStability,
    /// ∮⟨l, ω⟩ dt over a period, twice the integral of the kinetic energy.
    pub action: f64,
    /// Whether a reversor, a map that keeps h and l and turns motions round, takes it to itself.
    pub symmetric: bool,
    /// Whether its existence was proved.
    pub proved: bool,
    /// What holds it, where it was proved.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enclosure: Option<OrbitEnclosureDocument>,
}

/// Decimals that are rounded outward: between them lies what was proved to exist.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OrbitEnclosureDocument {
    /// γ where the orbit starts.
    pub gamma: [Ends; 3],
    /// ω there.
    pub omega: [Ends; 3],
    /// The period.
    pub period: Ends,
    /// The sum of the two multipliers.
    pub trace: Ends,
}

term! {
    /// How a family of periodic orbits ends.
    pub enum FamilyEnd {
        /// It shrinks to an equilibrium.
        Equilibrium = "equilibrium",
        /// Its period grows without bound, as its orbits come ever nearer to equilibria.
        Separatrix = "separatrix",
        /// Its period grows without bound, as its orbits come ever nearer to a circle of equilibria, along which they run.
        Circle = "circle",
        /// It joins another family: its orbits become symmetric, or run twice through one of half the period.
        Joined = "joined",
        /// So many members were asked for.
        Members = "members",
        /// The smallest step did not find a next member.
        Lost = "lost",
        /// It was not begun: the other pair of eigenvalues is a multiple of this one, or zero.
        Resonant = "resonant",
        /// It was not begun: the equilibrium is one of a circle or a sphere of them.
        NotIsolated = "not-isolated",
    }
}

term! {
    /// What happens at an orbit of a family.
    pub enum OrbitEventKind {
        /// The family turns back: h, or l where h is fixed, is largest or smallest, and both multipliers are 1.
        Fold = "fold",
        /// Both multipliers are 1 and the family goes on: another family of the same period crosses it.
        Branch = "branch",
        /// Both multipliers are −1: a family of twice the period begins.
        Doubling = "doubling",
        /// The multipliers are third roots of 1: a family of three times the period passes.
        Tripling = "tripling",
    }
}

/// The end of a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FamilyEndingDocument {
    /// How it ends.
    pub kind: FamilyEnd,
    /// The curves of the equilibria to which it comes, by their ids; empty for other ends.
    pub curves: Vec<String>,
    /// h of its last member.
    pub h: Option<f64>,
    /// l of its last member.
    pub l: Option<f64>,
    /// Period of its last member.
    pub period: Option<f64>,
}

/// A family that begins at an orbit of another one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicBranchDocument {
    /// Its orbits, from the other family on.
    pub members: Vec<PeriodicOrbitDocument>,
    /// How it ends.
    pub end: FamilyEndingDocument,
}

/// A special orbit of a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OrbitEventDocument {
    /// What happens there.
    pub kind: OrbitEventKind,
    /// The number of the member after which it lies, from 0.
    pub after: usize,
    /// h there.
    pub h: f64,
    /// l there.
    pub l: f64,
    /// Period there.
    pub period: f64,
    /// Bound on how far the place was still moving, in h or, where h is fixed, l.
    pub error: f64,
    /// The families that begin there, if they were followed.
    pub branches: Vec<PeriodicBranchDocument>,
}

/// A family of periodic orbits that begins at an equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicFamilyDocument {
    /// The curve of the equilibrium.
    pub curve: Option<String>,
    /// γ of the equilibrium.
    pub gamma: [f64; 3],
    /// h of the equilibrium.
    pub h: f64,
    /// l of the equilibrium.
    pub l: f64,
    /// The frequency ω of small oscillations, from the eigenvalues ±iω.
    pub frequency: f64,
    /// The period 2π/ω to which those of the family tend there.
    pub period: f64,
    /// The orbits, from the equilibrium on.
    pub members: Vec<PeriodicOrbitDocument>,
    /// Its special orbits, in order.
    pub events: Vec<OrbitEventDocument>,
    /// How it ends.
    pub end: FamilyEndingDocument,
}

/// The answer of `periodic family`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicFamiliesDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The l that all members have, as given; `null` where h is fixed.
    pub fixed_l: Option<String>,
    /// The h that all members have, as given; `null` where l is fixed.
    pub fixed_h: Option<String>,
    /// The families, by equilibrium, the faster oscillation first.
    pub families: Vec<PeriodicFamilyDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// The answer of `periodic`: the periodic orbits with few crossings of the section P at one point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy, as given.
    pub h: String,
    /// Vertical angular momentum, as given.
    pub l: String,
    /// The most crossings of P in a period that were asked for, inward and outward.
    pub crossings: u32,
    /// The isolated orbits, each once, by their crossings, then by their periods; each starts where its centre of mass is lowest.
    pub orbits: Vec<PeriodicOrbitDocument>,
    /// One orbit of each continuum of orbits of one period, such as a resonant torus of an integrable body.
    pub continua: Vec<PeriodicOrbitDocument>,
    /// For m = 1, 2, … the sum of the indices of the isolated fixed points of the m-th return to the maxima of ⟨γ,r⟩.
    pub index_sums: Vec<i32>,
    /// Whether every cell of the section was decided.
    pub complete: bool,
    /// What that rests on, or what may be missing.
    pub why: String,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// An orbit of a listed family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ListedOrbitDocument {
    /// Its number along the family, from 0; those that were not asked for are counted.
    pub member: usize,
    /// The orbit.
    #[serde(flatten)]
    pub orbit: PeriodicOrbitDocument,
}

/// A family of `periodic list`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ListedFamilyDocument {
    /// The curve of its equilibrium and the number of its frequency there, from the fastest: `G2.1/1`. One id stands for a
    /// family at every l or h that was asked for.
    pub family: String,
    /// 0: it begins at the equilibrium; else the number of the branch that begins at a special orbit of that one.
    pub branch: usize,
    /// γ of the equilibrium.
    pub gamma: [f64; 3],
    /// h of the equilibrium.
    pub h: f64,
    /// l of the equilibrium.
    pub l: f64,
    /// Frequency ω of the small oscillations about it.
    pub frequency: f64,
    /// How many orbits it has, as far as it was followed.
    pub followed: usize,
    /// Those that were asked for, in their order.
    pub orbits: Vec<ListedOrbitDocument>,
    /// How it ends.
    pub end: FamilyEndingDocument,
}

/// The answer of `periodic list`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PeriodicListDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// The momenta at which families were followed; `null` where it was at energies.
    pub fixed_l: Option<Vec<String>>,
    /// The energies at which families were followed; `null` where it was at momenta.
    pub fixed_h: Option<Vec<String>>,
    /// Only this curve or family was asked for.
    pub only: Option<String>,
    /// So many orbits of each family, and of each branch, at most.
    pub members: usize,
    /// Whether families that begin at special orbits were followed too.
    pub branches: bool,
    /// Only linearly stable orbits were asked for.
    pub stable: bool,
    /// Only orbits with a period between these, both included, were asked for.
    pub period: Option<[f64; 2]>,
    /// Only orbits with at most so many crossings of P were asked for.
    pub crossings: Option<u32>,
    /// The families, by l or h, then by their equilibria, each with its branches behind it.
    pub families: Vec<ListedFamilyDocument>,
    /// Whether every family was followed to its end.
    pub complete: bool,
    /// What that means, and what is not checked.
    pub why: String,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

term! {
    /// Which motions run along a manifold.
    pub enum ManifoldKind {
        /// Those that leave the orbit or the equilibrium.
        Unstable = "unstable",
        /// Those that come to it.
        Stable = "stable",
    }
}

term! {
    /// Why a curve of a manifold ends.
    pub enum ManifoldEnd {
        /// It has the length that was asked for.
        Length = "length",
        /// What a return adds lies within 10⁻⁴ of a periodic orbit: a saddle connection, or curves that cross at so small an angle
        /// that they cannot be told apart there. Of an equilibrium likewise; a motion comes to within 10⁻⁵ of one, and all its
        /// points are those of a motion of the other kind, to 10⁻¹⁰.
        Orbit = "orbit",
        /// It would take more returns than are computed.
        Work = "work",
        /// Further points of the motion cannot be computed to 10⁻⁸.
        Accuracy = "accuracy",
    }
}

/// A curve of a manifold in P, from the orbit or equilibrium on; of an equilibrium with one real and one imaginary pair, the points of
/// one motion, which no curve joins.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ManifoldCurveDocument {
    /// The point of the orbit from which it comes: of p, Rp, R²p, … the number, p where the orbit starts and R the return. Of an
    /// equilibrium: of the lines that leave it in P, in the order in which R takes one to the next; else 0.
    pub point: usize,
    /// 1 or −1: the two curves at one point, or the two motions. Which is which has no meaning. 1 where there is one.
    pub side: i8,
    /// Its length in (γ, l/L), L = √(2A_max(|h| + |r|)).
    pub length: f64,
    /// The number of its points.
    pub points: usize,
    /// Breaks at which a motion touches P, so that a pair of crossings is born.
    pub tangencies: usize,
    /// Of an equilibrium: breaks at motions that come to it, or to one of the same curve.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rests: usize,
    /// Other breaks: neighbouring points could not be brought near each other.
    pub gaps: usize,
    /// Of one motion: the smallest distance of its points from those of the motions of the other kind.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<f64>,
    /// Why it ends.
    pub end: ManifoldEnd,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// The curves of one kind of one orbit or equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ManifoldDocument {
    /// The place of the orbit in `orbits`; where there are `equilibria`, that of one of them, as in the connections and contacts.
    pub orbit: usize,
    /// Stable or unstable.
    pub kind: ManifoldKind,
    /// Of an orbit: the multiplier that is larger than 1, or below −1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub multiplier: Option<f64>,
    /// Two at each point of the orbit where ⟨γ,r⟩ is largest; of an equilibrium, all.
    pub curves: Vec<ManifoldCurveDocument>,
}

/// An orbit that leaves a periodic orbit or an equilibrium and comes to one, found where their manifolds cross.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ConnectionDocument {
    /// The place in `orbits` of the orbit that it leaves.
    pub from: usize,
    /// That of the orbit to which it comes; homoclinic where it is the same.
    pub to: usize,
    /// γ at a point of it: of those found the one farthest from the periodic orbits.
    pub gamma: [f64; 3],
    /// ω there.
    pub omega: [f64; 3],
    /// The angle of the two curves there, in radians, in (γ, l/L).
    pub angle: f64,
    /// The distance of the points of both curves after Newton's method.
    pub residual: f64,
    /// How many of its points were found.
    pub points: usize,
}

/// Curves that run along each other, at angles below 10⁻⁴; or motions that agree in all points, to 10⁻¹⁰.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ContactDocument {
    /// The place in `orbits` of the orbit whose unstable curve it is.
    pub from: usize,
    /// That of the orbit whose stable curve it is.
    pub to: usize,
}

/// The answer of `periodic manifolds`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ManifoldsDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy, as given; that of the equilibria, where there are any.
    pub h: String,
    /// Vertical angular momentum, as given.
    pub l: String,
    /// The most crossings of P in a period that were asked for, inward and outward; 0 where equilibria were.
    pub crossings: u32,
    /// The length of each curve that was asked for.
    pub length: f64,
    /// The equilibria whose manifolds were asked for, as in `critical`; of a symmetric pair both. Then there are no `orbits`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub equilibria: Vec<RelativeEquilibriumDocument>,
    /// All isolated orbits, as in `periodic`.
    pub orbits: Vec<PeriodicOrbitDocument>,
    /// The manifolds of the unstable ones, by orbit or equilibrium, the unstable one first.
    pub manifolds: Vec<ManifoldDocument>,
    /// Homoclinic and heteroclinic orbits, each once as far as its points could be matched, by the orbits that they connect.
    pub connections: Vec<ConnectionDocument>,
    /// Curves that cannot be told from each other.
    pub contacts: Vec<ContactDocument>,
    /// Whether no curve took too much work, none has gaps and none was left out, the list of the orbits is complete, and every
    /// crossing of the polylines farther than 10⁻³ from the orbits is one of a connection or of a contact.
    pub complete: bool,
    /// What that means, or what may be missing.
    pub why: String,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}
