/** The axes of the diagram: of the plane, and of the straightened plane, whose numbers are the true ones. */
import { powerOf, ticks, type Pen } from "../draw/canvas";
import type { Ink } from "../draw/theme";
import type { Window } from "../bindings/documents";
import { shown } from "../state/numbers";
import type { StraightChart } from "../state/straight";
import { texts } from "../texts";

/** A rectangle in the panel. */
export interface Area {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function paintAxes(pen: Pen, area: Area, { h, l }: Window, colors: Ink): void {
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.strokeRect(area.x, area.y, area.width, area.height);
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  const bottom = area.y + area.height;
  const unit = 10 ** powerOf(...h);
  const list = ticks(h[0] / unit, h[1] / unit, area.width / 90);
  const long = (list[0]?.text.length ?? 0) > 9;
  for (const [i, { value, text }] of list.entries()) {
    const x = area.x + ((value * unit - h[0]) / (h[1] - h[0])) * area.width;
    pen.fillRect(x, bottom, 1, 4);
    if (!long || i % 2 === 0) pen.fillText(text, x, bottom + 16);
  }
  pen.fillText(texts.diagram.energy + inUnits(powerOf(...h)), area.x + area.width / 2, bottom + 32);
  pen.textAlign = "right";
  const unitOfL = 10 ** powerOf(...l);
  for (const { value, text } of ticks(l[0] / unitOfL, l[1] / unitOfL, area.height / 50)) {
    const y = bottom - ((value * unitOfL - l[0]) / (l[1] - l[0])) * area.height;
    pen.fillRect(area.x - 4, y, 4, 1);
    // Longer ones would run into the name of the axis.
    const inside = text.length > 4;
    pen.textAlign = inside ? "left" : "right";
    pen.fillText(text, inside ? area.x + 4 : area.x - 7, y + (inside ? -3 : 4));
  }
  pen.save();
  pen.translate(11, area.y + area.height / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.fillText(texts.diagram.momentum + inUnits(powerOf(...l)), 0, 0);
  pen.restore();
}

/** What stands behind a name whose numbers are in units of a power of ten. */
const inUnits = (power: number): string => (power === 0 ? "" : ` / 10${[...String(power)].map((sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]).join("")}`);

/** l below, h on the left at l = 0 and on the right at the last l. */
export function paintStraightAxes(pen: Pen, area: Area, { drawing }: StraightChart, colors: Ink): void {
  const [right, bottom] = [area.x + area.width, area.y + area.height];
  pen.strokeStyle = colors.line;
  pen.lineWidth = 1;
  pen.strokeRect(area.x, area.y, area.width, area.height);
  pen.fillStyle = colors.faint;
  pen.font = "11px system-ui, sans-serif";
  const label = (axis: number, draw: (at: number, text: string) => void) => drawing.ticks[axis]!.at.forEach((at, k) => draw(at, drawing.ticks[axis]!.texts[k]!));
  pen.textAlign = "center";
  label(0, (at, text) => {
    pen.fillRect(area.x + at, bottom, 1, 4);
    pen.fillText(text, area.x + at, bottom + 16);
  });
  pen.fillText(texts.diagram.momentum, area.x + area.width / 2, bottom + 32);
  pen.textAlign = "right";
  label(1, (at, text) => {
    pen.fillRect(area.x - 4, area.y + at, 4, 1);
    pen.fillText(text, area.x - 7, area.y + at + 4);
  });
  pen.textAlign = "left";
  label(2, (at, text) => {
    pen.fillRect(right, area.y + at, 4, 1);
    pen.fillText(text, right + 7, area.y + at + 4);
  });
  pen.fillText(texts.diagram.energyAtZero, 4, area.y - 10);
  pen.textAlign = "right";
  pen.fillText(texts.diagram.energyAt(shown(drawing.end, 3)), right + 42, area.y - 10);
}

/** Lines of constant h. */
export function paintLevels(pen: Pen, { drawing: { levels } }: StraightChart, colors: Ink): void {
  pen.strokeStyle = colors.faint;
  pen.lineWidth = 0.5;
  pen.globalAlpha = 0.6;
  for (let at = 0; at < levels.length; ) {
    const count = levels[at++]!;
    pen.beginPath();
    for (let k = 0; k < count; k++, at += 2) pen.lineTo(levels[at]!, levels[at + 1]!);
    pen.stroke();
  }
  pen.globalAlpha = 1;
}
