/** What was computed of the state. */
import type { Place } from "../bindings/calls";
import type { Atlas, Classification, Component, Window } from "../bindings/documents";
import type { PlaneChart } from "./chart";
import type { StraightChart } from "./straight";

/** What the diagram draws. */
export interface Drawn {
  document: Atlas;
  /** A and r of it. */
  numbers: number[];
  window: Window;
  chart: PlaneChart | StraightChart;
  /** Curves by their names, as `chart.line` takes them. */
  curves: Map<string, Float64Array>;
}

/** What is known of the point (h, l). */
export interface Known {
  status: Classification["status"] | "open";
  region: string | null;
  signature: string;
  components: Component[] | null;
  margin: { h: number; nearest: string } | null;
  exact: boolean;
}

/** Curves of the body before, which stay in sight for a while so that one sees what moved. */
export interface Shadow {
  curves: Map<string, Float64Array>;
  /** They are points of the straightened plane. */
  straight: boolean;
}

export const NOTHING: Known = { status: "open", region: null, signature: "", components: null, margin: null, exact: false };

/** At a place of a fast document. */
export function knownAt({ regions }: Atlas, { region: number, distance, nearest }: Place): Known {
  const region = regions[number];
  return {
    status: region ? "regular" : number === -1 ? "forbidden" : "undecided",
    region: region?.id ?? null,
    signature: region?.signature ?? "",
    components: number === -1 ? [] : (region?.components ?? null),
    margin: { h: distance, nearest },
    exact: false,
  };
}
