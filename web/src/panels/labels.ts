/** Which component of U a direction belongs to: pieces found by flooding a grid, each named by the module's proof for one of its points. */
import type { Vec } from "../draw/ball";
import { valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { potential } from "./potential";

/** Cells along an edge of each face of the cube round the sphere. */
const EDGE = 48;
const CELLS = 6 * EDGE * EDGE;

const FACES: [Vec, Vec, Vec][] = [
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[-1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
  [[0, -1, 0], [0, 0, 1], [1, 0, 0]], [[0, 0, 1], [1, 0, 0], [0, 1, 0]], [[0, 0, -1], [1, 0, 0], [0, 1, 0]],
];

function center(cell: number): Vec {
  const [front, u, v] = FACES[Math.floor(cell / (EDGE * EDGE))]!;
  const [x, y] = [(2 * ((cell % EDGE) + 0.5)) / EDGE - 1, (2 * ((Math.floor(cell / EDGE) % EDGE) + 0.5)) / EDGE - 1];
  const g = [0, 1, 2].map((i) => front[i]! + x * u[i]! + y * v[i]!) as Vec;
  const size = Math.hypot(...g);
  return [g[0] / size, g[1] / size, g[2] / size];
}

function cellOf(g: Vec): number {
  const sizes = g.map(Math.abs) as Vec;
  const axis = sizes[0] >= sizes[1] && sizes[0] >= sizes[2] ? 0 : sizes[1] >= sizes[2] ? 1 : 2;
  const face = 2 * axis + (g[axis]! < 0 ? 1 : 0);
  const [, u, v] = FACES[face]!;
  const along = (w: Vec) => Math.min(EDGE - 1, Math.floor(((w[0] * g[0] + w[1] * g[1] + w[2] * g[2]) / sizes[axis]! + 1) * 0.5 * EDGE));
  return face * EDGE * EDGE + along(v) * EDGE + along(u);
}

const CENTERS = Array.from({ length: CELLS }, (_, cell) => center(cell));

/** The four cells beside each, found by stepping over its edges; also over those of the cube. */
const BESIDE = CENTERS.map((g, cell) => {
  const [, u, v] = FACES[Math.floor(cell / (EDGE * EDGE))]!;
  const step = 1.7 / EDGE;
  return [u, v].flatMap((w) => [step, -step].map((s) => cellOf([g[0] + s * w[0], g[1] + s * w[1], g[2] + s * w[2]])));
});

export class Labels {
  ready: () => void = () => undefined;
  private labels: Int8Array | null = null;

  constructor(private readonly session: Session) {}

  forget(): void {
    this.labels = null;
  }

  /** The number of the component; undefined while it is not known, −1 outside. */
  at(g: Vec | null): number | undefined {
    return g && this.labels ? this.labels[cellOf(g)] : undefined;
  }

  /** Floods the pieces of U at the present point, and asks which component each is. */
  learn(): void {
    this.labels = null;
    const { point, A, r } = this.session.state;
    if (!point || !this.session.orbits.portrait || (this.session.known.components?.length ?? 0) < 2) return;
    const u = potential(A.map(valueOf) as Vec, r.map(valueOf) as Vec, valueOf(point.l));
    const h = valueOf(point.h);
    const pieces = new Int16Array(CELLS).fill(-1);
    const deepest: { cell: number; value: number }[] = [];
    for (let cell = 0; cell < CELLS; cell++) {
      if (pieces[cell] !== -1 || u(CENTERS[cell]!) > h) continue;
      const piece = deepest.push({ cell, value: Infinity }) - 1;
      const stack = [cell];
      pieces[cell] = piece;
      for (let next = stack.pop(); next !== undefined; next = stack.pop()) {
        const value = u(CENTERS[next]!);
        if (value < deepest[piece]!.value) deepest[piece] = { cell: next, value };
        for (const other of BESIDE[next]!) {
          if (pieces[other] !== -1 || u(CENTERS[other]!) > h) continue;
          pieces[other] = piece;
          stack.push(other);
        }
      }
    }
    const gammas = Float64Array.from(deepest.flatMap(({ cell }) => CENTERS[cell]!));
    const opening = this.session.orbits.portrait;
    void this.session.orbits.parts(gammas).then(
      (parts) => {
        if (this.session.orbits.portrait !== opening) return;
        this.labels = Int8Array.from(pieces, (piece) => (piece < 0 ? -1 : (parts[piece] ?? -1)));
        this.ready();
      },
      () => undefined,
    );
  }
}
