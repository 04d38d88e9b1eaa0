/** What was computed of the state. */
import type { Atlas, Classification, Component, Window } from "../bindings/documents";

/** What the diagram draws. */
export interface Drawn {
  document: Atlas;
  window: Window;
  rows: Float64Array;
  rowCount: number;
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

export const NOTHING: Known = { status: "open", region: null, signature: "", components: null, margin: null, exact: false };
