/** The picture of a section: two halves over the same angles, what lies behind the orbits, the orbits, what flashes. */
import type { Pen, Size } from "../draw/canvas";
import { ink, type Ink } from "../draw/theme";
import type { Loop } from "../bindings/documents";
import { AT, ROW } from "../state/orbits";
import type { Session } from "../state/session";
import type { Clock } from "./clock";
import { colorsOf } from "./orbit-colors";
import { texts } from "../texts";

export const TAU = 2 * Math.PI;

/** One sheet of the PP-torus in the picture. */
export interface Half {
  sheet: 1 | -1;
  x: number;
  y: number;
  width: number;
  height: number;
}

export function halves({ width, height }: Size): [Half, Half] {
  const [gap, left, top, bottom] = [26, 30, 22, 30];
  const each = (width - left - gap - 12) / 2;
  const box = { y: top, width: Math.max(20, each), height: Math.max(20, height - top - bottom) };
  return [{ sheet: 1, x: left, ...box }, { sheet: -1, x: left + each + gap, ...box }];
}

export const placeOf = (half: Half, psi: number, theta: number): [number, number] => [half.x + (psi / TAU) * half.width, half.y + (theta / Math.PI) * half.height];

/** Everything that does not move, on a canvas of its own: it is drawn anew only when there is news. */
export function drawStill(session: Session, size: Size, scale: number): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(size.width * scale);
  canvas.height = Math.round(size.height * scale);
  const pen = canvas.getContext("2d")!;
  pen.scale(scale, scale);
  paintStill(pen, size, session);
  return canvas;
}

function paintStill(pen: Pen, size: Size, session: Session): void {
  const colors = ink();
  const { portrait } = session.orbits;
  for (const half of halves(size)) {
    const side = half.sheet > 0 ? 1 : 0;
    pen.fillStyle = colors.forbidden;
    pen.fillRect(half.x, half.y, half.width, half.height);
    if (portrait) {
      area(pen, half, portrait.accessible, colors.dark ? "#202a35" : "#ffffff");
      area(pen, half, portrait.incoming[side], colors.dark ? "#2b3947" : "#eaf1f7");
      lines(pen, half, portrait.tangency[side], colors.faint, 1, [4, 3]);
    }
    points(pen, half, session, colors);
    if (portrait) lines(pen, half, portrait.boundary, colors.text, 1.6, []);
    frame(pen, half, colors);
  }
}

const outline = (pen: Pen, half: Half, loop: Loop) => loop.forEach(([psi, theta], i) => (i === 0 ? pen.moveTo(...placeOf(half, psi, theta)) : pen.lineTo(...placeOf(half, psi, theta))));

function area(pen: Pen, half: Half, loops: Loop[], color: string): void {
  pen.beginPath();
  for (const loop of loops) {
    outline(pen, half, loop);
    pen.closePath();
  }
  pen.fillStyle = color;
  pen.fill("evenodd");
}

function lines(pen: Pen, half: Half, list: Loop[], color: string, width: number, dash: number[]): void {
  pen.strokeStyle = color;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  for (const line of list) outline(pen, half, line);
  pen.stroke();
  pen.setLineDash([]);
}

function frame(pen: Pen, half: Half, colors: Ink): void {
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.strokeRect(half.x, half.y, half.width, half.height);
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.fillText(half.sheet > 0 ? "T⁺ (Δ > 0)" : "T⁻ (Δ < 0)", half.x + half.width / 2, half.y - 7);
  [["0", 0], ["π", 0.5], ["2π", 1]].forEach(([text, at]) => pen.fillText(text as string, half.x + (at as number) * half.width, half.y + half.height + 13));
  pen.fillText(texts.section.angle, half.x + half.width / 2, half.y + half.height + 25);
  pen.textAlign = "right";
  if (half.sheet > 0) [["0", 0], ["ϑ′", 0.5], ["π", 1]].forEach(([text, at]) => pen.fillText(text as string, half.x - 5, half.y + (at as number) * half.height + 4));
}

function points(pen: Pen, half: Half, session: Session, colors: Ink): void {
  const color = colorsOf(session, colors.dark);
  session.orbits.rows.forEach((rows, orbit) => {
    pen.fillStyle = color(orbit);
    const size = orbit === session.orbits.selected ? 1.9 : 1.3;
    for (let at = 0; at < rows.length; at += ROW) {
      if (rows[at + AT.sheet]! > 0 !== half.sheet > 0) continue;
      const [x, y] = placeOf(half, rows[at + AT.psi]!, rows[at + AT.theta]!);
      pen.fillRect(x - size / 2, y - size / 2, size, size);
    }
  });
}

/** The crossing that the motion makes now, and the same place on the other half under the pointer. */
export function paintMoving(pen: Pen, size: Size, session: Session, clock: Clock, cursor: { psi: number; theta: number } | null): void {
  const colors = ink();
  const both = halves(size);
  if (cursor) {
    pen.strokeStyle = colors.faint;
    pen.lineWidth = 1;
    for (const half of both) {
      const [x, y] = placeOf(half, cursor.psi, cursor.theta);
      pen.beginPath();
      pen.moveTo(x - 6, y);
      pen.lineTo(x + 6, y);
      pen.moveTo(x, y - 6);
      pen.lineTo(x, y + 6);
      pen.stroke();
    }
  }
  const rows = session.orbits.rows[session.orbits.selected];
  if (!rows || !session.orbits.motion) return;
  for (let at = 0; at < rows.length && rows[at + AT.time]! <= clock.time; at += ROW) {
    const age = clock.time - rows[at + AT.time]!;
    if (age > clock.glow) continue;
    const half = both[rows[at + AT.sheet]! > 0 ? 0 : 1]!;
    const share = 1 - age / clock.glow;
    pen.globalAlpha = share;
    pen.strokeStyle = pen.fillStyle = colors.accent;
    pen.lineWidth = 2;
    pen.beginPath();
    const [x, y] = placeOf(half, rows[at + AT.psi]!, rows[at + AT.theta]!);
    pen.arc(x, y, 3 + 9 * (1 - share), 0, TAU);
    pen.stroke();
    pen.beginPath();
    pen.arc(x, y, 3, 0, TAU);
    pen.fill();
    pen.globalAlpha = 1;
  }
}
