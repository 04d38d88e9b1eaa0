/** Where a region's name stands: the place deepest inside it, on a grid of a few pixels. */
import type { Drawn } from "./known";

/** Pixels of a cell. */
export const CELL = 4;

export interface Place {
  /** Pixels from the left and the top of the picture. */
  x: number;
  y: number;
  /** Pixels to the region's edge. */
  depth: number;
}

/** The regions of the cells of a grid, row by row from the top; −1 below all curves. */
export function cellsOf({ rows, rowCount, window }: Drawn, width: number): { cells: Int16Array; columns: number; lines: number } {
  const columns = Math.max(1, Math.floor(width / CELL));
  const lines = Math.max(1, Math.floor(rowCount / CELL));
  const cells = new Int16Array(columns * lines).fill(-1);
  const [from, to] = window.h;
  const column = (h: number) => Math.min(columns, Math.max(0, Math.round(((h - from) / (to - from)) * columns)));
  let at = 0;
  for (let row = 0; row < rowCount && at < rows.length; row++) {
    const count = rows[at++]!;
    const line = lines - 1 - Math.floor(row / CELL);
    if (row % CELL === CELL >> 1 && line >= 0) {
      for (let k = 0; k < count; k++) {
        const end = k + 1 < count ? column(rows[at + 2 * k + 2]!) : columns;
        cells.fill(rows[at + 2 * k + 1]!, line * columns + column(rows[at + 2 * k]!), line * columns + end);
      }
    }
    at += 2 * count;
  }
  return { cells, columns, lines };
}

/** The deepest place of each region; the edge of the picture counts as an edge of the region. */
export function deepest(drawn: Drawn, width: number): Map<number, Place> {
  const { cells, columns, lines } = cellsOf(drawn, width);
  const depth = new Float32Array(cells.length);
  const beside = (other: number, region: number, far: number) => (cells[other] === region ? depth[other]! + far : 0.5);
  for (let y = 0; y < lines; y++) {
    for (let x = 0; x < columns; x++) {
      const at = y * columns + x;
      const region = cells[at]!;
      const edge = x === 0 || y === 0;
      depth[at] = edge ? 0.5 : Math.min(beside(at - 1, region, 1), beside(at - columns, region, 1), beside(at - columns - 1, region, 1.4), x + 1 < columns ? beside(at - columns + 1, region, 1.4) : 0.5);
    }
  }
  const places = new Map<number, Place>();
  for (let y = lines - 1; y >= 0; y--) {
    for (let x = columns - 1; x >= 0; x--) {
      const at = y * columns + x;
      const region = cells[at]!;
      const edge = x === columns - 1 || y === lines - 1;
      const back = edge ? 0.5 : Math.min(beside(at + 1, region, 1), beside(at + columns, region, 1), beside(at + columns + 1, region, 1.4), x > 0 ? beside(at + columns - 1, region, 1.4) : 0.5);
      depth[at] = Math.min(depth[at]!, back);
      if (region >= 0 && CELL * depth[at]! > (places.get(region)?.depth ?? 0)) places.set(region, { x: (x + 0.5) * CELL, y: (y + 0.5) * CELL, depth: CELL * depth[at]! });
    }
  }
  return places;
}
