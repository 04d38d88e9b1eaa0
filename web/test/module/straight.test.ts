/** The straightened diagram: its columns have the regions and curves that points are told. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import init, * as guest from "../../src/bindings/generated/bifdiag_web.js";
import later, { Straight } from "../../src/bindings/generated/bifdiag_web_straight.js";
import { boxesOf } from "../../src/state/names";
import type { Atlas } from "../../src/bindings/documents";
import { bodies, hashOf } from "../program";

const bytes = (name: string) => readFileSync(new URL(`../../src/bindings/generated/${name}_bg.wasm`, import.meta.url));

beforeAll(async () => {
  await init({ module_or_path: bytes("bifdiag_web") });
  await later({ module_or_path: bytes("bifdiag_web_straight") });
});

describe("each column is the plane at one momentum", () => {
  test.each(bodies(12))("of A = $A, r = $r", (body) => {
    const diagram = new guest.Diagram(hashOf(body));
    const text = diagram.document();
    const { regions, curves } = JSON.parse(text) as Atlas;
    const boxes = Float64Array.from(regions.flatMap((region) => boxesOf(region).flat()));
    const straight = new Straight(text, diagram, 480, 340, boxes, new Float64Array(), Float64Array.of(0.3141592653589793));
    const columns = straight.columns();
    let seen = 0;
    let exact = false;
    for (let at = 0; at < columns.length; ) {
      const [x, l, count] = [columns[at]!, columns[at + 1]!, columns[at + 2]!];
      at += 3;
      expect(x).toBeGreaterThanOrEqual(0);
      expect(x).toBeLessThanOrEqual(480);
      exact ||= l === 0.3141592653589793;
      const over = Array.from({ length: count }, (_, k) => [...columns.subarray(at + 3 * k, at + 3 * k + 3)] as [number, number, number]);
      at += 3 * count;
      const steps = columns[at++]!;
      over.forEach(([h, y, region], k) => {
        const [end, above] = [over[k + 1]?.[0] ?? columns[at + 5]!, over[k + 1]?.[1] ?? 0];
        expect(y).toBeGreaterThanOrEqual(above);
        if (end - h > 1e-9 * Math.max(1, Math.abs(h))) {
          const [found, distance, bound] = diagram.locate((h + end) / 2, l) as unknown as [number, number, number];
          if (found === -2) expect(distance).toBeLessThan(bound);
          else expect([l, found]).toEqual([l, region]);
          seen++;
        }
      });
      at += steps;
    }
    expect(seen).toBeGreaterThan(480);
    expect(exact).toBe(true);
    // Curves lie where the columns have them.
    const lines = straight.curves();
    let at = 0;
    for (let k = 0; k < curves.length; k++) at += 1 + 3 * lines[at]!;
    expect(at).toBe(lines.length);
    // Shares that are held give the same.
    const again = new Straight(text, diagram, 480, 340, boxes, straight.shares(), Float64Array.of(0.3141592653589793));
    expect(again.columns()).toEqual(columns);
  });
});

test("what is no document is refused", () => {
  expect(() => new Straight("{}", new guest.Diagram("body=paper"), 480, 340, new Float64Array(), new Float64Array(), new Float64Array())).toThrow();
});
