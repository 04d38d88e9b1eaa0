/** One worker: the module and what is kept of the last question. It answers in the order in which it is asked. */
import type { Answer, Arguments, Drawing, Name, Place, Question, Reply, Site } from "./calls";
import type { Atlas, Orbit, Portrait, Window } from "./documents";
import partsUrl from "./generated/bifdiag_web_parts_bg.wasm?url";
import init, * as guest from "./generated/bifdiag_web.js";

const PORTRAIT_ROWS = 90;

let diagram: { body: string; of: guest.Diagram; text: string; document: Atlas } | undefined;
let section: { site: string; of: guest.Section } | undefined;
let classes: guest.Classes | undefined;
let readers = false;

function diagramOf(body: string): NonNullable<typeof diagram> {
  if (diagram?.body !== body) {
    const of = new guest.Diagram(body);
    const text = of.document();
    diagram?.of.free();
    diagram = { body, of, text, document: JSON.parse(text) as Atlas };
  }
  return diagram;
}

function sectionOf(site: Site): guest.Section {
  const name = site.join("&");
  if (section?.site !== name) {
    section?.of.free();
    section = undefined;
    section = { site: name, of: new guest.Section(...site) };
  }
  return section.of;
}

/** `view`: what is to be seen; null: what suits the body. */
function draw(body: string, view: Window | null, height: number, width: number, point: [number, number] | null): Drawing {
  const { of, text, document } = diagramOf(body);
  const window = view ?? document.drawing.view.main;
  const { h, l } = window;
  const names = document.curves.map((curve) => curve.id);
  const curves = of.curves(names, Math.max(0, l[0]), l[1], (h[1] - h[0]) / width / 3);
  return { text, window, rows: of.columns(l[0], l[1], height), rowCount: height, names, curves, place: point && locate(body, ...point) };
}

function locate(body: string, h: number, l: number): Place {
  const { of } = diagramOf(body);
  const [region, distance] = of.locate(h, l) as unknown as [number, number];
  return { region, distance, nearest: of.nearest(h, l) };
}

/** The readers of parts, loaded when the first one is given. Fetched as bytes: no server needs to know its type. */
async function parts(): Promise<typeof import("./generated/bifdiag_web_parts.js")> {
  const module = await import("./generated/bifdiag_web_parts.js");
  if (readers) return module;
  const response = await fetch(partsUrl);
  if (!response.ok) throw new Error(`the readers of parts could not be loaded: ${response.status} ${response.statusText}`);
  await module.default({ module_or_path: await response.arrayBuffer() });
  readers = true;
  return module;
}

const answers: { [N in Name]: (...values: Arguments<N>) => Answer<N> | Promise<Answer<N>> } = {
  presets: () => guest.presets(),
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

let begun: Promise<unknown> | undefined;

self.onmessage = async ({ data }: MessageEvent<Question | { module: WebAssembly.Module }>) => {
  if ("module" in data) {
    begun = init({ module_or_path: data.module });
    return;
  }
  let reply: Reply;
  try {
    await begun;
    const answer = answers[data.name] as (...values: unknown[]) => unknown;
    reply = { id: data.id, value: await answer(...data.values) };
  } catch (error) {
    // After a trap the module's memory cannot be trusted.
    const trapped = error instanceof WebAssembly.RuntimeError;
    reply = { id: data.id, error: error instanceof Error ? error.message : String(error), trapped };
  }
  self.postMessage(reply, { transfer: "value" in reply ? arrays(reply.value) : [] });
};
