/** The (h, l) diagram: regions tinted by type, curves by branch, events, the point. Click, drag, wheel and pinch. */
import { Sheet, type Pen, type Size } from "../draw/canvas";
import { make, panel } from "../draw/dom";
import { near } from "../draw/press";
import { tipAt } from "../draw/tip";
import { shown, surface, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import type { Window } from "../bindings/documents";
import { PlaneChart } from "../state/chart";
import { beside } from "./beside";
import { chaosLayer } from "./chaos";
import { paintDiagram, paintWaiting, plot } from "./diagram-paint";
import { gestures } from "./gestures";
import { stabilityLine } from "./stability";
import { texts } from "../texts";

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
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": texts.diagram.canvas }, data: { testid: "diagram" } });
  const tip = make("div", { className: "tip", hidden: true });
  let painted = session.state.point;
  const paint = (pen: Pen, size: Size) => {
    painted = session.state.point;
    return session.drawn ? paintDiagram(pen, size, session) : session.message || paintWaiting(pen, size);
  };
  const sheet = new Sheet(canvas, paint);
  const frame = () => plot(sheet.size, session.state);
  const inside = (x: number, y: number): [number, number] => [x - frame().x, y - frame().y];

  const choose = (x: number, y: number) => {
    const point = session.drawn!.chart.rounded(...inside(x, y));
    if (point) session.point(point);
  };
  // The straightened plane is all to be seen.
  const zoom = (at: [number, number], factor: number) => {
    const { chart, window } = session.drawn ?? {};
    if (!(chart instanceof PlaneChart)) return;
    const [x, y] = inside(...at);
    // Over the numbers of an axis what stands beside them stays.
    const kept = chart.value(Math.min(chart.width, Math.max(0, x)), Math.min(chart.height, Math.max(0, y)));
    const next = narrowed(window!, kept ?? [window!.h[0], 0], factor);
    if (next) session.view(next);
  };
  const pan = (dx: number, dy: number) => {
    const { chart, window } = session.drawn!;
    if (!(chart instanceof PlaneChart)) return;
    const { h, l } = window;
    const [dh, dl] = [(-dx / chart.width) * (h[1] - h[0]), (dy / chart.height) * (l[1] - l[0])];
    const up = Math.max(dl, -l[0]);
    session.view({ h: [h[0] + dh, h[1] + dh], l: [l[0] + up, l[1] + up] });
  };
  gestures(canvas, {
    ready: () => session.drawn !== null,
    place: (event) => sheet.place(event),
    handle: (x, y) => {
      const { point } = session.state;
      if (!point || !session.drawn) return false;
      const spot = session.drawn.chart.place(valueOf(point.h), Math.abs(valueOf(point.l)));
      return spot !== null && near(inside(x, y), spot);
    },
    point: choose,
    pan,
    zoom,
    start: (what) => (session.dragging = what),
    end: () => session.release(),
    zooms: () => session.drawn?.chart instanceof PlaneChart,
    hover: (x, y) => void hover(session, sheet, tip, [x, y], inside(x, y)),
    leave: () => ((tip.hidden = true), session.pointAt({})),
  });
  canvas.addEventListener("keydown", (event) => keys(session, sheet, event, zoom));
  session.on(["drawing"], () => sheet.now());
  session.on(["hover", "theme", "shadow", "chaos"], () => sheet.ask());
  // What is learnt of a point is told elsewhere.
  session.on(["point"], () => session.state.point !== painted && sheet.ask());
  const resized = () => (session.picture.resolution = frame());
  new ResizeObserver(() => {
    resized();
    void session.redraw();
  }).observe(canvas);
  const pin = tool(texts.diagram.keep, texts.diagram.keepHelp, () => session.picture.pin());
  session.on(["shadow"], () => pin.setAttribute("aria-pressed", String(session.picture.pinned)));
  const twin = beside(session);
  const straight = tool(texts.diagram.straight, texts.diagram.straightHelp, () => session.straighten(!session.state.straight));
  straight.dataset.testid = "straight";
  const layer = chaosLayer(session);
  const zooms = [
    tool("+", texts.diagram.zoomIn, () => zoom([sheet.size.width / 2, sheet.size.height / 2], 0.5)),
    tool("−", texts.diagram.zoomOut, () => zoom([sheet.size.width / 2, sheet.size.height / 2], 2)),
    tool("⌂", texts.diagram.whole, () => session.view(null)),
  ];
  for (const zoom of zooms.slice(0, 2)) zoom.className = "zoom";
  const tools = make("div", { className: "tools" },
    twin.tool,
    pin,
    straight,
    layer.tool,
    ...zooms,
  );
  session.on(["theme"], () => {
    const { width, height } = session.picture.resolution;
    resized();
    if (session.drawn && (width !== session.picture.resolution.width || height !== session.picture.resolution.height)) void session.redraw();
    straight.setAttribute("aria-pressed", String(session.state.straight));
    for (const zoom of zooms) zoom.disabled = session.state.straight;
  });
  const element = panel(texts.diagram.title, texts.diagram.help, make("div", { className: "stage" }, canvas, tip), layer.legend, twin.element);
  element.querySelector("header")!.append(tools);
  return { element, sheet };
}

const tool = (label: string, title: string, onclick: () => void) => make("button", { type: "button", title, onclick, attributes: { "aria-label": title } }, label);

/** Arrow keys move the point by two pixels, with shift by twenty; + − 0 zoom; Escape removes the point if nothing else is to be ended. */
function keys(session: Session, { size }: Sheet, event: KeyboardEvent, zoom: (at: [number, number], factor: number) => void): void {
  if (!session.drawn) return;
  const { chart } = session.drawn;
  const { point } = session.state;
  const area = plot(size, session.state);
  const spot = (point && chart.place(valueOf(point.h), valueOf(point.l))) ?? [chart.width / 2, chart.height / 2];
  const center: [number, number] = [spot[0] + area.x, spot[1] + area.y];
  if (event.key === "+" || event.key === "=") zoom(center, 0.7);
  else if (event.key === "-") zoom(center, 1 / 0.7);
  else if (event.key === "0") session.state.straight || session.view(null);
  else if (event.key === "Escape") {
    const { present, tour, lesson } = session.state;
    if (present !== null || tour !== null || lesson !== null) return;
    session.point(null);
  } else {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step) return;
    const far = event.shiftKey ? 20 : 2;
    const next = chart.rounded(spot[0] + far * step[0]!, spot[1] + far * step[1]!);
    if (!next) return event.preventDefault();
    session.dragging = "point";
    session.point(next);
    clearTimeout(rest);
    rest = setTimeout(() => session.release(), 250);
  }
  event.preventDefault();
}
let rest: ReturnType<typeof setTimeout>;

async function hover(session: Session, sheet: Sheet, tip: HTMLElement, at: [number, number], inside: [number, number]): Promise<void> {
  if (!session.drawn || session.dragging) return void (tip.hidden = true);
  const { chart, document } = session.drawn;
  const value = chart.value(...inside);
  if (!value) return void (tip.hidden = true);
  const [h, l] = value;
  const place = await session.locate(h, l).catch(() => null);
  if (!place) return;
  const region = document.regions[place.region];
  const curve = chart.pixels(h, l, place.distance) < 6 ? place.nearest : undefined;
  session.pointAt({ ...(region && { region: region.id }), ...(curve && { curve }) });
  const lines = [`h = ${shown(h)}, l = ${shown(l)}`];
  if (region) lines.push(`${region.id}: P = ${region.signature?.split("+").map(surface).join(" + ") ?? texts.diagram.none}, U = ${region.components.map((c) => surface(c.accessible_region)).join(" + ")}`, `E = ${region.components.map((c) => surface(c.energy_surface)).join(" + ")}, ${texts.diagram.genus(region.components.map((c) => c.genus ?? "–").join(", "))}`);
  else lines.push(place.region === -1 ? texts.diagram.below : texts.diagram.onCurve);
  lines.push(texts.diagram.from(shown(place.distance), place.nearest));
  const share = session.state.chaos && region ? session.chaos.at(h, l, place.region, session.state.component) : null;
  if (share && share.orbits > 0) lines.push(texts.diagram.share(share.fraction.toFixed(2), share.error.toFixed(2), share.open.toFixed(2), share.orbits));
  if (curve) lines.push(...(await curveLines(session, curve, h, l)));
  tipAt(tip, sheet.size, at, lines);
}

/** Stability of the steady motion on a curve. */
async function curveLines(session: Session, curve: string, h: number, l: number): Promise<string[]> {
  const found = await session.equilibria(String(l)).catch(() => null);
  const nearest = found?.critical.reduce<typeof found.critical[number] | null>((best, one) => (!best || Math.abs(one.h - h) < Math.abs(best.h - h) ? one : best), null);
  if (!nearest || nearest.branch !== curve) return [];
  const values = nearest.eigenvalues?.map(([re, im]) => `±${shown(re, 3)} ± ${shown(im, 3)}i`).join(", ");
  return [texts.diagram.steady(nearest.index, texts.stability.linear[nearest.stability]), stabilityLine(nearest), ...(values ? [texts.diagram.eigenvalues(values)] : [])];
}
