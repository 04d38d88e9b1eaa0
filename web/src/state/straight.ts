/** The straightened plane: l to the right, h upwards from the level lowest curve, as the module lays it out. Between the energies that it
 * gives for a column everything is linear. */
import type { StraightDrawing } from "../bindings/calls";
import type { Chart, Line, Spot } from "./chart";
import { rounded } from "./numbers";
import type { Point } from "./state";

/** What lies over one momentum: energies that rise, their y, and the region above each; above the highest curve steps towards infinity. */
interface Column {
  x: number;
  l: number;
  h: number[];
  y: number[];
  region: number[];
}

export class StraightChart implements Chart {
  readonly width: number;
  readonly height: number;
  readonly regions: Int16Array;
  private readonly columns: Column[] = [];

  constructor(readonly drawing: StraightDrawing) {
    const { columns: numbers, width, height } = drawing;
    [this.width, this.height] = [width, height];
    for (let at = 0; at < numbers.length; ) {
      const column: Column = { x: numbers[at]!, l: numbers[at + 1]!, h: [], y: [], region: [] };
      const count = numbers[at + 2]!;
      at += 3;
      for (let k = 0; k < count; k++, at += 3) {
        column.h.push(numbers[at]!);
        column.y.push(numbers[at + 1]!);
        column.region.push(numbers[at + 2]!);
      }
      const steps = numbers[at++]!;
      const top = column.y.at(-1) ?? 0;
      // The first is the highest curve itself.
      for (let k = 1; k < steps; k++) {
        column.h.push(numbers[at + k]!);
        column.y.push(top * (1 - k / steps));
        column.region.push(column.region.at(-1)!);
      }
      at += steps;
      this.columns.push(column);
    }
    this.regions = new Int16Array(width * height).fill(-1);
    // There may be fewer columns than pixels: between two events that are a few units of the last place apart there are no more momenta.
    for (let x = 0; x < width; x++) this.paint(this.columnAt(x + 0.5), x);
  }

  place(h: number, lv: number): Spot | null {
    const { columns, drawing } = this;
    const l = Math.abs(lv);
    if (l > drawing.end || columns.length === 0) return null;
    const next = first(columns.length, (k) => columns[k]!.l >= l);
    const [right, left] = [columns[Math.min(next, columns.length - 1)]!, columns[Math.max(0, next - 1)]!];
    const share = right.l > left.l ? Math.min(1, Math.max(0, (l - left.l) / (right.l - left.l))) : 1;
    // A column at the very momentum knows best.
    const [from, to] = share === 1 ? [heightIn(right, h), heightIn(right, h)] : [heightIn(left, h), heightIn(right, h)];
    if (from === null || to === null) return null;
    return [left.x + share * (right.x - left.x), from + share * (to - from)];
  }

  value(x: number, y: number): [h: number, l: number] | null {
    const column = this.columnAt(x);
    const h = column ? energyIn(column, y) : null;
    return column && h !== null ? [h, column.l] : null;
  }

  rounded(x: number, y: number): Point | null {
    const column = this.columnAt(x);
    const h = column ? energyIn(column, y) : null;
    if (!column || h === null) return null;
    const beside = [y - 0.5, y + 0.5].map((y) => energyIn(column, y) ?? h);
    // Half a pixel on the side where it is less: between curves that are close it stays between them.
    const step = Math.min(...beside.map((other) => Math.abs(other - h)).filter((far) => far > 0), Math.abs(h) || 1);
    return { h: rounded(h, step / 2), l: String(column.l) };
  }

  pixels(h: number, l: number, distance: number): number {
    const spots = [h, h - distance, h + distance].map((h) => this.place(h, l));
    const far = spots.slice(1).map((spot) => (spot && spots[0] ? Math.abs(spot[1] - spots[0][1]) : Infinity));
    return Math.min(...far);
  }

  /** Whether there is a column at this momentum, so that a place there is as exact as its curves. */
  knows(l: number): boolean {
    const at = Math.abs(l);
    const found = this.columns[first(this.columns.length, (k) => this.columns[k]!.l >= at)];
    return at > this.drawing.end || found?.l === at;
  }

  line = (points: Float64Array): Line => points;

  events = (): (Spot | null)[] => {
    const { events } = this.drawing;
    return Array.from({ length: events.length / 2 }, (_, k) => (Number.isNaN(events[2 * k]!) ? null : [events[2 * k]!, events[2 * k + 1]!]));
  };

  private columnAt(x: number): Column | undefined {
    const { columns } = this;
    const next = first(columns.length, (k) => columns[k]!.x >= x);
    const [left, right] = [columns[next - 1], columns[next]];
    return left && (!right || x - left.x < right.x - x) ? left : right;
  }

  private paint(column: Column | undefined, x: number): void {
    const { y, region } = column ?? { y: [], region: [] };
    for (let k = 0; k < y.length; k++) {
      const [top, bottom] = [Math.round(y[k + 1] ?? 0), Math.round(y[k]!)];
      for (let row = top; row < bottom; row++) this.regions[row * this.width + x] = region[k]!;
    }
  }
}

/** y of an energy; null below the lowest curve. */
function heightIn({ h, y }: Column, energy: number): number | null {
  const above = first(h.length, (k) => h[k]! > energy);
  if (above === 0) return null;
  // Beyond the last step it is as good as at the edge.
  if (above === h.length) return y[above - 1]! / 2;
  return y[above - 1]! + (y[above]! - y[above - 1]!) * ((energy - h[above - 1]!) / (h[above]! - h[above - 1]!));
}

/** The energy at a height; null below the lowest curve. */
function energyIn({ h, y }: Column, at: number): number | null {
  const above = first(y.length, (k) => y[k]! < at);
  if (above === 0) return null;
  if (above === y.length) return h[above - 1]!;
  return h[above - 1]! + (h[above]! - h[above - 1]!) * ((at - y[above - 1]!) / (y[above]! - y[above - 1]!));
}

/** The first number below `count` that is so, where all after it are too; `count` if none is. */
function first(count: number, is: (k: number) => boolean): number {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (is(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
