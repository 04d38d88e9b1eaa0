import type { Window } from "../bindings/documents";

/** A window on the way from one to another: at 0 the first, at 1 the second, begun and ended slowly. */
export function between(from: Window, to: Window, share: number): Window {
  const eased = share * share * (3 - 2 * share);
  const way = ([a, b]: [number, number], [c, d]: [number, number]): [number, number] => [(1 - eased) * a + eased * c, (1 - eased) * b + eased * d];
  return { h: way(from.h, to.h), l: way(from.l, to.l) };
}

export const same = (one: Window, other: Window): boolean => [...one.h, ...one.l].every((end, i) => end === [...other.h, ...other.l][i]);
