/** The body's motion: its ellipsoid of inertia turning about the fixed point, the centre of mass, the trace of the vertical, three angles. */
import { apply, composed, grainOf, lookingAt, rotation, turned, type Turn, type Vec } from "../draw/ball";
import { Pixels, Sheet, type Pen, type Size } from "../draw/canvas";
import { drag } from "../draw/press";
import { button, make, panel } from "../draw/dom";
import { ink, type Ink } from "../draw/theme";
import { valueOf } from "../state/numbers";
import { MOMENT } from "../state/orbits";
import type { Session } from "../state/session";
import type { Clock } from "./clock";
import { texts } from "../texts";

/** γ points down in the space of the picture: the vertical of H = T − ⟨γ,r⟩ is the direction of gravity. */
const UPSIDE: Turn = [[1, 0, 0], [0, -1, 0], [0, 0, -1]];
/** Moments of the trace that are drawn. */
const TRACE = 400;

/** Semi-axes of the ellipsoid ⟨x, A x⟩ = 1, the largest brought to 1. */
function axesOf(a: Vec): Vec {
  const raw = a.map((moment) => 1 / Math.sqrt(moment)) as Vec;
  const largest = Math.max(...raw);
  return raw.map((x) => Math.max(0.12, x / largest)) as Vec;
}

export function motionPanel(session: Session, clock: Clock): { element: HTMLElement; sheet: Sheet } {
  const canvas = make("canvas", { tabIndex: 0, attributes: { role: "application", "aria-label": texts.motion.canvas }, data: { testid: "motion" } });
  let view: Turn = lookingAt([1, 0.5, 0.35], [0, 0, 1]);
  const angles = make("span", { className: "angles" });
  const sheet = new Sheet(canvas, (pen, size) => paint(pen, size, session, clock, view));
  let last: [number, number] | null = null;
  drag(canvas, {
    sideways: true,
    start: (event) => ((last = sheet.place(event)), true),
    move: (event) => {
      const now = sheet.place(event);
      if (last) view = turned(view, [0, 1, 0], (now[0] - last[0]) / 90);
      if (last) view = turned(view, [1, 0, 0], (now[1] - last[1]) / 90);
      last = now;
      sheet.ask();
    },
    end: () => (last = null),
  });
  const play = button("▶", texts.motion.play, () => (clock.playing ? clock.pause() : clock.play()), { testid: "play" });
  const slider = make("input", { type: "range", min: "0", max: "1", step: "any", value: "0", attributes: { "aria-label": texts.motion.time } });
  slider.addEventListener("input", () => clock.to(Number(slider.value) * clock.end));
  const speed = make("select", { title: texts.motion.speed, attributes: { "aria-label": texts.motion.speed } });
  for (const factor of [0.25, 1, 4, 16]) speed.append(make("option", { value: String(factor), selected: factor === 1 }, `${factor}×`));
  speed.addEventListener("change", () => (clock.speed = Number(speed.value)));
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (event.key !== " " && !step) return;
    event.preventDefault();
    if (!step) return play.click();
    view = turned(turned(view, [0, 1, 0], 0.1 * step[0]!), [1, 0, 0], 0.1 * step[1]!);
    sheet.ask();
  });
  session.on(["motion"], () => {
    const { motion } = session.orbits;
    clock.end = motion ? motion[motion.length - MOMENT]! : 0;
    clock.time = 0;
    if (!motion) clock.pause();
    else if (!matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
    sheet.ask();
  });
  clock.on(() => {
    // While a hand changes the body the motion is that of another one.
    if (session.dragging === "body") return;
    play.textContent = clock.playing ? "❚❚" : "▶";
    slider.value = String(clock.end > 0 ? clock.time / clock.end : 0);
    const { motion } = session.orbits;
    if (motion) {
      const at = momentAt(motion, clock);
      angles.textContent = ["ϑ", "ψ", "φ"].map((name, i) => `${name} = ${motion[at + 10 + i]!.toFixed(2).replace("-", "−")}`).join("  ");
    } else angles.textContent = "";
    sheet.ask();
  });
  session.on(["theme", "body"], () => (session.dragging === "body" ? sheet.askInTurn() : sheet.ask()));
  const bar = make("div", { className: "bar" }, play, slider, speed, angles);
  const element = panel(texts.motion.title, texts.motion.help, make("div", { className: "stage" }, canvas), bar);
  return { element, sheet };
}

/** Where the moment nearest to the clock's time begins. */
function momentAt(motion: Float64Array, clock: Clock): number {
  const count = motion.length / MOMENT;
  const share = clock.end > 0 ? clock.time / clock.end : 0;
  return MOMENT * Math.min(count - 1, Math.max(0, Math.round(share * (count - 1))));
}

let scratch: Pixels | undefined;

function paint(pen: Pen, size: Size, session: Session, clock: Clock, view: Turn): void {
  const colors = ink();
  const { motion } = session.orbits;
  if (!motion) {
    pen.fillStyle = colors.faint;
    pen.textAlign = "center";
    pen.font = "13px system-ui";
    pen.fillText(session.state.point ? session.orbits.reason && texts.motion.none : texts.motion.choose, size.width / 2, size.height / 2);
    return;
  }
  const at = momentAt(motion, clock);
  const [w, x, y, z] = [13, 14, 15, 16].map((k) => motion[at + k]!) as [number, number, number, number];
  const turn = composed(view, composed(UPSIDE, rotation(w, x, y, z)));
  // The body and the numbers of its axes, above the legend.
  const room = { width: size.width, height: size.height - LEGEND };
  const radius = Math.max(8, Math.min(0.4 * room.width, room.height / 2.4 - 4));
  const axes = axesOf(session.state.A.map(valueOf) as Vec);
  const place = (v: Vec): [number, number, number] => {
    const [right, up, front] = apply(turn, v);
    return [room.width / 2 + radius * right, room.height / 2 - radius * up, front];
  };
  paintGravity(pen, radius, view, colors);
  trace(pen, motion, at, axes, place, colors, false);
  paintBody(pen, room, radius, grainOf(session), axes, turn, colors);
  trace(pen, motion, at, axes, place, colors, true);
  center(pen, session, place, colors);
  paintAxes(pen, axes, place, colors);
  legend(pen, size, colors);
}

/** The principal axes where they leave the body, with their numbers. */
function paintAxes(pen: Pen, axes: Vec, place: (v: Vec) => [number, number, number], colors: Ink): void {
  pen.strokeStyle = pen.fillStyle = colors.faint;
  pen.lineWidth = 1.2;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  axes.forEach((size, i) => {
    const along = (far: number) => place([0, 1, 2].map((k) => (k === i ? far : 0)) as Vec);
    const [[x, y, front], [px, py]] = [along(size), along(size + 0.1)];
    pen.globalAlpha = front < 0 ? 0.35 : 1;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(px, py);
    pen.stroke();
    const [tx, ty] = along(size + 0.19);
    pen.fillText(String(i + 1), tx, ty + 4);
  });
  pen.globalAlpha = 1;
}

/** The height of the legend. */
const LEGEND = 32;

/** What the signs are. */
function legend(pen: Pen, { height }: Size, colors: Ink): void {
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "left";
  const line = (text: string, row: number, color: string) => {
    pen.fillStyle = color;
    pen.fillText(text, 8, height - 6 - 14 * row);
  };
  line(texts.motion.signs, 1, colors.faint);
  line(texts.motion.trace, 0, colors.accent);
}

/** The ellipsoid by one ray for each pixel or few: |x/a| = 1 in the body's axes. */
function paintBody(pen: Pen, size: Size, large: number, grain: number, axes: Vec, turn: Turn, colors: Ink): void {
  const radius = large / grain;
  const side = Math.floor(2 * radius) + 2;
  scratch ??= new Pixels();
  const { data } = scratch.sized(side, side);
  const [X, Y, Z] = turn.map((row) => [row[0] / axes[0], row[1] / axes[1], row[2] / axes[2]]) as unknown as Turn;
  const zz = Z[0] * Z[0] + Z[1] * Z[1] + Z[2] * Z[2];
  for (let row = 0; row < side; row++) {
    const v = (side / 2 - row) / radius;
    for (let column = 0; column < side; column++) {
      const u = (column - side / 2) / radius;
      const [a, b, c] = [u * X[0] + v * Y[0], u * X[1] + v * Y[1], u * X[2] + v * Y[2]];
      const half = (a * Z[0] + b * Z[1] + c * Z[2]) / zz;
      const square = half * half - (a * a + b * b + c * c - 1) / zz;
      if (square < 0) {
        data[4 * (row * side + column) + 3] = 0;
        continue;
      }
      const depth = -half + Math.sqrt(square);
      const p = [a + depth * Z[0], b + depth * Z[1], c + depth * Z[2]] as const;
      // The normal of |x/a| = 1 is p/a in the body's axes.
      const n = [p[0] / axes[0], p[1] / axes[1], p[2] / axes[2]] as const;
      const light = (n[0] * (0.5 * turn[2][0] + 0.6 * turn[1][0] - 0.3 * turn[0][0]) + n[1] * (0.5 * turn[2][1] + 0.6 * turn[1][1] - 0.3 * turn[0][1]) + n[2] * (0.5 * turn[2][2] + 0.6 * turn[1][2] - 0.3 * turn[0][2])) / Math.hypot(...n);
      // A pattern of octants, so that turning is seen.
      const dark = p[0] * p[1] * p[2] > 0 ? 0.86 : 1;
      const shade = (0.5 + 0.5 * Math.max(-0.4, light)) * dark;
      const at = 4 * (row * side + column);
      data[at] = (colors.dark ? 150 : 176) * shade;
      data[at + 1] = (colors.dark ? 182 : 205) * shade;
      data[at + 2] = (colors.dark ? 214 : 235) * shade;
      // The edge fades over a pixel.
      data[at + 3] = Math.min(255, 255 * square * zz * 0.4 * radius);
    }
  }
  const shown = side * grain;
  scratch.draw(pen, size.width / 2 - shown / 2, size.height / 2 - shown / 2, shown, shown);
}

/** Where the vertical has pierced the body: on the ellipsoid, in front or behind. */
function trace(pen: Pen, motion: Float64Array, at: number, axes: Vec, place: (v: Vec) => [number, number, number], colors: Ink, front: boolean): void {
  pen.strokeStyle = colors.accent;
  pen.lineWidth = 1.5;
  pen.globalAlpha = front ? 0.9 : 0.25;
  pen.beginPath();
  let drawing = false;
  for (let k = Math.max(0, at - TRACE * MOMENT); k <= at; k += MOMENT) {
    const g = [motion[k + 1]!, motion[k + 2]!, motion[k + 3]!] as Vec;
    const size = Math.hypot(g[0] / axes[0], g[1] / axes[1], g[2] / axes[2]);
    const [x, y, z] = place(g.map((value) => value / size) as Vec);
    const here = z >= 0 === front;
    if (here && drawing) pen.lineTo(x, y);
    else if (here) pen.moveTo(x, y);
    drawing = here;
  }
  pen.stroke();
  pen.globalAlpha = 1;
}

function center(pen: Pen, session: Session, place: (v: Vec) => [number, number, number], colors: Ink): void {
  const r = session.state.r.map(valueOf) as Vec;
  const size = Math.hypot(...r);
  if (size === 0) return;
  const [x0, y0] = place([0, 0, 0]);
  const [x, y] = place(r.map((value) => (0.62 * value) / size) as Vec);
  pen.strokeStyle = colors.text;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x, y);
  pen.stroke();
  pen.fillStyle = colors.text;
  pen.beginPath();
  pen.arc(x, y, 4.5, 0, 2 * Math.PI);
  pen.fill();
  pen.fillStyle = colors.panel;
  pen.beginPath();
  pen.arc(x0, y0, 3.5, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
}

/** An arrow in the direction of gravity beside the body. */
function paintGravity(pen: Pen, radius: number, view: Turn, colors: Ink): void {
  const [right, up] = apply(view, [0, 0, -1]);
  const [x, y] = [16, 20];
  const length = 0.3 * radius;
  pen.strokeStyle = pen.fillStyle = colors.faint;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(x, y);
  const tip = [x + length * right, y - length * up] as const;
  pen.lineTo(...tip);
  // Seen from its end an arrow has no head.
  const seen = Math.hypot(right, up);
  for (const side of seen > 0.2 ? [-1, 1] : []) {
    const [a, b] = [right / seen, -up / seen];
    pen.moveTo(...tip);
    pen.lineTo(tip[0] - 6 * a - 3 * side * b, tip[1] - 6 * b + 3 * side * a);
  }
  pen.stroke();
  pen.font = "11px system-ui";
  pen.textAlign = "left";
  pen.fillText(texts.motion.gravity, x + 6, y + 4);
}

