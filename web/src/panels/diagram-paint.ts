/** The picture of the diagram. */
import { ticks, type Pen, type Size } from "../draw/canvas";
import { branchColors, ink, tint, type Ink, type Rgb } from "../draw/theme";
import { surface, valueOf } from "../state/numbers";
import type { Drawn, Shadow } from "../state/known";
import type { Session } from "../state/session";
import type { Window } from "../bindings/documents";
import { deepest, type Place } from "../state/places";
import { circlesOf, typeOf } from "./regions";

export interface Area {
  x: number;
  y: number;
  width: number;
  height: number;
}

export const plot = ({ width, height }: Size): Area => ({ x: 46, y: 8, width: Math.max(10, width - 56), height: Math.max(10, height - 44) });

export const placeOf = ({ h, l }: Window, area: Area, [hv, lv]: [number, number]): [number, number] => [
  area.x + ((hv - h[0]) / (h[1] - h[0])) * area.width,
  area.y + area.height - ((lv - l[0]) / (l[1] - l[0])) * area.height,
];

export const valueAt = ({ h, l }: Window, area: Area, [x, y]: [number, number]): [number, number] => [
  h[0] + ((x - area.x) / area.width) * (h[1] - h[0]),
  l[0] + ((area.y + area.height - y) / area.height) * (l[1] - l[0]),
];

export function paintDiagram(pen: Pen, size: Size, session: Session): void {
  const drawn = session.drawn!;
  const colors = ink();
  const area = plot(size);
  const lit = session.hover.region ?? null;
  paintRegions(pen, area, drawn, colors, lit);
  pen.save();
  pen.beginPath();
  pen.rect(area.x, area.y, area.width, area.height);
  pen.clip();
  if (session.shadow) paintShadow(pen, area, drawn.window, session.shadow, colors);
  paintCurves(pen, area, drawn, colors, session.hover.curve);
  paintEvents(pen, area, drawn, colors);
  paintNames(pen, area, drawn, colors, deepest(drawn, area.width));
  paintPoint(pen, area, drawn, session, colors);
  pen.restore();
  paintAxes(pen, area, drawn.window, colors);
}

let surfaceImage: HTMLCanvasElement | undefined;

/** Tints row by row into an image of one pixel a row. */
function paintRegions(pen: Pen, area: Area, { document, rows, rowCount, window }: Drawn, colors: Ink, lit: string | null): void {
  const width = Math.round(area.width);
  const image = new ImageData(width, Math.max(1, rowCount));
  const pixels = new Uint32Array(image.data.buffer);
  const code = ([r, g, b]: Rgb) => (255 << 24) | (b << 16) | (g << 8) | r;
  const tints = document.regions.map((region) => {
    const color = tint(typeOf(region), circlesOf(region), colors.dark);
    return code(region.id === lit ? (color.map((value) => (colors.dark ? Math.min(255, value + 26) : Math.max(0, value - 22))) as Rgb) : color);
  });
  const outside = Number.parseInt(colors.forbidden.slice(1), 16);
  pixels.fill(code([outside >> 16, (outside >> 8) & 255, outside & 255]));
  const [from, to] = window.h;
  const column = (h: number) => Math.min(width, Math.max(0, Math.round(((h - from) / (to - from)) * width)));
  let at = 0;
  for (let row = 0; row < rowCount && at < rows.length; row++) {
    const count = rows[at++]!;
    const y = rowCount - 1 - row;
    for (let k = 0; k < count; k++) {
      const region = rows[at + 2 * k + 1]!;
      const [left, right] = [column(rows[at + 2 * k]!), k + 1 < count ? column(rows[at + 2 * k + 2]!) : width];
      if (right <= left) continue;
      pixels.fill(tints[region] ?? 0, y * width + left, y * width + right);
    }
    at += 2 * count;
  }
  surfaceImage ??= globalThis.document.createElement("canvas");
  surfaceImage.width = width;
  surfaceImage.height = image.height;
  surfaceImage.getContext("2d")!.putImageData(image, 0, 0);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(surfaceImage, area.x, area.y, area.width, area.height);
}

function paintCurves(pen: Pen, area: Area, { document, curves, window }: Drawn, colors: Ink, lit: string | undefined): void {
  const palette = branchColors(document, colors.dark);
  pen.lineJoin = "round";
  for (const curve of document.curves) {
    const points = curves.get(curve.id);
    if (!points || points.length === 0) continue;
    const pole = curve.kind.startsWith("pole");
    pen.strokeStyle = palette.get(curve.branch) ?? colors.text;
    pen.lineWidth = (pole ? 1 : 1.8) + (curve.id === lit ? 1.6 : 0);
    if (pole) {
      stroke(pen, area, window, points, -Infinity, Infinity, [2, 3]);
      continue;
    }
    const wide = pen.lineWidth;
    const spans = curve.stability.length > 0 ? curve.stability : [{ l_from: 0, l_to: Infinity, nonlinear: null, friction: null }];
    spans.forEach(({ l_from, l_to, nonlinear, friction }, i) => {
      const last = i === spans.length - 1 ? Infinity : (l_to ?? Infinity);
      const verdict = nonlinear?.verdict ?? "open";
      // Thin: stable without friction only.
      pen.lineWidth = verdict === "stable" && friction?.conserving_l !== "survives" ? wide / 2.5 : wide;
      stroke(pen, area, window, points, i === 0 ? -Infinity : l_from, last, DASHES[verdict]);
    });
  }
  pen.setLineDash([]);
}

/** The curves of the body before. */
function paintShadow(pen: Pen, area: Area, window: Window, shadow: Shadow, colors: Ink): void {
  pen.strokeStyle = colors.faint;
  pen.globalAlpha = 0.45;
  pen.lineWidth = 3;
  for (const points of shadow.values()) stroke(pen, area, window, points, -Infinity, Infinity, []);
  pen.globalAlpha = 1;
}

/** Lines of curves by the verdict on their stability. */
const DASHES = { stable: [], unstable: [7, 4], open: [2, 3] };

/** The part of a polyline with l between two values. */
function stroke(pen: Pen, area: Area, window: Window, points: Float64Array, from: number, to: number, dash: number[]): void {
  pen.setLineDash(dash);
  pen.beginPath();
  for (let i = 0; i < points.length; i += 2) {
    const [h, l] = [points[i]!, points[i + 1]!];
    const [before, after] = [points[i - 1] ?? l, points[i + 3] ?? l];
    // A point beyond the part still ends its last segment.
    if ((l < from && after <= from) || (l > to && before >= to)) continue;
    pen.lineTo(...placeOf(window, area, [h, l]));
  }
  pen.stroke();
}

function paintEvents(pen: Pen, area: Area, { document, window }: Drawn, colors: Ink): void {
  pen.fillStyle = colors.text;
  for (const { h, l } of document.events) {
    const [x, y] = placeOf(window, area, [h, l]);
    pen.beginPath();
    pen.arc(x, y, 2.2, 0, 2 * Math.PI);
    pen.fill();
  }
}

function paintNames(pen: Pen, area: Area, { document, rowCount }: Drawn, colors: Ink, places: Map<number, Place>): void {
  pen.textAlign = "center";
  pen.fillStyle = colors.text;
  for (const [number, place] of places) {
    const region = document.regions[number];
    if (!region) continue;
    const lines = [region.id, typeOf(region).split("+").map(surface).join("+")];
    pen.font = "12px system-ui, sans-serif";
    const wide = Math.max(...lines.map((line) => pen.measureText(line).width)) / 2;
    const [x, y] = [area.x + place.x, area.y + (place.y * area.height) / Math.max(1, rowCount)];
    // A box of two lines in a strip that leans.
    if (place.depth > 0.8 * Math.hypot(Math.min(wide, 26), 15)) {
      pen.fillText(lines[0]!, x, y - 3);
      pen.fillText(lines[1]!, x, y + 12);
    } else if (place.depth > 9) pen.fillText(lines[0]!, x, y + 4);
  }
}

function paintPoint(pen: Pen, area: Area, { window }: Drawn, { state }: Session, colors: Ink): void {
  if (!state.point) return;
  const [x, y] = placeOf(window, area, [valueOf(state.point.h), Math.abs(valueOf(state.point.l))]);
  pen.strokeStyle = colors.paper;
  pen.fillStyle = colors.accent;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.arc(x, y, 6, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
}

function paintAxes(pen: Pen, area: Area, { h, l }: Window, colors: Ink): void {
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.strokeRect(area.x, area.y, area.width, area.height);
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  const bottom = area.y + area.height;
  const list = ticks(h[0], h[1], area.width / 90);
  const long = (list[0]?.text.length ?? 0) > 9;
  for (const [i, { value, text }] of list.entries()) {
    const x = area.x + ((value - h[0]) / (h[1] - h[0])) * area.width;
    pen.fillRect(x, bottom, 1, 4);
    if (!long || i % 2 === 0) pen.fillText(text, x, bottom + 16);
  }
  pen.fillText("energy h", area.x + area.width / 2, bottom + 32);
  pen.textAlign = "right";
  for (const { value, text } of ticks(l[0], l[1], area.height / 50)) {
    const y = bottom - ((value - l[0]) / (l[1] - l[0])) * area.height;
    pen.fillRect(area.x - 4, y, 4, 1);
    const inside = text.length > 6;
    pen.textAlign = inside ? "left" : "right";
    pen.fillText(text, inside ? area.x + 4 : area.x - 7, y + (inside ? -3 : 4));
  }
  pen.save();
  pen.translate(11, area.y + area.height / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText("momentum l", 0, 0);
  pen.restore();
}

