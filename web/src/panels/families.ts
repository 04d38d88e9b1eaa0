/** Planes in the space of bodies: where a place of the map lies among bodies, and the other way round. */
import type { Triple } from "../bindings/documents";
import { rounded, stepOf, valueOf } from "../state/numbers";
import type { State } from "../state/state";
import { texts } from "../texts";

type Body = Pick<State, "A" | "r">;

export interface Family {
  id: "katok" | "eta" | "moments" | "center";
  axes: () => [string, string];
  x: [number, number];
  y: [number, number];
  /** Numbers A1, A2, A3, r1, r2, r3 of a place; null where there is no body. */
  numbers: (x: number, y: number, from: Body) => number[] | null;
  /** Where a body lies, if it does. */
  place: (body: Body) => [number, number] | null;
}

const numbersOf = ({ A, r }: Body): [number[], number[]] => [A.map(valueOf), r.map(valueOf)];

const unit = (r: number[]): number[] => r.map((x) => x / (Math.hypot(...r) || 1));

export const FAMILIES: Family[] = [
  {
    id: "katok",
    axes: () => ["A₂/A₁", "A₃/A₁"],
    x: [0, 2],
    y: [0, 2],
    numbers: (x, y) => (x > 0 && y > 0 ? [1, x, y, 1, 0, 0] : null),
    place: (body) => {
      const [a, r] = numbersOf(body) as [[number, number, number], [number, number, number]];
      return r[1] === 0 && r[2] === 0 && r[0] !== 0 ? [a[1] / a[0], a[2] / a[0]] : null;
    },
  },
  {
    id: "eta",
    axes: () => ["η = A₂/A₃", texts.bodies.angleFrom1],
    x: [0.5, 2.5],
    y: [0, 90],
    numbers: (x, y) => [2, x, 1, Math.cos((y * Math.PI) / 180), 0, y === 0 ? 0 : Math.sin((y * Math.PI) / 180)],
    place: (body) => {
      const [a, r] = numbersOf(body) as [[number, number, number], [number, number, number]];
      return a[0] === 2 * a[2] && r[1] === 0 && Math.hypot(...r) > 0 ? [a[1] / a[2], (Math.atan2(Math.abs(r[2]), Math.abs(r[0])) * 180) / Math.PI] : null;
    },
  },
  {
    id: "moments",
    axes: () => ["A₁/(A₁+A₂+A₃)", "A₂/(A₁+A₂+A₃)"],
    x: [0, 1],
    y: [0, 1],
    numbers: (x, y, from) => (x > 0 && y > 0 && x + y < 1 ? [x, y, 1 - x - y, ...unit(numbersOf(from)[1])] : null),
    place: (body) => {
      const [a] = numbersOf(body) as [[number, number, number], number[]];
      const sum = a[0] + a[1] + a[2];
      return [a[0] / sum, a[1] / sum];
    },
  },
  {
    id: "center",
    axes: () => [texts.bodies.angleFrom3, texts.bodies.angleRound],
    x: [0, 90],
    y: [0, 90],
    numbers: (x, y, from) => {
      const [polar, round] = [(x * Math.PI) / 180, (y * Math.PI) / 180];
      return [...numbersOf(from)[0], Math.sin(polar) * Math.cos(round), Math.sin(polar) * Math.sin(round), Math.cos(polar)];
    },
    place: (body) => {
      const r = unit(numbersOf(body)[1]).map(Math.abs) as [number, number, number];
      return [(Math.atan2(Math.hypot(r[0], r[1]), r[2]) * 180) / Math.PI, (Math.atan2(r[1], r[0]) * 180) / Math.PI];
    },
  },
];

/** Whether a body lies in the part of a plane that the map shows. */
export function isIn(family: Family, body: Body): boolean {
  const place = family.place(body);
  const inside = (value: number, [from, to]: [number, number]) => value >= from && value <= to;
  return place !== null && inside(place[0], family.x) && inside(place[1], family.y);
}

/** The body at a place, as short texts. */
export function bodyAt(family: Family, x: number, y: number, from: Body): Body | null {
  const numbers = family.numbers(x, y, from);
  if (!numbers) return null;
  const size = family.id === "moments" ? from.A.map(valueOf).reduce((sum, a) => sum + a, 0) : 1;
  const length = family.id === "katok" ? 1 : Math.hypot(...from.r.map(valueOf)) || 1;
  const step = stepOf(size / 3, 3);
  // No moment is rounded to 0.
  const A = numbers.slice(0, 3).map((a) => rounded(Math.max(step, size * a), step)) as Triple;
  const r = numbers.slice(3).map((x) => rounded(length * x, stepOf(length, 4))) as Triple;
  return { A: family.id === "center" ? from.A : A, r: family.id === "moments" ? from.r : r };
}
