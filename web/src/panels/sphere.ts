/** The accessible region U on the Poisson sphere: all directions γ of the vertical, seen from the body, that the energy allows. */
import { castBall, apply, grainOf, lookingAt, turned, unit, type Turn, type Vec } from "../draw/ball";
import { Pixels, Sheet, type Pen, type Size } from "../draw/canvas";
import { drag } from "../draw/press";
import { make, panel } from "../draw/dom";
import { ink, type Ink, type Rgb } from "../draw/theme";
import { valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { Labels } from "./labels";
import { potential } from "./potential";
import { colorOf } from "./regions";
import { texts } from "../texts";

/** U while its region is not known, and the directions that the energy does not allow: neither is like the ground of a region. */
const UNKNOWN: Record<"light" | "dark", Rgb> = { light: [190, 196, 202], dark: [120, 130, 140] };
const FORBIDDEN: Record<"light" | "dark", Rgb> = { light: [168, 175, 184], dark: [96, 104, 114] };
/** Level lines between the lowest and the highest energy on the sphere. */
const LEVELS = 14;

export function spherePanel(session: Session): { element: HTMLElement; sheet: Sheet } {
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": texts.sphere.canvas }, data: { testid: "sphere" } });
  let turn: Turn = lookingAt([1, 0.7, 0.5], [0, 0, 1]);
  const labels = new Labels(session);
  const sheet = new Sheet(canvas, (pen, size) => paint(pen, size, session, turn, labels));
  labels.ready = () => sheet.ask();
  let last: [number, number] | null = null;
  const rotate = (dx: number, dy: number) => {
    const size = Math.hypot(dx, dy);
    if (size > 0) turn = turned(turn, [dy / size, dx / size, 0], size);
    sheet.ask();
  };
  drag(canvas, {
    sideways: true,
    start: (event) => ((last = sheet.place(event)), true),
    move: (event) => {
      const now = sheet.place(event);
      const radius = 0.45 * Math.min(sheet.size.width, sheet.size.height);
      if (last) rotate((now[0] - last[0]) / radius, (now[1] - last[1]) / radius);
      last = now;
    },
    end: () => (last = null),
  });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    if (!step) return;
    event.preventDefault();
    rotate(step[0]!, step[1]!);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0) return;
    const part = labels.at(directionAt(sheet, turn, event));
    if (part !== session.hover.component) session.pointAt(part === undefined || part < 0 ? {} : { component: part });
  });
  canvas.addEventListener("pointerleave", () => session.pointAt({}));
  session.on(["body"], () => labels.forget());
  session.on(["section"], () => labels.learn());
  session.on(["point", "body", "hover", "theme", "section"], () => (session.dragging === "body" ? sheet.askInTurn() : sheet.ask()));
  session.on(["motion"], () => sheet.ask());
  const element = panel(texts.sphere.title, texts.sphere.help, make("div", { className: "stage" }, canvas));
  return { element, sheet };
}

function directionAt(sheet: Sheet, turn: Turn, event: PointerEvent): Vec | null {
  const [px, py] = sheet.place(event);
  const radius = 0.45 * Math.min(sheet.size.width, sheet.size.height);
  const [x, y] = [(px - sheet.size.width / 2) / radius, (sheet.size.height / 2 - py) / radius];
  const rest = 1 - x * x - y * y;
  if (rest < 0) return null;
  const z = Math.sqrt(rest);
  return [0, 1, 2].map((i) => x * turn[0][i]! + y * turn[1][i]! + z * turn[2][i]!) as Vec;
}

let scratch: Pixels | undefined;

function paint(pen: Pen, size: Size, session: Session, turn: Turn, labels: Labels): void {
  const colors = ink();
  const { point, A, r } = session.state;
  const side = Math.floor(Math.min(size.width, size.height));
  const radius = 0.45 * side;
  const u = potential(A.map(valueOf) as Vec, r.map(valueOf) as Vec, point ? valueOf(point.l) : 0);
  const h = point ? valueOf(point.h) : NaN;
  const grain = grainOf(session);
  const rays = Math.floor(side / grain);
  scratch ??= new Pixels();
  const extremes = [Infinity, -Infinity] as [number, number];
  for (const { h: value } of session.critical) extremes.splice(0, 2, Math.min(extremes[0], value), Math.max(extremes[1], value));
  const step = Number.isFinite(extremes[0]) && extremes[1] > extremes[0] ? (extremes[1] - extremes[0]) / LEVELS : Infinity;
  const theme = colors.dark ? "dark" : "light";
  const region = session.drawn?.document.regions.find(({ id }) => id === session.known.region);
  const color = region ? colorOf(region, colors.dark) : UNKNOWN[theme];
  castBall(scratch.sized(rays, rays), radius / grain, turn, (g, light, out, at) => {
    const value = u(g);
    const inside = value <= h;
    const part = inside ? (labels.at(g) ?? 0) : -1;
    const base = inside ? color : FORBIDDEN[theme];
    const band = step < Infinity && Math.abs(value / step - Math.round(value / step)) < 0.06 ? (colors.dark && inside ? 1.4 : 0.86) : 1;
    const lit = session.hover.component === undefined || session.hover.component === part ? 1 : 0.6;
    // The side away from the light is darker; the rest of U has the very colour of its region.
    const shade = (inside ? Math.min(1, 0.8 + 0.3 * light) * lit : 0.85 + 0.2 * light) * band;
    for (let i = 0; i < 3; i++) out[at + i] = Math.min(255, base[i]! * shade);
    out[at + 3] = 255;
  });
  scratch.draw(pen, (size.width - side) / 2, (size.height - side) / 2, side, side);
  pen.strokeStyle = colors.faint;
  pen.lineWidth = 1;
  pen.beginPath();
  pen.arc(size.width / 2, size.height / 2, radius, 0, 2 * Math.PI);
  pen.stroke();
  const place = (v: Vec): { at: [number, number]; front: boolean } => {
    const [x, y, z] = apply(turn, v);
    return { at: [size.width / 2 + radius * x, size.height / 2 - radius * y], front: z >= 0 };
  };
  if (session.dragging !== "body") paintBoundary(pen, session, place, colors);
  paintMarks(pen, size, session, place, colors);
  if (!point) {
    pen.fillStyle = colors.text;
    pen.textAlign = "center";
    pen.font = "13px system-ui";
    pen.fillText(texts.sphere.choose, size.width / 2, size.height - 8);
  }
}

type Placed = (v: Vec) => { at: [number, number]; front: boolean };

function paintBoundary(pen: Pen, session: Session, place: Placed, colors: Ink): void {
  pen.strokeStyle = colors.dark ? "#f2f5f8" : "#10161d";
  pen.lineWidth = 1.6;
  for (const line of session.orbits.portrait?.sphere ?? []) {
    pen.beginPath();
    let drawing = false;
    for (const vector of [...line, line[0]!]) {
      const { at, front } = place(vector);
      if (front && drawing) pen.lineTo(...at);
      else if (front) pen.moveTo(...at);
      drawing = front;
    }
    pen.stroke();
  }
}

/** Poles ±r̂, and critical points with their Morse index. */
function paintMarks(pen: Pen, { width }: Size, session: Session, place: Placed, colors: Ink): void {
  const mark = (vector: Vec, text: string, shape: "dot" | "cross") => {
    const { at, front } = place(vector);
    pen.globalAlpha = front ? 1 : 0.28;
    pen.fillStyle = pen.strokeStyle = colors.dark ? "#ffffff" : "#10161d";
    pen.lineWidth = 1.5;
    pen.beginPath();
    const [x, y] = at;
    if (shape === "dot") pen.arc(x, y, 3, 0, 2 * Math.PI);
    else {
      pen.moveTo(x - 4, y - 4);
      pen.lineTo(x + 4, y + 4);
      pen.moveTo(x + 4, y - 4);
      pen.lineTo(x - 4, y + 4);
    }
    if (shape === "dot") pen.fill();
    else pen.stroke();
    pen.font = "11px system-ui, sans-serif";
    const fits = x + 6 + pen.measureText(text).width < width;
    pen.textAlign = fits ? "left" : "right";
    pen.fillText(text, fits ? x + 6 : x - 6, y - 4);
    pen.globalAlpha = 1;
  };
  // While a hand changes the body they are those of another one, and so is the edge of U.
  const critical = session.dragging === "body" ? [] : session.critical;
  const r = session.state.r.map(valueOf) as Vec;
  const kind = (index: number, multiplicity: number) => (multiplicity > 1 ? texts.sphere.degenerate : texts.sphere.kinds[index]!);
  const poles = Math.hypot(...r) > 0 ? ([["+r̂", unit(r)], ["−r̂", unit(r.map((x) => -x) as Vec)]] as [string, Vec][]) : [];
  for (const [name, pole] of poles) {
    const rest = critical.find(({ gamma, multiplicity }) => typeof multiplicity === "number" && Math.hypot(...gamma.map((x, i) => x - pole[i]!)) < 0.03);
    mark(pole, rest ? `${name}, ${kind(rest.index, Number(rest.multiplicity))}` : name, "cross");
  }
  for (const { gamma, index, multiplicity, branch } of critical) {
    if (branch !== null && branch === session.hover.curve) ring(pen, place(gamma), colors);
    const atPole = poles.some(([, pole]) => Math.hypot(...gamma.map((x, i) => x - pole[i]!)) < 0.03);
    if (typeof multiplicity === "number") mark(gamma, atPole ? "" : kind(index, multiplicity), "dot");
  }
}

/** Round the steady rotations of the curve under the pointer. */
function ring(pen: Pen, { at, front }: ReturnType<Placed>, colors: Ink): void {
  pen.globalAlpha = front ? 1 : 0.4;
  pen.strokeStyle = colors.accent;
  pen.lineWidth = 2.5;
  pen.beginPath();
  pen.arc(...at, 8, 0, 2 * Math.PI);
  pen.stroke();
  pen.globalAlpha = 1;
}
