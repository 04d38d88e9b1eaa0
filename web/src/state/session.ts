/** The state and everything that was computed of it. Panels read from here and ask here; workers are asked only here. */
import { Channel, Superseded } from "../bindings/client";
import { Hand } from "../bindings/hand";
import type { Arguments, Place } from "../bindings/calls";
import type { Atlas, Classification, Critical, PartBlock, Triple, Window } from "../bindings/documents";
import { Emitter } from "./emitter";
import { format } from "./hash";
import { NOTHING, type Drawn, type Known, type Shadow } from "./known";
import { valueOf } from "./numbers";
import { Orbits } from "./orbits";
import { ChaosMap } from "./chaos";
import { PlaneChart } from "./chart";
import { places } from "./places";
import { StraightChart } from "./straight";
import { bodyText, FIRST, START, type Point, type State } from "./state";
import { signatureOf } from "./signature";
import { between, same } from "./view";
import { texts } from "../texts";

/** Durations that are kept. */
const FRAMES = 600;
/** Milliseconds that the axes take to their new place, that old curves stay, and within which steps are one entry of the history. */
const [GLIDE, SHADOW, STEPS] = [350, 1000, 700];
/** So much of its size a panel may change before the straightened plane is fitted to it anew. */
const RESIZED = 0.15;
/** A point that the page chooses is at least so many pixels from every curve, if one is. */
const CLEAR = 8;

export class Session extends Emitter {
  state: State = FIRST;
  drawn: Drawn | null = null;
  /** The exact document of the body, and its text; null while it is being made. */
  atlas: Atlas | null = null;
  text = "";
  known: Known = NOTHING;
  critical: Critical["critical"] = [];
  /** What happened when the point last went over a curve. */
  sentence = "";
  /** The region or curve under the pointer, wherever it is pointed at. */
  hover: { region?: string; curve?: string; component?: number } = {};
  message = "";
  /** What is told beside errors. */
  notice = "";
  shadow: Shadow | null = null;
  /** True while the shadow stays, to compare with. */
  pinned = false;
  /** True while the page shows something by itself: the address stays. */
  quiet = false;
  dragging: "body" | "point" | "view" | null = null;
  readonly frames: number[] = [];
  readonly orbits: Orbits;
  readonly chaos = new ChaosMap(() => this.emit("chaos"));
  /** Size of the diagram in pixels, which rows and curves are made for. */
  resolution = { width: 600, height: 400 };
  private readonly pencil = new Channel(20);
  /** What the pencil does, under the hand. */
  private readonly hand = new Hand();
  private readonly scholar = new Channel(60);
  /** Makes the atlas with all verdicts, which takes tenths of a second: nothing that the hand does waits for it. */
  private readonly archivist = new Channel(60);
  private generation = 0;
  /** The window that is kept while the body moves, and the shares of the straightened plane; null: those that fit best. */
  private held: Window | null = null;
  private shares: Float64Array | null = null;
  /** The size that these were made for. */
  private fitted = { width: 0, height: 0 };
  private fading: ReturnType<typeof setTimeout> | undefined;
  /** Whether a point is chosen where none is given, and whether the address was just opened, or stays as it is wrong. */
  private choosing = true;
  private opened: boolean | "wrong" = true;
  private written = 0;
  private failed = false;
  /** The fast document that is drawn, and its text. */
  private sketched: Atlas | null = null;
  private sketchText = "";
  /** How many drawings were asked for, and which of them was made last. */
  private asked = 0;
  private answered = 0;
  /** The drawing that was asked for last. */
  private drawing: Promise<Place | null> = Promise.resolve(null);

  constructor() {
    super();
    this.archivist.begin();
    this.orbits = new Orbits(this);
  }

  /** Everything anew; `opened`: from the address, which is not another step then. A wrong one stays. */
  set(state: State, opened: boolean | "wrong" = false): void {
    this.state = state;
    this.opened = opened;
    this.choosing = true;
    this.held = this.shares = null;
    if (!this.pinned) this.shadow = null;
    this.sentence = this.notice = "";
    this.emit("theme");
    this.emit("guide");
    this.emit("body");
    void this.settle();
  }

  fail(message: string): void {
    this.message = message;
    this.emit("message");
  }

  /** Another body, whose point the page chooses. */
  adopt(A: Triple, r: Triple): void {
    this.state = { ...this.state, point: null };
    this.choosing = true;
    this.body(A, r);
  }

  body(A: Triple, r: Triple): void {
    clearTimeout(this.fading);
    this.shadow ??= this.outline();
    this.held ??= this.state.view ? null : (this.drawn?.window ?? null);
    this.state = { ...this.state, A, r, view: this.dragging === "body" ? this.state.view : null };
    const drawing = this.dragging ? this.sketch() : null;
    this.emit("body");
    void (drawing ?? this.settle());
  }

  point(point: Point | null): void {
    const from = this.state.point;
    this.choosing = false;
    this.state = { ...this.state, point };
    this.emit("point");
    const { chart } = this.drawn ?? {};
    if (point && chart instanceof StraightChart && !chart.knows(valueOf(point.l))) void this.redraw();
    if (!this.dragging) return void this.settle(false);
    if (from && point) void this.cross(from, point);
    void this.glance();
  }

  /** The curves as they are drawn now. */
  private outline(): Shadow | null {
    return this.drawn ? { curves: this.drawn.curves, straight: this.drawn.chart instanceof StraightChart } : null;
  }

  /** Straightens the plane, or shows it as it is. */
  straighten(straight: boolean): void {
    this.state = { ...this.state, straight };
    this.shares = this.shadow = null;
    this.pinned = false;
    this.emit("shadow");
    this.write(true);
    this.emit("theme");
    void this.redraw();
  }

  view(view: Window | null): void {
    this.state = { ...this.state, view };
    if (!this.dragging) this.write(true);
    void this.redraw();
  }

  /** Changes without new work: colours, embedding, guides. */
  update(change: Partial<State>, what: "theme" | "guide" | "orbits"): void {
    this.state = { ...this.state, ...change };
    this.write(true);
    this.emit(what);
  }

  /** The address says what is shown. */
  settled(): void {
    this.write();
  }

  /** The hand has come to rest. */
  release(): void {
    const was = this.dragging;
    this.dragging = null;
    this.hand.rest();
    if (was === "view") this.write(true);
    else void this.settle(was === "body");
  }

  pointAt(hover: Session["hover"]): void {
    this.hover = hover;
    this.emit("hover");
  }

  /** What lies at a place of the diagram. */
  locate = (h: number, l: number): Promise<Place> => this.pencil.latest("locate", bodyText(this.state), h, l);

  equilibria = async (l: string): Promise<Critical> => JSON.parse(await this.pencil.latest("critical", bodyText(this.state), l)) as Critical;

  /** Where the class of bodies changes between two of them, and by what. */
  border = (from: number[], to: number[]) => this.scholar.ask("border", Float64Array.from(from), Float64Array.from(to));

  partOfFile = async (...part: Arguments<"partOfFile">): Promise<PartBlock> => JSON.parse(await this.pencil.ask("partOfFile", ...part)) as PartBlock;

  partOfTensor = async (...part: Arguments<"partOfTensor">): Promise<PartBlock> => JSON.parse(await this.pencil.ask("partOfTensor", ...part)) as PartBlock;

  /** Keeps the curves that are drawn now to compare others with, or lets them go. */
  pin(): void {
    this.pinned = !this.pinned;
    this.shadow = this.pinned ? this.outline() : null;
    this.emit("shadow");
  }

  /** The address follows what is settled; each rest is a step to go back to, unless it only looks at the same in another way. */
  private write(replace = false): void {
    const hash = `#${format(this.state)}`;
    if (this.quiet || this.failed || this.opened === "wrong" || hash === location.hash) return;
    const now = performance.now();
    if (replace || this.opened || now - this.written < STEPS) history.replaceState(null, "", hash);
    else history.pushState(null, "", hash);
    this.written = now;
    this.emit("address");
  }

  /** The exact answer to all that the state asks for: first what is seen and moves, then verdicts. */
  private async settle(newBody = true): Promise<void> {
    const generation = ++this.generation;
    document.documentElement.dataset.ready = "false";
    this.message = "";
    if (!this.opened) this.notice = "";
    this.failed = false;
    try {
      const early = newBody && this.state.point ? this.classify(generation) : null;
      early?.catch(() => undefined);
      if (newBody) this.atlas = this.shares = null;
      // Beside what a page that begins is waited for, the atlas would take half of a processor.
      const atlas = newBody && !this.opened ? this.document(generation) : null;
      atlas?.catch(() => undefined);
      if (newBody) await this.picture(generation);
      // What is wrong with the point is told beside the body's atlas.
      let wrong: unknown = null;
      if (generation === this.generation) await (early ?? this.classify(generation)).catch((error: unknown) => (wrong = error));
      if (generation === this.generation) {
        if (!wrong) void this.reach("moving", generation);
        const orbits = wrong ? null : this.orbits.complete();
        await (atlas ?? (newBody ? this.document(generation) : null));
        if (wrong) throw wrong;
        if (generation === this.generation) {
          this.write();
          this.opened = false;
        }
        await orbits;
      }
    } catch (error) {
      if (error instanceof Superseded || generation !== this.generation) return;
      this.message = error instanceof Error ? error.message : String(error);
      this.failed = true;
      if (newBody && !this.atlas) this.clear();
    }
    if (generation !== this.generation) return;
    this.emit("message");
    if (newBody) this.fade();
    await this.reach("true", generation);
  }

  /** Tells how far the page is, once that is painted: "moving", the picture is there, the point is decided and the body turns; "true", all is. */
  private async reach(stage: "moving" | "true", generation: number): Promise<void> {
    await new Promise((painted) => requestAnimationFrame(() => requestAnimationFrame(painted)));
    const { dataset } = document.documentElement;
    if (generation !== this.generation || dataset.ready === "true") return;
    dataset.ready = stage;
    this.emit("ready");
  }

  /** Nothing of an older body stays beside a message. */
  private clear(): void {
    this.drawn = this.held = null;
    this.text = "";
    this.critical = [];
    this.orbits.close();
    this.learn(NOTHING);
    this.emit("drawing");
  }

  private async document(generation: number): Promise<void> {
    const text = await this.archivist.latest("atlas", bodyText(this.state));
    if (generation !== this.generation) return;
    this.text = text;
    this.atlas = JSON.parse(text) as Atlas;
    this.emit("atlas");
  }

  /** Draws while the body moves under the hand. */
  private async sketch(): Promise<void> {
    const begun = performance.now();
    try {
      const place = await this.draw();
      if (place) this.see(place);
    } catch (error) {
      if (error instanceof Superseded) return;
      return this.fail(error instanceof Error ? error.message : String(error));
    }
    this.frame(begun);
    if (this.message) this.fail("");
  }

  private tell(notice: string): void {
    this.notice = notice;
    this.emit("message");
  }

  frame(begun: number): void {
    this.frames.push(performance.now() - begun);
    if (this.frames.length > FRAMES) this.frames.shift();
  }

  /** The same body in another view or size. */
  async redraw(): Promise<void> {
    try {
      await this.draw();
    } catch (error) {
      if (!(error instanceof Superseded)) this.fail(error instanceof Error ? error.message : String(error));
    }
  }

  private fade(): void {
    clearTimeout(this.fading);
    if (!this.pinned) this.fading = setTimeout(() => this.dragging !== "body" && ((this.shadow = null), this.emit("shadow")), SHADOW);
  }

  /** Draws what the state asks for; axes that were held glide to what suits the body. */
  private async picture(generation: number): Promise<void> {
    await this.latestDrawing();
    const from = this.state.straight ? null : this.held;
    if (this.state.straight) this.held = null;
    if (from && this.drawn) {
      const to = this.drawn.document.drawing.view.main;
      const calm = same(from, to) || matchMedia("(prefers-reduced-motion: reduce)").matches;
      const begun = performance.now();
      for (let share = 0; !calm && share < 1 && !this.state.view; ) {
        if (this.dragging === "body" || generation !== this.generation) return;
        share = Math.min(1, (performance.now() - begun) / GLIDE);
        this.held = between(from, to, share);
        await this.latestDrawing();
      }
      this.held = null;
      if (calm) await this.latestDrawing();
    }
    if (generation === this.generation) this.choose();
  }

  /** Where no point is given: one deep inside a region over which U has many components. */
  private choose(): void {
    const { state, drawn } = this;
    if (state.point || !drawn || !this.choosing || state.embed === "diagram" || (state.lesson !== null && state.lesson !== "list") || state.task?.then) return;
    const paper = bodyText(state) === bodyText(START) && !state.view;
    const { regions } = drawn.document;
    const worth = (region: number, depth: number) => (depth < CLEAR ? 0 : (regions[region]?.components.length ?? 0) * (regions[region]?.signature ? 10 : 1)) + depth / 1e4;
    const [best] = [...places(drawn.chart, [])].sort(([a, { depth: x }], [b, { depth: y }]) => worth(b, y) - worth(a, x));
    if (!best) return;
    const [, { x, y }] = best;
    this.state = { ...state, point: paper ? START.point : drawn.chart.rounded(x, y) };
  }

  /** Until the present state is drawn, whoever asked for it last. */
  private async latestDrawing(): Promise<void> {
    for (let mine = this.draw(); ; mine = this.drawing) {
      try {
        return void (await mine);
      } catch (error) {
        if (!(error instanceof Superseded) || mine === this.drawing) throw error;
      }
    }
  }

  private draw(): Promise<Place | null> {
    return (this.drawing = this.drawOnce());
  }

  private async drawOnce(): Promise<Place | null> {
    const [width, height] = [this.resolution.width, this.resolution.height].map(Math.round) as [number, number];
    const { point, straight } = this.state;
    const place: [number, number] | null = point && [valueOf(point.h), valueOf(point.l)];
    const at = this.dragging === "body" && place?.every(Number.isFinite) ? place : null;
    const numbers = [...this.state.A, ...this.state.r].map(valueOf);
    // Shares that were made for a very different size are made anew; a line more below moves nothing under the hand.
    const like = (now: number, then: number) => Math.abs(now - then) < RESIZED * then;
    const held = this.dragging === "body" || (like(width, this.fitted.width) && like(height, this.fitted.height)) ? this.shares : null;
    const momenta = Float64Array.from([Math.abs(place?.[1] ?? NaN)].filter(Number.isFinite));
    const how = straight ? { held: held ?? new Float64Array(), momenta } : null;
    const asked: Arguments<"draw"> = [bodyText(this.state), this.state.view ?? this.held, width, height, at, how];
    const own = ++this.asked;
    const drawing = (this.dragging === "body" ? this.hand.draw(...asked) : null) ?? (await this.pencil.latest("draw", ...asked));
    if (own < this.answered) throw new Superseded("drawn by the hand meanwhile");
    this.answered = own;
    const curves = new Map<string, Float64Array>();
    let next = 0;
    const found = drawing.straight;
    if (typeof found === "string") this.tell(texts.failure.straight(found));
    const chart = found && typeof found !== "string" ? new StraightChart(found) : new PlaneChart(width, height, drawing.window, drawing.rows);
    this.shares = chart instanceof StraightChart ? chart.drawing.shares : null;
    if (!held) this.fitted = { width, height };
    const numbersEach = chart instanceof StraightChart ? 3 : 2;
    for (const name of drawing.names) {
      const count = drawing.curves[next++]!;
      curves.set(name, drawing.curves.subarray(next, next + numbersEach * count));
      next += numbersEach * count;
    }
    // The same body in another window has the same document.
    if (drawing.text !== this.sketchText) this.sketched = JSON.parse((this.sketchText = drawing.text)) as Atlas;
    this.drawn = { document: this.sketched!, numbers, window: drawing.window, chart, curves };
    this.emit("drawing");
    // The picture may have got another size, or another view, while this was made.
    const { resolution } = this;
    return height === Math.round(resolution.height) && width === Math.round(resolution.width) && straight === this.state.straight ? drawing.place : this.draw();
  }

  /** A quick look at the point while it moves. */
  private async glance(): Promise<void> {
    const begun = performance.now();
    try {
      await this.look();
      this.frame(begun);
    } catch (error) {
      if (!(error instanceof Superseded)) this.fail(error instanceof Error ? error.message : String(error));
    }
  }

  /** Every curve that the point goes over is told, however far apart the places are where the hand was seen. */
  private async cross(from: Point, to: Point): Promise<void> {
    const place = ({ h, l }: Point): [number, number] => [valueOf(h), valueOf(l)];
    try {
      const sentences = await this.pencil.ask("surgeries", bodyText(this.state), place(from), place(to));
      if (sentences.length === 0) return;
      this.sentence = sentences.at(-1)!;
      this.emit("point");
    } catch (error) {
      this.fail(error instanceof Error ? error.message : String(error));
    }
  }

  private async look(): Promise<void> {
    const { point } = this.state;
    if (!point || !this.drawn) return;
    const asked: Arguments<"locate"> = [bodyText(this.state), valueOf(point.h), valueOf(point.l)];
    this.see(this.hand.locate(...asked) ?? (await this.pencil.latest("locate", ...asked)));
  }

  private see(place: Place): void {
    if (!this.drawn) return;
    const region = this.drawn.document.regions[place.region];
    const components = place.region === -1 ? [] : (region?.components ?? null);
    this.learn({
      status: region ? "regular" : place.region === -1 ? "forbidden" : "undecided",
      region: region?.id ?? null,
      signature: region?.signature ?? "",
      components,
      margin: { h: place.distance, nearest: place.nearest },
      exact: false,
    });
  }

  private learn(known: Known): void {
    this.known = known;
    this.emit("point");
  }

  private async classify(generation: number): Promise<void> {
    const { point } = this.state;
    if (!point) {
      this.critical = [];
      this.orbits.close();
      this.learn(NOTHING);
      return;
    }
    const body = bodyText(this.state);
    const found = JSON.parse(await this.scholar.latest("classify", body, point.h, point.l)) as Classification;
    const critical = JSON.parse(await this.scholar.latest("critical", body, point.l)) as Critical;
    if (generation !== this.generation) return;
    this.critical = critical.critical;
    const { status, region, components, margin } = found;
    this.learn({ status, region, signature: signatureOf(components), components, margin, exact: true });
    await this.orbits.open(body, point, this.state);
  }
}
