/** The chaotic share over the diagram: cells that are asked of a worker tile by tile, from coarse to fine. */
import { Channel, Superseded } from "../bindings/client";
import type { Triple, Window } from "../bindings/documents";

/** Cells along each side of a map, the standard deviation that is wanted, and the steps of the integrator after which an orbit is open. */
export interface Level {
  cells: number;
  error: number;
  steps: number;
}

export const LEVELS: readonly Level[] = [
  { cells: 16, error: 0.15, steps: 2560 },
  { cells: 32, error: 0.1, steps: 5120 },
  { cells: 64, error: 0.08, steps: 20480 },
];

/** Cells along a side of a tile, and numbers of a row of `Shares.tile`. */
const [TILE, ROW] = [8, 10];

/** What was found of one component of a region in a cell. */
export interface Share {
  fraction: number;
  open: number;
  orbits: number;
  error: number;
  /** Which part of the block belongs to the region. */
  part: number;
}

interface Found {
  level: Level;
  tiles: Set<number>;
  /** By cell, region and component. */
  shares: Map<number, Share>;
}

export class ChaosMap {
  running = false;
  message = "";
  window: Window | null = null;
  /** The most components of a region that was met. */
  components = 1;
  /** Grows with all that is found. */
  version = 0;
  private levels: Found[] = [];
  private run = 0;
  private readonly channel = new Channel(600);

  constructor(private readonly told: () => void) {}

  /** Ends the work and forgets what was found: the answer to an older question is none. */
  clear(): void {
    this.run++;
    if (this.running) this.channel.reset();
    this.running = false;
    this.window = null;
    this.components = 1;
    this.levels = [];
    this.version++;
    this.message = "";
    this.told();
  }

  /** Measures a window, each level finer than the one before. */
  async measure(A: Triple, r: Triple, window: Window): Promise<void> {
    this.clear();
    const own = this.run;
    this.window = window;
    this.running = true;
    try {
      for (const level of LEVELS) {
        const found: Found = { level, tiles: new Set(), shares: new Map() };
        this.levels.push(found);
        const tiles = (level.cells / TILE) ** 2;
        for (let tile = 0; tile < tiles; tile++) {
          const rows = await this.channel.ask("tile", A, r, [...window.h, ...window.l], [level.cells, level.cells], tile, level.error, level.steps);
          if (own !== this.run) return;
          this.take(found, tile, rows);
          this.told();
        }
      }
    } catch (error) {
      if (error instanceof Superseded || own !== this.run) return;
      this.message = error instanceof Error ? error.message : String(error);
    }
    this.running = false;
    this.told();
  }

  /** The share at a point of a region, from the finest cells that are there; null where it was not met; undefined where nothing is known yet. */
  at(h: number, l: number, region: number, component: number): Share | null | undefined {
    if (!this.window) return undefined;
    const { window } = this;
    const along = (value: number, [from, to]: [number, number]) => (value - from) / (to - from);
    const [x, y] = [along(h, window.h), along(l, window.l)];
    if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) return undefined;
    for (let k = this.levels.length - 1; k >= 0; k--) {
      const { level, tiles, shares } = this.levels[k]!;
      const [i, j] = [Math.floor(x * level.cells), Math.floor(y * level.cells)];
      if (!tiles.has(Math.floor(i / TILE) * (level.cells / TILE) + Math.floor(j / TILE))) continue;
      return shares.get(key(i, j, region, component)) ?? null;
    }
    return undefined;
  }

  /** The finest level of which everything is measured, else the coarsest; how much of the next is done; and the means over it. */
  get summary(): { level: Level; next: { level: Level; share: number } | null; open: number; error: number } | null {
    const whole = ({ level, tiles }: Found) => tiles.size / (level.cells / TILE) ** 2;
    const last = this.levels.findLast((found) => whole(found) === 1) ?? this.levels[0];
    if (!last) return null;
    const next = this.levels.find((found) => whole(found) < 1);
    let [parts, open, error] = [0, 0, 0];
    for (const share of last.shares.values()) {
      if (share.orbits === 0) continue;
      parts += share.part;
      open += share.part * share.open;
      error = Math.max(error, share.error);
    }
    return { level: last.level, next: next ? { level: next.level, share: whole(next) } : null, open: open / (parts || 1), error };
  }

  private take({ tiles, shares }: Found, tile: number, rows: Float64Array): void {
    tiles.add(tile);
    for (let at = 0; at < rows.length; at += ROW) {
      const [i, j, region, component, part, , chaotic, open, orbits, error] = rows.subarray(at, at + ROW) as unknown as [number, number, number, number, number, number, number, number, number, number];
      shares.set(key(i, j, region, component), { fraction: chaotic / orbits, open: orbits > 0 ? open / orbits : 0, orbits, error, part });
      this.components = Math.max(this.components, component + 1);
    }
    this.version++;
  }
}

/** A number, since each pixel asks: cells along a side, regions and components are far fewer than 4,096. */
const key = (i: number, j: number, region: number, component: number): number => ((component * 4096 + region) * 4096 + i) * 4096 + j;
