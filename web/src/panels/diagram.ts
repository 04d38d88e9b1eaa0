/** The (h, l) diagram: regions tinted by type, curves by branch, events, the point. Click, drag, wheel and pinch. */
import { Sheet, type Pen, type Size } from "../draw/canvas";
import { make, panel } from "../draw/dom";
import { near } from "../draw/press";
import { tipAt } from "../draw/tip";
import { rounded, shown, surface, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import type { Window } from "../bindings/documents";
import { beside } from "./beside";
import { paintDiagram, placeOf, plot, valueAt } from "./diagram-paint";
import { gestures } from "./gestures";
import { stabilityLine } from "./stability";

/** A view is never narrower than this part of its distance from 0: there doubles end. */
const NARROWEST = 1e-11;

function narrowed({ h, l }: Window, [hc, lc]: [number, number], factor: number): Window | null {
  const scale = ([from, to]: [number, number], center: number): [number, number] => [center + (from - center) * factor, center + (to - center) * factor];
  const next = { h: scale(h, hc), l: scale(l, lc) };
  if (next.l[0] < 0) next.l = [0, next.l[1] - next.l[0]];
  const wide = ([from, to]: [number, number]) => to - from > NARROWEST * Math.max(Math.abs(from), Math.abs(to), 1e-300);
  return wide(next.h) && wide(next.l) ? next : null;
}

export function diagramPanel(session: Session): { element: HTMLElement; sheet: Sheet } {
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": "Diagram of energy h and momentum l: click to choose a point, arrow keys move it, plus and minus zoom" }, data: { testid: "diagram" } });
  const tip = make("div", { className: "tip", hidden: true });
  const paint = (pen: Pen, size: Size) => session.drawn && paintDiagram(pen, size, session);
  const sheet = new Sheet(canvas, paint);
  const view = () => session.drawn!.window;

  const choose = (x: number, y: number) => {
    const window = view();
    const [h, l] = valueAt(window, plot(sheet.size), [x, y]);
    const step = ([from, to]: [number, number], pixels: number) => (to - from) / pixels / 2;
    session.point({ h: rounded(h, step(window.h, sheet.size.width)), l: rounded(Math.max(0, l), step(window.l, sheet.size.height)) });
  };
  const zoom = (at: [number, number], factor: number) => {
    const next = session.drawn && narrowed(view(), valueAt(view(), plot(sheet.size), at), factor);
    if (next) session.view(next);
  };
  const pan = (dx: number, dy: number) => {
    const { h, l } = view();
    const area = plot(sheet.size);
    const [dh, dl] = [(-dx / area.width) * (h[1] - h[0]), (dy / area.height) * (l[1] - l[0])];
    const up = Math.max(dl, -l[0]);
    session.view({ h: [h[0] + dh, h[1] + dh], l: [l[0] + up, l[1] + up] });
  };
  gestures(canvas, {
    ready: () => session.drawn !== null,
    place: (event) => sheet.place(event),
    handle: (x, y) => {
      const { point } = session.state;
      if (!point || !session.drawn) return false;
      const [px, py] = placeOf(view(), plot(sheet.size), [valueOf(point.h), Math.abs(valueOf(point.l))]);
      return near([x, y], [px, py]);
    },
    point: choose,
    pan,
    zoom,
    start: (what) => (session.dragging = what),
    end: () => session.release(),
    hover: (x, y) => void hover(session, sheet, tip, x, y),
    leave: () => ((tip.hidden = true), session.pointAt({})),
  });
  canvas.addEventListener("keydown", (event) => keys(session, sheet, event, zoom));
  session.on(["drawing"], () => sheet.now());
  session.on(["point", "hover", "theme", "shadow"], () => sheet.ask());
  new ResizeObserver(() => {
    session.resolution = plot(sheet.size);
    if (session.drawn) void session.redraw();
  }).observe(canvas);
  const pin = tool("Keep", "Keep these curves in grey, to compare with another body", () => session.pin());
  session.on(["shadow"], () => pin.setAttribute("aria-pressed", String(session.pinned)));
  const twin = beside(session);
  const tools = make("div", { className: "tools" },
    twin.tool,
    pin,
    tool("+", "Zoom in", () => zoom([sheet.size.width / 2, sheet.size.height / 2], 0.5)),
    tool("−", "Zoom out", () => zoom([sheet.size.width / 2, sheet.size.height / 2], 2)),
    tool("⌂", "The whole diagram", () => session.view(null)),
  );
  const element = panel("Diagram", "The plane of energy h and vertical angular momentum l, both conserved. Within a tinted region all motions have the same shape, which changes on the curves. Curves are steady rotations: solid where stable (thin: without friction only), dashed where unstable; on dotted lines the centre of mass can first hang straight down or stand straight up. Click to choose a point, drag it; a finger taps, or holds and drags; two fingers or the wheel zoom", make("div", { className: "stage" }, canvas, tip), twin.element);
  element.querySelector("header")!.append(tools);
  return { element, sheet };
}

const tool = (label: string, title: string, onclick: () => void) => make("button", { type: "button", title, onclick, attributes: { "aria-label": title } }, label);

/** Arrow keys move the point by two pixels, with shift by twenty; + − 0 zoom. */
function keys(session: Session, { size }: Sheet, event: KeyboardEvent, zoom: (at: [number, number], factor: number) => void): void {
  if (!session.drawn) return;
  const { window } = session.drawn;
  const { point } = session.state;
  const area = plot(size);
  const center = point ? placeOf(window, area, [valueOf(point.h), valueOf(point.l)]) : ([size.width / 2, size.height / 2] as [number, number]);
  if (event.key === "+" || event.key === "=") zoom(center, 0.7);
  else if (event.key === "-") zoom(center, 1 / 0.7);
  else if (event.key === "0") session.view(null);
  else if (event.key === "Escape") session.point(null);
  else {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step) return;
    const far = event.shiftKey ? 20 : 2;
    const [h, l] = valueAt(window, area, [center[0] + far * step[0]!, center[1] + far * step[1]!]);
    session.dragging = "point";
    session.point({ h: rounded(h, (window.h[1] - window.h[0]) / area.width / 2), l: rounded(Math.max(0, l), (window.l[1] - window.l[0]) / area.height / 2) });
    clearTimeout(rest);
    rest = setTimeout(() => session.release(), 250);
  }
  event.preventDefault();
}
let rest: ReturnType<typeof setTimeout>;

async function hover(session: Session, sheet: Sheet, tip: HTMLElement, x: number, y: number): Promise<void> {
  if (!session.drawn || session.dragging) return void (tip.hidden = true);
  const { window, document } = session.drawn;
  const [h, l] = valueAt(window, plot(sheet.size), [x, y]);
  if (l < 0) return void (tip.hidden = true);
  const place = await session.locate(h, l).catch(() => null);
  if (!place) return;
  const region = document.regions[place.region];
  const pixels = (place.distance / (window.h[1] - window.h[0])) * sheet.size.width;
  const curve = pixels < 6 ? place.nearest : undefined;
  session.pointAt({ ...(region && { region: region.id }), ...(curve && { curve }) });
  const lines = [`h = ${shown(h)}, l = ${shown(l)}`];
  if (region) lines.push(`${region.id}: P = ${region.signature?.split("+").map(surface).join(" + ") ?? "none"}, U = ${region.components.map((c) => surface(c.accessible_region)).join(" + ")}`, `E = ${region.components.map((c) => surface(c.energy_surface)).join(" + ")}, genus ${region.components.map((c) => c.genus ?? "–").join(", ")}`);
  else lines.push(place.region === -1 ? "no motion at this low energy" : "on a curve, to within rounding");
  lines.push(`${shown(place.distance)} in h from ${place.nearest}`);
  if (curve) lines.push(...(await curveLines(session, curve, h, l)));
  tipAt(tip, sheet.size, [x, y], lines);
}

/** Stability of the steady motion on a curve. */
async function curveLines(session: Session, curve: string, h: number, l: number): Promise<string[]> {
  const found = await session.equilibria(String(l)).catch(() => null);
  const nearest = found?.critical.reduce<typeof found.critical[number] | null>((best, one) => (!best || Math.abs(one.h - h) < Math.abs(best.h - h) ? one : best), null);
  if (!nearest || nearest.branch !== curve) return [];
  const values = nearest.eigenvalues?.map(([re, im]) => `±${shown(re, 3)} ± ${shown(im, 3)}i`).join(", ");
  return [`steady rotation, index ${nearest.index}, ${nearest.stability}`, stabilityLine(nearest), ...(values ? [`eigenvalues ${values}`] : [])];
}
