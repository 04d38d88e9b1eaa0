/** The section at the present point: its orbits, as they are computed, and the motion behind one of them. */
import { Channel, Superseded } from "../bindings/client";
import type { Site } from "../bindings/calls";
import type { Orbit, Portrait } from "../bindings/documents";
import type { Vec } from "../draw/ball";
import type { Emitter } from "./emitter";
import type { Point, State } from "./state";

/** Numbers of a crossing, as `Section.follow` gives them. */
export const ROW = 13;
export const AT = { orbit: 0, index: 1, time: 2, gamma: 3, l: 6, sheet: 9, rate: 10, theta: 11, psi: 12 } as const;
/** Numbers of a moment of a motion: time, γ, l, ω, ϑ, ψ, φ, q. */
export const MOMENT = 17;
/** Orbits that are followed at a time: what is finished is drawn. The first ones soon; later more, since the last orbits
 * of a chunk leave lanes idle, and each chunk is a message and a picture. */
const CHUNK = 4;
const LARGEST_CHUNK = 16;
/** A motion is shown over so many crossings, with so many moments between two. */
const CROSSINGS_SHOWN = 60;
const MOMENTS = 40;

export class Orbits {
  /** Why there is no section; empty while there is one. */
  reason = "";
  axes: [Vec, Vec, Vec] | null = null;
  portrait: Portrait | null = null;
  starts: [number, number, number][] = [];
  /** The crossings of each orbit, a row after the other. */
  rows: Float64Array[] = [];
  /** Verdict and measures of each orbit, as far as they are known. */
  judged: (Orbit | undefined)[] = [];
  selected = 0;
  motion: Float64Array | null = null;
  /** Seconds that the crossings took to compute in the worker. */
  seconds = 0;
  running = false;
  /** Counts what is opened, so that answers to an older question are known. */
  private opening = 0;
  private site: Site = ["", "", ""];
  private crossings = 0;
  private readonly channel = new Channel(120);
  /** Verdicts take most of the time, and no batch of them needs another. */
  private readonly second = new Channel(120);

  constructor(private readonly session: Emitter) {
    for (const channel of [this.channel, this.second]) channel.begin();
  }

  get count(): number {
    return this.rows.reduce((sum, rows) => sum + rows.length / ROW, 0);
  }

  close(reason = ""): void {
    this.opening++;
    Object.assign(this, { reason, axes: null, portrait: null, starts: [], rows: [], judged: [], motion: null, running: false, seconds: 0 });
    this.reset();
    this.session.emit("section");
    this.session.emit("orbits");
    this.session.emit("motion");
  }

  /** Opens the section and follows the first orbits, one of which the body then moves along. */
  async open(body: string, { h, l }: Point, { orbits, seed, crossings }: State): Promise<void> {
    this.close();
    this.site = [body, h, l];
    this.crossings = crossings;
    await this.work(async (current) => {
      const opened = await this.channel.ask("open", this.site, orbits, seed);
      if (!current()) return;
      const [x, y, z] = [0, 3, 6].map((at) => [...opened.axes.subarray(at, at + 3)] as Vec);
      this.axes = [x!, y!, z!];
      this.portrait = opened.portrait;
      for (let at = 0; at < opened.starts.length; at += 3) this.starts.push([...opened.starts.subarray(at, at + 3)] as [number, number, number]);
      this.selected = 0;
      this.session.emit("section");
      this.running = true;
      await this.follow(0, CHUNK, crossings, current);
      await this.play(current);
    });
  }

  /** Follows the other orbits, and judges all. */
  async complete(): Promise<void> {
    const { crossings, starts } = this;
    const orbits = starts.length;
    await this.work(async (current) => {
      if (!this.running) return;
      for (let first = CHUNK, count = CHUNK; first < orbits && current(); first += count) {
        count = Math.min(first, LARGEST_CHUNK, orbits - first);
        await this.follow(first, count, crossings, current);
      }
      let next = 0;
      const judge = async (channel: Channel) => {
        for (let first = next; first < orbits && current(); first = next) {
          next += CHUNK;
          await this.judge(channel, first, Math.min(CHUNK, orbits - first), crossings, current);
        }
      };
      await Promise.all([judge(this.channel), judge(this.second)]);
      if (current()) this.running = false;
    });
    this.session.emit("orbits");
  }

  /** Work at what is open now; where it fails a sentence says why. */
  private async work(what: (current: () => boolean) => Promise<void>): Promise<void> {
    const opening = this.opening;
    const current = () => opening === this.opening;
    try {
      await what(current);
    } catch (error) {
      if (error instanceof Superseded || !current()) return;
      this.running = false;
      this.reason = error instanceof Error ? error.message : String(error);
      this.session.emit("section");
    }
  }

  /** Starts another orbit at a point of the section. */
  async start(theta: number, psi: number, sheet: number, crossings: number): Promise<void> {
    const opening = this.opening;
    const current = () => opening === this.opening;
    const orbit = this.starts.length;
    this.starts.push([theta, psi, sheet]);
    try {
      await this.follow(orbit, 1, crossings, current);
      if (!current()) return;
      this.select(orbit);
      await this.judge(this.channel, orbit, 1, crossings, current);
    } catch (error) {
      if (error instanceof Superseded) return;
      this.starts.splice(orbit, 1);
      throw error;
    }
  }

  select(orbit: number): void {
    if (orbit === this.selected && this.motion) return;
    this.selected = orbit;
    this.session.emit("selection");
    const opening = this.opening;
    void this.play(() => opening === this.opening && this.selected === orbit).catch(() => undefined);
  }

  private reset(): void {
    for (const channel of [this.channel, this.second]) channel.reset();
  }

  stop(): void {
    this.opening++;
    this.running = false;
    this.reset();
    this.session.emit("orbits");
  }

  /** In which component of U vectors γ lie. */
  parts = (gammas: Float64Array): Promise<Int32Array> => this.channel.ask("parts", this.site, gammas);

  private flat = (first: number, count: number) => Float64Array.from(this.starts.slice(first, first + count).flat());

  private async follow(first: number, count: number, crossings: number, current: () => boolean): Promise<void> {
    const starts = this.flat(first, count);
    const { rows: found, seconds } = await this.channel.ask("follow", this.site, starts, first, crossings);
    if (!current()) return;
    this.seconds += seconds;
    let from = 0;
    for (let at = 0; at <= found.length; at += ROW) {
      if (at < found.length && found[at] === found[from]) continue;
      if (at > from) this.rows[found[from]!] = found.subarray(from, at);
      from = at;
    }
    for (let orbit = first; orbit < first + starts.length / 3; orbit++) this.rows[orbit] ??= new Float64Array(0);
    this.session.emit("orbits");
  }

  /** Their verdicts, from the same starts over as many crossings. */
  private async judge(channel: Channel, first: number, count: number, crossings: number, current: () => boolean): Promise<void> {
    const found = await channel.ask("judge", this.site, this.flat(first, count), crossings);
    if (!current()) return;
    found.forEach((orbit, i) => (this.judged[first + i] = { ...orbit, orbit: first + i }));
    this.session.emit("orbits");
  }

  private async play(current: () => boolean): Promise<void> {
    const start = this.starts[this.selected];
    const rows = this.rows[this.selected];
    if (!start || !rows) return;
    const crossings = rows.length / ROW;
    const last = Math.min(crossings, CROSSINGS_SHOWN) - 1;
    const end = last > 0 ? rows[last * ROW + AT.time]! : 20;
    const count = Math.max(200, MOMENTS * Math.max(1, last));
    const times = Float64Array.from({ length: count + 1 }, (_, i) => (end * i) / count);
    const motion = await this.channel.ask("motion", this.site, start[0], start[1], start[2], times);
    if (!current()) return;
    this.motion = motion;
    this.session.emit("motion");
  }
}
