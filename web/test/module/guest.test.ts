/** The module gives what the command line gives: documents to the byte, crossings within a tolerance. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import init, * as guest from "../../src/bindings/generated/bifdiag_web.js";
import { bifdiag, bodies, hashOf, optionsOf } from "../program";

beforeAll(async () => {
  await init({ module_or_path: readFileSync(new URL("../../src/bindings/generated/bifdiag_web_bg.wasm", import.meta.url)) });
});

describe("documents are the command line's", () => {
  test.each(bodies(12))("of A = $A, r = $r", (body) => {
    expect(guest.atlas(hashOf(body))).toBe(bifdiag(...optionsOf(body), "--json"));
    expect(guest.classify(hashOf(body), "3.8", "3.25")).toBe(bifdiag("classify", ...optionsOf(body), "--h=3.8", "--l=3.25", "--json"));
    expect(guest.critical(hashOf(body), "13/4")).toBe(bifdiag("critical", ...optionsOf(body), "--l=13/4", "--json"));
  });
});

test("what is wrong is told", () => {
  expect(() => guest.atlas("A=2,1,1")).toThrow("r is missing");
  expect(() => guest.atlas("A=2,-1,1&r=1,0,0")).toThrow("A2 = -1 is not positive");
  expect(() => guest.classify("body=paper", "x", "1")).toThrow("h: `x` is not a number");
  expect(() => guest.atlas("body=nothing")).toThrow("no body `nothing`");
  expect(() => new guest.Section("body=paper", "-9", "1")).toThrow("forbidden");
});

test("crossings agree with native ones while rounding has not grown", () => {
  // No fused operations here: the last bits differ, and grow at most like the crossings of a regular orbit.
  const section = new guest.Section("body=paper", "3.8", "3.25");
  const rows = section.follow(section.starts(4, 0), 0, 20);
  const lines = bifdiag("section", "--body=paper", "--h=3.8", "--l=3.25", "--orbits=4", "--crossings=20", "--data=-", "--no-plot").trim().split("\n").map((line) => line.split(","));
  const [head, ...native] = lines as [string[], ...string[][]];
  expect(native.length).toBe(rows.length / 13);
  native.forEach((line, row) => {
    const of = (name: string) => Number(line[head.indexOf(name)]);
    expect(rows[13 * row]).toBe(of("orbit"));
    expect(rows[13 * row + 1]).toBe(of("index"));
    expect(rows[13 * row + 9]).toBe(of("sheet"));
    for (const [name, at] of [["time", 2], ["theta", 11], ["psi", 12]] as const) {
      const distance = Math.abs(rows[13 * row + at]! - of(name));
      expect(Math.min(distance, Math.abs(distance - 2 * Math.PI))).toBeLessThan(1e-9);
    }
  });
});

describe("a way through the plane is told curve by curve", () => {
  const told = (body: string, from: [number, number], to: [number, number]) => new guest.Diagram(body).surgeries(Float64Array.from(from), Float64Array.from(to));
  const passed = ["the forbidden region", "G2.1", "R1", "P+", "R2", "G1.3", "R5", "S2.1", "R6", "P-", "R7", "G1.1", "R3", "G0.1", "R4"];
  test("however many curves lie between its ends", () => {
    const names = told("body=paper", [-1, 2.868], [12, 2.868]).map((sentence) => sentence.split(":")[0]);
    expect(names).toEqual([0, 1, 2, 3, 4, 5, 6].map((k) => `${passed[2 * k]} → ${passed[2 * k + 2]} across ${passed[2 * k + 1]}`));
  });
  test("and backwards", () => {
    const names = told("body=paper", [12, 2.868], [-1, 2.868]).map((sentence) => sentence.split(":")[0]);
    expect(names).toEqual([6, 5, 4, 3, 2, 1, 0].map((k) => `${passed[2 * k + 2]} → ${passed[2 * k]} across ${passed[2 * k + 1]}`));
  });
  test("a saddle that parts a disc is no birth of a disc, though both leave one more", () => {
    expect(told("body=paper", [3.4, 2.4], [2.25, 2.4]).at(-1)).toBe("R2 → R5 across G1.2: at a saddle components of U part, and those of E with them (D2 to D2 + D2).");
    expect(told("body=paper", [2.1, 2.4], [2.25, 2.4])).toEqual(["R2 → R5 across G1.3: a disc of U appears, and with it a three-sphere of E (D2 to D2 + D2)."]);
  });
});

test("columns of a picture hold what points are told", () => {
  const diagram = new guest.Diagram("body=paper");
  const columns = diagram.columns(0, 8, 40);
  let at = 0;
  for (let column = 0; column < 40; column++) {
    const l = ((column + 0.5) / 40) * 8;
    const count = columns[at++]!;
    for (let k = 0; k < count; k++, at += 2) {
      const [low, high] = [columns[at]!, k + 1 < count ? columns[at + 2]! : columns[at]! + 1];
      if (high - low > 1e-9) expect(diagram.locate((low + high) / 2, l)[0]).toBe(columns[at + 1]);
    }
  }
});
