/** The cells of a map of bodies: classes asked of a worker from coarse to fine. */
import { Channel, Superseded } from "../bindings/client";
import type { State } from "../state/state";
import type { Family } from "./families";

type Body = Pick<State, "A" | "r">;

/** Cells along an edge of the finest map, and of the coarsest. */
export const FINEST = 128;
const COARSEST = 8;
/** Bodies in a question: a fraction of a second. */
const BATCH = 256;

export interface Cell {
  /** The number of the class; −1 where it is open, −2 where there is no body. */
  class: number;
  regions: number;
}

export class Cells {
  names: string[] = [];
  running = false;
  message = "";
  readonly channel = new Channel(120);
  private cells = new Map<number, Cell>();
  private run = 0;

  constructor(private readonly told: () => void) {}

  get share(): number {
    return this.cells.size / (FINEST * FINEST);
  }

  get classes(): number {
    return new Set([...this.cells.values()].map((cell) => cell.class).filter((number) => number >= 0)).size;
  }

  clear(): void {
    this.run++;
    this.running = false;
    this.channel.reset();
    this.cells = new Map();
    this.told();
  }

  /** Ends the work; what was found stays. */
  stop(): void {
    this.run++;
    this.running = false;
    this.channel.reset();
    this.told();
  }

  async fill(family: Family, from: Body): Promise<void> {
    this.clear();
    const own = this.run;
    this.message = "";
    this.running = true;
    try {
      for (let size = COARSEST; size <= FINEST; size *= 2) {
        const wanted = this.missing(size);
        for (let first = 0; first < wanted.length && own === this.run; first += BATCH) await this.ask(wanted.slice(first, first + BATCH), family, from, own);
      }
    } catch (error) {
      if (error instanceof Superseded) return;
      this.message = error instanceof Error ? error.message : String(error);
    }
    if (own !== this.run) return;
    this.running = false;
    this.told();
  }

  /** The cell of a number, or that of the finest level so far that covers it. */
  nearest(at: number): Cell | undefined {
    const [column, row] = [at % FINEST, Math.floor(at / FINEST)];
    for (let step = 1; step <= FINEST / COARSEST; step *= 2) {
      const found = this.cells.get((Math.floor(row / step) * step + (step >> 1)) * FINEST + Math.floor(column / step) * step + (step >> 1));
      if (found) return found;
    }
    return undefined;
  }

  /** The cell at a place of the plane. */
  at({ x, y }: Family, px: number, py: number): Cell | undefined {
    const along = (value: number, [from, to]: [number, number]) => Math.floor(((value - from) / (to - from)) * FINEST);
    const [column, row] = [along(px, x), along(py, y)];
    return column >= 0 && row >= 0 && column < FINEST && row < FINEST ? this.nearest(row * FINEST + column) : undefined;
  }

  private missing(size: number): number[] {
    const step = FINEST / size;
    const numbers = Array.from({ length: size * size }, (_, k) => (Math.floor(k / size) * step + (step >> 1)) * FINEST + (k % size) * step + (step >> 1));
    return numbers.filter((at) => !this.cells.has(at));
  }

  private async ask(places: number[], family: Family, from: Body, own: number): Promise<void> {
    const bodies: number[] = [];
    const asked: number[] = [];
    for (const at of places) {
      const numbers = family.numbers(...middle(family, at), from);
      if (!numbers) this.cells.set(at, { class: -2, regions: 0 });
      else {
        asked.push(at);
        bodies.push(...numbers);
      }
    }
    const { found, names } = await this.channel.ask("classes", Float64Array.from(bodies));
    if (own !== this.run) return;
    this.names = names;
    asked.forEach((at, i) => this.cells.set(at, { class: found[2 * i]!, regions: found[2 * i + 1]! }));
    this.told();
  }
}

const middle = ({ x, y }: Family, at: number): [number, number] => [
  x[0] + (((at % FINEST) + 0.5) / FINEST) * (x[1] - x[0]),
  y[0] + ((Math.floor(at / FINEST) + 0.5) / FINEST) * (y[1] - y[0]),
];
