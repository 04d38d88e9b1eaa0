/** Places in the straightened plane and back. */
import { expect, test } from "vitest";
import { PlaneChart } from "../../src/state/chart";
import { places } from "../../src/state/places";
import { StraightChart } from "../../src/state/straight";

const STEPS = 4;

/** Two curves, h = l and h = l + 1e-6, that lie at 90 and 50 pixels; the region between them is 0, that above is 1. */
const column = (x: number, l: number) => [x, l, 2, l, 90, 0, l + 1e-6, 50, 1, STEPS, l + 1e-6, l + 1, l + 2, l + 8];
const chart = new StraightChart({
  width: 100, height: 100, shares: new Float64Array(), events: Float64Array.of(20, 50, NaN, NaN), levels: new Float64Array(), ticks: [], end: 1,
  columns: Float64Array.from([0, 0.01, 0.02, 0.25].flatMap((l, k) => column([0, 1.4, 2.1, 25][k]!, l)).concat(column(99.5, 1))),
});

test("a place has its value, and the value its place", () => {
  for (const [x, y] of [[25, 70], [25, 20], [0, 89], [99.5, 51]] as const) {
    const [h, l] = chart.value(x, y)!;
    const [px, py] = chart.place(h, l)!;
    expect([px, py]).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 4)]);
  }
  expect(chart.value(25, 70)![0]).toBeCloseTo(0.2500005, 12);
});

test("a hand's number between curves that are close stays between them", () => {
  const { h, l } = chart.rounded(25.3, 60)!;
  expect(l).toBe("0.25");
  expect(Number(h)).toBeGreaterThan(0.25);
  expect(Number(h)).toBeLessThan(0.250001);
  expect(chart.place(Number(h), Number(l))![1]).toBeCloseTo(60, 0);
});

test("where there is no motion, and beyond the last momentum, is no place", () => {
  expect(chart.value(25, 95)).toBe(null);
  expect(chart.place(0.1, 0.25)).toBe(null);
  expect(chart.place(5, 1.5)).toBe(null);
  expect([chart.knows(0.25), chart.knows(-0.25), chart.knows(0.3)]).toEqual([true, true, false]);
  expect(chart.events()).toEqual([[20, 50], null]);
});

test("regions fill their pixels", () => {
  const at = (x: number, y: number) => chart.regions[y * 100 + x];
  expect([at(25, 95), at(25, 89), at(25, 50), at(25, 49), at(25, 0)]).toEqual([-1, 0, 0, 1, 1]);
});

test("between columns that are far apart, because no momenta lie between them, the nearest one is painted and answers", () => {
  const at = (x: number, y: number) => chart.regions[y * 100 + x];
  for (const x of [10, 40, 70, 99]) expect([at(x, 95), at(x, 70), at(x, 20)]).toEqual([-1, 0, 1]);
  expect([40, 70].map((x) => chart.value(x, 70)![1])).toEqual([0.25, 1]);
});

test("a name stands where it fits, on one line in a strip", () => {
  // One region over all pixels but the upper 24 rows, which another one has.
  const rows = Float64Array.from(Array.from({ length: 100 }, (_, row) => [1, -1, row < 76 ? 0 : 1]).flat());
  const plane = new PlaneChart(120, 100, { h: [0, 1], l: [0, 1] }, rows);
  const found = places(plane, [[[40, 34], [80, 19], [20, 18]], [[40, 34], [80, 19], [20, 18]]]);
  expect(found.get(0)!.box).toBe(0);
  expect(found.get(1)!.box).toBe(1);
  expect(found.get(1)!.y).toBeCloseTo(12, -1);
  expect(Math.abs(found.get(1)!.x - 60)).toBeLessThan(8);
});
