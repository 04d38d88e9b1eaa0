/** The picture of a map of bodies. */
import { Pixels, ticks, type Pen, type Size } from "../draw/canvas";
import { ink, type Ink, type Rgb } from "../draw/theme";
import type { State } from "../state/state";
import type { Border } from "./borders";
import { FINEST, type Cells } from "./cells";
import type { Family } from "./families";

/** Colours of classes in the order in which they are met; told apart by lightness as well as by hue. */
const COLORS: Rgb[] = [[86, 180, 233], [230, 159, 0], [0, 158, 115], [204, 121, 167], [240, 228, 66], [0, 114, 178], [213, 94, 0], [150, 150, 150], [170, 110, 60], [120, 200, 190], [190, 170, 230], [110, 130, 60]];

export interface Box {
  x: number;
  y: number;
  side: number;
}

export const boxOf = ({ width, height }: Size): Box => {
  const side = Math.max(20, Math.min(width - 60, height - 44));
  return { x: 46 + (width - 60 - side) / 2, y: 8, side };
};

let scratch: Pixels | undefined;

export function paintBodies(pen: Pen, size: Size, state: State, family: Family, cells: Cells, borders: Border[]): void {
  const colors = ink();
  const box = boxOf(size);
  scratch ??= new Pixels();
  const image = scratch.sized(FINEST, FINEST);
  image.data.fill(0);
  for (let at = 0; at < FINEST * FINEST; at++) {
    const cell = cells.nearest(at);
    if (!cell || cell.class === -2) continue;
    const color: Rgb = cell.class < 0 ? [120, 120, 120] : COLORS[cell.class % COLORS.length]!;
    const shade = (cell.class >= COLORS.length ? 0.7 : 1) * (colors.dark ? 0.75 : 1);
    const to = 4 * ((FINEST - 1 - Math.floor(at / FINEST)) * FINEST + (at % FINEST));
    for (let i = 0; i < 3; i++) image.data[to + i] = color[i]! * shade;
    image.data[to + 3] = 255;
  }
  pen.imageSmoothingEnabled = false;
  scratch.draw(pen, box.x, box.y, box.side, box.side);
  axes(pen, family, box, colors);
  const spot = (x: number, y: number, radius: number, color: string) => {
    const across = (value: number, [from, to]: [number, number]) => ((value - from) / (to - from)) * box.side;
    pen.beginPath();
    pen.arc(box.x + across(x, family.x), box.y + box.side - across(y, family.y), radius, 0, 2 * Math.PI);
    pen.fillStyle = color;
    pen.strokeStyle = colors.paper;
    pen.lineWidth = 2;
    pen.fill();
    pen.stroke();
  };
  for (const { x, y } of borders) spot(x, y, 4, colors.text);
  const place = family.place(state);
  if (place) spot(...place, 6, colors.accent);
}

function axes(pen: Pen, family: Family, { x, y, side }: Box, colors: Ink): void {
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.strokeRect(x, y, side, side);
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  for (const { value, text } of ticks(...family.x, 4)) pen.fillText(text, x + ((value - family.x[0]) / (family.x[1] - family.x[0])) * side, y + side + 14);
  pen.fillText(family.axes()[0], x + side / 2, y + side + 28);
  pen.textAlign = "right";
  for (const { value, text } of ticks(...family.y, 4)) pen.fillText(text, x - 5, y + side - ((value - family.y[0]) / (family.y[1] - family.y[0])) * side + 4);
  pen.save();
  pen.translate(x - 34, y + side / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText(family.axes()[1], 0, 0);
  pen.restore();
}
