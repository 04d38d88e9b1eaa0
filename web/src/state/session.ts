/** The state and everything that was computed of it. Panels read from here and ask here; workers are asked only here. */
import { Channel, Superseded } from "../bindings/client";
import type { Arguments, Place } from "../bindings/calls";
import type { Atlas, Classification, Critical, PartBlock, Triple, Window } from "../bindings/documents";
import { Emitter } from "./emitter";
import { format } from "./hash";
import { NOTHING, type Drawn, type Known } from "./known";
import { valueOf } from "./numbers";
import { Orbits } from "./orbits";
import { bodyText, FIRST, type Point, type State } from "./state";
import { signatureOf } from "./signature";

/** Durations that are kept. */
const FRAMES = 600;

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
  dragging: "body" | "point" | "view" | null = null;
  readonly frames: number[] = [];
  readonly orbits: Orbits;
  /** Size of the diagram in pixels, which rows and curves are made for. */
  resolution = { width: 600, height: 400 };
  private readonly pencil = new Channel(20);
  private readonly scholar = new Channel(60);
  private generation = 0;
  /** The drawing that was asked for last. */
  private drawing: Promise<void> = Promise.resolve();

  constructor() {
    super();
    this.orbits = new Orbits(this);
  }

  presets = () => this.pencil.ask("presets");

  /** Everything anew, as after loading. */
  set(state: State): void {
    this.state = state;
    this.sentence = "";
    this.emit("theme");
    this.emit("guide");
    this.emit("body");
    void this.settle();
  }

  fail(message: string): void {
    this.message = message;
    this.emit("message");
  }

  body(A: Triple, r: Triple): void {
    this.state = { ...this.state, A, r, view: this.dragging === "body" ? this.state.view : null };
    this.emit("body");
    void (this.dragging ? this.sketch() : this.settle());
  }

  point(point: Point | null): void {
    const from = this.state.point;
    this.state = { ...this.state, point };
    this.emit("point");
    if (!this.dragging) return void this.settle(false);
    if (from && point) void this.tell(from, point);
    void this.glance();
  }

  view(view: Window | null): void {
    this.state = { ...this.state, view };
    if (!this.dragging) this.write();
    void this.redraw();
  }

  /** Changes without new work: colours, embedding, guides. */
  update(change: Partial<State>, what: "theme" | "guide" | "orbits"): void {
    this.state = { ...this.state, ...change };
    this.write();
    this.emit(what);
  }

  /** The hand has come to rest. */
  release(): void {
    const was = this.dragging;
    this.dragging = null;
    if (was === "view") this.write();
    else void this.settle(was === "body");
  }

  pointAt(hover: Session["hover"]): void {
    this.hover = hover;
    this.emit("hover");
  }

  /** What lies at a place of the diagram. */
  locate = (h: number, l: number): Promise<Place> => this.pencil.latest("locate", bodyText(this.state), h, l);

  equilibria = async (l: string): Promise<Critical> => JSON.parse(await this.pencil.latest("critical", bodyText(this.state), l)) as Critical;

  partOfFile = async (...part: Arguments<"partOfFile">): Promise<PartBlock> => JSON.parse(await this.pencil.ask("partOfFile", ...part)) as PartBlock;

  partOfTensor = async (...part: Arguments<"partOfTensor">): Promise<PartBlock> => JSON.parse(await this.pencil.ask("partOfTensor", ...part)) as PartBlock;

  private write(): void {
    history.replaceState(null, "", `#${format(this.state)}`);
  }

  /** The exact answer to all that the state asks for. */
  private async settle(newBody = true): Promise<void> {
    const generation = ++this.generation;
    document.documentElement.dataset.ready = "false";
    this.message = "";
    this.write();
    try {
      if (newBody) {
        this.atlas = null;
        await Promise.all([this.picture(), this.document(generation)]);
      }
      if (generation === this.generation) await this.classify(generation);
    } catch (error) {
      if (error instanceof Superseded || generation !== this.generation) return;
      this.message = error instanceof Error ? error.message : String(error);
      if (newBody && !this.atlas) this.clear();
    }
    if (generation !== this.generation) return;
    this.emit("message");
    await new Promise((painted) => requestAnimationFrame(() => requestAnimationFrame(painted)));
    if (generation === this.generation) document.documentElement.dataset.ready = "true";
  }

  /** Nothing of an older body stays beside a message. */
  private clear(): void {
    this.drawn = null;
    this.text = "";
    this.critical = [];
    this.orbits.close();
    this.learn(NOTHING);
    this.emit("drawing");
  }

  private async document(generation: number): Promise<void> {
    const text = await this.scholar.latest("atlas", bodyText(this.state));
    if (generation !== this.generation) return;
    this.text = text;
    this.atlas = JSON.parse(text) as Atlas;
    this.emit("atlas");
  }

  /** Draws while the body moves under the hand. */
  private async sketch(): Promise<void> {
    const begun = performance.now();
    try {
      await this.draw();
      if (this.state.point) await this.look();
    } catch (error) {
      if (error instanceof Superseded) return;
      return this.fail(error instanceof Error ? error.message : String(error));
    }
    this.frame(begun);
    if (this.message) this.fail("");
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

  /** Until the present state is drawn, whoever asked for it last. */
  private async picture(): Promise<void> {
    for (let mine = this.draw(); ; mine = this.drawing) {
      try {
        return await mine;
      } catch (error) {
        if (!(error instanceof Superseded) || mine === this.drawing) throw error;
      }
    }
  }

  private draw(): Promise<void> {
    return (this.drawing = this.drawOnce());
  }

  private async drawOnce(): Promise<void> {
    const { width, height } = this.resolution;
    const from = this.dragging === "body" ? (this.drawn?.window ?? null) : null;
    const drawing = await this.pencil.latest("draw", bodyText(this.state), this.state.view, from, Math.round(height), width);
    const curves = new Map<string, Float64Array>();
    let at = 0;
    for (const name of drawing.names) {
      const count = drawing.curves[at++]!;
      curves.set(name, drawing.curves.subarray(at, at + 2 * count));
      at += 2 * count;
    }
    const { window, rows, rowCount } = drawing;
    this.drawn = { document: JSON.parse(drawing.text) as Atlas, window, rows, rowCount, curves };
    this.emit("drawing");
    // The picture may have got another size while this was made.
    if (rowCount !== Math.round(this.resolution.height)) await this.draw();
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
  private async tell(from: Point, to: Point): Promise<void> {
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
    const place = await this.pencil.latest("locate", bodyText(this.state), valueOf(point.h), valueOf(point.l));
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
    const found = JSON.parse(await this.scholar.ask("classify", body, point.h, point.l)) as Classification;
    const critical = JSON.parse(await this.scholar.ask("critical", body, point.l)) as Critical;
    if (generation !== this.generation) return;
    this.critical = critical.critical;
    const { status, region, components, margin } = found;
    this.learn({ status, region, signature: signatureOf(components), components, margin, exact: true });
    await this.orbits.open(body, point, this.state);
  }
}
