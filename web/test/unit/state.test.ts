import { describe, expect, test } from "vitest";
import { format, parse, unknownKeys } from "../../src/state/hash";
import { isNumber, rounded, shown, stepOf, stepped, surface, typed, valueOf } from "../../src/state/numbers";
import { FIRST } from "../../src/state/state";
import { inWords, listed } from "../../src/state/words";
import { commandLines, pythonLines } from "../../src/panels/take";

const named = (name: string) => (name === "rod" ? { A: ["1/1000", "1", "1"] as [string, string, string], r: ["1", "0", "0"] as [string, string, string] } : undefined);

describe("the hash", () => {
  test("keeps numbers as they were written", () => {
    const text = "A=11/10,1.10,1&r=0.94868,0,-1e-3&h=3.80&l=13/4";
    expect(format(parse(`#${text}`, named))).toBe(text);
  });

  test("comes back whole", () => {
    const state = { ...FIRST, point: { h: "1", l: "2" }, view: { h: [0, 1], l: [0.5, 2] } as const, orbits: 3, seed: 9, coloring: "lyapunov" as const, theme: "dark" as const, embed: "section" as const, tour: 3 };
    expect(parse(format(state as never), named)).toEqual(state);
  });

  test("a straightened diagram is all to be seen", () => {
    const state = { ...FIRST, straight: true };
    expect(format(state)).toContain("&view=straight");
    expect(parse(format({ ...state, view: { h: [0, 1], l: [0, 1] } }), named)).toEqual(state);
    expect(commandLines(state)).toContain("--view=straight");
  });

  test("of nothing is the paper's body; presets have names", () => {
    expect(parse("", named)).toEqual(FIRST);
    expect(parse("#body=rod", named).A).toEqual(["1/1000", "1", "1"]);
  });

  test.each([
    ["A=1,2", "A = 1,2: three numbers"],
    ["h=1", "l is missing"],
    ["l=1", "h is missing"],
    ["body=cow", "body = cow"],
    ["view=1,0,0,1", "view = 1,0,0,1"],
    ["orbits=0", "orbits = 0"],
    ["embed=sphere", "embed = sphere"],
    ["nonsense", "“nonsense” has no value"],
  ])("%s is refused", (text, message) => expect(() => parse(text, named)).toThrow(message));

  test("keys of later versions are passed over, and told", () => {
    expect(parse("later=1", named)).toEqual(FIRST);
    expect(unknownKeys("#later=1&A=2,1,1&hh=3")).toEqual(["later", "hh"]);
  });
  test("a point is read as fields read it", () => {
    expect(parse("h=3,8&l=−1,5e–1", named).point).toEqual({ h: "3.8", l: "-1.5e-1" });
    expect(parse("h=%203,8%20&l=13%20/%204", named).point).toEqual({ h: "3.8", l: "13/4" });
    // Where it is not known which sign is the decimal one, nothing is changed.
    expect(parse("h=1,000.5&l=1", named).point).toEqual({ h: "1,000.5", l: "1" });
  });
  test("a typographic minus is one", () => expect(parse("r=1,0,−2&h=−1&l=1", named)).toMatchObject({ r: ["1", "0", "-2"], point: { h: "-1", l: "1" } }));
});

describe("numbers", () => {
  test("a hand's number is short", () => {
    expect([rounded(0.123456, 0.001), rounded(2, 0.01), rounded(-1e-9, 1e-3), rounded(1234.5, 10), rounded(-110.2, 1), rounded(1200, 10), rounded(0.1004, 0.001), rounded(7.4984e-5, 1e-8), rounded(-1e-5, 1e-3)]).toEqual(["0.123", "2", "0", "1235", "-110", "1200", "0.1", "7.498e-5", "0"]);
  });
  test("steps suit the size, and keep the digits that are written", () => {
    expect([stepOf(1.37, 3), stepOf(0.95, 4), stepOf(2e-5, 3), stepOf(200, 3), stepOf(0, 3)].map((step) => Number(step.toPrecision(3)))).toEqual([1e-3, 1e-4, 1e-8, 0.1, 1e-3]);
    expect([stepped("1.1", 1), stepped("1.11", -10), stepped("0.94868", 1), stepped("", 1), stepped("-0.6", -1)]).toEqual(["1.11", "1.01", "0.94869", "0.01", "-0.61"]);
    expect([stepped("1/1000", 1), stepped("2.1e-5", 1), stepped("11/10", -1)]).toEqual(["0.00101", "2.11e-5", "1.09"]);
  });
  test("typed as people do", () => {
    expect(["3,8", "−1", " 11 / 10 ", "1,5e–3", "1,000.5"].map(typed)).toEqual(["3.8", "-1", "11/10", "1.5e-3", "1,000.5"]);
    expect(["3.8", "-1", "11/10", "1.5e-3", ".5", "+2"].every(isNumber)).toBe(true);
    expect(["", "two", "1,000.5", "1/2/3", "1/", "0x10", "Infinity", "1 2"].some(isNumber)).toBe(false);
  });
  test("surfaces in words", () => expect([inWords("M3"), inWords("S2-2D2"), inWords("S2-D2"), listed(["S2", "T2"]), listed([null])]).toEqual(["surface of genus 3, with 3 handles", "sphere with 2 holes", "sphere with one hole", "sphere and torus", "none"]));
  test("quotients have values", () => expect([valueOf("11/10"), valueOf("1e-3"), valueOf(""), valueOf("1/")]).toEqual([1.1, 1e-3, NaN, NaN]));
  test("a few digits for reading", () => expect([shown(0.000012345), shown(3.14159), shown(0), shown(-0.5), shown(NaN)]).toEqual(["1.234e-5", "3.142", "0", "−0.5", "NaN"]));
  test("surfaces", () => expect(["S2", "M3", "S2-2D2", "(S1xS2)#(S1xS2)", "RP3", "#3(S1xS2)"].map(surface)).toEqual(["S²", "M²₃", "S²∖2D²", "(S¹×S²)#(S¹×S²)", "RP³", "#3(S¹×S²)"]));
});

test("the lines that give the same name what was asked beyond the usual", () => {
  const state = { ...FIRST, point: { h: "3.80", l: "13/4" }, seed: 3 };
  expect(commandLines(state).split("\n").at(-1)).toBe("bifdiag section --A=2,1.1,1 --r=0.94868,0,0.61623 --h=3.80 --l=13/4 --seed=3");
  expect(pythonLines(state).split("\n").at(-1)).toBe('body.section("3.80", "13/4", seed=3)');
});
