/** Work that waits for frames: all at once while they come in time, one piece a frame after a late one. */
import { beforeEach, expect, test, vi } from "vitest";

let asked: ((time: number) => void)[] = [];
let inTurn: typeof import("../../src/draw/turns").inTurn;
let time = 0;
let done: string[] = [];

/** A frame so many milliseconds after the one before; what was done in it. */
function frame(after: number): string {
  time += after;
  done = [];
  for (const call of asked.splice(0)) call(time);
  return done.join("");
}
const work = ["a", "b", "c"].map((name) => () => void done.push(name));
const ask = () => work.forEach((one) => inTurn(one));

beforeEach(async () => {
  asked = [];
  vi.stubGlobal("requestAnimationFrame", (call: (time: number) => void) => asked.push(call));
  vi.resetModules();
  ({ inTurn } = await import("../../src/draw/turns"));
});

test("frames in time do all, once however often it was asked", () => {
  ask();
  ask();
  expect(frame(16)).toBe("abc");
  expect(asked.length).toBe(0);
  ask();
  expect(frame(17)).toBe("abc");
});

test("after a late frame each has its turn, and nobody is passed over while all ask anew", () => {
  ask();
  frame(16);
  ask();
  expect(frame(34)).toBe("a");
  ask();
  expect([frame(16), frame(16), frame(16)]).toEqual(["b", "c", "a"]);
  expect(asked.length).toBe(0);
});

test("after thirty frames in time all are done with each again; a pause of the hand is no late frame", () => {
  ask();
  frame(16);
  ask();
  frame(34);
  for (let k = 0; k < 29; k++) {
    ask();
    expect(frame(16).length).toBe(1);
  }
  ask();
  expect(frame(16).length).toBe(3);
  ask();
  expect(frame(500)).toBe("abc");
});
