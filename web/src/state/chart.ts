/** How the (h, l) half-plane lies in the diagram's panel, in pixels from the upper left corner of its frame. */
import type { Atlas, Window } from "../bindings/documents";
import { rounded } from "./numbers";
import type { Point } from "./state";

export type Spot = [x: number, y: number];

/** A polyline as l, x, y of each of its points. */
export type Line = Float64Array;

export interface Chart {
  readonly width: number;
  readonly height: number;
  /** The number of the region of each pixel, row by row from above; −1 below all curves. */
  readonly regions: Int16Array;
  /** Where a point lies; null where it has no place. */
  place(h: number, l: number): Spot | null;
  /** What lies there; null where no point does. */
  value(x: number, y: number): [h: number, l: number] | null;
  /** The same in as few digits as a hand there can mean. */
  rounded(x: number, y: number): Point | null;
  /** How many pixels a distance in h is at a point. */
  pixels(h: number, l: number, distance: number): number;
  /** A curve as it was drawn, of this body or of the one before. */
  line(points: Float64Array): Line;
  events(of: Atlas): (Spot | null)[];
}

/** h to the right, l upwards: a window of the plane. */
export class PlaneChart implements Chart {
  readonly regions: Int16Array;

  /** `rows`: as `Diagram.columns` has them, one for each pixel from below. */
  constructor(readonly width: number, readonly height: number, readonly window: Window, rows: Float64Array) {
    this.regions = new Int16Array(width * height).fill(-1);
    const column = (h: number) => Math.min(width, Math.max(0, Math.round(this.place(h, 0)[0])));
    let at = 0;
    for (let row = height - 1; row >= 0 && at < rows.length; row--) {
      const count = rows[at++]!;
      for (let k = 0; k < count; k++) {
        const end = k + 1 < count ? column(rows[at + 2 * k + 2]!) : width;
        this.regions.fill(rows[at + 2 * k + 1]!, row * width + column(rows[at + 2 * k]!), row * width + end);
      }
      at += 2 * count;
    }
  }

  place(hv: number, lv: number): Spot {
    const { h, l } = this.window;
    return [((hv - h[0]) / (h[1] - h[0])) * this.width, (1 - (lv - l[0]) / (l[1] - l[0])) * this.height];
  }

  value(x: number, y: number): [h: number, l: number] | null {
    const { h, l } = this.window;
    const lv = l[0] + (1 - y / this.height) * (l[1] - l[0]);
    return lv < 0 ? null : [h[0] + (x / this.width) * (h[1] - h[0]), lv];
  }

  rounded(x: number, y: number): Point {
    const { h, l } = this.window;
    const [hv, lv] = this.value(x, y) ?? [h[0] + (x / this.width) * (h[1] - h[0]), 0];
    return { h: rounded(hv, (h[1] - h[0]) / this.width / 2), l: rounded(lv, (l[1] - l[0]) / this.height / 2) };
  }

  pixels(_h: number, _l: number, distance: number): number {
    return (distance / (this.window.h[1] - this.window.h[0])) * this.width;
  }

  line(points: Float64Array): Line {
    const line = new Float64Array(1.5 * points.length);
    for (let i = 0; i < points.length / 2; i++) {
      const [h, l] = [points[2 * i]!, points[2 * i + 1]!];
      line.set([l, ...this.place(h, l)], 3 * i);
    }
    return line;
  }

  events = ({ events }: Atlas): Spot[] => events.map(({ h, l }) => this.place(h, l));
}
