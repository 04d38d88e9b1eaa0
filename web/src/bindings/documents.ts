/** The documents as the page receives them, and what it exchanges beside them. */
import type { Atlas as AtlasDocument, Body, Drawing, Part, VerdictName } from "./schema";

export type { Classification, Component, Critical, Curve, Orbit, Reason, Region, RelativeEquilibrium, Window } from "./schema";

export type Triple = Part["A"];

/** The page asks for no atlas without its drawing. */
export type Atlas = AtlasDocument & { drawing: Drawing };

/** A real part as it was understood. */
export type PartBlock = Part;

/** What is special about a body. */
export type Flags = Omit<Body, "A" | "r" | "part">;

export type Verdict = VerdictName;

export type Loop = [number, number][];

/** What the two halves of the section look like before any orbit; each pair is [T⁻, T⁺]. */
export interface Portrait {
  accessible: Loop[];
  incoming: [Loop[], Loop[]];
  boundary: Loop[];
  tangency: [Loop[], Loop[]];
  sphere: [number, number, number][][];
}
