/** The picture of the diagram. */
import type { Pen, Size } from "../draw/canvas";
import { branchColors, ink, tint, type Ink, type Rgb } from "../draw/theme";
import { valueOf } from "../state/numbers";
import type { Drawn, Shadow } from "../state/known";
import type { Session } from "../state/session";
import type { Chart, Line } from "../state/chart";
import { boxesOf, nameOf, typeOf } from "../state/names";
import { places, type Place } from "../state/places";
import { StraightChart } from "../state/straight";
import { paintAxes, paintLevels, paintStraightAxes, type Area } from "./diagram-axes";
import { circlesOf } from "./regions";

/** The frame in the panel; the straightened plane has an axis on the right too, and names of axes above. */
export const plot = ({ width, height }: Size, straight: boolean): Area =>
  straight ? { x: 46, y: 24, width: Math.max(10, width - 92), height: Math.max(10, height - 60) } : { x: 46, y: 8, width: Math.max(10, width - 56), height: Math.max(10, height - 44) };

export function paintDiagram(pen: Pen, size: Size, session: Session): void {
  const drawn = session.drawn!;
  const { chart } = drawn;
  const colors = ink();
  const area = plot(size, chart instanceof StraightChart);
  paintRegions(pen, area, drawn, colors, session.hover.region ?? null);
  pen.save();
  pen.beginPath();
  pen.rect(area.x, area.y, area.width, area.height);
  pen.clip();
  pen.translate(area.x, area.y);
  if (chart instanceof StraightChart) paintLevels(pen, chart, colors);
  if (session.shadow) paintShadow(pen, chart, session.shadow, colors);
  paintCurves(pen, drawn, colors, session.hover.curve);
  paintEvents(pen, drawn, colors);
  paintNames(pen, drawn, colors);
  paintPoint(pen, chart, session, colors);
  pen.restore();
  if (chart instanceof StraightChart) paintStraightAxes(pen, area, chart, colors);
  else paintAxes(pen, area, chart.window, colors);
}

let surfaceImage: HTMLCanvasElement | undefined;

/** Tints pixel by pixel. */
function paintRegions(pen: Pen, area: Area, { document, chart }: Drawn, colors: Ink, lit: string | null): void {
  const { width, height, regions } = chart;
  const image = new ImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  const code = ([r, g, b]: Rgb) => (255 << 24) | (b << 16) | (g << 8) | r;
  const tints = document.regions.map((region) => {
    const color = tint(typeOf(region), circlesOf(region), colors.dark);
    return code(region.id === lit ? (color.map((value) => (colors.dark ? Math.min(255, value + 26) : Math.max(0, value - 22))) as Rgb) : color);
  });
  const outside = Number.parseInt(colors.forbidden.slice(1), 16);
  const forbidden = code([outside >> 16, (outside >> 8) & 255, outside & 255]);
  for (let at = 0; at < regions.length; at++) pixels[at] = regions[at]! < 0 ? forbidden : (tints[regions[at]!] ?? 0);
  surfaceImage ??= globalThis.document.createElement("canvas");
  surfaceImage.width = width;
  surfaceImage.height = height;
  surfaceImage.getContext("2d")!.putImageData(image, 0, 0);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(surfaceImage, area.x, area.y, area.width, area.height);
}

function paintCurves(pen: Pen, { document, curves, chart }: Drawn, colors: Ink, lit: string | undefined): void {
  const palette = branchColors(document, colors.dark);
  pen.lineJoin = "round";
  for (const curve of document.curves) {
    const drawn = curves.get(curve.id);
    if (!drawn || drawn.length === 0) continue;
    const line = chart.line(drawn);
    const pole = curve.kind.startsWith("pole");
    pen.strokeStyle = palette.get(curve.branch) ?? colors.text;
    pen.lineWidth = (pole ? 1 : 1.8) + (curve.id === lit ? 1.6 : 0);
    if (pole) {
      stroke(pen, line, -Infinity, Infinity, [2, 3]);
      continue;
    }
    const wide = pen.lineWidth;
    const spans = curve.stability.length > 0 ? curve.stability : [{ l_from: 0, l_to: Infinity, nonlinear: null, friction: null }];
    spans.forEach(({ l_from, l_to, nonlinear, friction }, i) => {
      const last = i === spans.length - 1 ? Infinity : (l_to ?? Infinity);
      const verdict = nonlinear?.verdict ?? "open";
      // Thin: stable without friction only.
      pen.lineWidth = verdict === "stable" && friction?.conserving_l !== "survives" ? wide / 2.5 : wide;
      stroke(pen, line, i === 0 ? -Infinity : l_from, last, DASHES[verdict]);
    });
  }
  pen.setLineDash([]);
}

/** The curves of the body before. */
function paintShadow(pen: Pen, chart: Chart, shadow: Shadow, colors: Ink): void {
  pen.strokeStyle = colors.faint;
  pen.globalAlpha = 0.45;
  pen.lineWidth = 3;
  for (const points of shadow.values()) stroke(pen, chart.line(points), -Infinity, Infinity, []);
  pen.globalAlpha = 1;
}

/** Lines of curves by the verdict on their stability. */
const DASHES = { stable: [], unstable: [7, 4], open: [2, 3] };

/** The part of a line with l between two values. */
function stroke(pen: Pen, line: Line, from: number, to: number, dash: number[]): void {
  pen.setLineDash(dash);
  pen.beginPath();
  for (let i = 0; i < line.length; i += 3) {
    const l = line[i]!;
    const [before, after] = [line[i - 3] ?? l, line[i + 3] ?? l];
    // A point beyond the part still ends its last segment.
    if ((l < from && after <= from) || (l > to && before >= to)) continue;
    pen.lineTo(line[i + 1]!, line[i + 2]!);
  }
  pen.stroke();
}

function paintEvents(pen: Pen, { document, chart }: Drawn, colors: Ink): void {
  pen.fillStyle = colors.text;
  for (const spot of chart.events(document)) {
    if (!spot) continue;
    pen.beginPath();
    pen.arc(...spot, 2.2, 0, 2 * Math.PI);
    pen.fill();
  }
}

/** Where names stand, as long as the same is drawn. */
const standing = new WeakMap<Chart, Map<number, Place>>();

function paintNames(pen: Pen, { document, chart }: Drawn, colors: Ink): void {
  const found = standing.get(chart) ?? places(chart, document.regions.map(boxesOf));
  standing.set(chart, found);
  pen.textAlign = "center";
  pen.fillStyle = colors.text;
  pen.font = "12px system-ui, sans-serif";
  for (const [number, { x, y, box }] of found) {
    const region = document.regions[number];
    if (!region || box < 0) continue;
    const [id, type] = nameOf(region);
    if (box === 0) {
      pen.fillText(id, x, y - 3);
      pen.fillText(type, x, y + 12);
    } else pen.fillText(box === 1 ? `${id} ${type}` : id, x, y + 4);
  }
}

function paintPoint(pen: Pen, chart: Chart, { state }: Session, colors: Ink): void {
  const spot = state.point && chart.place(valueOf(state.point.h), Math.abs(valueOf(state.point.l)));
  if (!spot) return;
  pen.strokeStyle = colors.paper;
  pen.fillStyle = colors.accent;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.arc(...spot, 6, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
}
