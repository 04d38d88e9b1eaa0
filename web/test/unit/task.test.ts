import { describe, expect, test } from "vitest";
import { format, parse, unknownKeys } from "../../src/state/hash";
import { FIRST, type State } from "../../src/state/state";
import { choicesOf } from "../../src/state/task";

const STATE: State = {
  ...FIRST,
  point: { h: "3.8", l: "3.25" },
  embed: "section",
  task: { heading: "Übung 3 (b)", question: "Is h − l = 100 % of it?\n“Yes” & no; 1 + 1 = 2 | #", choices: ["Yes", "−1, or * no"], right: 1, explanation: "It's so!", then: { h: "-1/2", l: "1e-3" } },
};
const none = () => undefined;
const link = format(STATE);

describe("a link to a task", () => {
  test("comes back whole, whatever its texts hold", () => {
    expect(parse(link, none)).toEqual(STATE);
    expect(unknownKeys(link)).toEqual([]);
    // Signs at which mail programs end a link, or which another encoding would take for its own.
    expect(link).not.toMatch(/[\s"'()<>*!|`]/);
  });
  test("survives another encoding of the same", () => {
    const other = link.split("&").map((part) => part.split("=").map((text) => encodeURIComponent(decodeURIComponent(text)).replace(/%C3%9C/g, "Ü")).join("=")).join("&");
    expect(other).not.toBe(link);
    expect(parse(other, none)).toEqual(STATE);
  });
  test("is refused where any part of it is missing or was changed", () => {
    for (let end = link.indexOf("heading=") + 1; end < link.length; end++) expect(() => parse(link.slice(0, end), none), link.slice(end - 9, end)).toThrow();
    expect(() => parse(link.replace("h=3.8", "h=3.9"), none)).toThrow("did not come over whole");
    expect(() => parse("task=What%20now%3F", none)).toThrow("Link to a task");
    expect(() => parse(link.replace("%C3", "%C"), none)).toThrow("cut off");
  });
  test("has no choices, or several of which one is right", () => {
    expect(choicesOf("")).toEqual({ choices: [], right: 0 });
    expect(choicesOf(" one\n\n*  two\r\nthree")).toEqual({ choices: ["one", "two", "three"], right: 1 });
    expect(() => choicesOf("* one")).toThrow("one answer only");
    expect(() => choicesOf("one\ntwo")).toThrow("No answer is marked");
    expect(() => choicesOf("*one\n*two")).toThrow("Several answers are marked");
  });
});
