/** The point that the page chooses where none is given. */
import type { Drawn } from "./known";
import { places } from "./places";
import { bodyText, START, type Point, type State } from "./state";

/** It is at least so many pixels from every curve, if one is. */
const CLEAR = 8;

/** Deep inside a region over which U has many components; of the paper's body the one that the page begins with. */
export function chosenPoint(state: State, { document: { regions }, chart }: Drawn): Point | null {
  const worth = (region: number, depth: number) => (depth < CLEAR ? 0 : (regions[region]?.components.length ?? 0) * (regions[region]?.signature ? 10 : 1)) + depth / 1e4;
  const [best] = [...places(chart, [])].sort(([a, { depth: x }], [b, { depth: y }]) => worth(b, y) - worth(a, x));
  if (!best) return null;
  const [, { x, y }] = best;
  return bodyText(state) === bodyText(START) && !state.view ? START.point : chart.rounded(x, y);
}
