/** The picture of the diagram. */
import { Pixels, type Pen, type Size } from "../draw/canvas";
import { branchColors, css, ink, NO_SHARE, shareColor, type Ink, type Rgb } from "../draw/theme";
import { valueOf } from "../state/numbers";
import type { Drawn, Shadow } from "../state/known";
import type { Session } from "../state/session";
import type { State } from "../state/state";
import type { Chart, Line, Spot } from "../state/chart";
import { boxesOf, nameOf } from "../state/names";
import { places, type Place } from "../state/places";
import { StraightChart } from "../state/straight";
import { paintAxes, paintLevels, paintStraightAxes, type Area } from "./diagram-axes";
import { colorOf } from "./regions";
import { texts } from "../texts";

/** The frame in the panel; the straightened plane has an axis on the right too, and names of axes above, where the scale of shares is. */
export const plot = ({ width, height }: Size, { straight, chaos }: Pick<State, "straight" | "chaos">): Area => {
  const [right, top] = [straight ? 46 : 10, straight || chaos ? 24 : 8];
  return { x: 46, y: top, width: Math.max(10, width - 46 - right), height: Math.max(10, height - 36 - top) };
};

export function paintDiagram(pen: Pen, size: Size, session: Session): void {
  const drawn = session.drawn!;
  const { chart } = drawn;
  const colors = ink();
  const area = plot(size, session.state);
  paintRegions(pen, area, drawn, colors, session);
  pen.save();
  pen.beginPath();
  pen.rect(area.x, area.y, area.width, area.height);
  pen.clip();
  pen.translate(area.x, area.y);
  if (chart instanceof StraightChart) paintLevels(pen, chart, colors);
  if (session.picture.shadow?.straight === chart instanceof StraightChart) paintShadow(pen, chart, session.picture.shadow!, colors);
  if (session.state.chaos) paintHalo(pen, drawn, colors);
  paintCurves(pen, drawn, colors, session.hover.curve);
  paintEvents(pen, drawn, colors);
  paintNames(pen, drawn, colors, session, session.dragging === "body");
  paintPoint(pen, chart, session, colors);
  pen.restore();
  if (chart instanceof StraightChart) paintStraightAxes(pen, area, chart, colors);
  else paintAxes(pen, area, chart.window, colors);
  if (session.state.chaos) paintScale(pen, area, colors);
}

/** While the module is on its way. */
export function paintWaiting(pen: Pen, { width, height }: Size): void {
  pen.fillStyle = ink().faint;
  pen.textAlign = "center";
  pen.font = "13px system-ui, sans-serif";
  pen.fillText(texts.head.loading, width / 2, height / 2);
}

let surface: Pixels | undefined;

const code = ([r, g, b]: Rgb) => (255 << 24) | (b << 16) | (g << 8) | r;

/** The colours of shares by pixel, as long as nothing is new; 0 where none is known. */
let shares: { of: Chart; version: number; component: number; pixels: Uint32Array } | undefined;

/** Each pixel has the share of its own region in its cell. */
function sharesOf(chart: Chart, { chaos, state: { component } }: Session): Uint32Array {
  if (shares?.of === chart && shares.version === chaos.version && shares.component === component) return shares.pixels;
  const { width, height, regions } = chart;
  const pixels = new Uint32Array(width * height);
  for (let x = 0; x < width; x++) {
    for (let y = 0; y < height; y++) {
      const region = regions[y * width + x]!;
      const value = region < 0 ? null : chart.value(x + 0.5, y + 0.5);
      const share = value ? chaos.at(...value, region, component) : undefined;
      if (share !== undefined && (share !== null || component === 0)) pixels[y * width + x] = code(share && share.orbits > 0 ? shareColor(share.fraction) : NO_SHARE);
    }
  }
  shares = { of: chart, version: chaos.version, component, pixels };
  return pixels;
}

/** Tints pixel by pixel. */
function paintRegions(pen: Pen, area: Area, { document, chart }: Drawn, colors: Ink, session: Session): void {
  const { width, height, regions } = chart;
  const lit = session.hover.region ?? null;
  const over = session.state.chaos ? sharesOf(chart, session) : null;
  surface ??= new Pixels();
  const pixels = new Uint32Array(surface.sized(width, height).data.buffer);
  const outside = Number.parseInt(colors.forbidden.slice(1), 16);
  // The forbidden part, whose number is −1, comes first.
  const palette = new Uint32Array(document.regions.length + 1);
  palette[0] = code([outside >> 16, (outside >> 8) & 255, outside & 255]);
  document.regions.forEach((region, number) => {
    const color = colorOf(region, colors.dark);
    palette[number + 1] = code(region.id === lit ? (color.map((value) => (colors.dark ? Math.min(255, value + 26) : Math.max(0, value - 22))) as Rgb) : color);
  });
  for (let at = 0; at < regions.length; at++) pixels[at] = palette[regions[at]! + 1]!;
  if (over) for (let at = 0; at < regions.length; at++) pixels[at] = over[at] || pixels[at]!;
  pen.imageSmoothingEnabled = false;
  surface.draw(pen, area.x, area.y, area.width, area.height);
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

/** Room round curves on colours that may be dark or light. */
function paintHalo(pen: Pen, { document, curves, chart }: Drawn, colors: Ink): void {
  pen.strokeStyle = colors.paper;
  pen.lineWidth = 4;
  pen.globalAlpha = 0.75;
  for (const { id } of document.curves) {
    const drawn = curves.get(id);
    if (drawn) stroke(pen, chart.line(drawn), -Infinity, Infinity, []);
  }
  pen.globalAlpha = 1;
}

/** The scale of shares, above the frame. */
function paintScale(pen: Pen, area: Area, colors: Ink): void {
  const [width, x, y] = [90, area.x + area.width / 2 - 20, area.y - 16];
  for (let k = 0; k < width; k++) {
    pen.fillStyle = css(shareColor(k / (width - 1)));
    pen.fillRect(x + k, y, 1.2, 8);
  }
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.fillText(`${texts.diagram.chaotic} 0`, x - 4, y + 8);
  pen.textAlign = "left";
  pen.fillText("1", x + width + 4, y + 8);
}

/** The curves of the body before. */
function paintShadow(pen: Pen, chart: Chart, shadow: Shadow, colors: Ink): void {
  pen.strokeStyle = colors.faint;
  pen.globalAlpha = 0.45;
  pen.lineWidth = 3;
  for (const points of shadow.curves.values()) stroke(pen, chart.line(points), -Infinity, Infinity, []);
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

/** Pixels from the middle of the point to a name. */
const ROUND = 9;

/** Where names stand, as long as the same is drawn. */
const standing = new WeakMap<Chart, Map<number, Place>>();

function paintNames(pen: Pen, { document, chart }: Drawn, colors: Ink, { state }: Session, moving: boolean): void {
  const spot = spotOf(chart, state);
  const ground = state.chaos;
  const found = standing.get(chart) ?? places(chart, document.regions.map(boxesOf), moving);
  standing.set(chart, found);
  pen.textAlign = "center";
  pen.font = "12px system-ui, sans-serif";
  for (const [number, place] of found) {
    const region = document.regions[number];
    const { box } = place;
    if (!region || box < 0) continue;
    const [id, type] = nameOf(region);
    const { x, y } = beside(place, boxesOf(region)[box]!, spot, chart, number);
    if (ground) {
      const wide = Math.max(...(box === 0 ? [id, type] : [box === 1 ? `${id} ${type}` : id]).map((text) => pen.measureText(text).width)) + 6;
      const high = box === 0 ? 31 : 16;
      pen.fillStyle = colors.paper;
      pen.globalAlpha = 0.8;
      pen.fillRect(x - wide / 2, y - high / 2, wide, high);
      pen.globalAlpha = 1;
    }
    pen.fillStyle = colors.text;
    if (box === 0) {
      pen.fillText(id, x, y - 3);
      pen.fillText(type, x, y + 12);
    } else pen.fillText(box === 1 ? `${id} ${type}` : id, x, y + 4);
  }
}

/** The place of a name, or one beside it in the same region where the point would cover it. */
function beside({ x, y }: Place, [width, height]: [number, number], spot: Spot | null, { regions, width: columns, height: lines }: Chart, number: number): { x: number; y: number } {
  const [far, high] = [width / 2 + ROUND, height / 2 + ROUND];
  if (!spot || Math.abs(spot[0] - x) > far || Math.abs(spot[1] - y) > high) return { x, y };
  const inside = (at: number, line: number) => at >= 0 && at < columns && line >= 0 && line < lines && regions[Math.floor(line) * columns + Math.floor(at)] === number;
  const around: Spot[] = [[x, spot[1] - high], [x, spot[1] + high], [spot[0] - far, y], [spot[0] + far, y]];
  const free = around.find(([px, py]) => [-1, 0, 1].every((i) => [-1, 0, 1].every((j) => inside(px + (i * width) / 2, py + (j * height) / 2))));
  return free ? { x: free[0], y: free[1] } : { x, y };
}

const spotOf = (chart: Chart, { point }: State): Spot | null => point && chart.place(valueOf(point.h), Math.abs(valueOf(point.l)));

function paintPoint(pen: Pen, chart: Chart, { state }: Session, colors: Ink): void {
  const spot = spotOf(chart, state);
  if (!spot) return;
  pen.strokeStyle = colors.paper;
  pen.fillStyle = colors.accent;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.arc(...spot, 6, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
}
