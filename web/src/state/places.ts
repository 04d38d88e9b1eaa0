/** Where a region's name stands: the place deepest inside it, on a grid of a few pixels, at which as much of the name as may be fits. */
import type { Chart } from "./chart";

/** Pixels of a cell, and of one while the picture moves. */
const [CELL, COARSE] = [4, 8];

export interface Place {
  /** Pixels from the left and the top of the frame: the middle of the name. */
  x: number;
  y: number;
  /** Pixels to the region's edge. */
  depth: number;
  /** The first of the boxes that fits there; −1 where none does. */
  box: number;
}

/** Width and height of a name in pixels, in each of its forms, the best first. */
export type Boxes = [width: number, height: number][];

interface Grid {
  /** Pixels of a cell. */
  cell: number;
  cells: Int16Array;
  depth: Float32Array;
  /** How many cells to the right are of the same region. */
  run: Uint16Array;
  /** The middle of each region between left and right. */
  middle: number[];
  columns: number;
  lines: number;
}

/** For each region the place of its name; the edge of the picture counts as an edge of the region. */
export function places(chart: Chart, boxes: Boxes[], moving = false): Map<number, Place> {
  const grid = depths(chart, moving ? COARSE : CELL);
  const found = new Map<number, Place>();
  const forms = Math.max(0, ...boxes.map((own) => own.length));
  for (let form = 0; form < forms; form++) rooms(grid, boxes, form, found);
  const { cell, cells, depth, columns } = grid;
  // Too narrow for any of them.
  const deepest = new Map<number, Place>();
  for (let at = 0; at < cells.length; at++) {
    const region = cells[at]!;
    if (region < 0 || found.has(region) || cell * depth[at]! <= (deepest.get(region)?.depth ?? 0)) continue;
    deepest.set(region, { x: ((at % columns) + 0.5) * cell, y: (Math.floor(at / columns) + 0.5) * cell, depth: cell * depth[at]!, box: -1 });
  }
  return new Map([...found, ...deepest]);
}

/** The regions of cells, and how many cells each is from the edge of its region; to the right and in all directions. */
function depths({ regions, width, height }: Chart, cell: number): Grid {
  const [columns, lines] = [Math.max(1, Math.floor(width / cell)), Math.max(1, Math.floor(height / cell))];
  const cells = new Int16Array(columns * lines);
  for (let at = 0; at < cells.length; at++) cells[at] = regions[(Math.floor(at / columns) * cell + (cell >> 1)) * width + (at % columns) * cell + (cell >> 1)] ?? -1;
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
  for (let y = lines - 1; y >= 0; y--) {
    for (let x = columns - 1; x >= 0; x--) {
      const at = y * columns + x;
      const region = cells[at]!;
      const edge = x === columns - 1 || y === lines - 1;
      const back = edge ? 0.5 : Math.min(beside(at + 1, region, 1), beside(at + columns, region, 1), beside(at + columns + 1, region, 1.4), x > 0 ? beside(at + columns - 1, region, 1.4) : 0.5);
      depth[at] = Math.min(depth[at]!, back);
    }
  }
  const run = new Uint16Array(cells.length);
  const [left, right]: [number[], number[]] = [[], []];
  for (let at = cells.length - 1; at >= 0; at--) {
    const [x, region] = [at % columns, cells[at]!];
    run[at] = x + 1 < columns && cells[at + 1] === region ? run[at + 1]! + 1 : 1;
    if (region < 0) continue;
    left[region] = Math.min(left[region] ?? x, x);
    right[region] = Math.max(right[region] ?? x, x);
  }
  return { cell, cells, depth, run, middle: left.map((from, region) => (from + right[region]! + 1) / 2), columns, lines };
}

/** The deepest place for one form of the names of those regions that have none yet; of equal ones that nearest to their middle. */
function rooms({ cell, cells, depth, run, middle, columns, lines }: Grid, boxes: Boxes[], form: number, found: Map<number, Place>): void {
  const best = new Map<number, [worth: number, place: Place]>();
  for (let at = 0; at < cells.length; at++) {
    const region = cells[at]!;
    const box = region < 0 || found.has(region) ? undefined : boxes[region]?.[form];
    if (!box) continue;
    const [wide, high] = box.map((pixels) => Math.ceil(pixels / cell)) as [number, number];
    if (run[at]! < wide || Math.floor(at / columns) + high > lines) continue;
    let fits = true;
    for (let line = 1; line < high && fits; line++) fits = cells[at + line * columns] === region && run[at + line * columns]! >= wide;
    if (!fits) continue;
    const [x, y] = [(at % columns) + wide / 2, Math.floor(at / columns) + high / 2];
    const own = depth[Math.floor(y) * columns + Math.floor(x)]!;
    const worth = own - Math.abs(x - middle[region]!) / columns;
    if (worth > (best.get(region)?.[0] ?? -Infinity)) best.set(region, [worth, { x: x * cell, y: y * cell, depth: cell * own, box: form }]);
  }
  for (const [region, [, place]] of best) found.set(region, place);
}
