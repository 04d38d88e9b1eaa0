/** The triangle of all ratios A1 : A2 : A3; bodies that exist lie in the inner triangle, where no moment exceeds the others' sum. */
import { Sheet, type Pen, type Size } from "../draw/canvas";
import { drag, near } from "../draw/press";
import { make } from "../draw/dom";
import { ink } from "../draw/theme";
import type { Triple } from "../bindings/documents";
import { rounded, stepOf, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

type Place = [number, number];

/** The least share of a moment that the hand can reach. */
const LEAST = 0.01;

function corners({ width, height }: Size): [Place, Place, Place] {
  const side = Math.min(width - 24, (height - 30) / 0.8660254);
  const [left, bottom] = [(width - side) / 2, (height + 0.8660254 * side) / 2];
  return [[left, bottom], [left + side, bottom], [left + side / 2, bottom - 0.8660254 * side]];
}

const mix = (shares: number[], places: Place[]): Place => [0, 1].map((i) => shares.reduce((sum, share, k) => sum + share * places[k]![i]!, 0)) as Place;

/** Shares of the corners at a place. */
function sharesAt([x, y]: Place, [a, b, c]: [Place, Place, Place]): [number, number, number] {
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const second = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
  const third = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
  return [1 - second - third, second, third];
}

export function triangle(session: Session): HTMLElement {
  const canvas = make("canvas", { className: "control", tabIndex: 0, attributes: { role: "application", "aria-label": texts.body.triangle }, data: { testid: "triangle" } });
  const moments = () => session.state.A.map(valueOf);
  const paint = (pen: Pen, size: Size) => {
    const colors = ink();
    const outer = corners(size);
    const path = (places: Place[]) => {
      pen.beginPath();
      for (const place of places) pen.lineTo(...place);
      pen.closePath();
    };
    path(outer);
    pen.strokeStyle = colors.line;
    pen.lineWidth = 1;
    pen.stroke();
    path([mix([0.5, 0.5, 0], outer), mix([0, 0.5, 0.5], outer), mix([0.5, 0, 0.5], outer)]);
    pen.fillStyle = colors.dark ? "#24303c" : "#e9eef3";
    pen.fill();
    pen.stroke();
    pen.fillStyle = colors.faint;
    pen.font = "11px system-ui";
    pen.textAlign = "center";
    ["A₁", "A₂", "A₃"].forEach((name, i) => pen.fillText(name, outer[i]![0], outer[i]![1] + (i < 2 ? 12 : -4)));
    const a = moments();
    const sum = a.reduce((x, y) => x + y, 0);
    if (!(sum > 0)) return;
    pen.beginPath();
    pen.arc(...mix(a.map((x) => x / sum), outer), 6, 0, 2 * Math.PI);
    pen.fillStyle = colors.accent;
    pen.fill();
  };
  const sheet = new Sheet(canvas, paint);
  const take = (shares: [number, number, number]) => {
    const sum = moments().reduce((x, y) => x + y, 0) || 3;
    const kept = shares.map((share) => Math.max(LEAST, share));
    const whole = kept.reduce((x, y) => x + y, 0);
    session.body(kept.map((share) => rounded((sum * share) / whole, stepOf(sum / 3, 3))) as Triple, session.state.r);
  };
  drag(canvas, {
    handle: (event) => {
      const a = moments();
      const sum = a.reduce((x, y) => x + y, 0);
      return near(sheet.place(event), mix(a.map((x) => x / sum), corners(sheet.size)));
    },
    start: () => ((session.dragging = "body"), true),
    move: (event) => take(sharesAt(sheet.place(event), corners(sheet.size))),
    end: () => session.release(),
  });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [1, -1, 0], ArrowRight: [-1, 1, 0], ArrowUp: [-0.5, -0.5, 1], ArrowDown: [0.5, 0.5, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const a = moments();
    const sum = a.reduce((x, y) => x + y, 0);
    take(a.map((x, i) => x / sum + 0.005 * step[i]!) as [number, number, number]);
  });
  let shown = session.state.A;
  session.on(["body"], () => session.state.A.join() !== shown.join() && ((shown = session.state.A), sheet.ask()));
  session.on(["theme"], () => sheet.ask());
  return make("figure", {}, canvas, make("figcaption", {}, texts.body.ratios));
}
