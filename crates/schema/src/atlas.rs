//! `atlas.json`: curves, events and regions of the (h, l) plane of one body.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::term::term;
use super::{
    Accuracy, CertificateDocument, ComponentDocument, FrictionDocument, GivenBody, Head, IntegrableDocument,
    MarginDocument, NonlinearDocument, NonlinearVerdict, PartDocument, Reason, Stability,
};

/// What is special about a body, decided exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Flags {
    /// No mass distribution has these moments and this centre of mass: some A_i + A_j < A_k, or = A_k with r_k ≠ 0.
    pub unphysical: bool,
    /// The body exists and some A_i + A_j = A_k: all mass lies in a plane through the fixed point.
    pub plate: bool,
    /// Two or three moments are equal.
    pub symmetric: bool,
    /// Some r_i = 0.
    pub plane: bool,
    /// r is a principal direction: r̂ is an eigenvector of A.
    pub axis: bool,
    /// r = 0: Euler's case.
    pub euler: bool,
}

impl Flags {
    /// The closed form of the generic body needs a special case.
    #[must_use]
    pub fn degenerate(&self) -> bool {
        self.symmetric || self.plane || self.axis || self.euler
    }
}

/// The body of an atlas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodyDocument {
    /// The numbers.
    #[serde(flatten)]
    pub given: GivenBody,
    /// What is special about the body.
    #[serde(flatten)]
    pub flags: Flags,
    /// One of `symmetric`, `plane`, `axis` and `euler`: the generic closed form needs a special case.
    pub degenerate: bool,
    /// The integrable cases to which the body belongs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integrable: Vec<IntegrableDocument>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// What a curve in the (h, l) plane consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CurveKind {
    /// Relative equilibria of the generic family γ(μ).
    Generic,
    /// A symmetric pair over μ = A_i with r_i = 0.
    Pair,
    /// A circle of relative equilibria (bodies with two equal moments).
    Circle,
    /// Rotation about a principal axis: a straight line in (l², h).
    Axis,
    /// r̂ enters U_hl.
    PolePlus,
    /// −r̂ enters U_hl.
    PoleMinus,
    /// All of S² is critical.
    Sphere,
}

/// A stretch of a curve with one kind of stability.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StabilitySpan {
    /// Where it begins.
    pub l_from: f64,
    /// Where it ends; null at infinity.
    pub l_to: Option<f64>,
    /// The linear type there.
    pub stability: Stability,
    /// The verdict there, except at isolated points, which `verdict_changes` lists.
    pub nonlinear: NonlinearDocument,
    /// What friction leaves of it.
    pub friction: FrictionDocument,
}

term! {
    /// How the linear type changes along a branch. The list is open.
    pub enum StabilityChangeKind {
        /// Two imaginary pairs of opposite Krein sign meet and leave the imaginary axis.
        HamiltonianHopf = "hamiltonian-hopf",
        /// Two real pairs meet and become a complex quadruple.
        RealCollision = "real-collision",
        /// A pair of eigenvalues goes through zero, or two pairs where moments are equal, at a cusp or pitchfork.
        Zero = "zero",
    }
}

/// A point of a branch at which the linear type changes: a root of the polynomials of Proposition 13.4 of
/// docs/algorithms.md, isolated exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StabilityChangeDocument {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Id of the curve on which it lies; at a cusp or pitchfork the first of the two.
    pub curve: String,
    /// Id of the curve that continues after a cusp or pitchfork.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub onto: Option<String>,
    /// What happens.
    pub kind: StabilityChangeKind,
    /// The type at smaller l or, at a cusp or pitchfork, on `curve`.
    pub from: Stability,
    /// The type at larger l or, at a cusp or pitchfork, on `onto`.
    pub to: Stability,
    /// Bound on the errors of `l` and `h`; with a certificate at most 256 roundings (2⁻⁵²) of `l + |h| + |r|`.
    pub error_bound: f64,
}

term! {
    /// Which of the hypotheses of Arnold's theorem fails.
    pub enum Failing {
        /// ω₁ = ω₂.
        Resonance11 = "1:1",
        /// ω₁ = 2ω₂.
        Resonance12 = "1:2",
        /// ω₁ = 3ω₂.
        Resonance13 = "1:3",
        /// D₄ = 0.
        Determinant = "D4",
    }
}

/// A point of a curve at which a hypothesis of Arnold's theorem fails, whether or not the verdict changes there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct VerdictChangeDocument {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Id of the curve on which it lies.
    pub curve: String,
    /// What fails.
    pub kind: Failing,
    /// The verdict at the point itself.
    pub verdict: NonlinearVerdict,
    /// Why.
    pub why: Reason,
    /// The verdicts before and after differ.
    pub changes: bool,
    /// Bound on the errors of `l` and `h`.
    pub error_bound: f64,
    /// `verify` confirms it.
    pub proved: bool,
}

/// The asymptote of a curve: h = l²/(2 J) + h0 + O(l⁻²).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TailDocument {
    /// J: the moment of inertia of the limiting axis.
    pub moment: f64,
    /// h0.
    pub h_offset: f64,
}

/// A curve of critical values, or a pole line: a piece of a branch along which l is monotone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CurveDocument {
    /// Id, unique in the atlas.
    pub id: String,
    /// What it consists of.
    pub kind: CurveKind,
    /// Branch: curves that continue each other through cusps and pitchforks share it.
    pub branch: String,
    /// The branch in words: `from +r̂`, `between axis 1 and axis 2`, `pair over axis 2`, `circle over axes 1 and 2`, …
    pub branch_name: String,
    /// Morse index; null for a pole line.
    pub index: Option<u8>,
    /// 2 for a symmetric pair (a double curve), else 1.
    pub multiplicity: u32,
    /// Ids of the curves with the same (h, l): pole lines that run on critical curves.
    pub coincides_with: Vec<String>,
    /// Range of μ of the closed form; an infinite end is null. Absent for pole lines, and where r = 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mu_range: Option<[Option<f64>; 2]>,
    /// Range of l; an infinite end is null.
    pub l_range: [Option<f64>; 2],
    /// The linear type along the curve, by rising l; empty for pole lines, and with a window for curves that have no l in
    /// common with it.
    pub stability: Vec<StabilitySpan>,
    /// Asymptotics for l → ∞; null for a curve with two finite ends.
    pub tail: Option<TailDocument>,
}

/// Kinds of events of the arrangement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EventKind {
    /// Two curves meet and vanish.
    Cusp,
    /// A symmetric pair or a circle leaves a curve; `curves` holds the curve before, the curve after, and the pair or circle.
    Pitchfork,
    /// Two curves cross.
    Crossing,
}

/// Proved bounds of a point, as decimals. In l² they are at most as wide as the enclosure of the certificate and four
/// roundings (2⁻⁵²) of l², in h as that and four roundings of `|h| + |r|`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct EnclosureDocument {
    /// l lies between these; the lower one is not negative.
    pub l: [String; 2],
    /// h lies between these.
    pub h: [String; 2],
}

/// A point where curves meet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EventDocument {
    /// What happens.
    pub kind: EventKind,
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Ids of the curves that meet.
    pub curves: Vec<String>,
    /// Bound on the error of `l`; with a certificate at most the width of the enclosure and two roundings of l.
    pub l_error: f64,
    /// Bound on the error of `h`; with a certificate at most the width of the enclosure and four roundings of `|h| + |r|`.
    pub h_error: f64,
    /// Proved bounds (certified only).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enclosure: Option<EnclosureDocument>,
}

/// A point inside a region, chosen where it is wide relative to the energies there; where no double lies inside, the
/// doubles nearest to a point inside, which the certificate has exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SampleDocument {
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
    /// Distance of the exact point to the boundary. With a certificate its `error_bound` holds for the rounded point too, unless
    /// a curve begins or ends in between.
    pub margin: MarginDocument,
}

/// A region on the other side of a curve.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct NeighbourDocument {
    /// Id of the region; null: the forbidden region below the lowest critical value.
    pub region: Option<String>,
    /// Id of the curve crossed.
    pub curve: String,
}

/// A part of a region: all (h, l) between two curves over a range of l that no event divides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CellDocument {
    /// Range of l; an infinite end is null.
    pub l_range: [Option<f64>; 2],
    /// Id of the curve below (to the left in h).
    pub lower: String,
    /// Id of the curve above; null: unbounded.
    pub upper: Option<String>,
}

/// A connected face of the (h, l) half-plane l > 0, on which the topology is constant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RegionDocument {
    /// Id, unique in the atlas.
    pub id: String,
    /// A well-placed point inside.
    pub sample: SampleDocument,
    /// The components of U_hl; none where they are not decided (`fast`).
    pub components: Vec<ComponentDocument>,
    /// The sections' names joined by `+`; null when r = 0, and where they are not decided (`fast`).
    pub signature: Option<String>,
    /// True when the region is bounded in the (h, l) plane.
    pub bounded: bool,
    /// Range of l; an infinite end is null.
    pub l_range: [Option<f64>; 2],
    /// Ids of the curves on the boundary, each once: below and above each cell, in the order of `cells`.
    pub boundary: Vec<String>,
    /// The regions across curves of the boundary, one for each region and curve; across a pole line that coincides with
    /// another curve none. With a window only listed regions, and the forbidden one.
    pub neighbours: Vec<NeighbourDocument>,
    /// The cells whose union it is, by rising l, then h.
    pub cells: Vec<CellDocument>,
    /// True when a window cuts it. The `sample` of a cut region lies in the window; `cells`, `l_range` and `h_width`
    /// are those of the
    /// whole.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub clipped: bool,
}

/// Something that this accuracy could not decide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UndecidedDocument {
    /// What could not be decided, in words.
    pub what: String,
    /// Near this l.
    pub l: f64,
    /// Near this h.
    pub h: f64,
    /// Ids of the curves concerned.
    pub curves: Vec<String>,
}

/// Totals of an atlas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SummaryDocument {
    /// Number of the `regions`.
    pub regions: usize,
    /// Number of the `events`.
    pub events: usize,
    /// How many of the `regions` have each signature (for r = 0, each type of U); without a name, those that are not decided.
    pub signatures: BTreeMap<String, usize>,
    /// The largest number of relative equilibria at one l, of the whole half-plane also where a window was searched; a critical
    /// circle or sphere counts once. With `fast` it may be too large where events are nearer than f64 resolves.
    pub critical_points_max: usize,
    /// What could not be decided.
    pub undecided: Vec<UndecidedDocument>,
    /// True when `regions` covers the whole half-plane l > 0 and nothing is undecided; never with a window.
    pub complete: bool,
}

/// A part of the (h, l) plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WindowDocument {
    /// Energies.
    pub h: [f64; 2],
    /// Vertical angular momenta.
    pub l: [f64; 2],
}

/// The windows in which a diagram is seen, to 10⁻⁶ of each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ViewDocument {
    /// The default view: all events, and a part of every unbounded region; the `polygon` of each region lies in it.
    pub everything: WindowDocument,
    /// All events except those far beyond all others.
    pub main: WindowDocument,
}

/// The drawing of a curve.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CurveDrawing {
    /// Points [h, l] by rising l, from end to end (none of a curve that has no l in common with the window, if one was asked
    /// for, and of a pole line not those where it runs along such a curve); an unbounded curve at least up to l₁, the largest of 1.6 times the l of the
    /// last event and 3√(A |r|) with the largest A (|r| here at least the unit of energy of the certificate). No chord leaves
    /// its curve by more than 1/800 of l₁²/(2A) + 2|r| in h, measured across the chord in units of that height and of l₁.
    pub polyline: Vec<[f64; 2]>,
}

/// The drawing of a region.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RegionDrawing {
    /// The part of the region inside `view.everything` (inside the window, if one was asked for): closed outlines of points
    /// [h, l] whose last point is the first; a hole is a separate outline (fill by the even-odd rule). An outline
    /// begins at
    /// its smallest l, there at the lowest h (to a rounding), and has the region on its left as l runs to the right and h upwards;
    /// outlines are ordered by that l, then h. Where two events of the list are at one l, all outlines end at the l of
    /// each event. Corners lie on the curves, except where a curve leaves the view. No edge leaves its curve by more
    /// than 1/250 of the
    /// height of the view in h, or it spans less than 10⁻⁹ of the view's l.
    pub polygon: Vec<Vec<[f64; 2]>>,
    /// The largest extent in h at one l, to 10⁻⁶ of it and 4·10⁻⁹ of |r|; null if unbounded.
    pub h_width: Option<f64>,
}

/// What pictures of an atlas show, in f64: no part of a proof. The accuracies hold for all bodies except those whose
/// curves cannot be told apart in doubles, such as rods of 10⁻¹¹ and less.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DrawingDocument {
    /// Where the diagram is seen; it depends on the body alone.
    pub view: ViewDocument,
    /// By the ids of the curves.
    pub curves: BTreeMap<String, CurveDrawing>,
    /// By the ids of the regions.
    pub regions: BTreeMap<String, RegionDrawing>,
}

/// The atlas of one body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AtlasDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The requested level of accuracy.
    pub accuracy: Accuracy,
    /// The body.
    pub body: BodyDocument,
    /// The requested window: events and changes are then those in it, `regions` those that meet it; absent: the whole
    /// half-plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub window: Option<WindowDocument>,
    /// Critical curves and pole lines.
    pub curves: Vec<CurveDocument>,
    /// Cusps, pitchforks and crossings, by rising l; with a window those in it.
    pub events: Vec<EventDocument>,
    /// Every change of the linear type along a branch, by rising l; with a window those in it.
    pub stability_changes: Vec<StabilityChangeDocument>,
    /// Every isolated point of a curve at which a hypothesis of Arnold's theorem fails, by rising l, then h; with a window
    /// those in it. None on curves where a further integral decides (`integral`). Absent with `--accuracy fast`, and where
    /// not all of them are known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict_changes: Option<Vec<VerdictChangeDocument>>,
    /// Every region; with a window those that meet it.
    pub regions: Vec<RegionDocument>,
    /// Totals.
    pub summary: SummaryDocument,
    /// What pictures show; absent with `--no-drawing`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drawing: Option<DrawingDocument>,
    /// What is needed to check the atlas (certified only).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<CertificateDocument>,
}

impl RegionDocument {
    /// The label of the region: the sections' names joined by `+`; for r = 0, where there are no sections, those of the
    /// types of U.
    #[must_use]
    pub fn shown(&self) -> String {
        let accessible = || self.components.iter().map(|component| component.accessible_region.as_str());
        self.signature.clone().unwrap_or_else(|| accessible().collect::<Vec<_>>().join("+"))
    }
}

impl AtlasDocument {
    /// The points of a curve by rising l; none without a drawing.
    #[must_use]
    pub fn polyline(&self, curve: &str) -> &[[f64; 2]] {
        let drawn = self.drawing.as_ref().and_then(|drawing| drawing.curves.get(curve));
        drawn.map_or(&[], |curve| &curve.polyline)
    }

    /// The largest extent of a region in h; none without a drawing, or if it is unbounded.
    #[must_use]
    pub fn h_width(&self, region: &str) -> Option<f64> {
        self.drawing.as_ref()?.regions.get(region)?.h_width
    }
}
