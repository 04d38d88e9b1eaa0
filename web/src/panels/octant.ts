/** The direction of the centre of mass on an octant of the sphere; the other octants give the same diagrams. */
import type { Triple } from "../bindings/documents";
import { Sheet, type Pen, type Size } from "../draw/canvas";
import { drag, near } from "../draw/press";
import { apply, back, lookingAt, unit, type Vec } from "../draw/ball";
import { make } from "../draw/dom";
import { ink } from "../draw/theme";
import { rounded, stepOf, valueOf } from "../state/numbers";
import type { Session } from "../state/session";
import { texts } from "../texts";

const VIEW = lookingAt([1, 1, 1], [0, 0, 1]);
const AXES: Vec[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

export function octant(session: Session): HTMLElement {
  const canvas = make("canvas", { className: "control", tabIndex: 0, attributes: { role: "application", "aria-label": texts.body.octant }, data: { testid: "octant" } });
  const frame = ({ width, height }: Size) => ({ radius: 0.52 * Math.min(width, height), x: width / 2, y: height / 2 + 0.03 * height });
  const length = () => Math.hypot(...session.state.r.map(valueOf)) || 1;
  const direction = (): Vec => unit((session.state.r.map((text) => Math.abs(valueOf(text))) as Vec).map((x) => x || 0) as Vec);
  const paint = (pen: Pen, size: Size) => {
    const colors = ink();
    const { radius, x, y } = frame(size);
    const place = (v: Vec): [number, number] => {
      const [right, up] = apply(VIEW, v);
      return [x + radius * right, y - radius * up];
    };
    const arc = (from: Vec, to: Vec) => {
      for (let k = 0; k <= 24; k++) pen.lineTo(...place(unit([0, 1, 2].map((i) => from[i]! * (1 - k / 24) + (to[i]! * k) / 24) as Vec)));
    };
    pen.beginPath();
    for (let i = 0; i < 3; i++) arc(AXES[i]!, AXES[(i + 1) % 3]!);
    pen.closePath();
    pen.fillStyle = colors.dark ? "#24303c" : "#e9eef3";
    pen.fill();
    pen.strokeStyle = colors.line;
    pen.lineWidth = 1;
    pen.stroke();
    for (const share of [1 / 3, 2 / 3]) {
      for (let i = 0; i < 3; i++) {
        const [a, b, c] = [AXES[i]!, AXES[(i + 1) % 3]!, AXES[(i + 2) % 3]!];
        const lean = (from: Vec) => unit([0, 1, 2].map((k) => from[k]! * (1 - share) + c[k]! * share) as Vec);
        pen.beginPath();
        arc(lean(a), lean(b));
        pen.stroke();
      }
    }
    pen.fillStyle = colors.faint;
    pen.font = "11px system-ui";
    pen.textAlign = "center";
    AXES.forEach((axis, i) => {
      const [px, py] = place(axis);
      // Beside the point where it lies on an axis.
      pen.fillText(`${i + 1}`, px + (px - x) * (i < 2 ? 0.26 : 0.12), py + (py - y) * 0.12 + 4);
    });
    if (session.state.r.every((text) => valueOf(text) === 0)) return;
    pen.beginPath();
    pen.arc(...place(direction()), 6, 0, 2 * Math.PI);
    pen.fillStyle = colors.accent;
    pen.fill();
  };
  const sheet = new Sheet(canvas, paint);
  const take = (v: Vec) => {
    const size = length();
    const to = unit(v.map((x) => Math.max(0, x)) as Vec);
    session.body(session.state.A, to.map((x) => rounded(size * x, stepOf(size, 4))) as Triple);
  };
  drag(canvas, {
    handle: (event) => {
      const { radius, x, y } = frame(sheet.size);
      const [right, up] = apply(VIEW, direction());
      return near(sheet.place(event), [x + radius * right, y - radius * up]);
    },
    start: () => ((session.dragging = "body"), true),
    move: (event) => {
      const [px, py] = sheet.place(event);
      const { radius, x, y } = frame(sheet.size);
      let [u, v] = [(px - x) / radius, (y - py) / radius];
      const far = Math.hypot(u, v);
      if (far > 0.999) [u, v] = [(u / far) * 0.999, (v / far) * 0.999];
      take(back(VIEW, [u, v, Math.sqrt(1 - u * u - v * v)]));
    },
    end: () => session.release(),
  });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const [right, up, front] = apply(VIEW, direction());
    take(back(VIEW, [right + 0.01 * step[0]!, up + 0.01 * step[1]!, front]));
  });
  session.on(["body", "theme"], () => sheet.ask());
  return make("figure", {}, canvas, make("figcaption", {}, texts.body.direction));
}
