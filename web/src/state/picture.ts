/** The picture of the diagram: drawn by a worker or, under the hand, on the page's own thread; what was asked for last wins. */
import { Superseded, type Channel } from "../bindings/client";
import type { Hand } from "../bindings/hand";
import type { Arguments, Drawing, Place } from "../bindings/calls";
import type { Atlas, Window } from "../bindings/documents";
import type { Emitter } from "./emitter";
import type { Drawn, Shadow } from "./known";
import { valueOf } from "./numbers";
import { PlaneChart } from "./chart";
import { StraightChart } from "./straight";
import { bodyText, type State } from "./state";
import { between, same } from "./view";
import { texts } from "../texts";

/** Milliseconds that the axes take to their new place, and that old curves stay. */
const [GLIDE, SHADOW] = [350, 1000];
/** So much of its size a panel may change before the straightened plane is fitted to it anew. */
const RESIZED = 0.15;

/** Whose state is drawn. */
interface Owner extends Emitter {
  readonly state: State;
  readonly dragging: "body" | "point" | "view" | null;
  tell(notice: string): void;
}

export class Picture {
  drawn: Drawn | null = null;
  shadow: Shadow | null = null;
  /** True while the shadow stays, to compare with. */
  pinned = false;
  /** Size of the diagram in pixels, which rows and curves are made for. */
  resolution = { width: 600, height: 400 };
  /** The window that is kept while the body moves, and the shares of the straightened plane; null: those that fit best. */
  private held: Window | null = null;
  private shares: Float64Array | null = null;
  /** The size that these were made for. */
  private fitted = { width: 0, height: 0 };
  private fading: ReturnType<typeof setTimeout> | undefined;
  /** The fast document that is drawn, and its text. */
  private sketched: Atlas | null = null;
  private sketchText = "";
  /** How many drawings were asked for, and which of them was made last. */
  private asked = 0;
  private answered = 0;
  /** The drawing that was asked for last. */
  private drawing: Promise<Place | null> = Promise.resolve(null);

  constructor(private readonly owner: Owner, private readonly pencil: Channel, private readonly hand: Hand) {}

  /** Nothing is kept of what was shown before. */
  begin(): void {
    this.held = this.shares = null;
    if (!this.pinned) this.shadow = null;
  }

  /** The body is about to move: axes hold, and its curves stay in sight. */
  hold(): void {
    clearTimeout(this.fading);
    this.shadow ??= this.outline();
    this.held ??= this.owner.state.view ? null : (this.drawn?.window ?? null);
  }

  /** The straightened plane is fitted to the body anew. */
  fit(): void {
    this.shares = null;
  }

  /** Of another kind than before: its curves are not to be compared. */
  turn(): void {
    this.shares = this.shadow = null;
    this.pinned = false;
    this.owner.emit("shadow");
  }

  /** Nothing of an older body stays. */
  clear(): void {
    this.drawn = this.held = null;
  }

  /** Keeps the curves that are drawn now to compare others with, or lets them go. */
  pin(): void {
    this.pinned = !this.pinned;
    this.shadow = this.pinned ? this.outline() : null;
    this.owner.emit("shadow");
  }

  /** Old curves go after a while. */
  fade(): void {
    clearTimeout(this.fading);
    if (!this.pinned) this.fading = setTimeout(() => this.owner.dragging !== "body" && ((this.shadow = null), this.owner.emit("shadow")), SHADOW);
  }

  /** The curves as they are drawn now. */
  private outline(): Shadow | null {
    return this.drawn ? { curves: this.drawn.curves, straight: this.drawn.chart instanceof StraightChart } : null;
  }

  /** Draws what the state asks for; axes that were held glide to what suits the body. False if something else was asked for meanwhile. */
  async settle(current: () => boolean): Promise<boolean> {
    await this.latest();
    const { owner } = this;
    const from = owner.state.straight ? null : this.held;
    if (owner.state.straight) this.held = null;
    if (!from || !this.drawn) return current();
    const to = this.drawn.document.drawing.view.main;
    const calm = same(from, to) || matchMedia("(prefers-reduced-motion: reduce)").matches;
    const begun = performance.now();
    for (let share = 0; !calm && share < 1 && !owner.state.view; ) {
      if (owner.dragging === "body" || !current()) return false;
      share = Math.min(1, (performance.now() - begun) / GLIDE);
      this.held = between(from, to, share);
      await this.latest();
    }
    this.held = null;
    if (calm) await this.latest();
    return current();
  }

  /** Until the present state is drawn, whoever asked for it last. */
  private async latest(): Promise<void> {
    for (let mine = this.draw(); ; mine = this.drawing) {
      try {
        return void (await mine);
      } catch (error) {
        if (!(error instanceof Superseded) || mine === this.drawing) throw error;
      }
    }
  }

  /** Draws; what lies at the point is part of the answer while the body moves. */
  draw(): Promise<Place | null> {
    return (this.drawing = this.drawOnce());
  }

  private async drawOnce(): Promise<Place | null> {
    const { state, dragging } = this.owner;
    const [width, height] = [this.resolution.width, this.resolution.height].map(Math.round) as [number, number];
    const { point, straight } = state;
    const place: [number, number] | null = point && [valueOf(point.h), valueOf(point.l)];
    const at = dragging === "body" && place?.every(Number.isFinite) ? place : null;
    const numbers = [...state.A, ...state.r].map(valueOf);
    // Shares that were made for a very different size are made anew; a line more below moves nothing under the hand.
    const like = (now: number, then: number) => Math.abs(now - then) < RESIZED * then;
    const held = dragging === "body" || (like(width, this.fitted.width) && like(height, this.fitted.height)) ? this.shares : null;
    const momenta = Float64Array.from([Math.abs(place?.[1] ?? NaN)].filter(Number.isFinite));
    const how = straight ? { held: held ?? new Float64Array(), momenta } : null;
    const asked: Arguments<"draw"> = [bodyText(state), state.view ?? this.held, width, height, at, how];
    const own = ++this.asked;
    const drawing = (dragging === "body" ? this.hand.draw(...asked) : null) ?? (await this.pencil.latest("draw", ...asked));
    if (own < this.answered) throw new Superseded("drawn by the hand meanwhile");
    this.answered = own;
    if (!held) this.fitted = { width, height };
    this.take(drawing, numbers, width, height);
    // The picture may have got another size, or another view, while this was made.
    const { resolution } = this;
    return height === Math.round(resolution.height) && width === Math.round(resolution.width) && straight === this.owner.state.straight ? drawing.place : this.draw();
  }

  /** What was drawn is shown. */
  private take({ text, window, names, curves: points, rows, straight: found }: Drawing, numbers: number[], width: number, height: number): void {
    if (typeof found === "string") this.owner.tell(texts.failure.straight(found));
    const chart = found && typeof found !== "string" ? new StraightChart(found) : new PlaneChart(width, height, window, rows);
    this.shares = chart instanceof StraightChart ? chart.drawing.shares : null;
    const curves = new Map<string, Float64Array>();
    const numbersEach = chart instanceof StraightChart ? 3 : 2;
    let next = 0;
    for (const name of names) {
      const count = points[next++]!;
      curves.set(name, points.subarray(next, next + numbersEach * count));
      next += numbersEach * count;
    }
    // The same body in another window has the same document.
    if (text !== this.sketchText) this.sketched = JSON.parse((this.sketchText = text)) as Atlas;
    this.drawn = { document: this.sketched!, numbers, window, chart, curves };
    this.owner.emit("drawing");
  }
}
