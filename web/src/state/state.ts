/** What the page shows: everything that a permalink carries. */
import type { Triple, Window } from "../bindings/documents";
import type { Assignment } from "./task";

/** A point of the diagram, as exact texts. */
export interface Point {
  h: string;
  l: string;
}

export const PANELS = ["diagram", "sphere", "motion", "section", "bodies"] as const;
export type Panel = (typeof PANELS)[number];
export type Embedded = "diagram" | "section" | "motion";
export type Theme = "dark" | "light";
export type Coloring = "orbit" | "verdict" | "lyapunov" | "rotation";

export interface State {
  A: Triple;
  r: Triple;
  point: Point | null;
  /** What the diagram shows; null: what suits the body. */
  view: Window | null;
  /** Whether the diagram is straightened: then it is all to be seen. */
  straight: boolean;
  /** Whether the chaotic share is shown over the diagram, and of which component of E. */
  chaos: boolean;
  component: number;
  orbits: number;
  crossings: number;
  seed: number;
  coloring: Coloring;
  theme: Theme | null;
  embed: Embedded | null;
  /** The panel that fills the screen. */
  present: Panel | null;
  /** The step of the tour that is open, from 1. */
  tour: number | null;
  lesson: string | null;
  /** A lecturer's task, from a link. */
  task: Assignment | null;
  /** A1, A2, A3, r1, r2, r3 of a body whose diagram stands beside. */
  beside: string | null;
}

/** The paper's body. */
export const FIRST: State = {
  A: ["2", "1.1", "1"],
  r: ["0.94868", "0", "0.61623"],
  point: null,
  view: null,
  straight: false,
  chaos: false,
  component: 0,
  orbits: 24,
  crossings: 500,
  seed: 0,
  coloring: "orbit",
  theme: null,
  embed: null,
  present: null,
  tour: null,
  lesson: null,
  task: null,
  beside: null,
};

/** What an address without a state shows: the paper's body where U falls into two discs. */
export const START: State = { ...FIRST, point: { h: "3.8", l: "3.25" } };

/** A body as the workers read it. */
export const bodyText = ({ A, r }: Pick<State, "A" | "r">): string => `A=${A.join(",")}&r=${r.join(",")}`;

/** The same as the address has it of a body beside. */
export const besideText = ({ A, r }: Pick<State, "A" | "r">): string => [...A, ...r].join(",");
