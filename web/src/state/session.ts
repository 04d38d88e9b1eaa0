/** The state and everything that was computed of it. Panels read from here and ask here; workers are asked only here. */
import { Channel, Superseded } from "../bindings/client";
import { Hand } from "../bindings/hand";
import type { Arguments, Place } from "../bindings/calls";
import type { Atlas, Classification, Critical, PartBlock, Triple, Window } from "../bindings/documents";
import { Emitter } from "./emitter";
import { Address } from "./address";
import { chosenPoint } from "./choice";
import { knownAt, NOTHING, type Drawn, type Known } from "./known";
import { valueOf } from "./numbers";
import { Orbits } from "./orbits";
import { ChaosMap } from "./chaos";
import { Picture } from "./picture";
import { StraightChart } from "./straight";
import { bodyText, FIRST, type Point, type State } from "./state";
import { signatureOf } from "./signature";

/** Durations that are kept. */
const FRAMES = 600;

export class Session extends Emitter {
  state: State = FIRST;
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
  dragging: "body" | "point" | "view" | null = null;
  readonly frames: number[] = [];
  readonly orbits: Orbits;
  readonly chaos = new ChaosMap(() => this.emit("chaos"));
  readonly address = new Address(this);
  /** The picture of the diagram. */
  readonly picture: Picture;
  private readonly pencil = new Channel(20);
  /** What the pencil does, under the hand. */
  private readonly hand = new Hand();
  private readonly scholar = new Channel(60);
  /** Makes the atlas with all verdicts, which takes tenths of a second: nothing that the hand does waits for it. */
  private readonly archivist = new Channel(60);
  private generation = 0;
  /** Whether a point is chosen where none is given. */
  private choosing = true;

  constructor() {
    super();
    this.archivist.begin();
    this.orbits = new Orbits(this);
    this.picture = new Picture(this, this.pencil, this.hand);
  }

  get drawn(): Drawn | null {
    return this.picture.drawn;
  }

  /** Everything anew; `opened`: from the address, which is not another step then. A wrong one stays. */
  set(state: State, opened: boolean | "wrong" = false): void {
    this.state = state;
    this.address.opened = opened;
    this.choosing = true;
    this.picture.begin();
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

  tell(notice: string): void {
    this.notice = notice;
    this.emit("message");
  }

  /** Another body, whose point the page chooses. */
  adopt(A: Triple, r: Triple): void {
    this.state = { ...this.state, point: null };
    this.choosing = true;
    this.body(A, r);
  }

  body(A: Triple, r: Triple): void {
    this.picture.hold();
    if (!this.dragging) this.sentence = "";
    this.state = { ...this.state, A, r, view: this.dragging === "body" ? this.state.view : null };
    const drawing = this.dragging ? this.sketch() : null;
    this.emit("body");
    void (drawing ?? this.settle());
  }

  point(point: Point | null): void {
    const from = this.state.point;
    this.choosing = false;
    this.state = { ...this.state, point };
    if (!this.dragging) this.sentence = "";
    this.emit("point");
    const { chart } = this.drawn ?? {};
    if (point && chart instanceof StraightChart && !chart.knows(valueOf(point.l))) void this.redraw();
    if (!this.dragging) return void this.settle(false);
    if (from && point) void this.cross(from, point);
    void this.glance();
  }

  /** Straightens the plane, or shows it as it is. */
  straighten(straight: boolean): void {
    this.state = { ...this.state, straight };
    this.picture.turn();
    this.address.write(true);
    this.emit("theme");
    void this.redraw();
  }

  view(view: Window | null): void {
    this.state = { ...this.state, view };
    if (!this.dragging) this.address.write(true);
    void this.redraw();
  }

  /** Changes without new work: colours, embedding, guides. */
  update(change: Partial<State>, what: "theme" | "guide" | "orbits"): void {
    this.state = { ...this.state, ...change };
    this.address.write(true);
    this.emit(what);
  }

  /** The hand has come to rest. */
  release(): void {
    const was = this.dragging;
    this.dragging = null;
    this.hand.rest();
    if (was === "view") this.address.write(true);
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

  /** The exact answer to all that the state asks for: first what is seen and moves, then verdicts. */
  private async settle(newBody = true): Promise<void> {
    const generation = ++this.generation;
    document.documentElement.dataset.ready = "false";
    this.message = "";
    if (!this.address.opened) this.notice = "";
    this.address.failed = false;
    try {
      const early = newBody && this.state.point ? this.classify(generation) : null;
      early?.catch(() => undefined);
      if (newBody) this.atlas = null;
      if (newBody) this.picture.fit();
      // Beside what a page that begins is waited for, the atlas would take half of a processor.
      const atlas = newBody && !this.address.opened ? this.document(generation) : null;
      atlas?.catch(() => undefined);
      if (newBody && (await this.picture.settle(() => generation === this.generation))) this.choose();
      // What is wrong with the point is told beside the body's atlas.
      let wrong: unknown = null;
      if (generation === this.generation) await (early ?? this.classify(generation)).catch((error: unknown) => (wrong = error));
      if (generation === this.generation) {
        if (!wrong) void this.reach("moving", generation);
        const orbits = wrong ? null : this.orbits.complete();
        await (atlas ?? (newBody ? this.document(generation) : null));
        if (wrong) throw wrong;
        if (generation === this.generation) {
          this.address.write();
          this.address.opened = false;
        }
        await orbits;
      }
    } catch (error) {
      if (error instanceof Superseded || generation !== this.generation) return;
      this.message = error instanceof Error ? error.message : String(error);
      this.address.failed = true;
      if (newBody && !this.atlas) this.clear();
    }
    if (generation !== this.generation) return;
    this.emit("message");
    if (newBody) this.picture.fade();
    await this.reach("true", generation);
  }

  /** A point where none is given, unless the reader is to find it. */
  private choose(): void {
    const { state, drawn } = this;
    if (state.point || !drawn || !this.choosing || state.embed === "diagram" || (state.lesson !== null && state.lesson !== "list") || state.task?.then) return;
    this.state = { ...state, point: chosenPoint(state, drawn) };
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
    this.picture.clear();
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
    const { generation } = this;
    try {
      const place = await this.picture.draw();
      if (place && generation === this.generation) this.see(place);
    } catch (error) {
      if (error instanceof Superseded) return;
      return this.fail(error instanceof Error ? error.message : String(error));
    }
    this.frame(begun);
    if (this.message) this.fail("");
  }

  private frame(begun: number): void {
    this.frames.push(performance.now() - begun);
    if (this.frames.length > FRAMES) this.frames.shift();
  }

  /** The same body in another view or size. */
  async redraw(): Promise<void> {
    try {
      await this.picture.draw();
    } catch (error) {
      if (!(error instanceof Superseded)) this.fail(error instanceof Error ? error.message : String(error));
    }
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
    const { state: { point }, generation } = this;
    if (!point || !this.drawn) return;
    const asked: Arguments<"locate"> = [bodyText(this.state), valueOf(point.h), valueOf(point.l)];
    const place = this.hand.locate(...asked) ?? (await this.pencil.latest("locate", ...asked));
    // The hand may have come to rest meanwhile, and the exact answer been there first.
    if (generation === this.generation) this.see(place);
  }

  private see(place: Place): void {
    if (this.drawn) this.learn(knownAt(this.drawn.document, place));
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
