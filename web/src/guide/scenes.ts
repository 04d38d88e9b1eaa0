/** The scenes of the story. */
import { START, type State } from "../state/state";

export interface Scene {
  seconds: number;
  text: string;
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
  { seconds: 7, panel: "motion", state: { point: START.point }, text: "A heavy body turns about a fixed point. The red line shows where the vertical has pierced it." },
  { seconds: 7, panel: "section", text: "Whenever its centre of mass is highest or lowest, a motion leaves a dot. Dots along a curve belong to a regular motion." },
  { seconds: 7, panel: "sphere", text: "Seen from the body, the vertical wanders on a sphere. The energy keeps it in the coloured part: here one of two discs." },
  { seconds: 7, panel: "diagram", text: "Energy h and momentum l are conserved: one point of this diagram. All motions in a tinted region have the same shape." },
  { seconds: 9, panel: "diagram", state: { point: START.point, view: VIEW }, point: [Number(HERE.h), Number(HERE.l)], text: "As the point crosses a curve, the shape changes: the two discs join, and the section gets two handles." },
  { seconds: 9, panel: "diagram", state: { point: START.point, view: { h: [-2, 14], l: [0, 6] } }, r: [0.7, 0.3, 0.65], text: "Another centre of mass, another diagram. In grey: where the curves were." },
  { seconds: 7, panel: "section", state: { point: { h: "6", l: "2" }, coloring: "verdict" }, text: "With more energy many motions are chaotic: their dots fill areas." },
  { seconds: 7, panel: "section", state: { A: ["2", "2", "1"], r: ["1", "0", "0"], point: { h: "2", l: "1" } }, text: "Kovalevskaya’s top is the exception: it has one more conserved quantity, and no chaos at all. Now it is your turn." },
];
