/** Names of regions in the diagram: the id and the type, in a few forms. */
import type { Region } from "../bindings/documents";
import { surface } from "./numbers";
import type { Boxes } from "./places";

export const typeOf = (region: Region): string => region.signature ?? region.components.map((component) => component.accessible_region).join("+");

/** The id and the type. */
export const nameOf = (region: Region): [id: string, type: string] => [region.id, typeOf(region).split("+").map(surface).join("+")];

/** Pixels that a letter takes at most on average, and between two lines. */
const [LETTER, LINE] = [7, 15];

/** Boxes of the name on two lines and on one, and of the id alone. */
export function boxesOf(region: Region): Boxes {
  const [id, type] = nameOf(region).map((text) => LETTER * text.length + 6) as [number, number];
  return [[Math.max(id, type), 2 * LINE + 4], [id + type - 2, LINE + 4], [id, LINE + 3]];
}
