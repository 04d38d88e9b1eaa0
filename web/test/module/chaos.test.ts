/** The chaotic share of cells is the command line's. */
import { readFileSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { beforeAll, expect, test } from "vitest";
import later, { Shares } from "../../src/bindings/generated/bifdiag_web_chaos.js";
import { bifdiag } from "../program";

beforeAll(async () => {
  await later({ module_or_path: readFileSync(new URL("../../src/bindings/generated/bifdiag_web_chaos_bg.wasm", import.meta.url)) });
});

interface Row {
  cell: [number, number];
  region: string;
  component: number;
  part: number;
  block: number;
  fraction: number | null;
  open: number;
  error: number | null;
  orbits: number;
}

const native = (body: string, window: string, cells: string, error: string, steps: string): Row[] => {
  const out = join(mkdtempSync(join(tmpdir(), "bifdiag-")), "chaos.json");
  bifdiag("chaos", `--body=${body}`, `--window=${window}`, `--cells=${cells}`, `--error=${error}`, `--steps=${steps}`, `--out=${out}`, "-q");
  return (JSON.parse(readFileSync(out, "utf8")) as { rows: Row[] }).rows;
};

/** Rows of all tiles, in the order of the command line's. */
function here(A: string[], r: string[], window: number[], cells: [number, number], error: number, steps: number): Row[] {
  const shares = new Shares(A, r);
  const tiles = cells.reduce((product, count) => product * Math.ceil(count / 8), 1);
  return Array.from({ length: tiles }, (_, tile) => [...shares.tile(Float64Array.from(window), Uint32Array.from(cells), tile, error, steps)]).flatMap((numbers) =>
    Array.from({ length: numbers.length / 10 }, (_, k) => {
      const [i, j, region, component, part, block, chaotic, open, orbits, error] = numbers.slice(10 * k, 10 * k + 10) as [number, number, number, number, number, number, number, number, number, number];
      return { cell: [i, j] as [number, number], region: `R${region + 1}`, component, part, block, fraction: orbits > 0 ? chaotic / orbits : null, open: open / Math.max(1, orbits), error, orbits };
    }),
  );
}

const place = ({ cell, region, component, part }: Row) => `${cell} ${region} ${component} ${part}`;

test("an integrable body: no orbit is chaotic, and at least nine rows of ten are the same in all numbers", () => {
  const rows = here(["2", "2", "1"], ["1", "0", "0"], [-1, 3, 0, 2], [8, 8], 0.2, 5120);
  const wanted = native("kovalevskaya", "-1:3,0:2", "8x8", "0.2", "5120");
  expect(rows.map(place)).toEqual(wanted.map(place));
  // Orbits differ in their last bits, so that one that is hardly decided may stay open on one side.
  const equal = rows.filter((row, k) => row.orbits === wanted[k]!.orbits && row.fraction === wanted[k]!.fraction && row.open === wanted[k]!.open && row.block === wanted[k]!.block);
  expect(equal.length).toBeGreaterThan(0.9 * rows.length);
  expect(Math.max(...rows.map(({ fraction }) => fraction ?? 0))).toBe(0);
});

test("the paper's body: the same cells, regions, components and parts; shares within their errors", () => {
  const rows = here(["2", "1.1", "1"], ["0.94868", "0", "0.61623"], [3.2, 4.2, 2.9, 3.5], [4, 4], 0.2, 1280);
  const wanted = native("paper", "3.2:4.2,2.9:3.5", "4x4", "0.2", "1280");
  expect(rows.map(place)).toEqual(wanted.map(place));
  expect(new Set(rows.map(({ component }) => component)).size).toBeGreaterThan(1);
  rows.forEach((row, k) => {
    const other = wanted[k]!;
    expect(row.fraction === null, place(row)).toBe(other.fraction === null);
    if (row.fraction === null || other.fraction === null) return;
    // Chaotic orbits part from those of the program; what is certain is between the share and that with the open ones.
    const far = 3 * Math.hypot(row.error!, other.error!);
    expect(row.fraction - other.fraction - other.open, place(row)).toBeLessThan(far);
    expect(other.fraction - row.fraction - row.open, place(row)).toBeLessThan(far);
  });
});

test("what is no window is refused", () => {
  const shares = new Shares(["2", "1.1", "1"], ["0.94868", "0", "0.61623"]);
  expect(() => shares.tile(Float64Array.of(0, 1), Uint32Array.of(8, 8), 0, 0.2, 1280)).toThrow("a window is");
  expect(() => new Shares(["2", "-1", "1"], ["1", "0", "0"])).toThrow("A2");
});
