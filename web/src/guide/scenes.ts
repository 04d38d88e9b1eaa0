/** The scenes of the story, without their texts. */
import { START, type State } from "../state/state";

export interface Scene {
  seconds: number;
  /** The panel that the scene is about. */
  panel: string;
  state?: Partial<State>;
  /** What a hand does from the scene's state on: the point or r moves there. */
  point?: [h: number, l: number];
  r?: [number, number, number];
}

const HERE = { h: "3.53", l: "2.862" };
const VIEW: State["view"] = { h: [1, 6], l: [1.7, 4] };

export const STORY: Scene[] = [
  { seconds: 7, panel: "motion", state: { point: START.point } },
  { seconds: 7, panel: "section" },
  { seconds: 7, panel: "sphere" },
  { seconds: 7, panel: "diagram" },
  { seconds: 9, panel: "diagram", state: { point: START.point, view: VIEW }, point: [Number(HERE.h), Number(HERE.l)] },
  { seconds: 9, panel: "diagram", state: { point: START.point, view: { h: [-2, 14], l: [0, 6] } }, r: [0.7, 0.3, 0.65] },
  { seconds: 7, panel: "section", state: { point: { h: "6", l: "2" }, coloring: "verdict" } },
  { seconds: 7, panel: "section", state: { A: ["2", "2", "1"], r: ["1", "0", "0"], point: { h: "2", l: "1" } } },
];
