/** The parts of the command line's documents that the page reads. */

export type Triple = [string, string, string];

/** A part of the (h, l) plane. */
export interface Window {
  h: [number, number];
  l: [number, number];
}

export interface Component {
  boundary_circles: number;
  poles: ("+" | "-")[] | null;
  accessible_region: string;
  energy_surface: string;
  section: string | null;
  genus: number | null;
}

export interface StabilitySpan {
  l_from: number;
  l_to: number;
  stability: string;
}

export interface Curve {
  id: string;
  kind: string;
  branch: string;
  index: number | null;
  multiplicity: number;
  coincides_with: string[];
  l_range: [number | null, number | null];
  stability: StabilitySpan[];
}

export interface AtlasEvent {
  kind: string;
  l: number;
  h: number;
  curves: string[];
}

export interface Region {
  id: string;
  sample: { h: number; l: number };
  components: Component[];
  signature: string | null;
  bounded: boolean;
  l_range: [number | null, number | null];
}

export interface Flags {
  unphysical: boolean;
  symmetric: boolean;
  axis: boolean;
  euler: boolean;
}

/** What pictures show; `view`: where the diagram is seen. */
export interface Picture {
  view: { everything: Window; main: Window };
  curves: Record<string, { polyline: [number, number][] }>;
}

export interface Atlas {
  accuracy: string;
  command?: string;
  body: { A: Triple; r: Triple } & Flags;
  curves: Curve[];
  events: AtlasEvent[];
  regions: Region[];
  summary: { regions: number; complete: boolean };
  drawing: Picture;
}

/** A real part as it was understood. */
export interface PartBlock {
  A: Triple;
  r: Triple;
  mass: string;
  g: string;
  units: string;
  exact: boolean;
  principal_com: { moments: [number, number, number] };
}

export interface Classification {
  h: string;
  l: string;
  status: "regular" | "forbidden" | "critical" | "undecided";
  region: string | null;
  margin: { h: number; nearest: string; error_bound: number };
  components: Component[] | null;
  note?: string;
}

export interface Equilibrium {
  h: number;
  gamma: [number, number, number];
  omega: number;
  index: number;
  multiplicity: number | string;
  stability: string;
  stable?: string | false | null;
  eigenvalues?: [number, number][];
  branch: string | null;
}

export interface Critical {
  l: string | number;
  critical: Equilibrium[];
}

export type Verdict = "regular" | "chaotic" | "open";

/** An orbit of a section. */
export interface Orbit {
  orbit: number;
  verdict: Verdict;
  reason: string;
  chaos?: { lyapunov: { exponent: number } | null; rotation: { number: number } | null };
}

export type Loop = [number, number][];

/** What the two halves of the section look like before any orbit; each pair is [T⁻, T⁺]. */
export interface Portrait {
  accessible: Loop[];
  incoming: [Loop[], Loop[]];
  boundary: Loop[];
  tangency: [Loop[], Loop[]];
  sphere: [number, number, number][][];
}
