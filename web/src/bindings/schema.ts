/** The documents of the command line. Written by `cargo run --release --example records`. */

/** The atlas of one body. */
export interface Atlas {
  /** Version of the documents. */
  schema_version: string;
  /** Version of the program that made it. */
  version: string;
  /** The canonical command that prints the document, made from body and settings. */
  command: string;
  /** The requested level of accuracy. */
  accuracy: Accuracy;
  /** The body. */
  body: Body;
  /** The requested window: events and changes are then those in it, `regions` those that meet it; absent: the whole half-plane. */
  window?: Window;
  /** Critical curves and pole lines. */
  curves: Curve[];
  /** Cusps, pitchforks and crossings, by rising l; with a window those in it. */
  events: Event[];
  /** Every change of the linear type along a branch, by rising l; with a window those in it. */
  stability_changes: StabilityChange[];
  /** Every isolated point of a curve at which a hypothesis of Arnold's theorem fails, by rising l, then h; with a window those in it. None on curves where a further integral decides (`integral`). Absent with `--accuracy fast`, and where not all of them are known. */
  verdict_changes?: VerdictChange[];
  /** Every region; with a window those that meet it. */
  regions: Region[];
  /** Totals. */
  summary: Summary;
  /** What pictures show; absent with `--no-drawing`. */
  drawing?: Drawing;
  /** What is needed to check the atlas (certified only). */
  certificate?: Certificate;
}

/** The requested level of accuracy. */
export type Accuracy = "exact" | "fast";

/** The body of an atlas. */
export interface Body {
  /** A1, A2, A3 as given. */
  A: [string, string, string];
  /** r1, r2, r3 as given. */
  r: [string, string, string];
  /** No mass distribution has these moments and this centre of mass: some A_i + A_j < A_k, or = A_k with r_k ≠ 0. */
  unphysical: boolean;
  /** The body exists and some A_i + A_j = A_k: all mass lies in a plane through the fixed point. */
  plate: boolean;
  /** Two or three moments are equal. */
  symmetric: boolean;
  /** Some r_i = 0. */
  plane: boolean;
  /** r is a principal direction: r̂ is an eigenvector of A. */
  axis: boolean;
  /** r = 0: Euler's case. */
  euler: boolean;
  /** One of `symmetric`, `plane`, `axis` and `euler`: the generic closed form needs a special case. */
  degenerate: boolean;
  /** The integrable cases to which the body belongs. */
  integrable?: Integrable[];
  /** The part from which A and r were computed, when one was given. */
  part?: Part;
}

/** An integrable case to which a body belongs, decided exactly. */
export interface Integrable {
  /** Which. */
  case: IntegrableCaseName;
  /** The further integral in ω, γ, A, r and L = Aω, in the axes of the body. */
  integral: string;
  /** For which motions it is constant, such as `always` or `where l = 0`. */
  holds: string;
}

/** A case in which there is a further first integral, or an invariant relation. */
export type IntegrableCaseName = "euler" | "lagrange" | "kovalevskaya" | "goryachev-chaplygin" | "hess-appelrot";

/** A part as it was read. */
export interface Part {
  /** The tensor about the fixed point, its entries exact (off the diagonal Ixy = −∫ x y dm). */
  inertia: [[string, string, string], [string, string, string], [string, string, string]];
  /** The centre of mass from the fixed point, exact. */
  com: [string, string, string];
  /** The mass, exact. */
  mass: string;
  /** The acceleration of gravity in m/s². */
  g: string;
  /** Units of mass, length and time, of the block and of h, l, A and r in the document; `g` is in m/s², spins in rpm and rad/s. */
  units: string;
  /** About the fixed point: the axes in which A, r and γ of the document are. */
  principal: Principal;
  /** About the centre of mass: what CAD prints. */
  principal_com: Principal;
  /** Principal moments about the fixed point. */
  A: [string, string, string];
  /** m g times the centre of mass, in the principal axes. */
  r: [string, string, string];
  /** True when A and r are exact; else they are rounded to at least 130 digits, so that equal moments, zeros and coincidences of thresholds remain. */
  exact: boolean;
  /** Some mass distribution has these mass properties. */
  physical: boolean;
}

/** Principal moments and axes about a point. */
export interface Principal {
  /** The principal moments, in the part's units. */
  moments: [number, number, number];
  /** Row k is principal axis k in the part's frame. */
  axes: [[number, number, number], [number, number, number], [number, number, number]];
}

/** A part of the (h, l) plane. */
export interface Window {
  /** Energies. */
  h: [number, number];
  /** Vertical angular momenta. */
  l: [number, number];
}

/** A curve of critical values, or a pole line: a piece of a branch along which l is monotone. */
export interface Curve {
  /** Id, unique in the atlas. */
  id: string;
  /** What it consists of. */
  kind: CurveKind;
  /** Branch: curves that continue each other through cusps and pitchforks share it. */
  branch: string;
  /** The branch in words: `from +r̂`, `between axis 1 and axis 2`, `pair over axis 2`, `circle over axes 1 and 2`, … */
  branch_name: string;
  /** Morse index; null for a pole line. */
  index: number | null;
  /** 2 for a symmetric pair (a double curve), else 1. */
  multiplicity: number;
  /** Ids of the curves with the same (h, l): pole lines that run on critical curves. */
  coincides_with: string[];
  /** Range of μ of the closed form; an infinite end is null. Absent for pole lines, and where r = 0. */
  mu_range?: [number | null, number | null];
  /** Range of l; an infinite end is null. */
  l_range: [number | null, number | null];
  /** The linear type along the curve, by rising l; empty for pole lines, and with a window for curves that have no l in common with it. */
  stability: StabilitySpan[];
  /** Asymptotics for l → ∞; null for a curve with two finite ends. */
  tail: Tail | null;
}

/** What a curve in the (h, l) plane consists of. */
export type CurveKind = "generic" | "pair" | "circle" | "axis" | "pole-plus" | "pole-minus" | "sphere";

/** A stretch of a curve with one kind of stability. */
export interface StabilitySpan {
  /** Where it begins. */
  l_from: number;
  /** Where it ends; null at infinity. */
  l_to: number | null;
  /** The linear type there. */
  stability: Stability;
  /** The verdict there, except at isolated points, which `verdict_changes` lists. */
  nonlinear: Nonlinear;
  /** What friction leaves of it. */
  friction: Friction;
}

/** Linear type of a relative equilibrium, decided exactly: the eigenvalues ±λ₁, ±λ₂ of the Euler–Poisson flow reduced by l. */
export type Stability = "elliptic" | "saddle-centre" | "saddle" | "complex" | "double-elliptic" | "double-real" | "zero";

/** The verdict on the stability of a relative equilibrium, with its evidence. */
export interface Nonlinear {
  /** Stable, unstable, or open. */
  verdict: NonlinearVerdict;
  /** Why. */
  why: Reason;
  /** Arnold's determinant D₄ = K₁₁ω₂² + K₁₂ω₁ω₂ + K₂₂ω₁² over Ω², where H = ω₁I₁ − ω₂I₂ + K₁₁I₁² + K₁₂I₁I₂ + K₂₂I₂² + … with the pair of positive Krein sign first; `null` except at index 2 with two distinct imaginary pairs, and there too where a further integral decides, at a resonance 1:2 that makes it unstable, and along a curve. */
  D4_over_s: number | null;
  /** Bound on its error. */
  D4_error: number | null;
  /** Distances to the resonances; `null` except at index 2 with imaginary pairs, and there too where a further integral decides, and along a curve. */
  near: Resonances | null;
  /** Decided by enclosures and exact arithmetic; in an atlas: `verify` confirms it. */
  proved: boolean;
}

/** Whether a relative equilibrium is stable: in the sense of Lyapunov, at fixed l, modulo rotation about the vertical; of a circle or sphere of them, as a whole. */
export type NonlinearVerdict = "stable" | "unstable" | "open";

/** Why a relative equilibrium has its verdict. */
export type Reason = "energy" | "integral" | "arnold" | "spectrum" | "resonance 1:2" | "resonance 1:3" | "resonance 1:1" | "degenerate";

/** Distances to the resonances, from the coefficients of λ⁴ + bλ² + c; each vanishes at its resonance, to rounding. */
export interface Resonances {
  /** (b² − 4c)/b². */
  "1:1": number;
  /** (4b² − 25c)/b². */
  "1:2": number;
  /** (9b² − 100c)/b². */
  "1:3": number;
}

/** A relative equilibrium with friction that conserves l (Thomson, Tait and Chetaev): it survives exactly at a minimum of U_l. */
export interface Friction {
  /** What it leaves; `null` at a degenerate point that no theorem decides. */
  conserving_l: Damped | null;
  /** Directions that grow: the Morse index. */
  growing: number;
  /** Pairs of `eigenvalues`, each with d Re λ/dδ at δ = 0 for the torque −δA(ω − Ωγ): of an imaginary pair negative exactly if its Krein sign is positive. Without double pairs and zeros; empty along a curve. Computed in doubles: they grow without bound towards a collision of eigenvalues, and lose digits there. */
  rates: [[number, number], number][];
}

/** What friction that conserves l leaves of the stability. */
export type Damped = "survives" | "lost";

/** The asymptote of a curve: h = l²/(2 J) + h0 + O(l⁻²). */
export interface Tail {
  /** J: the moment of inertia of the limiting axis. */
  moment: number;
  /** h0. */
  h_offset: number;
}

/** A point where curves meet. */
export interface Event {
  /** What happens. */
  kind: EventKind;
  /** Vertical angular momentum. */
  l: number;
  /** Energy. */
  h: number;
  /** Ids of the curves that meet. */
  curves: string[];
  /** Bound on the error of `l`; with a certificate at most the width of the enclosure and two roundings of l. */
  l_error: number;
  /** Bound on the error of `h`; with a certificate at most the width of the enclosure and four roundings of `|h| + |r|`. */
  h_error: number;
  /** Proved bounds (certified only). */
  enclosure?: Enclosure;
}

/** Kinds of events of the arrangement. */
export type EventKind = "cusp" | "pitchfork" | "crossing";

/** Proved bounds of a point, as decimals. In l² they are at most as wide as the enclosure of the certificate and four roundings (2⁻⁵²) of l², in h as that and four roundings of `|h| + |r|`. */
export interface Enclosure {
  /** l lies between these; the lower one is not negative. */
  l: [string, string];
  /** h lies between these. */
  h: [string, string];
}

/** A point of a branch at which the linear type changes: a root of the polynomials of Proposition 13.4 of docs/algorithms.md, isolated exactly. */
export interface StabilityChange {
  /** Vertical angular momentum. */
  l: number;
  /** Energy. */
  h: number;
  /** Id of the curve on which it lies; at a cusp or pitchfork the first of the two. */
  curve: string;
  /** Id of the curve that continues after a cusp or pitchfork. */
  onto?: string;
  /** What happens. */
  kind: StabilityChangeKind;
  /** The type at smaller l or, at a cusp or pitchfork, on `curve`. */
  from: Stability;
  /** The type at larger l or, at a cusp or pitchfork, on `onto`. */
  to: Stability;
  /** Bound on the errors of `l` and `h`; with a certificate at most 256 roundings (2⁻⁵²) of `l + |h| + |r|`. */
  error_bound: number;
}

/** How the linear type changes along a branch. The list is open. */
export type StabilityChangeKind = "hamiltonian-hopf" | "real-collision" | "zero";

/** A point of a curve at which a hypothesis of Arnold's theorem fails, whether or not the verdict changes there. */
export interface VerdictChange {
  /** Vertical angular momentum. */
  l: number;
  /** Energy. */
  h: number;
  /** Id of the curve on which it lies. */
  curve: string;
  /** What fails. */
  kind: Failing;
  /** The verdict at the point itself. */
  verdict: NonlinearVerdict;
  /** Why. */
  why: Reason;
  /** The verdicts before and after differ. */
  changes: boolean;
  /** Bound on the errors of `l` and `h`. */
  error_bound: number;
  /** `verify` confirms it. */
  proved: boolean;
}

/** Which of the hypotheses of Arnold's theorem fails. */
export type Failing = "1:1" | "1:2" | "1:3" | "D4";

/** A connected face of the (h, l) half-plane l > 0, on which the topology is constant. */
export interface Region {
  /** Id, unique in the atlas. */
  id: string;
  /** A well-placed point inside. */
  sample: Sample;
  /** The components of U_hl; none where they are not decided (`fast`). */
  components: Component[];
  /** The sections' names joined by `+`; null when r = 0, and where they are not decided (`fast`). */
  signature: string | null;
  /** True when the region is bounded in the (h, l) plane. */
  bounded: boolean;
  /** Range of l; an infinite end is null. */
  l_range: [number | null, number | null];
  /** Ids of the curves on the boundary, each once: below and above each cell, in the order of `cells`. */
  boundary: string[];
  /** The regions across curves of the boundary, one for each region and curve; across a pole line that coincides with another curve none. With a window only listed regions, and the forbidden one. */
  neighbours: Neighbour[];
  /** The cells whose union it is, by rising l, then h. */
  cells: Cell[];
  /** True when a window cuts it. The `sample` of a cut region lies in the window; `cells`, `l_range` and `h_width` are those of the whole. */
  clipped?: boolean;
}

/** A point inside a region, chosen where it is wide relative to the energies there; where no double lies inside, the doubles nearest to a point inside, which the certificate has exactly. */
export interface Sample {
  /** Energy. */
  h: number;
  /** Vertical angular momentum. */
  l: number;
  /** Distance of the exact point to the boundary. With a certificate its `error_bound` holds for the rounded point too, unless a curve begins or ends in between. */
  margin: Margin;
}

/** Distance in h to the nearest curve. With `fast`, curves that begin or end within rounding (1e-14) of l count on both sides; with `exact`, those at l itself. */
export interface Margin {
  /** `|h − h_c|` to the nearest critical curve or pole line at this l. */
  h: number;
  /** Id of that curve; `l=0` at rest without weight, where no curve of the atlas is nearest. */
  nearest: string;
  /** Bound on the error of `h`. */
  error_bound: number;
}

/** One connected component of U_hl with the components of E_hl and P_hl above it. */
export interface Component {
  /** k: the component of U_hl is the sphere without k discs. */
  boundary_circles: number;
  /** The poles inside: `+` for r̂ and `-` for −r̂; null when r = 0. */
  poles: string[] | null;
  /** Its name: `S2` (the sphere), `D2` (a disc), `S2-2D2` (an annulus), … `S2-kD2`. */
  accessible_region: string;
  /** The component of E_hl above it: `RP3`, `S3`, `S1xS2`, `(S1xS2)#(S1xS2)`, `#3(S1xS2)` … `#(k-1)(S1xS2)`. */
  energy_surface: string;
  /** The component of P_hl above it, by genus: `S2`, `T2`, `M2`, `M3`, …; null when r = 0. */
  section: string | null;
  /** Genus of `section`: k + n − 1 with n poles inside; null when r = 0. */
  genus: number | null;
}

/** A region on the other side of a curve. */
export interface Neighbour {
  /** Id of the region; null: the forbidden region below the lowest critical value. */
  region: string | null;
  /** Id of the curve crossed. */
  curve: string;
}

/** A part of a region: all (h, l) between two curves over a range of l that no event divides. */
export interface Cell {
  /** Range of l; an infinite end is null. */
  l_range: [number | null, number | null];
  /** Id of the curve below (to the left in h). */
  lower: string;
  /** Id of the curve above; null: unbounded. */
  upper: string | null;
}

/** Totals of an atlas. */
export interface Summary {
  /** Number of the `regions`. */
  regions: number;
  /** Number of the `events`. */
  events: number;
  /** How many of the `regions` have each signature (for r = 0, each type of U); without a name, those that are not decided. */
  signatures: Record<string, number>;
  /** The largest number of relative equilibria at one l, of the whole half-plane also where a window was searched; a critical circle or sphere counts once. With `fast` it may be too large where events are nearer than f64 resolves. */
  critical_points_max: number;
  /** What could not be decided. */
  undecided: Undecided[];
  /** True when `regions` covers the whole half-plane l > 0 and nothing is undecided; never with a window. */
  complete: boolean;
}

/** Something that this accuracy could not decide. */
export interface Undecided {
  /** What could not be decided, in words. */
  what: string;
  /** Near this l. */
  l: number;
  /** Near this h. */
  h: number;
  /** Ids of the curves concerned. */
  curves: string[];
}

/** What pictures of an atlas show, in f64: no part of a proof. The accuracies hold for all bodies except those whose curves cannot be told apart in doubles, such as rods of 10⁻¹¹ and less. */
export interface Drawing {
  /** Where the diagram is seen; it depends on the body alone. */
  view: View;
  /** By the ids of the curves. */
  curves: Record<string, CurveDrawing>;
  /** By the ids of the regions. */
  regions: Record<string, RegionDrawing>;
}

/** The windows in which a diagram is seen, to 10⁻⁶ of each. */
export interface View {
  /** The default view: all events, and a part of every unbounded region; the `polygon` of each region lies in it. */
  everything: Window;
  /** All events except those far beyond all others. */
  main: Window;
}

/** The drawing of a curve. */
export interface CurveDrawing {
  /** Points [h, l] by rising l, from end to end (none of a curve that has no l in common with the window, if one was asked for, and of a pole line not those where it runs along such a curve); an unbounded curve at least up to l₁, the largest of 1.6 times the l of the last event and 3√(A |r|) with the largest A (|r| here at least the unit of energy of the certificate). No chord leaves its curve by more than 1/800 of l₁²/(2A) + 2|r| in h, measured across the chord in units of that height and of l₁. */
  polyline: [number, number][];
}

/** The drawing of a region. */
export interface RegionDrawing {
  /** The part of the region inside `view.everything` (inside the window, if one was asked for): closed outlines of points [h, l] whose last point is the first; a hole is a separate outline (fill by the even-odd rule). An outline begins at its smallest l, there at the lowest h (to a rounding), and has the region on its left as l runs to the right and h upwards; outlines are ordered by that l, then h. Where two events of the list are at one l, all outlines end at the l of each event. Corners lie on the curves, except where a curve leaves the view. No edge leaves its curve by more than 1/250 of the height of the view in h, or it spans less than 10⁻⁹ of the view's l. */
  polygon: [number, number][][];
  /** The largest extent in h at one l, to 10⁻⁶ of it and 4·10⁻⁹ of |r|; null if unbounded. */
  h_width: number | null;
}

/** A certificate. */
export interface Certificate {
  /** Units of all its numbers. */
  units: CertificateUnits;
  /** Bits of the arithmetic that the proof needed at most. */
  bits: number;
  /** Cusps of the generic family, then those over eigenspaces without r. */
  cusps: CertifiedCusp[];
  /** The place where the slope of the generic family turns, if r lies on no principal plane. */
  inflection?: Place;
  /** Meetings with pole lines. */
  meetings: CertifiedMeeting[];
  /** Orders of pairs of critical curves. Pairs with the global minimum, and of straight lines, need none. */
  pairs: CertifiedPair[];
  /** Events by rising x. */
  events: CertifiedEvent[];
  /** Numbers of the events between each two slabs. */
  transitions: number[][];
  /** Slabs by rising x: one more than transitions. */
  slabs: CertifiedSlab[];
  /** A sample of each region. */
  samples: CertifiedSample[];
  /** SHA-256 of the atlas as compact JSON with this string empty. */
  checksum: string;
}

/** Units of the numbers of a certificate: powers of four. */
export interface CertificateUnits {
  /** Unit of A. */
  moment: string;
  /** Unit of r and h. */
  energy: string;
}

/** An isolated cusp: the only root of the cusp polynomial in its range. */
export interface CertifiedCusp {
  /** Where it is. */
  place: Place;
  /** Ids of the two curves. */
  curves: [string, string];
}

/** A range of places on a family of relative equilibria. */
export interface Place {
  /** Number of an eigenspace of A, by rising moment, from 0. */
  base: number;
  /** `+`: μ = a + y; `-`: μ = a − y; `over`: v = s² = P̂ + y over an eigenspace that carries no r. */
  side: string;
  /** y lies between these. */
  y: [string, string];
}

/** An isolated meeting of a critical curve with a pole line. */
export interface CertifiedMeeting {
  /** `+` or `-`. */
  pole: string;
  /** Where it is on the critical curve. */
  place: Place;
  /** The critical curve; both, if the meeting is exactly at a cusp or pitchfork. */
  curves: string[];
  /** The curves touch and do not cross. */
  touch: boolean;
}

/** The order of two critical curves over all their common range. */
export interface CertifiedPair {
  /** Ids. */
  curves: [string, string];
  /** By rising x, without gaps. */
  stretches: CertifiedStretch[];
}

/** A range of x on which the order of two curves is constant, or changes once. */
export interface CertifiedStretch {
  /** Lower end. */
  from: CertifiedNode;
  /** Upper end. */
  to: CertifiedNode;
  /** Sign of h of the first curve minus h of the second at the lower end. */
  sign: number;
  /** The box in x of the one crossing, if there is one. */
  crossing?: [CertifiedNode, CertifiedNode];
}

/** Where two curves are compared. */
export interface CertifiedNode {
  /** x; absent at the beginning or end of the common range. */
  x?: string;
  /** The places of both curves over x; absent at x → ∞ and at an end that both share. */
  places?: [Place, Place];
}

/** A point where curves meet. */
export interface CertifiedEvent {
  /** What it is: `cusp:N`, `pitchfork:N`, `meeting:N` (numbers from 0 in the lists of the certificate) or `crossing`. Several: they are proved to be one point. */
  sources: string[];
  /** Ids of the curves that meet. */
  curves: string[];
  /** Enclosure of x. */
  x: [string, string];
  /** Enclosure of h. */
  h: [string, string];
}

/** A strip between events: the order of the curves over one abscissa. */
export interface CertifiedSlab {
  /** The abscissa. */
  x: string;
  /** Curves by rising h. */
  curves: CertifiedHeight[];
}

/** A curve over the abscissa of a slab. */
export interface CertifiedHeight {
  /** Id of the curve. */
  curve: string;
  /** Its place over x; absent on a straight line. */
  place?: Place;
  /** Id of the region above. */
  region: string;
}

/** A point at which the topology of a region is proved. */
export interface CertifiedSample {
  /** Id of the region. */
  region: string;
  /** Number of the slab whose abscissa is taken, from 0. */
  slab: number;
  /** Energy. */
  h: string;
}

/** The answer of `classify`. */
export interface Classification {
  /** Version of the documents. */
  schema_version: string;
  /** Version of the program that made it. */
  version: string;
  /** The canonical command that prints the document, made from body and settings. */
  command: string;
  /** A1, A2, A3 as given. */
  A: [string, string, string];
  /** r1, r2, r3 as given. */
  r: [string, string, string];
  /** Energy as given. */
  h: string;
  /** Vertical angular momentum as given. */
  l: string;
  /** What is known of the point. */
  status: Status;
  /** The requested level of accuracy. */
  accuracy: Accuracy;
  /** Id of the region in the body's atlas; null unless regular, with `--no-region`, and where no atlas gives it (`note` says so). */
  region: string | null;
  /** Distance to the nearest curve. */
  margin: Margin;
  /** The components of U_hl (none when forbidden); null when critical or undecided. */
  components: Component[] | null;
  /** The sections' names joined by `+`; null when r = 0, when forbidden, and when no single class is known. */
  signature: string | null;
  /** Each region that meets at a critical or undecided point, once; without an atlas, each class. */
  candidates?: Candidate[];
  /** What of a point is not known or not defined, and why. */
  note?: string;
  /** The part from which A and r were computed, when one was given. */
  part?: Part;
}

/** What is known of a point. */
export type Status = "regular" | "forbidden" | "critical" | "undecided";

/** A region that meets at a critical or undecided point; without an atlas, a class. */
export interface Candidate {
  /** Id of the region; null for the forbidden region, and without an atlas. */
  region: string | null;
  /** `regular`, or `forbidden` for the region below the lowest critical value. */
  status: Status;
  /** The components of U_hl there; none in the forbidden region. */
  components: Component[];
}

/** The answer of `critical`. */
export interface Critical {
  /** Version of the documents. */
  schema_version: string;
  /** Version of the program that made it. */
  version: string;
  /** The canonical command that prints the document, made from body and settings. */
  command: string;
  /** A1, A2, A3 as given. */
  A: [string, string, string];
  /** r1, r2, r3 as given. */
  r: [string, string, string];
  /** Vertical angular momentum as given. */
  l: string;
  /** All relative equilibria, by rising h, then γ lexicographically; a symmetric pair is two entries. */
  critical: RelativeEquilibrium[];
  /** Bound on the error of every `h`. */
  error_bound: number;
  /** True: beside a cusp or pitchfork, points are counted in exact arithmetic. False only where two cusps are closer than 2⁻⁴⁰⁰⁰. */
  complete: boolean;
  /** What could not be decided, in words. */
  note?: string;
  /** The part from which A and r were computed, when one was given. */
  part?: Part;
}

/** A relative equilibrium: the body turns about the vertical γ with constant angular velocity ω γ. */
export interface RelativeEquilibrium {
  /** Energy h = U_l(γ). */
  h: number;
  /** The vertical in body coordinates. */
  gamma: [number, number, number];
  /** Angular velocity l / J(γ), with the sign of l. */
  omega: number;
  /** Negative eigenvalues of the Hessian of U_l, the Morse index: 0 minimum, 1 saddle, 2 maximum (unless it is degenerate, which `multiplicity` 2 says); for a circle, of its one normal direction (0 also where that is degenerate, at a cusp). */
  index: number;
  /** 1: a critical point; 2: a degenerate one, exactly at a cusp, where two meet in it, at a pitchfork, where three do, or one and a circle, or where a cusp lies at a pitchfork, where more do; `circle` or `sphere`: all points of one, of which `gamma` is one. */
  multiplicity: Multiplicity;
  /** Linear type of the flow reduced by l. */
  stability: Stability;
  /** The reason for its stability, if known: `nonlinear` in one word. */
  stable: Verdict;
  /** The verdict on its stability, with its reason. */
  nonlinear: Nonlinear;
  /** What friction leaves of it. */
  friction: Friction;
  /** The two of ±λ₁, ±λ₂ with re ≥ 0 and im ≥ 0, as [re, im], real ones first, then by size. A complex quadruple gives the same pair twice; a circle its transverse pair, then [0, 0]. */
  eigenvalues: [[number, number], [number, number]];
  /** Bound on the error of each of the four numbers. */
  eigenvalue_error: number;
  /** Id of the curve on which it lies. */
  branch: string;
  /** Its branch in words. */
  branch_name: string;
}

/** What an entry stands for: 1, a critical point; 2, a degenerate one, exactly at a cusp, where two critical points meet in it, or at a pitchfork, where three do, or a point and a circle; or a circle or sphere, of which `gamma` is one point. */
export type Multiplicity = number | "circle" | "sphere";

/** What is known of the stability; of a circle or sphere as a whole (Proposition 13.6 of docs/mathematics.md). */
export type Verdict = "energy" | "integral" | "arnold" | "spectrum" | false | null;

/** The largest deviation of each first integral from its value at the start. */
export interface Drift {
  /** Of H. */
  h: number;
  /** Of ⟨γ,l⟩. */
  l: number;
  /** Of ⟨γ,γ⟩. */
  gamma: number;
}

/** One orbit. */
export interface Orbit {
  /** Its number, as in the data. */
  orbit: number;
  /** Number in `components`, from 0, of the component that holds its start; null if it is not known. */
  component: number | null;
  /** ϑ' of its start. */
  theta: number;
  /** ψ' of its start. */
  psi: number;
  /** Sheet of its start, ±1. */
  sheet: number;
  /** Crossings; the start is not counted. */
  crossings: number;
  /** Why it ended. */
  end: EndName;
  /** What stopped the integrator. */
  failure?: string;
  /** Time until which it was followed. */
  time: number;
  /** Steps of the integrator. */
  steps: number;
  /** Extrema of S whose sign is within rounding: a pair of crossings may be missing or spurious there. */
  tangencies: number;
  /** The largest deviations of the first integrals, over the crossings. */
  drift: Drift;
  /** The largest |S| at a crossing. */
  residual: number;
  /** Regular, chaotic, or open. */
  verdict: VerdictName;
  /** Why, in words. */
  reason: string;
  /** Where it was decided; absent where it is open. */
  decided?: Decided;
  /** How regular it is, if requested. */
  chaos?: Chaos;
}

/** Why an orbit ended. */
export type EndName = "crossings" | "time" | "decided" | "stays-on-section" | "failed" | "interrupted";

/** Whether an orbit is regular or chaotic. Chaotic is not unstable: an unstable periodic orbit is not chaotic. */
export type VerdictName = "regular" | "chaotic" | "open";

/** Where a verdict was decided: the time of the deciding test, and the last crossing before it. An orbit that is followed further keeps it. */
export interface Decided {
  /** Time since the start. */
  time: number;
  /** Number of the last crossing before it. */
  crossing: number;
}

/** How regular an orbit is. */
export interface Chaos {
  /** The largest Lyapunov exponent; null for an orbit of no duration, with fewer than 24 returns, or that was not finished. */
  lyapunov: Lyapunov | null;
  /** The rotation number; null if undefined. */
  rotation: Rotation | null;
  /** Why there is no rotation number. */
  no_rotation?: string;
  /** The evidence for the verdict: the three tests that decided it; where it is open, the last three. Empty for an orbit that was too short or not finished. */
  evidence: Evidence[];
}

/** The largest Lyapunov exponent of an orbit over a finite time T, per unit of time. */
export interface Lyapunov {
  /** λ(T) = ln(|δ(T)|/|δ(0)|)/T; of regular orbits it falls like ln(T)/T. */
  exponent: number;
  /** λ(T/2), to show how much it still changes. */
  exponent_half: number;
  /** The weighted mean of d ln|δ|/dt, which converges faster for regular orbits. */
  mean_rate: number;
  /** The same over [0, T/2]. */
  mean_rate_half: number;
  /** T. */
  time: number;
}

/** The rotation number of an orbit's return map. */
export interface Rotation {
  /** Turns per return, in [0, 1/2]. */
  number: number;
  /** How far the two halves of the returns disagree; 0 for a chain of islands. */
  error: number;
  /** The angle that was averaged: ψ′, the angle about the mean, the curve's own parameter, or none for islands. */
  angle: RotationAngleName;
  /** Length of the chain of islands (or of the periodic orbit). */
  islands?: number;
  /** Number of returns. */
  returns: number;
}

/** Which angle turns. */
export type RotationAngleName = "axis" | "mean" | "curve" | "islands";

/** A test of an orbit at one time T: means over the windows [T/4, 5T/8] and [5T/8, T] with the weight (u(1−u))⁸. */
export interface Evidence {
  /** T. */
  time: number;
  /** How far the means of γ over the two windows are apart, in units of the spread of γ. */
  apart: number;
  /** How much ln|δ| grows in each of them: the mean of d ln|δ|/dt times its length; about 0.87 and 0.46 where |δ| grows linearly. */
  growth: [number, number];
  /** ln(|δ(T)|/|δ(0)|). */
  log: number;
}
