/** What a worker can be asked, and what it answers. */
import type { Orbit, Portrait, Triple, Window } from "./documents";

export interface Drawing {
  /** The fast document, as text. */
  text: string;
  window: Window;
  width: number;
  height: number;
  /** The rows of the picture from the lowest l: see `Diagram.columns`; none of the straightened plane. */
  rows: Float64Array;
  /** Names of curves, and their points as `Diagram.curves` has them, or `Straight.curves`. */
  names: string[];
  curves: Float64Array;
  /** The straightened plane, where it was asked for; a text says why there is none. */
  straight: StraightDrawing | string | null;
  /** What lies at the point, where one was given. */
  place: Place | null;
}

/** What `Straight` has of a panel. */
export interface StraightDrawing {
  width: number;
  height: number;
  shares: Float64Array;
  columns: Float64Array;
  events: Float64Array;
  levels: Float64Array;
  /** Round numbers of l, of h at l = 0, of h at the last l: where in pixels, and their texts. */
  ticks: { at: Float64Array; texts: string[] }[];
  /** The last l. */
  end: number;
}

/** How the plane is straightened: by shares that are kept (none: by the best), with columns at these momenta beside those of the pixels. */
export interface Straightening {
  held: Float64Array;
  momenta: Float64Array;
}

export interface Place {
  region: number;
  distance: number;
  nearest: string;
}

export interface Opened {
  axes: Float64Array;
  starts: Float64Array;
  portrait: Portrait;
}

/** Crossings as `Section.follow` has them, and how long they took in the worker. */
export interface Followed {
  rows: Float64Array;
  seconds: number;
}

/** A body and a point that have a section. */
export type Site = [body: string, h: string, l: string];

/** The name of a call to its arguments and its answer. */
export interface Calls {
  draw: [[body: string, view: Window | null, width: number, height: number, point: [h: number, l: number] | null, straight: Straightening | null], Drawing];
  locate: [[body: string, h: number, l: number], Place];
  surgeries: [[body: string, from: [h: number, l: number], to: [h: number, l: number]], string[]];
  partOfFile: [[name: string, bytes: Uint8Array, density: string, mass: string, units: string, pivot: string], string];
  partOfTensor: [[tensor: string, integral: boolean, aboutCom: boolean, com: string, mass: string, units: string], string];
  atlas: [[body: string], string];
  classify: [[body: string, h: string, l: string], string];
  critical: [[body: string, l: string], string];
  open: [[site: Site, orbits: number, seed: number], Opened];
  follow: [[site: Site, starts: Float64Array, first: number, crossings: number], Followed];
  judge: [[site: Site, starts: Float64Array, crossings: number], Orbit[]];
  parts: [[site: Site, gammas: Float64Array], Int32Array];
  motion: [[site: Site, theta: number, psi: number, sheet: number, times: Float64Array], Float64Array];
  tile: [[A: Triple, r: Triple, window: number[], cells: [number, number], tile: number, error: number, steps: number], Float64Array];
  border: [[from: Float64Array, to: Float64Array], { t: number; error: number; text: string }];
  classes: [[bodies: Float64Array], { found: Int32Array; names: string[] }];
}

export type Name = keyof Calls;
export type Arguments<N extends Name> = Calls[N][0];
export type Answer<N extends Name> = Calls[N][1];

export interface Question {
  id: number;
  name: Name;
  values: unknown[];
}

export type Reply = { id: number; value: unknown } | { id: number; error: string; trapped: boolean };
