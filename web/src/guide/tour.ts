/** Eight steps through the paper; each is a state of the page, set over the first one. What to see in it is among the texts. */
import type { State } from "../state/state";

const KOVALEVSKAYA: Pick<State, "A" | "r"> = { A: ["2", "2", "1"], r: ["1", "0", "0"] };
const LAGRANGE: Pick<State, "A" | "r"> = { A: ["2", "1", "1"], r: ["1", "0", "0"] };

export const TOUR: Partial<State>[] = [
  {},
  { view: { h: [0.5, 6], l: [1.7, 4] } },
  { point: { h: "3.8", l: "3.25" } },
  { point: { h: "3.8", l: "3.25" }, seed: 1 },
  { point: { h: "3.53", l: "2.862" }, view: { h: [2.6, 4.6], l: [2.3, 3.4] } },
  { ...KOVALEVSKAYA, point: { h: "2", l: "1" } },
  { ...LAGRANGE, point: { h: "2.1", l: "2.05" }, view: { h: [1.4, 2.8], l: [1.6, 2.4] } },
  { point: { h: "6", l: "2" }, coloring: "verdict" },
];
