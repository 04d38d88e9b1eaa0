/** What the page shows: everything that a permalink carries. */
import type { Triple, Window } from "../bindings/documents";

/** A point of the diagram, as exact texts. */
export interface Point {
  h: string;
  l: string;
}

export type Panel = "diagram" | "section" | "motion";
export type Theme = "dark" | "light";
export type Coloring = "orbit" | "verdict" | "lyapunov" | "rotation";

export interface State {
  A: Triple;
  r: Triple;
  point: Point | null;
  /** What the diagram shows; null: what suits the body. */
  view: Window | null;
  orbits: number;
  crossings: number;
  seed: number;
  coloring: Coloring;
  theme: Theme | null;
  embed: Panel | null;
  /** The step of the tour that is open, from 1. */
  tour: number | null;
  lesson: string | null;
}

/** The paper's body. */
export const FIRST: State = {
  A: ["2", "1.1", "1"],
  r: ["0.94868", "0", "0.61623"],
  point: null,
  view: null,
  orbits: 24,
  crossings: 500,
  seed: 0,
  coloring: "orbit",
  theme: null,
  embed: null,
  tour: null,
  lesson: null,
};

/** A body as the workers read it. */
export const bodyText = ({ A, r }: Pick<State, "A" | "r">): string => `A=${A.join(",")}&r=${r.join(",")}`;
