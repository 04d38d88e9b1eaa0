import type { Window } from "./documents";

/** A part of the way to another window, so that a picture under the hand does not leap. */
export function towards(from: Window, to: Window): Window {
  const way = ([a, b]: [number, number], [c, d]: [number, number]): [number, number] => [a + 0.2 * (c - a), b + 0.2 * (d - b)];
  return { h: way(from.h, to.h), l: way(from.l, to.l) };
}
