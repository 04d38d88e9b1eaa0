/** One worker: the module and what is kept of the last question. It answers in the order in which it is asked. */
import type { Answer, Arguments, Drawing, Name, Question, Reply, Site, StraightDrawing, Straightening } from "./calls";
import type { Orbit, Portrait, Window } from "./documents";
import { begun, diagramOf, guest, init, locate, plane, type Diagram } from "./drawing";
import { boxesOf } from "../state/names";
import partsUrl from "./generated/bifdiag_web_parts_bg.wasm?url";
import chaosUrl from "./generated/bifdiag_web_chaos_bg.wasm?url";
import straightUrl from "./generated/bifdiag_web_straight_bg.wasm?url";

const PORTRAIT_ROWS = 90;

let section: { site: string; of: guest.Section } | undefined;
let shares: { body: string; of: InstanceType<Chaos["Shares"]> } | undefined;
let classes: guest.Classes | undefined;

function sectionOf(site: Site): guest.Section {
  const name = site.join("&");
  if (section?.site !== name) {
    section?.of.free();
    section = undefined;
    section = { site: name, of: new guest.Section(...site) };
  }
  return section.of;
}

/** In the plane; or straightened where that is asked for and can be done. */
async function draw(body: string, view: Window | null, width: number, height: number, point: [number, number] | null, how: Straightening | null): Promise<Drawing> {
  const module = how && (await straights());
  let straight: string | null = null;
  if (module && how) {
    try {
      const { curves, ...found } = straighten(module, diagramOf(body), width, height, how);
      return { ...begun(body, view, width, height, point), rows: new Float64Array(), curves, straight: found };
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) throw error;
      straight = error instanceof Error ? error.message : String(error);
    }
  }
  return { ...plane(body, view, width, height, point), straight };
}

/** The diagram of a body, straightened. */
function straighten(module: Straights, { of, text, document }: Diagram, width: number, height: number, { held, momenta }: Straightening): StraightDrawing & { curves: Float64Array } {
  // The shares are fitted to three forms of a name: on two lines, on one line, and the id alone.
  const boxes = Float64Array.from(document.regions.flatMap((region) => boxesOf(region).flat()));
  const found = new module.Straight(text, of, width, height, boxes, held, momenta);
  try {
    const ticks = [0, 1, 2].map((axis) => ({ at: found.ticks(axis), texts: found.labels(axis) }));
    return { width, height, shares: found.shares(), columns: found.columns(), curves: found.curves(), events: found.events(), levels: found.levels(), ticks, end: found.l_end() };
  } finally {
    found.free();
  }
}

type Parts = typeof import("./generated/bifdiag_web_parts.js");
type Chaos = typeof import("./generated/bifdiag_web_chaos.js");
type Straights = typeof import("./generated/bifdiag_web_straight.js");

/** A module of its own, loaded when first used. Fetched as bytes: no server needs to know its type. */
function later<M extends { default: (input: { module_or_path: ArrayBuffer }) => Promise<unknown> }>(what: string, url: string, script: () => Promise<M>): () => Promise<M> {
  let loaded: Promise<M> | undefined;
  const load = async () => {
    const module = await script();
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${what} could not be loaded: ${response.status} ${response.statusText}`);
    await module.default({ module_or_path: await response.arrayBuffer() });
    return module;
  };
  return () => (loaded ??= load().catch((error: unknown) => {
    loaded = undefined;
    throw error;
  }));
}

const parts = later<Parts>("the readers of parts", partsUrl, () => import("./generated/bifdiag_web_parts.js"));
const chaos = later<Chaos>("the chaotic share", chaosUrl, () => import("./generated/bifdiag_web_chaos.js"));
const straights = later<Straights>("the straightened diagram", straightUrl, () => import("./generated/bifdiag_web_straight.js"));

const answers: { [N in Name]: (...values: Arguments<N>) => Answer<N> | Promise<Answer<N>> } = {
  draw,
  locate,
  surgeries: (body, from, to) => diagramOf(body).of.surgeries(Float64Array.from(from), Float64Array.from(to)),
  partOfFile: async (...part) => (await parts()).part_of_file(...part),
  partOfTensor: async (...part) => (await parts()).part_of_tensor(...part),
  atlas: (body) => guest.atlas(body),
  classify: (body, h, l) => guest.classify(body, h, l),
  critical: (body, l) => guest.critical(body, l),
  open(site, orbits, seed) {
    const of = sectionOf(site);
    const portrait = JSON.parse(of.portrait(PORTRAIT_ROWS)) as Portrait;
    return { axes: of.axes(), starts: of.starts(orbits, seed), portrait };
  },
  follow(site, starts, first, crossings) {
    const of = sectionOf(site);
    const begun = performance.now();
    const rows = of.follow(starts, first, crossings);
    return { rows, seconds: (performance.now() - begun) / 1000 };
  },
  judge: (site, starts, crossings) => JSON.parse(sectionOf(site).judge(starts, crossings)) as Orbit[],
  parts: (site, gammas) => sectionOf(site).components(gammas),
  motion: (site, theta, psi, sheet, times) => sectionOf(site).motion(theta, psi, sheet, times),
  async tile(A, r, window, cells, tile, error, steps) {
    const module = await chaos();
    const body = [...A, ...r].join("&");
    if (shares?.body !== body) {
      shares?.of.free();
      shares = undefined;
      shares = { body, of: new module.Shares(A, r) };
    }
    return shares.of.tile(Float64Array.from(window), Uint32Array.from(cells), tile, error, steps);
  },
  border(from, to) {
    const [t, error, text] = guest.border(from, to) as [string, string, string];
    return { t: Number(t), error: Number(error), text };
  },
  classes(bodies) {
    classes ??= new guest.Classes();
    const found = classes.of(bodies);
    const names: string[] = [];
    for (let name = classes.name(0); name !== undefined; name = classes.name(names.length)) names.push(name);
    return { found, names };
  },
};

/** The arrays of an answer, which are handed over instead of copied. */
function arrays(answer: unknown): ArrayBuffer[] {
  const parts = typeof answer === "object" && answer && !ArrayBuffer.isView(answer) ? Object.values(answer) : [answer];
  return parts.filter((part) => ArrayBuffer.isView(part)).map((part) => part.buffer as ArrayBuffer);
}

let able: Promise<unknown> | undefined;

self.onmessage = async ({ data }: MessageEvent<Question | { module: WebAssembly.Module }>) => {
  if ("module" in data) {
    able = init({ module_or_path: data.module });
    return;
  }
  let reply: Reply;
  try {
    await able;
    const answer = answers[data.name] as (...values: unknown[]) => unknown;
    reply = { id: data.id, value: await answer(...data.values) };
  } catch (error) {
    // After a trap the module's memory cannot be trusted.
    const trapped = error instanceof WebAssembly.RuntimeError;
    reply = { id: data.id, error: error instanceof Error ? error.message : String(error), trapped };
  }
  self.postMessage(reply, { transfer: "value" in reply ? arrays(reply.value) : [] });
};
