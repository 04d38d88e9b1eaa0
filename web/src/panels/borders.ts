/** Where the class changes to the left, right, above and below the present body: found exactly when the hand rests. */
import type { Channel } from "../bindings/client";
import { shown } from "../state/numbers";
import type { State } from "../state/state";
import type { Family } from "./families";

export interface Border {
  x: number;
  y: number;
  text: string;
}

/** `classAt` tells the class of the map's cell at a place; `cell` is the width of one. */
export async function bordersOf(channel: Channel, family: Family, body: Pick<State, "A" | "r">, classAt: (x: number, y: number) => number | undefined, cells: number): Promise<Border[]> {
  const place = family.place(body);
  if (!place) return [];
  const own = classAt(...place);
  if (own === undefined || own < 0) return [];
  const steps = [(family.x[1] - family.x[0]) / cells, (family.y[1] - family.y[0]) / cells] as const;
  const found: Border[] = [];
  for (const [axis, sign] of [[0, -1], [0, 1], [1, -1], [1, 1]] as const) {
    const at = (k: number): [number, number] => (axis === 0 ? [place[0] + sign * k * steps[0], place[1]] : [place[0], place[1] + sign * k * steps[1]]);
    let k = 1;
    while (k < cells && classAt(...at(k)) === own) k++;
    const other = classAt(...at(k));
    const [from, to] = [family.numbers(...at(0), body), family.numbers(...at(k), body)];
    if (other === undefined || other < 0 || !from || !to) continue;
    const border = await channel.ask("border", Float64Array.from(from), Float64Array.from(to)).catch(() => null);
    if (!border) continue;
    const [x, y] = at(border.t * k);
    found.push({ x, y, text: `${family.axes()[axis]} = ${shown(axis === 0 ? x : y, 8)}: ${border.text}` });
  }
  return found;
}
