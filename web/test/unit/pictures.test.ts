import { describe, expect, test } from "vitest";
import { between, same } from "../../src/state/view";
import { apply, back, castBall, composed, lookingAt, rotation, turned, type Vec } from "../../src/draw/ball";
import { powerOf, ticks } from "../../src/draw/canvas";
import { LESSONS } from "../../src/guide/lessons";
import words from "../../src/texts/en/guide";
import { npy } from "../../src/export/files";
import { described, loaded } from "../../src/panels/catalogue";
import { bodyAt, FAMILIES } from "../../src/panels/families";

const near = (a: Vec, b: Vec) => a.forEach((x, i) => expect(x).toBeCloseTo(b[i]!, 12));

describe("turning", () => {
  test("what is looked at stands in front", () => near(apply(lookingAt([1, 2, 2], [0, 0, 1]), [1 / 3, 2 / 3, 2 / 3]), [0, 0, 1]));
  test("back undoes apply", () => {
    const turn = turned(lookingAt([1, 0.3, 0.2], [0, 0, 1]), [0.6, 0.8, 0], 0.7);
    near(back(turn, apply(turn, [0.1, 0.2, 0.3])), [0.1, 0.2, 0.3]);
  });
  test("a quaternion of a quarter turn about axis 3", () => {
    const turn = rotation(Math.SQRT1_2, 0, 0, Math.SQRT1_2);
    near(apply(turn, [1, 0, 0]), [0, 1, 0]);
    near(apply(composed(turn, turn), [1, 0, 0]), [-1, 0, 0]);
  });
  test("each pixel of a ball gets its direction", () => {
    const image = { width: 3, height: 3, data: new Uint8ClampedArray(36) } as unknown as ImageData;
    const seen: Vec[] = [];
    castBall(image, 2, lookingAt([1, 0, 0], [0, 0, 1]), (direction) => seen.push([...direction]));
    near(seen[4]!, [1, 0, 0]);
    for (const direction of seen) expect(Math.hypot(...direction)).toBeCloseTo(1, 12);
  });
});

test("ticks are round and told apart, also in a narrow view", () => {
  expect(ticks(0, 10, 5).map(({ text }) => text)).toEqual(["0", "2", "4", "6", "8", "10"]);
  const narrow = ticks(1.2345678, 1.2345688, 4).map(({ text }) => text);
  expect(new Set(narrow).size).toBe(narrow.length);
});

test("an array of NumPy begins its data at a multiple of 64", () => {
  const bytes = npy("<i4", "(2,)", new Uint8Array(8));
  expect((bytes.length - 8) % 64).toBe(0);
  expect(new TextDecoder().decode(bytes.subarray(1, 6))).toBe("NUMPY");
});

test("a view glides from one window to another, and ends there exactly", () => {
  const [from, to] = [{ h: [0, 1], l: [0, 1] }, { h: [2, 3.3], l: [0, 4] }] as { h: [number, number]; l: [number, number] }[];
  expect(between(from!, to!, 0.5).l[1]).toBeCloseTo(2.5);
  expect(same(between(from!, to!, 1), to!) && same(between(from!, to!, 0), from!)).toBe(true);
});

describe("planes of bodies", () => {
  test.each(FAMILIES)("$id: a body lies where its place says", (family) => {
    const A: [string, string, string] = family.id === "eta" ? ["2", "1.3", "1"] : ["1", "0.7", "0.5"];
    const body = { A, r: ["1", "0", "0"] as [string, string, string] };
    const place = family.place(body)!;
    const found = bodyAt(family, ...place, body)!;
    const [x, y] = family.place(found)!;
    expect(x).toBeCloseTo(place[0], 2);
    expect(y).toBeCloseTo(place[1], 2);
  });
});

test("each lesson's right choice is one of its choices", () => {
  LESSONS.forEach(({ tasks }, i) => tasks.forEach(({ right }, k) => expect(words.lessons[i]!.tasks[k]!.choices[right]).toBeDefined()));
});

describe("classes in words", () => {
  test("by share, by stratum, or not at all", () => {
    const known = { generic: { a: 0.32, b: 0.5, c: 0, d: null }, special: { e: { in: [1], preset: "katok:5" }, f: { in: [0, 1] } }, strata: ["Euler", "r on axis 3"] };
    expect([..."abcdefg"].map((name) => described(known, words.classes, name))).toEqual([
      "number 2 of 3 classes of physical bodies, 32 % of them",
      "number 1 of 3 classes of physical bodies, 50 % of them",
      "one of 3 classes of physical bodies, less than one body in a million",
      "known, but not for physical bodies",
      "katok:5 (r on axis 3)",
      "Euler; r on axis 3",
      "not in the catalogue",
    ]);
  });
  test("Katok's seven classes and the largest one of all bodies are in the catalogue", async () => {
    const known = await loaded();
    const presets = Object.values(known.special).map(({ preset }) => preset);
    for (let k = 1; k <= 7; k++) expect(presets).toContain(`katok:${k}`);
    expect(described(known, words.classes, "01036ac4a504")).toMatch(/^number 1 of \d+ classes of physical bodies, 3\d\.\d % of them$/);
  });
});

test("long numbers of an axis are in units of a power of ten", () => {
  expect([powerOf(0, 8.6), powerOf(-1.2, 24), powerOf(0, 8e-5), powerOf(-2e6, 3e5), powerOf(0, 99_999), powerOf(0, 0.001)]).toEqual([0, 0, -5, 6, 0, 0]);
});
